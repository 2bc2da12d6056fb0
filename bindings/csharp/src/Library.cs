// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Text;

namespace Shd
{
    /// <summary>
    /// Finds the native libraries. Mono reads Shd.dll.config beside Shd.dll, whose names its loader searches for; .NET
    /// searches beside Shd.dll and in runtimes/. With .NET 6 the environment variable SHD_LIBRARY, the path of
    /// libshd.so, comes first, and the components are searched beside it.
    /// </summary>
    internal static class Library
    {
        private static int isVersionChecked;

        /// <summary>Refuses a library of another version, whose structs may differ.</summary>
        internal static void CheckVersion()
        {
            if (isVersionChecked != 0) return;
            uint version = Native.LibShd.Version(), major = version >> 16, minor = version >> 8 & 255;
            if (major != Constants.VersionMajor || (major == 0 && minor != Constants.VersionMinor))
                throw new DllNotFoundException("libshd has version " + major + "." + minor + ", this binding is for " +
                                               Constants.VersionMajor + "." + Constants.VersionMinor);
            isVersionChecked = 1;
        }

#if NET5_0_OR_GREATER
        private static readonly object Guard = new object();
        private static bool isResolverSet;

        internal static void SetResolver()
        {
            lock (Guard)
            {
                if (!isResolverSet) NativeLibrary.SetDllImportResolver(typeof(Library).Assembly, Resolve);
                isResolverSet = true;
            }
        }

        private static IntPtr Resolve(string name, Assembly assembly, DllImportSearchPath? places)
        {
            string core = System.Environment.GetEnvironmentVariable("SHD_LIBRARY");
            if (string.IsNullOrEmpty(core)) return IntPtr.Zero;
            if (name == "shd") return NativeLibrary.Load(Path.GetFullPath(core));
            string beside = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(core)), "lib" + name + ".so");
            return File.Exists(beside) ? NativeLibrary.Load(beside) : IntPtr.Zero;
        }
#endif
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
