// SPDX-License-Identifier: MIT
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Threading;
using Shd;

/// <summary>When objects and callbacks are released.</summary>
public static class Lifetime
{
    private static void Collect()
    {
        for (int i = 0; i < 4; ++i)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
    }

    /// <summary>Overwrites the stack, which Mono scans conservatively.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Wipe(int depth)
    {
        long a = depth, b = 1, c = 2, d = 3;
        return depth == 0 ? (int)(a + b + c + d) : Wipe(depth - 1) + (int)(a * 0 + b - c * 0);
    }

    private static void InThread(ThreadStart start)
    {
        Exception problem = null;
        Thread thread = new Thread(() =>
        {
            try { start(); }
            catch (Exception caught) { problem = caught; }
        });
        thread.Start();
        thread.Join();
        if (problem != null) throw new Failure(problem.ToString());
    }

    [Test]
    public static void DisposeFreesAll()
    {
        CountingAllocator memory = new CountingAllocator();
        Context context = new Context(new ContextDesc { Allocator = memory, WorkerCount = 2 });
        Texture texture = Make.Checker(context);
        Sampler sampler = Make.Nearest(context);
        Material material = new Material(context, new MaterialDesc { Model = Model.Unlit, Diffuse = new Float3(1, 1, 1),
            Slots = new[] { Slot.FromTexture(SlotTarget.Diffuse, texture, sampler) } });
        context.Dispose(); // its objects keep the context
        texture.Dispose();
        sampler.Dispose();
        Check.IsTrue(memory.All > 0 && memory.Alive > 0, "the material has memory");
        material.Dispose();
        Check.Equal(0, memory.Alive, "blocks after Dispose");
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Forget(CountingAllocator memory)
    {
        Context context = new Context(new ContextDesc { Allocator = memory });
        Texture texture = Make.Checker(context);
        Material self = null;
        self = Make.Program(context, (fragments, radiance) => radiance.R.Fill(self == null ? 0 : 1)); // a cycle
        float[,] red = Make.Red(context, self, 8, 8);
        Check.Equal(1.0f, red[4, 4], "red");
        LookupBatch batch = texture.Prepare(Make.Nearest(context), new Lookups { U = new float[3], V = new float[3] },
                                            Make.Channel(3));
        batch.Run();
        PlaneView view = new Framebuffer(context, 4, 4).ViewPlane(Shd.Plane.R);
        Check.Equal(4, view.Row(3).Length, "row");
        Check.IsTrue(memory.Alive > 0, "blocks");
    }

    [Test]
    public static void FinalisersFreeAll()
    {
        CountingAllocator memory = new CountingAllocator();
        for (int i = 0; i < 10; ++i) InThread(() => Forget(memory));
        Wipe(200);
        for (int i = 0; i < 20 && memory.Alive > 0; ++i)
        {
            Collect();
            Thread.Sleep(10);
        }
        Check.Equal(0, memory.Alive, "blocks after GC.Collect");
        Check.IsTrue(memory.All > 100, "blocks that were allocated: " + memory.All);
    }

    /// <summary>Collections while programs and arrays are in use.</summary>
    [Test]
    public static void CollectionsDuringCalls()
    {
        using (Context context = new Context())
        {
            Material material = Make.Program(context, (fragments, radiance) =>
            {
                GC.Collect();
                fragments.U.CopyTo(radiance.R);
            });
            Collect();
            float[,] red = Make.Red(context, material, 64, 32);
            for (int x = 0; x < 64; ++x)
                Check.IsTrue(Math.Abs(red[7, x] - (x + 0.5f) / 64) < 1e-6f, "red of column " + x);
            material.Dispose();
        }
    }

    /// <summary>Dispose on another thread while calls use the object.</summary>
    [Test]
    public static void DisposeDuringCalls()
    {
        float[] u = new float[5000], v = new float[5000];
        using (Context context = new Context(new ContextDesc { WorkerCount = 1 }))
        using (Sampler sampler = new Sampler(context))
        {
            for (int round = 0; round < 50; ++round)
            {
                Texture texture = Make.Checker(context);
                Texels texels = Make.Channel(5000);
                LookupBatch batch = texture.Prepare(sampler, new Lookups { U = u, V = v }, texels);
                Exception other = null;
                Thread caller = new Thread(() =>
                {
                    try
                    {
                        while (true)
                        {
                            batch.Run();
                            texture.Sample(sampler, new Lookups { U = u, V = v }, texels);
                        }
                    }
                    catch (ObjectDisposedException) { }
                    catch (Exception problem) { other = problem; }
                });
                caller.Start();
                Thread.Sleep(round % 3);
                texture.Dispose();
                batch.Dispose();
                caller.Join();
                Check.IsTrue(other == null, "the caller: " + other);
            }
        }
    }

    [Test]
    public static void FailedAllocations()
    {
        CountingAllocator memory = new CountingAllocator();
        using (Context context = new Context(new ContextDesc { Allocator = memory, WorkerCount = 1 }))
        {
            int alive = memory.Alive;
            for (int budget = 0; ; ++budget)
            {
                memory.Budget = budget;
                try
                {
                    using (Texture texture = Make.Checker(context)) { }
                    break;
                }
                catch (ShdException problem) { Check.Equal(Result.ErrorOutOfMemory, problem.Result, "Result"); }
                Check.Equal(alive, memory.Alive, "blocks after a failure");
                Check.IsTrue(budget < 100, "no call succeeds");
            }
            memory.Budget = long.MaxValue;
        }
        Check.Equal(0, memory.Alive, "blocks at the end");
    }
}
