// SPDX-License-Identifier: MIT
// Written by generate.py; do not edit.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>
    /// Points to shade, one row each, as packed columns of `count` elements; borrowed for the call.
    ///
    /// A row is a visible fragment at Phong frequency, a vertex at Gouraud frequency, and a triangle's centroid at flat
    /// frequency. For vertices and centroids x, y, depth and the derivatives are 0.
    /// </summary>
    public readonly unsafe ref struct Fragments
    {
        private readonly Native.Fragments* raw;
        /// <summary>Rows.</summary>
        public readonly int Count;
        internal Fragments(Native.Fragments* from) { raw = from; Count = (int)from->Count; }
        /// <summary>index into RenderDesc.draws; the same for every row</summary>
        public uint Draw { get { return raw->Draw; } }
        /// <summary>index into Draw.instances, 0 without instances; the same for every row</summary>
        public uint Instance { get { return raw->Instance; } }
        /// <summary>MaterialDesc.varying_count</summary>
        public uint VaryingCount { get { return raw->VaryingCount; } }
        /// <summary>number of `attribute` columns</summary>
        public uint AttributeCount { get { return raw->AttributeCount; } }
        /// <summary>Draw.uniforms</summary>
        public IntPtr Uniforms { get { return (IntPtr)raw->Uniforms; } }
        /// <summary>
        /// Raster position, pixels from the left edge. It is the centre of the pixel, or the mean of the covered samples if
        /// there are several samples and the triangle does not cover the centre. With DrawFlags.SampleShading it is the
        /// position of the sample.
        /// </summary>
        public ReadOnlySpan<float> X { get { return Inline.Read<float>(raw->X, Count); } }
        /// <summary>raster position, pixels from the top edge, as x</summary>
        public ReadOnlySpan<float> Y { get { return Inline.Read<float>(raw->Y, Count); } }
        /// <summary>depth-buffer value, 0 near .. 1 far</summary>
        public ReadOnlySpan<float> Depth { get { return Inline.Read<float>(raw->Depth, Count); } }
        /// <summary>index of the triangle in its mesh</summary>
        public ReadOnlySpan<uint> Triangle { get { return Inline.Read<uint>(raw->Triangle, Count); } }
        /// <summary>position, world space</summary>
        public ReadOnlySpan<float> Px { get { return Inline.Read<float>(raw->Px, Count); } }
        /// <summary>position, world space</summary>
        public ReadOnlySpan<float> Py { get { return Inline.Read<float>(raw->Py, Count); } }
        /// <summary>position, world space</summary>
        public ReadOnlySpan<float> Pz { get { return Inline.Read<float>(raw->Pz, Count); } }
        /// <summary>shading normal, world space, unit</summary>
        public ReadOnlySpan<float> Nx { get { return Inline.Read<float>(raw->Nx, Count); } }
        /// <summary>shading normal, world space, unit</summary>
        public ReadOnlySpan<float> Ny { get { return Inline.Read<float>(raw->Ny, Count); } }
        /// <summary>shading normal, world space, unit</summary>
        public ReadOnlySpan<float> Nz { get { return Inline.Read<float>(raw->Nz, Count); } }
        /// <summary>wo: towards the eye, world space, unit (0 at the eye itself)</summary>
        public ReadOnlySpan<float> Ox { get { return Inline.Read<float>(raw->Ox, Count); } }
        /// <summary>wo: towards the eye, world space, unit (0 at the eye itself)</summary>
        public ReadOnlySpan<float> Oy { get { return Inline.Read<float>(raw->Oy, Count); } }
        /// <summary>wo: towards the eye, world space, unit (0 at the eye itself)</summary>
        public ReadOnlySpan<float> Oz { get { return Inline.Read<float>(raw->Oz, Count); } }
        /// <summary>
        /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
        /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
        /// </summary>
        public ReadOnlySpan<float> Tx { get { return Inline.Read<float>(raw->Tx, Count); } }
        /// <summary>
        /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
        /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
        /// </summary>
        public ReadOnlySpan<float> Ty { get { return Inline.Read<float>(raw->Ty, Count); } }
        /// <summary>
        /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
        /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
        /// </summary>
        public ReadOnlySpan<float> Tz { get { return Inline.Read<float>(raw->Tz, Count); } }
        /// <summary>
        /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
        /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
        /// </summary>
        public ReadOnlySpan<float> Tw { get { return Inline.Read<float>(raw->Tw, Count); } }
        /// <summary>texture coordinates, perspective-correct</summary>
        public ReadOnlySpan<float> U { get { return Inline.Read<float>(raw->U, Count); } }
        /// <summary>texture coordinates, perspective-correct</summary>
        public ReadOnlySpan<float> V { get { return Inline.Read<float>(raw->V, Count); } }
        /// <summary>second set of texture coordinates; 0 if the mesh has none</summary>
        public ReadOnlySpan<float> U1 { get { return Inline.Read<float>(raw->U1, Count); } }
        /// <summary>second set of texture coordinates; 0 if the mesh has none</summary>
        public ReadOnlySpan<float> V1 { get { return Inline.Read<float>(raw->V1, Count); } }
        /// <summary>analytic derivatives of u, v along one pixel to the right</summary>
        public ReadOnlySpan<float> Dudx { get { return Inline.Read<float>(raw->Dudx, Count); } }
        /// <summary>analytic derivatives of u, v along one pixel to the right</summary>
        public ReadOnlySpan<float> Dvdx { get { return Inline.Read<float>(raw->Dvdx, Count); } }
        /// <summary>analytic derivatives of u, v along one pixel down</summary>
        public ReadOnlySpan<float> Dudy { get { return Inline.Read<float>(raw->Dudy, Count); } }
        /// <summary>analytic derivatives of u, v along one pixel down</summary>
        public ReadOnlySpan<float> Dvdy { get { return Inline.Read<float>(raw->Dvdy, Count); } }
        /// <summary>[attribute_count] columns of the mesh, interpolated; NULL for absent ones</summary>
        public ReadOnlySpan<float> Attribute(int index) { return Inline.Read<float>(raw->Attribute[Inline.Check(index, raw->AttributeCount)], Count); }
        /// <summary>
        /// [varying_count] columns of the vertex program, interpolated by MaterialDesc.interpolation. At Gouraud
        /// frequency they are the values of the vertex, at flat frequency the mean of the triangle's three vertices. FLAT
        /// varyings have the value of the first vertex at every frequency.
        /// </summary>
        public ReadOnlySpan<float> Varying(int index) { return Inline.Read<float>(raw->Varying[Inline.Check(index, raw->VaryingCount)], Count); }
    }

    /// <summary>Output of a program: scene-linear, premultiplied by a. r, g, b start as 0 and a as 1.</summary>
    public readonly unsafe ref struct Radiance
    {
        private readonly Native.Radiance* raw;
        /// <summary>Rows.</summary>
        public readonly int Count;
        internal Radiance(Native.Radiance* from, int rows) { raw = from; Count = rows; }
        /// <summary>number of `target` elements: 3</summary>
        public uint TargetCount { get { return raw->TargetCount; } }
        /// <summary>packed columns of `count` elements</summary>
        public Span<float> R { get { return Inline.Write<float>(raw->R, Count); } }
        /// <summary>packed columns of `count` elements</summary>
        public Span<float> G { get { return Inline.Write<float>(raw->G, Count); } }
        /// <summary>packed columns of `count` elements</summary>
        public Span<float> B { get { return Inline.Write<float>(raw->B, Count); } }
        /// <summary>packed columns of `count` elements</summary>
        public Span<float> A { get { return Inline.Write<float>(raw->A, Count); } }
        /// <summary>starts as 0; any other value drops the row. NULL without MaterialFlags.Discards</summary>
        public Span<uint> Discard { get { return Inline.Write<uint>(raw->Discard, Count); } }
        /// <summary>
        /// [target_count] r, g, b, a of AovFlags.Target1, 2 and 3; start as 0. NULL for
        /// targets that the framebuffer lacks
        /// </summary>
        public Span<float> Target(int index, int channel) { return Inline.Write<float>(raw->Target == null ? null : raw->Target[Inline.Check(index, raw->TargetCount) * 4 + Inline.Check(channel, 4)], Count); }
    }

    /// <summary>
    /// Neighbouring vertices of one draw, one row each, as packed columns of `count` elements; borrowed for the call.
    ///
    /// Every vertex of a triangle is processed for each instance of the draw, up to 512 vertices per call. It is processed
    /// once, or once in each pass that needs it if the frame has several passes (RenderDesc.pass_triangles). The
    /// grouping of vertices and the order of calls are unspecified.
    /// </summary>
    public readonly unsafe ref struct Vertices
    {
        private readonly Native.Vertices* raw;
        /// <summary>Rows.</summary>
        public readonly int Count;
        internal Vertices(Native.Vertices* from) { raw = from; Count = (int)from->Count; }
        /// <summary>index into RenderDesc.draws</summary>
        public uint Draw { get { return raw->Draw; } }
        /// <summary>index into Draw.instances, 0 without instances</summary>
        public uint Instance { get { return raw->Instance; } }
        /// <summary>row i is vertex first + i of the mesh</summary>
        public uint First { get { return raw->First; } }
        /// <summary>number of `attribute` columns</summary>
        public uint AttributeCount { get { return raw->AttributeCount; } }
        /// <summary>position, object space</summary>
        public ReadOnlySpan<float> Px { get { return Inline.Read<float>(raw->Px, Count); } }
        /// <summary>position, object space</summary>
        public ReadOnlySpan<float> Py { get { return Inline.Read<float>(raw->Py, Count); } }
        /// <summary>position, object space</summary>
        public ReadOnlySpan<float> Pz { get { return Inline.Read<float>(raw->Pz, Count); } }
        /// <summary>normal, object space, unit</summary>
        public ReadOnlySpan<float> Nx { get { return Inline.Read<float>(raw->Nx, Count); } }
        /// <summary>normal, object space, unit</summary>
        public ReadOnlySpan<float> Ny { get { return Inline.Read<float>(raw->Ny, Count); } }
        /// <summary>normal, object space, unit</summary>
        public ReadOnlySpan<float> Nz { get { return Inline.Read<float>(raw->Nz, Count); } }
        /// <summary>tangent, object space, and handedness; NULL if the mesh has no tangents</summary>
        public ReadOnlySpan<float> Tx { get { return Inline.Read<float>(raw->Tx, Count); } }
        /// <summary>tangent, object space, and handedness; NULL if the mesh has no tangents</summary>
        public ReadOnlySpan<float> Ty { get { return Inline.Read<float>(raw->Ty, Count); } }
        /// <summary>tangent, object space, and handedness; NULL if the mesh has no tangents</summary>
        public ReadOnlySpan<float> Tz { get { return Inline.Read<float>(raw->Tz, Count); } }
        /// <summary>tangent, object space, and handedness; NULL if the mesh has no tangents</summary>
        public ReadOnlySpan<float> Tw { get { return Inline.Read<float>(raw->Tw, Count); } }
        /// <summary>texture coordinates; 0 if the mesh has none</summary>
        public ReadOnlySpan<float> U { get { return Inline.Read<float>(raw->U, Count); } }
        /// <summary>texture coordinates; 0 if the mesh has none</summary>
        public ReadOnlySpan<float> V { get { return Inline.Read<float>(raw->V, Count); } }
        /// <summary>second set of texture coordinates; NULL if the mesh has none</summary>
        public ReadOnlySpan<float> U1 { get { return Inline.Read<float>(raw->U1, Count); } }
        /// <summary>second set of texture coordinates; NULL if the mesh has none</summary>
        public ReadOnlySpan<float> V1 { get { return Inline.Read<float>(raw->V1, Count); } }
        /// <summary>[attribute_count] columns of the mesh; NULL for absent ones</summary>
        public ReadOnlySpan<float> Attribute(int index) { return Inline.Read<float>(raw->Attribute[Inline.Check(index, raw->AttributeCount)], Count); }
        /// <summary>[16], column-major; of the instance</summary>
        public Matrix4 ObjectToWorld { get { return *(Matrix4*)raw->ObjectToWorld; } }
        /// <summary>[16], column-major</summary>
        public Matrix4 WorldToView { get { return *(Matrix4*)raw->WorldToView; } }
        /// <summary>[16], column-major</summary>
        public Matrix4 ViewToClip { get { return *(Matrix4*)raw->ViewToClip; } }
        /// <summary>[3], world space</summary>
        public Float3 Eye { get { return *(Float3*)raw->Eye; } }
        /// <summary>Draw.uniforms</summary>
        public IntPtr Uniforms { get { return (IntPtr)raw->Uniforms; } }
    }

    /// <summary>
    /// Values that a program may change, as packed columns of `count` elements.
    ///
    /// Each column starts with the values that the draw has without a program. A vertex whose values stay unchanged gives
    /// the same bits as without a program. Triangles with a vertex that has NaN or infinity in any column are dropped;
    /// RenderStats.nonfinite counts them.
    /// </summary>
    public readonly unsafe ref struct VertexOutputs
    {
        private readonly Native.VertexOutputs* raw;
        /// <summary>Rows.</summary>
        public readonly int Count;
        internal VertexOutputs(Native.VertexOutputs* from, int rows) { raw = from; Count = rows; }
        /// <summary>MaterialDesc.varying_count</summary>
        public uint VaryingCount { get { return raw->VaryingCount; } }
        /// <summary>clip space: visible with -w..w for x and y, 0..w for z</summary>
        public Span<float> X { get { return Inline.Write<float>(raw->X, Count); } }
        /// <summary>clip space: visible with -w..w for x and y, 0..w for z</summary>
        public Span<float> Y { get { return Inline.Write<float>(raw->Y, Count); } }
        /// <summary>clip space: visible with -w..w for x and y, 0..w for z</summary>
        public Span<float> Z { get { return Inline.Write<float>(raw->Z, Count); } }
        /// <summary>clip space: visible with -w..w for x and y, 0..w for z</summary>
        public Span<float> W { get { return Inline.Write<float>(raw->W, Count); } }
        /// <summary>position, world space, for lighting and wo</summary>
        public Span<float> Px { get { return Inline.Write<float>(raw->Px, Count); } }
        /// <summary>position, world space, for lighting and wo</summary>
        public Span<float> Py { get { return Inline.Write<float>(raw->Py, Count); } }
        /// <summary>position, world space, for lighting and wo</summary>
        public Span<float> Pz { get { return Inline.Write<float>(raw->Pz, Count); } }
        /// <summary>normal, world space; changed normals are normalised afterwards</summary>
        public Span<float> Nx { get { return Inline.Write<float>(raw->Nx, Count); } }
        /// <summary>normal, world space; changed normals are normalised afterwards</summary>
        public Span<float> Ny { get { return Inline.Write<float>(raw->Ny, Count); } }
        /// <summary>normal, world space; changed normals are normalised afterwards</summary>
        public Span<float> Nz { get { return Inline.Write<float>(raw->Nz, Count); } }
        /// <summary>texture coordinates</summary>
        public Span<float> U { get { return Inline.Write<float>(raw->U, Count); } }
        /// <summary>texture coordinates</summary>
        public Span<float> V { get { return Inline.Write<float>(raw->V, Count); } }
        /// <summary>[varying_count] columns that start as 0</summary>
        public Span<float> Varying(int index) { return Inline.Write<float>(raw->Varying[Inline.Check(index, raw->VaryingCount)], Count); }
    }

    /// <summary>
    /// Rays as packed columns of `count` elements, borrowed for the call. They start a little above the surfaces.
    /// struct_size goes from the library to the tracer, as in shd/fragments.h.
    /// </summary>
    public readonly unsafe ref struct Rays
    {
        private readonly Native.Rays* raw;
        /// <summary>Rows.</summary>
        public readonly int Count;
        internal Rays(Native.Rays* from) { raw = from; Count = (int)from->Count; }
        /// <summary>origins, world space</summary>
        public ReadOnlySpan<float> Ox { get { return Inline.Read<float>(raw->Ox, Count); } }
        /// <summary>origins, world space</summary>
        public ReadOnlySpan<float> Oy { get { return Inline.Read<float>(raw->Oy, Count); } }
        /// <summary>origins, world space</summary>
        public ReadOnlySpan<float> Oz { get { return Inline.Read<float>(raw->Oz, Count); } }
        /// <summary>directions, world space, unit</summary>
        public ReadOnlySpan<float> Dx { get { return Inline.Read<float>(raw->Dx, Count); } }
        /// <summary>directions, world space, unit</summary>
        public ReadOnlySpan<float> Dy { get { return Inline.Read<float>(raw->Dy, Count); } }
        /// <summary>directions, world space, unit</summary>
        public ReadOnlySpan<float> Dz { get { return Inline.Read<float>(raw->Dz, Count); } }
        /// <summary>length of each ray, world length, &gt; 0; FLT_MAX or infinity = unlimited</summary>
        public ReadOnlySpan<float> Length { get { return Inline.Read<float>(raw->Length, Count); } }
    }
}
