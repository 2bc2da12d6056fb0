// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>
    /// A prepared batch of lookups: Run() costs little more than the call in C, and makes no garbage. The batch keeps
    /// the texture, the sampler and the pinned arrays until Dispose. One thread runs a batch, because its results go to
    /// the same arrays each time.
    /// </summary>
    public sealed unsafe class LookupBatch : SafeHandle
    {
        private readonly Call call = new Call();
        private readonly IntPtr texture, sampler;
        private readonly Native.Lookups* lookups;
        private readonly Native.Texels* texels;
        private readonly long capacity;

        internal LookupBatch(Texture texture, Sampler sampler, Lookups input, Texels output)
            : base(IntPtr.Zero, true)
        {
            if (input == null) throw new ArgumentNullException("lookups");
            if (output == null) throw new ArgumentNullException("output");
            try
            {
                this.texture = call.Use(texture, "texture");
                this.sampler = call.Use(sampler, "sampler");
                lookups = (Native.Lookups*)call.Memory(sizeof(Native.Lookups));
                *lookups = input.Build(call, "lookups");
                texels = (Native.Texels*)call.Memory(sizeof(Native.Texels));
                *texels = output.Build(call, "output", lookups->Count);
                capacity = lookups->Count;
            }
            catch
            {
                call.Dispose();
                throw;
            }
            SetHandle((IntPtr)lookups);
        }

        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

        /// <summary>Number of lookups, from the beginning of the columns; at first their length.</summary>
        public long Count
        {
            get { return WithLookups(-1); }
            set
            {
                if (value < 0 || value > capacity)
                    throw new ArgumentOutOfRangeException("value", "Count: " + value + " is not in [0, " + capacity + "]");
                WithLookups(value);
            }
        }

        /// <summary>Lookups with coordinates, derivatives or levels that were not finite, in the latest run.</summary>
        public long NonfiniteCount
        {
            get
            {
                Begin();
                try { return texels->NonfiniteCount; }
                finally { DangerousRelease(); }
            }
        }

        private long WithLookups(long count)
        {
            Begin();
            try
            {
                if (count >= 0) lookups->Count = count;
                return lookups->Count;
            }
            finally { DangerousRelease(); }
        }

        private void Begin()
        {
            bool isAdded = false;
            DangerousAddRef(ref isAdded);
        }

        /// <summary>Filters the lookups into the columns of the batch.</summary>
        public void Run()
        {
            Begin();
            Result result = Native.LibShd.TextureSample(texture, sampler, lookups, texels);
            if (result == Result.Ok) DangerousRelease();
            else Fail(result);
        }

        private void Fail(Result result)
        {
            try { call.Check(result); }
            finally { DangerousRelease(); }
        }

        protected override bool ReleaseHandle()
        {
            call.Dispose();
            return true;
        }
    }
}
