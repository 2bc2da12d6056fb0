// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Runtime.CompilerServices;
using System.Threading;
using Shd;

/// <summary>Textures in tile caches.</summary>
public static class Tiles
{
    private const int Width = 100, Height = 70, Count = 500;

    private sealed class Problem : Exception { }

    /// <summary>A texture in memory, its levels as tiles, and a texture of these tiles.</summary>
    private sealed class Source : IDisposable
    {
        public readonly Context Context = new Context();
        public readonly TileCache Cache;
        public readonly Texture Memory, Texture;
        public bool Throws;
        public int Calls, Loaded;
        private readonly byte[][] levels;

        public Source()
        {
            byte[] texels = new byte[Width * Height * 4];
            new Random(1).NextBytes(texels);
            Memory = new Texture(Context, Desc(texels));
            levels = new byte[Memory.Info.LevelCount][];
            for (int l = 0; l < levels.Length; ++l)
            {
                int width = Math.Max(1, Width >> l), height = Math.Max(1, Height >> l);
                levels[l] = new byte[width * height * 4];
                Memory.ReadLevel(0, l, new Image(Format.Rgba8, width, height, levels[l]));
            }
            TileCacheDesc desc = TileCacheDesc.Default;
            desc.TileBytes = 1024;
            desc.BudgetBytes = 1 << 20;
            Cache = new TileCache(Context, desc);
            Texture = Make();
        }

        public static TextureDesc Desc(byte[] texels)
        {
            return new TextureDesc(Format.Rgba8, Width, Height, texels) { Tables = TableFlags.Mipmap };
        }

        public Texture Make()
        {
            TextureDesc desc = Desc(null);
            desc.Tiles = new TileSource(Cache, Load);
            return new Texture(Context, desc);
        }

        private void Load(TextureTiles tiles)
        {
            Interlocked.Increment(ref Calls);
            Interlocked.Add(ref Loaded, tiles.Count);
            if (Throws)
            {
                Throws = false;
                throw new Problem();
            }
            for (int i = 0; i < tiles.Count; ++i)
            {
                TextureTile tile = tiles[i];
                Region area = tile.Area;
                for (int y = 0; y < area.Height; ++y)
                {
                    int first = ((int)area.Y + y) * Math.Max(1, Width >> tile.Level) + (int)area.X;
                    new ReadOnlySpan<byte>(levels[tile.Level], first * 4, (int)area.Width * 4).CopyTo(tile.Row(y));
                }
            }
        }

        public float[][] Sample(Texture texture, MissingTiles missing = MissingTiles.Wait)
        {
            return Look(Context, texture, missing);
        }

        public void Dispose()
        {
            Texture.Dispose();
            Memory.Dispose();
            Cache.Dispose();
            Context.Dispose();
        }
    }

    private static float[][] Look(Context context, Texture texture, MissingTiles missing)
    {
        float[] u = new float[Count], v = new float[Count], lod = new float[Count];
        for (int i = 0; i < Count; ++i)
        {
            u[i] = i * 37 % Count / (float)Count;
            v[i] = i * 91 % Count / (float)Count;
            lod[i] = i / 83.0f;
        }
        Texels texels = new Texels();
        float[][] channels = new float[4][];
        for (int c = 0; c < 4; ++c) texels.Channel[c] = channels[c] = new float[Count];
        SamplerDesc desc = SamplerDesc.Default;
        desc.Filter = Filter.Trilinear;
        desc.MissingTiles = missing;
        using (Sampler sampler = new Sampler(context, desc))
            texture.Sample(sampler, new Lookups { U = u, V = v, Lod = lod }, texels);
        return channels;
    }

    private static bool AreEqual(float[][] a, float[][] b)
    {
        for (int c = 0; c < 4; ++c)
            for (int i = 0; i < Count; ++i)
                if (BitConverter.ToInt32(BitConverter.GetBytes(a[c][i]), 0) !=
                    BitConverter.ToInt32(BitConverter.GetBytes(b[c][i]), 0)) return false;
        return true;
    }

    private static TileRegion Region()
    {
        TileRegion region = TileRegion.Default;
        region.Level = 1;
        region.Area.Width = Width / 2;
        region.Area.Height = Height / 2;
        return region;
    }

    [Test]
    public static void BitsOfMemory()
    {
        using (Source source = new Source())
        {
            float[][] expected = source.Sample(source.Memory);
            Check.IsTrue(AreEqual(expected, source.Sample(source.Texture)), "bits");
            TileCacheStats stats = source.Cache.Stats;
            Check.Equal((ulong)source.Calls, stats.LoadCount, "LoadCount");
            Check.Equal((ulong)source.Loaded, stats.LoadedTileCount, "LoadedTileCount");
            Check.Equal((long)source.Loaded, stats.ResidentTileCount, "ResidentTileCount");
            source.Sample(source.Texture);
            Check.Equal(stats.LoadCount, source.Cache.Stats.LoadCount, "loads of resident tiles");
        }
    }

    [Test]
    public static void Exceptions()
    {
        using (Source source = new Source())
        {
            float[][] expected = source.Sample(source.Memory);
            Action<Texture>[] calls = { texture => source.Sample(texture), texture => texture.LoadTiles(Region()),
                                        texture => texture.PinTiles(Region()) };
            foreach (Action<Texture> call in calls)
                using (Texture texture = source.Make())
                {
                    source.Throws = true;
                    Check.Throws<Problem>(() => call(texture));
                    Check.IsTrue(AreEqual(expected, source.Sample(texture)), "bits after an exception");
                }
            Check.IsTrue(source.Cache.Stats.FailedTileCount >= 3, "FailedTileCount");
        }
    }

