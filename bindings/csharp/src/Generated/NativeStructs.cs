// SPDX-License-Identifier: MIT
// Written by generate.py; do not edit.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd.Native
{
    /// <summary>Options of a bake; nothing is required.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct BakeDesc
    {
        /// <summary>set by shd_bake_desc_default()</summary>
        public uint StructSize;
        /// <summary>texture coordinates at which triangles lie: 0 = uv of the mesh, 1 = uv1; default 0</summary>
        public uint UvSet;
        /// <summary>
        /// Largest distance [texels], 0..1024, over which empty texels get a copy of the nearest shaded texel, in all planes
        /// except depth: seams then do not mix with the background when the texture is filtered. Distances are between
        /// centres; of equally near texels the one in the upper row is copied, then the left one. Default 0 = none.
        /// </summary>
        public uint Dilation;
        /// <summary>reserved; 0</summary>
        public uint Flags;
        /// <summary>TexelState of width * height texels; default not wanted</summary>
        public U32Out States;
        /// <summary>its struct_size is read; NULL = not wanted; all zero on failure</summary>
        public BakeStats* Stats;

        /// <summary>The defaults of the library.</summary>
        public static BakeDesc Default
        {
            get
            {
                BakeDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.BakeDesc, &made, (UIntPtr)sizeof(BakeDesc)));
                return made;
            }
        }
    }

    /// <summary>Source of the config. Zero is the default of each field. Strings are borrowed for the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ColorDesc
    {
        /// <summary>set by shd_color_desc_default()</summary>
        public uint StructSize;
        /// <summary>precision of 8-bit images; default DisplayPrecision.Baked</summary>
        public DisplayPrecision DisplayPrecision;
        /// <summary>
        /// path of a config file, at most 64 MiB; NULL = the file named by the environment
        /// variable OCIO if it is set and not empty, else the built-in config. The config
        /// and the tables that it names must be regular files
        /// </summary>
        public byte* ConfigPath;
        /// <summary>a config in memory (YAML); then config_path must be NULL and OCIO is not read</summary>
        public byte* ConfigText;
        /// <summary>colour space or role of framebuffers; NULL = the role scene_linear</summary>
        public byte* WorkingSpace;

        /// <summary>The defaults of the library.</summary>
        public static ColorDesc Default
        {
            get
            {
                ColorDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ColorDesc, &made, (UIntPtr)sizeof(ColorDesc)));
                return made;
            }
        }
    }

    /// <summary>A display and one of its views: user_data of a Display whose callback is shd_color_apply_view(). Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ColorView
    {
        /// <summary>required; borrowed for the call that takes the Display</summary>
        public IntPtr Color;
        /// <summary>NULL = the config's default</summary>
        public byte* Display;
        /// <summary>NULL = the display's default</summary>
        public byte* View;
    }

    /// <summary>Column of floats that shd reads. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct F32In
    {
        /// <summary>first element; NULL = the column is absent</summary>
        public float* Data;
        /// <summary>bytes between elements; 0 = packed</summary>
        public long Stride { get { return (long)strideWord; } set { strideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr strideWord;
    }

    /// <summary>Column of floats that shd writes. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct F32Out
    {
        /// <summary>first element; NULL = not wanted</summary>
        public float* Data;
        /// <summary>bytes between elements; 0 = packed</summary>
        public long Stride { get { return (long)strideWord; } set { strideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr strideWord;
    }

    /// <summary>Column of 32-bit unsigned integers that shd reads. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct U32In
    {
        /// <summary>first element; NULL = the column is absent</summary>
        public uint* Data;
        /// <summary>bytes between elements; 0 = packed</summary>
        public long Stride { get { return (long)strideWord; } set { strideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr strideWord;
    }

    /// <summary>Column of 32-bit unsigned integers that shd writes. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct U32Out
    {
        /// <summary>first element; NULL = not wanted</summary>
        public uint* Data;
        /// <summary>bytes between elements; 0 = packed</summary>
        public long Stride { get { return (long)strideWord; } set { strideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr strideWord;
    }

    /// <summary>Column of 16-bit unsigned integers that shd reads. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct U16In
    {
        /// <summary>first element; NULL = the column is absent</summary>
        public ushort* Data;
        /// <summary>bytes between elements; 0 = packed</summary>
        public long Stride { get { return (long)strideWord; } set { strideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr strideWord;
    }

    /// <summary>
    /// Host memory. Frozen.
    ///
    /// Set both callbacks or neither (then malloc and free). They run on any thread, workers of the executor included. They
    /// must not throw, longjmp or call shd.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Allocator
    {
        /// <summary>Returns `size` &gt; 0 bytes aligned to `alignment` (a power of two, at least 8), or NULL.</summary>
        public IntPtr Allocate;
        /// <summary>
        /// Frees memory that `allocate` returned. `size` and `alignment` are those of its allocation; `memory` is never
        /// NULL.
        /// </summary>
        public IntPtr Free;
        /// <summary>passed to both; borrowed until release of the context</summary>
        public void* UserData;
    }

    /// <summary>
    /// Host job system. Frozen.
    ///
    /// Zero = the built-in executor: oneTBB if the library was built with it, else the calling thread. The built-in executor
    /// also uses the calling thread if no thread can be started, in contexts that a child process inherits by fork(), and in
    /// all contexts of a child whose parent has used oneTBB.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Executor
    {
        /// <summary>
        /// Runs task(task_data, i, worker) once for every i in [0, count), in any order and on any threads, and returns when
        /// all are done. Tasks that run concurrently must have different values of `worker`. A result other than Result.Ok
        /// makes the call of shd fail with Result.ErrorCallback. Runs on the thread that called shd; must not throw or
        /// longjmp; may call shd.
        /// </summary>
        public IntPtr ParallelFor;
        /// <summary>borrowed until release of the context</summary>
        public void* UserData;
        /// <summary>
        /// `worker` is below this number, 1..1024; scratch memory is allocated for this number
        /// of workers
        /// </summary>
        public uint WorkerCount;
    }

    /// <summary>Host log. Frozen. Without a log shd writes nothing: it never uses stdout or stderr.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Log
    {
        /// <summary>Takes one line without newline. Any thread, calls may be concurrent; must not throw, longjmp or call shd.</summary>
        public IntPtr Write;
        /// <summary>borrowed until release of the context</summary>
        public void* UserData;
    }

    /// <summary>Options of a context. Zero is the default of each.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ContextDesc
    {
        /// <summary>set by shd_context_desc_default()</summary>
        public uint StructSize;
        /// <summary>default 0</summary>
        public ContextFlags Flags;
        /// <summary>
        /// threads of the built-in executor, 0..1024, at most one per core; 1 = calling thread;
        /// default 0 = one per core
        /// </summary>
        public uint WorkerCount;
        /// <summary>default Simd.Best; Result.ErrorUnsupported if it cannot run here</summary>
        public Simd Simd;
        /// <summary>default malloc and free; huge pages are requested for blocks of 8 MiB and more</summary>
        public Allocator Allocator;
        /// <summary>default built-in</summary>
        public Executor Executor;
        /// <summary>default none</summary>
        public Log Log;

        /// <summary>The defaults of the library.</summary>
        public static ContextDesc Default
        {
            get
            {
                ContextDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ContextDesc, &made, (UIntPtr)sizeof(ContextDesc)));
                return made;
            }
        }
    }

    /// <summary>Columns for edges; NULL = not wanted.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Edges
    {
        /// <summary>set by shd_edges_default()</summary>
        public uint StructSize;
        /// <summary>the two ends, in the direction of the first triangle</summary>
        public U32Out2 Vertex;
        /// <summary>the first triangle, and the other one; 0xffffffff for borders and non-manifold edges</summary>
        public U32Out2 Triangle;
        /// <summary>EdgeFlags bits, among the requested ones</summary>
        public U32Out Kinds;

        /// <summary>The defaults of the library.</summary>
        public static Edges Default
        {
            get
            {
                Edges made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Edges, &made, (UIntPtr)sizeof(Edges)));
                return made;
            }
        }
    }

    /// <summary>Image and tables of an environment. Required: image.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct EnvironmentDesc
    {
        /// <summary>set by shd_environment_desc_default()</summary>
        public uint StructSize;
        /// <summary>any but Projection.None; default Projection.LatLong</summary>
        public Projection Projection;
        /// <summary>
        /// Linear radiance, of any format and of 1 x 1 up to 2^26 pixels; borrowed for the call. One channel means grey; the
        /// fourth is ignored. CUBE takes the six faces on top of each other: height = 6 width. MIRROR_BALL, ANGULAR and
        /// OCTAHEDRAL are square. Channels that are negative or NaN count as 0, and those above 1e12 as 1e12;
        /// EnvironmentInfo counts them.
        /// </summary>
        public Image* Image;
        /// <summary>default Irradiance.Harmonics</summary>
        public Irradiance Irradiance;
        /// <summary>default EnvironmentTables.All</summary>
        public EnvironmentTables Tables;

        /// <summary>The defaults of the library.</summary>
        public static EnvironmentDesc Default
        {
            get
            {
                EnvironmentDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.EnvironmentDesc, &made, (UIntPtr)sizeof(EnvironmentDesc)));
                return made;
            }
        }
    }

    /// <summary>Lookups of an environment, as columns of `count` elements.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct EnvironmentLookups
    {
        /// <summary>set by shd_environment_lookups_default()</summary>
        public uint StructSize;
        /// <summary>number of lookups; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>x, y, z, any length; required. 0, NaN and infinity count as +Z</summary>
        public F32In3 Direction;
        /// <summary>
        /// Roughness of a GGX lobe around the direction, clamped to 0..1, NaN = 1: the mean of the radiance, weighted by
        /// D(h) n.l with n = v = direction (Karis, "Real Shading in Unreal Engine 4", 2013). Only for environments with
        /// EnvironmentTables.Ggx.
        /// </summary>
        public F32In Roughness;
        /// <summary>
        /// Exponent p of a Phong lobe around the direction r, clamped to 0..1e6, NaN = 0: the mean of the radiance, weighted
        /// by max(0, r.l)^p. Only for environments with EnvironmentTables.Phong. Without roughness and exponent, lookups
        /// give the radiance itself.
        /// </summary>
        public F32In Exponent;

        /// <summary>The defaults of the library.</summary>
        public static EnvironmentLookups Default
        {
            get
            {
                EnvironmentLookups made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.EnvironmentLookups, &made, (UIntPtr)sizeof(EnvironmentLookups)));
                return made;
            }
        }
    }

    /// <summary>Columns for irradiance or radiance; NULL = not wanted.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct EnvironmentLight
    {
        /// <summary>set by shd_environment_light_default()</summary>
        public uint StructSize;
        /// <summary>red, green, blue; irradiance, or radiance in the unit of the image</summary>
        public F32Out3 Rgb;

        /// <summary>The defaults of the library.</summary>
        public static EnvironmentLight Default
        {
            get
            {
                EnvironmentLight made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.EnvironmentLight, &made, (UIntPtr)sizeof(EnvironmentLight)));
                return made;
            }
        }
    }

    /// <summary>An explanation, with the caller's memory for its tables.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Explanation
    {
        /// <summary>set by shd_explanation_default()</summary>
        public uint StructSize;
        /// <summary>[tap_capacity]; gets the first taps; NULL with a capacity of 0</summary>
        public Tap* Taps;
        /// <summary>[blend_capacity]; gets the first blends; NULL with a capacity of 0</summary>
        public BlendStep* Blends;
        /// <summary>bytes of the caller's Tap; set by shd_explanation_default()</summary>
        public uint TapSize;
        /// <summary>elements of `taps`</summary>
        public uint TapCapacity;
        /// <summary>written: taps of the lookup</summary>
        public uint TapCount;
        /// <summary>bytes of the caller's BlendStep; set by shd_explanation_default()</summary>
        public uint BlendSize;
        /// <summary>elements of `blends`</summary>
        public uint BlendCapacity;
        /// <summary>written: blends of the lookup; fewer than taps</summary>
        public uint BlendCount;
        /// <summary>written: the filter that was used, after magnification</summary>
        public Filter Filter;
        /// <summary>written: r, g, b, a of shd_texture_sample() with Precision.Full</summary>
        public Float4 Result;
        /// <summary>written: level of detail of trilinear in the profile, after bias and clamps</summary>
        public float Lod;
        /// <summary>written: factor from the blends' units to the result, by stored channel</summary>
        public Float4 ScaleHigh;
        /// <summary>written: lower bits of that factor</summary>
        public Float4 ScaleLow;
        /// <summary>Written: the stored channel of r, g, b, a of the result; 4 = a constant: `fill`, or 0, 0, 1 of comparisons.</summary>
        public UInt4 ChannelSource;
        /// <summary>
        /// Written: longer half axis of the footprint's ellipse, u and v in base-level texels, width and blur included;
        /// (2^lod, 0) if the lookup has a level of detail. At most 2^100 long. 3D textures: the first two components.
        /// </summary>
        public Float2 LongerAxis;
        /// <summary>written: the shorter half axis, before any limit of anisotropy; 0 for 3D textures</summary>
        public Float2 ShorterAxis;

        /// <summary>The defaults of the library.</summary>
        public static Explanation Default
        {
            get
            {
                Explanation made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Explanation, &made, (UIntPtr)sizeof(Explanation)));
                return made;
            }
        }
    }

    /// <summary>Columns for derivatives per pixel step; NULL = not wanted.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Derivatives
    {
        /// <summary>set by shd_derivatives_default()</summary>
        public uint StructSize;
        /// <summary>du/dx</summary>
        public F32Out Dudx;
        /// <summary>dv/dx</summary>
        public F32Out Dvdx;
        /// <summary>du/dy</summary>
        public F32Out Dudy;
        /// <summary>dv/dy</summary>
        public F32Out Dvdy;

        /// <summary>The defaults of the library.</summary>
        public static Derivatives Default
        {
            get
            {
                Derivatives made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Derivatives, &made, (UIntPtr)sizeof(Derivatives)));
                return made;
            }
        }
    }

    /// <summary>Hits of rays with their differentials, as columns of `count` elements; x, y, z in one space.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct RayDifferentials
    {
        /// <summary>set by shd_ray_differentials_default()</summary>
        public uint StructSize;
        /// <summary>number of hits; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>change of the surface point with u; required</summary>
        public F32In3 Dpdu;
        /// <summary>change of the surface point with v; required</summary>
        public F32In3 Dpdv;
        /// <summary>direction of the ray, any length; required</summary>
        public F32In3 Direction;
        /// <summary>distance to the hit, in lengths of `direction`; absent = 0</summary>
        public F32In Distance;
        /// <summary>change of the ray's origin per pixel step in x; absent = 0</summary>
        public F32In3 OriginDx;
        /// <summary>change of the ray's origin per pixel step in y; absent = 0</summary>
        public F32In3 OriginDy;
        /// <summary>change of `direction` per pixel step in x; absent = 0</summary>
        public F32In3 DirectionDx;
        /// <summary>change of `direction` per pixel step in y; absent = 0</summary>
        public F32In3 DirectionDy;

        /// <summary>The defaults of the library.</summary>
        public static RayDifferentials Default
        {
            get
            {
                RayDifferentials made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.RayDifferentials, &made, (UIntPtr)sizeof(RayDifferentials)));
                return made;
            }
        }
    }

    /// <summary>Hits of rays with their cones, as columns of `count` elements; x, y, z in one space.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct RayCones
    {
        /// <summary>set by shd_ray_cones_default()</summary>
        public uint StructSize;
        /// <summary>number of hits; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>change of the surface point with u; required</summary>
        public F32In3 Dpdu;
        /// <summary>change of the surface point with v; required</summary>
        public F32In3 Dpdv;
        /// <summary>direction of the ray, any length; required</summary>
        public F32In3 Direction;
        /// <summary>diameter of the cone at the hit, in the units of the points; required</summary>
        public F32In Width;

        /// <summary>The defaults of the library.</summary>
        public static RayCones Default
        {
            get
            {
                RayCones made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.RayCones, &made, (UIntPtr)sizeof(RayCones)));
                return made;
            }
        }
    }

    /// <summary>
    /// Points to shade, one row each, as packed columns of `count` elements; borrowed for the call.
    ///
    /// A row is a visible fragment at Phong frequency, a vertex at Gouraud frequency, and a triangle's centroid at flat
    /// frequency. For vertices and centroids x, y, depth and the derivatives are 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Fragments
    {
        /// <summary>size of the library's struct</summary>
        public uint StructSize;
        /// <summary>index into RenderDesc.draws; the same for every row</summary>
        public uint Draw;
        /// <summary>index into Draw.instances, 0 without instances; the same for every row</summary>
        public uint Instance;
        /// <summary>MaterialDesc.varying_count</summary>
        public uint VaryingCount;
        /// <summary>number of `attribute` columns</summary>
        public uint AttributeCount;
        /// <summary>rows</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>Draw.uniforms</summary>
        public void* Uniforms;
        /// <summary>
        /// Raster position, pixels from the left edge. It is the centre of the pixel, or the mean of the covered samples if
        /// there are several samples and the triangle does not cover the centre. With DrawFlags.SampleShading it is the
        /// position of the sample.
        /// </summary>
        public float* X;
        /// <summary>raster position, pixels from the top edge, as x</summary>
        public float* Y;
        /// <summary>depth-buffer value, 0 near .. 1 far</summary>
        public float* Depth;
        /// <summary>index of the triangle in its mesh</summary>
        public uint* Triangle;
        /// <summary>position, world space</summary>
        public float* Px;
        /// <summary>position, world space</summary>
        public float* Py;
        /// <summary>position, world space</summary>
        public float* Pz;
        /// <summary>shading normal, world space, unit</summary>
        public float* Nx;
        /// <summary>shading normal, world space, unit</summary>
        public float* Ny;
        /// <summary>shading normal, world space, unit</summary>
        public float* Nz;
        /// <summary>wo: towards the eye, world space, unit (0 at the eye itself)</summary>
        public float* Ox;
        /// <summary>wo: towards the eye, world space, unit (0 at the eye itself)</summary>
        public float* Oy;
        /// <summary>wo: towards the eye, world space, unit (0 at the eye itself)</summary>
        public float* Oz;
        /// <summary>
        /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
        /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
        /// </summary>
        public float* Tx;
        /// <summary>
        /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
        /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
        /// </summary>
        public float* Ty;
        /// <summary>
        /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
        /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
        /// </summary>
        public float* Tz;
        /// <summary>
        /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
        /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
        /// </summary>
        public float* Tw;
        /// <summary>texture coordinates, perspective-correct</summary>
        public float* U;
        /// <summary>texture coordinates, perspective-correct</summary>
        public float* V;
        /// <summary>second set of texture coordinates; 0 if the mesh has none</summary>
        public float* U1;
        /// <summary>second set of texture coordinates; 0 if the mesh has none</summary>
        public float* V1;
        /// <summary>analytic derivatives of u, v along one pixel to the right</summary>
        public float* Dudx;
        /// <summary>analytic derivatives of u, v along one pixel to the right</summary>
        public float* Dvdx;
        /// <summary>analytic derivatives of u, v along one pixel down</summary>
        public float* Dudy;
        /// <summary>analytic derivatives of u, v along one pixel down</summary>
        public float* Dvdy;
        /// <summary>[attribute_count] columns of the mesh, interpolated; NULL for absent ones</summary>
        public float** Attribute;
        /// <summary>
        /// [varying_count] columns of the vertex program, interpolated by MaterialDesc.interpolation. At Gouraud
        /// frequency they are the values of the vertex, at flat frequency the mean of the triangle's three vertices. FLAT
        /// varyings have the value of the first vertex at every frequency.
        /// </summary>
        public float** Varying;
    }

    /// <summary>Output of a program: scene-linear, premultiplied by a. r, g, b start as 0 and a as 1.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Radiance
    {
        /// <summary>size of the library's struct</summary>
        public uint StructSize;
        /// <summary>number of `target` elements: 3</summary>
        public uint TargetCount;
        /// <summary>packed columns of `count` elements</summary>
        public float* R;
        /// <summary>packed columns of `count` elements</summary>
        public float* G;
        /// <summary>packed columns of `count` elements</summary>
        public float* B;
        /// <summary>packed columns of `count` elements</summary>
        public float* A;
        /// <summary>starts as 0; any other value drops the row. NULL without MaterialFlags.Discards</summary>
        public uint* Discard;
        /// <summary>
        /// [target_count] r, g, b, a of AovFlags.Target1, 2 and 3; start as 0. NULL for
        /// targets that the framebuffer lacks
        /// </summary>
        public float** Target;
    }

    /// <summary>A plane in place: no copy.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PlaneView
    {
        /// <summary>set by shd_plane_view_default()</summary>
        public uint StructSize;
        /// <summary>[height][row_stride / 4]; NULL for planes of uint32_t</summary>
        public float* F32;
        /// <summary>[height][row_stride / 4]; NULL for planes of floats</summary>
        public uint* U32;
        /// <summary>bytes between rows</summary>
        public long RowStride { get { return (long)rowStrideWord; } set { rowStrideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr rowStrideWord;

        /// <summary>The defaults of the library.</summary>
        public static PlaneView Default
        {
            get
            {
                PlaneView made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.PlaneView, &made, (UIntPtr)sizeof(PlaneView)));
                return made;
            }
        }
    }

    /// <summary>Conversion of linear colour for a display: a transform of libshd_color, or a function of the caller. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Display
    {
        /// <summary>
        /// Fills every pixel of `out`, a packed RGBA32F image of the framebuffer's size, with display colour: encoded,
        /// straight alpha, 0..1. Runs on the thread of the call that takes the Display; must not throw or longjmp. A
        /// result other than Result.Ok, with its text from shd_report_error(), becomes the result of the call. NULL = none.
        /// </summary>
        public IntPtr Apply;
        /// <summary>borrowed for the call</summary>
        public void* UserData;
    }

    /// <summary>An image in the caller's memory. Required: format, width, height, pixels.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Image
    {
        /// <summary>set by shd_image_default()</summary>
        public uint StructSize;
        /// <summary>storage of `pixels`</summary>
        public Format Format;
        /// <summary>pixels, 1..65536</summary>
        public uint Width;
        /// <summary>pixels, 1..65536</summary>
        public uint Height;
        /// <summary>
        /// [height][width], row 0 on top; borrowed for the call; blocks are
        /// [ceil(height / 4)][ceil(width / 4)]
        /// </summary>
        public void* Pixels;
        /// <summary>bytes between rows of pixels or blocks, at least the bytes of a row; 0 = packed</summary>
        public long RowStride { get { return (long)rowStrideWord; } set { rowStrideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr rowStrideWord;

        /// <summary>The defaults of the library.</summary>
        public static Image Default
        {
            get
            {
                Image made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Image, &made, (UIntPtr)sizeof(Image)));
                return made;
            }
        }
    }

    /// <summary>Options and budgets of a load. A budget that would be exceeded is Result.ErrorLimit.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct LoadDesc
    {
        /// <summary>set by shd_load_desc_default()</summary>
        public uint StructSize;
        /// <summary>formats to accept; default 0 = FileFormatFlags.Default</summary>
        public FileFormatFlags Formats;
        /// <summary>default none</summary>
        public LoadFlags Flags;
        /// <summary>default AUTO; other values override the file's declaration</summary>
        public ColorEncoding ColorSpace;
        /// <summary>tables of textures; default TableFlags.Mipmap</summary>
        public TableFlags Tables;
        /// <summary>part of a multi-part EXR, page of a TIFF, frame of a GIF; default 0</summary>
        public uint Subimage;
        /// <summary>size of the file; 0 = 2^30</summary>
        public ulong MaxFileBytes;
        /// <summary>
        /// width * height, of the data and of the display window, and the pixels of all
        /// levels with LoadFlags.FileLevels; 0 = 2^28
        /// </summary>
        public ulong MaxPixels;
        /// <summary>decoded, as RGBA, all levels; 0 = 2^32</summary>
        public ulong MaxBytes;
        /// <summary>decoded bytes per file byte, for more than 2^24 decoded; 0 = 4000</summary>
        public double MaxRatio;
        /// <summary>
        /// [s], 0 = 60; kills the child that decodes. With LoadFlags.InProcess it is
        /// checked between bands of rows. A worker that is stopped (SIGSTOP, a debugger)
        /// costs a load all of its time; when it has been silent for two seconds, the
        /// next load starts another one
        /// </summary>
        public double TimeLimit;
        /// <summary>
        /// program that decodes, relative to the working directory at the call; NULL =
        /// shd-io-worker beside libshd_io or in its installed place; borrowed for the
        /// call
        /// </summary>
        public byte* WorkerPath;
        /// <summary>
        /// textures: the file is voxels of this layout; borrowed for the call; default
        /// NULL
        /// </summary>
        public RawDesc* Raw;
        /// <summary>
        /// textures: slices of a 3D texture from the files of the desc, without a path;
        /// borrowed for the call; default NULL
        /// </summary>
        public StackDesc* Stack;
        /// <summary>
        /// textures: grid and box of an OpenVDB file; borrowed for the call; default NULL
        /// = the first grid of float or double, if the content is OpenVDB
        /// </summary>
        public VdbDesc* Vdb;
        /// <summary>
        /// textures: gets the contents of a KTX2 or DDS file; all zero on failure and for
        /// other files, and its struct_size is read; default NULL
        /// </summary>
        public TextureFileInfo* Info;
        /// <summary>
        /// textures: gets the properties of an OpenVDB grid; all zero on failure and for
        /// other files, and its struct_size is read; default NULL
        /// </summary>
        public VdbInfo* VdbInfo;

        /// <summary>The defaults of the library.</summary>
        public static LoadDesc Default
        {
            get
            {
                LoadDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.LoadDesc, &made, (UIntPtr)sizeof(LoadDesc)));
                return made;
            }
        }
    }

    /// <summary>Options of a save.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SaveDesc
    {
        /// <summary>set by shd_save_desc_default()</summary>
        public uint StructSize;
        /// <summary>
        /// a framebuffer's colour: PNG 8 or 16, EXR 16 or 32, TIFF 8, 16 or 32;
        /// default 0 = 8 for PNG, 16 for EXR, 32 for TIFF. For images always 0
        /// </summary>
        public uint BitDepth;
        /// <summary>
        /// framebuffers in 8 and 16 bits: AUTO and SRGB apply the sRGB curve, LINEAR and
        /// DATA do not. Images: the tag of PNG and EXR; AUTO = by pixel format
        /// </summary>
        public ColorEncoding ColorSpace;
        /// <summary>a framebuffer's colour in 8 and 16 bits; default none</summary>
        public Dither Dither;
        /// <summary>
        /// Replaces the sRGB curve of a framebuffer in 8 and 16 bits; see shd_color_apply_view() in shd/color.h. Default
        /// none.
        /// </summary>
        public Display Display;

        /// <summary>The defaults of the library.</summary>
        public static SaveDesc Default
        {
            get
            {
                SaveDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.SaveDesc, &made, (UIntPtr)sizeof(SaveDesc)));
                return made;
            }
        }
    }

    /// <summary>Kind, intensity and placement of a light.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct LightDesc
    {
        /// <summary>set by shd_light_desc_default()</summary>
        public uint StructSize;
        /// <summary>default LightKind.Point</summary>
        public LightKind Kind;
        /// <summary>
        /// I, scene-linear RGB, 0..1e12; default 1. Points and spots: E = 1 at distance r takes
        /// I = r^2
        /// </summary>
        public Float3 Intensity;
        /// <summary>
        /// position of points, spots and the cookie of directional lights; world space, finite;
        /// default 0
        /// </summary>
        public Float3 Position;
        /// <summary>
        /// directional lights and spots: direction of the light rays, world space, any length
        /// except 0; default (0, -1, 0)
        /// </summary>
        public Float3 Direction;
        /// <summary>
        /// points and spots: distance from which E is 0 [world units]; default 0 = no limit. Lights
        /// with a finite range are culled beyond it
        /// </summary>
        public float Range;
        /// <summary>spots: half angle of the full cone [rad], 0..outer_angle; default 0</summary>
        public float InnerAngle;
        /// <summary>
        /// spots: half angle of the cone [rad], 0.001..pi/2, with a cookie up to 1.55; default
        /// pi/4
        /// </summary>
        public float OuterAngle;
        /// <summary>
        /// up direction of the cookie and of shadow maps, world space. Orthogonalised against
        /// `direction`; replaced by another direction if parallel to it. Default (0, 1, 0)
        /// </summary>
        public Float3 Up;
        /// <summary>
        /// directional lights: width and height of the cookie [world units], above 0; default 1.
        /// The centre of the cookie lies on the ray from `position`; with wraps that repeat, the
        /// cookie tiles the plane
        /// </summary>
        public Float2 Extent;
        /// <summary>
        /// Light cookie: a texture of colours that multiply E, as seen from the light. It covers the square around the outer
        /// cone of a spot, or a rectangle of size `extent` for a directional light. The fourth channel is ignored. Points
        /// and ambient lights have no cookie. NULL = none; retained.
        /// </summary>
        public IntPtr Texture;
        /// <summary>sampler of `texture`; NULL = bilinear, black outside; retained</summary>
        public IntPtr Sampler;

        /// <summary>The defaults of the library.</summary>
        public static LightDesc Default
        {
            get
            {
                LightDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.LightDesc, &made, (UIntPtr)sizeof(LightDesc)));
                return made;
            }
        }
    }

    /// <summary>Points to look up, as columns of `count` elements. Required: u, v. Absent columns are NULL.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Lookups
    {
        /// <summary>set by shd_lookups_default()</summary>
        public uint StructSize;
        /// <summary>number of lookups; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>normalised coordinate across; required</summary>
        public F32In U;
        /// <summary>normalised coordinate down; required</summary>
        public F32In V;
        /// <summary>du/dx per pixel step; absent = 0</summary>
        public F32In Dudx;
        /// <summary>dv/dx; absent = 0</summary>
        public F32In Dvdx;
        /// <summary>du/dy; absent = 0</summary>
        public F32In Dudy;
        /// <summary>dv/dy; absent = 0</summary>
        public F32In Dvdy;
        /// <summary>log2 of the footprint in base texels; replaces the derivatives, width and blur</summary>
        public F32In Lod;
        /// <summary>layer of the array; absent = 0; numbers beyond the last layer mean the last layer</summary>
        public U32In Layer;
        /// <summary>random bits of Filter.Stochastic; absent = hashed from u, v and, if read, w</summary>
        public U32In Random;
        /// <summary>
        /// third coordinate: across the slices of a 3D texture, or of a direction; required by these
        /// textures, without effect for others
        /// </summary>
        public F32In W;
        /// <summary>dw/dx per pixel step, where w has effect; absent = 0</summary>
        public F32In Dwdx;
        /// <summary>dw/dy; absent = 0</summary>
        public F32In Dwdy;
        /// <summary>compared with texels by samplers with `compares`; absent = 0</summary>
        public F32In Reference;

        /// <summary>The defaults of the library.</summary>
        public static Lookups Default
        {
            get
            {
                Lookups made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Lookups, &made, (UIntPtr)sizeof(Lookups)));
                return made;
            }
        }
    }

    /// <summary>Columns for the filtered values: linear, and premultiplied only if the texels are.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Texels
    {
        /// <summary>Set by shd_texels_default(). 0 is accepted for the layout of 0.1, so that `Texels texels = {0};` works.</summary>
        public uint StructSize;
        /// <summary>r, g, b, a after the texture's swizzle; NULL = not wanted</summary>
        public F32Out4 Channel;
        /// <summary>
        /// d/du and d/dv of the channels, with u and v normalised and the footprint held constant; NULL = not wanted.
        /// Available for BILINEAR, BICUBIC, BILINEAR_MIP, TRILINEAR, RIPMAP, ANISOTROPIC and EWA, and for a magnification
        /// filter in this list; other filters return Result.ErrorUnsupported. BILINEAR has kinks at texel centres; the result
        /// there is the derivative to the right. EWA has kinks where a texel enters the ellipse; the result there is the
        /// derivative of the weights. du, dv and dw of a texture of directions are the derivatives in the three components
        /// of the direction, not normalised, with the footprint held constant in the image.
        /// </summary>
        public F32Out4 Du;
        public F32Out4 Dv;
        /// <summary>written: lookups whose coordinates, derivatives or lod were not finite</summary>
        public long NonfiniteCount { get { return (long)nonfiniteCountWord; } set { nonfiniteCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr nonfiniteCountWord;
        /// <summary>
        /// d/dw of the channels of a 3D texture or of one of directions, as du; NULL = not wanted.
        /// 2D textures return Result.ErrorUnsupported
        /// </summary>
        public F32Out4 Dw;
        /// <summary>
        /// 0 for lookups that found all their tiles. With MissingTiles.Coarser, l + 1 if a tile of level l is missing
        /// and coarser levels were filtered instead. NULL = not wanted.
        /// </summary>
        public U32Out Coarser;

        /// <summary>The defaults of the library.</summary>
        public static Texels Default
        {
            get
            {
                Texels made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Texels, &made, (UIntPtr)sizeof(Texels)));
                return made;
            }
        }
    }

    /// <summary>Columns for levels of detail; NULL = not wanted.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Levels
    {
        /// <summary>set by shd_levels_default()</summary>
        public uint StructSize;
        /// <summary>continuous level of trilinear in the sampler's profile, after bias and clamps</summary>
        public F32Out Lod;
        /// <summary>nearest mip level: ceil(lod + 1/2) - 1, or the profile's</summary>
        public U32Out Level;

        /// <summary>The defaults of the library.</summary>
        public static Levels Default
        {
            get
            {
                Levels made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Levels, &made, (UIntPtr)sizeof(Levels)));
                return made;
            }
        }
    }

    /// <summary>
    /// Functions of the caller. Frozen.
    ///
    /// A C++ exception that reaches shd becomes Result.ErrorCallback. The frame is undefined if a program throws, longjmps or
    /// changes the count.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MaterialProgram
    {
        /// <summary>required for Model.Program, else NULL</summary>
        public IntPtr Fragment;
        /// <summary>for any model; NULL = only the matrices of view and draw</summary>
        public IntPtr Vertex;
        /// <summary>passed to both; borrowed until release</summary>
        public void* UserData;
    }

    /// <summary>Model and coefficients, scene-linear RGB.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MaterialDesc
    {
        /// <summary>set by shd_material_desc_default()</summary>
        public uint StructSize;
        /// <summary>default Model.Lambert</summary>
        public Model Model;
        /// <summary>shown instead of the model; default DebugView.None</summary>
        public DebugView DebugView;
        /// <summary>default none</summary>
        public MaterialFlags Flags;
        /// <summary>
        /// k_a, 0..1e6. Default -1 in all channels: k_a is ambient_share times the diffuse
        /// colour, k_d times its slot. SlotTarget.Ambient replaces the slot of the diffuse
        /// colour in this product
        /// </summary>
        public Float3 Ambient;
        /// <summary>
        /// 0..1; default 1/16; used if ambient is -1. METALLIC_ROUGHNESS multiplies k_a by its
        /// base colour in any case, so k_a is ambient_share there
        /// </summary>
        public float AmbientShare;
        /// <summary>k_d or base colour, 0..1e6; default 0.8</summary>
        public Float3 Diffuse;
        /// <summary>k_s, 0..1e6; default 0.5</summary>
        public Float3 Specular;
        /// <summary>p, 0..1e6; default 64</summary>
        public float Exponent;
        /// <summary>0..1; default 0</summary>
        public float Metallic;
        /// <summary>0..1; default 0.5</summary>
        public float Roughness;
        /// <summary>
        /// index of refraction of GLASS, and of METALLIC_ROUGHNESS for the part that is not
        /// metal, 1..10;
        /// default 1.5
        /// </summary>
        public float Ior;
        /// <summary>0..1e12; default 0, so a slot needs a larger value here</summary>
        public Float3 Emission;
        /// <summary>opacity of models, 0..1; default 1</summary>
        public float Opacity;
        /// <summary>effect of SlotTarget.Occlusion, 0..1; default 1</summary>
        public float OcclusionStrength;
        /// <summary>
        /// [slot_count], all with the same struct_size, at most one for each target;
        /// borrowed for the call; coefficients without a slot are constant
        /// </summary>
        public Slot* Slots;
        /// <summary>default 0</summary>
        public uint SlotCount;
        /// <summary>default NormalEncoding.Xyz</summary>
        public NormalEncoding NormalEncoding;
        /// <summary>factor of x and y of mapped normals, -1e3..1e3; default 1</summary>
        public float NormalScale;
        /// <summary>default Bump.None</summary>
        public Bump Bump;
        /// <summary>factor of heights, -1e6..1e6; default 1</summary>
        public float BumpScale;
        /// <summary>
        /// Depth of height 0 below the surface [world units], 0..1e6; height 1 lies on the surface. At Phong frequency, all
        /// textures with the uv set of the height are looked up at the point where the line of sight meets the height field
        /// (parallax occlusion mapping, Tatarchuk 2006). The triangles do not move. Default 0 = off.
        /// </summary>
        public float ParallaxDepth;
        /// <summary>maximum number of lookups of the height per fragment, 2..256; default 24</summary>
        public uint ParallaxSteps;
        /// <summary>warm colour of GOOCH, 0..1e6; default (0.4, 0.4, 0)</summary>
        public Float3 Warm;
        /// <summary>cool colour of GOOCH, 0..1e6; default (0, 0, 0.4)</summary>
        public Float3 Cool;
        /// <summary>share of k_d added to `warm`, 0..1; default 0.6</summary>
        public float WarmMix;
        /// <summary>share of k_d added to `cool`, 0..1; default 0.2</summary>
        public float CoolMix;
        /// <summary>steps of TOON, 1..256; default 3</summary>
        public uint ToonSteps;
        /// <summary>default Blend.Opaque</summary>
        public Blend Blend;
        /// <summary>fragments with a smaller alpha are dropped, 0..1; default 0 = none</summary>
        public float AlphaCutoff;
        /// <summary>default none</summary>
        public MaterialProgram Program;
        /// <summary>
        /// [varying_count]; borrowed for the call; NULL = all
        /// Interpolation.Perspective
        /// </summary>
        public Interpolation* Interpolation;
        /// <summary>
        /// varyings that program.vertex writes, 0..Constants.MaxVaryings; 0 without
        /// program.vertex
        /// </summary>
        public long VaryingCount { get { return (long)varyingCountWord; } set { varyingCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr varyingCountWord;
        /// <summary>
        /// Strength c of a clear coat over METALLIC_ROUGHNESS, 0..1; default 0 = none. As KHR_materials_clearcoat of glTF,
        /// with its own roughness and normal n_c and F = 0.04 + 0.96 (1 - |n_c.v|)^5: the model times 1 - c F, plus the sum
        /// of E max(0, n_c.l) c F D V. Without SlotTarget.ClearcoatNormal, n_c is the normal without normal maps and bumps.
        /// Ambient light and emission are not darkened. No effect on other models.
        /// </summary>
        public float Clearcoat;
        /// <summary>0..1; default 0</summary>
        public float ClearcoatRoughness;

        /// <summary>The defaults of the library.</summary>
        public static MaterialDesc Default
        {
            get
            {
                MaterialDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.MaterialDesc, &made, (UIntPtr)sizeof(MaterialDesc)));
                return made;
            }
        }
    }

    /// <summary>Vertices and triangles of a mesh; copied. Required: vertex_count, position.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeshDesc
    {
        /// <summary>set by shd_mesh_desc_default()</summary>
        public uint StructSize;
        /// <summary>0..2^28; 0 makes an empty mesh</summary>
        public uint VertexCount;
        /// <summary>x, y, z, object space; required unless vertex_count is 0</summary>
        public F32In3 Position;
        /// <summary>x, y, z, object space, any length; all three or none; computed if absent</summary>
        public F32In3 Normal;
        /// <summary>used when `normal` is absent; default NormalWeight.Area</summary>
        public NormalWeight NormalWeight;
        /// <summary>default none</summary>
        public MeshFlags Flags;
        /// <summary>x, y, z, object space, and handedness, +1 or -1; see @ref tangents. All four or none; stored unchanged.</summary>
        public F32In4 Tangent;
        /// <summary>u, v; both or none; 0 if absent</summary>
        public F32In2 Uv;
        /// <summary>u, v of a second set; both or none; 0 if absent</summary>
        public F32In2 Uv1;
        /// <summary>
        /// [attribute_count] columns for materials and programs, such as colours; any may be
        /// absent
        /// </summary>
        public F32In* Attributes;
        /// <summary>0..Constants.MaxAttributes; default 0</summary>
        public uint AttributeCount;
        /// <summary>default Topology.Triangles</summary>
        public Topology Topology;
        /// <summary>
        /// Vertex numbers of the triangles in the order of `topology`; counter-clockwise = front. NULL = indices16; if that
        /// is NULL too, 0, 1, 2, ... In strips and fans the largest number (0xffffffff, or 0xffff in indices16) starts a new
        /// strip or fan.
        /// </summary>
        public U32In Indices;
        /// <summary>16-bit vertex numbers; at most one of indices and indices16 is set</summary>
        public U16In Indices16;
        /// <summary>A multiple of 3 up to 3 * 2^28 for triangles, else up to 2^28 + 2. Without indices: 0 = vertex_count.</summary>
        public long IndexCount { get { return (long)indexCountWord; } set { indexCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr indexCountWord;

        /// <summary>The defaults of the library.</summary>
        public static MeshDesc Default
        {
            get
            {
                MeshDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.MeshDesc, &made, (UIntPtr)sizeof(MeshDesc)));
                return made;
            }
        }
    }

    /// <summary>
    /// Rays as packed columns of `count` elements, borrowed for the call. They start a little above the surfaces.
    /// struct_size goes from the library to the tracer, as in shd/fragments.h.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Rays
    {
        /// <summary>size of the library's struct</summary>
        public uint StructSize;
        /// <summary>number of rays, at least 1</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>origins, world space</summary>
        public float* Ox;
        /// <summary>origins, world space</summary>
        public float* Oy;
        /// <summary>origins, world space</summary>
        public float* Oz;
        /// <summary>directions, world space, unit</summary>
        public float* Dx;
        /// <summary>directions, world space, unit</summary>
        public float* Dy;
        /// <summary>directions, world space, unit</summary>
        public float* Dz;
        /// <summary>length of each ray, world length, &gt; 0; FLT_MAX or infinity = unlimited</summary>
        public float* Length;
    }

    /// <summary>A tracer and its data. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Tracer
    {
        /// <summary>NULL = none: depth maps</summary>
        public IntPtr Trace;
        /// <summary>passed to `trace`; borrowed for the call</summary>
        public void* UserData;
    }

    /// <summary>Occluders and rays; borrowed for the call. Required: nothing.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct OcclusionDesc
    {
        /// <summary>set by shd_occlusion_desc_default()</summary>
        public uint StructSize;
        /// <summary>per point, 1..65536; default 64</summary>
        public uint Rays;
        /// <summary>any value; default 0</summary>
        public uint Seed;
        /// <summary>world length over which occluders count, &gt; 0; default FLT_MAX = unlimited</summary>
        public float Radius;
        /// <summary>
        /// World length by which rays start above the surface, 0..1e9, besides 2^-18 of the largest coordinate of the point.
        /// Depth maps: ShadowDesc.bias. Default 0.
        /// </summary>
        public float Bias;
        /// <summary>depth maps: edge length [texels], 16..8192; default 1024</summary>
        public uint MapSize;
        /// <summary>default none</summary>
        public Tracer Tracer;
        /// <summary>
        /// Occluders of the depth maps, as in ShadowRenderDesc; NULL if draw_count is 0. Not read if there is a
        /// tracer, which has occluders of its own.
        /// </summary>
        public Draw* Draws;
        /// <summary>up to 2^20</summary>
        public long DrawCount { get { return (long)drawCountWord; } set { drawCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr drawCountWord;

        /// <summary>The defaults of the library.</summary>
        public static OcclusionDesc Default
        {
            get
            {
                OcclusionDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.OcclusionDesc, &made, (UIntPtr)sizeof(OcclusionDesc)));
                return made;
            }
        }
    }

    /// <summary>Points on surfaces; borrowed for the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct OcclusionPoints
    {
        /// <summary>set by shd_occlusion_points_default()</summary>
        public uint StructSize;
        /// <summary>number of points; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>x, y, z, world space; required unless count is 0</summary>
        public F32In3 Position;
        /// <summary>x, y, z, world space, any length; required unless count is 0</summary>
        public F32In3 Normal;

        /// <summary>The defaults of the library.</summary>
        public static OcclusionPoints Default
        {
            get
            {
                OcclusionPoints made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.OcclusionPoints, &made, (UIntPtr)sizeof(OcclusionPoints)));
                return made;
            }
        }
    }

    /// <summary>A texture of occlusion, with the coverage of shd/bake.h. Required: width, height.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct OcclusionAtlas
    {
        /// <summary>set by shd_occlusion_atlas_default()</summary>
        public uint StructSize;
        /// <summary>texels, 1..16384</summary>
        public uint Width;
        /// <summary>texels, 1..16384</summary>
        public uint Height;
        /// <summary>as BakeDesc.uv_set: 0 or 1; default 0</summary>
        public uint UvSet;
        /// <summary>as BakeDesc.dilation, 0..1024 texels; default 0</summary>
        public uint Dilation;
        /// <summary>value of texels that stay empty, finite; default 1</summary>
        public float Empty;
        /// <summary>
        /// [draw_count] surfaces; mesh, object_to_world and instances are read; NULL if draw_count
        /// is 0
        /// </summary>
        public Draw* Draws;
        /// <summary>up to 2^20</summary>
        public long DrawCount { get { return (long)drawCountWord; } set { drawCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr drawCountWord;
        /// <summary>TexelState of width * height texels; default not wanted</summary>
        public U32Out States;
        /// <summary>statistics; its struct_size is read; NULL = not wanted; all zero on failure</summary>
        public BakeStats* Stats;

        /// <summary>The defaults of the library.</summary>
        public static OcclusionAtlas Default
        {
            get
            {
                OcclusionAtlas made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.OcclusionAtlas, &made, (UIntPtr)sizeof(OcclusionAtlas)));
                return made;
            }
        }
    }

    /// <summary>
    /// A polygon and the kind of its coordinates.
    ///
    /// The polygon is simple: its edges meet in its vertices only, where exactly two of them meet, and no edge is a point.
    /// Its vertices run in either direction. Convex kinds need a turn at every vertex.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PolygonDesc
    {
        /// <summary>set by shd_polygon_desc_default()</summary>
        public uint StructSize;
        /// <summary>default Barycentric.Wachspress</summary>
        public Barycentric Kind;
        /// <summary>[vertex_count] x and y, finite; required</summary>
        public F32In2 Vertex;
        /// <summary>3..Constants.MaxPolygonVertices</summary>
        public uint VertexCount;
        /// <summary>
        /// HARMONIC: parts of each side of a triangle, 1..256; default 32. The solution has about
        /// vertex_count segments^2 / 2 nodes. Nodes times vertices are limited to 2^24.
        /// </summary>
        public uint Segments;

        /// <summary>The defaults of the library.</summary>
        public static PolygonDesc Default
        {
            get
            {
                PolygonDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.PolygonDesc, &made, (UIntPtr)sizeof(PolygonDesc)));
                return made;
            }
        }
    }

    /// <summary>Points at which coordinates are computed, as columns of `count` elements. Required: position.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PolygonPoints
    {
        /// <summary>set by shd_polygon_points_default()</summary>
        public uint StructSize;
        /// <summary>number of points; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>x and y; required</summary>
        public F32In2 Position;

        /// <summary>The defaults of the library.</summary>
        public static PolygonPoints Default
        {
            get
            {
                PolygonPoints made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.PolygonPoints, &made, (UIntPtr)sizeof(PolygonPoints)));
                return made;
            }
        }
    }

    /// <summary>Columns for the coordinates.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PolygonWeights
    {
        /// <summary>set by shd_polygon_weights_default()</summary>
        public uint StructSize;
        /// <summary>number of columns; vertex_count of the polygon</summary>
        public uint WeightCount;
        /// <summary>[weight_count] b_i, one column for each vertex; NULL columns are not wanted</summary>
        public F32Out* Weight;
        /// <summary>written: points outside the polygon</summary>
        public long OutsideCount { get { return (long)outsideCountWord; } set { outsideCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr outsideCountWord;
        /// <summary>written: points that are not finite</summary>
        public long NonfiniteCount { get { return (long)nonfiniteCountWord; } set { nonfiniteCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr nonfiniteCountWord;

        /// <summary>The defaults of the library.</summary>
        public static PolygonWeights Default
        {
            get
            {
                PolygonWeights made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.PolygonWeights, &made, (UIntPtr)sizeof(PolygonWeights)));
                return made;
            }
        }
    }

    /// <summary>
    /// Colour of a rectangle of the framebuffer: scene-linear, premultiplied by alpha, the average of the samples of each
    /// pixel. Its bits are those that a framebuffer with color_format Format.Rgba32f holds after the frame. Interleaved
    /// formats round these values, so a tile is more precise than their pixels; only pixels that the frame leaves unchanged
    /// (RenderFlags.Load, or outside the scissor) are decoded from the framebuffer.
    ///
    /// The struct goes from the library to the callback: struct_size is the size of the library's struct.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PresentTile
    {
        /// <summary>size of the library's struct</summary>
        public uint StructSize;
        /// <summary>below shd_context_worker_count(); calls with one worker are never concurrent</summary>
        public uint Worker;
        /// <summary>first column, pixels of the framebuffer from the left</summary>
        public uint X;
        /// <summary>first row, pixels of the framebuffer from the top</summary>
        public uint Y;
        /// <summary>columns, 1..64</summary>
        public uint Width;
        /// <summary>rows, 1..64</summary>
        public uint Height;
        /// <summary>r, g, b and a: [height][row_stride / 4]; borrowed for the call</summary>
        public FloatPointer4 Channel;
        /// <summary>bytes between rows</summary>
        public long RowStride { get { return (long)rowStrideWord; } set { rowStrideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr rowStrideWord;
    }

    /// <summary>Host callback for finished tiles. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Present
    {
        /// <summary>
        /// Called once for each tile of the framebuffer in no particular order, also for tiles that the frame does not
        /// change. In a frame of several passes (RenderDesc.pass_triangles) this is in the last pass, and with
        /// supersampling after the last block. A result other than Result.Ok, with its text from shd_report_error(), becomes
        /// the result of the render; tiles that follow are skipped. NULL = none.
        /// </summary>
        public IntPtr Tile;
        /// <summary>borrowed for the call that takes the Present</summary>
        public void* UserData;
    }

    /// <summary>Directions to project, as columns of `count` elements.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Directions
    {
        /// <summary>set by shd_directions_default()</summary>
        public uint StructSize;
        /// <summary>any but Projection.None; required</summary>
        public Projection Projection;
        /// <summary>number of directions; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>x, y, z, any length; required</summary>
        public F32In3 Direction;
        /// <summary>change of `direction` per pixel step in x; absent = 0</summary>
        public F32In3 DirectionDx;
        /// <summary>change of `direction` per pixel step in y; absent = 0</summary>
        public F32In3 DirectionDy;

        /// <summary>The defaults of the library.</summary>
        public static Directions Default
        {
            get
            {
                Directions made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Directions, &made, (UIntPtr)sizeof(Directions)));
                return made;
            }
        }
    }

    /// <summary>Columns for points of images; NULL = not wanted.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ProjectedPoints
    {
        /// <summary>set by shd_projected_points_default()</summary>
        public uint StructSize;
        /// <summary>across, 0..1</summary>
        public F32Out U;
        /// <summary>down, 0..1</summary>
        public F32Out V;
        /// <summary>face of CUBE, 0..5; 0 for other projections</summary>
        public U32Out Face;
        /// <summary>du/dx, within +-1e30; for CUBE on the plane of the face</summary>
        public F32Out Dudx;
        /// <summary>dv/dx</summary>
        public F32Out Dvdx;
        /// <summary>du/dy</summary>
        public F32Out Dudy;
        /// <summary>dv/dy</summary>
        public F32Out Dvdy;
        /// <summary>written: directions that count as +Z</summary>
        public long NonfiniteCount { get { return (long)nonfiniteCountWord; } set { nonfiniteCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr nonfiniteCountWord;

        /// <summary>The defaults of the library.</summary>
        public static ProjectedPoints Default
        {
            get
            {
                ProjectedPoints made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ProjectedPoints, &made, (UIntPtr)sizeof(ProjectedPoints)));
                return made;
            }
        }
    }

    /// <summary>Points of images, as columns of `count` elements.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ImagePoints
    {
        /// <summary>set by shd_image_points_default()</summary>
        public uint StructSize;
        /// <summary>any but Projection.None; required</summary>
        public Projection Projection;
        /// <summary>number of points; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>across, clamped to 0..1; LAT_LONG repeats; required</summary>
        public F32In U;
        /// <summary>down, clamped to 0..1; required</summary>
        public F32In V;
        /// <summary>face of CUBE; absent = 0; numbers above 5 mean 5; other projections ignore it</summary>
        public U32In Face;

        /// <summary>The defaults of the library.</summary>
        public static ImagePoints Default
        {
            get
            {
                ImagePoints made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ImagePoints, &made, (UIntPtr)sizeof(ImagePoints)));
                return made;
            }
        }
    }

    /// <summary>Columns for the directions of points; NULL = not wanted.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PointDirections
    {
        /// <summary>set by shd_point_directions_default()</summary>
        public uint StructSize;
        /// <summary>x, y, z, unit; -Z outside the disc of MIRROR_BALL and ANGULAR</summary>
        public F32Out3 Direction;
        /// <summary>
        /// Solid angle per area of (u, v) at the point [sr]; 0 outside the disc. A texel of a small image of n texels has
        /// about the n-th part of it; the integral over the image (six faces) is 4 pi.
        /// </summary>
        public F32Out SolidAngle;
        /// <summary>written: points with a coordinate that is not finite; it counts as 0</summary>
        public long NonfiniteCount { get { return (long)nonfiniteCountWord; } set { nonfiniteCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr nonfiniteCountWord;

        /// <summary>The defaults of the library.</summary>
        public static PointDirections Default
        {
            get
            {
                PointDirections made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.PointDirections, &made, (UIntPtr)sizeof(PointDirections)));
                return made;
            }
        }
    }

    /// <summary>All directions, in one image or six. Required: projection, images.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct DirectionImages
    {
        /// <summary>set by shd_direction_images_default()</summary>
        public uint StructSize;
        /// <summary>any but Projection.None</summary>
        public Projection Projection;
        /// <summary>arrangement of CUBE; default six images; others ignore it</summary>
        public CubeLayout Layout;
        /// <summary>
        /// One image, or the six of CubeLayout.Faces, of one struct_size, format and size. Square for MIRROR_BALL,
        /// ANGULAR and OCTAHEDRAL, and the size of the layout for CUBE. Borrowed for the call.
        /// </summary>
        public Image* Images;

        /// <summary>The defaults of the library.</summary>
        public static DirectionImages Default
        {
            get
            {
                DirectionImages made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.DirectionImages, &made, (UIntPtr)sizeof(DirectionImages)));
                return made;
            }
        }
    }

    /// <summary>
    /// One mesh in the frame. Required: mesh.
    ///
    /// Lines are rectangles around the edge, as long as the edge, with square ends (OpenGL 4.6 core specification,
    /// 14.5, antialiased lines). Points are squares around the vertices. Both lie on the grid of 8 subpixel bits and cover
    /// samples as triangles do, so a line or point narrower than 1 may fall between samples. Depth varies along a line and
    /// is constant across it; a point has the depth of its vertex. depth_bias_slope uses these depths instead of the
    /// triangle's. Attributes are interpolated at the pixel, with barycentric coordinates clamped to the triangle, and
    /// texture coordinates clamped to those of its vertices; a triangle without area gives the mean of its corners.
    ///
    /// Culling drops all lines and points of a triangle. A triangle without area is dropped if `cull` is not NONE. Clipping
    /// at the near and far plane adds no edges. A vertex beyond these planes has no point, and an edge without length has no
    /// line. A shared edge or vertex is drawn once by each of its triangles, with the same samples and depths.
    /// Compare.Less therefore shows it once, but with DrawFlags.KeepDepth a blend is applied several times.
    ///
    /// Fill.Lines draws each edge of the mesh once, for triangles facing either way: `cull` has no effect. The edge
    /// belongs to its first triangle: this triangle's vertices shade it, and it is ordered and counted with this triangle.
    /// Silhouettes are found for the centre of projection of world_to_view and view_to_clip (view.eye, if a camera made the
    /// view), or for the direction of a parallel projection. They depend on object_to_world and the positions of the mesh;
    /// vertex programs have no effect on them.
    ///
    /// A drawing without hidden lines takes two draws. The first draws the mesh as usual (without a material, if only lines
    /// shall be visible), with depth_bias 1e-5 and depth_bias_slope fill_width / 2 + 1. This bias moves the surface behind
    /// the lines that lie on its front. The second draws the lines with Compare.LessEqual. Lines over everything use
    /// Compare.Always.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Draw
    {
        /// <summary>set by shd_draw_default(); the same in every element of the array</summary>
        public uint StructSize;
        /// <summary>required; borrowed for the call</summary>
        public IntPtr Mesh;
        /// <summary>borrowed for the call; NULL = draw depth only, without programs</summary>
        public IntPtr Material;
        /// <summary>passed to the programs of the material; borrowed for the call; default NULL</summary>
        public void* Uniforms;
        /// <summary>affine, finite; default identity</summary>
        public Matrix4 ObjectToWorld;
        /// <summary>
        /// Object-to-world matrices, [instance_count][16], each affine and finite, instead of object_to_world. The mesh is
        /// drawn with each of them as if by separate draws, in order. Borrowed for the call.
        /// </summary>
        public float* Instances;
        /// <summary>all draws together up to 2^20; default 0 = once, with object_to_world</summary>
        public long InstanceCount { get { return (long)instanceCountWord; } set { instanceCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr instanceCountWord;
        /// <summary>default Frequency.Phong</summary>
        public Frequency Frequency;
        /// <summary>default none</summary>
        public DrawFlags Flags;
        /// <summary>default Cull.None</summary>
        public Cull Cull;
        /// <summary>default Compare.Less</summary>
        public Compare Compare;
        /// <summary>added to depth, -1..1; the sum is clamped to 0..1; default 0</summary>
        public float DepthBias;
        /// <summary>
        /// factor of another bias: the larger of |dz/dx| and |dz/dy| per pixel; finite;
        /// default 0
        /// </summary>
        public float DepthBiasSlope;
        /// <summary>default Fill.Solid</summary>
        public Fill Fill;
        /// <summary>width of lines and points [pixels], 1/16..64; default 0 = 1</summary>
        public float FillWidth;
        /// <summary>edges of Fill.Lines; default EdgeFlags.All</summary>
        public EdgeFlags Edges;
        /// <summary>threshold of EdgeFlags.Crease, as in EdgesDesc: -1..1; default 0.5</summary>
        public float CreaseCosine;

        /// <summary>The defaults of the library.</summary>
        public static Draw Default
        {
            get
            {
                Draw made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Draw, &made, (UIntPtr)sizeof(Draw)));
                return made;
            }
        }
    }

    /// <summary>Host progress callback. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Progress
    {
        /// <summary>
        /// Called after each piece of the frame, with the finished fraction of the frame, (0, 1]. Runs on any worker; calls
        /// are never concurrent. Must not throw, longjmp or call shd. A result other than 0 cancels: the render returns
        /// Result.ErrorCancelled and the framebuffer holds a part of the frame.
        /// </summary>
        public IntPtr Report;
        /// <summary>borrowed for the call</summary>
        public void* UserData;
    }

    /// <summary>
    /// A whole frame, or a window of it. All pointers are borrowed for the call. Required: framebuffer.
    ///
    /// Draws are projected to the picture. The framebuffer holds the window of the picture that begins at pixel (crop_x,
    /// crop_y). Its pixels have the same bits as in the whole picture.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct RenderDesc
    {
        /// <summary>set by shd_render_desc_default()</summary>
        public uint StructSize;
        /// <summary>required</summary>
        public IntPtr Framebuffer;
        /// <summary>linear, premultiplied RGBA; default 0</summary>
        public Float4 ClearColor;
        /// <summary>0..1; default 1</summary>
        public float ClearDepth;
        /// <summary>default none</summary>
        public RenderFlags Flags;
        /// <summary>
        /// Replaces `view`. An aspect of 0, the default, means the aspect of the viewport, or of the picture if there is no
        /// viewport. NULL = `view`.
        /// </summary>
        public Camera* Camera;
        /// <summary>default: identity matrices, eye at 0</summary>
        public View View;
        /// <summary>default Visibility.Depth</summary>
        public Visibility Visibility;
        /// <summary>
        /// [draw_count], all with the same struct_size, in order; NULL if draw_count is
        /// 0
        /// </summary>
        public Draw* Draws;
        /// <summary>up to 2^20</summary>
        public long DrawCount { get { return (long)drawCountWord; } set { drawCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr drawCountWord;
        /// <summary>[light_count]; NULL if light_count is 0</summary>
        public IntPtr* Lights;
        /// <summary>
        /// [light_count], each NULL or a shadow of shd/shadow.h that was rendered for a light of the same kind. The light
        /// that reaches a fragment is multiplied by the visibility at its position, with its shading normal. NULL = none.
        /// </summary>
        public IntPtr* Shadows;
        /// <summary>up to 2^20</summary>
        public long LightCount { get { return (long)lightCountWord; } set { lightCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr lightCountWord;
        /// <summary>pixels, framebuffer size..65536; default 0 = framebuffer size</summary>
        public uint PictureWidth;
        /// <summary>pixels, framebuffer size..65536; default 0 = framebuffer size</summary>
        public uint PictureHeight;
        /// <summary>
        /// column of the picture at which the framebuffer begins; the framebuffer lies
        /// inside the picture; default 0
        /// </summary>
        public uint CropX;
        /// <summary>row of the picture at which the framebuffer begins; default 0</summary>
        public uint CropY;
        /// <summary>
        /// target of NDC -1..1 in the picture, not empty; cuts triangles, lines and points
        /// at its edge; NULL = the whole picture
        /// </summary>
        public Region* Viewport;
        /// <summary>pixels of the picture that may change; NULL = all</summary>
        public Region* Scissor;
        /// <summary>
        /// n, 2..16; 0 and 1 = off. The frame is drawn as a picture n times as large, up to 65536 pixels a side, with the
        /// framebuffer's number of samples in each pixel; crop, viewport and scissor are scaled by n. Colour and targets of
        /// a pixel are the plain average of its n x n pixels; depth and the other planes have the values of the top left
        /// one. Derivatives (and so footprints of textures) and raster positions in programs refer to the large picture;
        /// lines and points are n times as wide in it. With RenderFlags.Load each of the n x n pixels starts with the pixel's
        /// values. The large picture is drawn in blocks of up to 1024 x 1024 pixels; only one block is in memory. Statistics
        /// are sums over blocks, so a triangle counts in each block.
        /// </summary>
        public uint Supersampling;
        /// <summary>
        /// Largest number of triangles that are processed together, 1024..2^31-1; 0 = 2^21. A larger frame is drawn in
        /// passes. A pass has several whole draws, each of which counts as at least 16 triangles, or a part of one draw. The
        /// framebuffer has the same bits for any number. Draws of Blend.Weighted and Blend.Sorted form the last pass
        /// together. Only with Visibility.Depth: the other methods order all triangles together.
        ///
        /// Working memory is at most 512 bytes for each of these triangles, 256 for each draw or instance, 24 for each
        /// sample of the framebuffer and 16 more for each of its targets, and 8 MiB for each worker. Additional memory: 4
        /// bytes for each tile of 64 x 64 pixels that a triangle touches beyond dozens, 48 for each piece of a clipped
        /// triangle, 4 for each varying of up to three vertices a triangle, and the triangles of the last pass. A frame in
        /// several passes or with supersampling takes 16 bytes for each pixel of a framebuffer with interleaved colour.
        /// </summary>
        public uint PassTriangles;
        /// <summary>
        /// statistics; its struct_size is read; NULL = not wanted. All zero on failure, except
        /// where the struct_size or the unknown end of this desc is refused
        /// </summary>
        public RenderStats* Stats;
        /// <summary>default none</summary>
        public Progress Progress;
        /// <summary>receives the finished tiles; default none</summary>
        public Present Present;
        /// <summary>
        /// Light from all directions, in addition to the lights; NULL = none. Every model with lights reflects it, except
        /// GOOCH. It casts no shadows; SlotTarget.Occlusion multiplies all of its reflected light. It must
        /// have been created with the tables of the models of the draws (EnvironmentDesc.tables).
        /// </summary>
        public IntPtr Environment;
        /// <summary>factor of its radiance, 0..1e12; default 1</summary>
        public float EnvironmentIntensity;
        /// <summary>
        /// rotation or reflection of its directions, column-major, with orthonormal
        /// columns within 1e-3; default identity
        /// </summary>
        public Matrix3 EnvironmentToWorld;
        /// <summary>default Background.Clear</summary>
        public Background Background;
        /// <summary>
        /// roughness of the GGX lobe that blurs the environment behind the picture, 0..1;
        /// values above 0 need EnvironmentTables.Ggx; default 0 = sharp
        /// </summary>
        public float BackgroundRoughness;
        /// <summary>
        /// [volume_count], all with the same struct_size. They are blended over the finished draws in this order, so the
        /// caller sorts volumes from far to near. A ray of a pixel ends at the depth of a sample, with one march for all
        /// samples of equal depth. Depth decreases with the distance if clear_depth is below 1/2, and increases otherwise.
        /// Depth and planes other than colour keep their values. NULL if volume_count is 0.
        /// </summary>
        public VolumeDraw* Volumes;
        /// <summary>up to 1024; default 0</summary>
        public long VolumeCount { get { return (long)volumeCountWord; } set { volumeCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr volumeCountWord;

        /// <summary>The defaults of the library.</summary>
        public static RenderDesc Default
        {
            get
            {
                RenderDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.RenderDesc, &made, (UIntPtr)sizeof(RenderDesc)));
                return made;
            }
        }
    }

    /// <summary>Options and budgets of a load. A budget that would be exceeded is Result.ErrorLimit.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SceneDesc
    {
        /// <summary>set by shd_scene_desc_default()</summary>
        public uint StructSize;
        /// <summary>default none</summary>
        public SceneFlags Flags;
        /// <summary>
        /// flags of all meshes; meshes with uv have tangents, unless a normal map reads uv1;
        /// default none
        /// </summary>
        public MeshFlags MeshFlags;
        /// <summary>
        /// sampler of all textures; its wraps are replaced by those of the file, and
        /// its filter and magnification where the file has nearest texels or
        /// levels. Borrowed for the call; NULL = trilinear
        /// </summary>
        public SamplerDesc* Sampler;
        /// <summary>
        /// formats, flags, tables and budgets of each texture file; its color_space is
        /// ignored; worker_path is that of the model,
        /// too. Borrowed for the call; NULL = defaults
        /// </summary>
        public LoadDesc* Texture;
        /// <summary>sum of the model and the files that are read with it; 0 = 2^30</summary>
        public ulong MaxFileBytes;
        /// <summary>sum over all meshes; 0 = 2^26</summary>
        public ulong MaxVertices;
        /// <summary>sum over all meshes; 0 = 2^26</summary>
        public ulong MaxTriangles;
        /// <summary>0 = 2^18; always at most 512 deep</summary>
        public ulong MaxNodes;
        /// <summary>up to 2^20, the maximum of a frame; 0 = 2^18</summary>
        public ulong MaxInstances;
        /// <summary>all textures with their mip levels; 0 = 2^32</summary>
        public ulong MaxTextureBytes;
        /// <summary>
        /// [s] 0 = 60. Ends the process that reads; with SceneFlags.InProcess checked
        /// between the steps of a reader
        /// </summary>
        public double TimeLimit;
        /// <summary>memory of the process that reads, and of what it sends; 0 = 2^32 [bytes]</summary>
        public ulong MaxReaderBytes;
        /// <summary>
        /// Answers the names of the model's files, in place of its folder: for archives and memory. The bytes are borrowed
        /// until the load returns. Result.ErrorNotFound = no such file; any other result than Result.Ok ends the load. Runs on
        /// the thread of the load; must not throw or longjmp. NULL = the folder of the model, or no file for a model in
        /// memory.
        /// </summary>
        public IntPtr Find;
        /// <summary>first argument of `find`</summary>
        public void* FindUserData;

        /// <summary>The defaults of the library.</summary>
        public static SceneDesc Default
        {
            get
            {
                SceneDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.SceneDesc, &made, (UIntPtr)sizeof(SceneDesc)));
                return made;
            }
        }
    }

    /// <summary>Light and draws of a map; borrowed for the call. Required: light.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ShadowRenderDesc
    {
        /// <summary>set by shd_shadow_render_desc_default()</summary>
        public uint StructSize;
        /// <summary>required; directional, spot or point</summary>
        public IntPtr Light;
        /// <summary>
        /// Draws that cast shadows, as in RenderDesc; NULL if draw_count is 0. Depth comparison, depth biases and
        /// culling of a draw are ignored; a draw with DrawFlags.KeepDepth casts no shadow. Vertex programs run with the
        /// light's view. Alpha tests and programs that drop fragments apply too, except for draws with WEIGHTED or SORTED
        /// blending. Opacity by itself has no effect.
        /// </summary>
        public Draw* Draws;
        /// <summary>up to 2^20</summary>
        public long DrawCount { get { return (long)drawCountWord; } set { drawCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr drawCountWord;
        /// <summary>
        /// Range of depths, near_plane &lt; far_plane. Surfaces outside cast no shadow. Both 0 = fitted to the draws.
        /// Directional lights: measured from the origin of the world along the direction of the light, any sign. Other
        /// lights: measured from the light along the axis of the face, &gt; 0; a fitted near_plane is at least 1/256 of
        /// far_plane.
        /// </summary>
        public float NearPlane;
        public float FarPlane;
        /// <summary>
        /// Directional lights: the part of the world that needs shadows. Both 0 = the bounds of the draws. Draws between
        /// this part and the light still cast shadows. The size of texels is rounded up in steps of 1/8 to 1/16, and texels
        /// lie at multiples of their size, so shadows do not shimmer while bounds of constant size move.
        /// </summary>
        public Float3 BoundsMin;
        public Float3 BoundsMax;

        /// <summary>The defaults of the library.</summary>
        public static ShadowRenderDesc Default
        {
            get
            {
                ShadowRenderDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ShadowRenderDesc, &made, (UIntPtr)sizeof(ShadowRenderDesc)));
                return made;
            }
        }
    }

    /// <summary>Points on surfaces; borrowed for the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ShadowLookups
    {
        /// <summary>set by shd_shadow_lookups_default()</summary>
        public uint StructSize;
        /// <summary>number of points; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>x, y, z, world space; required unless count is 0</summary>
        public F32In3 Position;
        /// <summary>unit, world space; all three columns or none</summary>
        public F32In3 Normal;

        /// <summary>The defaults of the library.</summary>
        public static ShadowLookups Default
        {
            get
            {
                ShadowLookups made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ShadowLookups, &made, (UIntPtr)sizeof(ShadowLookups)));
                return made;
            }
        }
    }

    /// <summary>Output columns of a shape. They do not overlap; each may be absent.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ShapeColumns
    {
        /// <summary>set by shd_shape_columns_default()</summary>
        public uint StructSize;
        /// <summary>elements in each column of vertices, at least the number from shd_shape_count()</summary>
        public uint VertexCount;
        /// <summary>
        /// elements in `indices`, at least the number from shd_shape_count() unless `indices`
        /// is absent
        /// </summary>
        public long IndexCount { get { return (long)indexCountWord; } set { indexCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr indexCountWord;
        /// <summary>x, y, z, object space</summary>
        public F32Out3 Position;
        /// <summary>x, y, z, unit, outwards</summary>
        public F32Out3 Normal;
        /// <summary>u, v</summary>
        public F32Out2 Uv;
        /// <summary>three for each triangle</summary>
        public U32Out Indices;

        /// <summary>The defaults of the library.</summary>
        public static ShapeColumns Default
        {
            get
            {
                ShapeColumns made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.ShapeColumns, &made, (UIntPtr)sizeof(ShapeColumns)));
                return made;
            }
        }
    }

    /// <summary>
    /// A source for a coefficient. Required: target, and the fields that the source uses.
    ///
    /// Slots that scale light (diffuse, tint, ambient, specular, opacity, emission, metallic, occlusion, matcap) are looked
    /// up for every fragment at every frequency. Slots that shape a lobe (exponent, roughness, normal, normal_mixed, height
    /// and those of the clear coat) are looked up where lobes are evaluated: at flat and Gouraud frequency at the centroid
    /// or vertex, on level 0.
    ///
    /// Values are not clamped, even if negative. NaN and infinity propagate to the colours of their fragments, which
    /// RenderStats.nonfinite_fragments counts. There are two exceptions. Exponents are clamped to 0..1e6 (NaN becomes
    /// 0) and roughness to 0..1 (NaN becomes 1). The surface keeps its normal where a mapped normal is 0 or not finite, or a
    /// slope of heights is not finite.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Slot
    {
        /// <summary>set by shd_slot_default(); the same in every element of an array</summary>
        public uint StructSize;
        /// <summary>the coefficient; each slot of a material has a different one</summary>
        public SlotTarget Target;
        /// <summary>default SlotSource.Constant</summary>
        public SlotSource Source;
        /// <summary>SlotSource.Vertex: first column, 0..7; default 0</summary>
        public uint Attribute;
        /// <summary>
        /// SlotSource.Texture: a 2D texture, or a 3D texture that is looked up at places;
        /// else NULL; retained by the material
        /// </summary>
        public IntPtr Texture;
        /// <summary>SlotSource.Texture: NULL = default sampler; retained by the material</summary>
        public IntPtr Sampler;
        /// <summary>function of SlotSource.Procedure</summary>
        public IntPtr Procedure;
        /// <summary>passed to `procedure`; borrowed until release of the material</summary>
        public void* UserData;
        /// <summary>channel of the texture or the solid texture for scalars, 0..3; default 0</summary>
        public uint Channel;
        /// <summary>coordinates for the texture: 0 = uv of the mesh, 1 = uv1; default 0</summary>
        public uint UvSet;
        /// <summary>
        /// (u', v') = (t[0] u + t[1] v + t[2], t[3] u + t[4] v + t[5]), finite; default identity. glTF's
        /// KHR_texture_transform is T R S, with the rotation r and v downwards
        /// t = {sx cos r, sy sin r, ox, -sx sin r, sy cos r, oy}.
        /// </summary>
        public Float6 UvTransform;
        /// <summary>
        /// Solid texture of SlotSource.Solid, else NULL; copied by the material. Colours take r, g, b and, for the
        /// diffuse slot and normals, a; scalars take `channel`. At Phong frequency, and for slots that scale light, the
        /// width of a pixel is max(|dp/dx|, |dp/dy|), with the exact derivatives of the place p by pixel steps; where lobes
        /// are evaluated at vertices or centroids it is 0. `place_width` multiplies it.
        /// </summary>
        public SolidDesc* Solid;
        /// <summary>
        /// Place = place_transform * position, column-major, affine: the last row is 0, 0, 0, 1; default identity. A solid
        /// texture is evaluated at the place. A 3D texture is looked up at (u, v, w) = place, with the derivatives of the
        /// place by pixel steps times `place_width`: it fills the cube from 0 to 1, and its sampler wraps it.
        /// </summary>
        public Matrix4 PlaceTransform;
        /// <summary>space of the position; default PlaceSpace.Object</summary>
        public PlaceSpace PlaceSpace;
        /// <summary>
        /// factor of the width of a pixel, 0..1000; 0 = no band limit, level 0 of
        /// 3D textures; default 1
        /// </summary>
        public float PlaceWidth;

        /// <summary>The defaults of the library.</summary>
        public static Slot Default
        {
            get
            {
                Slot made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.Slot, &made, (UIntPtr)sizeof(Slot)));
                return made;
            }
        }
    }

    /// <summary>Points at which a solid texture is evaluated, as columns of `count` elements. Required: position.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SolidPoints
    {
        /// <summary>set by shd_solid_points_default()</summary>
        public uint StructSize;
        /// <summary>number of points; 0 is allowed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>x, y, z; required</summary>
        public F32In3 Position;
        /// <summary>diameter of a pixel at the point [units of the positions]; absent = 0: no band limit</summary>
        public F32In Width;

        /// <summary>The defaults of the library.</summary>
        public static SolidPoints Default
        {
            get
            {
                SolidPoints made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.SolidPoints, &made, (UIntPtr)sizeof(SolidPoints)));
                return made;
            }
        }
    }

    /// <summary>Columns for the values of a solid texture; NULL = not wanted. At least one is required.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SolidValues
    {
        /// <summary>set by shd_solid_values_default()</summary>
        public uint StructSize;
        /// <summary>the pattern, in the range of its kind</summary>
        public F32Out Value;
        /// <summary>
        /// d value / dx, dy and dz, with the width held constant, limited to -1e30..1e30. Where the pattern jumps or has no
        /// derivative the result is that of one side, or 0.
        /// </summary>
        public F32Out3 Gradient;
        /// <summary>r, g, b, a of SolidDesc.colors at the value, linear</summary>
        public F32Out4 Color;
        /// <summary>written: points whose position or width is not finite</summary>
        public long NonfiniteCount { get { return (long)nonfiniteCountWord; } set { nonfiniteCountWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr nonfiniteCountWord;

        /// <summary>The defaults of the library.</summary>
        public static SolidValues Default
        {
            get
            {
                SolidValues made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.SolidValues, &made, (UIntPtr)sizeof(SolidValues)));
                return made;
            }
        }
    }

    /// <summary>Options of tessellation and displacement.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TessellationDesc
    {
        /// <summary>set by shd_tessellation_desc_default()</summary>
        public uint StructSize;
        /// <summary>default TessellationMode.Uniform</summary>
        public TessellationMode Mode;
        /// <summary>UNIFORM: parts of an edge, 1..Constants.MaxSegments; default 1</summary>
        public uint Segments;
        /// <summary>ADAPTIVE: largest number of parts of an edge, 1..Constants.MaxSegments; default 64</summary>
        public uint MaxSegments;
        /// <summary>ADAPTIVE: longest part [pixels], without `view` [world units]; &gt; 0; default 8</summary>
        public float EdgeLength;
        /// <summary>ADAPTIVE with `view`: of the picture [pixels], 1..65536; default 1024</summary>
        public uint Width;
        /// <summary>ADAPTIVE with `view`: of the picture [pixels], 1..65536; default 1024</summary>
        public uint Height;
        /// <summary>the call is refused if the result would have more, 1..2^28; default 2^24</summary>
        public uint MaxTriangles;
        /// <summary>
        /// ADAPTIVE: view for lengths in pixels. An edge counts as turned about its middle until it is perpendicular to the
        /// line of sight; its length is then projected to the picture. An edge that passes the eye has max_segments parts,
        /// an edge behind the eye has 1. Borrowed for the call; NULL = lengths in world units.
        /// </summary>
        public View* View;
        /// <summary>ADAPTIVE: [16], column-major; borrowed for the call; NULL = identity</summary>
        public float* ObjectToWorld;
        /// <summary>channel r is the height; borrowed for the call; NULL = no displacement</summary>
        public IntPtr Displacement;
        /// <summary>sampler of `displacement`; borrowed for the call; NULL = the default sampler</summary>
        public IntPtr Sampler;
        /// <summary>level of detail of the lookups, log2 of base texels, -32..32; default 0</summary>
        public float Lod;
        /// <summary>factor of heights [object units], -1e12..1e12; default 0 = no displacement</summary>
        public float Amplitude;
        /// <summary>height that is not displaced, -1e12..1e12; default 0</summary>
        public float Offset;
        /// <summary>used with displacement; default DisplacedNormals.Tilted</summary>
        public DisplacedNormals Normals;

        /// <summary>The defaults of the library.</summary>
        public static TessellationDesc Default
        {
            get
            {
                TessellationDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TessellationDesc, &made, (UIntPtr)sizeof(TessellationDesc)));
                return made;
            }
        }
    }

    /// <summary>Texels and tables of a texture. Required: format, width, height, texels.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TextureDesc
    {
        /// <summary>set by shd_texture_desc_default()</summary>
        public uint StructSize;
        /// <summary>
        /// any; no default. RGB8 to RGB32F are stored as RGBA. Blocks stay compressed, and lookups
        /// decode them (docs/compressed.md): the caller gives its mip levels; other tables are
        /// kept decoded
        /// </summary>
        public Format Format;
        /// <summary>texels, 1..65536; width * height * layers at most 2^28; see `tiles` for larger ones</summary>
        public uint Width;
        /// <summary>texels, 1..65536</summary>
        public uint Height;
        /// <summary>
        /// [layers][height][width], row 0 on top, aligned to a channel; copied without
        /// TextureFlags.Borrow. Blocks: [layers][ceil(height / 4)][ceil(width / 4)], at any
        /// address
        /// </summary>
        public void* Texels;
        /// <summary>bytes between rows of texels or blocks, at least the bytes of a row; 0 = packed</summary>
        public long RowStride { get { return (long)rowStrideWord; } set { rowStrideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr rowStrideWord;
        /// <summary>bytes between layers, at least the rows of a layer times the row stride; 0 = packed</summary>
        public long LayerStride { get { return (long)layerStrideWord; } set { layerStrideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr layerStrideWord;
        /// <summary>images of the array, 1..2048; default 1</summary>
        public uint Layers;
        /// <summary>default none</summary>
        public TextureFlags Flags;
        /// <summary>sources of r, g, b, a of lookups; default Channel.Default</summary>
        public Channel4 Swizzle;
        /// <summary>
        /// values of channels that the format does not have, in lookups inside and outside the
        /// image; finite; default 0, 0, 0, 1
        /// </summary>
        public Float4 Fill;
        /// <summary>default none</summary>
        public TableFlags Tables;
        /// <summary>
        /// number of `levels` per layer; the mipmap ends with the last one, even if it is
        /// larger than 1 x 1; default 0 = the library builds the levels
        /// </summary>
        public uint LevelCount;
        /// <summary>
        /// The caller's mip levels for TableFlags.Mipmap: [layers][level_count], all of one struct_size, of this format;
        /// copied. Element l is level l + 1: max(1, width &gt;&gt; (l + 1)) by max(1, height &gt;&gt; (l + 1)). A ripmap of the same
        /// texture uses them for the levels that it shares with the mipmap. A 3D texture has the max(1, depth &gt;&gt; 1) slices
        /// of level 1 first, then the slices of level 2, and so on.
        /// </summary>
        public Image* Levels;
        /// <summary>
        /// Slices of a 3D texture, 1..65536; default 0 = a 2D texture. width * height * depth is at most 2^28, `layers` is
        /// 1, and TableFlags.Mipmap is the only table. Texels are [depth][height][width], and `layer_stride` is the distance
        /// of slices. Lookups read (u, v, w); w = 0 is the outer face of slice 0. A level halves all three sizes.
        /// </summary>
        public uint Depth;
        /// <summary>
        /// Default Projection.None. With any other one, lookups read (u, v, w) as a direction of any length. `width` and
        /// `height` are equal unless it is LAT_LONG; `layers` of CUBE are the 6 faces +X, -X, +Y, -Y, +Z, -Z; `depth` is 0;
        /// `tables` has TableFlags.Mipmap at most. Mip levels are averages of texels of one image, unweighted.
        /// </summary>
        public Projection Projection;
        /// <summary>
        /// Default none. With a cache, the texture keeps no texels: `texels` is NULL, strides are 0, nothing is borrowed,
        /// and the format has not three channels. `width` and `height` are 1..2^20, and the tiles of all levels and layers
        /// at most 2^30. TableFlags.Ripmap and TableFlags.SummedArea are built in memory, of all levels, when the texture is
        /// made; dropped tiles do not change them. The callback writes the mip levels too. `level_count` is their
        /// number, 0 = down to 1 x 1; `levels` is NULL. Coordinates are binary32 floats: beyond 65536 texels, filters have
        /// fewer than 8 bits for the fraction of a texel. Precision.Fast has no effect. Filter.Exact,
        /// shd_texture_explain() and shd_texture_bounds() wait for the tiles that they read, also with
        /// MissingTiles.Coarser.
        /// </summary>
        public TileSource Tiles;

        /// <summary>The defaults of the library.</summary>
        public static TextureDesc Default
        {
            get
            {
                TextureDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TextureDesc, &made, (UIntPtr)sizeof(TextureDesc)));
                return made;
            }
        }
    }

    /// <summary>A tile that a callback fills. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Tile
    {
        /// <summary>layer, face, or slice of the level of a 3D texture</summary>
        public uint Layer;
        /// <summary>0 = the base level</summary>
        public uint Level;
        /// <summary>first column of the level, a multiple of the width of whole tiles</summary>
        public uint X;
        /// <summary>first row of the level, a multiple of the height of whole tiles</summary>
        public uint Y;
        /// <summary>texels to write in a row: the width of a tile, less at the right edge of the level</summary>
        public uint Width;
        /// <summary>rows to write; fewer at the lower edge</summary>
        public uint Height;
        /// <summary>rows of texels or of blocks, `row_stride` apart; aligned to 64 bytes; content undefined</summary>
        public void* Texels;
        /// <summary>bytes between rows of texels or of blocks</summary>
        public long RowStride { get { return (long)rowStrideWord; } set { rowStrideWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr rowStrideWord;
    }

    /// <summary>Source of the tiles of a texture. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TileSource
    {
        /// <summary>retained; NULL = the texture has its texels in memory</summary>
        public IntPtr Cache;
        /// <summary>required with `cache`</summary>
        public IntPtr Load;
        /// <summary>
        /// called once, after the last `load`, when the texture is destroyed; may be
        /// NULL. It is not called if shd_texture_create() fails
        /// </summary>
        public IntPtr Release;
        /// <summary>passed to both; borrowed until release of the texture</summary>
        public void* UserData;
    }

    /// <summary>Options of a texture in a file. Required: cache.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TileFileDesc
    {
        /// <summary>set by shd_tile_file_desc_default()</summary>
        public uint StructSize;
        /// <summary>
        /// meaning of 8-bit numbers; default AUTO = as declared by the file, sRGB if it
        /// declares nothing. Other numbers must be linear, or be declared so here
        /// </summary>
        public ColorEncoding ColorSpace;
        /// <summary>retained by the texture</summary>
        public IntPtr Cache;
        /// <summary>
        /// open readers to keep, 1..4096; default 0 = 16. Each has a descriptor and some
        /// memory of OpenImageIO; more exist while more threads read. A KTX2 or DDS file
        /// has one descriptor for all threads
        /// </summary>
        public long MaxReaders { get { return (long)maxReadersWord; } set { maxReadersWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr maxReadersWord;
        /// <summary>colour of absent files of a set, linear; finite; default 0, 0, 0, 1</summary>
        public Float4 Fill;

        /// <summary>The defaults of the library.</summary>
        public static TileFileDesc Default
        {
            get
            {
                TileFileDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.TileFileDesc, &made, (UIntPtr)sizeof(TileFileDesc)));
                return made;
            }
        }
    }

    /// <summary>
    /// Neighbouring vertices of one draw, one row each, as packed columns of `count` elements; borrowed for the call.
    ///
    /// Every vertex of a triangle is processed for each instance of the draw, up to 512 vertices per call. It is processed
    /// once, or once in each pass that needs it if the frame has several passes (RenderDesc.pass_triangles). The
    /// grouping of vertices and the order of calls are unspecified.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Vertices
    {
        /// <summary>size of the library's struct</summary>
        public uint StructSize;
        /// <summary>index into RenderDesc.draws</summary>
        public uint Draw;
        /// <summary>index into Draw.instances, 0 without instances</summary>
        public uint Instance;
        /// <summary>row i is vertex first + i of the mesh</summary>
        public uint First;
        /// <summary>number of `attribute` columns</summary>
        public uint AttributeCount;
        /// <summary>rows; must not be changed</summary>
        public long Count { get { return (long)countWord; } set { countWord = (UIntPtr)checked((ulong)value); } }
        private UIntPtr countWord;
        /// <summary>position, object space</summary>
        public float* Px;
        /// <summary>position, object space</summary>
        public float* Py;
        /// <summary>position, object space</summary>
        public float* Pz;
        /// <summary>normal, object space, unit</summary>
        public float* Nx;
        /// <summary>normal, object space, unit</summary>
        public float* Ny;
        /// <summary>normal, object space, unit</summary>
        public float* Nz;
        /// <summary>tangent, object space, and handedness; NULL if the mesh has no tangents</summary>
        public float* Tx;
        /// <summary>tangent, object space, and handedness; NULL if the mesh has no tangents</summary>
        public float* Ty;
        /// <summary>tangent, object space, and handedness; NULL if the mesh has no tangents</summary>
        public float* Tz;
        /// <summary>tangent, object space, and handedness; NULL if the mesh has no tangents</summary>
        public float* Tw;
        /// <summary>texture coordinates; 0 if the mesh has none</summary>
        public float* U;
        /// <summary>texture coordinates; 0 if the mesh has none</summary>
        public float* V;
        /// <summary>second set of texture coordinates; NULL if the mesh has none</summary>
        public float* U1;
        /// <summary>second set of texture coordinates; NULL if the mesh has none</summary>
        public float* V1;
        /// <summary>[attribute_count] columns of the mesh; NULL for absent ones</summary>
        public float** Attribute;
        /// <summary>[16], column-major; of the instance</summary>
        public float* ObjectToWorld;
        /// <summary>[16], column-major</summary>
        public float* WorldToView;
        /// <summary>[16], column-major</summary>
        public float* ViewToClip;
        /// <summary>[3], world space</summary>
        public float* Eye;
        /// <summary>Draw.uniforms</summary>
        public void* Uniforms;
    }

    /// <summary>
    /// Values that a program may change, as packed columns of `count` elements.
    ///
    /// Each column starts with the values that the draw has without a program. A vertex whose values stay unchanged gives
    /// the same bits as without a program. Triangles with a vertex that has NaN or infinity in any column are dropped;
    /// RenderStats.nonfinite counts them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct VertexOutputs
    {
        /// <summary>size of the library's struct</summary>
        public uint StructSize;
        /// <summary>MaterialDesc.varying_count</summary>
        public uint VaryingCount;
        /// <summary>clip space: visible with -w..w for x and y, 0..w for z</summary>
        public float* X;
        /// <summary>clip space: visible with -w..w for x and y, 0..w for z</summary>
        public float* Y;
        /// <summary>clip space: visible with -w..w for x and y, 0..w for z</summary>
        public float* Z;
        /// <summary>clip space: visible with -w..w for x and y, 0..w for z</summary>
        public float* W;
        /// <summary>position, world space, for lighting and wo</summary>
        public float* Px;
        /// <summary>position, world space, for lighting and wo</summary>
        public float* Py;
        /// <summary>position, world space, for lighting and wo</summary>
        public float* Pz;
        /// <summary>normal, world space; changed normals are normalised afterwards</summary>
        public float* Nx;
        /// <summary>normal, world space; changed normals are normalised afterwards</summary>
        public float* Ny;
        /// <summary>normal, world space; changed normals are normalised afterwards</summary>
        public float* Nz;
        /// <summary>texture coordinates</summary>
        public float* U;
        /// <summary>texture coordinates</summary>
        public float* V;
        /// <summary>[varying_count] columns that start as 0</summary>
        public float** Varying;
    }

    /// <summary>Density, transfer function, steps and shading of a volume. Required: point_count, texture, density, extinction.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct VolumeDesc
    {
        /// <summary>set by shd_volume_desc_default()</summary>
        public uint StructSize;
        /// <summary>points of the transfer function, 1..256</summary>
        public uint PointCount;
        /// <summary>3D texture; retained</summary>
        public IntPtr Texture;
        /// <summary>
        /// [point_count] densities of the points, -1e38..1e38, never decreasing. Values are
        /// interpolated between points; two points of one density are a jump
        /// </summary>
        public F32In Density;
        /// <summary>[point_count] sigma [1 / world unit], 0..1e12</summary>
        public F32In Extinction;
        /// <summary>
        /// [point_count] scene-linear r, g, b, 0..1e6: radiance, or the diffuse colour of
        /// `material`; absent = 1
        /// </summary>
        public F32In3 Color;
        /// <summary>
        /// Shades the points by the lights of the frame, with shadows and cookies, but not by its environment: an opaque
        /// material without slots and debug view, of a model that reflects light; others are Result.ErrorUnsupported. Its
        /// diffuse colour is multiplied by `color`. The normal is the direction in which density falls fastest, by central
        /// differences over two texels; it faces the viewer where the gradient is 0, and always with
        /// MaterialFlags.DoubleSided. NULL = `color` is radiance; retained.
        /// </summary>
        public IntPtr Material;
        /// <summary>corner of the texture's (0, 0, 0) in object space, finite; default 0</summary>
        public Float3 BoxMin;
        /// <summary>corner of the texture's (1, 1, 1); above box_min on each axis; default 1</summary>
        public Float3 BoxMax;
        /// <summary>length of a step [world units], above 0, at most 1e12; default 1/256</summary>
        public float Step;
        /// <summary>
        /// the point of a step lies at a fraction 1/2 + jitter (h - 1/2) of the step, with h in [0, 1) hashed
        /// from the pixel of the picture and `seed`; 0..1; default 0
        /// </summary>
        public float Jitter;
        /// <summary>seed of the jitter; default 0</summary>
        public uint Seed;
        /// <summary>reserved; 0</summary>
        public uint Flags;

        /// <summary>The defaults of the library.</summary>
        public static VolumeDesc Default
        {
            get
            {
                VolumeDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.VolumeDesc, &made, (UIntPtr)sizeof(VolumeDesc)));
                return made;
            }
        }
    }

    /// <summary>One volume in the frame. Required: volume.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct VolumeDraw
    {
        /// <summary>set by shd_volume_draw_default(); the same in every element of the array</summary>
        public uint StructSize;
        /// <summary>borrowed for the call</summary>
        public IntPtr Volume;
        /// <summary>affine, finite, invertible; default identity</summary>
        public Matrix4 ObjectToWorld;

        /// <summary>The defaults of the library.</summary>
        public static VolumeDraw Default
        {
            get
            {
                VolumeDraw made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.VolumeDraw, &made, (UIntPtr)sizeof(VolumeDraw)));
                return made;
            }
        }
    }

    /// <summary>Files of a stack. Required: either paths and path_count, or pattern.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct StackDesc
    {
        /// <summary>set by shd_stack_desc_default()</summary>
        public uint StructSize;
        /// <summary>number of `paths`, 0..65536</summary>
        public uint PathCount;
        /// <summary>[path_count] files, slice 0 first; of a single file all pages are slices</summary>
        public byte** Paths;
        /// <summary>
        /// A path with one place for a number, instead of `paths`: %d, %5d (padded by spaces to five characters) or %05d
        /// (by zeros); %% is a percent sign. Slice k is the file of the number first + k.
        /// </summary>
        public byte* Pattern;
        /// <summary>number of slice 0 of `pattern`; default 0</summary>
        public uint First;
        /// <summary>number of the last slice, first..first + 65535; default 0</summary>
        public uint Last;

        /// <summary>The defaults of the library.</summary>
        public static StackDesc Default
        {
            get
            {
                StackDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.StackDesc, &made, (UIntPtr)sizeof(StackDesc)));
                return made;
            }
        }
    }

    /// <summary>Grid and box of an OpenVDB load.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct VdbDesc
    {
        /// <summary>set by shd_vdb_desc_default()</summary>
        public uint StructSize;
        /// <summary>default none</summary>
        public VdbFlags Flags;
        /// <summary>name, at most 255 bytes; default NULL = the first grid of float or double</summary>
        public byte* Grid;
        /// <summary>first voxel of the box, in index space, -2^30..2^30; read with VdbFlags.Box</summary>
        public Int3 BoxMin;
        /// <summary>last voxel of the box, at least box_min on each axis; read with VdbFlags.Box</summary>
        public Int3 BoxMax;

        /// <summary>The defaults of the library.</summary>
        public static VdbDesc Default
        {
            get
            {
                VdbDesc made;
                ShdException.Check(Native.LibShd.DescInit(DescKind.VdbDesc, &made, (UIntPtr)sizeof(VdbDesc)));
                return made;
            }
        }
    }

    /// <summary>2 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct F32In2
    {
        public const int Length = 2;
        private F32In e0, e1;
        /// <summary>Element 0 .. 1.</summary>
        public F32In this[int index]
        {
            get { Inline.Check(index, Length); fixed (F32In* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (F32In* first = &e0) first[index] = value; }
        }
    }

    /// <summary>3 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct F32In3
    {
        public const int Length = 3;
        private F32In e0, e1, e2;
        /// <summary>Element 0 .. 2.</summary>
        public F32In this[int index]
        {
            get { Inline.Check(index, Length); fixed (F32In* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (F32In* first = &e0) first[index] = value; }
        }
    }

    /// <summary>4 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct F32In4
    {
        public const int Length = 4;
        private F32In e0, e1, e2, e3;
        /// <summary>Element 0 .. 3.</summary>
        public F32In this[int index]
        {
            get { Inline.Check(index, Length); fixed (F32In* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (F32In* first = &e0) first[index] = value; }
        }
    }

    /// <summary>2 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct F32Out2
    {
        public const int Length = 2;
        private F32Out e0, e1;
        /// <summary>Element 0 .. 1.</summary>
        public F32Out this[int index]
        {
            get { Inline.Check(index, Length); fixed (F32Out* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (F32Out* first = &e0) first[index] = value; }
        }
    }

    /// <summary>3 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct F32Out3
    {
        public const int Length = 3;
        private F32Out e0, e1, e2;
        /// <summary>Element 0 .. 2.</summary>
        public F32Out this[int index]
        {
            get { Inline.Check(index, Length); fixed (F32Out* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (F32Out* first = &e0) first[index] = value; }
        }
    }

    /// <summary>4 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct F32Out4
    {
        public const int Length = 4;
        private F32Out e0, e1, e2, e3;
        /// <summary>Element 0 .. 3.</summary>
        public F32Out this[int index]
        {
            get { Inline.Check(index, Length); fixed (F32Out* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (F32Out* first = &e0) first[index] = value; }
        }
    }

    /// <summary>4 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FloatPointer4
    {
        public const int Length = 4;
        private float* e0, e1, e2, e3;
        /// <summary>Element 0 .. 3.</summary>
        public float* this[int index]
        {
            get { Inline.Check(index, Length); fixed (float** first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (float** first = &e0) first[index] = value; }
        }
    }

    /// <summary>2 elements inside a struct.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct U32Out2
    {
        public const int Length = 2;
        private U32Out e0, e1;
        /// <summary>Element 0 .. 1.</summary>
        public U32Out this[int index]
        {
            get { Inline.Check(index, Length); fixed (U32Out* first = &e0) return first[index]; }
            set { Inline.Check(index, Length); fixed (U32Out* first = &e0) first[index] = value; }
        }
    }
}
