// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Threading;
using Shd;
using Plane = Shd.Plane; // System.Numerics has another one

/// <summary>Lookups, frames and callbacks with known results.</summary>
public static class Rendering
{
    private struct Vertex
    {
        public float X, Y, Z, U, V;
    }

    private sealed class Broken : Executor
    {
        public override int WorkerCount { get { return 2; } }
        public override void ParallelFor(long count, ParallelTask task)
        {
            throw new InvalidOperationException("no threads");
        }
    }

    private static string CodesAt(Texture texture, Sampler sampler, float lod)
    {
        Texels texels = new Texels();
        float[][] channels = { new float[1], new float[1], new float[1], new float[1] };
        for (int c = 0; c < 4; ++c) texels.Channel[c] = channels[c];
        texture.Sample(sampler, new Lookups { U = new[] { 0.375f }, V = new[] { 0.125f }, Lod = new[] { lod } },
                       texels);
        return string.Join(" ", Array.ConvertAll(channels, channel => Math.Round(channel[0] * 255).ToString()));
    }

    /// <summary>The first row of BC1 is red, blue and colours between them; BC7 is one colour, in mode 6.</summary>
    [Test]
    public static void Blocks()
    {
        byte[] bc1 = { 0x00, 0xf8, 0x1f, 0x00, 0xe4, 0, 0, 0 };
        byte[] bc7 = { 192, 255, 159, 66, 1, 0, 254, 255, 1, 0, 0, 0, 0, 0, 0, 0 };
        TextureDesc levels = new TextureDesc(Format.Bc7, 8, 4, new byte[32]);
        levels.Tables = TableFlags.Mipmap;
        levels.LevelImages = new[] { new Image(Format.Bc7, 4, 2, bc7) };
        SamplerDesc nearest = SamplerDesc.Default;
        nearest.Filter = Filter.NearestMip;
        using (Context context = new Context())
        using (Sampler sampler = new Sampler(context, nearest))
        using (Texture first = new Texture(context, new TextureDesc(Format.Bc1Rgb, 4, 4, bc1)))
        using (Texture second = new Texture(context, new TextureDesc(Format.Bc7, 3, 1, bc7)))
        using (Texture third = new Texture(context, levels))
        {
            Check.Equal("0 0 255 255", CodesAt(first, sampler, 0), "BC1");
            Check.Equal("255 41 1 255", CodesAt(second, sampler, 0), "BC7");
            Check.Equal("0 0 0 0, 255 41 1 255", CodesAt(third, sampler, 0) + ", " + CodesAt(third, sampler, 1),
                        "levels");
        }
    }

    private static TextureInfo InfoOf(Context context, TextureDesc desc)
    {
        using (Texture texture = new Texture(context, desc)) return texture.Info;
    }

    /// <summary>A desc without a kind has that of its fields.</summary>
    [Test]
    public static void Kinds()
    {
        using (Context context = new Context())
        {
            TextureDesc desc = new TextureDesc(Format.R8, 2, 2, new byte[4]);
            Check.Equal(TextureKind.Texture2D, InfoOf(context, desc).Kind, "Kind");
            desc.Texels = new byte[12];
            desc.Depth = 3;
            Check.Equal(TextureKind.Texture3D, InfoOf(context, desc).Kind, "Kind of slices");
            Check.Equal(3u, InfoOf(context, desc).Depth, "Depth");
            desc.Texels = new byte[11];
            Check.Throws<ArgumentException>(() => new Texture(context, desc), "desc.Texels: 11 bytes, not 12");
            desc.Projection = Projection.Cube;
            Check.Throws<ArgumentException>(() => new Texture(context, desc), "desc.Kind: it must be set");
            desc.Kind = TextureKind.Directions;
            desc.Depth = 0;
            desc.Texels = new byte[24];
            Check.Equal(6L, InfoOf(context, desc).LayerCount, "LayerCount");
            desc.Kind = null;
            Check.Equal(TextureKind.Directions, InfoOf(context, desc).Kind, "Kind of faces");
            desc.Texels = new byte[4];
            Check.Throws<ArgumentException>(() => new Texture(context, desc), "desc.Texels: 4 bytes, not 24");
            desc.Projection = Projection.Angular;
            Check.Equal(1L, InfoOf(context, desc).LayerCount, "LayerCount");
            desc.Kind = TextureKind.Texture2D;
            Check.Throws<ShdException>(() => new Texture(context, desc), "texture.projection: 3, but texture.kind");
            desc.Kind = (TextureKind)3;
            Check.Throws<ShdException>(() => new Texture(context, desc), "texture.kind: 3");
            desc.Kind = TextureKind.Texture3D;
            Check.Throws<ShdException>(() => new Texture(context, desc), "texture.depth: 0");
        }
    }

