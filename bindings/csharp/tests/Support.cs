// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Threading;
using Shd;

/// <summary>A method without arguments that is a test.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class TestAttribute : Attribute { }

public sealed class Failure : Exception
{
    public Failure(string text) : base(text) { }
}

public static class Check
{
    public static void IsTrue(bool value, string text)
    {
        if (!value) throw new Failure(text);
    }

    public static void Equal<T>(T expected, T got, string text)
    {
        IsTrue(EqualityComparer<T>.Default.Equals(expected, got), text + ": " + got + ", not " + expected);
    }

    /// <summary>The exception of an action, whose text has all the given words.</summary>
    public static T Throws<T>(Action action, params string[] words) where T : Exception
    {
        try { action(); }
        catch (T problem)
        {
            foreach (string word in words)
                IsTrue(problem.Message.Contains(word), "no \"" + word + "\" in \"" + problem.Message + "\"");
            return problem;
        }
        throw new Failure("no " + typeof(T).Name);
    }
}

/// <summary>Memory of C with the number of blocks that are alive.</summary>
public sealed class CountingAllocator : Allocator
{
    private int alive, all;
    private long failAfter = long.MaxValue;

    public int Alive { get { return Volatile.Read(ref alive); } }
    public int All { get { return Volatile.Read(ref all); } }
    /// <summary>Allocations that succeed from now on.</summary>
    public long Budget { set { Interlocked.Exchange(ref failAfter, value); } }

    [DllImport("libc.so.6")]
    private static extern int posix_memalign(out IntPtr memory, UIntPtr alignment, UIntPtr size);

    [DllImport("libc.so.6")]
    private static extern void free(IntPtr memory);

    public override IntPtr Allocate(long size, long alignment)
    {
        IntPtr memory;
        if (Interlocked.Decrement(ref failAfter) < 0) return IntPtr.Zero;
        if (posix_memalign(out memory, (UIntPtr)(ulong)alignment, (UIntPtr)(ulong)size) != 0) return IntPtr.Zero;
        Interlocked.Increment(ref alive);
        Interlocked.Increment(ref all);
        return memory;
    }

    public override void Free(IntPtr memory, long size, long alignment)
    {
        Interlocked.Decrement(ref alive);
        free(memory);
    }
}

public static class Make
{
    public static Texture Checker(Context context)
    {
        return new Texture(context, new TextureDesc(Format.R8, 2, 2, new byte[] { 0, 255, 255, 0 }));
    }

    public static Sampler Nearest(Context context)
    {
        SamplerDesc desc = SamplerDesc.Default;
        desc.Filter = Filter.Nearest;
        return new Sampler(context, desc);
    }

    /// <summary>A channel for as many lookups.</summary>
    public static Texels Channel(int count)
    {
        Texels texels = new Texels();
        texels.Channel[0] = new float[count];
        return texels;
    }

    /// <summary>A square that fills the picture without a camera; u and v grow to the right and down.</summary>
    public static Mesh Square(Context context)
    {
        MeshDesc desc = new MeshDesc { Topology = Topology.Strip };
        Column.Set(desc.Position, new float[,] { { -1, 1, 0.5f }, { -1, -1, 0.5f }, { 1, 1, 0.5f }, { 1, -1, 0.5f } });
        Column.Set(desc.Uv, new float[,] { { 0, 0 }, { 0, 1 }, { 1, 0 }, { 1, 1 } });
        return new Mesh(context, desc);
    }

    public static Material Program(Context context, FragmentProgram program)
    {
        return new Material(context, new MaterialDesc { Model = Model.Program,
                                                        Program = new MaterialProgram { Fragment = program } });
    }

    /// <summary>Red of a frame of the square with a material.</summary>
    public static float[,] Red(Context context, Material material, int width, int height, RenderDesc frame = null)
    {
        using (Mesh mesh = Square(context))
        using (Framebuffer framebuffer = new Framebuffer(context, width, height))
        {
            frame = frame ?? new RenderDesc();
            frame.Framebuffer = framebuffer;
            frame.Draws = new[] { new Draw(mesh, material) };
            context.Render(frame);
            return framebuffer.ReadPlane(Plane.R);
        }
    }
}

public static class Tests
{
    public static string LayoutPath;

    private static bool Run(MethodInfo method)
    {
        string name = method.DeclaringType.Name + "." + method.Name;
        try
        {
            method.Invoke(null, null);
            Console.WriteLine("ok   " + name);
            return true;
        }
        catch (TargetInvocationException problem)
        {
            bool isMissing = problem.InnerException is DllNotFoundException &&
                             problem.InnerException.Message.StartsWith("libshd_");
            Console.WriteLine((isMissing ? "skip " : "FAIL ") + name + ": " +
                              (isMissing ? problem.InnerException.Message : problem.InnerException.ToString()));
            return isMissing;
        }
    }

    public static int Main(string[] arguments)
    {
        if (arguments.Length < 1)
        {
            Console.Error.WriteLine("usage: Tests layout.txt [part of a name]");
            return 2;
        }
        LayoutPath = arguments[0];
        int failed = 0, all = 0;
        foreach (Type type in typeof(Tests).Assembly.GetTypes())
            foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public))
                if (method.GetCustomAttributes(typeof(TestAttribute), false).Length > 0 &&
                    (arguments.Length < 2 || (type.Name + "." + method.Name).Contains(arguments[1])))
                {
                    ++all;
                    if (!Run(method)) ++failed;
                }
        Console.WriteLine(all + " tests, " + failed + " failed");
        return failed == 0 && all > 0 ? 0 : 1;
    }
}
