// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace Shd
{
    /// <summary>A set of planes with the same width and height.</summary>
    public sealed unsafe class Framebuffer : ShdObject
    {
        /// <summary>A framebuffer of a desc that began as FramebufferDesc.Default.</summary>
        public Framebuffer(Context context, FramebufferDesc desc) : base(new FramebufferHandle())
        {
            using (Call call = new Call())
            {
                IntPtr made;
                call.Check(Native.LibShd.FramebufferCreate(call.Use(context, "context"), &desc, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        public Framebuffer(Context context, int width, int height, int sampleCount = 1)
            : this(context, Desc(width, height, sampleCount)) { }

        private static FramebufferDesc Desc(int width, int height, int sampleCount)
        {
            FramebufferDesc desc = FramebufferDesc.Default;
            desc.Width = checked((uint)width);
            desc.Height = checked((uint)height);
            desc.SampleCount = sampleCount;
            return desc;
        }

        public FramebufferInfo Info
        {
            get
            {
                using (Call call = new Call())
                {
                    FramebufferInfo info = FramebufferInfo.Default;
                    call.Check(Native.LibShd.FramebufferGetInfo(call.Use(this, "framebuffer"), &info));
                    return info;
                }
            }
        }

        /// <summary>Converts the colour into the pixels of an image.</summary>
        public void ReadColor(Image output)
        {
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.Image image = output.Build(call, "output");
                call.Check(Native.LibShd.FramebufferReadColor(call.Use(this, "framebuffer"), &image));
            }
        }

        /// <summary>Colour as bytes [height][width][channels], in a format of 8 bits.</summary>
        public byte[] ReadColor(Format format = Format.Rgba8Srgb)
        {
            FramebufferInfo info = Info;
            byte[] pixels = new byte[(long)Native.LibShd.FormatSize(format) * info.Width * info.Height];
            ReadColor(new Image(format, (int)info.Width, (int)info.Height, pixels));
            return pixels;
        }

        /// <summary>A copy of a plane of floats, [height][width].</summary>
        public float[,] ReadPlane(Plane plane)
        {
            FramebufferInfo info = Info;
            float[,] values = new float[info.Height, info.Width];
            using (Call call = new Call())
            {
                Native.F32Out column = new Native.F32Out();
                column.Data = (float*)call.Pin(values);
                call.Check(Native.LibShd.FramebufferReadPlane(call.Use(this, "framebuffer"), plane, &column));
            }
            return values;
        }

        /// <summary>A copy of a plane of numbers, such as Plane.Draw, [height][width].</summary>
        public uint[,] ReadIntegerPlane(Plane plane)
        {
            FramebufferInfo info = Info;
            uint[,] values = new uint[info.Height, info.Width];
            using (Call call = new Call())
            {
                Native.U32Out column = new Native.U32Out();
                column.Data = (uint*)call.Pin(values);
                call.Check(Native.LibShd.FramebufferReadU32Plane(call.Use(this, "framebuffer"), plane, &column));
            }
            return values;
        }

        /// <summary>The memory of a plane of floats, without a copy. The next frame changes it.</summary>
        public PlaneView ViewPlane(Plane plane) { return new PlaneView(this, plane); }
    }

    /// <summary>Rows of a plane in the memory of a framebuffer, which lives until Dispose.</summary>
    public sealed unsafe class PlaneView : IDisposable
    {
        private readonly Call call = new Call();
        private readonly Native.PlaneView view;
        private int isDisposed;

        public readonly int Width, Height;

        internal PlaneView(Framebuffer framebuffer, Plane plane)
        {
            try
            {
                FramebufferInfo info = framebuffer.Info;
                Width = (int)info.Width;
                Height = (int)info.Height;
                Native.PlaneView made = Native.PlaneView.Default;
                call.Check(Native.LibShd.FramebufferViewPlane(call.Use(framebuffer, "framebuffer"), plane, &made));
                if (made.F32 == null)
                    throw new ArgumentException("plane: " + plane + " has integers, not floats", "plane");
                view = made;
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Row `y` from the top. The span is valid until Dispose, and not after it.</summary>
        public ReadOnlySpan<float> Row(int y)
        {
            if (isDisposed != 0) throw new ObjectDisposedException("PlaneView");
            return new ReadOnlySpan<float>((byte*)view.F32 + Inline.Check(y, Height) * view.RowStride, Width);
        }

        ~PlaneView() { Close(); }

        public void Dispose()
        {
            Close();
            GC.SuppressFinalize(this);
        }

        private void Close()
        {
            if (Interlocked.Exchange(ref isDisposed, 1) == 0) call.Dispose();
        }
    }
}
