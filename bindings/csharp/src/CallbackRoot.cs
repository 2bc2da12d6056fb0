// SPDX-License-Identifier: MIT
using System;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Threading;

namespace Shd
{
    /// <summary>
    /// The managed side of user_data: the functions of one desc, and their first exception.
    ///
    /// Owners of handles keep the root alive; its GC handle tracks the object during finalisation. So a function that
    /// refers to its own material is no leak, and allocators can be called until the last release.
    /// </summary>
    internal sealed class CallbackRoot
    {
        internal readonly object Target;
        private GCHandle self;
        private int references = 1;
        private ExceptionDispatchInfo failure;

        internal CallbackRoot(object target)
        {
            Target = target;
            self = GCHandle.Alloc(this, GCHandleType.WeakTrackResurrection);
        }

        internal unsafe void* UserData { get { return (void*)GCHandle.ToIntPtr(self); } }

        /// <summary>The root of a callback that runs on this thread.</summary>
        internal static unsafe CallbackRoot Of(void* userData)
        {
            return (CallbackRoot)GCHandle.FromIntPtr((IntPtr)userData).Target;
        }

        internal bool HasFailed { get { return Volatile.Read(ref failure) != null; } }

        /// <summary>Stores an exception. Concurrent workers may fail; the first one counts.</summary>
        internal void Fail(Exception problem)
        {
            Interlocked.CompareExchange(ref failure, ExceptionDispatchInfo.Capture(problem), null);
        }

        /// <summary>Throws the stored exception, and forgets it.</summary>
        internal void Rethrow()
        {
            ExceptionDispatchInfo stored = Interlocked.Exchange(ref failure, null);
            if (stored != null) stored.Throw();
        }

        internal void Retain() { Interlocked.Increment(ref references); }

        internal void Release()
        {
            if (Interlocked.Decrement(ref references) == 0) self.Free();
        }
    }
}
