// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;
using Shd;

/// <summary>Calls that must be refused with a clear error.</summary>
public static class Misuse
{
    private struct Vertex
    {
        public float X, Y;
        public double Z;
    }

    private static readonly float[] Half = { 0.5f };

    [Test]
    public static void DisposedTwice()
    {
        using (Context context = new Context())
        {
            Texture texture = Make.Checker(context);
            texture.Dispose();
            texture.Dispose();
            Check.IsTrue(texture.IsDisposed, "IsDisposed");
        }
    }

    [Test]
    public static void UsedAfterDispose()
    {
        using (Context context = new Context())
        using (Sampler sampler = Make.Nearest(context))
        {
            Texture texture = Make.Checker(context);
            LookupBatch batch = texture.Prepare(sampler, new Lookups { U = Half, V = Half }, Make.Channel(1));
            texture.Dispose();
            batch.Run(); // the batch keeps the texture
            batch.Dispose();
            batch.Dispose();
            Check.Throws<ObjectDisposedException>(() => batch.Run());
            Check.Throws<ObjectDisposedException>(() => { long n = batch.Count; });
            Check.Throws<ObjectDisposedException>(() => texture.Sample(sampler, new Lookups { U = Half, V = Half },
                new Texels()), "texture: the Texture was disposed");
            Check.Throws<ObjectDisposedException>(() => { TextureInfo info = texture.Info; });
            Check.Throws<ObjectDisposedException>(() => new Material(context, new MaterialDesc {
                Slots = new[] { Slot.FromTexture(SlotTarget.Diffuse, texture) } }), "desc.Slots[0].Texture");
        }
        Context closed = new Context();
        closed.Dispose();
        Check.Throws<ObjectDisposedException>(() => new Sampler(closed), "context: the Context was disposed");
    }

    [Test]
    public static void Null()
    {
        using (Context context = new Context())
        {
            Check.Equal("context", Check.Throws<ArgumentNullException>(() => new Sampler(null)).ParamName, "ParamName");
            Check.Throws<ArgumentNullException>(() => new Texture(context, null));
            Check.Throws<ArgumentNullException>(() => context.Render(null));
            Check.Throws<ShdException>(() => context.Render(new RenderDesc()), "framebuffer");
            using (Framebuffer framebuffer = new Framebuffer(context, 8, 8))
            {
                Check.Throws<ArgumentNullException>(
                    () => context.Render(new RenderDesc { Framebuffer = framebuffer, Draws = new Draw[] { null } }),
                    "frame.Draws[0]");
                Check.Throws<ShdException>(
                    () => context.Render(new RenderDesc { Framebuffer = framebuffer, Draws = new[] { new Draw() } }),
                    "mesh");
            }
        }
    }

    [Test]
    public static void WrongLength()
    {
        float[] two = new float[2];
        using (Context context = new Context())
        using (Texture texture = Make.Checker(context))
        using (Sampler sampler = Make.Nearest(context))
        {
            ArgumentException problem = Check.Throws<ArgumentException>(
                () => texture.Sample(sampler, new Lookups { U = Half, V = two }, new Texels()),
                "lookups.V: 2 elements, not 1");
            Check.Equal("V", problem.ParamName, "ParamName");
            Texels texels = new Texels();
            texels.Channel[1] = two;
            Check.Throws<ArgumentException>(
                () => texture.Sample(sampler, new Lookups { U = Half, V = Half }, texels),
                "output.Channel: 2 elements, not 1");
            Check.Throws<ArgumentException>(() => SampleSpans(texture, sampler, Half, two, Half),
                                            "V: 2 elements, not 1");
            Check.Throws<ArgumentException>(() => SampleSpans(texture, sampler, Half, Half, two),
                                            "R: 2 elements, not 1");
            using (LookupBatch batch = texture.Prepare(sampler, new Lookups { U = two, V = two }, new Texels()))
                Check.Throws<ArgumentOutOfRangeException>(() => batch.Count = 3, "3 is not in [0, 2]");
            Check.Throws<ArgumentException>(
                () => new Texture(context, new TextureDesc(Format.Rgba8, 2, 2, new byte[15])),
                "desc.Texels: 15 bytes, not 16");
            Check.Throws<ArgumentException>(
                () => new Texture(context, new TextureDesc(Format.Bc7, 5, 4, new byte[16])),
                "desc.Texels: 16 bytes, not 32");
            MeshDesc mesh = new MeshDesc();
            Column.Set(mesh.Position, new float[9]);
            Column.Set(mesh.Uv, new float[4]);
            Check.Throws<ArgumentException>(() => new Mesh(context, mesh), "desc.Uv: 2 elements, not 3");
            Check.Throws<ArgumentException>(() => Column.Set(mesh.Position, new float[10]), "rows: 10 elements");
        }
    }

    private static void SampleSpans(Texture texture, Sampler sampler, float[] u, float[] v, float[] r)
    {
        texture.Sample(sampler, new LookupSpans { U = u, V = v }, new TexelSpans { R = r });
    }

