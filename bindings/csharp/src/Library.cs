// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

namespace Shd
{
    /// <summary>
    /// Finds the native libraries. The environment variable SHD_LIBRARY is the path of libshd.so, with the components
    /// beside it. Without SHD_LIBRARY the places of the runtime and of the system's loader are searched.
    /// </summary>
    internal static unsafe class Library
    {
        private const int Now = 2, Global = 0x100;

        [DllImport("libdl.so.2", EntryPoint = "dlopen")]
        private static extern IntPtr Open([MarshalAs(UnmanagedType.LPStr)] string path, int flags);

        [DllImport("libdl.so.2", EntryPoint = "dlerror")]
        private static extern byte* OpenError();

        /// <summary>The path of a library beside SHD_LIBRARY; null if the loader searches for the library.</summary>
        private static string PathOf(string name)
        {
            string core = System.Environment.GetEnvironmentVariable("SHD_LIBRARY");
            if (string.IsNullOrEmpty(core)) return null;
            if (name == "shd") return Path.GetFullPath(core);
            string beside = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(core)), "lib" + name + ".so");
            return File.Exists(beside) ? beside : null;
        }

        /// <summary>Loads a library, so that the functions imported by its name are found.</summary>
        internal static void Load(string name)
        {
#if NET5_0_OR_GREATER
            lock (Resolved)
            {
                if (!isResolverSet) NativeLibrary.SetDllImportResolver(typeof(Library).Assembly, Resolve);
                isResolverSet = true;
            }
#else
            string path = PathOf(name);
            if (path != null && Open(path, Now | Global) == IntPtr.Zero)
                throw new DllNotFoundException("SHD_LIBRARY: " + Utf8.Read(OpenError()));
#endif
            if (name == "shd") CheckVersion(Native.LibShd.Version());
        }

#if NET5_0_OR_GREATER
        private static readonly object Resolved = new object();
        private static bool isResolverSet;

        private static IntPtr Resolve(string name, System.Reflection.Assembly assembly, DllImportSearchPath? places)
        {
            string path = PathOf(name);
            return path != null ? NativeLibrary.Load(path) : IntPtr.Zero;
        }
#endif

        private static void CheckVersion(uint version)
        {
            uint major = version >> 16, minor = version >> 8 & 255;
            if (major == Constants.VersionMajor && (major > 0 || minor == Constants.VersionMinor)) return;
            throw new DllNotFoundException("libshd is version " + major + "." + minor + ", this binding is for " +
                                           Constants.VersionMajor + "." + Constants.VersionMinor);
        }
    }

    /// <summary>Texts of C.</summary>
    internal static unsafe class Utf8
    {
        internal static string Read(byte* text)
        {
            if (text == null) return null;
            int length = 0;
            while (text[length] != 0) ++length;
            return length == 0 ? "" : Encoding.UTF8.GetString(text, length);
        }
    }
}
