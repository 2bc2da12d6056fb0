// SPDX-License-Identifier: MIT
// Written by generate.py; do not edit.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>Source of the value of a baked texel.</summary>
    public enum TexelState
    {
        /// <summary>no triangle: the clear values of the frame</summary>
        Empty = 0,
        /// <summary>a triangle that covers the centre of the texel</summary>
        Centre = 1,
        Touched = 2,
        /// <summary>a copy of the nearest texel that a triangle shaded</summary>
        Dilated = 3,
    }

    /// <summary>
    /// Legal definitions of the size p of a footprint, whose level of detail is log2 p; combine with |. Below, x and y are
    /// the derivatives in base-level texels. Derivatives of 3D textures have a third component, x_w and y_w, which joins
    /// every sum and every maximum.
    /// </summary>
    [Flags]
    public enum LevelRules : uint
    {
        /// <summary>axes x and y: p = max(|x|, |y|). Vulkan's and OpenGL's definition</summary>
        Lengths = 1,
        /// <summary>the axes of the ellipse that x and y span, as Direct3D 11 defines</summary>
        Ellipse = 2,
        /// <summary>
        /// Vulkan's approximations, each of its own size: max(|x_u|, |x_v|) &lt;= |x| &lt;= sqrt(2) (|x_u| + |x_v|), and y
        /// likewise.
        /// </summary>
        Vulkan = 4,
        /// <summary>OpenGL's: with m_u = max(|x_u|, |y_u|) and m_v = max(|x_v|, |y_v|), max(m_u, m_v) &lt;= p &lt;= m_u + m_v.</summary>
        Opengl = 8,
        /// <summary>The profile of the sampler (Profile); not OIIO, which returns Result.ErrorUnsupported.</summary>
        Profile = 16,
    }

    /// <summary>Rules of a graphics API, for shd_bounds_preset().</summary>
    public enum Rules
    {
        /// <summary>The least precision that Vulkan 1.3 allows: 4 bits of coordinates and of levels; LENGTHS, ELLIPSE, VULKAN.</summary>
        Vulkan = 0,
        /// <summary>Direct3D 11.3: 8 bits of coordinates and of levels; LENGTHS, ELLIPSE.</summary>
        D3d11 = 1,
        /// <summary>WebGPU has no rules of its own and runs on other APIs: VULKAN's bits, and the rules of the other three.</summary>
        Webgpu = 2,
        /// <summary>OpenGL 4.6 has no least number of bits: VULKAN's bits; LENGTHS, OPENGL.</summary>
        Opengl = 3,
    }

    /// <summary>Precision of displays for 8-bit images. Images of other formats are always exact.</summary>
    public enum DisplayPrecision
    {
        /// <summary>
        /// A view is baked once into tables, which SIMD kernels apply. Codes differ from the exact ones by at most 1 in
        /// 99.9 % of the channels and by at most 3 in the others. The bake measures this on 65,536 colours, in gamut,
        /// saturated and negative, of 2^-14 to 2^6. A view outside this bound is applied exactly, and a line of the
        /// context's log (LogLevel.Warning) reports it once.
        /// </summary>
        Baked = 0,
        /// <summary>OpenColorIO's processor for each pixel</summary>
        Exact = 1,
    }

    /// <summary>Severity of a line of the log.</summary>
    public enum LogLevel
    {
        Debug = 0,
        Info = 1,
        Warning = 2,
        Error = 3,
    }

    /// <summary>
    /// Instruction set of the kernels. All give the same bits.
    ///
    /// The build (CMake option SHD_SIMD) and the machine decide which ones can be chosen.
    /// </summary>
    public enum Simd
    {
        /// <summary>the fastest one of this machine and build</summary>
        Best = 0,
        /// <summary>the lowest one of this build: runs wherever the library runs</summary>
        Baseline = 1,
        /// <summary>one lane or generic vectors; only in builds whose baseline it is</summary>
        Scalar = 2,
        /// <summary>the baseline of x86-64 with a Highway after 1.0.3</summary>
        Sse2 = 3,
        /// <summary>in builds with SHD_SIMD=all</summary>
        Ssse3 = 4,
        /// <summary>SSE4.2</summary>
        Sse4 = 5,
        Avx2 = 6,
        /// <summary>AVX-512 F, BW, CD, DQ and VL</summary>
        Avx512 = 7,
        Neon = 8,
        Wasm = 9,
    }

    /// <summary>Options of a context; combine with |.</summary>
    [Flags]
    public enum ContextFlags : uint
    {
        Default = 0,
        /// <summary>
        /// Working memory of a call is allocated and freed block by block. Without this flag the context keeps it for the
        /// next call, so that a loop of equal frames allocates nothing after each worker has drawn a part of a frame, with
        /// one worker after the first frame; see shd_context_trim().
        /// </summary>
        ReturnMemory = 1,
    }

    /// <summary>A sized struct, for shd_desc_init().</summary>
    public enum DescKind
    {
        None = 0,
        /// <summary>ContextDesc</summary>
        ContextDesc = 1,
        /// <summary>Image</summary>
        Image = 2,
        /// <summary>TextureDesc</summary>
        TextureDesc = 3,
        /// <summary>TextureInfo</summary>
        TextureInfo = 4,
        /// <summary>MipDesc</summary>
        MipDesc = 5,
        /// <summary>SamplerDesc</summary>
        SamplerDesc = 6,
        /// <summary>Lookups</summary>
        Lookups = 7,
        /// <summary>Texels</summary>
        Texels = 8,
        /// <summary>Levels</summary>
        Levels = 9,
        /// <summary>Explanation; sets tap_size and blend_size to the library's</summary>
        Explanation = 10,
        /// <summary>RayDifferentials</summary>
        RayDifferentials = 11,
        /// <summary>RayCones</summary>
        RayCones = 12,
        /// <summary>Derivatives</summary>
        Derivatives = 13,
        /// <summary>MeshDesc</summary>
        MeshDesc = 14,
        /// <summary>MeshInfo</summary>
        MeshInfo = 15,
        /// <summary>EdgesDesc</summary>
        EdgesDesc = 16,
        /// <summary>Edges</summary>
        Edges = 17,
        /// <summary>TessellationDesc</summary>
        TessellationDesc = 18,
        /// <summary>MaterialDesc</summary>
        MaterialDesc = 19,
        /// <summary>Slot; `target` becomes SlotTarget.Diffuse</summary>
        Slot = 20,
        /// <summary>LightDesc</summary>
        LightDesc = 21,
        /// <summary>ShadowDesc</summary>
        ShadowDesc = 22,
        /// <summary>ShadowRenderDesc</summary>
        ShadowRenderDesc = 23,
        /// <summary>ShadowLookups</summary>
        ShadowLookups = 24,
        /// <summary>FramebufferDesc</summary>
        FramebufferDesc = 25,
        /// <summary>FramebufferInfo</summary>
        FramebufferInfo = 26,
        /// <summary>PlaneView</summary>
        PlaneView = 27,
        /// <summary>Camera</summary>
        Camera = 28,
        /// <summary>Draw</summary>
        Draw = 29,
        /// <summary>RenderDesc</summary>
        RenderDesc = 30,
        /// <summary>RenderStats</summary>
        RenderStats = 31,
        /// <summary>ColorDesc, of shd/color.h</summary>
        ColorDesc = 32,
        /// <summary>LoadDesc, of shd/io.h</summary>
        LoadDesc = 33,
        /// <summary>SaveDesc, of shd/io.h</summary>
        SaveDesc = 34,
        /// <summary>BitmapInfo, of shd/io.h</summary>
        BitmapInfo = 35,
        /// <summary>ShapeDesc</summary>
        ShapeDesc = 36,
        /// <summary>ShapeColumns</summary>
        ShapeColumns = 37,
        /// <summary>SceneDesc, of shd/scene.h</summary>
        SceneDesc = 38,
        /// <summary>SceneInfo, of shd/scene.h</summary>
        SceneInfo = 39,
        /// <summary>SceneInstance, of shd/scene.h</summary>
        SceneInstance = 40,
        /// <summary>SolidDesc</summary>
        SolidDesc = 41,
        /// <summary>SolidPoints</summary>
        SolidPoints = 42,
        /// <summary>SolidValues</summary>
        SolidValues = 43,
        /// <summary>Directions</summary>
        Directions = 44,
        /// <summary>ProjectedPoints</summary>
        ProjectedPoints = 45,
        /// <summary>ImagePoints</summary>
        ImagePoints = 46,
        /// <summary>PointDirections</summary>
        PointDirections = 47,
        /// <summary>VolumeDesc</summary>
        VolumeDesc = 48,
        /// <summary>VolumeDraw</summary>
        VolumeDraw = 49,
        /// <summary>EnvironmentDesc</summary>
        EnvironmentDesc = 50,
        /// <summary>EnvironmentInfo</summary>
        EnvironmentInfo = 51,
        /// <summary>EnvironmentLookups</summary>
        EnvironmentLookups = 52,
        /// <summary>EnvironmentLight</summary>
        EnvironmentLight = 53,
        /// <summary>DirectionImages</summary>
        DirectionImages = 54,
        /// <summary>PolygonDesc</summary>
        PolygonDesc = 55,
        /// <summary>PolygonPoints</summary>
        PolygonPoints = 56,
        /// <summary>PolygonWeights</summary>
        PolygonWeights = 57,
        /// <summary>RawDesc, of shd/volume_file.h</summary>
        RawDesc = 58,
        /// <summary>StackDesc, of shd/volume_file.h</summary>
        StackDesc = 59,
        /// <summary>VdbDesc, of shd/volume_file.h</summary>
        VdbDesc = 60,
        /// <summary>VdbInfo, of shd/volume_file.h</summary>
        VdbInfo = 61,
        /// <summary>BakeDesc</summary>
        BakeDesc = 62,
        /// <summary>BakeStats</summary>
        BakeStats = 63,
        /// <summary>OcclusionDesc</summary>
        OcclusionDesc = 64,
        /// <summary>OcclusionPoints</summary>
        OcclusionPoints = 65,
        /// <summary>OcclusionAtlas</summary>
        OcclusionAtlas = 66,
        /// <summary>BoundsDesc</summary>
        BoundsDesc = 67,
        /// <summary>TextureFileInfo, of shd/texture_file.h</summary>
        TextureFileInfo = 68,
        /// <summary>Ktx2Desc, of shd/texture_file.h</summary>
        Ktx2Desc = 69,
        /// <summary>TileRegion</summary>
        TileRegion = 70,
        /// <summary>TileCacheDesc</summary>
        TileCacheDesc = 71,
        /// <summary>TileCacheStats</summary>
        TileCacheStats = 72,
        /// <summary>TileFileDesc, of shd/tile_file.h</summary>
        TileFileDesc = 73,
        /// <summary>TileFileInfo, of shd/tile_file.h</summary>
        TileFileInfo = 74,
    }

    /// <summary>
    /// Kinds of edges; combine with |.
    ///
    /// An edge of two triangles may be both SILHOUETTE and CREASE. Where both triangles run along it in the same direction,
    /// as on a Moebius strip, the second triangle counts as flipped.
    /// </summary>
    [Flags]
    public enum EdgeFlags : uint
    {
        None = 0,
        /// <summary>
        /// Between two triangles of which one faces the eye e and the other does not: f0(e) f1(e) &lt;= 0 with
        /// f(e) = (e - p) . n, p a corner of the triangle and n its normal.
        /// </summary>
        Silhouette = 1,
        /// <summary>between two triangles with unit normals n0 . n1 &lt;= crease_cosine, in object space</summary>
        Crease = 2,
        /// <summary>an edge of one triangle</summary>
        Border = 4,
        /// <summary>an edge of three triangles or more</summary>
        Nonmanifold = 8,
        /// <summary>all kinds</summary>
        All = 15,
    }

    /// <summary>Method that computes the irradiance.</summary>
    public enum Irradiance
    {
        /// <summary>
        /// Spherical harmonics of the orders 0 to 2 (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance
        /// Environment Maps", 2001), at least 0. The error is up to 0.1 of the irradiance of a single light that faces the
        /// surface, and about 0.01 for environments without a sun.
        /// </summary>
        Harmonics = 0,
        /// <summary>a map of 96 x 96 directions: error up to 0.018 of such a light</summary>
        Convolved = 1,
    }

    /// <summary>Tables of an environment in addition to the irradiance; combine with |.</summary>
    [Flags]
    public enum EnvironmentTables : uint
    {
        None = 0,
        /// <summary>the image itself, for backgrounds and mirrors; part of every other table</summary>
        Radiance = 1,
        /// <summary>lobes of METALLIC_ROUGHNESS</summary>
        Ggx = 2,
        /// <summary>lobes of PHONG, COMBINED, TOON and both models of Blinn</summary>
        Phong = 4,
        All = 7,
    }

    /// <summary>Optional planes; combine with |.</summary>
    [Flags]
    public enum AovFlags : uint
    {
        None = 0,
        /// <summary>Plane.U, _V</summary>
        Uv = 1,
        /// <summary>Plane.Nx, _NY, _NZ: shading normal, world space</summary>
        Normal = 2,
        /// <summary>Plane.Triangle</summary>
        Triangle = 4,
        /// <summary>Plane.Px, _PY, _PZ: world space</summary>
        Position = 8,
        /// <summary>Plane.Dudx, _DVDX, _DUDY, _DVDY: of uv, per pixel to the right and down</summary>
        Derivatives = 16,
        /// <summary>Plane.B0, _B1, _B2: perspective-correct weights of the triangle's corners</summary>
        Barycentrics = 32,
        /// <summary>Plane.Lod, _LEVEL: shd_texture_query_levels() of the diffuse texture</summary>
        Level = 64,
        /// <summary>Plane.Draw</summary>
        Draw = 128,
        /// <summary>Plane.Overdraw</summary>
        Overdraw = 256,
        /// <summary>Plane.Target1R, _G, _B, _A: a colour target besides R, G, B, A</summary>
        Target1 = 512,
        /// <summary>Plane.Target2R, _G, _B, _A</summary>
        Target2 = 1024,
        /// <summary>Plane.Target3R, _G, _B, _A</summary>
        Target3 = 2048,
    }

    /// <summary>
    /// One plane of a framebuffer: width * height elements, row by row from the top.
    ///
    /// Planes after Plane.Depth, except overdraw and targets, hold the values of the last opaque fragment visible at the
    /// first sample of a pixel. Blended draws and draws of depth alone do not change them.
    ///
    /// Targets are additional colours of the same samples. Programs write them as Radiance.target; other materials write
    /// 0 to all four channels. They start as 0. Each target is blended with the material's blend and its own a, except that
    /// WEIGHTED and SORTED leave targets unchanged. The alpha test uses the alpha of the main colour target.
    /// </summary>
    public enum Plane
    {
        /// <summary>R, G, B and A are in memory only with color_format Format.Rgba32f</summary>
        R = 0,
        G = 1,
        B = 2,
        A = 3,
        /// <summary>D32F, 0 near .. 1 far</summary>
        Depth = 4,
        U = 5,
        V = 6,
        Nx = 7,
        Ny = 8,
        Nz = 9,
        /// <summary>uint32_t: triangle index in its mesh, 0xffffffff where nothing was drawn</summary>
        Triangle = 10,
        Px = 11,
        Py = 12,
        Pz = 13,
        Dudx = 14,
        Dvdx = 15,
        Dudy = 16,
        Dvdy = 17,
        B0 = 18,
        B1 = 19,
        B2 = 20,
        /// <summary>continuous level of detail; 0 without texture</summary>
        Lod = 21,
        /// <summary>uint32_t: the mip level nearest to it</summary>
        Level = 22,
        /// <summary>uint32_t: index into RenderDesc.draws, 0xffffffff where nothing was drawn</summary>
        Draw = 23,
        /// <summary>uint32_t: number of times that the first sample was drawn, hidden later or not</summary>
        Overdraw = 24,
        Target1R = 25,
        Target1G = 26,
        Target1B = 27,
        Target1A = 28,
        Target2R = 29,
        Target2G = 30,
        Target2B = 31,
        Target2A = 32,
        Target3R = 33,
        Target3G = 34,
        Target3B = 35,
        Target3A = 36,
    }

    /// <summary>
    /// Storage of one pixel or texel.
    ///
    /// Unsigned integer channels hold value / maximum, in [0, 1]; F channels are IEEE 754 binary16 or binary32. All channels
    /// are linear, except r, g and b of the _SRGB formats, which are encoded (IEC 61966-2-1). Textures take every format;
    /// framebuffers, colour transforms and files list the formats that they take.
    ///
    /// BC formats are blocks of 4 x 4 texels, row by row from the top left (Khronos Data Format Specification 1.3, chapters
    /// 18 to 20). Only shd_texture_create() and shd_texture_read_level() take them. docs/compressed.md has their values.
    /// </summary>
    public enum Format
    {
        None = 0,
        R8 = 1,
        Rgba8 = 2,
        Rgba8Srgb = 3,
        Rgba16f = 4,
        Rgba32f = 5,
        Rgba16 = 6,
        Rg8 = 7,
        Rgb8 = 8,
        R8Srgb = 9,
        Rg8Srgb = 10,
        Rgb8Srgb = 11,
        R16 = 12,
        Rg16 = 13,
        Rgb16 = 14,
        R16f = 15,
        Rg16f = 16,
        Rgb16f = 17,
        R32f = 18,
        Rg32f = 19,
        Rgb32f = 20,
        /// <summary>blocks of 8 bytes; every texel is opaque</summary>
        Bc1Rgb = 21,
        Bc1RgbSrgb = 22,
        /// <summary>blocks of 8 bytes; texels may be transparent black</summary>
        Bc1Rgba = 23,
        Bc1RgbaSrgb = 24,
        /// <summary>blocks of 16 bytes, as all of the following except BC4</summary>
        Bc2 = 25,
        Bc2Srgb = 26,
        Bc3 = 27,
        Bc3Srgb = 28,
        /// <summary>one channel in 0..1, blocks of 8 bytes</summary>
        Bc4 = 29,
        /// <summary>one channel in -1..1, blocks of 8 bytes</summary>
        Bc4Snorm = 30,
        /// <summary>two channels in 0..1</summary>
        Bc5 = 31,
        /// <summary>two channels in -1..1</summary>
        Bc5Snorm = 32,
        /// <summary>three channels from 0 to 65504</summary>
        Bc6hUfloat = 33,
        /// <summary>three channels from -65504 to 65504</summary>
        Bc6hSfloat = 34,
        Bc7 = 35,
        Bc7Srgb = 36,
        /// <summary>
        /// one uint32_t: r, g, b as numbers of 9 bits from bit 0 on, e in bits 27 to 31. A channel
        /// is its number times 2^(e - 24): 0 to 65408
        /// </summary>
        Rgb9e5 = 37,
    }

    /// <summary>File formats that a load may accept; combine with |.</summary>
    [Flags]
    public enum FileFormatFlags : uint
    {
        None = 0,
        Png = 1,
        Jpeg = 2,
        Exr = 4,
        Tiff = 8,
        /// <summary>Radiance RGBE</summary>
        Hdr = 16,
        /// <summary>
        /// recognised by a plausible header, after all others: it has no signature; no
        /// palettes whose first index is not 0
        /// </summary>
        Tga = 32,
        /// <summary>uncompressed</summary>
        Bmp = 64,
        /// <summary>blocks and pixels (shd/texture_file.h)</summary>
        Dds = 128,
        Webp = 256,
        /// <summary>PBM, PGM, PPM and PFM</summary>
        Pnm = 512,
        Psd = 1024,
        Dpx = 2048,
        Gif = 4096,
        /// <summary>blocks and pixels (shd/texture_file.h)</summary>
        Ktx2 = 8192,
        /// <summary>grids of OpenVDB, textures alone (shd/volume_file.h)</summary>
        Vdb = 16384,
        /// <summary>PNG, JPEG, EXR, TIFF, HDR, TGA, BMP, DDS, WEBP, PNM, KTX2 and VDB; default of LoadDesc.formats.</summary>
        Default = 25599,
        /// <summary>Also every other format of the OpenImageIO build. For trusted files.</summary>
        Any = 1073741824,
    }

    /// <summary>Encoding of the numbers of a file.</summary>
    public enum ColorEncoding
    {
        /// <summary>load: as declared by the file, see shd_bitmap_color_space(); save: by format</summary>
        Auto = 0,
        /// <summary>r, g, b encoded with the sRGB curve (IEC 61966-2-1)</summary>
        Srgb = 1,
        /// <summary>light, Rec. 709 primaries</summary>
        Linear = 2,
        /// <summary>no colour: normals, roughness, masks</summary>
        Data = 3,
    }

    /// <summary>Options of a load; combine with |.</summary>
    [Flags]
    public enum LoadFlags : uint
    {
        Default = 0,
        /// <summary>
        /// Decode in this process, for files that are as trusted as this program. Needs no worker; saves its start, about 2
        /// ms a file and one copy of the pixels. A hostile file can end or take over this process, and time_limit is checked
        /// between bands of rows only.
        /// </summary>
        InProcess = 1,
        /// <summary>a damaged file loads: rows above the damage, zero below, and BitmapFlags.Partial is set</summary>
        Partial = 2,
        /// <summary>bottom row first</summary>
        FlipV = 4,
        /// <summary>
        /// Textures: take the mip levels of an image file, unchanged, instead of averages of its base. OpenEXR, and TIFF as
        /// written by maketx (`.tx`), can have levels; KTX2 and DDS give theirs without the flag. If they end before 1 x 1,
        /// the mipmap of the texture ends there, too. If the file has none, shd builds all of them. Level l must be max(1,
        /// size &gt;&gt; l) wide and high: OpenEXR files of rounding mode ROUND_UP whose sizes differ are Result.ErrorUnsupported,
        /// and so are levels of a file whose data window is not its display window. A damaged level is Result.ErrorCorrupt;
        /// with LoadFlags.Partial it and all smaller levels count as absent. Needs TableFlags.Mipmap in `tables`. Bitmaps have
        /// no levels.
        /// </summary>
        FileLevels = 8,
        /// <summary>
        /// Bitmaps: colour becomes linear light by its colour space, as an image that is a light needs it. RGBA8_SRGB, whose
        /// format has the curve, linear 8-bit, half and float pixels stay as they are; all others become RGBA32F, and
        /// shd_bitmap_color_space() is "Linear Rec.709". Primaries are not converted. An unknown colour space is
        /// Result.ErrorUnsupported. Textures are always linear.
        /// </summary>
        Linear = 16,
        /// <summary>
        /// Textures of images with alpha: invisible texels give no fringes. r, g and b of the mip levels are averages
        /// weighted by alpha (TexelContent.AlphaWeighted). Texels of alpha 0, in all levels, take the mean colour of
        /// their visible neighbours, or of the next coarser level if no neighbour is visible; so lookups between a visible
        /// and an invisible texel have the colour of the visible one. For straight alpha. No effect on other textures, on
        /// KTX2 and DDS, and with LoadFlags.FileLevels if the file has levels.
        /// </summary>
        AlphaWeighted = 32,
        /// <summary>
        /// Textures of images with alpha: r, g and b are multiplied by alpha, so that lookups and mip levels are averages
        /// weighted by alpha, without fringes (Porter and Duff, "Compositing Digital Images", 1984). The texture is
        /// TextureFlags.Premultiplied; 8-bit texels become RGBA16F. No effect on files that are premultiplied or opaque, and
        /// on KTX2 and DDS. Not with LoadFlags.AlphaWeighted.
        /// </summary>
        Premultiply = 64,
    }

    /// <summary>Properties of a loaded file; combine with |.</summary>
    [Flags]
    public enum BitmapFlags : uint
    {
        None = 0,
        /// <summary>damaged, rows are missing (LoadFlags.Partial)</summary>
        Partial = 1,
        /// <summary>r, g, b are multiplied by alpha (EXR, some TIFF); otherwise straight</summary>
        Premultiplied = 2,
    }

    /// <summary>Rounding of colour to the codes of an integer format.</summary>
    public enum Dither
    {
        /// <summary>to the nearest</summary>
        None = 0,
        /// <summary>
        /// Up or down by a fixed pattern of the pixel's position, so that areas keep their mean and gradients show no bands.
        /// Values that equal a code do not change. r, g and b of a pixel share a threshold; alpha is rounded to the nearest.
        /// </summary>
        Ordered = 1,
    }

    /// <summary>Kind of light.</summary>
    public enum LightKind
    {
        /// <summary>from a point in all directions</summary>
        Point = 0,
        /// <summary>parallel rays of equal E everywhere</summary>
        Directional = 1,
        /// <summary>I_a, from all directions; ambient lights add up</summary>
        Ambient = 2,
        /// <summary>from a point into a cone</summary>
        Spot = 3,
    }

    /// <summary>
    /// Reflectance model: the radiance L towards the eye.
    ///
    /// n: unit normal, l: unit vector to a light, v: unit vector to the eye, h = (v + l) / |v + l|, E: irradiance
    /// (shd/light.h). Sums are over all lights except ambient lights, whose sum is I_a. k_d, k_a, k_s, p and so on are
    /// constants of the material times their slots. "Specular" terms are 0 where n.l &lt;= 0 (except with
    /// MaterialFlags.SpecularUngated) and where v + l = 0; 0^0 = 1. Every model adds the emission, and multiplies I_a by the
    /// occlusion.
    ///
    /// BLINN_PHONG_NORMALIZED and METALLIC_ROUGHNESS divide the diffuse term by pi, the other models do not: with lights
    /// whose intensity is pi times as large, their diffuse surfaces are as bright as those of LAMBERT (shd/light.h).
    /// </summary>
    public enum Model
    {
        /// <summary>k_a I_a + sum of k_d E max(0, n.l)</summary>
        Lambert = 0,
        /// <summary>Lambert + sum of k_s E max(0, n.h)^p (Blinn 1977)</summary>
        BlinnPhong = 1,
        /// <summary>program.fragment</summary>
        Program = 2,
        /// <summary>k_d, independent of lights and frequency</summary>
        Unlit = 3,
        /// <summary>Lambert + sum of k_s E max(0, v.r)^p with r = 2 (n.l) n - l (Phong 1975)</summary>
        Phong = 4,
        /// <summary>
        /// k_a I_a + sum of (k_d / pi + k_s N max(0, n.h)^p) E max(0, n.l), N = (p + 2)(p + 4) / (8 pi (2^(-p/2) + p)):
        /// reflects at most the incident light where k_d + k_s &lt;= 1 (Giesen, "Phong and Blinn-Phong Normalization Factors",
        /// 2009)
        /// </summary>
        BlinnPhongNormalized = 5,
        /// <summary>
        /// k_d (I_a + sum of E max(0, n.l)) + sum of E k_s max(0, n.h)^p (Shirley and Marschner, "Fundamentals of Computer
        /// Graphics", 2009, 10.2)
        /// </summary>
        Combined = 6,
        /// <summary>
        /// k_w w + (1 - k_w) c with k_w the mean of (1 + n.l) / 2 over the lights, 1/2 without any: w = warm + warm_mix k_d,
        /// c = cool + cool_mix k_d (Gooch et al., "A Non-Photorealistic Lighting Model", 1998)
        /// </summary>
        Gooch = 7,
        /// <summary>
        /// Blinn-Phong with n.l rounded up to a multiple of 1 / toon_steps, and max(0, n.h)^p replaced by 0 below 1/2 and by
        /// 1 from 1/2 on
        /// </summary>
        Toon = 8,
        /// <summary>
        /// Metallic-roughness of glTF 2.0, appendix B: k_a I_a (b (1 - m) + F0) + sum of E max(0, n.l) (b (1 - m) (1 - f)
        /// (1 - (1 - v.h)^5) / pi + F D V), with base colour b = k_d, metallic m, alpha = max(roughness^2, 0.001),
        /// F = F0 + (1 - F0) (1 - v.h)^5, F0 = f (1 - m) + b m, f = ((ior - 1) / (ior + 1))^2, the distribution D of
        /// Trowbridge and Reitz (GGX) and V, the height-correlated masking and shadowing of Smith over 4 (n.l) (n.v), where
        /// n.v counts as at least 1e-4: interpolated normals may face away from the eye. Metals reflect at most the incident
        /// light. Dielectrics exceed it at grazing angles (1.2 at 75 degrees from n, 1.6 at 85), diffuse plus specular
        /// </summary>
        MetallicRoughness = 9,
        /// <summary>
        /// k_d times SlotTarget.Matcap at (1/2 + x/2, 1/2 - y/2) of the normal in view space; a normal
        /// without a direction reads the middle
        /// </summary>
        Matcap = 10,
        /// <summary>
        /// A clear solid: k_a I_a + sum of E max(0, n.l) F D V + k_d (1 - F) T, with F, D and V of METALLIC_ROUGHNESS for
        /// F0 = ((ior - 1) / (ior + 1))^2, and T the radiance of the frame's environment (RenderDesc.environment) along
        /// the refracted line of sight, 0 without one. The solid counts as a sphere with the normal of the fragment, which
        /// turns the line of sight twice. Other draws are not seen through it
        /// </summary>
        Glass = 11,
    }

    /// <summary>Debug views of values that the rasteriser computes. They replace the model's radiance L; the emission is added.</summary>
    public enum DebugView
    {
        /// <summary>the model</summary>
        None = 0,
        /// <summary>shading normal: (n + 1) / 2</summary>
        Normal = 1,
        /// <summary>texture coordinates: (u - floor(u), v - floor(v), 0)</summary>
        Uv = 2,
        /// <summary>
        /// level of detail of the diffuse texture: blue for level 0, over green, to red for
        /// the last level
        /// </summary>
        Level = 3,
        /// <summary>barycentric coordinates in the triangle</summary>
        Barycentrics = 4,
    }

    /// <summary>
    /// Encoding of a tangent-space normal in the values of SlotTarget.Normal.
    ///
    /// x points along u, z along the normal, and y up in the image, against v, as in glTF 2.0 (down with
    /// MaterialFlags.NormalYDown). Textures of 8 and 16 bits hold (c + 1) / 2 of a component c; float textures, vertices
    /// and procedures hold c itself.
    /// </summary>
    public enum NormalEncoding
    {
        /// <summary>(x, y, z)</summary>
        Xyz = 0,
        /// <summary>(x, y), z = sqrt(1 - x^2 - y^2)</summary>
        Xy = 1,
        /// <summary>
        /// XYZ with the length of the mean normal as the fourth channel, as shd_mip_build() makes it. The variance of
        /// normals within a pixel widens the specular lobe (Toksvig, "Mipmapping Normal Maps", 2005)
        /// </summary>
        Toksvig = 2,
        /// <summary>
        /// (x / z, y / z) and their squares, in floats, and their product in SlotTarget.NormalMixed, as shd_normal_moments()
        /// makes them. Lobes are averaged over normals with slopes of mean b and covariance S within the pixel (Olano and
        /// Baker, "LEAN Mapping", 2010), so grooves stretch highlights across them. With S = 0 the results are those of XYZ:
        /// - diffuse: the mean of max(0, n.l) over a Gaussian of slopes around the mean normal, divided by
        ///   sqrt(1 + trace S);
        /// - max(0, n.h)^p: Laplace's method, that is the lobe of the normal between b and h where its product with the
        ///   Gaussian is largest, times the Gaussian there, divided by sqrt(det(1 + p S G)), G being the metric of angles;
        /// - max(0, v.r)^p: the same with 4 p h.l in place of p;
        /// - METALLIC_ROUGHNESS: adaptive Gauss-Hermite quadrature (Naylor and Smith, "Applications of a Method for the
        ///   Efficient Computation of Posterior Distributions", 1982): the sum of the lobes of four normals along the longer
        ///   axis of S. Normals and weights suit the Gaussian of slopes times a Gaussian around h with the precision
        ///   2 (0.2 + r^2) / (1 + r^2) / alpha^2, r = s / (6 alpha^2) for the larger variance s of S.
        /// GOOCH and TOON use the mean normal only. Filter.Ewa with a lod_bias of -0.5 to -0.25 is closest to shading
        /// many samples a pixel: its default footprint is wider than a pixel
        /// </summary>
        Moments = 3,
    }

    /// <summary>Tilt of normals by SlotTarget.Height.</summary>
    public enum Bump
    {
        /// <summary>no tilt; heights are for parallax only</summary>
        None = 0,
        /// <summary>
        /// The normal of the surface moved along n by bump_scale h [world units]: n - bump_scale grad h. The gradient on the
        /// surface uses the exact derivative of the filtered height in u and v (Mikkelsen, "Bump Mapping Unparametrized
        /// Surfaces on the GPU", 2010). Filters without derivatives use differences over a texel.
        /// </summary>
        Gradient = 1,
        /// <summary>
        /// (-s (h(u + 1/w, v) - h(u, v)), -s (h(u, v + 1/h) - h(u, v)), 1) along t, v and n, with s = bump_scale:
        /// differences over one texel, independent of the size of the surface (after Blinn, "Simulation of Wrinkled
        /// Surfaces", 1978)
        /// </summary>
        Texel = 2,
    }

    /// <summary>
    /// Blending of a fragment of colour c and opacity a onto a sample of colour d and opacity A.
    ///
    /// Models give c = a L with the radiance L and a = opacity times its slot times the alpha of the diffuse slot. For
    /// STRAIGHT and OPAQUE they give c = L.
    /// </summary>
    public enum Blend
    {
        /// <summary>colour c; A becomes the a of a program, or 1 for a model</summary>
        Opaque = 0,
        /// <summary>c + (1 - a) d, a + (1 - a) A: "over" (Porter and Duff 1984)</summary>
        Premultiplied = 1,
        /// <summary>a c + (1 - a) d, a + (1 - a) A</summary>
        Straight = 2,
        /// <summary>c + d, A</summary>
        Add = 3,
        /// <summary>c d + (1 - a) d, A</summary>
        Multiply = 4,
        /// <summary>
        /// After all other draws, independent of order: with R the product of 1 - a, w = max(0.01, 3000 (1 - depth)^3) and
        /// C = sum of w c / sum of w a, the result is (1 - R) C + R d, 1 - R + R A. An approximation (McGuire and Bavoil,
        /// "Weighted Blended Order-Independent Transparency", 2013, equation 10). Depth is tested, not written.
        /// </summary>
        Weighted = 5,
        /// <summary>
        /// After all other draws, PREMULTIPLIED from far to near per sample; equal depths in the order of draws and
        /// triangles. Depth is tested, not written.
        /// </summary>
        Sorted = 6,
    }

    /// <summary>Options of a material; combine with |.</summary>
    [Flags]
    public enum MaterialFlags : uint
    {
        None = 0,
        /// <summary>Keep the specular term where n.l &lt;= 0, as in the textbook formula; by default it is 0 there.</summary>
        SpecularUngated = 1,
        /// <summary>Add the ambient term once for each light that is not ambient, instead of once in total.</summary>
        AmbientPerLight = 2,
        /// <summary>The program may set Radiance.discard.</summary>
        Discards = 4,
        /// <summary>Keep the first round(a * sample count) samples of a pixel and drop the others.</summary>
        AlphaToCoverage = 8,
        /// <summary>Flip normals on triangles seen from behind.</summary>
        DoubleSided = 16,
        /// <summary>Mapped normals have y down in the image, along v, as usual with Direct3D; default is up, as in glTF.</summary>
        NormalYDown = 32,
    }

    /// <summary>Weights of face normals in computed vertex normals. Degenerate faces contribute nothing.</summary>
    public enum NormalWeight
    {
        /// <summary>sum of face normals times face area (the cross products)</summary>
        Area = 0,
        /// <summary>plain average of unit face normals</summary>
        Uniform = 1,
        /// <summary>weighted by the corner angle (Thuermer and Wuethrich 1998)</summary>
        Angle = 2,
    }

    /// <summary>
    /// Assembly of triangles from indices. A triangle of coincident vertices counts as a triangle, but covers nothing.
    /// There is no topology of lines or points: Draw.fill draws the edges or the vertices of triangles.
    /// </summary>
    public enum Topology
    {
        /// <summary>three indices each: (0, 1, 2), (3, 4, 5), ...</summary>
        Triangles = 0,
        /// <summary>each further index adds a triangle: (0, 1, 2), (1, 3, 2), (2, 3, 4), ...</summary>
        Strip = 1,
        /// <summary>each further index adds a triangle around vertex 0: (0, 1, 2), (0, 2, 3), ...</summary>
        Fan = 2,
    }

    /// <summary>Options of a mesh; combine with |.</summary>
    [Flags]
    public enum MeshFlags : uint
    {
        None = 0,
        /// <summary>Accept NaN and infinite positions; rendering drops and counts the triangles that use them.</summary>
        KeepNonfinite = 1,
        /// <summary>
        /// Compute tangents when none are given; see @ref tangents. Vertices may be appended to the caller's vertices:
        /// MeshInfo.vertex_count is vertex_count + split_count.
        /// </summary>
        Tangents = 2,
        /// <summary>
        /// Find the triangles that share each edge, for shd_mesh_find_edges() and Fill.Lines. The mesh takes 12 more
        /// bytes per triangle. Its creation temporarily takes another 12 bytes per triangle and 12 per vertex, and linear
        /// time.
        /// </summary>
        Adjacency = 4,
    }

    /// <summary>
    /// Filter kernel along one axis, in texels of the new level.
    ///
    /// The weight of a source texel is the integral of the kernel over the texel, for any ratio of sizes. The weights of a
    /// level's texel sum to 1, so constant images stay constant.
    /// </summary>
    public enum MipKernel
    {
        /// <summary>the texel's own area (Williams 1983)</summary>
        Box = 0,
        /// <summary>1 - |x|, radius 1</summary>
        Triangle = 1,
        /// <summary>sinc under a Kaiser window of parameter 4, radius 3</summary>
        Kaiser = 2,
        /// <summary>sinc(x) sinc(x / 3), radius 3</summary>
        Lanczos = 3,
    }

    /// <summary>Source of each level.</summary>
    public enum MipSource
    {
        /// <summary>every level is made from the base and rounded once</summary>
        Base = 0,
        /// <summary>
        /// every level is made from the previous, stored level; faster for many levels,
        /// but rounding errors add up
        /// </summary>
        Previous = 1,
    }

    /// <summary>Content of the texels, which decides how they are averaged.</summary>
    public enum TexelContent
    {
        /// <summary>light: _SRGB formats are decoded before filtering</summary>
        Color = 0,
        /// <summary>numbers: _SRGB formats are filtered without decoding</summary>
        Data = 1,
        /// <summary>
        /// Unit vectors in three or four channels. Integer channels, of _SRGB formats too, hold (n + 1) / 2. Levels are
        /// renormalised; a zero mean becomes (0, 0, 1). The fourth channel of a level is the length of the mean, at most 1;
        /// materials compute a wider specular lobe from it (Toksvig, "Mipmapping Normal Maps", 2005). The caller sets the
        /// fourth channel of the base, 1 for unit vectors.
        /// </summary>
        Normal = 2,
        /// <summary>as data</summary>
        Height = 3,
        /// <summary>
        /// Colour whose alpha is tested, in four channels. Alpha of every level is scaled so that the share of texels that
        /// reach `alpha_cutoff` is the share of the base (Castano, "Computing Alpha Mipmaps", 2010). The share is exact to
        /// the nearest texel, except where texels of equal alpha lie at the cutoff.
        /// </summary>
        AlphaCoverage = 4,
        /// <summary>
        /// Colour with straight alpha, in four channels. r, g and b of a level are averages weighted by alpha, as averages
        /// of premultiplied colour: transparent texels do not shine through (Porter and Duff, "Compositing Digital Images",
        /// 1984). The weight of a texel is max(alpha, 0) + 2^-20, so that colours under alpha 0 alone are averaged, too.
        /// </summary>
        AlphaWeighted = 5,
    }

    /// <summary>Kind of generalised barycentric coordinates; the file's comment has the formulas.</summary>
    public enum Barycentric
    {
        /// <summary>rational functions on convex polygons</summary>
        Wachspress = 0,
        /// <summary>closed form on simple polygons</summary>
        MeanValue = 1,
        /// <summary>cotangent weights on convex polygons</summary>
        DiscreteHarmonic = 2,
        /// <summary>solution of the Laplace equation on simple polygons</summary>
        Harmonic = 3,
    }

    /// <summary>Maps from directions to points of images.</summary>
    public enum Projection
    {
        /// <summary>an image that shows no directions</summary>
        None = 0,
        /// <summary>longitude across, latitude down; any size, customary: width = 2 height</summary>
        LatLong = 1,
        /// <summary>photograph of a mirror ball; square</summary>
        MirrorBall = 2,
        /// <summary>the distance from the centre is the angle from +Z; square</summary>
        Angular = 3,
        /// <summary>six square faces: +X, -X, +Y, -Y, +Z, -Z</summary>
        Cube = 4,
        /// <summary>an octahedron unfolded into a square</summary>
        Octahedral = 5,
    }

    /// <summary>Arrangement of the faces of a cube map in images. n is the size of a face.</summary>
    public enum CubeLayout
    {
        /// <summary>six images of n x n: +X, -X, +Y, -Y, +Z, -Z</summary>
        Faces = 0,
        /// <summary>one image of 6n x n: the faces from left to right</summary>
        Row = 1,
        /// <summary>one image of n x 6n: the faces from top to bottom</summary>
        Column = 2,
        /// <summary>4n x 3n: +Y above +Z; -X, +Z, +X, -Z; -Y below +Z</summary>
        HorizontalCross = 3,
        /// <summary>3n x 4n: +Y; -X, +Z, +X; -Y; -Z turned by half a turn</summary>
        VerticalCross = 4,
    }

    /// <summary>Points at which the reflectance model is evaluated. Textures are looked up per fragment at every frequency.</summary>
    public enum Frequency
    {
        /// <summary>per fragment, with interpolated and renormalised normals (Phong 1975)</summary>
        Phong = 0,
        /// <summary>per vertex, colours interpolated (Gouraud 1971)</summary>
        Gouraud = 1,
        /// <summary>once per triangle, with the face normal at the centroid</summary>
        Flat = 2,
    }

    /// <summary>Triangles that are skipped; front = counter-clockwise on the screen, seen with y up.</summary>
    public enum Cull
    {
        None = 0,
        Back = 1,
        Front = 2,
    }

    /// <summary>Options of a draw; combine with |.</summary>
    [Flags]
    public enum DrawFlags : uint
    {
        None = 0,
        /// <summary>test depth without writing it</summary>
        KeepDepth = 1,
        /// <summary>shade every sample at its own position, instead of every pixel once</summary>
        SampleShading = 2,
    }

    /// <summary>Parts of a triangle that are drawn.</summary>
    public enum Fill
    {
        Solid = 0,
        /// <summary>its three edges</summary>
        Wireframe = 1,
        /// <summary>its three vertices</summary>
        Points = 2,
        /// <summary>its edges of the kinds in Draw.edges; for meshes with MeshFlags.Adjacency</summary>
        Lines = 3,
    }

    /// <summary>Options of a frame; combine with |.</summary>
    [Flags]
    public enum RenderFlags : uint
    {
        None = 0,
        /// <summary>fill RenderStats.hidden_samples: coverage is computed at least twice</summary>
        CountHidden = 1,
        /// <summary>
        /// keep the planes instead of clearing them: each sample starts with the values of its
        /// pixel
        /// </summary>
        Load = 2,
    }

    /// <summary>
    /// Method that decides which triangle is visible at a sample.
    ///
    /// PAINTER and NEWELL order the triangles of all draws and paint each over the previous ones. Depths are not compared,
    /// as with Compare.Always; the final depth is that of the triangle painted last. Depth decreases with the distance
    /// in draws that compare GREATER or GREATER_EQUAL and increases in all others; biases apply. DrawFlags works as
    /// usual. Opaque draws are shaded after all of them are painted. PREMULTIPLIED, STRAIGHT, ADD and MULTIPLY take effect
    /// in the order of painting. WEIGHTED and SORTED come last and test the painted depths. A draw without a material writes
    /// its depth and hides nothing.
    /// </summary>
    public enum Visibility
    {
        /// <summary>the depth of the sample, by the draw's comparison (Catmull 1974)</summary>
        Depth = 0,
        /// <summary>
        /// The painter's algorithm: triangles by their farthest vertex, far ones first, equal ones in the order of draws and
        /// triangles. The picture is wrong where two triangles overlap and the one painted first is nearer in the overlap;
        /// RenderStats.order_conflicts counts these pairs. O(n log n).
        /// </summary>
        Painter = 1,
        /// <summary>
        /// The painter's algorithm with the tests, reordering and cuts of Newell, Newell and Sancha, "A Solution to the
        /// Hidden Surface Problem" (1972). Correct, except where depths differ by less than the effect of a shift by 1/256
        /// pixel, or by less than 2^-23.
        ///
        /// Triangles that overlap cyclically or pass through each other are cut along the plane of one of them. New vertices
        /// lie on the grid of 1/256 pixel. A sample within 1/256 pixel of a cut, or of an edge that was cut, may lie on
        /// either side, and windows of a picture may differ there. Pieces keep the attributes and ids of their triangle.
        /// A triangle is not cut if a piece would have no area on the grid.
        ///
        /// For n triangles there are at most n + 1024 cuts and 1024 n + 2^22 comparisons; order_conflicts counts the
        /// remaining errors. Runs on one thread and takes up to 1000 bytes a triangle.
        /// </summary>
        Newell = 2,
    }

    /// <summary>Colour of the samples that no draw covers.</summary>
    public enum Background
    {
        /// <summary>clear_color</summary>
        Clear = 0,
        /// <summary>
        /// Radiance of the environment along the line of sight through the centre of the pixel, averaged over the pixel;
        /// a = 1. No effect with RenderFlags.Load.
        /// </summary>
        Environment = 1,
    }

    /// <summary>Result of every call that can fail. A call that fails changes nothing.</summary>
    public enum Result
    {
        /// <summary>done</summary>
        Ok = 0,
        /// <summary>the text names desc, field, value and range</summary>
        ErrorInvalidArgument = 1,
        /// <summary>an allocation failed; nothing leaked, every object is as before</summary>
        ErrorOutOfMemory = 2,
        /// <summary>well formed, but this build or version does not offer it</summary>
        ErrorUnsupported = 3,
        /// <summary>a file, colour space, display, view or plane does not exist</summary>
        ErrorNotFound = 4,
        /// <summary>reading or writing a file failed</summary>
        ErrorIo = 5,
        /// <summary>a file is damaged, or its content does not have the claimed format</summary>
        ErrorCorrupt = 6,
        /// <summary>a budget that the caller set (pixels, bytes, time) would be exceeded</summary>
        ErrorLimit = 7,
        /// <summary>the host's progress callback requested cancellation</summary>
        ErrorCancelled = 8,
        /// <summary>a host callback reported failure</summary>
        ErrorCallback = 9,
        /// <summary>a bug in shd or a library below it; please report the text</summary>
        ErrorInternal = 10,
    }

    /// <summary>
    /// Reconstruction and minification filter.
    ///
    /// Filters that use mip levels read only level 0 of a texture without a mipmap. Ripmap and summed-area lookups are
    /// refused if the texture does not have the table.
    /// </summary>
    public enum Filter
    {
        /// <summary>Bilinear on the two nearest mip levels, blended by the fraction of the level of detail (Williams 1983).</summary>
        Trilinear = 0,
        /// <summary>the texel of level 0 that contains (u, v)</summary>
        Nearest = 1,
        /// <summary>the four texels of level 0 around (u, v)</summary>
        Bilinear = 2,
        /// <summary>The 4 x 4 texels of level 0 around (u, v), weighted by the cubic `cubic` (Mitchell and Netravali 1988).</summary>
        Bicubic = 3,
        /// <summary>the texel of the nearest mip level that contains (u, v)</summary>
        NearestMip = 4,
        /// <summary>bilinear on the nearest mip level</summary>
        BilinearMip = 5,
        /// <summary>Bilinear on the four nearest ripmap levels, which halve each axis on its own. Needs TableFlags.Ripmap.</summary>
        Ripmap = 6,
        /// <summary>
        /// The average of the texels over `box`, where each texel is a square of constant value, from sums over rectangles
        /// (Crow 1984). Needs TableFlags.SummedArea. Sides of a box are at least 1 texel, which makes magnification
        /// bilinear, and at most 2^22. Bias and clamps of the level of detail apply to log2 of a side; `lod` is a square of
        /// 2^lod texels. If a box touches a texel that is not finite, the result is NaN in its channel.
        /// </summary>
        SummedArea = 7,
        /// <summary>Trilinear probes of the footprint's shorter axis, along the longer one (McCormack et al. 1999).</summary>
        Anisotropic = 8,
        /// <summary>
        /// The texels inside the footprint's ellipse, weighted by exp(-2 r^2) - exp(-2) with r from 0 at its centre to 1 on
        /// its edge (Greene and Heckbert 1986), on the mip level on which the footprint's shorter half axis b is 1..2
        /// texels, b &gt;= a / max_anisotropy; on the finest level, b = max(b, 1). Half axes: sqrt(0.84^2 a^2 + c) and
        /// sqrt(0.84^2 b^2 + c) in texels of level l, c = 1 - 0.6127 (1 - 4^-l): Heckbert's reconstruction filter without
        /// the averaging of level l. Bilinear where a is at most one texel of level 0; blended from bilinear to EWA where a
        /// is one to two texels. `lod` is a circle. Reads at most 16 (max_anisotropy + 1) texels, 4 times as many in 3D.
        /// </summary>
        Ewa = 9,
        /// <summary>An unbiased estimate of the filter that `stochastic_filter` names, from what Stochastic picks at random.</summary>
        Stochastic = 10,
        /// <summary>
        /// The average of the bilinear reconstruction over the footprint's parallelogram, computed in double: the ground
        /// truth. It uses the finest level on which the parallelogram covers at most 16 / tolerance^2 cells (2^10..2^24). If
        /// it covers more cells even on the coarsest level, it is shortened to this number. `lod` is a square of 2^lod
        /// texels, in 3D a box. docs/filter-exact.md has its definition on images of directions. Slow.
        /// </summary>
        Exact = 11,
        /// <summary>
        /// The texels that contain (u, v) of the two nearest mip levels, blended by the fraction of the level of detail:
        /// VK_FILTER_NEAREST with VK_SAMPLER_MIPMAP_MODE_LINEAR, GL_NEAREST_MIPMAP_LINEAR, D3D's MIN_MAG_POINT_MIP_LINEAR.
        /// </summary>
        NearestMipLinear = 12,
    }

    /// <summary>
    /// Filter for magnification: where the level of detail of NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP and TRILINEAR is
    /// 0 or below, and where the footprint of all other filters is at most one texel long.
    /// </summary>
    public enum Magnification
    {
        /// <summary>
        /// the default of the filter: nearest for NEAREST, NEAREST_MIP and
        /// NEAREST_MIP_LINEAR, bicubic for BICUBIC, bilinear for all others
        /// </summary>
        Default = 0,
        /// <summary>Filter.Nearest</summary>
        Nearest = 1,
        /// <summary>Filter.Bilinear</summary>
        Bilinear = 2,
        /// <summary>Filter.Bicubic</summary>
        Bicubic = 3,
    }

    /// <summary>Cubic kernels by their (B, C) of Mitchell and Netravali, "Reconstruction Filters in Computer Graphics" (1988).</summary>
    public enum Cubic
    {
        /// <summary>(0, 1/2): interpolates, overshoots</summary>
        CatmullRom = 0,
        /// <summary>(1, 0): smooths, never overshoots</summary>
        BSpline = 1,
        /// <summary>(1/3, 1/3): in between</summary>
        Mitchell = 2,
    }

    /// <summary>Weights of the probes of Filter.Anisotropic along the longer axis.</summary>
    public enum ProbeWeights
    {
        /// <summary>a box</summary>
        Equal = 0,
        /// <summary>exp(-2 x^2), x = -1..1 from end to end of the probes</summary>
        Gaussian = 1,
    }

    /// <summary>Area that Filter.SummedArea averages.</summary>
    public enum Box
    {
        /// <summary>The bounding rectangle of the footprint's parallelogram: |dudx| + |dudy| by |dvdx| + |dvdy|.</summary>
        Bounding = 0,
        /// <summary>
        /// The average over the bounding rectangles of N equal parts of the parallelogram along its longer side a. If b is
        /// the other side in texels, N = ceil(|a| / max(|b|, 1)), at most max_anisotropy.
        /// </summary>
        Oriented = 1,
    }

    /// <summary>
    /// Definition of the level of detail, the levels and the probes of NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP,
    /// TRILINEAR and ANISOTROPIC.
    ///
    /// LEAST_ERROR differs from EXACT in RIPMAP as well, and in STOCHASTIC of these filters. All other filters are the same
    /// in all profiles, because EWA, SUMMED_AREA and EXACT have the least error as they are.
    ///
    /// Mean PSNR [dB] of five scenes under a box of one pixel and a tent of two: four photographs, then checker, noise and
    /// zone plate. docs/filters.md has more rules and figures, measured by `SHD_BENCH_PHOTOGRAPHS=folder shd-bench
    /// --benchmark_filter=^default/` (bench/README.md).
    ///
    /// | filter | LEAST_ERROR | EXACT | OpenImageIO |
    /// |---|---|---|---|
    /// | BILINEAR_MIP | 41.0 41.2, 34.2 33.5 | 37.0 39.0, 31.9 33.1 | 34.5 36.3, 29.4 31.5 |
    /// | TRILINEAR | 42.7 43.0, 36.3 35.1 | 37.5 40.1, 33.3 34.5 | 39.5 41.5, 34.1 34.7 |
    /// | ANISOTROPIC (16) | 49.5 46.2, 43.4 37.6 | 46.1 46.6, 42.8 38.9 | 43.8 47.5, 38.1 39.0 |
    /// | RIPMAP | 44.4 44.9, 37.7 36.2 | 40.5 43.8, 36.9 37.1 | |
    ///
    /// Below, x and y are the columns of the matrix J of derivatives in base-level texels, a = max_anisotropy, and lambda is
    /// the level of detail before bias and clamps.
    /// </summary>
    public enum Profile
    {
        /// <summary>
        /// The levels of least measured error, a little finer than the footprint. Let s1 &gt;= s2 be the singular values of J,
        /// and rms(x, y) = sqrt((x^2 + y^2) / 2). lambda = log2(rms(s1, s2)) - 3/8. ANISOTROPIC: r = min(s1 / s2, a), lambda
        /// = log2(rms(s1 / r, s2)) - 1/8 - 1 / (4 r), and ceil(r - 1/8) probes along the longer axis. RIPMAP: log2 of the
        /// extent along each axis, less 3/8. The column `lod` of lookups is used as it is.
        /// </summary>
        LeastError = 0,
        /// <summary>
        /// Vulkan 1.3 specification, "Image Operations": lambda = log2(max(|x|, |y|)). ANISOTROPIC: eta = min(longer /
        /// shorter, a) for the longer and the shorter one of x and y, lambda = log2(longer / eta), and ceil(eta) probes of
        /// equal weight at i / (ceil(eta) + 1) - 1/2 of the longer one. Fractions of levels and weights of bilinear lookups
        /// (BILINEAR's too) have 8 bits, as most desktop GPUs report in mipmapPrecisionBits and subTexelPrecisionBits.
        /// Weights of textures with a projection are not rounded.
        /// </summary>
        Vulkan = 1,
        /// <summary>
        /// Direct3D 11.3 functional specification, 7.18.10 and 7.18.11: lambda = log2(m), with m the major axis of J's
        /// ellipse, or the longer of x and y if they are parallel. ANISOTROPIC: r = min(m^2 / |det J|, a), lambda = log2(m /
        /// r), ceil(min(r, max(m, 1))) probes along m. The specification does not define the places and weights of probes;
        /// shd uses the places and weights of Profile.Vulkan. Fractions of levels and weights of bilinear lookups have
        /// 8 bits, as in Profile.Vulkan, and the nearest level is floor(lod + 1/2).
        /// </summary>
        D3d11 = 2,
        /// <summary>
        /// OpenImageIO 2.4, TextureSystem with default options. The width w of the filter, in units of the texture, is the
        /// largest of |du/dx| .. |dv/dy| plus the larger blur. The coarser level is the first one on which w is at most one
        /// texel of the smaller side; the finer level is the next finer one. The weight of the coarser level is 2 w - 1,
        /// with w in texels of this level; NEAREST_MIP and BILINEAR_MIP use the coarser level. ANISOTROPIC: axes m &gt;= n of
        /// the ellipse in units of the texture, lengthened by blur; where m &gt; a n they become m' = (m + a n) / 2 and n' = m'
        /// / a. Levels by w = n. N = floor(2 m / n - 1) probes, at least 1 and at most one per half texel of level 0, at p
        /// (m - n), p = (2 k + 1 - N) / N, k = 0 to N - 1, of weight exp(-2 x^2), x = p m / (2 (m - n)). `width_x` and
        /// `width_y` scale the derivatives of u and of v, as swidth and twidth do.
        /// </summary>
        Oiio = 3,
        /// <summary>As LEAST_ERROR with lambda = log2(s1), log2(s1 / r) for ANISOTROPIC, and without the 3/8 of a level.</summary>
        Exact = 4,
    }

    /// <summary>Arithmetic of lookups. Each has the same bits on every SIMD target.</summary>
    public enum Precision
    {
        /// <summary>weights and sums are binary32 floats</summary>
        Full = 0,
        /// <summary>
        /// Texels are blended in integers of 16 bits, with fractions of 15 bits. Values are within 2^-11 of
        /// Precision.Full, an eighth of a step of 8 bits. Where all texels are equal, values have the same bits.
        ///
        /// Levels of detail are the same. In LEAST_ERROR and EXACT, ANISOTROPIC blends levels in a part of the way between
        /// them: it has the levels and probes of a level_blend of at most 9/32. Its values are within
        /// 2^-11 + 2^-22 (width + height) of Precision.Full with that level_blend, for footprints of up to 4 textures.
        ///
        /// It applies to 2D textures of 8-bit unorm formats of one to four channels, the filters BILINEAR, BILINEAR_MIP,
        /// TRILINEAR and ANISOTROPIC with equal weights of the probes, and every wrap except Wrap.Border. All other
        /// lookups, derivatives of values, and shd_texture_explain() have Precision.Full.
        ///
        /// Choose it for pictures of 8 bits. Keep Precision.Full for measurements, and for values whose differences
        /// matter, such as heights and normals.
        /// </summary>
        Fast = 1,
    }

    /// <summary>
    /// Random choice of Filter.Stochastic. The expected value of each is the named filter F = sum of w_k t_k, with the
    /// texels t_k and their weights w_k.
    /// </summary>
    public enum Stochastic
    {
        /// <summary>One texel, with its weight as the probability. Variance: sum of w_k (t_k - F)^2.</summary>
        Texel = 0,
        /// <summary>
        /// One of the two levels of TRILINEAR, or one probe of ANISOTROPIC and one of its levels; then the bilinear lookup
        /// b_i of its four texels, or eight in 3D. With the probabilities p_i the variance is sum of p_i (b_i - F)^2: the
        /// variance of one texel less the mean variance within a quad. Where the level of detail is at most 0, trilinear has
        /// none. Other filters are refused.
        /// </summary>
        Quad = 1,
    }

    /// <summary>Lookups where a tile of the texture is not in memory (shd/tile_cache.h). No effect for other textures.</summary>
    public enum MissingTiles
    {
        /// <summary>load the tile; the result does not depend on the content of the cache</summary>
        Wait = 0,
        /// <summary>
        /// Never load and wait for no callback: filter from the finest levels with resident tiles, and request missing ones
        /// (shd_tile_cache_load_requested()). A lookup that needs a missing tile of level l is done again with a level of
        /// detail of at least l + 1, and so on; BILINEAR and BICUBIC become BILINEAR_MIP, and NEAREST becomes NEAREST_MIP.
        /// If no tile of any level is resident, the result is 0. Texels has the column `coarser`.
        /// </summary>
        Coarser = 1,
    }

    /// <summary>
    /// Comparisons `z OP d`: of a depth z with the depth d of a sample in depth tests, or of a reference z with a texel d in
    /// comparison lookups (SamplerDesc.compares). If z or d is NaN, every comparison except ALWAYS is false.
    /// </summary>
    public enum Compare
    {
        /// <summary>z &lt; d</summary>
        Less = 0,
        /// <summary>z &lt;= d</summary>
        LessEqual = 1,
        /// <summary>z = d</summary>
        Equal = 2,
        /// <summary>z &gt;= d</summary>
        GreaterEqual = 3,
        /// <summary>z &gt; d, for depth that decreases with the distance (clear_depth 0)</summary>
        Greater = 4,
        /// <summary>z &lt; d or z &gt; d</summary>
        NotEqual = 5,
        /// <summary>true</summary>
        Always = 6,
        /// <summary>false</summary>
        Never = 7,
    }

    /// <summary>Options of a load; combine with |.</summary>
    [Flags]
    public enum SceneFlags : uint
    {
        None = 0,
        /// <summary>a texture that cannot be read makes the load fail</summary>
        RequireTextures = 1,
        /// <summary>textures have the filters of SceneDesc.sampler, not those of the file</summary>
        HostFilters = 2,
        /// <summary>reads the model in this process: faster start, and the file must be trusted</summary>
        InProcess = 4,
        /// <summary>names of the model may leave its folder: by `..`, absolute paths and links</summary>
        AnyFolder = 8,
    }

    /// <summary>Kinds of parts that have names.</summary>
    public enum ScenePart
    {
        Mesh = 0,
        Material = 1,
        /// <summary>the path of its file</summary>
        Texture = 2,
        Light = 3,
        Camera = 4,
        Animation = 5,
    }

    /// <summary>Computation of visibility from depths.</summary>
    public enum ShadowFilter
    {
        /// <summary>the nearest texel, 0 or 1</summary>
        Hard = 0,
        /// <summary>
        /// The mean of n x n bilinear comparisons a texel apart (Reeves, Salesin and Cook, "Rendering Antialiased Shadows
        /// with Depth Maps", 1987). It varies continuously. Reads (n + 1)^2 texels, n = taps.
        /// </summary>
        Pcf = 1,
        /// <summary>
        /// Chebyshev's bound of the distribution of depths in n x n texels, n = taps, interpolated from four neighbours
        /// (Donnelly and Lauritzen, "Variance Shadow Maps", 2006).
        /// </summary>
        Variance = 2,
        /// <summary>
        /// Chebyshev's bound over a square of edge length filter_size around the point, from a summed-area table (Lauritzen,
        /// GPU Gems 3, 2007, 8).
        /// </summary>
        SummedAreaVariance = 3,
        /// <summary>
        /// Penumbras that widen with the distance to the blockers (Fernando, "Percentage-Closer Soft Shadows", 2005): the
        /// mean depth of blockers from n x n texels, then the mean of n x n bilinear comparisons over the width of the
        /// penumbra, n = taps. Only blockers that a ray from the point to the light meets determine the width, if there are
        /// any (Guennebaud, Barthe and Paulin, "Real-Time Soft Shadow Mapping by Backprojection", 2006). Reads 5 n^2 texels
        /// for any width; in wide penumbras they are not adjacent. The pattern of the texels is shifted at each point
        /// (Cranley and Patterson, 1976) by a hash of the bits of its position, so penumbras have fine noise, less with more
        /// taps. Equal positions have equal patterns in every frame, tile and batch.
        /// </summary>
        Pcss = 4,
    }

    /// <summary>Kinds of shapes.</summary>
    public enum Shape
    {
        /// <summary>uses `radius`</summary>
        Sphere = 0,
        /// <summary>uses `size`</summary>
        Box = 1,
        /// <summary>a rectangle, size[0] by size[2]</summary>
        Plane = 2,
        /// <summary>`radius` of the circle in the middle of the tube, `tube_radius`</summary>
        Torus = 3,
        /// <summary>
        /// The Utah teapot: 32 bicubic Bezier patches by Martin Newell (1975), with the bottom that Frank Crow added ("The
        /// Origins of the Teapot", IEEE Computer Graphics and Applications 7(1), 1987). The body with its bottom, the lid,
        /// the handle and the spout are separate open surfaces that meet or intersect.
        /// </summary>
        Teapot = 4,
    }

    /// <summary>
    /// Coefficient of a material that a slot feeds.
    ///
    /// The value of the slot multiplies the constant of the same name in MaterialDesc, if there is one. Colours have
    /// three channels, scalars one.
    /// </summary>
    public enum SlotTarget
    {
        /// <summary>colour k_d or base colour; the fourth channel multiplies opacity</summary>
        Diffuse = 0,
        /// <summary>colour k_a</summary>
        Ambient = 1,
        /// <summary>colour k_s</summary>
        Specular = 2,
        /// <summary>scalar p</summary>
        Exponent = 3,
        /// <summary>scalar</summary>
        Opacity = 4,
        /// <summary>colour</summary>
        Emission = 5,
        /// <summary>scalar</summary>
        Metallic = 6,
        /// <summary>scalar</summary>
        Roughness = 7,
        /// <summary>scalar o: ambient light times 1 + occlusion_strength (o - 1)</summary>
        Occlusion = 8,
        /// <summary>tangent-space normal in MaterialDesc.normal_encoding</summary>
        Normal = 9,
        /// <summary>scalar height, for bumps and parallax; takes 2D textures only</summary>
        Height = 10,
        /// <summary>colour by the direction of the normal in view; takes 2D textures only</summary>
        Matcap = 11,
        /// <summary>
        /// scalar: mixed moment of slopes; read with NormalEncoding.Moments and
        /// SlotTarget.Normal only. A constant slot gives slopes without covariance
        /// </summary>
        NormalMixed = 12,
        /// <summary>scalar: strength of the clear coat, clamped to 0..1</summary>
        Clearcoat = 13,
        /// <summary>scalar: roughness of the clear coat</summary>
        ClearcoatRoughness = 14,
        /// <summary>tangent-space normal of the clear coat, NormalEncoding.Xyz with z &gt; 0</summary>
        ClearcoatNormal = 15,
        Tint = 16,
    }

    /// <summary>Source of the values of a slot.</summary>
    public enum SlotSource
    {
        /// <summary>1; for the normal (0, 0, 1) in tangent space</summary>
        Constant = 0,
        /// <summary>
        /// `texture` through `sampler`: 2D at uv, 3D at the place of a point. If it is TextureFlags.Premultiplied, the slots
        /// DIFFUSE and TINT have r / a, g / a, b / a of the lookup, or 0 where a is not positive; other slots read the
        /// lookup as it is.
        /// </summary>
        Texture = 1,
        /// <summary>interpolated attributes of the mesh from `attribute` on; 1 for absent ones</summary>
        Vertex = 2,
        /// <summary>`procedure`</summary>
        Procedure = 3,
        /// <summary>colours of `solid` at the place of a point</summary>
        Solid = 4,
    }

    /// <summary>Space of the places at which solid textures are evaluated.</summary>
    public enum PlaceSpace
    {
        /// <summary>
        /// Object space: the position in world space through the inverse of Draw.object_to_world. The pattern moves with
        /// the object. If the matrix has no inverse, the place is 0 before place_transform.
        /// </summary>
        Object = 0,
        /// <summary>world space: objects move through the pattern</summary>
        World = 1,
    }

    /// <summary>Pattern of a solid texture; the file's comment has the formulas.</summary>
    public enum Solid
    {
        /// <summary>two colours, across x</summary>
        Stripes = 0,
        /// <summary>cubes of two colours</summary>
        Checker = 1,
        /// <summary>gradient noise on the integer lattice</summary>
        Perlin = 2,
        /// <summary>interpolated random values</summary>
        Value = 3,
        /// <summary>gradient noise on a lattice of tetrahedra</summary>
        Simplex = 4,
        /// <summary>distances to random points</summary>
        Worley = 5,
        /// <summary>waves across x, distorted by turbulence</summary>
        Marble = 6,
        /// <summary>rings around y, distorted by noise</summary>
        Wood = 7,
    }

    /// <summary>Sum of octaves.</summary>
    public enum SolidSum
    {
        /// <summary>fractional Brownian motion: the sum of n</summary>
        Fbm = 0,
        /// <summary>the sum of |n|</summary>
        Turbulence = 1,
    }

    /// <summary>Gradients of Solid.Perlin.</summary>
    public enum SolidGradients
    {
        /// <summary>twelve gradients, chosen by an integer hash; fastest</summary>
        Hashed = 0,
        /// <summary>256 random unit vectors, through a permutation table</summary>
        Table = 1,
    }

    /// <summary>Weight of a lattice point at distance t along an axis.</summary>
    public enum SolidFade
    {
        /// <summary>second derivatives are continuous</summary>
        Quintic = 0,
        /// <summary>first derivatives are continuous</summary>
        Cubic = 1,
    }

    /// <summary>Distance of Solid.Worley.</summary>
    public enum SolidDistance
    {
        /// <summary>to the nearest feature point</summary>
        F1 = 0,
        /// <summary>to the second nearest feature point</summary>
        F2 = 1,
        /// <summary>F2 - F1: 0 on the borders between the cells of the points</summary>
        F2F1 = 2,
    }

    /// <summary>Number of parts of an edge.</summary>
    public enum TessellationMode
    {
        /// <summary>`segments` for each edge: a triangle becomes segments^2</summary>
        Uniform = 0,
        /// <summary>
        /// The smallest number for which no part is longer than `edge_length`. It depends only on the positions of the
        /// edge's two ends, so triangles on both sides agree and no cracks open, even where uv or normals differ.
        /// </summary>
        Adaptive = 1,
    }

    /// <summary>
    /// Normals of a displaced mesh.
    ///
    /// The mean of face normals, weighted by area. Vertices that shared position and normal before displacement share the
    /// mean. Seams of uv therefore stay smooth, and creases stay sharp.
    /// </summary>
    public enum DisplacedNormals
    {
        /// <summary>
        /// The previous normals, tilted by the slope of the heights: n - grad h, where grad h is the gradient on the faces
        /// around the vertex before displacement. Coarse triangles with smooth normals keep their smooth look.
        /// </summary>
        Tilted = 0,
        /// <summary>the previous normals</summary>
        Kept = 1,
        /// <summary>the normals of the faces around the vertex after displacement</summary>
        Faces = 2,
    }

    /// <summary>Prefiltered tables of a texture; combine with |.</summary>
    [Flags]
    public enum TableFlags : uint
    {
        /// <summary>the base level alone</summary>
        None = 0,
        /// <summary>levels max(1, floor(size / 2^l)) down to 1 x 1 (Williams 1983); 4/3 of the memory</summary>
        Mipmap = 1,
        /// <summary>
        /// Levels max(1, floor(width / 2^i)) x max(1, floor(height / 2^j)) for every i and j. Takes at most 4 times the
        /// memory, including the mipmap, whose levels are shared. For textures of up to 2^26 texels.
        /// </summary>
        Ripmap = 2,
        /// <summary>
        /// Sums over all rectangles at the origin (Crow 1984): (width + 1) x (height + 1) sums for every stored channel and
        /// layer. A sum takes 4 bytes for 8-bit unorm of up to 2^24 texels a layer, else 8, and 4 more where a binary16 or
        /// binary32 texel is not finite. Sums are exact for unorm. For sRGB and floats of magnitude up to m they are within
        /// 2^-51 width height m.
        /// </summary>
        SummedArea = 4,
    }

    /// <summary>Source of an output channel.</summary>
    public enum Channel
    {
        /// <summary>the channel at the same position; `fill` if the format lacks it</summary>
        Default = 0,
        R = 1,
        G = 2,
        B = 3,
        A = 4,
        /// <summary>the element of `fill` at the same position</summary>
        Fill = 5,
    }

    /// <summary>Options of a texture; combine with |.</summary>
    [Flags]
    public enum TextureFlags : uint
    {
        None = 0,
        /// <summary>
        /// Borrow `texels` until release instead of copying them. Only shd_texture_update() may change them. Requires one
        /// layer of packed rows, or packed slices of packed rows, a format without three channels or RGB9E5, and texels
        /// aligned to min(size of a texel, 4) bytes. Constants.TexturePadding bytes behind the last texel must be readable,
        /// because lookups load whole vectors. Blocks need neither the alignment nor the padding, and must not change while
        /// the texture lives, because decoded blocks are kept between calls. Lookups give the same bits as for copied
        /// texels.
        /// </summary>
        Borrow = 1,
        /// <summary>
        /// With TextureFlags.Borrow: borrow the mip levels as well. Levels 0, 1, 2 ... then follow one another without gaps
        /// from `texels` on, as in a file that is mapped to memory; `levels` has their addresses. Not for 3D textures, and
        /// not for blocks. shd_texture_update() gives Result.ErrorUnsupported.
        /// </summary>
        BorrowLevels = 2,
        /// <summary>
        /// The texels are premultiplied: r, g and b are multiplied by a. Lookups give such numbers, too. The slots
        /// SlotTarget.Diffuse and SlotTarget.Tint divide filtered r, g and b by filtered a (shd/slot.h).
        /// </summary>
        Premultiplied = 4,
    }

    /// <summary>File formats of textures.</summary>
    public enum TextureFileKind
    {
        None = 0,
        Ktx2 = 1,
        Dds = 2,
    }

    /// <summary>Compression of the levels of a KTX2 file, around its blocks or pixels. The values are those of the file format.</summary>
    public enum Supercompression
    {
        None = 0,
        /// <summary>Result.ErrorUnsupported</summary>
        BasisLz = 1,
        /// <summary>Zstandard (RFC 8878); optional when libshd_io is built</summary>
        Zstd = 2,
        /// <summary>zlib (RFC 1950); optional when libshd_io is built</summary>
        Zlib = 3,
    }

    /// <summary>Properties of a texture file; combine with |.</summary>
    [Flags]
    public enum TextureFileFlags : uint
    {
        None = 0,
        /// <summary>r, g, b are multiplied by alpha</summary>
        Premultiplied = 1,
        /// <summary>declared as an array, even of one layer</summary>
        Array = 2,
        /// <summary>
        /// The first row is the bottom one (KTXorientation of KTX2). The texture has the rows in the order of the
        /// file, so the picture is upside down, unless LoadFlags.FlipV reverses it.
        /// </summary>
        BottomUp = 4,
        /// <summary>the first column is the right one (KTXorientation)</summary>
        RightToLeft = 8,
    }

    /// <summary>Depths of the near and far plane.</summary>
    public enum DepthOrder
    {
        /// <summary>0 near .. 1 far</summary>
        Forward = 0,
        /// <summary>1 near .. 0 far, for draws that compare with Compare.Greater and a clear_depth of 0.</summary>
        Reversed = 1,
    }

    /// <summary>Interpolation of a varying from the three vertices of a triangle to a fragment.</summary>
    public enum Interpolation
    {
        /// <summary>Linear on the triangle itself.</summary>
        Perspective = 0,
        /// <summary>
        /// Linear on the screen between the three projected vertices, also for clipped triangles. If a vertex cannot be
        /// projected (w &lt; 2^-100, or more than 2^60 pixels away), PERSPECTIVE is used.
        /// </summary>
        Affine = 1,
        /// <summary>The value of the triangle's first vertex, for all fragments and at every frequency.</summary>
        Flat = 2,
    }

    /// <summary>Numbers of a file of voxels.</summary>
    public enum RawSample
    {
        /// <summary>the format R8, RG8, RGB8 or RGBA8</summary>
        U8 = 0,
        /// <summary>the format R16, RG16, RGB16 or RGBA16</summary>
        U16 = 1,
        /// <summary>IEEE 754 binary16; the format R16F, RG16F, RGB16F or RGBA16F</summary>
        F16 = 2,
        /// <summary>IEEE 754 binary32; the format R32F, RG32F, RGB32F or RGBA32F</summary>
        F32 = 3,
        /// <summary>as F32: the numbers -128..127 themselves</summary>
        I8 = 4,
        /// <summary>as F32: the numbers themselves, such as Hounsfield units</summary>
        I16 = 5,
        /// <summary>as F32: the numbers themselves, rounded to the nearest binary32</summary>
        U32 = 6,
        /// <summary>as F32: the numbers themselves, rounded to the nearest binary32</summary>
        I32 = 7,
    }

    /// <summary>Order of the bytes of a number.</summary>
    public enum ByteOrder
    {
        /// <summary>lowest byte first</summary>
        Little = 0,
        /// <summary>highest byte first</summary>
        Big = 1,
    }

    /// <summary>Options of an OpenVDB load; combine with |.</summary>
    [Flags]
    public enum VdbFlags : uint
    {
        Default = 0,
        /// <summary>sample the box of the desc instead of the bounds of the active voxels</summary>
        Box = 1,
    }

    /// <summary>Meaning of the numbers of a grid.</summary>
    public enum VdbClass
    {
        Unknown = 0,
        /// <summary>signed distances to a surface [world units], negative inside</summary>
        LevelSet = 1,
        /// <summary>densities, 0 outside</summary>
        FogVolume = 2,
    }

    /// <summary>Texel that index i reads along an axis of n texels (Vulkan specification, "Wrapping Operation").</summary>
    public enum Wrap
    {
        /// <summary>i mod n</summary>
        Repeat = 0,
        /// <summary>clamp(i, 0, n - 1)</summary>
        Clamp = 1,
        /// <summary>repeat with every second copy flipped</summary>
        Mirror = 2,
        /// <summary>the border colour outside 0..n - 1</summary>
        Border = 3,
        /// <summary>one flipped copy below 0, clamped beyond: clamp(i &lt; 0 ? -1 - i : i, 0, n - 1)</summary>
        MirrorOnce = 4,
    }

    /// <summary>Limits of the library, and the version of its headers.</summary>
    public static class Constants
    {
        /// <summary>Part of the version of the headers.</summary>
        public const int VersionMajor = 0;
        /// <summary>Part of the version of the headers.</summary>
        public const int VersionMinor = 1;
        /// <summary>Part of the version of the headers.</summary>
        public const int VersionPatch = 0;
        /// <summary>Largest number of the caller's own columns besides positions, normals, tangents and uv.</summary>
        public const int MaxAttributes = 8;
        /// <summary>Largest number of vertices of a polygon.</summary>
        public const int MaxPolygonVertices = 256;
        /// <summary>Largest number of parts in one direction of a shape.</summary>
        public const int MaxShapeSegments = 4096;
        /// <summary>Largest number of parts per side of a patch of the teapot.</summary>
        public const int MaxTeapotSegments = 256;
        /// <summary>Directions in which shapes are divided.</summary>
        public const int ShapeDirections = 3;
        /// <summary>Largest number of colours of a solid texture.</summary>
        public const int MaxSolidColors = 8;
        /// <summary>Largest number of parts of an edge.</summary>
        public const int MaxSegments = 1024;
        /// <summary>Bytes behind the last texel of a borrowed base level that lookups may read; their values have no effect.</summary>
        public const int TexturePadding = 128;
        /// <summary>Largest number of varyings: values that a vertex program passes to fragments.</summary>
        public const int MaxVaryings = 16;
        /// <summary>Largest number of steps of a ray through one volume.</summary>
        public const int VolumeMaxSteps = 4096;
    }
}