    [Test]
    public static void WrongType()
    {
        MeshDesc mesh = new MeshDesc();
        Check.Throws<ArgumentException>(() => Column.Set(mesh.Position, new double[9]), "rows: elements are Double");
        Check.Throws<ArgumentException>(() => Column.Set(mesh.Position, new Float2[3]), "rows: elements are Float2");
        Check.Throws<ArgumentException>(() => Column.Set(mesh.Position, new float[3, 2]), "2 columns, not 3");
        Check.Throws<ArgumentException>(() => Column.OfField<float, Vertex>(new Vertex[3], "Z"),
                                        "field Z is Double, not Single");
        Check.Throws<ArgumentException>(() => Column.OfField<float, Vertex>(new Vertex[3], "W"), "no field W");
        using (Context context = new Context())
        using (Texture texture = Make.Checker(context))
        using (Sampler sampler = Make.Nearest(context))
        {
            Check.Throws<ArgumentException>(
                () => new Texture(context, new TextureDesc(Format.Rgba8, 1, 1, new float[1])),
                "desc.Texels: elements are Single, not channels of Rgba8");
            Check.Throws<ArgumentException>(() => new Texture(context, new TextureDesc(Format.R32f, 1, 1, new int[1])),
                                            "elements are Int32, not channels of R32f");
            Texels texels = new Texels();
            texels.Channel[0] = new ReadOnlyMemory<float>(new float[1]);
            Check.Throws<ArgumentException>(() => texture.Sample(sampler, new Lookups { U = Half, V = Half }, texels),
                                            "output.Channel: the memory is read-only");
            Check.Throws<ArgumentException>(
                () => new Texture(context, new TextureDesc { Flags = TextureFlags.Borrow }), "cannot borrow");
        }
    }

    [Test]
    public static void WrongStride()
    {
        float[] ten = new float[10];
        Check.Throws<ArgumentOutOfRangeException>(() => Column.Of(ten, 1, 3, 4), "4 elements from 1 in steps of 3");
        Check.Throws<ArgumentOutOfRangeException>(() => Column.Of(ten, -1, 1, 1), "-1 is negative");
        Check.Throws<ArgumentOutOfRangeException>(() => Column.Of(ten, 0, 0, 1), "0 is not positive");
        Check.Throws<ArgumentOutOfRangeException>(() => Column.Of(new float[2, 3], 3));
        Check.Throws<ArgumentOutOfRangeException>(() => Column.At<float>(IntPtr.Zero, 1, -4), "-4 is negative");
        using (Context context = new Context())
        using (Texture texture = Make.Checker(context))
        using (Sampler sampler = Make.Nearest(context))
        {
            IntPtr memory = Marshal.AllocHGlobal(64);
            Check.Throws<ShdException>(() => texture.Sample(sampler, new Lookups {
                U = Column.At<float>(memory, 2, 6), V = Column.At<float>(memory, 2, 8) }, Make.Channel(2)),
                "lookups.u", "6");
            Marshal.FreeHGlobal(memory);
        }
    }

    [Test]
    public static void OutOfRange()
    {
        using (Context context = new Context())
        {
            SamplerDesc desc = SamplerDesc.Default;
            desc.MaxAnisotropy = -1;
            ShdException problem = Check.Throws<ShdException>(() => new Sampler(context, desc), "max_anisotropy", "-1");
            Check.Equal(Result.ErrorInvalidArgument, problem.Result, "Result");
            Check.Throws<ShdException>(() => new Sampler(context, new SamplerDesc()), "struct_size");
            Check.Throws<ShdException>(() => new Framebuffer(context, 0, 4), "width");
            Check.Throws<OverflowException>(() => new Framebuffer(context, -1, 4));
            Check.Throws<ShdException>(() => new Light(context, new LightDesc { Kind = (LightKind)99 }), "99");
            Check.Throws<ArgumentOutOfRangeException>(() => new ThreadExecutor(-1), "-1 is not in");
        }
    }

    [Test]
    public static void TwoFramesOnOneFramebuffer()
    {
        using (Context context = new Context(new ContextDesc { WorkerCount = 1 }))
        using (Framebuffer framebuffer = new Framebuffer(context, 8, 8))
        using (Mesh mesh = Make.Square(context))
        {
            Exception inside = null;
            FragmentProgram program = (fragments, radiance) =>
            {
                if (inside != null) return;
                Thread second = new Thread(() =>
                {
                    try { context.Render(new RenderDesc { Framebuffer = framebuffer }); }
                    catch (Exception problem) { inside = problem; }
                });
                second.Start();
                second.Join();
            };
            using (Material material = Make.Program(context, program))
            {
                RenderDesc frame = new RenderDesc { Framebuffer = framebuffer,
                                                    Draws = new[] { new Draw(mesh, material) } };
                context.Render(frame);
                Check.IsTrue(inside is InvalidOperationException &&
                             inside.Message.Contains("frame.Framebuffer: another call"),
                             "the second frame: " + inside);
                context.Render(frame); // the framebuffer is free again
            }
        }
    }

    /// <summary>A batch serves one thread; the other one is refused while it runs.</summary>
    [Test]
    public static void TwoThreadsOnOneBatch()
    {
        float[] u = new float[20000];
        using (Context context = new Context(new ContextDesc { WorkerCount = 1 }))
        using (Texture texture = Make.Checker(context))
        using (Sampler sampler = Make.Nearest(context))
        using (LookupBatch batch = texture.Prepare(sampler, new Lookups { U = u, V = u }, Make.Channel(u.Length)))
        {
            int ran = 0, refused = 0;
            Exception other = null;
            ThreadStart loop = () =>
            {
                for (int i = 0; i < 100000 && Volatile.Read(ref refused) == 0; ++i)
                {
                    try
                    {
                        batch.Run();
                        Interlocked.Increment(ref ran);
                    }
                    catch (InvalidOperationException) { Interlocked.Increment(ref refused); }
                    catch (Exception problem) { other = problem; }
                }
            };
            Thread second = new Thread(loop);
            second.Start();
            loop();
            second.Join();
            Check.IsTrue(other == null && ran > 0 && refused > 0, ran + " runs, " + refused + " refused, " + other);
        }
    }
}
