// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>A texture with its tables: an image, an array of them, a 3D texture or one of directions.</summary>
    public sealed unsafe class Texture : ShdObject
    {
        public Texture(Context context, TextureDesc desc) : this()
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.TextureDesc built = desc.Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.TextureCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        internal Texture() : base(new TextureHandle()) { }

        public TextureInfo Info
        {
            get
            {
                using (Call call = new Call())
                {
                    TextureInfo info = TextureInfo.Default;
                    call.Check(Native.LibShd.TextureGetInfo(call.Use(this, "texture"), &info));
                    return info;
                }
            }
        }

        /// <summary>Filters a batch of lookups into the columns of `output`.</summary>
        public void Sample(Sampler sampler, Lookups lookups, Texels output)
        {
            if (lookups == null) throw new ArgumentNullException("lookups");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.Lookups built = lookups.Build(call, "lookups");
                Native.Texels texels = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.TextureSample(call.Use(this, "texture"), call.Use(sampler, "sampler"), &built,
                                                       &texels));
                output.Take(ref texels);
            }
        }

        /// <summary>Filters lookups in spans. Fields of `lookups` and `output` that are empty are absent.</summary>
        public void Sample(Sampler sampler, LookupSpans lookups, TexelSpans output)
        {
            using (Call call = new Call())
            fixed (float* u = &MemoryMarshal.GetReference(lookups.U), v = &MemoryMarshal.GetReference(lookups.V))
            fixed (float* dudx = &MemoryMarshal.GetReference(lookups.Dudx))
            fixed (float* dvdx = &MemoryMarshal.GetReference(lookups.Dvdx))
            fixed (float* dudy = &MemoryMarshal.GetReference(lookups.Dudy))
            fixed (float* dvdy = &MemoryMarshal.GetReference(lookups.Dvdy))
            fixed (float* lod = &MemoryMarshal.GetReference(lookups.Lod))
            fixed (float* r = &MemoryMarshal.GetReference(output.R), g = &MemoryMarshal.GetReference(output.G))
            fixed (float* b = &MemoryMarshal.GetReference(output.B), a = &MemoryMarshal.GetReference(output.A))
            {
                int count = lookups.CheckCount();
                output.CheckCount(count);
                Native.Lookups built = Native.Lookups.Default;
                Native.Texels texels = Native.Texels.Default;
                built.Count = count;
                built.U.Data = u;
                built.V.Data = v;
                built.Dudx.Data = dudx;
                built.Dvdx.Data = dvdx;
                built.Dudy.Data = dudy;
                built.Dvdy.Data = dvdy;
                built.Lod.Data = lod;
                Native.F32Out* channels = (Native.F32Out*)&texels.Channel;
                channels[0].Data = r;
                channels[1].Data = g;
                channels[2].Data = b;
                channels[3].Data = a;
                call.Check(Native.LibShd.TextureSample(call.Use(this, "texture"), call.Use(sampler, "sampler"), &built,
                                                       &texels));
            }
        }

        /// <summary>Levels that the lookups would use.</summary>
        public void QueryLevels(Sampler sampler, Lookups lookups, Levels output)
        {
            if (lookups == null) throw new ArgumentNullException("lookups");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.Lookups built = lookups.Build(call, "lookups");
                Native.Levels levels = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.TextureQueryLevels(call.Use(this, "texture"), call.Use(sampler, "sampler"),
                                                            &built, &levels));
                output.Take(ref levels);
            }
        }

        /// <summary>A batch that can be run many times: arrays stay pinned until its Dispose.</summary>
        public LookupBatch Prepare(Sampler sampler, Lookups lookups, Texels output)
        {
            return new LookupBatch(this, sampler, lookups, output);
        }

        /// <summary>Copies a level into the pixels of an image.</summary>
        public void ReadLevel(int layer, int level, Image output)
        {
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.Image image = output.Build(call, "output");
                call.Check(Native.LibShd.TextureReadLevel(call.Use(this, "texture"), checked((uint)layer),
                                                          checked((uint)level), &image));
            }
        }

        /// <summary>Loads the tiles of a region that are not in memory.</summary>
        public void LoadTiles(TileRegion region)
        {
            using (Call call = new Call())
                call.Check(Native.LibShd.TextureLoadTiles(call.Use(this, "texture"), &region));
        }

        /// <summary>Loads the tiles of a region, and keeps them until UnpinTiles.</summary>
        public void PinTiles(TileRegion region)
        {
            using (Call call = new Call())
                call.Check(Native.LibShd.TexturePinTiles(call.Use(this, "texture"), &region));
        }

        /// <summary>Undoes one PinTiles of the same region.</summary>
        public void UnpinTiles(TileRegion region)
        {
            using (Call call = new Call())
                call.Check(Native.LibShd.TextureUnpinTiles(call.Use(this, "texture"), &region));
        }

        /// <summary>Drops the tiles of a region and the coarser tiles that cover it: their source has changed.</summary>
        public void DropTiles(TileRegion region)
        {
            using (Call call = new Call())
                call.Check(Native.LibShd.TextureDropTiles(call.Use(this, "texture"), &region));
        }

        /// <summary>Replaces texels, and rebuilds the tables. No other call may use the texture meanwhile.</summary>
        public void Update(int layer, int x, int y, Image texels)
        {
            if (texels == null) throw new ArgumentNullException("texels");
            using (Call call = new Call())
            {
                Native.Image image = texels.Build(call, "texels");
                call.Check(Native.LibShd.TextureUpdate(call.UseAlone(this, "texture"), checked((uint)layer),
                                                       checked((uint)x), checked((uint)y), &image));
            }
        }
    }

    /// <summary>Coordinates of lookups in spans, of one length. U and V are required.</summary>
    public ref struct LookupSpans
    {
        public ReadOnlySpan<float> U, V, Dudx, Dvdx, Dudy, Dvdy, Lod;

        private static void Check(ReadOnlySpan<float> span, int count, string name)
        {
            if (!span.IsEmpty && span.Length != count)
                throw new ArgumentException(name + ": " + span.Length + " elements, not " + count, name);
        }

        internal int CheckCount()
        {
            if (V.Length != U.Length)
                throw new ArgumentException("V: " + V.Length + " elements, not " + U.Length, "V");
            Check(Dudx, U.Length, "Dudx");
            Check(Dvdx, U.Length, "Dvdx");
            Check(Dudy, U.Length, "Dudy");
            Check(Dvdy, U.Length, "Dvdy");
            Check(Lod, U.Length, "Lod");
            return U.Length;
        }
    }

    /// <summary>Channels of filtered values in spans, of the length of the lookups.</summary>
    public ref struct TexelSpans
    {
        public Span<float> R, G, B, A;

        private static void Check(Span<float> span, int count, string name)
        {
            if (!span.IsEmpty && span.Length != count)
                throw new ArgumentException(name + ": " + span.Length + " elements, not " + count, name);
        }

        internal void CheckCount(int count)
        {
            Check(R, count, "R");
            Check(G, count, "G");
            Check(B, count, "B");
            Check(A, count, "A");
        }
    }
}
