// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>Arrays of pixels: their element types and lengths.</summary>
    internal static unsafe class Pixels
    {
        private static int ChannelSize(Format format)
        {
            string name = format.ToString();
            if (name.EndsWith("32f")) return 4;
            return name.EndsWith("16") || name.EndsWith("16f") ? 2 : 1;
        }

        /// <summary>Checks that an array can hold pixels of a format in rows and layers with these strides.</summary>
        internal static void Check(Array pixels, string name, Format format, long width, long height, long layers,
                                   long rowStride, long layerStride)
        {
            long pixel = (long)Native.LibShd.FormatSize(format), block = (long)Native.LibShd.FormatBlockSize(format);
            if (block > 0) // rows of compressed blocks of 4 x 4 texels
            {
                pixel = block;
                width = (width + 3) / 4;
                height = (height + 3) / 4;
            }
            if (pixel == 0) return; // the library names the unknown format
            Type element = pixels.GetType().GetElementType();
            int size = element.IsValueType ? Marshal.SizeOf(element) : 0;
            bool isFloat = element == typeof(float), is32Bit = ChannelSize(format) == 4;
            bool fits = element == typeof(byte) ||
                        (element.IsPrimitive ? size == ChannelSize(format) && isFloat == is32Bit : size == pixel);
            if (!fits)
                throw new ArgumentException(name + ": elements are " + element.Name + ", not channels of " + format,
                                            name);
            long row = rowStride != 0 ? rowStride : width * pixel,
                layer = layerStride != 0 ? layerStride : height * row;
            if (width <= 0 || height <= 0 || layers <= 0 || row < 0 || layer < 0) return; // refused by the library
            decimal needed = (decimal)(layers - 1) * layer + (decimal)(height - 1) * row + (decimal)width * pixel;
            decimal bytes = (decimal)pixels.LongLength * size;
            if (bytes < needed || (rowStride == 0 && layerStride == 0 && bytes != needed))
                throw new ArgumentException(name + ": " + bytes + " bytes, not " + needed, name);
        }
    }

    public sealed unsafe partial class Image
    {
        /// <summary>[height][width] pixels: an array of channels, of bytes, or of structs of one pixel.</summary>
        public Array Pixels;

        public Image() { }
        public Image(Format format, int width, int height, Array pixels)
        {
            Format = format;
            Width = (uint)width;
            Height = (uint)height;
            Pixels = pixels;
        }

        partial void More(Call call, string name, ref Native.Image made)
        {
            if (Pixels == null) return;
            Shd.Pixels.Check(Pixels, Call.Join(name, "Pixels"), Format, Width, Height, 1, RowStride, 0);
            made.Pixels = call.Pin(Pixels);
        }
    }

    public sealed unsafe partial class TextureDesc
    {
        /// <summary>
        /// Meaning of the coordinates. null = TextureKind.Texture3D if Depth is
        /// set, TextureKind.Directions if Projection is set, else TextureKind.Texture2D.
        /// </summary>
        public TextureKind? Kind;
        /// <summary>
        /// [layers, slices or faces][height][width] texels: an array of channels, of bytes, or of structs of one texel.
        /// Copied.
        /// </summary>
        public Array Texels;
        /// <summary>
        /// The caller's mip levels, [layers or faces][levels]; of a 3D texture all slices of level 1, then those of
        /// level 2, and so on. null = the library builds the levels.
        /// </summary>
        public IList<Image> LevelImages;
        /// <summary>The source of a texture that keeps no texels; null = the texture has its texels in memory.</summary>
        public TileSource Tiles;

        public TextureDesc() { }
        public TextureDesc(Format format, int width, int height, Array texels)
        {
            Format = format;
            Width = (uint)width;
            Height = (uint)height;
            Texels = texels;
        }

        partial void More(Call call, string name, ref Native.TextureDesc made)
        {
            if ((Flags & TextureFlags.Borrow) != 0)
                throw new ArgumentException(Call.Join(name, "Flags") + ": arrays are pinned for the call only, so a " +
                                            "texture cannot borrow their texels", "Flags");
            made.Kind = Kind ?? KindOfFields(name);
            long images = ImageCount(made.Kind);
            if (Texels != null)
            {
                Pixels.Check(Texels, Call.Join(name, "Texels"), Format, Width, Height, images, RowStride, LayerStride);
                made.Texels = call.Pin(Texels);
            }
            if (Tiles != null)
            {
                TileSource kept = new TileSource(Tiles.Cache, Tiles.Load) {
                    PixelSize = (int)Native.LibShd.FormatSize(Format) };
                made.Tiles.Cache = call.Use(kept.Cache, Call.Join(name, "Tiles.Cache"));
                if (kept.Load != null) made.Tiles.Load = Thunks.Load;
                made.Tiles.UserData = call.Callback(kept).UserData;
            }
            if (LevelImages == null) return;
            bool isVolume = made.Kind == TextureKind.Texture3D;
            if (!isVolume && (images < 1 || LevelImages.Count % images != 0))
                throw new ArgumentException(Call.Join(name, "LevelImages") + ": " + LevelImages.Count +
                                            " images are not levels of " + images + " layers", "LevelImages");
            made.LevelCount = isVolume ? LevelsOfSlices() : LevelImages.Count / images;
            made.LevelImages = Image.BuildAll(call, Call.Join(name, "LevelImages"), LevelImages);
        }

        /// <summary>The kind of a desc that has none.</summary>
        private TextureKind KindOfFields(string name)
        {
            if (Depth != 0 && Projection != Projection.None)
                throw new ArgumentException(Call.Join(name, "Kind") + ": it must be set, because both Depth and " +
                                            "Projection are", "Kind");
            if (Depth != 0) return TextureKind.Texture3D;
            return Projection != Projection.None ? TextureKind.Directions : TextureKind.Texture2D;
        }

        /// <summary>Number of images in Texels: layers, slices or faces.</summary>
        private long ImageCount(TextureKind kind)
        {
            if (kind == TextureKind.Texture3D) return Depth;
            if (kind == TextureKind.Directions && Projection == Projection.Cube) return 6;
            return LayerCount;
        }

        /// <summary>Levels of a 3D texture: level l has max(1, depth >> l) of the images.</summary>
        private uint LevelsOfSlices()
        {
            uint level = 0;
            for (long left = LevelImages.Count; left > 0; left -= Math.Max(1, Depth >> (int)Math.Min(31, level)))
                ++level;
            return level;
        }
    }
}
