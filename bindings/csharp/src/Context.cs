// SPDX-License-Identifier: MIT
using System;

namespace Shd
{
    /// <summary>Memory, threads and SIMD target of the objects that are made from it.</summary>
    public sealed unsafe partial class Context : ShdObject
    {
        /// <summary>A context of a desc; null = all defaults.</summary>
        public Context(ContextDesc desc = null) : base(new ContextHandle())
        {
            Library.CheckVersion();
            using (Call call = new Call())
            {
                Native.ContextDesc built = (desc ?? new ContextDesc()).Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.ContextCreate(&built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        /// <summary>Name of the instruction set of the kernels.</summary>
        public string SimdTarget
        {
            get
            {
                using (Call call = new Call())
                    return Utf8.Read(Native.LibShd.ContextGetSimdTarget(call.Use(this, "context")));
            }
        }

        public int WorkerCount
        {
            get
            {
                using (Call call = new Call())
                    return (int)Native.LibShd.ContextGetWorkerCount(call.Use(this, "context"));
            }
        }

        /// <summary>Frees scratch memory that the context keeps for later calls.</summary>
        public void Trim()
        {
            using (Call call = new Call()) Native.LibShd.ContextTrim(call.Use(this, "context"));
        }

        /// <summary>
        /// Renders a frame, and returns its statistics. Throws the exception of a callback. A framebuffer serves one
        /// frame; concurrent ones throw InvalidOperationException.
        /// </summary>
        public RenderStats Render(RenderDesc frame)
        {
            if (frame == null) throw new ArgumentNullException("frame");
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "context");
                if (frame.Framebuffer != null) call.UseAlone(frame.Framebuffer, "frame.Framebuffer");
                Native.RenderDesc built = frame.Build(call, "frame");
                RenderStats stats = RenderStats.Default;
                built.Stats = &stats;
                call.Check(Native.LibShd.Render(self, &built));
                return stats;
            }
        }

        /// <summary>Shades the texels of an atlas, the framebuffer of the frame, in the uv of its draws.</summary>
        public BakeStats Bake(RenderDesc frame, BakeDesc desc = null)
        {
            if (frame == null) throw new ArgumentNullException("frame");
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "context");
                long texels = -1;
                if (frame.Framebuffer != null)
                {
                    call.UseAlone(frame.Framebuffer, "frame.Framebuffer");
                    FramebufferInfo info = frame.Framebuffer.Info;
                    texels = (long)info.Width * info.Height;
                }
                Native.RenderDesc built = frame.Build(call, "frame");
                Native.BakeDesc bake = (desc ?? new BakeDesc()).Build(call, "desc", texels);
                BakeStats stats = BakeStats.Default;
                bake.Stats = &stats;
                call.Check(Native.LibShd.Bake(self, &built, &bake));
                return stats;
            }
        }
    }
}
