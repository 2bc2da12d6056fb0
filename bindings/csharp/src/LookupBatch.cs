// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace Shd
{
    /// <summary>
    /// A prepared batch of lookups: Run() costs little more than the call in C, and makes no garbage. The batch keeps
    /// the texture, the sampler and the pinned arrays until Dispose. It serves one thread, because each run writes to
    /// the same arrays; a concurrent run is refused. Dispose during a run takes effect at its end.
    /// </summary>
    public sealed unsafe class LookupBatch : IDisposable
    {
        private const int Idle = 0, Running = 1, Closing = 2, Closed = 3;

        private readonly Call call = new Call();
        private readonly IntPtr texture, sampler;
        private readonly Native.Lookups* lookups;
        private readonly Native.Texels* texels;
        private readonly long capacity;
        private int state;

        internal LookupBatch(Texture texture, Sampler sampler, Lookups input, Texels output)
        {
            try
            {
                if (input == null) throw new ArgumentNullException("lookups");
                if (output == null) throw new ArgumentNullException("output");
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
                Dispose();
                throw;
            }
        }

        ~LookupBatch() { Close(); }

        public void Dispose()
        {
            Close();
            GC.SuppressFinalize(this);
        }

        private void Close()
        {
            for (int seen = Volatile.Read(ref state); seen == Idle || seen == Running; seen = Volatile.Read(ref state))
            {
                int next = seen == Idle ? Closed : Closing;
                if (Interlocked.CompareExchange(ref state, next, seen) != seen) continue;
                if (next == Closed) call.Dispose();
                return;
            }
        }

        private void Begin()
        {
            if (Interlocked.CompareExchange(ref state, Running, Idle) != Idle) Refuse();
        }

        private void Refuse()
        {
            if (Volatile.Read(ref state) == Running)
                throw new InvalidOperationException("batch: another thread uses the LookupBatch");
            throw new ObjectDisposedException("LookupBatch", "batch: the LookupBatch was disposed");
        }

        private void End()
        {
            if (Interlocked.CompareExchange(ref state, Idle, Running) == Running) return;
            Volatile.Write(ref state, Closed);
            call.Dispose();
        }

        /// <summary>Number of lookups, from the beginning of the columns; at first their length.</summary>
        public long Count
        {
            get
            {
                Begin();
                long count = lookups->Count;
                End();
                return count;
            }
            set
            {
                if (value < 0 || value > capacity)
                    throw new ArgumentOutOfRangeException("value", "Count: " + value + " is not in [0, " +
                                                          capacity + "]");
                Begin();
                lookups->Count = value;
                End();
            }
        }

        /// <summary>Lookups with coordinates, derivatives or levels that were not finite, in the latest run.</summary>
        public long NonfiniteCount
        {
            get
            {
                Begin();
                long count = texels->NonfiniteCount;
                End();
                return count;
            }
        }

        /// <summary>Filters the lookups into the columns of the batch.</summary>
        public void Run()
        {
            Begin();
            Result result = Native.LibShd.TextureSample(texture, sampler, lookups, texels);
            if (result == Result.Ok) End();
            else Fail(result);
        }

        private void Fail(Result result)
        {
            try { call.Check(result); }
            finally { End(); }
        }
    }
}
