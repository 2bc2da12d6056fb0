// SPDX-License-Identifier: MIT
// Written by generate.py; do not edit.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd.Native
{
    /// <summary>Functions of shd, as in C.</summary>
    public static unsafe class LibShd
    {
#if NET5_0_OR_GREATER
        static LibShd() { Library.SetResolver(); }
#endif

        /// <summary>
        /// Shade the surfaces of draws into a framebuffer at their texture coordinates.
        ///
        /// A bake reads these fields of the frame: the framebuffer (with one sample per pixel), clear_color, camera or view,
        /// draws, lights, shadows, environment with its intensity and rotation, progress and stats. The view gives the eye.
        /// Vertex programs run; their clip positions have no effect. The other fields must have their defaults, except
        /// pass_triangles, which has no effect: all triangles are processed together. Depth becomes 1, and overdraw stays 0.
        ///
        /// Every draw has a material. Its colour replaces that of the texel: blends have no effect, and a is the opacity of the
        /// material. Fragments that a program or the alpha test drops leave their texel empty. MaterialFlags.DoubleSided and
        /// _ALPHA_TO_COVERAGE, and cull, fill, compare, depth biases and flags of a draw have no effect. The bits of the result
        /// do not depend on workers or SIMD targets.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_bake", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result Bake(IntPtr context, RenderDesc* frame, BakeDesc* desc);

        /// <summary>
        /// Version of the library that is running: major &lt;&lt; 16 | minor &lt;&lt; 8 | patch.
        ///
        /// It may differ from SHD_VERSION_*, which is the version of the headers.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_version", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint Version();

        /// <summary>Get the precision that the rules of a graphics API require at least.</summary>
        [DllImport("shd", EntryPoint = "shd_bounds_preset", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result BoundsPreset(Rules rules, BoundsDesc* outDesc);

        /// <summary>Compute the legal values of `lookups-&gt;count` lookups.</summary>
        [DllImport("shd", EntryPoint = "shd_texture_bounds", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureBounds(
            IntPtr texture, IntPtr sampler, Lookups* lookups, BoundsDesc* desc, Texels* lower, Texels* upper);

        /// <summary>Make a context.</summary>
        [DllImport("shd", EntryPoint = "shd_context_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ContextCreate(ContextDesc* desc, IntPtr* outContext);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_context_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ContextRetain(IntPtr context);

        /// <summary>Drop a reference; NULL is ignored. Objects hold references too; the last release frees everything. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_context_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ContextRelease(IntPtr context);

        /// <summary>
        /// Return the working memory that the context keeps between calls to the allocator. Calls that run at the same time
        /// keep theirs. NULL is ignored. Any thread.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_context_trim", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ContextTrim(IntPtr context);

        /// <summary>Name of the SIMD target of the context's kernels, such as "AVX2"; "" for a bad handle. Static.</summary>
        [DllImport("shd", EntryPoint = "shd_context_simd_target", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ContextSimdTarget(IntPtr context);

        /// <summary>Number of workers of the executor, at least 1; 0 for a bad handle.</summary>
        [DllImport("shd", EntryPoint = "shd_context_worker_count", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint ContextWorkerCount(IntPtr context);

        /// <summary>Write the defaults of a sized struct into the caller's memory and set its struct_size.</summary>
        [DllImport("shd", EntryPoint = "shd_desc_init", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result DescInit(DescKind kind, void* ptr, UIntPtr size);

        /// <summary>
        /// Find all edges of the requested kinds in a mesh. Each edge is listed once, in the order of the edges' first
        /// triangles.
        ///
        /// The result has the same bits on every machine.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_mesh_find_edges", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshFindEdges(
            IntPtr mesh, EdgesDesc* desc, UIntPtr capacity, Edges* @out, UIntPtr* outCount);

        /// <summary>
        /// Make an environment on the executor of the context.
        ///
        /// Kept: 11 bytes for each of 1 to 4 texels a pixel, of at least 64^2 (12 bytes each) and at most 2048^2 texels, and
        /// 4.2 MB or less for each kind of lobe. Temporary: 16 bytes a pixel, 224 bytes a row, and twice the bytes kept. Fixed:
        /// lobes and CONVOLVED take up to 12 MB of temporary memory more. Maps hold three channels of 16 bits with a common
        /// exponent: errors of up to 2^-16 of the largest channel.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_environment_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result EnvironmentCreate(IntPtr context, EnvironmentDesc* desc, IntPtr* outEnvironment);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_environment_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void EnvironmentRetain(IntPtr environment);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_environment_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void EnvironmentRelease(IntPtr environment);

        /// <summary>Get the properties of an environment.</summary>
        [DllImport("shd", EntryPoint = "shd_environment_get_info", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result EnvironmentGetInfo(IntPtr environment, EnvironmentInfo* outInfo);

        /// <summary>Look up the irradiance of surfaces whose normals are the directions, on the executor of the environment's context.</summary>
        [DllImport("shd", EntryPoint = "shd_environment_irradiance", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result EnvironmentIrradiance(
            IntPtr environment, EnvironmentLookups* lookups, EnvironmentLight* @out);

        /// <summary>Look up the radiance, or its mean over lobes, on the executor of the environment's context.</summary>
        [DllImport("shd", EntryPoint = "shd_environment_radiance", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result EnvironmentRadiance(
            IntPtr environment, EnvironmentLookups* lookups, EnvironmentLight* @out);

        /// <summary>Explain lookup `index` of a batch. Call once without memory for the counts, then again with it.</summary>
        [DllImport("shd", EntryPoint = "shd_texture_explain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureExplain(
            IntPtr texture, IntPtr sampler, Lookups* lookups, UIntPtr index, Explanation* explanation);

        /// <summary>
        /// Store `message` as the calling thread's shd_last_error() and return `result`.
        ///
        /// The message is copied and cut at 1023 bytes. It is not a format string.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_report_error", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ReportError(Result result, byte* message);

        /// <summary>Allocate from the context's allocator.</summary>
        [DllImport("shd", EntryPoint = "shd_context_allocate", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void* ContextAllocate(IntPtr context, UIntPtr size, UIntPtr alignment);

        /// <summary>Free memory with the size and alignment of its allocation; NULL is ignored.</summary>
        [DllImport("shd", EntryPoint = "shd_context_free", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ContextFree(IntPtr context, void* memory, UIntPtr size, UIntPtr alignment);

        /// <summary>Write a line to the context's log.</summary>
        [DllImport("shd", EntryPoint = "shd_context_log", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ContextLog(IntPtr context, LogLevel level, byte* message);

        /// <summary>Run tasks on the context's executor, with IEEE default floating-point control.</summary>
        [DllImport("shd", EntryPoint = "shd_context_parallel_for", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ContextParallelFor(IntPtr context, uint count, IntPtr task, void* taskData);

        /// <summary>Make a handle in the context's slabs, with one owned reference.</summary>
        [DllImport("shd", EntryPoint = "shd_object_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ObjectCreate(
            IntPtr context, uint type, void* body, IntPtr destroy, IntPtr* outObject);

        /// <summary>Body of a live handle of that type; NULL, with the error text set, for any other pointer value.</summary>
        [DllImport("shd", EntryPoint = "shd_object_body", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void* ObjectBody(IntPtr @object, uint type);

        /// <summary>Context of a handle; borrowed; NULL for a bad handle.</summary>
        [DllImport("shd", EntryPoint = "shd_object_context", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern IntPtr ObjectContext(IntPtr @object);

        /// <summary>Context of a framebuffer; borrowed; NULL for a bad handle.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_context", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern IntPtr FramebufferContext(IntPtr framebuffer);

        /// <summary>Add a reference; NULL is ignored.</summary>
        [DllImport("shd", EntryPoint = "shd_object_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ObjectRetain(IntPtr @object, uint type);

        /// <summary>Drop a reference; NULL is ignored.</summary>
        [DllImport("shd", EntryPoint = "shd_object_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ObjectRelease(IntPtr @object, uint type);

        /// <summary>
        /// Compute derivatives from ray differentials.
        ///
        /// The change of the hit point is d(o + t d) + dt d, with dt chosen so that it lies in the surface. It is then expressed
        /// in dp/du and dp/dv (Igehy, "Tracing Ray Differentials", 1999, sections 3.1 and 3.2).
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_derivatives_from_differentials", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result DerivativesFromDifferentials(RayDifferentials* rays, Derivatives* @out);

        /// <summary>
        /// Compute derivatives from ray cones.
        ///
        /// The derivatives are the axes of the ellipse in which the cone meets the surface: along the projected direction (x)
        /// and across it (y). Each is as long as the ellipse in its direction (Akenine-Moller et al., "Improved Shader and
        /// Texture Level of Detail Using Ray Cones", 2021, section 5). Angles between ray and surface below 2^-10 rad count as
        /// 2^-10 rad.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_derivatives_from_cones", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result DerivativesFromCones(RayCones* cones, Derivatives* @out);

        /// <summary>Make a framebuffer: colour 0, depth 1, AOVs 0, triangle and draw 0xffffffff.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result FramebufferCreate(IntPtr context, FramebufferDesc* desc, IntPtr* outFramebuffer);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void FramebufferRetain(IntPtr framebuffer);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void FramebufferRelease(IntPtr framebuffer);

        /// <summary>Get size and planes of a framebuffer.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_get_info", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result FramebufferGetInfo(IntPtr framebuffer, FramebufferInfo* outInfo);

        /// <summary>
        /// Get the position of a sample in its pixel. Positions and order are the standard sample locations of the Vulkan 1.3
        /// specification ("Multisampling"), which are those of Direct3D 11's standard pattern. They are multiples of 1/16 pixel.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_sample_position", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SamplePosition(uint samples, uint index, float* outX, float* outY);

        /// <summary>Get a plane without copying.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_view_plane", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result FramebufferViewPlane(IntPtr framebuffer, Plane plane, PlaneView* outView);

        /// <summary>Get interleaved colour without copying.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_view_color", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result FramebufferViewColor(IntPtr framebuffer, Image* outView);

        /// <summary>Copy a float plane into a column. R, G, B and A are decoded to linear floats if colour is interleaved.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_read_plane", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result FramebufferReadPlane(IntPtr framebuffer, Plane plane, F32Out* @out);

        /// <summary>Copy a plane of uint32_t into a column.</summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_read_u32_plane", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result FramebufferReadU32Plane(IntPtr framebuffer, Plane plane, U32Out* @out);

        /// <summary>
        /// Copy colour as interleaved RGBA. Pixels of the framebuffer's own color_format are copied bit by bit.
        ///
        /// Colour stays linear, except that Format.Rgba8Srgb is encoded. Integer formats clamp to 0..1 (NaN to 0) and round
        /// to nearest; sRGB codes are the correctly rounded ones of IEC 61966-2-1.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_framebuffer_read_color", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result FramebufferReadColor(IntPtr framebuffer, Image* @out);

        /// <summary>Bytes of one pixel; 0 for an unknown format, and for formats of blocks. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_format_size", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern UIntPtr FormatSize(Format format);

        /// <summary>Bytes of one block of 4 x 4 texels: 8 or 16; 0 for formats of pixels, and unknown ones. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_format_block_size", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern UIntPtr FormatBlockSize(Format format);

        /// <summary>Make a light.</summary>
        [DllImport("shd", EntryPoint = "shd_light_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result LightCreate(IntPtr context, LightDesc* desc, IntPtr* outLight);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_light_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void LightRetain(IntPtr light);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_light_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void LightRelease(IntPtr light);

        /// <summary>Filter `lookups-&gt;count` points of a texture.</summary>
        [DllImport("shd", EntryPoint = "shd_texture_sample", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureSample(IntPtr texture, IntPtr sampler, Lookups* lookups, Texels* @out);

        /// <summary>Compute the levels of detail of `lookups-&gt;count` points, as trilinear filtering uses them.</summary>
        [DllImport("shd", EntryPoint = "shd_texture_query_levels", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureQueryLevels(IntPtr texture, IntPtr sampler, Lookups* lookups, Levels* @out);

        /// <summary>Make a material.</summary>
        [DllImport("shd", EntryPoint = "shd_material_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MaterialCreate(IntPtr context, MaterialDesc* desc, IntPtr* outMaterial);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_material_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void MaterialRetain(IntPtr material);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_material_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void MaterialRelease(IntPtr material);

        /// <summary>
        /// Copy and check vertices and indices; compute normals if there are none.
        ///
        /// The call refuses these inputs, and the error text names the element: an index &gt;= vertex_count, an index count that is
        /// not a multiple of 3 (Topology.Triangles), a position that is not finite (unless MeshFlags.KeepNonfinite).
        /// Normals, uv, tangents and attributes that are not finite count as 0.
        ///
        /// @anchor tangents
        /// Tangents: the tangent t points towards increasing u, in the plane of the normal n. The bitangent is handedness *
        /// cross(n, t) and points towards decreasing v, up in the picture, as in glTF 2.0.
        ///
        /// MeshFlags.Tangents computes them to the MikkTSpace convention (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited",
        /// 2008) for (u, 1 - v). Vertices of equal position, normal and uv count as one. The directions of the triangles around
        /// it are weighted by angle, and triangles with mirrored uv stay apart. A vertex is split where mirrored and other
        /// triangles meet, and where it belongs to several fans that share no edge. The first part keeps the caller's vertex
        /// number. The copies have the other tangents; they follow the caller's vertices in the order of their originals. One
        /// rule differs from Mikkelsen's generator: at its threshold of 180 degrees it leaves a triangle out of a corner's sum
        /// if their directions are exactly opposite after rounding. Here each triangle of a fan counts for all its corners, so
        /// that folded or stretched uv do not split vertices.
        ///
        /// Triangles without area in uv, or with two corners at the same position, use the tangent of their neighbours at each
        /// vertex. A vertex without any tangent gets a unit vector perpendicular to n: the x axis projected into the plane of n,
        /// or the y axis where |n.x| &gt; 0.9. Such a vertex has degenerate or missing uv, has no triangles, or has directions that
        /// cancel. Its handedness is 1, or -1 where all its triangles are mirrored.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_mesh_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshCreate(IntPtr context, MeshDesc* desc, IntPtr* outMesh);

        /// <summary>Make the mesh of a shape: shd_shape_fill() and shd_mesh_create() in one call.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_create_shape", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshCreateShape(IntPtr context, ShapeDesc* desc, MeshFlags flags, IntPtr* outMesh);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void MeshRetain(IntPtr mesh);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void MeshRelease(IntPtr mesh);

        /// <summary>Get counts and bounds of a mesh.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_get_info", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshGetInfo(IntPtr mesh, MeshInfo* outInfo);

        /// <summary>Copy the positions out, object space.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_read_positions", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshReadPositions(IntPtr mesh, F32Out* @out);

        /// <summary>Copy the unit vertex normals out, given or computed.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_read_normals", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshReadNormals(IntPtr mesh, F32Out* @out);

        /// <summary>Copy the tangents out, given or computed; 0 if the mesh has none.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_read_tangents", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshReadTangents(IntPtr mesh, F32Out* @out);

        /// <summary>Copy the texture coordinates out; 0 if the mesh has none.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_read_uv", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshReadUv(IntPtr mesh, F32Out* @out);

        /// <summary>Copy the second set of texture coordinates out; 0 if the mesh has none.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_read_uv1", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshReadUv1(IntPtr mesh, F32Out* @out);

        /// <summary>Copy one of the caller's own columns out; 0 if it was absent.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_read_attribute", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshReadAttribute(IntPtr mesh, uint index, F32Out* @out);

        /// <summary>Copy the indices out as separate triangles, also for strips and fans.</summary>
        [DllImport("shd", EntryPoint = "shd_mesh_read_indices", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshReadIndices(IntPtr mesh, U32Out* @out);

        /// <summary>
        /// Make mip levels 1..level_count of an image, in the caller's memory, on the context's executor.
        ///
        /// With the defaults the levels are those of TableFlags.Mipmap. Results are clamped to the range of the format, because
        /// kernels with negative lobes can exceed it. Finite texels give finite levels.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_mip_build", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MipBuild(
            IntPtr context, Image* @base, MipDesc* desc, uint levelCount, Image* levels);

        /// <summary>
        /// Turn a normal map into the moments of its slopes, whose averages keep the roughness of normals.
        ///
        /// A texel is (bx, by, bx^2, by^2) with (bx, by) = (nx / nz, ny / nz), and bx by in an image of its own (Olano and
        /// Baker, "LEAN Mapping", 2010, section 3). Build the levels of the results as TexelContent.Data; any filter may
        /// read them. A filtered texel (bx, by, Mxx, Myy) and Mxy give the mean normal normalise(bx, by, 1) and the covariance
        /// of slopes (Mxx - bx^2, Mxy - bx by; Mxy - bx by, Myy - by^2), over which lobes are averaged (NormalEncoding).
        ///
        /// nz is raised to at least 1/32 of the normal's length, so |bx| and |by| are at most 32. Normals that point backwards
        /// are limited in the same way. A texel that is 0 or not finite becomes flat: four zeros.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_normal_moments", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result NormalMoments(IntPtr context, Image* normals, Image* @out, Image* mixed);

        /// <summary>Compute the occlusion of points.</summary>
        [DllImport("shd", EntryPoint = "shd_occlusion_compute", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result OcclusionCompute(
            IntPtr context, OcclusionDesc* desc, OcclusionPoints* points, F32Out* @out);

        /// <summary>Compute the occlusion of the vertices of a draw, with their vertex normals. Its mesh and object_to_world are read.</summary>
        [DllImport("shd", EntryPoint = "shd_occlusion_compute_vertices", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result OcclusionComputeVertices(
            IntPtr context, OcclusionDesc* desc, Draw* draw, F32Out* @out);

        /// <summary>
        /// Compute the occlusion of the texels of a texture, each at the point where shd_bake() shades it.
        ///
        /// Takes about 100 bytes of working memory for each texel.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_occlusion_bake", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result OcclusionBake(
            IntPtr context, OcclusionDesc* desc, OcclusionAtlas* atlas, F32Out* @out);

        /// <summary>Compute the barycentric coordinates of points.</summary>
        [DllImport("shd", EntryPoint = "shd_polygon_evaluate", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result PolygonEvaluate(
            IntPtr context, PolygonDesc* desc, PolygonPoints* points, PolygonWeights* @out);

        /// <summary>
        /// Project directions to points of an image, with derivatives.
        ///
        /// u and v are within 3e-7 of the exact values. Derivatives are those of the formulas above. Angles below 2^-50 rad
        /// from the poles of LAT_LONG and from the rim of MIRROR_BALL and ANGULAR, where a derivative goes to infinity, count as
        /// 2^-50 rad. NaN derivatives of directions count as 0, and so do finite components beside infinite ones. A component
        /// below 2^-100 of the largest one of its derivative may count as 0.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_project_directions", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ProjectDirections(IntPtr context, Directions* directions, ProjectedPoints* @out);

        /// <summary>
        /// Compute the directions of points of an image.
        ///
        /// The components of directions are within 4e-7 of the exact values; at a distance e from the rim of MIRROR_BALL, within
        /// 4e-7 + 1e-7 / sqrt(2 e). Solid angles are within 1e-5 of their largest value.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_unproject_directions", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result UnprojectDirections(IntPtr context, ImagePoints* points, PointDirections* @out);

        /// <summary>
        /// Convert images of directions to another projection, layout, size or format.
        ///
        /// Faces of the same projection and size are copied. Otherwise each texel becomes the average over its solid angle of
        /// the bilinear lookups of the source, in linear light. Samples along u and along v are at most half as far apart as the
        /// texels of the source (measured at the narrowest ones; on the equator of LAT_LONG; from LAT_LONG to LAT_LONG in
        /// columns), with at least 2 x 2 in each texel, weighted by their solid angle. Near the rim of a MIRROR_BALL target they
        /// are this far apart on average. LAT_LONG sources with far more texels along one axis than a target texel can resolve
        /// along both are averaged along it first, so that the work is at most about 64 samples for each pixel of the target and
        /// 16 for each pixel of the source. Equal texels give exactly their value. The integral over the sphere is kept to the
        /// rounding of the format and the error of the samples: docs/environments.md has measurements. Texels of MIRROR_BALL and
        /// ANGULAR outside the disc continue the image across the rim, so that bilinear lookups and mip levels there have no
        /// border. Unused parts of crosses become 0. Channels that the source lacks are 0, alpha 1; channels that the target
        /// lacks are dropped.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_projection_convert", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ProjectionConvert(IntPtr context, DirectionImages* from, DirectionImages* to);

        /// <summary>
        /// Render a frame.
        ///
        /// On Result.ErrorOutOfMemory, Result.ErrorCallback or Result.ErrorCancelled the framebuffer may hold a part of
        /// the frame; all other objects are unchanged, and the next render works.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_render", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result Render(IntPtr context, RenderDesc* desc);

        /// <summary>
        /// Text of the latest failure on the calling thread, "" if none.
        ///
        /// UTF-8, one line, at most 1023 bytes. Borrowed: valid until the next call of shd on this thread that fails. Success
        /// does not clear it.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_last_error", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* LastError();

        /// <summary>
        /// Name of a result as in the source, such as "Result.ErrorOutOfMemory"; "SHD_RESULT_UNKNOWN" for other values.
        ///
        /// The string is static.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_result_name", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ResultName(Result result);

        /// <summary>Make a sampler.</summary>
        [DllImport("shd", EntryPoint = "shd_sampler_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SamplerCreate(IntPtr context, SamplerDesc* desc, IntPtr* outSampler);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_sampler_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void SamplerRetain(IntPtr sampler);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_sampler_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void SamplerRelease(IntPtr sampler);

        /// <summary>Make a shadow without a map. Call shd_shadow_render() before any lookup.</summary>
        [DllImport("shd", EntryPoint = "shd_shadow_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ShadowCreate(IntPtr context, ShadowDesc* desc, IntPtr* outShadow);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_shadow_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ShadowRetain(IntPtr shadow);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_shadow_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ShadowRelease(IntPtr shadow);

        /// <summary>
        /// Render the map and replace the previous one. On failure the previous map stays.
        ///
        /// The cone of a spot has one map up to an outer angle of 1.1 rad [63 degrees], and six faces as a point light beyond.
        /// Filters read up to size / 8 texels (PCF and VARIANCE: size / 4) beyond the edge of a face, so each face is rendered
        /// wider by this margin. The fitted range uses the bounds of the meshes: set bounds and planes if vertex programs move
        /// the vertices. Bounds beyond 1e18 are Result.ErrorInvalidArgument. The map takes 4 bytes per texel (VARIANCE 8,
        /// SUMMED_AREA_VARIANCE 16), and during rendering 4 bytes per texel more and a framebuffer of up to 2048 x 2048 pixels.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_shadow_render", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ShadowRender(IntPtr context, IntPtr shadow, ShadowRenderDesc* desc);

        /// <summary>
        /// Compute the fraction of the light that reaches each point, 0 (in shadow) to 1 (lit), as frames do.
        ///
        /// Runs on the executor of the shadow's context.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_shadow_sample", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ShadowSample(IntPtr shadow, ShadowLookups* lookups, F32Out* @out);

        /// <summary>Compute the numbers of vertices and indices of a shape.</summary>
        [DllImport("shd", EntryPoint = "shd_shape_count", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ShapeCount(ShapeDesc* desc, uint* outVertexCount, UIntPtr* outIndexCount);

        /// <summary>Write a shape. Elements beyond the numbers from shd_shape_count() do not change.</summary>
        [DllImport("shd", EntryPoint = "shd_shape_fill", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ShapeFill(ShapeDesc* desc, ShapeColumns* columns);

        /// <summary>Evaluate a solid texture at `points-&gt;count` points.</summary>
        [DllImport("shd", EntryPoint = "shd_solid_evaluate", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SolidEvaluate(
            IntPtr context, SolidDesc* desc, SolidPoints* points, SolidValues* @out);

        /// <summary>
        /// Make a mesh of smaller triangles.
        ///
        /// Triangles follow the order of the original triangles. The vertices of `mesh` come first and keep their numbers and
        /// columns, except that -0 becomes 0; vertices on edges and inside triangles follow. Every column is interpolated
        /// linearly, normals and tangents are normalised, and handedness is the sign of the interpolated value. A triangle whose
        /// edges have different numbers of parts is cut into rows across its two most finely cut edges. Parts meet at vertices
        /// only, so a closed mesh stays closed.
        ///
        /// Displacement moves a vertex along its unit normal by amplitude * (texel - offset), with the texel at its uv. A height
        /// that is not finite, or moves a vertex beyond the range of float, counts as 0. Vertices at one position move together
        /// by the mean of their displacements, so seams of uv and creases stay closed. A sheet whose two sides are faces at the
        /// same positions therefore does not move. Tangents are projected into the planes of the new normals. Heights are looked
        /// up only at the vertices: if parts are longer than two texels of level `lod`, texels between vertices have no effect.
        ///
        /// If the result would have more than max_triangles, the call is refused before it allocates memory, and the error text
        /// names the field. In ADAPTIVE mode an edge with an end that is not finite has 1 part. The info of the new mesh has the
        /// normalless_count, tangentless_count and split_count of `mesh`.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_mesh_tessellate", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MeshTessellate(
            IntPtr context, IntPtr mesh, TessellationDesc* desc, IntPtr* outMesh);

        /// <summary>
        /// Make a texture: copy or borrow texels, and build the tables.
        ///
        /// Mip levels that are not given are area averages of the base level, exact for any size, computed in linear light.
        /// Levels of sRGB formats are stored sRGB-encoded and rounded to nearest.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_texture_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureCreate(IntPtr context, TextureDesc* desc, IntPtr* outTexture);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_texture_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void TextureRetain(IntPtr texture);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_texture_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void TextureRelease(IntPtr texture);

        /// <summary>Get size, format and memory of a texture.</summary>
        [DllImport("shd", EntryPoint = "shd_texture_get_info", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureGetInfo(IntPtr texture, TextureInfo* outInfo);

        /// <summary>
        /// Copy one mip level of a layer, or a slice of it in 3D, out as stored: sRGB stays encoded, and the swizzle does not
        /// apply. The fourth channel of a format of three is 0 here, while lookups give `fill`. Tiles of blocks are read again.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_texture_read_level", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureReadLevel(IntPtr texture, uint layer, uint level, Image* @out);

        /// <summary>
        /// Write a rectangle of the base level of one layer or slice, and rebuild the tables that depend on it. Textures of
        /// compressed blocks give Result.ErrorUnsupported.
        ///
        /// The texture then has the bits that shd_texture_create() gives for the changed base. Mip levels that the caller gave
        /// stay as they are.
        ///
        /// Cost: the first update of a layer whose size halves evenly several times rebuilds all its mip levels and keeps
        /// unrounded averages of every 16 x 16 texels (32 x 32 of floats), 1/32 of the memory of RGBA8 texels. Other updates
        /// compute only the texels that cover the rectangle. Levels below an odd width or height read all base texels under
        /// these texels; ripmap levels do so in whole rows. A summed-area table is recomputed for the whole layer. Levels of 3D
        /// textures read 16 slices under the rectangle, or all base texels below an odd size.
        ///
        /// If the base level is borrowed, the caller writes its texels before this call, while no other call uses the texture.
        /// `texels` then has the size of the rectangle, and its pixels are NULL.
        ///
        /// Nothing is written if an argument is refused or memory runs out. After Result.ErrorCallback, when the executor fails,
        /// the rectangle and the table entries that cover it are undefined until the same update succeeds.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_texture_update", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureUpdate(IntPtr texture, uint layer, uint x, uint y, Image* texels);

        /// <summary>Make a tile cache.</summary>
        [DllImport("shd", EntryPoint = "shd_tile_cache_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TileCacheCreate(IntPtr context, TileCacheDesc* desc, IntPtr* outCache);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_tile_cache_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void TileCacheRetain(IntPtr cache);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_tile_cache_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void TileCacheRelease(IntPtr cache);

        /// <summary>Get the counters of a cache.</summary>
        [DllImport("shd", EntryPoint = "shd_tile_cache_get_stats", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TileCacheGetStats(IntPtr cache, TileCacheStats* outStats);

        /// <summary>
        /// Load tiles that lookups with MissingTiles.Coarser did not find, the latest request first. A cache keeps the
        /// latest requests: up to 4096, or fewer if it has fewer tiles. An engine calls this on the threads that stream.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_tile_cache_load_requested", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TileCacheLoadRequested(IntPtr cache, uint maxTiles, uint* outLoaded);

        /// <summary>
        /// Load the tiles of a region that are not resident. They may be evicted again, also by later tiles of the region if it
        /// is larger than the cache.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_texture_load_tiles", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureLoadTiles(IntPtr texture, TileRegion* region);

        /// <summary>
        /// Load the tiles of a region, and keep them until shd_texture_unpin_tiles(). Each call counts. Half of the tiles of a
        /// cache can be pinned; more give Result.ErrorLimit. If the call fails, it pins no tile.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_texture_pin_tiles", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TexturePinTiles(IntPtr texture, TileRegion* region);

        /// <summary>
        /// Undo one shd_texture_pin_tiles() of the same region. A region with a tile that is not pinned gives
        /// Result.ErrorInvalidArgument, and nothing changes.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_texture_unpin_tiles", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureUnpinTiles(IntPtr texture, TileRegion* region);

        /// <summary>
        /// Drop the tiles of a region, and the tiles of all coarser levels that cover it, because their source has changed.
        /// Lookups that begin later load them again; lookups that run meanwhile may use either content. Pinned tiles stay
        /// pinned. This call loads them again. If a load fails, it returns the error, and the next call that needs a tile loads
        /// it.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_texture_drop_tiles", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureDropTiles(IntPtr texture, TileRegion* region);

        /// <summary>
        /// Perspective projection, view to clip space. With DepthOrder.Forward and a finite far plane it has the bits of
        /// shd_view_from_camera().
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_matrix_perspective", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixPerspective(
            float fovY, float aspect, float nearPlane, float farPlane, DepthOrder order, float* outMatrix);

        /// <summary>Parallel projection, view to clip space.</summary>
        [DllImport("shd", EntryPoint = "shd_matrix_orthographic", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixOrthographic(
            float* rectangle, float nearPlane, float farPlane, DepthOrder order, float* outMatrix);

        /// <summary>
        /// Rigid transform from world to view space: the eye is at the origin, the target on -Z. It has the bits of
        /// shd_view_from_camera().
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_matrix_look_at", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixLookAt(float* eye, float* target, float* up, float* outMatrix);

        /// <summary>translation * rotation * scale, as glTF 2.0 places nodes.</summary>
        [DllImport("shd", EntryPoint = "shd_matrix_from_trs", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixFromTrs(float* translation, float* rotation, float* scale, float* outMatrix);

        /// <summary>The product a b. Applied to a vector, b acts first.</summary>
        [DllImport("shd", EntryPoint = "shd_matrix_multiply", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixMultiply(float* a, float* b, float* outMatrix);

        /// <summary>The inverse. An affine matrix, with (0, 0, 0, 1) as its last row, has an affine inverse.</summary>
        [DllImport("shd", EntryPoint = "shd_matrix_invert", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixInvert(float* matrix, float* outMatrix);

        /// <summary>
        /// The matrix for normals that belongs to `matrix`: the inverse transpose of its upper left 3 x 3. Transformed normals
        /// are not unit vectors and need normalising. shd_render() transforms normals by itself.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_matrix_normal", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixNormal(float* matrix, float* out3x3);

        /// <summary>A point, (x, y, z, 1), transformed and divided by its w.</summary>
        [DllImport("shd", EntryPoint = "shd_matrix_transform_point", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixTransformPoint(float* matrix, float* point, float* outPoint);

        /// <summary>A direction, (x, y, z, 0), transformed; the translation and the last row of the matrix have no effect.</summary>
        [DllImport("shd", EntryPoint = "shd_matrix_transform_direction", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result MatrixTransformDirection(float* matrix, float* direction, float* outDirection);

        /// <summary>
        /// Compute the view of a camera; the same bits on every machine. An aspect of 0 counts as 1 here, because there is no
        /// picture. Frames that take the camera itself (RenderDesc.camera) use the aspect of their picture.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_view_from_camera", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ViewFromCamera(Camera* camera, View* outView);

        /// <summary>
        /// Make a volume. Finds the range of density in each block of the texture, so that rays skip blocks without extinction;
        /// the pictures have the same bits as without skipping. A texture in tiles loads each tile of its base level once; a
        /// tile that cannot be loaded fails the call.
        /// </summary>
        [DllImport("shd", EntryPoint = "shd_volume_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result VolumeCreate(IntPtr context, VolumeDesc* desc, IntPtr* outVolume);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_volume_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void VolumeRetain(IntPtr volume);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd", EntryPoint = "shd_volume_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void VolumeRelease(IntPtr volume);

    }

    /// <summary>Functions of shd_color, as in C.</summary>
    public static unsafe class LibShdColor
    {
#if NET5_0_OR_GREATER
        static LibShdColor() { Library.SetResolver(); }
#endif

        /// <summary>Text of the built-in config, as a starting point for other configs. Static. Any thread.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_default_config", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ColorDefaultConfig();

        /// <summary>Read a config.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ColorCreate(IntPtr context, ColorDesc* desc, IntPtr* outColor);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ColorRetain(IntPtr color);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void ColorRelease(IntPtr color);

        /// <summary>
        /// Transform a framebuffer for a display.
        ///
        /// The framebuffer is premultiplied by alpha. Its colour is divided by alpha, transformed, and written with
        /// straight (not premultiplied) alpha, as in PNG. Alpha is clamped to 0..1 (NaN to 0) and never encoded; a pixel of
        /// alpha 0 becomes 0, 0, 0, 0.
        ///
        /// The first call for a display and view builds the transform (about 10 ms), and the first one to an 8-bit image bakes
        /// it (6 ms for plain sRGB, 25 ms for ACES); later calls find it in a cache.
        /// </summary>
        [DllImport("shd_color", EntryPoint = "shd_color_apply_display", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ColorApplyDisplay(
            IntPtr color, IntPtr framebuffer, byte* display, byte* view, Image* @out);

        /// <summary>
        /// Render a frame and transform it for a display, tile by tile.
        ///
        /// The pixels are those of shd_render() with a framebuffer of color_format Format.Rgba32f, followed by
        /// shd_color_apply_display(). The worker that drew a tile transforms it as soon as it is finished, so that its colours
        /// are still in the caches. The framebuffer holds the frame as after shd_render(). A framebuffer of color_format
        /// Format.Rgba8 saves memory traffic; its rounding has no effect on `out`, except for pixels that the frame leaves
        /// unchanged (shd/present.h).
        /// </summary>
        [DllImport("shd_color", EntryPoint = "shd_color_render", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ColorRender(
            IntPtr color, RenderDesc* render, byte* display, byte* view, Image* @out);

        /// <summary>
        /// Callback for Display.apply that calls shd_color_apply_display(), so that one call saves a display image:
        /// `save.display.apply = shd_color_apply_view, save.display.user_data = &amp;view`.
        /// </summary>
        [DllImport("shd_color", EntryPoint = "shd_color_apply_view", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ColorApplyView(void* colorView, IntPtr framebuffer, Image* @out);

        /// <summary>Transform an image for a display, as shd_color_apply_display() does with a framebuffer.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_apply_display_image", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ColorApplyDisplayImage(
            IntPtr color, Image* @in, byte* fromSpace, byte* display, byte* view, Image* @out);

        /// <summary>
        /// Convert an image from one colour space to another in place.
        ///
        /// For example, convert a texture from "ACEScg" to the working space before shd_texture_create(). Alpha is
        /// unchanged and not multiplied in.
        /// </summary>
        [DllImport("shd_color", EntryPoint = "shd_color_convert", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ColorConvert(IntPtr color, byte* fromSpace, byte* toSpace, Image* inOut);

        /// <summary>Number of displays; 0 for a bad handle.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_display_count", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint ColorDisplayCount(IntPtr color);

        /// <summary>Name of a display; borrowed until release; NULL if there is none. Index 0 is not always the default.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_display_name", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ColorDisplayName(IntPtr color, uint index);

        /// <summary>Name of the default display; borrowed until release; NULL for a bad handle.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_default_display", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ColorDefaultDisplay(IntPtr color);

        /// <summary>Number of views of a display, NULL = the default one; 0 for an unknown display.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_view_count", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint ColorViewCount(IntPtr color, byte* display);

        /// <summary>Name of a view of a display, NULL = the default one; borrowed until release; NULL if there is none.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_view_name", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ColorViewName(IntPtr color, byte* display, uint index);

        /// <summary>Default view of a display, NULL = the default one; borrowed until release; NULL if there is none.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_default_view", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ColorDefaultView(IntPtr color, byte* display);

        /// <summary>Number of colour spaces, including those of the displays.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_space_count", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint ColorSpaceCount(IntPtr color);

        /// <summary>Name of a colour space; borrowed until release; NULL if there is none.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_space_name", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ColorSpaceName(IntPtr color, uint index);

        /// <summary>Name of the working space; borrowed until release; NULL for a bad handle.</summary>
        [DllImport("shd_color", EntryPoint = "shd_color_working_space", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* ColorWorkingSpace(IntPtr color);

    }

    /// <summary>Functions of shd_embree, as in C.</summary>
    public static unsafe class LibShdEmbree
    {
#if NET5_0_OR_GREATER
        static LibShdEmbree() { Library.SetResolver(); }
#endif

        /// <summary>Build a tree of the triangles of draws. Triangles with a position that is not finite are left out.</summary>
        [DllImport("shd_embree", EntryPoint = "shd_embree_create", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result EmbreeCreate(IntPtr context, Draw* draws, UIntPtr drawCount, IntPtr* outEmbree);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd_embree", EntryPoint = "shd_embree_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void EmbreeRetain(IntPtr embree);

        /// <summary>Drop a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd_embree", EntryPoint = "shd_embree_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void EmbreeRelease(IntPtr embree);

        /// <summary>Get the tracer of a tree.</summary>
        [DllImport("shd_embree", EntryPoint = "shd_embree_get_tracer", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result EmbreeGetTracer(IntPtr embree, Tracer* outTracer);

    }

    /// <summary>Functions of shd_io, as in C.</summary>
    public static unsafe class LibShdIo
    {
#if NET5_0_OR_GREATER
        static LibShdIo() { Library.SetResolver(); }
#endif

        /// <summary>
        /// Read an image file.
        ///
        /// The result has channels R, G, B, A: the channels with these names, or the first ones if no channel has such a name. A
        /// single channel (with or without alpha) is grey, r = g = b. If there is no alpha, it is 1. 8-bit integers become
        /// RGBA8_SRGB or RGBA8, 16-bit integers RGBA16, half floats RGBA16F, all others RGBA32F. No transfer curve is applied.
        /// An EXR data window is placed into its display window: pixels outside the data window are zero, and parts outside the
        /// display window are cropped. EXIF orientation is not applied. Deep images, subsampled channels and volumes are
        /// Result.ErrorUnsupported.
        /// </summary>
        [DllImport("shd_io", EntryPoint = "shd_bitmap_load", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result BitmapLoad(IntPtr context, byte* path, LoadDesc* desc, IntPtr* outBitmap);

        /// <summary>Read an image file that is in memory, as shd_bitmap_load() does.</summary>
        [DllImport("shd_io", EntryPoint = "shd_bitmap_load_memory", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result BitmapLoadMemory(
            IntPtr context, void* bytes, UIntPtr size, LoadDesc* desc, IntPtr* outBitmap);

        /// <summary>Add a reference; NULL is ignored.</summary>
        [DllImport("shd_io", EntryPoint = "shd_bitmap_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void BitmapRetain(IntPtr bitmap);

        /// <summary>Drop a reference; NULL is ignored.</summary>
        [DllImport("shd_io", EntryPoint = "shd_bitmap_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void BitmapRelease(IntPtr bitmap);

        /// <summary>Get the pixels without copying.</summary>
        [DllImport("shd_io", EntryPoint = "shd_bitmap_image", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result BitmapImage(IntPtr bitmap, Image* outImage);

        /// <summary>
        /// Colour space of the pixels: "sRGB", "Linear Rec.709", "ACEScg", "ACES2065-1", "Rec709", "Gamma2.2" (any
        /// number), "data", or the name in the file (printable ASCII, at most 63 characters).
        ///
        /// A file without a declared colour space is sRGB if its channels are integers and Linear Rec.709 if they are floats;
        /// PNM of integers is Rec709, as its specification requires.
        /// </summary>
        [DllImport("shd_io", EntryPoint = "shd_bitmap_color_space", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* BitmapColorSpace(IntPtr bitmap);

        /// <summary>Get format and properties of a loaded file.</summary>
        [DllImport("shd_io", EntryPoint = "shd_bitmap_get_info", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result BitmapGetInfo(IntPtr bitmap, BitmapInfo* outInfo);

        /// <summary>
        /// Make a texture from a file. The content decides its kind:
        ///
        ///  - Images (2D). sRGB and linear 8-bit files become RGBA8_SRGB and RGBA8, linear half files RGBA16F and linear float
        ///    files RGBA32F with the same numbers. All others (16-bit integers, other transfer curves) are linearised to
        ///    RGBA32F. Primaries are not converted; callers who need this use shd_bitmap_load(). Premultiplied files
        ///    (BitmapFlags.Premultiplied) give TextureFlags.Premultiplied textures. A colour space that shd_bitmap_color_space()
        ///    does not list is Result.ErrorUnsupported unless desc.color_space overrides it. The mip levels are those of
        ///    shd_texture_create(): exact averages of the base in linear light. Levels in the file are ignored unless
        ///    LoadFlags.FileLevels is set; then they are converted like the base.
        ///  - KTX 2.0 and DDS (2D, 3D, arrays, cube maps), as they are stored, with all levels; see shd/texture_file.h.
        ///  - OpenVDB (3D), and with desc.raw or desc.stack voxels and stacks of images; see shd/volume_file.h.
        ///
        /// Textures whose tiles stay in a file are opened by shd_texture_open().
        /// </summary>
        [DllImport("shd_io", EntryPoint = "shd_texture_load", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureLoad(IntPtr context, byte* path, LoadDesc* desc, IntPtr* outTexture);

        /// <summary>Make a texture from a file that is in memory, as shd_texture_load() does. desc.stack is Result.ErrorInvalidArgument.</summary>
        [DllImport("shd_io", EntryPoint = "shd_texture_load_memory", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureLoadMemory(
            IntPtr context, void* bytes, UIntPtr size, LoadDesc* desc, IntPtr* outTexture);

        /// <summary>
        /// Write a framebuffer. The extension of `path` decides the format:
        ///
        /// `.exr`          R, G, B, A as half or float, linear, premultiplied, and every other plane under its usual
        ///                 name: Z (0 near .. 1 far), uv.u, uv.v, uv.dudx, uv.dvdx, uv.dudy, uv.dvdy, N.x, N.y, N.z, P.x, P.y,
        ///                 P.z, bary.0, bary.1, bary.2, lod (float), triangle, level, draw, overdraw (uint);
        /// `.hdr`          r, g, b, linear, premultiplied (negative numbers become 0);
        /// `.png`          straight alpha; colour clamped to 0..1, NaN to 0, sRGB-encoded, rounded to nearest;
        ///                 `display` and `dither` replace the last two steps;
        /// `.tif` `.tiff`  8 and 16 bits as PNG, 32 bits float as EXR.
        ///
        /// The file appears whole or not at all: it is written to a temporary file beside it, flushed to the disk and renamed. A
        /// failure does not change the previous file, and readers that have it open keep the old contents. A symbolic link is
        /// followed; a path that names something other than a regular file is refused.
        /// </summary>
        [DllImport("shd_io", EntryPoint = "shd_framebuffer_save", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result FramebufferSave(IntPtr framebuffer, byte* path, SaveDesc* desc);

        /// <summary>
        /// Write an image without conversion. Paths and files are handled as by shd_framebuffer_save().
        ///
        /// PNG accepts R8, RGBA8, RGBA8_SRGB and RGBA16; EXR accepts RGBA16F and RGBA32F; HDR accepts RGBA32F; TIFF accepts all
        /// except RGBA16F; TGA and BMP accept R8, RGBA8 and RGBA8_SRGB. Alpha is tagged as straight, except in EXR.
        /// </summary>
        [DllImport("shd_io", EntryPoint = "shd_image_save", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ImageSave(Image* image, byte* path, SaveDesc* desc);

        /// <summary>
        /// Write a texture to a KTX 2.0 file: all levels, layers, slices and faces, as stored. Blocks stay compressed. The
        /// swizzle of the texture is not written.
        ///
        /// The file appears whole or not at all, as described for shd_framebuffer_save().
        /// </summary>
        [DllImport("shd_io", EntryPoint = "shd_texture_save_ktx2", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureSaveKtx2(IntPtr texture, byte* path, Ktx2Desc* desc);

        /// <summary>
        /// Open a tiled file, or a UDIM set, as a texture.
        ///
        /// Files that are not tiled, or lack mip levels although they are larger than a tile, give Result.ErrorUnsupported:
        /// shd-maketx converts them. Files whose levels do not halve (rounded down), or differ in channels, give
        /// Result.ErrorUnsupported or Result.ErrorCorrupt. Tiles have at most 2^26 bytes. This does not apply to KTX2 and DDS files;
        /// sets of them give Result.ErrorUnsupported.
        /// </summary>
        [DllImport("shd_io", EntryPoint = "shd_texture_open", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result TextureOpen(
            IntPtr context, byte* path, TileFileDesc* desc, IntPtr* outTexture, TileFileInfo* outInfo);

    }

    /// <summary>Functions of shd_scene, as in C.</summary>
    public static unsafe class LibShdScene
    {
#if NET5_0_OR_GREATER
        static LibShdScene() { Library.SetResolver(); }
#endif

        /// <summary>
        /// Read a model file.
        ///
        /// Materials: unlit materials become Model.Unlit, and those that transmit at least half of the light and are no
        /// metals Model.Glass, which needs an environment. Others with a roughness become Model.MetallicRoughness, and
        /// the rest Model.BlinnPhong. All reflect ambient light with their diffuse colour (ambient_share = 1). Every slot
        /// whose texture is in the file is set. Heights have no effect unless the file scales them. An opacity below 1, an
        /// opacity map and glTF's BLEND become Blend.Sorted; glTF's MASK becomes alpha_cutoff, and a cutoff above 1 makes
        /// the opacity 0. The first two sets of texture coordinates are used. Colours of vertices are the attributes 0 to 3 of a
        /// mesh, and multiply the diffuse colour and the opacity.
        ///
        /// Faces: the backs of surfaces that are not double-sided are culled; a node that mirrors turns the front around.
        ///
        /// Normals that the file has not, and normals of length 0 or not finite, are computed.
        ///
        /// Lights: points, spots, directional and ambient ones, with the file's numbers as intensities. If the light of the file
        /// does not decrease with the square of the distance, its intensity is chosen so that both agree at the distance of half
        /// the diagonal of the model.
        ///
        /// Skins and morph targets have the pose and the weights of the file; shd_scene_pose() samples animations. Points and
        /// lines are left out.
        ///
        /// A model whose centre is more than 1024 radii away from 0 is moved to 0, because floats would lose its details:
        /// SceneInfo.origin.
        /// </summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_load", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneLoad(IntPtr context, byte* path, SceneDesc* desc, IntPtr* outScene);

        /// <summary>Read a model file in memory. The files that it names come from SceneDesc.find.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_load_memory", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneLoadMemory(
            IntPtr context, void* bytes, UIntPtr size, byte* name, SceneDesc* desc, IntPtr* outScene);

        /// <summary>Add a reference; NULL is ignored. Any thread.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_retain", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void SceneRetain(IntPtr scene);

        /// <summary>Drop a reference; NULL is ignored. Handles that the caller retained stay. Any thread.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_release", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void SceneRelease(IntPtr scene);

        /// <summary>Counts and bounds of a scene.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_get_info", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneGetInfo(IntPtr scene, SceneInfo* outInfo);

        /// <summary>A problem with a part of the file, as one line of UTF-8. All warnings are also written to the log of the context.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_warning", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* SceneWarning(IntPtr scene, uint index);

        /// <summary>Name of a part in the file, made printable, at most 400 bytes; may be "".</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_name", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* SceneName(IntPtr scene, ScenePart part, uint index);

        /// <summary>A mesh; borrowed until release of the scene (retain it to keep it longer); NULL if there is none.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_mesh", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern IntPtr SceneMesh(IntPtr scene, uint index);

        /// <summary>A material; borrowed until release of the scene; NULL if there is none.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_material", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern IntPtr SceneMaterial(IntPtr scene, uint index);

        /// <summary>A texture; borrowed until release of the scene; NULL if there is none.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_texture", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern IntPtr SceneTexture(IntPtr scene, uint index);

        /// <summary>A light; borrowed until release of the scene; NULL if there is none.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_light", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern IntPtr SceneLight(IntPtr scene, uint index);

        /// <summary>The desc of a material, as a starting point for variants of it.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_get_material_desc", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneGetMaterialDesc(IntPtr scene, uint index, MaterialDesc* outDesc);

        /// <summary>The desc of a light.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_get_light_desc", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneGetLightDesc(IntPtr scene, uint index, LightDesc* outDesc);

        /// <summary>
        /// A camera of the file. If the file has no aspect, it is 0, which means the aspect of the picture. If the file has no
        /// near and far plane, they enclose the whole model.
        /// </summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_get_camera", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneGetCamera(IntPtr scene, uint index, Camera* outCamera);

        /// <summary>An instance of the scene.</summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_get_instance", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneGetInstance(IntPtr scene, uint index, SceneInstance* outInstance);

        /// <summary>
        /// Set draws, draw_count, lights and light_count of a frame: one draw for each instance, in their order, and the lights
        /// of the file. All other fields stay as they are. The caller sets the camera and the framebuffer, and adds lights if
        /// the file has none.
        /// </summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_fill_render", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneFillRender(IntPtr scene, RenderDesc* inOutRender);

        /// <summary>
        /// The times of an animation [s]: its first key and its last one. Poses before and after are those of the keys. Its name
        /// is that of ScenePart.Animation.
        /// </summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_get_animation_times", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result SceneGetAnimationTimes(
            IntPtr scene, uint index, double* outFirst, double* outLast);

        /// <summary>
        /// Make a scene of the file at some second of an animation, with all that nodes move: instances, skins, morph targets,
        /// lights and cameras. Interpolation is that of glTF 2.0, appendix C. The new scene does not depend on the pose of
        /// `scene`. It shares materials, textures and all meshes without skins and morph targets with it; parts keep their
        /// indices, except instances, lights and cameras whose numbers are out of range in the pose, which give a warning.
        /// </summary>
        [DllImport("shd_scene", EntryPoint = "shd_scene_pose", CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Result ScenePose(IntPtr scene, uint animation, double seconds, IntPtr* outScene);

    }
}
