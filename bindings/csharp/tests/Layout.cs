// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
using Shd;

/// <summary>Sizes and offsets of the runtime against those of shd.json.</summary>
public static class Layout
{
    [Test]
    public static void Structs()
    {
        Assembly library = typeof(Context).Assembly;
        Type type = null;
        int structs = 0, fields = 0;
        foreach (string line in File.ReadAllLines(Tests.LayoutPath))
        {
            string[] words = line.Split(' ');
            if (words[0] == "struct")
            {
                type = library.GetType(words[1]);
                Check.IsTrue(type != null, "no struct " + words[1]);
                Check.Equal(int.Parse(words[2]), Marshal.SizeOf(type), words[1]);
                ++structs;
            }
            else if (words[0] == "field")
            {
                Check.Equal(long.Parse(words[2]), (long)Marshal.OffsetOf(type, words[1]), type + "." + words[1]);
                ++fields;
            }
        }
        Check.IsTrue(structs > 80 && fields > 500, "the table is too short");
    }

    /// <summary>Every function that is imported exists in its library.</summary>
    [Test]
    public static void Functions()
    {
        int found = 0;
        foreach (Type type in typeof(Context).Assembly.GetTypes())
        {
            if (type.Namespace != "Shd.Native" || !type.Name.StartsWith("LibShd")) continue;
            foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public))
            {
                try { Marshal.Prelink(method); }
                catch (DllNotFoundException) when (type.Name != "LibShd") { continue; } // a component that is not built
                ++found;
            }
        }
        Check.IsTrue(found > 100, "functions: " + found);
    }

    [Test]
    public static void Defaults()
    {
        SamplerDesc sampler = SamplerDesc.Default;
        Check.Equal(132u, sampler.StructSize, "struct_size");
        Check.IsTrue(sampler.LodMax > 0, "LodMax");
        Check.Equal(1.0f, new RenderDesc().ClearDepth, "ClearDepth");
        Check.Equal(1.0f, new Draw().ObjectToWorld[5], "ObjectToWorld");
        Bytes64 text = new Bytes64();
        text[0] = (byte)'v';
        text[1] = (byte)'x';
        Check.Equal("vx", text.ToString(), "text");
        Check.Throws<ArgumentOutOfRangeException>(() => { float x = new Float3(1, 2, 3)[3]; }, "3 is not in [0, 3)");
    }
}
