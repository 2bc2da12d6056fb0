// SPDX-License-Identifier: MIT
// Renders a teapot with a texture in the light of two lamps, and writes a PNG.
//
//   Teapot picture.png [width height]
using System;
using System.IO;
using System.IO.Compression;
using System.Numerics;
using System.Text;
using Shd;

/// <summary>Writes 8-bit RGBA pixels, after "Portable Network Graphics (PNG) Specification" (W3C, 2003).</summary>
public static class Png
{
    private static uint Crc(byte[] bytes)
    {
        uint crc = 0xffffffff;
        foreach (byte value in bytes)
        {
            crc ^= value;
            for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
        }
        return ~crc;
    }

    private static void WriteNumber(Stream to, uint value)
    {
        for (int shift = 24; shift >= 0; shift -= 8) to.WriteByte((byte)(value >> shift));
    }

    private static void WriteChunk(Stream to, string type, byte[] data)
    {
        MemoryStream body = new MemoryStream();
        body.Write(Encoding.ASCII.GetBytes(type), 0, 4);
        body.Write(data, 0, data.Length);
        WriteNumber(to, (uint)data.Length);
        body.WriteTo(to);
        WriteNumber(to, Crc(body.ToArray()));
    }

    /// <summary>The rows, each after a filter byte of 0, as a zlib stream.</summary>
    private static byte[] Compress(int width, int height, byte[] pixels)
    {
        MemoryStream to = new MemoryStream();
        to.WriteByte(0x78);
        to.WriteByte(0x9c);
        uint a = 1, b = 0; // Adler-32
        using (DeflateStream deflate = new DeflateStream(to, CompressionMode.Compress, true))
        {
            byte[] row = new byte[1 + 4 * width];
            for (int y = 0; y < height; ++y)
            {
                Buffer.BlockCopy(pixels, 4 * width * y, row, 1, 4 * width);
                deflate.Write(row, 0, row.Length);
                foreach (byte value in row)
                {
                    a = (a + value) % 65521;
                    b = (b + a) % 65521;
                }
            }
        }
        WriteNumber(to, b << 16 | a);
        return to.ToArray();
    }

    public static void Write(string path, int width, int height, byte[] pixels)
    {
        MemoryStream head = new MemoryStream();
        WriteNumber(head, (uint)width);
        WriteNumber(head, (uint)height);
        head.Write(new byte[] { 8, 6, 0, 0, 0 }, 0, 5); // 8 bits, RGBA
        using (FileStream to = File.Create(path))
        {
            to.Write(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10 }, 0, 8);
            WriteChunk(to, "IHDR", head.ToArray());
            WriteChunk(to, "IDAT", Compress(width, height, pixels));
            WriteChunk(to, "IEND", new byte[0]);
        }
    }
}

public static class Teapot
{
    private static Texture CreateChecker(Context context)
    {
        const int size = 256;
        byte[,,] texels = new byte[size, size, 4];
        for (int y = 0; y < size; ++y)
        {
            for (int x = 0; x < size; ++x)
            {
                bool isDark = ((x / 32 ^ y / 32) & 1) != 0;
                texels[y, x, 0] = (byte)(isDark ? 40 : 240);
                texels[y, x, 1] = (byte)(isDark ? 90 : 230);
                texels[y, x, 2] = (byte)(isDark ? 130 : 210);
                texels[y, x, 3] = 255;
            }
        }
        TextureDesc desc = new TextureDesc(Format.Rgba8Srgb, size, size, texels) { Tables = TableFlags.Mipmap };
        return new Texture(context, desc);
    }

    private static byte[] Render(int width, int height)
    {
        ShapeDesc shape = ShapeDesc.Default;
        shape.Kind = Shape.Teapot;
        SamplerDesc filter = SamplerDesc.Default;
        filter.Filter = Filter.Anisotropic;
        filter.MaxAnisotropy = 8;
        using (Context context = new Context())
        using (Texture checker = CreateChecker(context))
        using (Sampler sampler = new Sampler(context, filter))
        using (Mesh mesh = Mesh.FromShape(context, shape))
        using (Material material = new Material(context, new MaterialDesc {
            Model = Model.BlinnPhong, Specular = new Float3(0.4f, 0.4f, 0.4f), Exponent = 60,
            Slots = new[] { Slot.FromTexture(SlotTarget.Diffuse, checker, sampler) } }))
        using (Light sun = new Light(context, new LightDesc {
            Kind = LightKind.Directional, Direction = new Float3(-1, -1.5f, -1),
            Intensity = new Float3(0.9f, 0.88f, 0.8f) }))
        using (Light sky = new Light(context, new LightDesc {
            Kind = LightKind.Ambient, Intensity = new Float3(0.15f, 0.18f, 0.25f) }))
        using (Framebuffer framebuffer = new Framebuffer(context, width, height, 8))
        {
            MeshInfo info = mesh.Info;
            Vector3 centre = ((Vector3)info.BoundsMin + (Vector3)info.BoundsMax) / 2;
            float size = ((Vector3)info.BoundsMax - (Vector3)info.BoundsMin).Length();
            Camera camera = Camera.Default;
            camera.Target = centre;
            camera.Eye = centre + size * new Vector3(0.5f, 0.55f, 1);
            camera.FovY = 0.7f;
            RenderStats stats = context.Render(new RenderDesc {
                Framebuffer = framebuffer, ClearColor = new Float4(0.05f, 0.07f, 0.1f, 1), Camera = camera,
                Lights = new[] { sun, sky }, Draws = new[] { new Draw(mesh, material) } });
            Console.WriteLine("{0} triangles, {1} fragments", stats.TriangleCount, stats.FragmentCount);
            return framebuffer.ReadColor(Format.Rgba8Srgb);
        }
    }

    public static int Main(string[] arguments)
    {
        if (arguments.Length != 1 && arguments.Length != 3)
        {
            Console.Error.WriteLine("usage: Teapot picture.png [width height]");
            return 2;
        }
        try
        {
            int width = arguments.Length == 3 ? int.Parse(arguments[1]) : 640;
            int height = arguments.Length == 3 ? int.Parse(arguments[2]) : 480;
            Png.Write(arguments[0], width, height, Render(width, height));
            return 0;
        }
        catch (Exception problem) when (problem is ShdException || problem is IOException || problem is FormatException)
        {
            Console.Error.WriteLine("teapot: " + problem.Message);
            return 1;
        }
    }
}
