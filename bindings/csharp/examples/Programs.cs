// SPDX-License-Identifier: MIT
// The three programs that every binding has, as bindings/c/programs.c: a batch of lookups, a frame, and a fragment
// program. Each prints a hash of its result.
//
//   Programs            prints the hashes
//   Programs --speed    prints the time of a call of one lookup, and of a batch of 2^20
using System;
using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;
using Shd;

public static class Programs
{
    private const int Size = 64, Count = 16384, Width = 320, Height = 200, Batch = 1 << 20, Calls = 200000;
    private const ulong HashBegin = 0xcbf29ce484222325;

    // FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte.
    private static ulong Hash(ulong hash, ReadOnlySpan<byte> bytes)
    {
        for (int i = 0; i < bytes.Length; ++i) hash = unchecked((hash ^ bytes[i]) * 0x100000001b3);
        return hash;
    }

    private static Texture CreateTexture(Context context)
    {
        byte[] texels = new byte[Size * Size * 4];
        for (int y = 0, i = 0; y < Size; ++y)
        {
            for (int x = 0; x < Size; ++x, i += 4)
            {
                texels[i] = (byte)(x * 4);
                texels[i + 1] = (byte)(y * 4);
                texels[i + 2] = (byte)((x ^ y) * 4);
                texels[i + 3] = 255;
            }
        }
        TextureDesc desc = new TextureDesc(Format.Rgba8Srgb, Size, Size, texels) { Tables = TableFlags.Mipmap };
        return new Texture(context, desc);
    }

    private static Sampler CreateSampler(Context context, Filter filter)
    {
        SamplerDesc desc = SamplerDesc.Default;
        desc.Filter = filter;
        desc.MaxAnisotropy = 16;
        return new Sampler(context, desc);
    }

    // 1. A batch of lookups: footprints of many sizes and directions, filtered with EWA.
    private static void LookUp(Context context)
    {
        float[][] input = new float[6][], output = new float[4][];
        for (int i = 0; i < 6; ++i) input[i] = new float[Count];
        for (int i = 0; i < 4; ++i) output[i] = new float[Count];
        for (int i = 0; i < Count; ++i)
        {
            input[0][i] = i % 128 / 64.0f;
            input[1][i] = i / 128 / 128.0f;
            input[2][i] = (1 + i % 7) / 256.0f;
            input[3][i] = i % 5 / 512.0f;
            input[4][i] = i % 3 / -512.0f;
            input[5][i] = (1 + i % 11) / 1024.0f;
        }
        using (Texture texture = CreateTexture(context))
        using (Sampler sampler = CreateSampler(context, Filter.Ewa))
        {
            Texels texels = new Texels();
            for (int i = 0; i < 4; ++i) texels.Channel[i] = output[i];
            texture.Sample(sampler, new Lookups { U = input[0], V = input[1], Dudx = input[2], Dvdx = input[3],
                                                  Dudy = input[4], Dvdy = input[5] }, texels);
        }
        ulong hash = HashBegin;
        foreach (float[] channel in output) hash = Hash(hash, MemoryMarshal.AsBytes<float>(channel));
        Console.WriteLine("lookup {0:x16}", hash);
    }

    // Renders a torus of one material in the light of the sun, with four samples a pixel, and prints the hash of its
    // pixels as RGBA8 in sRGB.
    private static void Render(Context context, string name, MaterialDesc materialDesc)
    {
        ShapeDesc torus = ShapeDesc.Default;
        torus.Kind = Shape.Torus;
        LightDesc sunDesc = new LightDesc { Kind = LightKind.Directional, Direction = new Float3(-0.5f, -1, -0.25f) };
        Camera camera = Camera.Default;
        camera.Eye = new Float3(0.5f, 1.5f, 2);
        using (Mesh mesh = Mesh.FromShape(context, torus))
        using (Material material = new Material(context, materialDesc))
        using (Light sun = new Light(context, sunDesc))
        using (Framebuffer framebuffer = new Framebuffer(context, Width, Height, 4))
        {
            context.Render(new RenderDesc { Framebuffer = framebuffer, Camera = camera, Lights = new[] { sun },
                                            Draws = new[] { new Draw(mesh, material) } });
            Console.WriteLine("{0} {1:x16}", name, Hash(HashBegin, framebuffer.ReadColor(Format.Rgba8Srgb)));
        }
    }

    // 2. A frame: the material has a texture.
    private static void DrawTextured(Context context)
    {
        using (Texture texture = CreateTexture(context))
        using (Sampler sampler = CreateSampler(context, Filter.Trilinear))
        {
            Slot slot = Slot.FromTexture(SlotTarget.Diffuse, texture, sampler);
            Render(context, "frame", new MaterialDesc { Model = Model.BlinnPhong, Slots = new[] { slot } });
        }
    }

    // 3. A fragment program: shows the texture coordinates.
    private static void DrawProgram(Context context)
    {
        const float blue = 0.25f;
        FragmentProgram uvAsColour = (fragments, radiance) =>
        {
            fragments.U.CopyTo(radiance.R);
            fragments.V.CopyTo(radiance.G);
            radiance.B.Fill(blue);
        };
        Render(context, "program",
               new MaterialDesc { Model = Model.Program, Program = new MaterialProgram { Fragment = uvAsColour } });
    }

    // Seconds of `calls` calls, the best of seven.
    private static double Measure(LookupBatch batch, int calls)
    {
        double best = double.MaxValue;
        for (int trial = 0; trial < 7; ++trial)
        {
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < calls; ++i) batch.Run();
            best = Math.Min(best, (Stopwatch.GetTimestamp() - start) / (double)Stopwatch.Frequency);
        }
        return best;
    }

    private static void PrintSpeed()
    {
        float[] u = new float[Batch], v = new float[Batch], lod = new float[Batch];
        for (int i = 0; i < Batch; ++i)
        {
            u[i] = i % 1024 / 1024.0f;
            v[i] = i / 1024 / 1024.0f;
            lod[i] = i % 16 / 8.0f;
        }
        Texels texels = new Texels();
        for (int i = 0; i < 4; ++i) texels.Channel[i] = new float[Batch];
        using (Context context = new Context(new ContextDesc { WorkerCount = 1 }))
        using (Texture texture = CreateTexture(context))
        using (Sampler sampler = CreateSampler(context, Filter.Trilinear))
        using (LookupBatch batch = texture.Prepare(sampler, new Lookups { U = u, V = v, Lod = lod }, texels))
        {
            batch.Count = 1;
            Console.WriteLine("call {0:F2} ns", 1e9 * Measure(batch, Calls) / Calls);
            batch.Count = Batch;
            Console.WriteLine("batch {0:F4} ms", 1e3 * Measure(batch, 3) / 3);
        }
    }

    public static int Main(string[] arguments)
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        try
        {
            if (arguments.Length > 0 && arguments[0] == "--speed")
            {
                PrintSpeed();
                return 0;
            }
            using (Context context = new Context())
            {
                LookUp(context);
                DrawTextured(context);
                DrawProgram(context);
            }
            return 0;
        }
        catch (ShdException problem)
        {
            Console.Error.WriteLine("programs: " + problem.Message);
            return 1;
        }
    }
}
