// SPDX-License-Identifier: MIT
// Written by generate.py; do not edit.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>Statistics of a bake.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct BakeStats
    {
        /// <summary>set by shd_bake_stats_default()</summary>
        public uint StructSize;
        /// <summary>in all draws</summary>
        public ulong Triangles;
        /// <summary>without area in texture coordinates, rounded to 1/256 texel; not baked</summary>
        public ulong ZeroAreaTriangles;
        /// <summary>with a position or texture coordinate that is not finite; not baked</summary>
        public ulong NonfiniteTriangles;
        /// <summary>with a corner outside 0..1; the part inside is baked</summary>
        public ulong OutsideTriangles;
        /// <summary>texels of TexelState.Centre</summary>
        public ulong CentreTexels;
        /// <summary>texels of TexelState.Touched</summary>
        public ulong TouchedTexels;
        /// <summary>texels of TexelState.Dilated</summary>
        public ulong DilatedTexels;
        /// <summary>texels whose centre several triangles cover</summary>
        public ulong OverlappingTexels;
        /// <summary>shaded texels whose r, g, b or a is NaN or infinite (kept as written)</summary>
        public ulong NonfiniteTexels;

        /// <summary>The defaults of the library.</summary>
        public static BakeStats Default
        {
            get
            {
                BakeStats made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.BakeStats, &made, (UIntPtr)sizeof(BakeStats)));
                return made;
            }
        }
    }

    /// <summary>The precision of implementations. Defaults are the rules of Rules.Vulkan.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct BoundsDesc
    {
        /// <summary>set by shd_bounds_desc_default()</summary>
        public uint StructSize;
        /// <summary>at least one; default LENGTHS | ELLIPSE | VULKAN</summary>
        public LevelRules LevelRules;
        /// <summary>fraction bits of a texel coordinate, 2..24; default 4</summary>
        public uint SubtexelBits;
        /// <summary>fraction bits of a level of detail, 1..24; default 4</summary>
        public uint LevelBits;
        /// <summary>bits of the weights of texels, 1..24; 0 = exact; default 9</summary>
        public uint WeightBits;
        /// <summary>bits of the results of unorm formats, 1..24; 0 = not rounded; default 8</summary>
        public uint ResultBits;
        /// <summary>error of a coordinate, relative to max(1, |u|), 0..1/16; default 2^-21</summary>
        public float CoordinateError;
        /// <summary>relative error of the derivatives, 0..1/2; default 0</summary>
        public float DerivativeError;
        /// <summary>error of a level of detail before bias, 0..16; default 2^-10</summary>
        public float LevelError;
        /// <summary>error of a result relative to the largest texel, 0..1; default 2^-16</summary>
        public float RelativeError;
        /// <summary>error of a decoded sRGB texel [codes], 0..1; default 1/2</summary>
        public float SrgbError;

        /// <summary>The defaults of the library.</summary>
        public static BoundsDesc Default
        {
            get
            {
                BoundsDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.BoundsDesc, &made, (UIntPtr)sizeof(BoundsDesc)));
                return made;
            }
        }
    }

    /// <summary>Edges to find.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct EdgesDesc
    {
        /// <summary>set by shd_edges_desc_default()</summary>
        public uint StructSize;
        /// <summary>kinds to find; default EdgeFlags.All</summary>
        public EdgeFlags Edges;
        /// <summary>
        /// Eye in object space, finite: the point (x, y, z) with w = 1, or with w = 0 the direction to an eye at infinity.
        /// Any other (x, y, z, w) except 0 is the point (x, y, z) / w. Default (0, 0, 1, 0).
        /// </summary>
        public Float4 Eye;
        /// <summary>-1..1; default 0.5: edges of 60 degrees and sharper</summary>
        public float CreaseCosine;

        /// <summary>The defaults of the library.</summary>
        public static EdgesDesc Default
        {
            get
            {
                EdgesDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.EdgesDesc, &made, (UIntPtr)sizeof(EdgesDesc)));
                return made;
            }
        }
    }

    /// <summary>Properties of an environment.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct EnvironmentInfo
    {
        /// <summary>set by shd_environment_info_default()</summary>
        public uint StructSize;
        /// <summary>as in its desc</summary>
        public Projection Projection;
        /// <summary>as in its desc</summary>
        public Irradiance Irradiance;
        /// <summary>as in its desc, with EnvironmentTables.Radiance if there are lobes</summary>
        public EnvironmentTables Tables;
        /// <summary>texels a side of the largest map, 0 without EnvironmentTables.Radiance</summary>
        public uint MapSize;
        /// <summary>mean radiance of all directions</summary>
        public Float3 Mean;
        /// <summary>channels of the image that were negative, NaN or above 1e12</summary>
        public ulong ReplacedCount;
        /// <summary>bytes of all tables</summary>
        public long ByteSize { get { return (long)byteSizeWord; } set { byteSizeWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr byteSizeWord;

        /// <summary>The defaults of the library.</summary>
        public static EnvironmentInfo Default
        {
            get
            {
                EnvironmentInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.EnvironmentInfo, &made, (UIntPtr)sizeof(EnvironmentInfo)));
                return made;
            }
        }
    }

    /// <summary>A texel that a lookup reads. Grows with Explanation.tap_size.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Tap
    {
        /// <summary>layer of the array</summary>
        public uint Layer;
        /// <summary>number of times the width was halved: the mip level, or the ripmap's level across</summary>
        public uint LevelU;
        /// <summary>number of times the height was halved: the mip level, or the ripmap's level down</summary>
        public uint LevelV;
        /// <summary>column, after wrapping</summary>
        public uint X;
        /// <summary>row, after wrapping</summary>
        public uint Y;
        /// <summary>1 = the border colour instead of the texel, else 0</summary>
        public uint Border;
        /// <summary>share of the result; the weights of all taps sum to 1 up to rounding</summary>
        public float Weight;
        /// <summary>
        /// stored channels as the blends read them: unorm channels as integers, unless a wrap is
        /// Wrap.Border; comparison lookups: 0 or 1 in the channel of r
        /// </summary>
        public Float4 Value;
        /// <summary>slice of a 3D texture, after wrapping; else 0</summary>
        public uint Z;
    }

    /// <summary>A blend of two nodes of the tree. Grows with Explanation.blend_size.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct BlendStep
    {
        /// <summary>node</summary>
        public uint A;
        /// <summary>node</summary>
        public uint B;
        /// <summary>weight of b</summary>
        public float S;
    }

    /// <summary>Size and planes of a framebuffer. Required: width, height.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FramebufferDesc
    {
        /// <summary>set by shd_framebuffer_desc_default()</summary>
        public uint StructSize;
        /// <summary>pixels, 1..16384</summary>
        public uint Width;
        /// <summary>pixels, 1..16384</summary>
        public uint Height;
        /// <summary>per pixel: 1, 2, 4, 8 or 16, at shd_sample_position(); default 1</summary>
        public uint Samples;
        /// <summary>optional planes; default none</summary>
        public AovFlags Aovs;
        /// <summary>
        /// Storage of colour: Format.Rgba32f, four planes; or interleaved Format.Rgba16f, _RGBA8_SRGB or _RGBA8.
        /// Default Format.Rgba32f. Targets are planes in any case. shd_render with RenderFlags.Load reads colour as it
        /// was rounded.
        /// </summary>
        public Format ColorFormat;

        /// <summary>The defaults of the library.</summary>
        public static FramebufferDesc Default
        {
            get
            {
                FramebufferDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.FramebufferDesc, &made, (UIntPtr)sizeof(FramebufferDesc)));
                return made;
            }
        }
    }

    /// <summary>Size and planes of a framebuffer.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FramebufferInfo
    {
        /// <summary>set by shd_framebuffer_info_default()</summary>
        public uint StructSize;
        /// <summary>pixels</summary>
        public uint Width;
        /// <summary>pixels</summary>
        public uint Height;
        /// <summary>per pixel</summary>
        public uint Samples;
        /// <summary>optional planes</summary>
        public AovFlags Aovs;
        /// <summary>storage of colour</summary>
        public Format ColorFormat;
        /// <summary>bytes of all planes and pixels</summary>
        public long ByteSize { get { return (long)byteSizeWord; } set { byteSizeWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr byteSizeWord;

        /// <summary>The defaults of the library.</summary>
        public static FramebufferInfo Default
        {
            get
            {
                FramebufferInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.FramebufferInfo, &made, (UIntPtr)sizeof(FramebufferInfo)));
                return made;
            }
        }
    }

    /// <summary>Format and properties of a loaded file.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct BitmapInfo
    {
        /// <summary>set by shd_bitmap_info_default()</summary>
        public uint StructSize;
        /// <summary>FileFormatFlags.Any for a format without a bit of its own</summary>
        public FileFormatFlags FileFormat;
        /// <summary>in the file</summary>
        public uint Channels;
        /// <summary>properties</summary>
        public BitmapFlags Flags;

        /// <summary>The defaults of the library.</summary>
        public static BitmapInfo Default
        {
            get
            {
                BitmapInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.BitmapInfo, &made, (UIntPtr)sizeof(BitmapInfo)));
                return made;
            }
        }
    }

    /// <summary>Counts and bounds of a mesh.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeshInfo
    {
        /// <summary>set by shd_mesh_info_default()</summary>
        public uint StructSize;
        /// <summary>including the vertices that MeshFlags.Tangents added</summary>
        public uint VertexCount;
        /// <summary>number of separate triangles, also for strips and fans</summary>
        public uint TriangleCount;
        /// <summary>bound of the finite positions; 0 if there are none</summary>
        public Float3 BoundsMin;
        /// <summary>bound of the finite positions; 0 if there are none</summary>
        public Float3 BoundsMax;
        /// <summary>vertices with a position that is not finite</summary>
        public uint NonfiniteCount;
        /// <summary>vertices whose faces have no area or whose normal was 0; they get (0, 0, 1)</summary>
        public uint NormallessCount;
        /// <summary>
        /// MeshFlags.Tangents: vertices without a tangent from uv; they get a perpendicular
        /// one
        /// </summary>
        public uint TangentlessCount;
        /// <summary>MeshFlags.Tangents: vertices that were added</summary>
        public uint SplitCount;

        /// <summary>The defaults of the library.</summary>
        public static MeshInfo Default
        {
            get
            {
                MeshInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.MeshInfo, &made, (UIntPtr)sizeof(MeshInfo)));
                return made;
            }
        }
    }

    /// <summary>Options of mip levels. Zero is the default of each except alpha_cutoff.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MipDesc
    {
        /// <summary>set by shd_mip_desc_default()</summary>
        public uint StructSize;
        /// <summary>default TexelContent.Color</summary>
        public TexelContent Content;
        /// <summary>default MipKernel.Box</summary>
        public MipKernel Kernel;
        /// <summary>default MipSource.Base</summary>
        public MipSource Source;
        /// <summary>
        /// texels beyond the edge, for kernels wider than the box; default Wrap.Repeat.
        /// With Wrap.Border only texels inside count, with weights scaled to sum 1
        /// </summary>
        public Wrap WrapU;
        /// <summary>as wrap_u, for v</summary>
        public Wrap WrapV;
        /// <summary>cutoff of TexelContent.AlphaCoverage, 0..1; default 0.5</summary>
        public float AlphaCutoff;

        /// <summary>The defaults of the library.</summary>
        public static MipDesc Default
        {
            get
            {
                MipDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.MipDesc, &made, (UIntPtr)sizeof(MipDesc)));
                return made;
            }
        }
    }

    /// <summary>Statistics of a frame: the counts from nonfinite to rasterised add up to `triangles`.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct RenderStats
    {
        /// <summary>set by shd_render_stats_default()</summary>
        public uint StructSize;
        /// <summary>in all draws</summary>
        public ulong Triangles;
        /// <summary>dropped: a vertex is NaN or infinite after transformation</summary>
        public ulong Nonfinite;
        /// <summary>dropped: outside the view volume</summary>
        public ulong Outside;
        /// <summary>
        /// dropped: facing the culled way, without area on the pixel grid, or
        /// (Fill.Lines) without a visible edge that belongs to the triangle
        /// </summary>
        public ulong Culled;
        /// <summary>dropped: between pixel centres</summary>
        public ulong Empty;
        /// <summary>drawn, hidden or not</summary>
        public ulong Rasterised;
        /// <summary>cut by a clip plane, among outside, culled, empty and rasterised</summary>
        public ulong Clipped;
        /// <summary>
        /// shaded; opaque draws count a pixel once for every triangle that is visible in
        /// it, in each pass (RenderDesc.pass_triangles)
        /// </summary>
        public ulong Fragments;
        /// <summary>fragments whose r, g, b or a was NaN or infinite (kept as written)</summary>
        public ulong NonfiniteFragments;
        /// <summary>
        /// covered, but failed the depth test before shading; 0 without
        /// RenderFlags.CountHidden. Draws that blend or drop fragments may be tested against
        /// stale depth, so their count is approximate
        /// </summary>
        public ulong HiddenSamples;
        /// <summary>
        /// PAINTER and NEWELL: pairs of triangles or pieces that overlap on the screen where the one painted first is nearer
        /// somewhere in the overlap, by more than the tolerance of NEWELL. A lower bound where triangles are dense: pairs
        /// are searched in the cells of a grid, and in a cell of n triangles up to 64 n + 1024 pairs are compared.
        /// </summary>
        public ulong OrderConflicts;
        /// <summary>cuts of NEWELL</summary>
        public ulong Splits;
        /// <summary>
        /// peak of working memory, with what the context keeps from earlier calls; depends on
        /// the number of workers
        /// </summary>
        public ulong ScratchBytes;
        /// <summary>wall-clock time of transforming vertices</summary>
        public double VertexSeconds;
        /// <summary>wall-clock time of finding visible triangles and clipping them</summary>
        public double AssemblySeconds;
        /// <summary>wall-clock time of sorting triangles by distance (if at all) and into tiles</summary>
        public double BinningSeconds;
        /// <summary>wall-clock time of coverage, shading and blending</summary>
        public double TileSeconds;

        /// <summary>The defaults of the library.</summary>
        public static RenderStats Default
        {
            get
            {
                RenderStats made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.RenderStats, &made, (UIntPtr)sizeof(RenderStats)));
                return made;
            }
        }
    }

    /// <summary>Rectangle of pixels of a picture. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Region
    {
        /// <summary>first column from the left</summary>
        public uint X;
        /// <summary>first row from the top</summary>
        public uint Y;
        /// <summary>columns</summary>
        public uint Width;
        /// <summary>rows</summary>
        public uint Height;
    }

    /// <summary>Settings of a sampler.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SamplerDesc
    {
        /// <summary>set by shd_sampler_desc_default()</summary>
        public uint StructSize;
        /// <summary>default Filter.Trilinear</summary>
        public Filter Filter;
        /// <summary>default Magnification.Default</summary>
        public Magnification Magnification;
        /// <summary>default Wrap.Repeat</summary>
        public Wrap WrapU;
        /// <summary>default Wrap.Repeat</summary>
        public Wrap WrapV;
        /// <summary>
        /// colour of texels outside with Wrap.Border: stored r, g, b, a, linear,
        /// before the swizzle of the texture; channels that come from its `fill` are
        /// `fill` outside, too; finite; default 0
        /// </summary>
        public Float4 Border;
        /// <summary>
        /// default Profile.LeastError. It also determines which
        /// lookups are magnified (Magnification)
        /// </summary>
        public Profile Profile;
        /// <summary>added to the level of detail, -15..15; default 0</summary>
        public float LodBias;
        /// <summary>lowest level of detail, 0..32; default 0; it is used where lod_max is lower</summary>
        public float LodMin;
        /// <summary>highest level of detail, 0..32; default 32</summary>
        public float LodMax;
        /// <summary>factor of the derivatives in x, 0..64; default 1</summary>
        public float WidthX;
        /// <summary>factor of the derivatives in y, 0..64; default 1</summary>
        public float WidthY;
        /// <summary>blur in u, 0..1, added to the footprint as covariance; default 0</summary>
        public float BlurU;
        /// <summary>blur in v, 0..1, added to the footprint as covariance; default 0</summary>
        public float BlurV;
        /// <summary>largest ratio of the footprint's axes, 1..64; default 16</summary>
        public float MaxAnisotropy;
        /// <summary>weights of ANISOTROPIC in LEAST_ERROR and EXACT; default ProbeWeights.Equal</summary>
        public ProbeWeights ProbeWeights;
        /// <summary>kernel of bicubic filters; default Cubic.CatmullRom</summary>
        public Cubic Cubic;
        /// <summary>area of Filter.SummedArea; default Box.Bounding</summary>
        public Box Box;
        /// <summary>tolerance of Filter.Exact, 2^-12..1; default 2^-6</summary>
        public float Tolerance;
        /// <summary>
        /// Filter that Filter.Stochastic estimates: BILINEAR, BICUBIC (B-spline only), TRILINEAR, ANISOTROPIC or EWA;
        /// default Filter.Trilinear.
        /// </summary>
        public Filter StochasticFilter;
        /// <summary>seed of Filter.Stochastic; default 0</summary>
        public uint Seed;
        /// <summary>default Precision.Full</summary>
        public Precision Precision;
        /// <summary>
        /// Largest number of texels that a lookup of ANISOTROPIC or EWA reads; in 3D textures 2 or 4 times as many. 0 = no
        /// limit besides max_anisotropy, or 32 or more; default 0. It limits the ratio of the footprint's axes as
        /// max_anisotropy does: longer footprints use coarser levels.
        /// </summary>
        public uint MaxTexels;
        /// <summary>
        /// Length by which a footprint may exceed the probes of ANISOTROPIC in LEAST_ERROR and EXACT before another one is
        /// added, in widths of a probe, 0..1; default 1/8. A footprint r times as long as wide has ceil(r - probe_slack)
        /// probes.
        /// </summary>
        public float ProbeSlack;
        /// <summary>
        /// Part of the way between two mip levels in which TRILINEAR, NEAREST_MIP_LINEAR and ANISOTROPIC in LEAST_ERROR and
        /// EXACT blend them, 0..1; default 1. If f is the fraction of the level of detail, the share of the coarser level is
        /// clamp((f - 1/2) / level_blend + 1/2, 0, 1), and a level without share is not read. With 0, only the nearer level
        /// is read.
        /// </summary>
        public float LevelBlend;
        /// <summary>random choice of Filter.Stochastic; default Stochastic.Texel</summary>
        public Stochastic Stochastic;
        /// <summary>across the slices of a 3D texture; no effect for others; default Wrap.Repeat</summary>
        public Wrap WrapW;
        /// <summary>default MissingTiles.Wait</summary>
        public MissingTiles MissingTiles;
        /// <summary>
        /// 1 = comparison lookups, as texture units have them for shadow maps (percentage-closer filtering; Reeves, Salesin
        /// and Cook 1987; Vulkan 1.3 specification, "Depth Compare Operation"); 0 = lookups return texels; default 0. Each
        /// texel that the filter reads becomes 1 if the comparison of the lookup's `reference` with it is true, else 0. The
        /// filter blends these numbers. The result is in r; g and b are 0, and a is 1.
        ///
        /// A texel is its channel of r after the texture's swizzle, which may be a constant of `fill`. Texels outside with
        /// Wrap.Border have the border colour. UNORM and SRGB formats clamp the reference to [0, 1]. Numbers are
        /// compared as floats, after sRGB is decoded.
        ///
        /// Works with NEAREST, BILINEAR, NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP, TRILINEAR and ANISOTROPIC on all
        /// textures. Other filters, derivatives, and samplers of materials, lights and tessellations return
        /// Result.ErrorUnsupported. Precision.Fast has no effect.
        /// </summary>
        public uint Compares;
        /// <summary>comparison of these lookups; default Compare.Less</summary>
        public Compare Compare;

        /// <summary>The defaults of the library.</summary>
        public static SamplerDesc Default
        {
            get
            {
                SamplerDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.SamplerDesc, &made, (UIntPtr)sizeof(SamplerDesc)));
                return made;
            }
        }
    }

    /// <summary>Contents of a file.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SceneInfo
    {
        /// <summary>set by shd_scene_info_default()</summary>
        public uint StructSize;
        /// <summary>with triangles</summary>
        public uint MeshCount;
        /// <summary>at least 1</summary>
        public uint MaterialCount;
        /// <summary>that could be read</summary>
        public uint TextureCount;
        /// <summary>0 where the file has none</summary>
        public uint LightCount;
        /// <summary>0 where the file has none</summary>
        public uint CameraCount;
        /// <summary>as many as draws</summary>
        public uint InstanceCount;
        /// <summary>parts of the file that were left out or changed</summary>
        public uint WarningCount;
        /// <summary>sum over all meshes, each counted once</summary>
        public ulong VertexCount;
        /// <summary>sum over all meshes, each counted once</summary>
        public ulong TriangleCount;
        /// <summary>lowest x, y, z of all instances, world space</summary>
        public Float3 BoundsMin;
        /// <summary>highest x, y, z of all instances, world space</summary>
        public Float3 BoundsMax;
        /// <summary>
        /// a place in the world of the file is origin + the place in world space; 0 unless the
        /// model is far away from 0. Equal in all poses
        /// </summary>
        public Double3 Origin;
        /// <summary>0 where the file has none</summary>
        public uint AnimationCount;
        /// <summary>meshes with a skin or morph targets, which each pose makes anew</summary>
        public uint DeformedMeshCount;

        /// <summary>The defaults of the library.</summary>
        public static SceneInfo Default
        {
            get
            {
                SceneInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.SceneInfo, &made, (UIntPtr)sizeof(SceneInfo)));
                return made;
            }
        }
    }

    /// <summary>A mesh placed in the world with a material.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SceneInstance
    {
        /// <summary>set by shd_scene_instance_default()</summary>
        public uint StructSize;
        /// <summary>index for shd_scene_mesh()</summary>
        public uint Mesh;
        /// <summary>index for shd_scene_material()</summary>
        public uint Material;
        /// <summary>affine, finite</summary>
        public Matrix4 ObjectToWorld;
        /// <summary>faces that its draw skips: Cull.None for surfaces that are double-sided</summary>
        public Cull Cull;

        /// <summary>The defaults of the library.</summary>
        public static SceneInstance Default
        {
            get
            {
                SceneInstance made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.SceneInstance, &made, (UIntPtr)sizeof(SceneInstance)));
                return made;
            }
        }
    }

    /// <summary>Options of a shadow.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ShadowDesc
    {
        /// <summary>set by shd_shadow_desc_default()</summary>
        public uint StructSize;
        /// <summary>edge length of each face [texels], 16..8192; default 1024</summary>
        public uint Size;
        /// <summary>default ShadowFilter.Hard</summary>
        public ShadowFilter Filter;
        /// <summary>n of PCF, VARIANCE and PCSS, 1..15; default 3</summary>
        public uint Taps;
        /// <summary>
        /// SUMMED_AREA_VARIANCE: edge length of the averaged square, world length at the point, 0..1e9; clamped to one texel
        /// to size / 4 texels. Default 0.
        /// </summary>
        public float FilterSize;
        /// <summary>
        /// PCSS: edge length of the square light, world length, 0..1e9; default 0. For directional lights: width of the
        /// penumbra per distance of blocker and receiver, which is twice the tangent of half the angular size of the light
        /// (the sun: 0.0093). Search and penumbra are at most size / 4 texels wide.
        /// </summary>
        public float LightSize;
        /// <summary>points are moved towards the light by this depth, world length, 0..1e9; default 0</summary>
        public float Bias;
        /// <summary>
        /// Factor of another bias: the edge length of a texel at the point times 1/4 + s. s is the sum of the |slopes| of
        /// the surface across and along the map, at most 8. A slope is depth over length. The plane of the surface is exact
        /// at each texel, so this bias covers only the difference of the surface from its plane. Without a normal, 1/4 + s
        /// is replaced by 2, or by n + 1 for PCF. 0..1000; default 1.
        /// </summary>
        public float BiasSlope;
        /// <summary>
        /// before the lookup, points are moved along their normal by this world length, 0..1e9;
        /// default 0. For coarse meshes with smooth normals: about the edge length of a texel
        /// </summary>
        public float NormalOffset;
        /// <summary>
        /// faces that cast no shadow: BACK faces are turned away from the light, FRONT faces
        /// towards it. Replaces the culling of the draws. Default Cull.None, for open surfaces.
        /// FRONT avoids acne on closed objects without a bias, but light leaks where they touch
        /// other surfaces
        /// </summary>
        public Cull CasterCull;
        /// <summary>
        /// VARIANCE, SUMMED_AREA_VARIANCE: visibilities below this value become 0, 0..0.99;
        /// default 0
        /// </summary>
        public float Bleed;
        /// <summary>VARIANCE, SUMMED_AREA_VARIANCE: world length squared, 0..1e9; default 0</summary>
        public float MinVariance;

        /// <summary>The defaults of the library.</summary>
        public static ShadowDesc Default
        {
            get
            {
                ShadowDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ShadowDesc, &made, (UIntPtr)sizeof(ShadowDesc)));
                return made;
            }
        }
    }

    /// <summary>A shape and its subdivision.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ShapeDesc
    {
        /// <summary>set by shd_shape_desc_default()</summary>
        public uint StructSize;
        /// <summary>default sphere</summary>
        public Shape Shape;
        /// <summary>spheres and tori: 1e-30..1e30; default 1</summary>
        public float Radius;
        /// <summary>tori: 1e-30..1e30, below `radius`; default 0.25</summary>
        public float TubeRadius;
        /// <summary>boxes and planes: length along x, y, z, 1e-30..1e30; default 2</summary>
        public Float3 Size;
        /// <summary>
        /// Parts; 0 = the number in brackets. Sphere: around, 3..4096 [32], and from pole to pole, 2..4096 [16]. Box: along
        /// x, y and z, 1..4096 [1]. Plane: [0] along x and [2] along z, as of `size`, 1..4096 [1]. Torus: around the axis,
        /// 3..4096 [48], and around the tube, 3..4096 [24]. Teapot: along each side of a patch, 2..256 [8]. Unused numbers
        /// are ignored, as size[1] and segments[1] of a plane.
        /// </summary>
        public UInt3 Segments;

        /// <summary>The defaults of the library.</summary>
        public static ShapeDesc Default
        {
            get
            {
                ShapeDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ShapeDesc, &made, (UIntPtr)sizeof(ShapeDesc)));
                return made;
            }
        }
    }

    /// <summary>A solid texture: a pattern, its octaves and its colours. It has no pointers, so a copy is independent.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SolidDesc
    {
        /// <summary>set by shd_solid_desc_default()</summary>
        public uint StructSize;
        /// <summary>default Solid.Stripes</summary>
        public Solid Kind;
        /// <summary>another seed gives another pattern of the same kind; no effect on STRIPES, CHECKER</summary>
        public uint Seed;
        /// <summary>side of a cell or width of a stripe [units of the positions], 1e-30..1e30; default 1</summary>
        public float Size;
        /// <summary>
        /// Number of octaves of PERLIN, VALUE, SIMPLEX, WORLEY, and of the noise in MARBLE and WOOD, 1..32; default 1. The
        /// sum is N = sum of gain^i n(lacunarity^i p) / sum of gain^i, for i from 0 on. Each octave has a pattern of its
        /// own, except with SolidGradients.Table, as in the classic form.
        /// </summary>
        public uint Octaves;
        /// <summary>ratio of the frequencies of successive octaves, 1..16; default 2</summary>
        public float Lacunarity;
        /// <summary>ratio of the amplitudes of successive octaves, 0..1; default 1/2</summary>
        public float Gain;
        /// <summary>PERLIN, VALUE and SIMPLEX: default SolidSum.Fbm</summary>
        public SolidSum Sum;
        /// <summary>PERLIN: default SolidGradients.Hashed</summary>
        public SolidGradients Gradients;
        /// <summary>PERLIN, VALUE, MARBLE and WOOD: default SolidFade.Quintic</summary>
        public SolidFade Fade;
        /// <summary>WORLEY: default SolidDistance.F1</summary>
        public SolidDistance Distance;
        /// <summary>MARBLE and WOOD: factor of the noise [cells], 0..1000; default 1</summary>
        public float Distortion;
        /// <summary>Values of the first and the last colour, -1e6..1e6; equal = the limits of the kind's range; default 0, 0.</summary>
        public Float2 Range;
        /// <summary>2..Constants.MaxSolidColors; default 2</summary>
        public uint ColorCount;
        /// <summary>
        /// r, g, b, a at equal distances over `range`, linear, -1e6..1e6; values in between are interpolated, values beyond
        /// `range` have the nearest colour. Default black and white, both opaque.
        /// </summary>
        public Float8x4 Colors;

        /// <summary>The defaults of the library.</summary>
        public static SolidDesc Default
        {
            get
            {
                SolidDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.SolidDesc, &made, (UIntPtr)sizeof(SolidDesc)));
                return made;
            }
        }
    }

    /// <summary>Size, format and memory of a texture.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TextureInfo
    {
        /// <summary>set by shd_texture_info_default()</summary>
        public uint StructSize;
        /// <summary>format of every level; RGBA for RGB8 to RGB32F, with _SRGB</summary>
        public Format Format;
        /// <summary>texels of level 0</summary>
        public uint Width;
        /// <summary>texels of level 0</summary>
        public uint Height;
        /// <summary>images of the array</summary>
        public uint Layers;
        /// <summary>
        /// 1; with TableFlags.Mipmap the number of levels down to 1 x 1, or the number of given
        /// levels + 1
        /// </summary>
        public uint LevelCount;
        /// <summary>tables of the texture</summary>
        public TableFlags Tables;
        /// <summary>as in its desc</summary>
        public TextureFlags Flags;
        /// <summary>
        /// bytes of all tables and of the data that shd_texture_update() keeps, without a borrowed
        /// base level
        /// </summary>
        public long ByteSize { get { return (long)byteSizeWord; } set { byteSizeWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr byteSizeWord;
        /// <summary>slices of level 0; 0 = not a 3D texture</summary>
        public uint Depth;
        /// <summary>as in its desc</summary>
        public Projection Projection;

        /// <summary>The defaults of the library.</summary>
        public static TextureInfo Default
        {
            get
            {
                TextureInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TextureInfo, &made, (UIntPtr)sizeof(TextureInfo)));
                return made;
            }
        }
    }

    /// <summary>Contents of a texture file.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TextureFileInfo
    {
        /// <summary>set by shd_texture_file_info_default()</summary>
        public uint StructSize;
        /// <summary>file format</summary>
        public TextureFileKind Kind;
        /// <summary>storage in the file: VkFormat of KTX2; DXGI_FORMAT of DDS, 0 without such a number</summary>
        public uint FileCode;
        /// <summary>compression around the levels; NONE for DDS</summary>
        public Supercompression Supercompression;
        /// <summary>properties</summary>
        public TextureFileFlags Flags;
        /// <summary>storage in the texture</summary>
        public Format Format;
        /// <summary>texels of level 0</summary>
        public uint Width;
        /// <summary>texels of level 0; 1 for a 1D texture</summary>
        public uint Height;
        /// <summary>slices of level 0; 0 = not a 3D texture</summary>
        public uint Depth;
        /// <summary>images of the array, or cube maps of an array of cube maps</summary>
        public uint Layers;
        /// <summary>6 for cube maps, otherwise 1</summary>
        public uint Faces;
        /// <summary>levels in the file</summary>
        public uint LevelCount;

        /// <summary>The defaults of the library.</summary>
        public static TextureFileInfo Default
        {
            get
            {
                TextureFileInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TextureFileInfo, &made, (UIntPtr)sizeof(TextureFileInfo)));
                return made;
            }
        }
    }

    /// <summary>Options of a KTX2 file that is written.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Ktx2Desc
    {
        /// <summary>set by shd_ktx2_desc_default()</summary>
        public uint StructSize;
        /// <summary>NONE, ZSTD or ZLIB; default NONE</summary>
        public Supercompression Supercompression;
        /// <summary>1..19 for ZSTD, 1..9 for ZLIB; default 0 = that of the library</summary>
        public int Effort;
        /// <summary>
        /// 3 = write r, g and b of a texture of four channels. Textures that are made of three channels have four, and the
        /// fourth is 0. Default 0 = all channels.
        /// </summary>
        public uint Channels;

        /// <summary>The defaults of the library.</summary>
        public static Ktx2Desc Default
        {
            get
            {
                Ktx2Desc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Ktx2Desc, &made, (UIntPtr)sizeof(Ktx2Desc)));
                return made;
            }
        }
    }

    /// <summary>Size of a tile cache.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TileCacheDesc
    {
        /// <summary>set by shd_tile_cache_desc_default()</summary>
        public uint StructSize;
        /// <summary>bytes of a tile, a power of two from 1024 to 2^20; default 65536</summary>
        public uint TileBytes;
        /// <summary>
        /// All memory of the cache: tiles, their table, and places for copies of texels; from 4 tiles plus 64 KiB to 2^31
        /// bytes; default 2^28. It is allocated once. A small budget makes lookups slower, because tiles are loaded again.
        /// Half of the tiles can be pinned.
        /// </summary>
        public ulong BudgetBytes;

        /// <summary>The defaults of the library.</summary>
        public static TileCacheDesc Default
        {
            get
            {
                TileCacheDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TileCacheDesc, &made, (UIntPtr)sizeof(TileCacheDesc)));
                return made;
            }
        }
    }

    /// <summary>Counters of a tile cache since its creation.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TileCacheStats
    {
        /// <summary>set by shd_tile_cache_stats_default()</summary>
        public uint StructSize;
        /// <summary>bytes of a tile</summary>
        public uint TileBytes;
        /// <summary>as in its desc</summary>
        public ulong BudgetBytes;
        /// <summary>memory of the cache, at most the budget; it does not change</summary>
        public ulong AllocatedBytes;
        /// <summary>tiles that fit</summary>
        public uint TileCount;
        /// <summary>tiles in memory now</summary>
        public uint ResidentTiles;
        /// <summary>tiles that are pinned now</summary>
        public uint PinnedTiles;
        /// <summary>tiles that shd_tile_cache_load_requested() would load now</summary>
        public uint RequestedTiles;
        /// <summary>calls of load callbacks</summary>
        public ulong Loads;
        /// <summary>tiles that callbacks wrote</summary>
        public ulong LoadedTiles;
        /// <summary>tiles of calls that failed</summary>
        public ulong FailedTiles;
        /// <summary>tiles that gave their place to others</summary>
        public ulong EvictedTiles;
        /// <summary>waits of lookups for tiles that other threads loaded</summary>
        public ulong Waits;

        /// <summary>The defaults of the library.</summary>
        public static TileCacheStats Default
        {
            get
            {
                TileCacheStats made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TileCacheStats, &made, (UIntPtr)sizeof(TileCacheStats)));
                return made;
            }
        }
    }

    /// <summary>Files of a texture.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TileFileInfo
    {
        /// <summary>set by shd_tile_file_info_default()</summary>
        public uint StructSize;
        /// <summary>files of a set side by side; 1 for a file</summary>
        public uint Columns;
        /// <summary>files of a set one above the other; 1 for a file</summary>
        public uint Rows;
        /// <summary>files that exist</summary>
        public uint Files;
        /// <summary>
        /// texels of a tile of a file. Caches whose tiles are as large or larger read each tile of
        /// a file once. KTX2 and DDS: 4 for blocks, 1 for pixels
        /// </summary>
        public uint TileWidth;
        /// <summary>texels of a tile of a file</summary>
        public uint TileHeight;

        /// <summary>The defaults of the library.</summary>
        public static TileFileInfo Default
        {
            get
            {
                TileFileInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TileFileInfo, &made, (UIntPtr)sizeof(TileFileInfo)));
                return made;
            }
        }
    }

    /// <summary>A rectangle of a level. Required: width, height.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TileRegion
    {
        /// <summary>set by shd_tile_region_default()</summary>
        public uint StructSize;
        /// <summary>layer, face, or slice of the level of a 3D texture; default 0</summary>
        public uint Layer;
        /// <summary>0..level_count - 1; default 0</summary>
        public uint Level;
        /// <summary>first column, in texels of the level; default 0</summary>
        public uint X;
        /// <summary>first row; default 0</summary>
        public uint Y;
        /// <summary>1 or more; x + width is at most the width of the level</summary>
        public uint Width;
        /// <summary>1 or more; y + height is at most the height of the level</summary>
        public uint Height;

        /// <summary>The defaults of the library.</summary>
        public static TileRegion Default
        {
            get
            {
                TileRegion made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TileRegion, &made, (UIntPtr)sizeof(TileRegion)));
                return made;
            }
        }
    }

    /// <summary>
    /// Transforms from world to clip space. Frozen, because it is a member of RenderDesc. Later options of a picture
    /// are appended to RenderDesc.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct View
    {
        /// <summary>rigid, finite</summary>
        public Matrix4 WorldToView;
        /// <summary>projection, finite</summary>
        public Matrix4 ViewToClip;
        /// <summary>world space; viewing directions (wo) point to it</summary>
        public Float3 Eye;
    }

    /// <summary>A perspective camera.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Camera
    {
        /// <summary>set by shd_camera_default()</summary>
        public uint StructSize;
        /// <summary>world space; default (0, 0, 3)</summary>
        public Float3 Eye;
        /// <summary>world space, different from the eye; default 0</summary>
        public Float3 Target;
        /// <summary>world space, any length, not along the line of sight; default (0, 1, 0)</summary>
        public Float3 Up;
        /// <summary>vertical field of view [rad], (0, pi); default 0.8</summary>
        public float FovY;
        /// <summary>width / height, &gt; 0; 0 = aspect of the picture, or 1 if there is no picture; default 0</summary>
        public float Aspect;
        /// <summary>distance, &gt; 0; default 0.1</summary>
        public float NearPlane;
        /// <summary>distance, &gt; near_plane; default 100</summary>
        public float FarPlane;

        /// <summary>The defaults of the library.</summary>
        public static Camera Default
        {
            get
            {
                Camera made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Camera, &made, (UIntPtr)sizeof(Camera)));
                return made;
            }
        }
    }

    /// <summary>Layout of a file of voxels. Required: width, height, depth.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct RawDesc
    {
        /// <summary>set by shd_raw_desc_default()</summary>
        public uint StructSize;
        /// <summary>voxels along x, 1..65536; width * height * depth at most 2^28</summary>
        public uint Width;
        /// <summary>voxels along y, 1..65536</summary>
        public uint Height;
        /// <summary>voxels along z, 1..65536</summary>
        public uint Depth;
        /// <summary>default RawSample.U8</summary>
        public RawSample Sample;
        /// <summary>numbers of a voxel, one behind the other, 1..4; default 1</summary>
        public uint Channels;
        /// <summary>default ByteOrder.Little</summary>
        public ByteOrder ByteOrder;
        /// <summary>reserved; 0</summary>
        public uint Flags;
        /// <summary>bytes before the first voxel, or SHD_RAW_HEADER_REST; default 0</summary>
        public ulong HeaderBytes;

        /// <summary>The defaults of the library.</summary>
        public static RawDesc Default
        {
            get
            {
                RawDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.RawDesc, &made, (UIntPtr)sizeof(RawDesc)));
                return made;
            }
        }
    }

    /// <summary>Properties of a loaded grid.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct VdbInfo
    {
        /// <summary>set by shd_vdb_info_default()</summary>
        public uint StructSize;
        /// <summary>as declared by the file</summary>
        public VdbClass GridClass;
        /// <summary>voxel of texel (0, 0, 0), in index space</summary>
        public Int3 IndexMin;
        /// <summary>value of all voxels that the file does not store</summary>
        public float Background;
        /// <summary>in the whole grid</summary>
        public ulong ActiveVoxels;
        /// <summary>
        /// from texture coordinates (u, v, w) to the world of the file, column-major: for
        /// VolumeDraw, if the box of the volume is the default box
        /// </summary>
        public Matrix4 ObjectToWorld;
        /// <summary>name of the grid; its first 63 bytes, control characters replaced</summary>
        public Bytes64 Grid;

        /// <summary>The defaults of the library.</summary>
        public static VdbInfo Default
        {
            get
            {
                VdbInfo made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.VdbInfo, &made, (UIntPtr)sizeof(VdbInfo)));
                return made;
            }
        }
    }

    /// <summary>64 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Bytes64
    {
        public const int Length = 64;
        private byte e0, e1, e2, e3, e4, e5, e6, e7;
        private byte e8, e9, e10, e11, e12, e13, e14, e15;
        private byte e16, e17, e18, e19, e20, e21, e22, e23;
        private byte e24, e25, e26, e27, e28, e29, e30, e31;
        private byte e32, e33, e34, e35, e36, e37, e38, e39;
        private byte e40, e41, e42, e43, e44, e45, e46, e47;
        private byte e48, e49, e50, e51, e52, e53, e54, e55;
        private byte e56, e57, e58, e59, e60, e61, e62, e63;
        /// <summary>Element 0 .. 63.</summary>
        public byte this[int index]
        {
            get { Inline.Check(index, Length); fixed (byte* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (byte* first = &e0) first[index] = value; }
        }
    }

    /// <summary>4 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Channel4
    {
        public const int Length = 4;
        private Channel e0, e1, e2, e3;
        /// <summary>Element 0 .. 3.</summary>
        public Channel this[int index]
        {
            get { Inline.Check(index, Length); fixed (Channel* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (Channel* first = &e0) first[index] = value; }
        }
    }

    /// <summary>3 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Double3
    {
        public const int Length = 3;
        private double e0, e1, e2;
        /// <summary>Element 0 .. 2.</summary>
        public double this[int index]
        {
            get { Inline.Check(index, Length); fixed (double* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (double* first = &e0) first[index] = value; }
        }
    }

    /// <summary>2 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Float2
    {
        public const int Length = 2;
        public float X, Y;
        public Float2(float x, float y)
        { X = x; Y = y; }
        /// <summary>Element 0 .. 1.</summary>
        public float this[int index]
        {
            get { Inline.Check(index, Length); fixed (float* first = &X) return first[index]; }
            set { Inline.Check(index, Length); fixed (float* first = &X) first[index] = value; }
        }
    }

    /// <summary>3 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Float3
    {
        public const int Length = 3;
        public float X, Y, Z;
        public Float3(float x, float y, float z)
        { X = x; Y = y; Z = z; }
        /// <summary>Element 0 .. 2.</summary>
        public float this[int index]
        {
            get { Inline.Check(index, Length); fixed (float* first = &X) return first[index]; }
            set { Inline.Check(index, Length); fixed (float* first = &X) first[index] = value; }
        }
    }

    /// <summary>4 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Float4
    {
        public const int Length = 4;
        public float X, Y, Z, W;
        public Float4(float x, float y, float z, float w)
        { X = x; Y = y; Z = z; W = w; }
        /// <summary>Element 0 .. 3.</summary>
        public float this[int index]
        {
            get { Inline.Check(index, Length); fixed (float* first = &X) return first[index]; }
            set { Inline.Check(index, Length); fixed (float* first = &X) first[index] = value; }
        }
    }

    /// <summary>6 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Float6
    {
        public const int Length = 6;
        private float e0, e1, e2, e3, e4, e5;
        /// <summary>Element 0 .. 5.</summary>
        public float this[int index]
        {
            get { Inline.Check(index, Length); fixed (float* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (float* first = &e0) first[index] = value; }
        }
    }

    /// <summary>8 x 4 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Float8x4
    {
        public const int Length = 32;
        private float e0, e1, e2, e3, e4, e5, e6, e7;
        private float e8, e9, e10, e11, e12, e13, e14, e15;
        private float e16, e17, e18, e19, e20, e21, e22, e23;
        private float e24, e25, e26, e27, e28, e29, e30, e31;
        /// <summary>Element 0 .. 31.</summary>
        public float this[int index]
        {
            get { Inline.Check(index, Length); fixed (float* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (float* first = &e0) first[index] = value; }
        }
        public float this[int row, int column]
        {
            get { Inline.Check(column, 4); return this[row * 4 + column]; }
            set { Inline.Check(column, 4); this[row * 4 + column] = value; }
        }
    }

    /// <summary>3 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Int3
    {
        public const int Length = 3;
        public int X, Y, Z;
        public Int3(int x, int y, int z)
        { X = x; Y = y; Z = z; }
        /// <summary>Element 0 .. 2.</summary>
        public int this[int index]
        {
            get { Inline.Check(index, Length); fixed (int* first = &X) return first[index]; }
            set { Inline.Check(index, Length); fixed (int* first = &X) first[index] = value; }
        }
    }

    /// <summary>9 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Matrix3
    {
        public const int Length = 9;
        private float e0, e1, e2, e3, e4, e5, e6, e7;
        private float e8;
        /// <summary>Element 0 .. 8.</summary>
        public float this[int index]
        {
            get { Inline.Check(index, Length); fixed (float* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (float* first = &e0) first[index] = value; }
        }
    }

    /// <summary>16 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Matrix4
    {
        public const int Length = 16;
        private float e0, e1, e2, e3, e4, e5, e6, e7;
        private float e8, e9, e10, e11, e12, e13, e14, e15;
        /// <summary>Element 0 .. 15.</summary>
        public float this[int index]
        {
            get { Inline.Check(index, Length); fixed (float* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (float* first = &e0) first[index] = value; }
        }
    }

    /// <summary>3 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct UInt3
    {
        public const int Length = 3;
        public uint X, Y, Z;
        public UInt3(uint x, uint y, uint z)
        { X = x; Y = y; Z = z; }
        /// <summary>Element 0 .. 2.</summary>
        public uint this[int index]
        {
            get { Inline.Check(index, Length); fixed (uint* first = &X) return first[index]; }
            set { Inline.Check(index, Length); fixed (uint* first = &X) first[index] = value; }
        }
    }

    /// <summary>4 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct UInt4
    {
        public const int Length = 4;
        public uint X, Y, Z, W;
        public UInt4(uint x, uint y, uint z, uint w)
        { X = x; Y = y; Z = z; W = w; }
        /// <summary>Element 0 .. 3.</summary>
        public uint this[int index]
        {
            get { Inline.Check(index, Length); fixed (uint* first = &X) return first[index]; }
            set { Inline.Check(index, Length); fixed (uint* first = &X) first[index] = value; }
        }
    }
}