    [Test]
    public static void Requested()
    {
        using (Source source = new Source())
        {
            source.Sample(source.Texture, MissingTiles.Coarser);
            Check.Equal(0, source.Calls, "calls of lookups that do not wait");
            source.Throws = true;
            Check.Throws<Problem>(() => source.Cache.LoadRequested());
            do source.Sample(source.Texture, MissingTiles.Coarser);
            while (source.Cache.LoadRequested(8) > 0);
            Check.IsTrue(AreEqual(source.Sample(source.Memory), source.Sample(source.Texture, MissingTiles.Coarser)),
                         "bits");
        }
    }

    [Test]
    public static void Regions()
    {
        using (Source source = new Source())
        {
            source.Texture.PinTiles(Region());
            Check.Equal(12L, source.Cache.Stats.PinnedTileCount, "PinnedTileCount");
            source.Texture.UnpinTiles(Region());
            Check.Equal(0L, source.Cache.Stats.PinnedTileCount, "PinnedTileCount");
            Check.Throws<ShdException>(() => source.Texture.UnpinTiles(Region()), "pinned");
            source.Texture.LoadTiles(Region());
            Check.Equal(12, source.Loaded, "tiles");
            source.Texture.DropTiles(Region());
            source.Texture.LoadTiles(Region());
            Check.Equal(24, source.Loaded, "tiles after DropTiles");
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static WeakReference Held(Context context, out Material material)
    {
        object held = new object();
        using (TileCache cache = new TileCache(context))
        using (Texture texture = new Texture(context, new TextureDesc(Format.R8, 1, 1, null) {
            Tiles = new TileSource(cache, tiles => tiles[0].Row(0).Fill((byte)(held == null ? 0 : 255))) }))
            material = new Material(context, new MaterialDesc { Model = Model.Unlit, Diffuse = new Float3(1, 1, 1),
                Slots = new[] { Slot.FromTexture(SlotTarget.Diffuse, texture) } });
        return new WeakReference(held);
    }

    /// <summary>A material keeps the function of its texture.</summary>
    [Test]
    public static void MaterialKeepsFunction()
    {
        using (Context context = new Context())
        {
            Material material;
            WeakReference held = Held(context, out material);
            GC.Collect();
            GC.WaitForPendingFinalizers();
            Check.IsTrue(held.IsAlive, "the function of a texture in use");
            Check.Equal(1.0f, Make.Red(context, material, 8, 8)[4, 4], "red");
            material.Dispose();
        }
    }

    [Test]
    public static void Refused()
    {
        using (Source source = new Source())
        {
            TextureDesc desc = Source.Desc(null);
            desc.Tiles = new TileSource(null, tiles => { });
            Check.Throws<ArgumentNullException>(() => new Texture(source.Context, desc), "Tiles.Cache");
            desc.Tiles = new TileSource(source.Cache, null);
            Check.Throws<ShdException>(() => new Texture(source.Context, desc), "texture.tiles.load");
            desc.Tiles = new TileSource(source.Cache, tiles => { });
            desc.LayerCount = 0;
            Check.Throws<ShdException>(() => new Texture(source.Context, desc), "texture.layer_count: 0");
            Check.Throws<ShdException>(() => source.Memory.LoadTiles(Region()), "tiles");
            TileCacheDesc small = TileCacheDesc.Default;
            small.BudgetBytes = 1;
            Check.Throws<ShdException>(() => new TileCache(source.Context, small), "budget_bytes: 1 is not");
        }
    }

    /// <summary>Rows and tiles that the callback does not have.</summary>
    [Test]
    public static void Indices()
    {
        using (Context context = new Context())
        using (TileCache cache = new TileCache(context))
        {
            TileLoader[] loaders = { tiles => tiles[tiles.Count].Row(0), tiles => tiles[0].Row((int)tiles[0].Area.Height) };
            foreach (TileLoader loader in loaders)
                using (Texture texture = new Texture(context, new TextureDesc(Format.R8, 1, 1, null) {
                    Tiles = new TileSource(cache, loader) }))
                {
                    TileRegion region = TileRegion.Default;
                    region.Area.Width = region.Area.Height = 1;
                    Check.Throws<ArgumentOutOfRangeException>(() => texture.LoadTiles(region), "1 is not in [0, 1)");
                }
        }
    }

    [Test]
    public static void TiledFile()
    {
        string path = Path.Combine(Path.GetDirectoryName(Tests.LayoutPath), "../../tiled.tif");
        using (Context context = new Context())
        using (TileCache cache = new TileCache(context))
        {
            TileFileDesc desc = new TileFileDesc { Cache = cache, Encoding = ColorEncoding.Linear };
            TileFileInfo info;
            byte[] texels = new byte[256];
            for (int i = 0; i < 256; ++i) texels[i] = (byte)i;
            using (Texture texture = Files.OpenTexture(context, path, desc, out info))
            using (Texture memory = new Texture(context, new TextureDesc(Format.R8, 16, 16, texels)))
            {
                Check.Equal(1L, info.FileCount, "FileCount");
                Check.Equal(16u, info.TileWidth, "TileWidth");
                Check.IsTrue(AreEqual(Look(context, memory, MissingTiles.Wait),
                                      Look(context, texture, MissingTiles.Wait)), "bits");
            }
            Check.Throws<ShdException>(() => Files.OpenTexture(context, "nothing.tif", desc, out info), "nothing.tif");
        }
    }
}
