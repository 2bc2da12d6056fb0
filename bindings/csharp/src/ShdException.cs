// SPDX-License-Identifier: MIT
using System;

namespace Shd
{
    /// <summary>A call that the library refused, with its result and its text.</summary>
    public sealed class ShdException : Exception
    {
        public ShdException(Result result, string message) : base(message) { Result = result; }

        public Result Result { get; private set; }

        /// <summary>The text of the latest failure on this thread.</summary>
        internal static unsafe string LastError() { return Utf8.Read(Native.LibShd.LastError()); }

        internal static void Check(Result result)
        {
            if (result != Result.Ok) throw new ShdException(result, LastError());
        }
    }
}