    /// <summary>The caller's levels of slices and faces.</summary>
    [Test]
    public static void LevelImages()
    {
        Image grey = new Image(Format.R8, 1, 1, new byte[] { 100 });
        byte[] read = new byte[1];
        TextureDesc volume = new TextureDesc(Format.R8, 2, 2, new byte[16]) { Depth = 4, Tables = TableFlags.Mipmap };
        volume.LevelImages = new[] { grey, grey, grey };
        TextureDesc cube = new TextureDesc(Format.R8, 2, 2, new byte[24]) { Projection = Projection.Cube,
                                                                            Tables = TableFlags.Mipmap };
        cube.LevelImages = new[] { grey, grey, grey, grey, grey, grey };
        using (Context context = new Context())
        {
            using (Texture texture = new Texture(context, volume))
                texture.ReadLevel(0, 2, new Image(Format.R8, 1, 1, read));
            Check.Equal(100, (int)read[0], "level 2 of slices");
            read[0] = 0;
            using (Texture texture = new Texture(context, cube))
                texture.ReadLevel(5, 1, new Image(Format.R8, 1, 1, read));
            Check.Equal(100, (int)read[0], "level 1 of faces");
            cube.LevelImages = new[] { grey, grey };
            Check.Throws<ArgumentException>(() => new Texture(context, cube),
                                            "desc.LevelImages: 2 images are not levels of 6 layers");
            cube.Kind = TextureKind.Texture2D;
            cube.Texels = null;
            cube.LayerCount = 0;
            Check.Throws<ArgumentException>(() => new Texture(context, cube), "levels of 0 layers");
        }
    }

    [Test]
    public static void Columns()
    {
        float[] u = { 0.25f, 9, 0.75f, 9 }, v = { 0.25f, 0.25f }, red = new float[2], green = new float[6];
        using (Context context = new Context())
        using (Texture texture = Make.Checker(context))
        using (Sampler sampler = Make.Nearest(context))
        {
            Texels texels = new Texels();
            texels.Channel[0] = new Memory<float>(red);
            texels.Channel[3] = Column.Of(green, 1, 3, 2);
            texture.Sample(sampler, new Lookups { U = Column.Of(u, 0, 2, 2), V = new ReadOnlyMemory<float>(v) },
                           texels);
            Check.Equal("0 1", red[0] + " " + red[1], "red");
            Check.Equal("0 1 0 0 1 0", string.Join(" ", green), "alpha");
            texture.Sample(sampler, new LookupSpans { U = v, V = v }, new TexelSpans { R = red });
            Check.Equal("0 0", red[0] + " " + red[1], "red of spans");
            Lookups other = new Lookups { U = new float[] { float.NaN, 0.75f }, V = v };
            Levels levels = new Levels { Lod = new float[2] };
            texture.QueryLevels(sampler, other, levels);
            Check.Equal(1L, levels.NonfiniteCount, "NonfiniteCount of levels");
            using (LookupBatch batch = texture.Prepare(sampler, other, texels))
            {
                batch.Run();
                Check.Equal("0 1", red[0] + " " + red[1], "red of a batch");
                Check.Equal(1L, batch.NonfiniteCount, "NonfiniteCount");
                batch.Count = 0;
                batch.Run();
                Check.Equal(0L, batch.NonfiniteCount, "NonfiniteCount");
            }
        }
    }

    [Test]
    public static void Meshes()
    {
        Vertex[] vertices = { new Vertex { Y = 1, U = 1 }, new Vertex { V = 1 }, new Vertex { X = 1 } };
        MeshDesc desc = new MeshDesc { Indices16 = new ushort[] { 0, 1, 2 } };
        desc.Position[0] = Column.OfField<float, Vertex>(vertices, "X");
        desc.Position[1] = Column.OfField<float, Vertex>(vertices, "Y");
        desc.Position[2] = Column.OfField<float, Vertex>(vertices, "Z");
        desc.Uv[0] = Column.OfField<float, Vertex>(vertices, "U");
        desc.Uv[1] = Column.OfField<float, Vertex>(vertices, "V");
        using (Context context = new Context())
        using (Mesh mesh = new Mesh(context, desc))
        {
            float[,] positions = mesh.ReadPositions(), uv = mesh.ReadUv(), normals = mesh.ReadNormals();
            Check.Equal("0 1 0", positions[0, 0] + " " + positions[0, 1] + " " + positions[0, 2], "position");
            Check.Equal("1 0", uv[0, 0] + " " + uv[0, 1], "uv");
            Check.Equal(1.0f, normals[2, 2], "normal");
            Check.Equal("0 1 2", string.Join(" ", mesh.ReadIndices()), "indices");
            Check.Equal(1L, mesh.Info.TriangleCount, "triangles");
            MeshDesc strip = new MeshDesc { Topology = Topology.Strip };
            Column.Set(strip.Position, new[] { new Vector3(0, 1, 0), new Vector3(0, 0, 0), new Vector3(1, 0, 0) });
            using (Mesh same = new Mesh(context, strip))
                Check.Equal(1.0f, same.ReadPositions()[2, 0], "position of a strip");
        }
    }

