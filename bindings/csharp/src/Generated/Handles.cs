// SPDX-License-Identifier: MIT
// Written by generate.py; do not edit.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>One reference to: An OpenColorIO config and the transforms built from it so far.</summary>
    internal sealed class ColorHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShdColor.ColorRelease(reference); }
    }

    /// <summary>One reference to: Owner of the allocator, executor and log that its objects use.</summary>
    internal sealed class ContextHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.ContextRelease(reference); }
    }

    /// <summary>One reference to: The triangles of draws, in a tree.</summary>
    internal sealed class EmbreeHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShdEmbree.EmbreeRelease(reference); }
    }

    /// <summary>One reference to: Light from all directions.</summary>
    internal sealed class EnvironmentHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.EnvironmentRelease(reference); }
    }

    /// <summary>One reference to: A set of planes with the same width and height.</summary>
    internal sealed class FramebufferHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.FramebufferRelease(reference); }
    }

    /// <summary>One reference to: The pixels of a file, without conversion.</summary>
    internal sealed class BitmapHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShdIo.BitmapRelease(reference); }
    }

    /// <summary>One reference to: A source of light in world space.</summary>
    internal sealed class LightHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.LightRelease(reference); }
    }

    /// <summary>One reference to: Reflectance of a surface.</summary>
    internal sealed class MaterialHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.MaterialRelease(reference); }
    }

    /// <summary>One reference to: Vertices and triangles, in object space.</summary>
    internal sealed class MeshHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.MeshRelease(reference); }
    }

    /// <summary>One reference to: A filter with its settings, for any texture.</summary>
    internal sealed class SamplerHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.SamplerRelease(reference); }
    }

    /// <summary>One reference to: A model file in memory.</summary>
    internal sealed class SceneHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShdScene.SceneRelease(reference); }
    }

    /// <summary>One reference to: Depths as seen from a light.</summary>
    internal sealed class ShadowHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.ShadowRelease(reference); }
    }

    /// <summary>One reference to: A two-dimensional texture, an array of them, a 3D texture or a texture of directions, with its tables.</summary>
    internal sealed class TextureHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.TextureRelease(reference); }
    }

    /// <summary>One reference to: Memory for the tiles of textures.</summary>
    internal sealed class TileCacheHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.TileCacheRelease(reference); }
    }

    /// <summary>One reference to: A density field with its transfer function.</summary>
    internal sealed class VolumeHandle : ObjectHandle
    {
        protected override void Drop(IntPtr reference) { Native.LibShd.VolumeRelease(reference); }
    }
}
