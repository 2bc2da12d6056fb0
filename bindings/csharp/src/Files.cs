// SPDX-License-Identifier: MIT
using System;

namespace Shd
{
    /// <summary>The pixels of a file, without conversion. Needs libshd_io.</summary>
    public sealed unsafe class Bitmap : ShdObject
    {
        public Bitmap(Context context, string path, LoadDesc desc = null) : base(new BitmapHandle())
        {
            if (path == null) throw new ArgumentNullException("path");
            using (Call call = new Call())
            {
                Native.LoadDesc built = (desc ?? new LoadDesc()).Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShdIo.BitmapLoad(call.Use(context, "context"), call.Text(path), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        /// <summary>A file in memory.</summary>
        public Bitmap(Context context, byte[] file, LoadDesc desc = null) : base(new BitmapHandle())
        {
            if (file == null) throw new ArgumentNullException("file");
            using (Call call = new Call())
            {
                Native.LoadDesc built = (desc ?? new LoadDesc()).Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShdIo.BitmapLoadMemory(call.Use(context, "context"), call.Pin(file),
                                                            (UIntPtr)(uint)file.Length, &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        public BitmapInfo Info
        {
            get
            {
                using (Call call = new Call())
                {
                    BitmapInfo info = BitmapInfo.Default;
                    call.Check(Native.LibShdIo.BitmapGetInfo(call.Use(this, "bitmap"), &info));
                    return info;
                }
            }
        }

        public string ColorSpace
        {
            get
            {
                using (Call call = new Call())
                    return Utf8.Read(Native.LibShdIo.BitmapGetColorSpace(call.Use(this, "bitmap")));
            }
        }

        /// <summary>A copy of the pixels, as bytes.</summary>
        public Image Read()
        {
            using (Call call = new Call())
            {
                Native.Image view = Native.Image.Default;
                call.Check(Native.LibShdIo.BitmapGetImage(call.Use(this, "bitmap"), &view));
                long row = (long)Native.LibShd.FormatSize(view.Format) * view.Width;
                byte[] pixels = new byte[row * view.Height];
                byte* to = (byte*)call.Pin(pixels);
                for (long y = 0; y < view.Height; ++y)
                    Buffer.MemoryCopy((byte*)view.Pixels + y * (view.RowStride != 0 ? view.RowStride : row),
                                      to + y * row,
                                      row, row);
                return new Image(view.Format, (int)view.Width, (int)view.Height, pixels);
            }
        }
    }

    /// <summary>Textures and pictures in files. Needs libshd_io.</summary>
    public static unsafe class Files
    {
        private static Texture Adopt(Call call, IntPtr made)
        {
            Texture texture = new Texture();
            texture.Handle.Adopt(made, call.Roots);
            return texture;
        }

        /// <summary>
        /// A texture of any file: an image, KTX2, DDS, OpenVDB, and with `desc` voxels or a stack of slices, which has no
        /// path. desc.Info and desc.VdbInfo, if they have a value, get the contents of the file.
        /// </summary>
        public static Texture LoadTexture(Context context, string path, LoadDesc desc = null)
        {
            if (path == null && (desc == null || desc.Stack == null)) throw new ArgumentNullException("path");
            using (Call call = new Call())
            {
                Native.LoadDesc built = (desc ?? new LoadDesc()).Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShdIo.TextureLoad(call.Use(context, "context"), call.Text(path), &built, &made));
                Take(desc, ref built);
                return Adopt(call, made);
            }
        }

        /// <summary>A texture of a file in memory.</summary>
        public static Texture LoadTexture(Context context, byte[] file, LoadDesc desc = null)
        {
            if (file == null) throw new ArgumentNullException("file");
            using (Call call = new Call())
            {
                Native.LoadDesc built = (desc ?? new LoadDesc()).Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShdIo.TextureLoadMemory(call.Use(context, "context"), call.Pin(file),
                                                             (UIntPtr)(uint)file.Length, &built, &made));
                Take(desc, ref built);
                return Adopt(call, made);
            }
        }

        private static void Take(LoadDesc desc, ref Native.LoadDesc built)
        {
            if (built.Info != null) desc.Info = *built.Info;
            if (built.VdbInfo != null) desc.VdbInfo = *built.VdbInfo;
        }

        /// <summary>
        /// A texture whose tiles stay in a tiled TIFF or OpenEXR file, or a UDIM set, until lookups need them. `desc` has
        /// the cache. The files are trusted: this process decodes them.
        /// </summary>
        public static Texture OpenTexture(Context context, string path, TileFileDesc desc, out TileFileInfo info)
        {
            if (path == null) throw new ArgumentNullException("path");
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.TileFileDesc built = desc.Build(call, "desc");
                TileFileInfo found = TileFileInfo.Default;
                IntPtr made;
                call.Check(Native.LibShdIo.TextureOpen(call.Use(context, "context"), call.Text(path), &built, &made,
                                                       &found));
                info = found;
                return Adopt(call, made);
            }
        }

        public static void Save(Framebuffer framebuffer, string path, SaveDesc desc = null)
        {
            if (path == null) throw new ArgumentNullException("path");
            using (Call call = new Call())
            {
                Native.SaveDesc built = (desc ?? new SaveDesc()).Build(call, "desc");
                call.Check(Native.LibShdIo.FramebufferSave(call.Use(framebuffer, "framebuffer"), call.Text(path),
                                                           &built));
            }
        }

        /// <summary>Writes all levels of a texture to a KTX2 file.</summary>
        public static void SaveKtx2(Texture texture, string path, Ktx2Desc? desc = null)
        {
            if (path == null) throw new ArgumentNullException("path");
            using (Call call = new Call())
            {
                Ktx2Desc built = desc ?? Ktx2Desc.Default;
                call.Check(Native.LibShdIo.TextureSaveKtx2(call.Use(texture, "texture"), call.Text(path), &built));
            }
        }

        public static void Save(Image image, string path, SaveDesc desc = null)
        {
            if (image == null) throw new ArgumentNullException("image");
            if (path == null) throw new ArgumentNullException("path");
            using (Call call = new Call())
            {
                Native.Image pixels = image.Build(call, "image");
                Native.SaveDesc built = (desc ?? new SaveDesc()).Build(call, "desc");
                call.Check(Native.LibShdIo.ImageSave(&pixels, call.Text(path), &built));
            }
        }
    }
}
