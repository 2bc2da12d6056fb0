// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>
    /// The owner of one reference to an object of the library: Dispose or the finaliser releases it once, after the
    /// last call that uses it.
    /// </summary>
    internal abstract class ObjectHandle : SafeHandle
    {
        private static readonly CallbackRoot[] NoRoots = new CallbackRoot[0];

        protected ObjectHandle() : base(IntPtr.Zero, true) { Roots = NoRoots; }

        /// <summary>Callbacks that the object, or an object that it retains, can call until its release.</summary>
        internal CallbackRoot[] Roots { get; private set; }

        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

        /// <summary>Takes over a reference that the caller owns.</summary>
        internal void Adopt(IntPtr reference, List<CallbackRoot> roots)
        {
            if (roots.Count > 0) Roots = roots.ToArray();
            foreach (CallbackRoot root in Roots) root.Retain();
            SetHandle(reference);
        }

        protected abstract void Drop(IntPtr reference);

        protected override bool ReleaseHandle()
        {
            Drop(handle);
            foreach (CallbackRoot root in Roots) root.Release();
            return true;
        }
    }

    /// <summary>
    /// Base of the objects. Dispose drops the reference; later uses throw ObjectDisposedException. A call that runs on
    /// another thread keeps the object until it ends.
    /// </summary>
    public abstract class ShdObject : IDisposable
    {
        internal readonly ObjectHandle Handle;
        private int isWritten;

        internal ShdObject(ObjectHandle handle) { Handle = handle; }

        public bool IsDisposed { get { return Handle.IsClosed; } }

        public void Dispose() { Handle.Dispose(); }

        /// <summary>Begins a call that needs the object for itself; false if another one runs.</summary>
        internal bool TryBeginWrite() { return System.Threading.Interlocked.Exchange(ref isWritten, 1) == 0; }
        internal void EndWrite() { System.Threading.Volatile.Write(ref isWritten, 0); }
    }
}
