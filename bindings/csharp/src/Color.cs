// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace Shd
{
    /// <summary>An OpenColorIO config, and the transforms built from it so far. Needs libshd_color.</summary>
    public sealed unsafe class Color : ShdObject
    {
        public Color(Context context, ColorDesc desc = null) : base(new ColorHandle())
        {
            using (Call call = new Call())
            {
                Native.ColorDesc built = (desc ?? new ColorDesc()).Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShdColor.ColorCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        /// <summary>Text of the built-in config.</summary>
        public static string DefaultConfig { get { return Utf8.Read(Native.LibShdColor.ColorDefaultConfig()); } }

        /// <summary>Converts the colour of a framebuffer to a display; null = the default display and view.</summary>
        public void ApplyDisplay(Framebuffer framebuffer, Image output, string display = null, string view = null)
        {
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.Image image = output.Build(call, "output");
                call.Check(Native.LibShdColor.ColorApplyDisplay(call.Use(this, "color"),
                                                                call.Use(framebuffer, "framebuffer"),
                                                                call.Text(display), call.Text(view), &image));
            }
        }

        /// <summary>Converts an image of a colour space to a display.</summary>
        public void ApplyDisplay(Image input, string fromSpace, Image output, string display = null, string view = null)
        {
            if (input == null) throw new ArgumentNullException("input");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.Image from = input.Build(call, "input"), to = output.Build(call, "output");
                call.Check(Native.LibShdColor.ColorApplyDisplayImage(call.Use(this, "color"), &from,
                                                                     call.Text(fromSpace), call.Text(display),
                                                                     call.Text(view), &to));
            }
        }

        /// <summary>Converts an image between colour spaces, in place.</summary>
        public void Convert(Image image, string fromSpace, string toSpace)
        {
            if (image == null) throw new ArgumentNullException("image");
            using (Call call = new Call())
            {
                Native.Image pixels = image.Build(call, "image");
                call.Check(Native.LibShdColor.ColorConvert(call.Use(this, "color"), &pixels, call.Text(fromSpace),
                                                           call.Text(toSpace)));
            }
        }

        public IList<string> Displays
        {
            get
            {
                using (Call call = new Call())
                {
                    IntPtr self = call.Use(this, "color");
                    string[] names = new string[(int)Native.LibShdColor.ColorGetDisplayCount(self)];
                    for (int i = 0; i < names.Length; ++i)
                        names[i] = Utf8.Read(Native.LibShdColor.ColorGetDisplayName(self, (UIntPtr)(uint)i));
                    return names;
                }
            }
        }

        public IList<string> Views(string display)
        {
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "color");
                byte* text = call.Text(display);
                string[] names = new string[(int)Native.LibShdColor.ColorGetViewCount(self, text)];
                for (int i = 0; i < names.Length; ++i)
                    names[i] = Utf8.Read(Native.LibShdColor.ColorGetViewName(self, text, (UIntPtr)(uint)i));
                return names;
            }
        }

        public IList<string> Spaces
        {
            get
            {
                using (Call call = new Call())
                {
                    IntPtr self = call.Use(this, "color");
                    string[] names = new string[(int)Native.LibShdColor.ColorGetSpaceCount(self)];
                    for (int i = 0; i < names.Length; ++i)
                        names[i] = Utf8.Read(Native.LibShdColor.ColorGetSpaceName(self, (UIntPtr)(uint)i));
                    return names;
                }
            }
        }

        public string WorkingSpace
        {
            get
            {
                using (Call call = new Call())
                    return Utf8.Read(Native.LibShdColor.ColorGetWorkingSpace(call.Use(this, "color")));
            }
        }
    }

    /// <summary>A display and view of a config, for SaveDesc; null = the default ones.</summary>
    public sealed unsafe class ColorView
    {
        public Color Color;
        public string Display, View;

        internal DisplayCall Build(Call call, string name)
        {
            return new DisplayCall(call.Use(Color, Call.Join(name, "Color")), call.Text(Display), call.Text(View));
        }
    }

    /// <summary>A colour view with the handle and texts of a call.</summary>
    internal sealed unsafe class DisplayCall
    {
        private readonly IntPtr color;
        private readonly byte* display;
        private readonly byte* view;

        internal DisplayCall(IntPtr color, byte* display, byte* view)
        {
            this.color = color;
            this.display = display;
            this.view = view;
        }

        internal Result Apply(IntPtr framebuffer, Native.Image* output)
        {
            return Native.LibShdColor.ColorApplyDisplay(color, framebuffer, display, view, output);
        }
    }
}