    [Test]
    public static void Frame()
    {
        using (Context context = new Context())
        using (Texture texture = Make.Checker(context))
        using (Sampler sampler = Make.Nearest(context))
        using (Mesh mesh = Make.Square(context))
        using (Material material = new Material(context, new MaterialDesc { Model = Model.Unlit,
            Diffuse = new Float3(1, 1, 1), Slots = new[] { Slot.FromTexture(SlotTarget.Diffuse, texture, sampler) } }))
        using (Framebuffer framebuffer = new Framebuffer(context, 16, 8))
        {
            RenderStats stats = context.Render(new RenderDesc { Framebuffer = framebuffer,
                                                                Draws = new[] { new Draw(mesh, material) } });
            Check.Equal(2ul, stats.RasterizedTriangleCount, "triangles");
            float[,] red = framebuffer.ReadPlane(Plane.R);
            using (PlaneView view = framebuffer.ViewPlane(Plane.R))
            {
                for (int y = 0; y < 8; ++y)
                    for (int x = 0; x < 16; ++x)
                    {
                        Check.Equal((x < 8) == (y < 4) ? 0.0f : 1.0f, red[y, x], "red at " + x + ", " + y);
                        Check.Equal(red[y, x], view.Row(y)[x], "view");
                    }
                Check.Throws<ArgumentOutOfRangeException>(() => view.Row(8), "8 is not in [0, 8)");
            }
            Check.Equal(255, (int)framebuffer.ReadColor()[4 * 15], "red of a pixel");
            Check.Throws<ShdException>(() => framebuffer.ReadPlane(Plane.Lod));
        }
    }

    [Test]
    public static void Matrices()
    {
        using (Context context = new Context())
        using (Mesh mesh = Make.Square(context))
        using (Framebuffer framebuffer = new Framebuffer(context, 16, 8))
        {
            Matrix4 move = Matrix4x4.CreateTranslation(1, 0, 0);
            foreach (Draw draw in new[] { new Draw(mesh) { ObjectToWorld = move },
                                          new Draw(mesh) { Instances = new[] { move } } })
            {
                context.Render(new RenderDesc { Framebuffer = framebuffer, Draws = new[] { draw } });
                float[,] depth = framebuffer.ReadPlane(Plane.Depth);
                Check.Equal("1 0.5", depth[3, 7] + " " + depth[3, 8], "depth");
            }
        }
    }

    /// <summary>Workers of the runtime and of the library give the same bits.</summary>
    [Test]
    public static void Workers()
    {
        FragmentProgram program = (fragments, radiance) =>
        {
            ReadOnlySpan<float> u = fragments.U, v = fragments.V;
            Span<float> r = radiance.R;
            for (int i = 0; i < u.Length; ++i) r[i] = u[i] * v[i];
        };
        float[,] first = null;
        foreach (ContextDesc desc in new[] { new ContextDesc { WorkerCount = 1 }, new ContextDesc { WorkerCount = 2 },
                                             new ContextDesc { Executor = new ThreadExecutor(7) } })
            using (Context context = new Context(desc))
            using (Material material = Make.Program(context, program))
            {
                float[,] red = Make.Red(context, material, 300, 200);
                first = first ?? red;
                for (int y = 0; y < 200; ++y)
                    for (int x = 0; x < 300; ++x) Check.Equal(first[y, x], red[y, x], "red at " + x + ", " + y);
            }
    }

    [Test]
    public static void VertexPrograms()
    {
        MaterialProgram program = new MaterialProgram {
            Vertex = (vertices, outputs) =>
            {
                Span<float> x = outputs.X;
                for (int i = 0; i < x.Length; ++i) x[i] = vertices.Px[i] / 2;
                vertices.U.CopyTo(outputs.Varying(0));
            },
            Fragment = (fragments, radiance) => fragments.Varying(0).CopyTo(radiance.R) };
        using (Context context = new Context())
        using (Material material = new Material(context, new MaterialDesc { Model = Model.Program, Program = program,
                                                                            VaryingCount = 1 }))
        {
            float[,] red = Make.Red(context, material, 16, 8);
            Check.Equal(0.0f, red[3, 3], "red beside the square");
            Check.IsTrue(Math.Abs(red[3, 4] - 1 / 16.0f) < 1e-6f, "red at the edge: " + red[3, 4]);
        }
    }

    [Test]
    public static void Procedures()
    {
        Slot stripes = Slot.FromProcedure(SlotTarget.Diffuse, (fragments, channels) =>
        {
            Span<float> r = channels[0];
            for (int i = 0; i < r.Length; ++i) r[i] = fragments.U[i] > 0.5f ? 1 : 0;
        });
        using (Context context = new Context())
        using (Material material = new Material(context, new MaterialDesc { Model = Model.Unlit,
            Diffuse = new Float3(1, 1, 1), Slots = new[] { stripes } }))
        {
            float[,] red = Make.Red(context, material, 16, 8);
            Check.Equal("0 1", red[3, 7] + " " + red[3, 8], "red");
        }
    }

    [Test]
    public static void LookupsInPrograms()
    {
        using (Context context = new Context())
        using (Texture texture = Make.Checker(context))
        using (Sampler sampler = Make.Nearest(context))
        using (Material material = Make.Program(context, (fragments, radiance) => texture.Sample(
            sampler, new LookupSpans { U = fragments.U, V = fragments.V }, new TexelSpans { R = radiance.R })))
        {
            float[,] red = Make.Red(context, material, 16, 8);
            Check.Equal("0 1", red[0, 0] + " " + red[0, 15], "red");
        }
    }

    [Test]
    public static void Exceptions()
    {
        foreach (uint workers in new uint[] { 1, 2 })
            using (Context context = new Context(new ContextDesc { WorkerCount = workers }))
            {
                int calls = 0;
                bool isBroken = true;
                FragmentProgram program = (fragments, radiance) =>
                {
                    if (!isBroken) return;
                    Interlocked.Increment(ref calls);
                    throw new KeyNotFoundException("from the program");
                };
                using (Material material = Make.Program(context, program))
                {
                    KeyNotFoundException problem = Check.Throws<KeyNotFoundException>(
                        () => Make.Red(context, material, 256, 256), "from the program");
                    Check.IsTrue(problem.StackTrace.Contains("Exceptions"), "the stack of the program");
                    Check.IsTrue(calls <= workers, "the program ran " + calls + " times");
                    isBroken = false;
                    Make.Red(context, material, 16, 8); // the material works again
                }
            }
        using (Context context = new Context(new ContextDesc { Executor = new Broken() }))
            Check.Throws<InvalidOperationException>(() => Make.Red(context, null, 256, 256), "no threads");
    }

    [Test]
    public static void Tiles()
    {
        float[,] image = new float[128, 256];
        using (Context context = new Context())
        using (Material material = Make.Program(context, (fragments, radiance) => fragments.U.CopyTo(radiance.R)))
        {
            RenderDesc frame = new RenderDesc { Present = tile =>
            {
                Region area = tile.Area;
                for (int y = 0; y < area.Height; ++y)
                    for (int x = 0; x < area.Width; ++x) image[area.Y + y, area.X + x] = tile.Row(0, y)[x];
            } };
            float[,] red = Make.Red(context, material, 256, 128, frame);
            for (int i = 0; i < 128; ++i) Check.Equal(red[i, 2 * i], image[i, 2 * i], "tile");
            Check.Throws<DivideByZeroException>(() => Make.Red(context, material, 8, 8, new RenderDesc {
                Present = tile => { int zero = tile.Worker * 0; Thread.Sleep(1 / zero); } }));
        }
    }

    [Test]
    public static void Progress()
    {
        using (Context context = new Context())
        using (Framebuffer framebuffer = new Framebuffer(context, 8, 8))
        {
            float last = 0;
            Func<float, Result> progress = fraction =>
            {
                last = fraction;
                return Result.Ok;
            };
            context.Render(new RenderDesc { Framebuffer = framebuffer, Progress = progress });
            Check.Equal(1.0f, last, "the last fraction");
            ShdException problem = Check.Throws<ShdException>(
                () => context.Render(new RenderDesc { Framebuffer = framebuffer,
                                                      Progress = fraction => Result.ErrorCancelled }));
            Check.Equal(Result.ErrorCancelled, problem.Result, "Result");
            progress = fraction => Result.ErrorNotFound;
            problem = Check.Throws<ShdException>(
                () => context.Render(new RenderDesc { Framebuffer = framebuffer, Progress = progress }));
            Check.Equal(Result.ErrorNotFound, problem.Result, "Result");
            Check.Throws<FormatException>(() => context.Render(new RenderDesc { Framebuffer = framebuffer,
                Progress = fraction => { throw new FormatException("from the callback"); } }), "from the callback");
        }
    }
}
