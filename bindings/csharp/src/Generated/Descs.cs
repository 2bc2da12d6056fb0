// SPDX-License-Identifier: MIT
// Written by generate.py; do not edit.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>Options of a bake; nothing is required.</summary>
    public sealed unsafe partial class BakeDesc
    {
        internal Native.BakeDesc Fields = Native.BakeDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static BakeDesc Default { get { return new BakeDesc(); } }

        /// <summary>texture coordinates at which triangles lie: 0 = uv of the mesh, 1 = uv1; default 0</summary>
        public uint UvSet { get { return Fields.UvSet; } set { Fields.UvSet = value; } }
        /// <summary>
        /// Largest distance [texels], 0..1024, over which empty texels get a copy of the nearest shaded texel, in all planes
        /// except depth: seams then do not mix with the background when the texture is filtered. Distances are between
        /// centres; of equally near texels the one in the upper row is copied, then the left one. Default 0 = none.
        /// </summary>
        public uint Dilation { get { return Fields.Dilation; } set { Fields.Dilation = value; } }
        /// <summary>reserved; 0</summary>
        public uint Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>TexelState of width * height texels; default not wanted</summary>
        public Column<uint> States;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.BakeDesc Build(Call call, string name, long rows = -1)
        {
            Native.BakeDesc made = Fields;
            made.States = call.U32Out(States, name, "States", ref rows);
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.BakeDesc made);
        internal static Native.BakeDesc* BuildAll(Call call, string name, IList<BakeDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.BakeDesc* all = (Native.BakeDesc*)call.Memory((long)list.Count * sizeof(Native.BakeDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.BakeDesc made) { Fields.UvSet = made.UvSet; Fields.Dilation = made.Dilation; Fields.Flags = made.Flags; }
    }

    /// <summary>Source of the config. Zero is the default of each field. Strings are borrowed for the call.</summary>
    public sealed unsafe partial class ColorDesc
    {
        internal Native.ColorDesc Fields = Native.ColorDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static ColorDesc Default { get { return new ColorDesc(); } }

        /// <summary>precision of 8-bit images; default DisplayPrecision.Baked</summary>
        public DisplayPrecision DisplayPrecision { get { return Fields.DisplayPrecision; } set { Fields.DisplayPrecision = value; } }
        /// <summary>
        /// path of a config file, at most 64 MiB; NULL = the file named by the environment
        /// variable OCIO if it is set and not empty, else the built-in config. The config
        /// and the tables that it names must be regular files
        /// </summary>
        public string ConfigPath;
        /// <summary>a config in memory (YAML); then config_path must be NULL and OCIO is not read</summary>
        public string ConfigText;
        /// <summary>colour space or role of framebuffers; NULL = the role scene_linear</summary>
        public string WorkingSpace;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.ColorDesc Build(Call call, string name, long rows = -1)
        {
            Native.ColorDesc made = Fields;
            made.ConfigPath = call.Text(ConfigPath);
            made.ConfigText = call.Text(ConfigText);
            made.WorkingSpace = call.Text(WorkingSpace);
            return made;
        }
        internal static Native.ColorDesc* BuildAll(Call call, string name, IList<ColorDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.ColorDesc* all = (Native.ColorDesc*)call.Memory((long)list.Count * sizeof(Native.ColorDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Options of a context. Zero is the default of each.</summary>
    public sealed unsafe partial class ContextDesc
    {
        internal Native.ContextDesc Fields = Native.ContextDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static ContextDesc Default { get { return new ContextDesc(); } }

        /// <summary>default 0</summary>
        public ContextFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>
        /// threads of the built-in executor, 0..1024, at most one per core; 1 = calling thread;
        /// default 0 = one per core
        /// </summary>
        public uint WorkerCount { get { return Fields.WorkerCount; } set { Fields.WorkerCount = value; } }
        /// <summary>default Simd.Best; Result.ErrorUnsupported if it cannot run here</summary>
        public Simd Simd { get { return Fields.Simd; } set { Fields.Simd = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.ContextDesc Build(Call call, string name, long rows = -1)
        {
            Native.ContextDesc made = Fields;
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.ContextDesc made);
        internal static Native.ContextDesc* BuildAll(Call call, string name, IList<ContextDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.ContextDesc* all = (Native.ContextDesc*)call.Memory((long)list.Count * sizeof(Native.ContextDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Columns for edges; NULL = not wanted.</summary>
    public sealed unsafe partial class Edges
    {
        internal Native.Edges Fields = Native.Edges.Default;

        /// <summary>The defaults of the library.</summary>
        public static Edges Default { get { return new Edges(); } }

        /// <summary>the two ends, in the direction of the first triangle</summary>
        public readonly Column<uint>[] Vertex = new Column<uint>[2];
        /// <summary>the first triangle, and the other one; 0xffffffff for borders and non-manifold edges</summary>
        public readonly Column<uint>[] Triangle = new Column<uint>[2];
        /// <summary>EdgeFlags bits, among the requested ones</summary>
        public Column<uint> Kinds;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Edges Build(Call call, string name, long rows = -1)
        {
            Native.Edges made = Fields;
            for (int i = 0; i < 2; ++i) made.Vertex[i] = call.U32Out(Vertex[i], name, "Vertex", ref rows);
            for (int i = 0; i < 2; ++i) made.Triangle[i] = call.U32Out(Triangle[i], name, "Triangle", ref rows);
            made.Kinds = call.U32Out(Kinds, name, "Kinds", ref rows);
            return made;
        }
        internal static Native.Edges* BuildAll(Call call, string name, IList<Edges> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Edges* all = (Native.Edges*)call.Memory((long)list.Count * sizeof(Native.Edges));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.Edges made) {  }
    }

    /// <summary>Image and tables of an environment. Required: image.</summary>
    public sealed unsafe partial class EnvironmentDesc
    {
        internal Native.EnvironmentDesc Fields = Native.EnvironmentDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static EnvironmentDesc Default { get { return new EnvironmentDesc(); } }

        /// <summary>any but Projection.None; default Projection.LatLong</summary>
        public Projection Projection { get { return Fields.Projection; } set { Fields.Projection = value; } }
        /// <summary>
        /// Linear radiance, of any format and of 1 x 1 up to 2^26 pixels; borrowed for the call. One channel means grey; the
        /// fourth is ignored. CUBE takes the six faces on top of each other: height = 6 width. MIRROR_BALL, ANGULAR and
        /// OCTAHEDRAL are square. Channels that are negative or NaN count as 0, and those above 1e12 as 1e12;
        /// EnvironmentInfo counts them.
        /// </summary>
        public Image Image;
        /// <summary>default Irradiance.Harmonics</summary>
        public Irradiance Irradiance { get { return Fields.Irradiance; } set { Fields.Irradiance = value; } }
        /// <summary>default EnvironmentTables.All</summary>
        public EnvironmentTables Tables { get { return Fields.Tables; } set { Fields.Tables = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.EnvironmentDesc Build(Call call, string name, long rows = -1)
        {
            Native.EnvironmentDesc made = Fields;
            if (Image != null) made.Image = Image.BuildAll(call, Call.Join(name, "Image"), new Image[] { Image });
            return made;
        }
        internal static Native.EnvironmentDesc* BuildAll(Call call, string name, IList<EnvironmentDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.EnvironmentDesc* all = (Native.EnvironmentDesc*)call.Memory((long)list.Count * sizeof(Native.EnvironmentDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Lookups of an environment, as columns of `count` elements.</summary>
    public sealed unsafe partial class EnvironmentLookups
    {
        internal Native.EnvironmentLookups Fields = Native.EnvironmentLookups.Default;

        /// <summary>The defaults of the library.</summary>
        public static EnvironmentLookups Default { get { return new EnvironmentLookups(); } }

        /// <summary>x, y, z, any length; required. 0, NaN and infinity count as +Z</summary>
        public readonly Column<float>[] Direction = new Column<float>[3];
        /// <summary>
        /// Roughness of a GGX lobe around the direction, clamped to 0..1, NaN = 1: the mean of the radiance, weighted by
        /// D(h) n.l with n = v = direction (Karis, "Real Shading in Unreal Engine 4", 2013). Only for environments with
        /// EnvironmentTables.Ggx.
        /// </summary>
        public Column<float> Roughness;
        /// <summary>
        /// Exponent p of a Phong lobe around the direction r, clamped to 0..1e6, NaN = 0: the mean of the radiance, weighted
        /// by max(0, r.l)^p. Only for environments with EnvironmentTables.Phong. Without roughness and exponent, lookups
        /// give the radiance itself.
        /// </summary>
        public Column<float> Exponent;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.EnvironmentLookups Build(Call call, string name, long rows = -1)
        {
            Native.EnvironmentLookups made = Fields;
            for (int i = 0; i < 3; ++i) made.Direction[i] = call.F32In(Direction[i], name, "Direction", ref rows);
            made.Roughness = call.F32In(Roughness, name, "Roughness", ref rows);
            made.Exponent = call.F32In(Exponent, name, "Exponent", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.EnvironmentLookups* BuildAll(Call call, string name, IList<EnvironmentLookups> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.EnvironmentLookups* all = (Native.EnvironmentLookups*)call.Memory((long)list.Count * sizeof(Native.EnvironmentLookups));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Columns for irradiance or radiance; NULL = not wanted.</summary>
    public sealed unsafe partial class EnvironmentLight
    {
        internal Native.EnvironmentLight Fields = Native.EnvironmentLight.Default;

        /// <summary>The defaults of the library.</summary>
        public static EnvironmentLight Default { get { return new EnvironmentLight(); } }

        /// <summary>red, green, blue; irradiance, or radiance in the unit of the image</summary>
        public readonly Column<float>[] Rgb = new Column<float>[3];

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.EnvironmentLight Build(Call call, string name, long rows = -1)
        {
            Native.EnvironmentLight made = Fields;
            for (int i = 0; i < 3; ++i) made.Rgb[i] = call.F32Out(Rgb[i], name, "Rgb", ref rows);
            return made;
        }
        internal static Native.EnvironmentLight* BuildAll(Call call, string name, IList<EnvironmentLight> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.EnvironmentLight* all = (Native.EnvironmentLight*)call.Memory((long)list.Count * sizeof(Native.EnvironmentLight));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.EnvironmentLight made) {  }
    }

    /// <summary>Columns for derivatives per pixel step; NULL = not wanted.</summary>
    public sealed unsafe partial class Derivatives
    {
        internal Native.Derivatives Fields = Native.Derivatives.Default;

        /// <summary>The defaults of the library.</summary>
        public static Derivatives Default { get { return new Derivatives(); } }

        /// <summary>du/dx</summary>
        public Column<float> Dudx;
        /// <summary>dv/dx</summary>
        public Column<float> Dvdx;
        /// <summary>du/dy</summary>
        public Column<float> Dudy;
        /// <summary>dv/dy</summary>
        public Column<float> Dvdy;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Derivatives Build(Call call, string name, long rows = -1)
        {
            Native.Derivatives made = Fields;
            made.Dudx = call.F32Out(Dudx, name, "Dudx", ref rows);
            made.Dvdx = call.F32Out(Dvdx, name, "Dvdx", ref rows);
            made.Dudy = call.F32Out(Dudy, name, "Dudy", ref rows);
            made.Dvdy = call.F32Out(Dvdy, name, "Dvdy", ref rows);
            return made;
        }
        internal static Native.Derivatives* BuildAll(Call call, string name, IList<Derivatives> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Derivatives* all = (Native.Derivatives*)call.Memory((long)list.Count * sizeof(Native.Derivatives));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.Derivatives made) {  }
    }

    /// <summary>Hits of rays with their differentials, as columns of `count` elements; x, y, z in one space.</summary>
    public sealed unsafe partial class RayDifferentials
    {
        internal Native.RayDifferentials Fields = Native.RayDifferentials.Default;

        /// <summary>The defaults of the library.</summary>
        public static RayDifferentials Default { get { return new RayDifferentials(); } }

        /// <summary>change of the surface point with u; required</summary>
        public readonly Column<float>[] Dpdu = new Column<float>[3];
        /// <summary>change of the surface point with v; required</summary>
        public readonly Column<float>[] Dpdv = new Column<float>[3];
        /// <summary>direction of the ray, any length; required</summary>
        public readonly Column<float>[] Direction = new Column<float>[3];
        /// <summary>distance to the hit, in lengths of `direction`; absent = 0</summary>
        public Column<float> Distance;
        /// <summary>change of the ray's origin per pixel step in x; absent = 0</summary>
        public readonly Column<float>[] OriginDx = new Column<float>[3];
        /// <summary>change of the ray's origin per pixel step in y; absent = 0</summary>
        public readonly Column<float>[] OriginDy = new Column<float>[3];
        /// <summary>change of `direction` per pixel step in x; absent = 0</summary>
        public readonly Column<float>[] DirectionDx = new Column<float>[3];
        /// <summary>change of `direction` per pixel step in y; absent = 0</summary>
        public readonly Column<float>[] DirectionDy = new Column<float>[3];

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.RayDifferentials Build(Call call, string name, long rows = -1)
        {
            Native.RayDifferentials made = Fields;
            for (int i = 0; i < 3; ++i) made.Dpdu[i] = call.F32In(Dpdu[i], name, "Dpdu", ref rows);
            for (int i = 0; i < 3; ++i) made.Dpdv[i] = call.F32In(Dpdv[i], name, "Dpdv", ref rows);
            for (int i = 0; i < 3; ++i) made.Direction[i] = call.F32In(Direction[i], name, "Direction", ref rows);
            made.Distance = call.F32In(Distance, name, "Distance", ref rows);
            for (int i = 0; i < 3; ++i) made.OriginDx[i] = call.F32In(OriginDx[i], name, "OriginDx", ref rows);
            for (int i = 0; i < 3; ++i) made.OriginDy[i] = call.F32In(OriginDy[i], name, "OriginDy", ref rows);
            for (int i = 0; i < 3; ++i) made.DirectionDx[i] = call.F32In(DirectionDx[i], name, "DirectionDx", ref rows);
            for (int i = 0; i < 3; ++i) made.DirectionDy[i] = call.F32In(DirectionDy[i], name, "DirectionDy", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.RayDifferentials* BuildAll(Call call, string name, IList<RayDifferentials> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.RayDifferentials* all = (Native.RayDifferentials*)call.Memory((long)list.Count * sizeof(Native.RayDifferentials));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Hits of rays with their cones, as columns of `count` elements; x, y, z in one space.</summary>
    public sealed unsafe partial class RayCones
    {
        internal Native.RayCones Fields = Native.RayCones.Default;

        /// <summary>The defaults of the library.</summary>
        public static RayCones Default { get { return new RayCones(); } }

        /// <summary>change of the surface point with u; required</summary>
        public readonly Column<float>[] Dpdu = new Column<float>[3];
        /// <summary>change of the surface point with v; required</summary>
        public readonly Column<float>[] Dpdv = new Column<float>[3];
        /// <summary>direction of the ray, any length; required</summary>
        public readonly Column<float>[] Direction = new Column<float>[3];
        /// <summary>diameter of the cone at the hit, in the units of the points; required</summary>
        public Column<float> Width;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.RayCones Build(Call call, string name, long rows = -1)
        {
            Native.RayCones made = Fields;
            for (int i = 0; i < 3; ++i) made.Dpdu[i] = call.F32In(Dpdu[i], name, "Dpdu", ref rows);
            for (int i = 0; i < 3; ++i) made.Dpdv[i] = call.F32In(Dpdv[i], name, "Dpdv", ref rows);
            for (int i = 0; i < 3; ++i) made.Direction[i] = call.F32In(Direction[i], name, "Direction", ref rows);
            made.Width = call.F32In(Width, name, "Width", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.RayCones* BuildAll(Call call, string name, IList<RayCones> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.RayCones* all = (Native.RayCones*)call.Memory((long)list.Count * sizeof(Native.RayCones));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>An image in the caller's memory. Required: format, width, height, pixels.</summary>
    public sealed unsafe partial class Image
    {
        internal Native.Image Fields = Native.Image.Default;

        /// <summary>The defaults of the library.</summary>
        public static Image Default { get { return new Image(); } }

        /// <summary>storage of `pixels`</summary>
        public Format Format { get { return Fields.Format; } set { Fields.Format = value; } }
        /// <summary>pixels, 1..65536</summary>
        public uint Width { get { return Fields.Width; } set { Fields.Width = value; } }
        /// <summary>pixels, 1..65536</summary>
        public uint Height { get { return Fields.Height; } set { Fields.Height = value; } }
        /// <summary>bytes between rows of pixels or blocks, at least the bytes of a row; 0 = packed</summary>
        public long RowStride { get { return Fields.RowStride; } set { Fields.RowStride = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Image Build(Call call, string name, long rows = -1)
        {
            Native.Image made = Fields;
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.Image made);
        internal static Native.Image* BuildAll(Call call, string name, IList<Image> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Image* all = (Native.Image*)call.Memory((long)list.Count * sizeof(Native.Image));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Options and budgets of a load. A budget that would be exceeded is Result.ErrorLimit.</summary>
    public sealed unsafe partial class LoadDesc
    {
        internal Native.LoadDesc Fields = Native.LoadDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static LoadDesc Default { get { return new LoadDesc(); } }

        /// <summary>formats to accept; default 0 = FileFormatFlags.Default</summary>
        public FileFormatFlags Formats { get { return Fields.Formats; } set { Fields.Formats = value; } }
        /// <summary>default none</summary>
        public LoadFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>default AUTO; other values override the file's declaration</summary>
        public ColorEncoding ColorSpace { get { return Fields.ColorSpace; } set { Fields.ColorSpace = value; } }
        /// <summary>tables of textures; default TableFlags.Mipmap</summary>
        public TableFlags Tables { get { return Fields.Tables; } set { Fields.Tables = value; } }
        /// <summary>part of a multi-part EXR, page of a TIFF, frame of a GIF; default 0</summary>
        public uint Subimage { get { return Fields.Subimage; } set { Fields.Subimage = value; } }
        /// <summary>size of the file; 0 = 2^30</summary>
        public ulong MaxFileBytes { get { return Fields.MaxFileBytes; } set { Fields.MaxFileBytes = value; } }
        /// <summary>
        /// width * height, of the data and of the display window, and the pixels of all
        /// levels with LoadFlags.FileLevels; 0 = 2^28
        /// </summary>
        public ulong MaxPixels { get { return Fields.MaxPixels; } set { Fields.MaxPixels = value; } }
        /// <summary>decoded, as RGBA, all levels; 0 = 2^32</summary>
        public ulong MaxBytes { get { return Fields.MaxBytes; } set { Fields.MaxBytes = value; } }
        /// <summary>decoded bytes per file byte, for more than 2^24 decoded; 0 = 4000</summary>
        public double MaxRatio { get { return Fields.MaxRatio; } set { Fields.MaxRatio = value; } }
        /// <summary>
        /// [s], 0 = 60; kills the child that decodes. With LoadFlags.InProcess it is
        /// checked between bands of rows. A worker that is stopped (SIGSTOP, a debugger)
        /// costs a load all of its time; when it has been silent for two seconds, the
        /// next load starts another one
        /// </summary>
        public double TimeLimit { get { return Fields.TimeLimit; } set { Fields.TimeLimit = value; } }
        /// <summary>
        /// program that decodes, relative to the working directory at the call; NULL =
        /// shd-io-worker beside libshd_io or in its installed place; borrowed for the
        /// call
        /// </summary>
        public string WorkerPath;
        /// <summary>
        /// textures: the file is voxels of this layout; borrowed for the call; default
        /// NULL
        /// </summary>
        public RawDesc? Raw;
        /// <summary>
        /// textures: slices of a 3D texture from the files of the desc, without a path;
        /// borrowed for the call; default NULL
        /// </summary>
        public StackDesc Stack;
        /// <summary>
        /// textures: grid and box of an OpenVDB file; borrowed for the call; default NULL
        /// = the first grid of float or double, if the content is OpenVDB
        /// </summary>
        public VdbDesc Vdb;
        /// <summary>
        /// textures: gets the contents of a KTX2 or DDS file; all zero on failure and for
        /// other files, and its struct_size is read; default NULL
        /// </summary>
        public TextureFileInfo? Info;
        /// <summary>
        /// textures: gets the properties of an OpenVDB grid; all zero on failure and for
        /// other files, and its struct_size is read; default NULL
        /// </summary>
        public VdbInfo? VdbInfo;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.LoadDesc Build(Call call, string name, long rows = -1)
        {
            Native.LoadDesc made = Fields;
            made.WorkerPath = call.Text(WorkerPath);
            if (Raw.HasValue) { made.Raw = (global::Shd.RawDesc*)call.Memory(sizeof(global::Shd.RawDesc)); *made.Raw = Raw.Value; }
            if (Stack != null) made.Stack = StackDesc.BuildAll(call, Call.Join(name, "Stack"), new StackDesc[] { Stack });
            if (Vdb != null) made.Vdb = VdbDesc.BuildAll(call, Call.Join(name, "Vdb"), new VdbDesc[] { Vdb });
            if (Info.HasValue) { made.Info = (global::Shd.TextureFileInfo*)call.Memory(sizeof(global::Shd.TextureFileInfo)); *made.Info = Info.Value; }
            if (VdbInfo.HasValue) { made.VdbInfo = (global::Shd.VdbInfo*)call.Memory(sizeof(global::Shd.VdbInfo)); *made.VdbInfo = VdbInfo.Value; }
            return made;
        }
        internal static Native.LoadDesc* BuildAll(Call call, string name, IList<LoadDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.LoadDesc* all = (Native.LoadDesc*)call.Memory((long)list.Count * sizeof(Native.LoadDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Options of a save.</summary>
    public sealed unsafe partial class SaveDesc
    {
        internal Native.SaveDesc Fields = Native.SaveDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static SaveDesc Default { get { return new SaveDesc(); } }

        /// <summary>
        /// a framebuffer's colour: PNG 8 or 16, EXR 16 or 32, TIFF 8, 16 or 32;
        /// default 0 = 8 for PNG, 16 for EXR, 32 for TIFF. For images always 0
        /// </summary>
        public uint BitDepth { get { return Fields.BitDepth; } set { Fields.BitDepth = value; } }
        /// <summary>
        /// framebuffers in 8 and 16 bits: AUTO and SRGB apply the sRGB curve, LINEAR and
        /// DATA do not. Images: the tag of PNG and EXR; AUTO = by pixel format
        /// </summary>
        public ColorEncoding ColorSpace { get { return Fields.ColorSpace; } set { Fields.ColorSpace = value; } }
        /// <summary>a framebuffer's colour in 8 and 16 bits; default none</summary>
        public Dither Dither { get { return Fields.Dither; } set { Fields.Dither = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.SaveDesc Build(Call call, string name, long rows = -1)
        {
            Native.SaveDesc made = Fields;
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.SaveDesc made);
        internal static Native.SaveDesc* BuildAll(Call call, string name, IList<SaveDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.SaveDesc* all = (Native.SaveDesc*)call.Memory((long)list.Count * sizeof(Native.SaveDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Kind, intensity and placement of a light.</summary>
    public sealed unsafe partial class LightDesc
    {
        internal Native.LightDesc Fields = Native.LightDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static LightDesc Default { get { return new LightDesc(); } }

        /// <summary>default LightKind.Point</summary>
        public LightKind Kind { get { return Fields.Kind; } set { Fields.Kind = value; } }
        /// <summary>
        /// I, scene-linear RGB, 0..1e12; default 1. Points and spots: E = 1 at distance r takes
        /// I = r^2
        /// </summary>
        public Float3 Intensity { get { return Fields.Intensity; } set { Fields.Intensity = value; } }
        /// <summary>
        /// position of points, spots and the cookie of directional lights; world space, finite;
        /// default 0
        /// </summary>
        public Float3 Position { get { return Fields.Position; } set { Fields.Position = value; } }
        /// <summary>
        /// directional lights and spots: direction of the light rays, world space, any length
        /// except 0; default (0, -1, 0)
        /// </summary>
        public Float3 Direction { get { return Fields.Direction; } set { Fields.Direction = value; } }
        /// <summary>
        /// points and spots: distance from which E is 0 [world units]; default 0 = no limit. Lights
        /// with a finite range are culled beyond it
        /// </summary>
        public float Range { get { return Fields.Range; } set { Fields.Range = value; } }
        /// <summary>spots: half angle of the full cone [rad], 0..outer_angle; default 0</summary>
        public float InnerAngle { get { return Fields.InnerAngle; } set { Fields.InnerAngle = value; } }
        /// <summary>
        /// spots: half angle of the cone [rad], 0.001..pi/2, with a cookie up to 1.55; default
        /// pi/4
        /// </summary>
        public float OuterAngle { get { return Fields.OuterAngle; } set { Fields.OuterAngle = value; } }
        /// <summary>
        /// up direction of the cookie and of shadow maps, world space. Orthogonalised against
        /// `direction`; replaced by another direction if parallel to it. Default (0, 1, 0)
        /// </summary>
        public Float3 Up { get { return Fields.Up; } set { Fields.Up = value; } }
        /// <summary>
        /// directional lights: width and height of the cookie [world units], above 0; default 1.
        /// The centre of the cookie lies on the ray from `position`; with wraps that repeat, the
        /// cookie tiles the plane
        /// </summary>
        public Float2 Extent { get { return Fields.Extent; } set { Fields.Extent = value; } }
        /// <summary>
        /// Light cookie: a texture of colours that multiply E, as seen from the light. It covers the square around the outer
        /// cone of a spot, or a rectangle of size `extent` for a directional light. The fourth channel is ignored. Points
        /// and ambient lights have no cookie. NULL = none; retained.
        /// </summary>
        public Texture Texture;
        /// <summary>sampler of `texture`; NULL = bilinear, black outside; retained</summary>
        public Sampler Sampler;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.LightDesc Build(Call call, string name, long rows = -1)
        {
            Native.LightDesc made = Fields;
            made.Texture = call.UseOrNull(Texture, name, "Texture");
            made.Sampler = call.UseOrNull(Sampler, name, "Sampler");
            return made;
        }
        internal static Native.LightDesc* BuildAll(Call call, string name, IList<LightDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.LightDesc* all = (Native.LightDesc*)call.Memory((long)list.Count * sizeof(Native.LightDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Points to look up, as columns of `count` elements. Required: u, v. Absent columns are NULL.</summary>
    public sealed unsafe partial class Lookups
    {
        internal Native.Lookups Fields = Native.Lookups.Default;

        /// <summary>The defaults of the library.</summary>
        public static Lookups Default { get { return new Lookups(); } }

        /// <summary>normalised coordinate across; required</summary>
        public Column<float> U;
        /// <summary>normalised coordinate down; required</summary>
        public Column<float> V;
        /// <summary>du/dx per pixel step; absent = 0</summary>
        public Column<float> Dudx;
        /// <summary>dv/dx; absent = 0</summary>
        public Column<float> Dvdx;
        /// <summary>du/dy; absent = 0</summary>
        public Column<float> Dudy;
        /// <summary>dv/dy; absent = 0</summary>
        public Column<float> Dvdy;
        /// <summary>log2 of the footprint in base texels; replaces the derivatives, width and blur</summary>
        public Column<float> Lod;
        /// <summary>layer of the array; absent = 0; numbers beyond the last layer mean the last layer</summary>
        public Column<uint> Layer;
        /// <summary>random bits of Filter.Stochastic; absent = hashed from u, v and, if read, w</summary>
        public Column<uint> Random;
        /// <summary>
        /// third coordinate: across the slices of a 3D texture, or of a direction; required by these
        /// textures, without effect for others
        /// </summary>
        public Column<float> W;
        /// <summary>dw/dx per pixel step, where w has effect; absent = 0</summary>
        public Column<float> Dwdx;
        /// <summary>dw/dy; absent = 0</summary>
        public Column<float> Dwdy;
        /// <summary>compared with texels by samplers with `compares`; absent = 0</summary>
        public Column<float> Reference;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Lookups Build(Call call, string name, long rows = -1)
        {
            Native.Lookups made = Fields;
            made.U = call.F32In(U, name, "U", ref rows);
            made.V = call.F32In(V, name, "V", ref rows);
            made.Dudx = call.F32In(Dudx, name, "Dudx", ref rows);
            made.Dvdx = call.F32In(Dvdx, name, "Dvdx", ref rows);
            made.Dudy = call.F32In(Dudy, name, "Dudy", ref rows);
            made.Dvdy = call.F32In(Dvdy, name, "Dvdy", ref rows);
            made.Lod = call.F32In(Lod, name, "Lod", ref rows);
            made.Layer = call.U32In(Layer, name, "Layer", ref rows);
            made.Random = call.U32In(Random, name, "Random", ref rows);
            made.W = call.F32In(W, name, "W", ref rows);
            made.Dwdx = call.F32In(Dwdx, name, "Dwdx", ref rows);
            made.Dwdy = call.F32In(Dwdy, name, "Dwdy", ref rows);
            made.Reference = call.F32In(Reference, name, "Reference", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.Lookups* BuildAll(Call call, string name, IList<Lookups> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Lookups* all = (Native.Lookups*)call.Memory((long)list.Count * sizeof(Native.Lookups));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Columns for the filtered values: linear, and premultiplied only if the texels are.</summary>
    public sealed unsafe partial class Texels
    {
        internal Native.Texels Fields = Native.Texels.Default;

        /// <summary>The defaults of the library.</summary>
        public static Texels Default { get { return new Texels(); } }

        /// <summary>r, g, b, a after the texture's swizzle; NULL = not wanted</summary>
        public readonly Column<float>[] Channel = new Column<float>[4];
        /// <summary>
        /// d/du and d/dv of the channels, with u and v normalised and the footprint held constant; NULL = not wanted.
        /// Available for BILINEAR, BICUBIC, BILINEAR_MIP, TRILINEAR, RIPMAP, ANISOTROPIC and EWA, and for a magnification
        /// filter in this list; other filters return Result.ErrorUnsupported. BILINEAR has kinks at texel centres; the result
        /// there is the derivative to the right. EWA has kinks where a texel enters the ellipse; the result there is the
        /// derivative of the weights. du, dv and dw of a texture of directions are the derivatives in the three components
        /// of the direction, not normalised, with the footprint held constant in the image.
        /// </summary>
        public readonly Column<float>[] Du = new Column<float>[4];
        public readonly Column<float>[] Dv = new Column<float>[4];
        /// <summary>written: lookups whose coordinates, derivatives or lod were not finite</summary>
        public long NonfiniteCount { get { return Fields.NonfiniteCount; } set { Fields.NonfiniteCount = value; } }
        /// <summary>
        /// d/dw of the channels of a 3D texture or of one of directions, as du; NULL = not wanted.
        /// 2D textures return Result.ErrorUnsupported
        /// </summary>
        public readonly Column<float>[] Dw = new Column<float>[4];
        /// <summary>
        /// 0 for lookups that found all their tiles. With MissingTiles.Coarser, l + 1 if a tile of level l is missing
        /// and coarser levels were filtered instead. NULL = not wanted.
        /// </summary>
        public Column<uint> Coarser;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Texels Build(Call call, string name, long rows = -1)
        {
            Native.Texels made = Fields;
            for (int i = 0; i < 4; ++i) made.Channel[i] = call.F32Out(Channel[i], name, "Channel", ref rows);
            for (int i = 0; i < 4; ++i) made.Du[i] = call.F32Out(Du[i], name, "Du", ref rows);
            for (int i = 0; i < 4; ++i) made.Dv[i] = call.F32Out(Dv[i], name, "Dv", ref rows);
            for (int i = 0; i < 4; ++i) made.Dw[i] = call.F32Out(Dw[i], name, "Dw", ref rows);
            made.Coarser = call.U32Out(Coarser, name, "Coarser", ref rows);
            return made;
        }
        internal static Native.Texels* BuildAll(Call call, string name, IList<Texels> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Texels* all = (Native.Texels*)call.Memory((long)list.Count * sizeof(Native.Texels));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.Texels made) { Fields.NonfiniteCount = made.NonfiniteCount; }
    }

    /// <summary>Columns for levels of detail; NULL = not wanted.</summary>
    public sealed unsafe partial class Levels
    {
        internal Native.Levels Fields = Native.Levels.Default;

        /// <summary>The defaults of the library.</summary>
        public static Levels Default { get { return new Levels(); } }

        /// <summary>continuous level of trilinear in the sampler's profile, after bias and clamps</summary>
        public Column<float> Lod;
        /// <summary>nearest mip level: ceil(lod + 1/2) - 1, or the profile's</summary>
        public Column<uint> Level;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Levels Build(Call call, string name, long rows = -1)
        {
            Native.Levels made = Fields;
            made.Lod = call.F32Out(Lod, name, "Lod", ref rows);
            made.Level = call.U32Out(Level, name, "Level", ref rows);
            return made;
        }
        internal static Native.Levels* BuildAll(Call call, string name, IList<Levels> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Levels* all = (Native.Levels*)call.Memory((long)list.Count * sizeof(Native.Levels));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.Levels made) {  }
    }

    /// <summary>Model and coefficients, scene-linear RGB.</summary>
    public sealed unsafe partial class MaterialDesc
    {
        internal Native.MaterialDesc Fields = Native.MaterialDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static MaterialDesc Default { get { return new MaterialDesc(); } }

        /// <summary>default Model.Lambert</summary>
        public Model Model { get { return Fields.Model; } set { Fields.Model = value; } }
        /// <summary>shown instead of the model; default DebugView.None</summary>
        public DebugView DebugView { get { return Fields.DebugView; } set { Fields.DebugView = value; } }
        /// <summary>default none</summary>
        public MaterialFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>
        /// k_a, 0..1e6. Default -1 in all channels: k_a is ambient_share times the diffuse
        /// colour, k_d times its slot. SlotTarget.Ambient replaces the slot of the diffuse
        /// colour in this product
        /// </summary>
        public Float3 Ambient { get { return Fields.Ambient; } set { Fields.Ambient = value; } }
        /// <summary>
        /// 0..1; default 1/16; used if ambient is -1. METALLIC_ROUGHNESS multiplies k_a by its
        /// base colour in any case, so k_a is ambient_share there
        /// </summary>
        public float AmbientShare { get { return Fields.AmbientShare; } set { Fields.AmbientShare = value; } }
        /// <summary>k_d or base colour, 0..1e6; default 0.8</summary>
        public Float3 Diffuse { get { return Fields.Diffuse; } set { Fields.Diffuse = value; } }
        /// <summary>k_s, 0..1e6; default 0.5</summary>
        public Float3 Specular { get { return Fields.Specular; } set { Fields.Specular = value; } }
        /// <summary>p, 0..1e6; default 64</summary>
        public float Exponent { get { return Fields.Exponent; } set { Fields.Exponent = value; } }
        /// <summary>0..1; default 0</summary>
        public float Metallic { get { return Fields.Metallic; } set { Fields.Metallic = value; } }
        /// <summary>0..1; default 0.5</summary>
        public float Roughness { get { return Fields.Roughness; } set { Fields.Roughness = value; } }
        /// <summary>
        /// index of refraction of GLASS, and of METALLIC_ROUGHNESS for the part that is not
        /// metal, 1..10;
        /// default 1.5
        /// </summary>
        public float Ior { get { return Fields.Ior; } set { Fields.Ior = value; } }
        /// <summary>0..1e12; default 0, so a slot needs a larger value here</summary>
        public Float3 Emission { get { return Fields.Emission; } set { Fields.Emission = value; } }
        /// <summary>opacity of models, 0..1; default 1</summary>
        public float Opacity { get { return Fields.Opacity; } set { Fields.Opacity = value; } }
        /// <summary>effect of SlotTarget.Occlusion, 0..1; default 1</summary>
        public float OcclusionStrength { get { return Fields.OcclusionStrength; } set { Fields.OcclusionStrength = value; } }
        /// <summary>
        /// [slot_count], all with the same struct_size, at most one for each target;
        /// borrowed for the call; coefficients without a slot are constant
        /// </summary>
        public IList<Slot> Slots;
        /// <summary>default NormalEncoding.Xyz</summary>
        public NormalEncoding NormalEncoding { get { return Fields.NormalEncoding; } set { Fields.NormalEncoding = value; } }
        /// <summary>factor of x and y of mapped normals, -1e3..1e3; default 1</summary>
        public float NormalScale { get { return Fields.NormalScale; } set { Fields.NormalScale = value; } }
        /// <summary>default Bump.None</summary>
        public Bump Bump { get { return Fields.Bump; } set { Fields.Bump = value; } }
        /// <summary>factor of heights, -1e6..1e6; default 1</summary>
        public float BumpScale { get { return Fields.BumpScale; } set { Fields.BumpScale = value; } }
        /// <summary>
        /// Depth of height 0 below the surface [world units], 0..1e6; height 1 lies on the surface. At Phong frequency, all
        /// textures with the uv set of the height are looked up at the point where the line of sight meets the height field
        /// (parallax occlusion mapping, Tatarchuk 2006). The triangles do not move. Default 0 = off.
        /// </summary>
        public float ParallaxDepth { get { return Fields.ParallaxDepth; } set { Fields.ParallaxDepth = value; } }
        /// <summary>maximum number of lookups of the height per fragment, 2..256; default 24</summary>
        public uint ParallaxSteps { get { return Fields.ParallaxSteps; } set { Fields.ParallaxSteps = value; } }
        /// <summary>warm colour of GOOCH, 0..1e6; default (0.4, 0.4, 0)</summary>
        public Float3 Warm { get { return Fields.Warm; } set { Fields.Warm = value; } }
        /// <summary>cool colour of GOOCH, 0..1e6; default (0, 0, 0.4)</summary>
        public Float3 Cool { get { return Fields.Cool; } set { Fields.Cool = value; } }
        /// <summary>share of k_d added to `warm`, 0..1; default 0.6</summary>
        public float WarmMix { get { return Fields.WarmMix; } set { Fields.WarmMix = value; } }
        /// <summary>share of k_d added to `cool`, 0..1; default 0.2</summary>
        public float CoolMix { get { return Fields.CoolMix; } set { Fields.CoolMix = value; } }
        /// <summary>steps of TOON, 1..256; default 3</summary>
        public uint ToonSteps { get { return Fields.ToonSteps; } set { Fields.ToonSteps = value; } }
        /// <summary>default Blend.Opaque</summary>
        public Blend Blend { get { return Fields.Blend; } set { Fields.Blend = value; } }
        /// <summary>fragments with a smaller alpha are dropped, 0..1; default 0 = none</summary>
        public float AlphaCutoff { get { return Fields.AlphaCutoff; } set { Fields.AlphaCutoff = value; } }
        /// <summary>
        /// [varying_count]; borrowed for the call; NULL = all
        /// Interpolation.Perspective
        /// </summary>
        public Interpolation[] Interpolation;
        /// <summary>
        /// varyings that program.vertex writes, 0..Constants.MaxVaryings; 0 without
        /// program.vertex
        /// </summary>
        public long VaryingCount { get { return Fields.VaryingCount; } set { Fields.VaryingCount = value; } }
        /// <summary>
        /// Strength c of a clear coat over METALLIC_ROUGHNESS, 0..1; default 0 = none. As KHR_materials_clearcoat of glTF,
        /// with its own roughness and normal n_c and F = 0.04 + 0.96 (1 - |n_c.v|)^5: the model times 1 - c F, plus the sum
        /// of E max(0, n_c.l) c F D V. Without SlotTarget.ClearcoatNormal, n_c is the normal without normal maps and bumps.
        /// Ambient light and emission are not darkened. No effect on other models.
        /// </summary>
        public float Clearcoat { get { return Fields.Clearcoat; } set { Fields.Clearcoat = value; } }
        /// <summary>0..1; default 0</summary>
        public float ClearcoatRoughness { get { return Fields.ClearcoatRoughness; } set { Fields.ClearcoatRoughness = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.MaterialDesc Build(Call call, string name, long rows = -1)
        {
            Native.MaterialDesc made = Fields;
            made.Slots = Slot.BuildAll(call, Call.Join(name, "Slots"), Slots);
            made.SlotCount = checked((uint)(Slots == null ? 0 : Slots.Count));
            if (Interpolation != null) made.Interpolation = (Interpolation*)call.Pin(Interpolation);
            if (Interpolation != null) made.VaryingCount = Interpolation.Length;
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.MaterialDesc made);
        internal static Native.MaterialDesc* BuildAll(Call call, string name, IList<MaterialDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.MaterialDesc* all = (Native.MaterialDesc*)call.Memory((long)list.Count * sizeof(Native.MaterialDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Vertices and triangles of a mesh; copied. Required: vertex_count, position.</summary>
    public sealed unsafe partial class MeshDesc
    {
        internal Native.MeshDesc Fields = Native.MeshDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static MeshDesc Default { get { return new MeshDesc(); } }

        /// <summary>x, y, z, object space; required unless vertex_count is 0</summary>
        public readonly Column<float>[] Position = new Column<float>[3];
        /// <summary>x, y, z, object space, any length; all three or none; computed if absent</summary>
        public readonly Column<float>[] Normal = new Column<float>[3];
        /// <summary>used when `normal` is absent; default NormalWeight.Area</summary>
        public NormalWeight NormalWeight { get { return Fields.NormalWeight; } set { Fields.NormalWeight = value; } }
        /// <summary>default none</summary>
        public MeshFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>x, y, z, object space, and handedness, +1 or -1; see @ref tangents. All four or none; stored unchanged.</summary>
        public readonly Column<float>[] Tangent = new Column<float>[4];
        /// <summary>u, v; both or none; 0 if absent</summary>
        public readonly Column<float>[] Uv = new Column<float>[2];
        /// <summary>u, v of a second set; both or none; 0 if absent</summary>
        public readonly Column<float>[] Uv1 = new Column<float>[2];
        /// <summary>
        /// [attribute_count] columns for materials and programs, such as colours; any may be
        /// absent
        /// </summary>
        public Column<float>[] Attributes;
        /// <summary>default Topology.Triangles</summary>
        public Topology Topology { get { return Fields.Topology; } set { Fields.Topology = value; } }
        /// <summary>
        /// Vertex numbers of the triangles in the order of `topology`; counter-clockwise = front. NULL = indices16; if that
        /// is NULL too, 0, 1, 2, ... In strips and fans the largest number (0xffffffff, or 0xffff in indices16) starts a new
        /// strip or fan.
        /// </summary>
        public Column<uint> Indices;
        /// <summary>16-bit vertex numbers; at most one of indices and indices16 is set</summary>
        public Column<ushort> Indices16;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.MeshDesc Build(Call call, string name, long rows = -1)
        {
            Native.MeshDesc made = Fields;
            for (int i = 0; i < 3; ++i) made.Position[i] = call.F32In(Position[i], name, "Position", ref rows);
            for (int i = 0; i < 3; ++i) made.Normal[i] = call.F32In(Normal[i], name, "Normal", ref rows);
            for (int i = 0; i < 4; ++i) made.Tangent[i] = call.F32In(Tangent[i], name, "Tangent", ref rows);
            for (int i = 0; i < 2; ++i) made.Uv[i] = call.F32In(Uv[i], name, "Uv", ref rows);
            for (int i = 0; i < 2; ++i) made.Uv1[i] = call.F32In(Uv1[i], name, "Uv1", ref rows);
            made.Attributes = call.F32Ins(Attributes, name, "Attributes", ref rows);
            made.AttributeCount = checked((uint)(Attributes == null ? 0 : Attributes.Length));
            long indexCount = -1;
            made.Indices = call.U32In(Indices, name, "Indices", ref indexCount);
            made.IndexCount = Math.Max(indexCount, 0);
            made.Indices16 = call.U16In(Indices16, name, "Indices16", ref indexCount);
            made.IndexCount = Math.Max(indexCount, 0);
            made.VertexCount = checked((uint)(Math.Max(rows, 0)));
            return made;
        }
        internal static Native.MeshDesc* BuildAll(Call call, string name, IList<MeshDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.MeshDesc* all = (Native.MeshDesc*)call.Memory((long)list.Count * sizeof(Native.MeshDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Occluders and rays; borrowed for the call. Required: nothing.</summary>
    public sealed unsafe partial class OcclusionDesc
    {
        internal Native.OcclusionDesc Fields = Native.OcclusionDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static OcclusionDesc Default { get { return new OcclusionDesc(); } }

        /// <summary>per point, 1..65536; default 64</summary>
        public uint Rays { get { return Fields.Rays; } set { Fields.Rays = value; } }
        /// <summary>any value; default 0</summary>
        public uint Seed { get { return Fields.Seed; } set { Fields.Seed = value; } }
        /// <summary>world length over which occluders count, &gt; 0; default FLT_MAX = unlimited</summary>
        public float Radius { get { return Fields.Radius; } set { Fields.Radius = value; } }
        /// <summary>
        /// World length by which rays start above the surface, 0..1e9, besides 2^-18 of the largest coordinate of the point.
        /// Depth maps: ShadowDesc.bias. Default 0.
        /// </summary>
        public float Bias { get { return Fields.Bias; } set { Fields.Bias = value; } }
        /// <summary>depth maps: edge length [texels], 16..8192; default 1024</summary>
        public uint MapSize { get { return Fields.MapSize; } set { Fields.MapSize = value; } }
        /// <summary>
        /// Occluders of the depth maps, as in ShadowRenderDesc; NULL if draw_count is 0. Not read if there is a
        /// tracer, which has occluders of its own.
        /// </summary>
        public IList<Draw> Draws;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.OcclusionDesc Build(Call call, string name, long rows = -1)
        {
            Native.OcclusionDesc made = Fields;
            made.Draws = Draw.BuildAll(call, Call.Join(name, "Draws"), Draws);
            made.DrawCount = Draws == null ? 0 : Draws.Count;
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.OcclusionDesc made);
        internal static Native.OcclusionDesc* BuildAll(Call call, string name, IList<OcclusionDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.OcclusionDesc* all = (Native.OcclusionDesc*)call.Memory((long)list.Count * sizeof(Native.OcclusionDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Points on surfaces; borrowed for the call.</summary>
    public sealed unsafe partial class OcclusionPoints
    {
        internal Native.OcclusionPoints Fields = Native.OcclusionPoints.Default;

        /// <summary>The defaults of the library.</summary>
        public static OcclusionPoints Default { get { return new OcclusionPoints(); } }

        /// <summary>x, y, z, world space; required unless count is 0</summary>
        public readonly Column<float>[] Position = new Column<float>[3];
        /// <summary>x, y, z, world space, any length; required unless count is 0</summary>
        public readonly Column<float>[] Normal = new Column<float>[3];

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.OcclusionPoints Build(Call call, string name, long rows = -1)
        {
            Native.OcclusionPoints made = Fields;
            for (int i = 0; i < 3; ++i) made.Position[i] = call.F32In(Position[i], name, "Position", ref rows);
            for (int i = 0; i < 3; ++i) made.Normal[i] = call.F32In(Normal[i], name, "Normal", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.OcclusionPoints* BuildAll(Call call, string name, IList<OcclusionPoints> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.OcclusionPoints* all = (Native.OcclusionPoints*)call.Memory((long)list.Count * sizeof(Native.OcclusionPoints));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>A texture of occlusion, with the coverage of shd/bake.h. Required: width, height.</summary>
    public sealed unsafe partial class OcclusionAtlas
    {
        internal Native.OcclusionAtlas Fields = Native.OcclusionAtlas.Default;

        /// <summary>The defaults of the library.</summary>
        public static OcclusionAtlas Default { get { return new OcclusionAtlas(); } }

        /// <summary>texels, 1..16384</summary>
        public uint Width { get { return Fields.Width; } set { Fields.Width = value; } }
        /// <summary>texels, 1..16384</summary>
        public uint Height { get { return Fields.Height; } set { Fields.Height = value; } }
        /// <summary>as BakeDesc.uv_set: 0 or 1; default 0</summary>
        public uint UvSet { get { return Fields.UvSet; } set { Fields.UvSet = value; } }
        /// <summary>as BakeDesc.dilation, 0..1024 texels; default 0</summary>
        public uint Dilation { get { return Fields.Dilation; } set { Fields.Dilation = value; } }
        /// <summary>value of texels that stay empty, finite; default 1</summary>
        public float Empty { get { return Fields.Empty; } set { Fields.Empty = value; } }
        /// <summary>
        /// [draw_count] surfaces; mesh, object_to_world and instances are read; NULL if draw_count
        /// is 0
        /// </summary>
        public IList<Draw> Draws;
        /// <summary>TexelState of width * height texels; default not wanted</summary>
        public Column<uint> States;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.OcclusionAtlas Build(Call call, string name, long rows = -1)
        {
            Native.OcclusionAtlas made = Fields;
            made.Draws = Draw.BuildAll(call, Call.Join(name, "Draws"), Draws);
            made.DrawCount = Draws == null ? 0 : Draws.Count;
            made.States = call.U32Out(States, name, "States", ref rows);
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.OcclusionAtlas made);
        internal static Native.OcclusionAtlas* BuildAll(Call call, string name, IList<OcclusionAtlas> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.OcclusionAtlas* all = (Native.OcclusionAtlas*)call.Memory((long)list.Count * sizeof(Native.OcclusionAtlas));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.OcclusionAtlas made) { Fields.Width = made.Width; Fields.Height = made.Height; Fields.UvSet = made.UvSet; Fields.Dilation = made.Dilation; Fields.Empty = made.Empty; }
    }

    /// <summary>
    /// A polygon and the kind of its coordinates.
    ///
    /// The polygon is simple: its edges meet in its vertices only, where exactly two of them meet, and no edge is a point.
    /// Its vertices run in either direction. Convex kinds need a turn at every vertex.
    /// </summary>
    public sealed unsafe partial class PolygonDesc
    {
        internal Native.PolygonDesc Fields = Native.PolygonDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static PolygonDesc Default { get { return new PolygonDesc(); } }

        /// <summary>default Barycentric.Wachspress</summary>
        public Barycentric Kind { get { return Fields.Kind; } set { Fields.Kind = value; } }
        /// <summary>[vertex_count] x and y, finite; required</summary>
        public readonly Column<float>[] Vertex = new Column<float>[2];
        /// <summary>
        /// HARMONIC: parts of each side of a triangle, 1..256; default 32. The solution has about
        /// vertex_count segments^2 / 2 nodes. Nodes times vertices are limited to 2^24.
        /// </summary>
        public uint Segments { get { return Fields.Segments; } set { Fields.Segments = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.PolygonDesc Build(Call call, string name, long rows = -1)
        {
            Native.PolygonDesc made = Fields;
            for (int i = 0; i < 2; ++i) made.Vertex[i] = call.F32In(Vertex[i], name, "Vertex", ref rows);
            made.VertexCount = checked((uint)(Math.Max(rows, 0)));
            return made;
        }
        internal static Native.PolygonDesc* BuildAll(Call call, string name, IList<PolygonDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.PolygonDesc* all = (Native.PolygonDesc*)call.Memory((long)list.Count * sizeof(Native.PolygonDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Points at which coordinates are computed, as columns of `count` elements. Required: position.</summary>
    public sealed unsafe partial class PolygonPoints
    {
        internal Native.PolygonPoints Fields = Native.PolygonPoints.Default;

        /// <summary>The defaults of the library.</summary>
        public static PolygonPoints Default { get { return new PolygonPoints(); } }

        /// <summary>x and y; required</summary>
        public readonly Column<float>[] Position = new Column<float>[2];

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.PolygonPoints Build(Call call, string name, long rows = -1)
        {
            Native.PolygonPoints made = Fields;
            for (int i = 0; i < 2; ++i) made.Position[i] = call.F32In(Position[i], name, "Position", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.PolygonPoints* BuildAll(Call call, string name, IList<PolygonPoints> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.PolygonPoints* all = (Native.PolygonPoints*)call.Memory((long)list.Count * sizeof(Native.PolygonPoints));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Columns for the coordinates.</summary>
    public sealed unsafe partial class PolygonWeights
    {
        internal Native.PolygonWeights Fields = Native.PolygonWeights.Default;

        /// <summary>The defaults of the library.</summary>
        public static PolygonWeights Default { get { return new PolygonWeights(); } }

        /// <summary>[weight_count] b_i, one column for each vertex; NULL columns are not wanted</summary>
        public Column<float>[] Weight;
        /// <summary>written: points outside the polygon</summary>
        public long OutsideCount { get { return Fields.OutsideCount; } set { Fields.OutsideCount = value; } }
        /// <summary>written: points that are not finite</summary>
        public long NonfiniteCount { get { return Fields.NonfiniteCount; } set { Fields.NonfiniteCount = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.PolygonWeights Build(Call call, string name, long rows = -1)
        {
            Native.PolygonWeights made = Fields;
            made.Weight = call.F32Outs(Weight, name, "Weight", ref rows);
            made.WeightCount = checked((uint)(Weight == null ? 0 : Weight.Length));
            return made;
        }
        internal static Native.PolygonWeights* BuildAll(Call call, string name, IList<PolygonWeights> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.PolygonWeights* all = (Native.PolygonWeights*)call.Memory((long)list.Count * sizeof(Native.PolygonWeights));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.PolygonWeights made) { Fields.OutsideCount = made.OutsideCount; Fields.NonfiniteCount = made.NonfiniteCount; }
    }

    /// <summary>Directions to project, as columns of `count` elements.</summary>
    public sealed unsafe partial class Directions
    {
        internal Native.Directions Fields = Native.Directions.Default;

        /// <summary>The defaults of the library.</summary>
        public static Directions Default { get { return new Directions(); } }

        /// <summary>any but Projection.None; required</summary>
        public Projection Projection { get { return Fields.Projection; } set { Fields.Projection = value; } }
        /// <summary>x, y, z, any length; required</summary>
        public readonly Column<float>[] Direction = new Column<float>[3];
        /// <summary>change of `direction` per pixel step in x; absent = 0</summary>
        public readonly Column<float>[] DirectionDx = new Column<float>[3];
        /// <summary>change of `direction` per pixel step in y; absent = 0</summary>
        public readonly Column<float>[] DirectionDy = new Column<float>[3];

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Directions Build(Call call, string name, long rows = -1)
        {
            Native.Directions made = Fields;
            for (int i = 0; i < 3; ++i) made.Direction[i] = call.F32In(Direction[i], name, "Direction", ref rows);
            for (int i = 0; i < 3; ++i) made.DirectionDx[i] = call.F32In(DirectionDx[i], name, "DirectionDx", ref rows);
            for (int i = 0; i < 3; ++i) made.DirectionDy[i] = call.F32In(DirectionDy[i], name, "DirectionDy", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.Directions* BuildAll(Call call, string name, IList<Directions> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Directions* all = (Native.Directions*)call.Memory((long)list.Count * sizeof(Native.Directions));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Columns for points of images; NULL = not wanted.</summary>
    public sealed unsafe partial class ProjectedPoints
    {
        internal Native.ProjectedPoints Fields = Native.ProjectedPoints.Default;

        /// <summary>The defaults of the library.</summary>
        public static ProjectedPoints Default { get { return new ProjectedPoints(); } }

        /// <summary>across, 0..1</summary>
        public Column<float> U;
        /// <summary>down, 0..1</summary>
        public Column<float> V;
        /// <summary>face of CUBE, 0..5; 0 for other projections</summary>
        public Column<uint> Face;
        /// <summary>du/dx, within +-1e30; for CUBE on the plane of the face</summary>
        public Column<float> Dudx;
        /// <summary>dv/dx</summary>
        public Column<float> Dvdx;
        /// <summary>du/dy</summary>
        public Column<float> Dudy;
        /// <summary>dv/dy</summary>
        public Column<float> Dvdy;
        /// <summary>written: directions that count as +Z</summary>
        public long NonfiniteCount { get { return Fields.NonfiniteCount; } set { Fields.NonfiniteCount = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.ProjectedPoints Build(Call call, string name, long rows = -1)
        {
            Native.ProjectedPoints made = Fields;
            made.U = call.F32Out(U, name, "U", ref rows);
            made.V = call.F32Out(V, name, "V", ref rows);
            made.Face = call.U32Out(Face, name, "Face", ref rows);
            made.Dudx = call.F32Out(Dudx, name, "Dudx", ref rows);
            made.Dvdx = call.F32Out(Dvdx, name, "Dvdx", ref rows);
            made.Dudy = call.F32Out(Dudy, name, "Dudy", ref rows);
            made.Dvdy = call.F32Out(Dvdy, name, "Dvdy", ref rows);
            return made;
        }
        internal static Native.ProjectedPoints* BuildAll(Call call, string name, IList<ProjectedPoints> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.ProjectedPoints* all = (Native.ProjectedPoints*)call.Memory((long)list.Count * sizeof(Native.ProjectedPoints));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.ProjectedPoints made) { Fields.NonfiniteCount = made.NonfiniteCount; }
    }

    /// <summary>Points of images, as columns of `count` elements.</summary>
    public sealed unsafe partial class ImagePoints
    {
        internal Native.ImagePoints Fields = Native.ImagePoints.Default;

        /// <summary>The defaults of the library.</summary>
        public static ImagePoints Default { get { return new ImagePoints(); } }

        /// <summary>any but Projection.None; required</summary>
        public Projection Projection { get { return Fields.Projection; } set { Fields.Projection = value; } }
        /// <summary>across, clamped to 0..1; LAT_LONG repeats; required</summary>
        public Column<float> U;
        /// <summary>down, clamped to 0..1; required</summary>
        public Column<float> V;
        /// <summary>face of CUBE; absent = 0; numbers above 5 mean 5; other projections ignore it</summary>
        public Column<uint> Face;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.ImagePoints Build(Call call, string name, long rows = -1)
        {
            Native.ImagePoints made = Fields;
            made.U = call.F32In(U, name, "U", ref rows);
            made.V = call.F32In(V, name, "V", ref rows);
            made.Face = call.U32In(Face, name, "Face", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.ImagePoints* BuildAll(Call call, string name, IList<ImagePoints> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.ImagePoints* all = (Native.ImagePoints*)call.Memory((long)list.Count * sizeof(Native.ImagePoints));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Columns for the directions of points; NULL = not wanted.</summary>
    public sealed unsafe partial class PointDirections
    {
        internal Native.PointDirections Fields = Native.PointDirections.Default;

        /// <summary>The defaults of the library.</summary>
        public static PointDirections Default { get { return new PointDirections(); } }

        /// <summary>x, y, z, unit; -Z outside the disc of MIRROR_BALL and ANGULAR</summary>
        public readonly Column<float>[] Direction = new Column<float>[3];
        /// <summary>
        /// Solid angle per area of (u, v) at the point [sr]; 0 outside the disc. A texel of a small image of n texels has
        /// about the n-th part of it; the integral over the image (six faces) is 4 pi.
        /// </summary>
        public Column<float> SolidAngle;
        /// <summary>written: points with a coordinate that is not finite; it counts as 0</summary>
        public long NonfiniteCount { get { return Fields.NonfiniteCount; } set { Fields.NonfiniteCount = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.PointDirections Build(Call call, string name, long rows = -1)
        {
            Native.PointDirections made = Fields;
            for (int i = 0; i < 3; ++i) made.Direction[i] = call.F32Out(Direction[i], name, "Direction", ref rows);
            made.SolidAngle = call.F32Out(SolidAngle, name, "SolidAngle", ref rows);
            return made;
        }
        internal static Native.PointDirections* BuildAll(Call call, string name, IList<PointDirections> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.PointDirections* all = (Native.PointDirections*)call.Memory((long)list.Count * sizeof(Native.PointDirections));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.PointDirections made) { Fields.NonfiniteCount = made.NonfiniteCount; }
    }

    /// <summary>All directions, in one image or six. Required: projection, images.</summary>
    public sealed unsafe partial class DirectionImages
    {
        internal Native.DirectionImages Fields = Native.DirectionImages.Default;

        /// <summary>The defaults of the library.</summary>
        public static DirectionImages Default { get { return new DirectionImages(); } }

        /// <summary>any but Projection.None</summary>
        public Projection Projection { get { return Fields.Projection; } set { Fields.Projection = value; } }
        /// <summary>arrangement of CUBE; default six images; others ignore it</summary>
        public CubeLayout Layout { get { return Fields.Layout; } set { Fields.Layout = value; } }
        /// <summary>
        /// One image, or the six of CubeLayout.Faces, of one struct_size, format and size. Square for MIRROR_BALL,
        /// ANGULAR and OCTAHEDRAL, and the size of the layout for CUBE. Borrowed for the call.
        /// </summary>
        public IList<Image> Images;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.DirectionImages Build(Call call, string name, long rows = -1)
        {
            Native.DirectionImages made = Fields;
            made.Images = Image.BuildAll(call, Call.Join(name, "Images"), Images);
            return made;
        }
        internal static Native.DirectionImages* BuildAll(Call call, string name, IList<DirectionImages> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.DirectionImages* all = (Native.DirectionImages*)call.Memory((long)list.Count * sizeof(Native.DirectionImages));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
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
    public sealed unsafe partial class Draw
    {
        internal Native.Draw Fields = Native.Draw.Default;

        /// <summary>The defaults of the library.</summary>
        public static Draw Default { get { return new Draw(); } }

        /// <summary>required; borrowed for the call</summary>
        public Mesh Mesh;
        /// <summary>borrowed for the call; NULL = draw depth only, without programs</summary>
        public Material Material;
        /// <summary>affine, finite; default identity</summary>
        public Matrix4 ObjectToWorld { get { return Fields.ObjectToWorld; } set { Fields.ObjectToWorld = value; } }
        /// <summary>
        /// Object-to-world matrices, [instance_count][16], each affine and finite, instead of object_to_world. The mesh is
        /// drawn with each of them as if by separate draws, in order. Borrowed for the call.
        /// </summary>
        public Matrix4[] Instances;
        /// <summary>default Frequency.Phong</summary>
        public Frequency Frequency { get { return Fields.Frequency; } set { Fields.Frequency = value; } }
        /// <summary>default none</summary>
        public DrawFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>default Cull.None</summary>
        public Cull Cull { get { return Fields.Cull; } set { Fields.Cull = value; } }
        /// <summary>default Compare.Less</summary>
        public Compare Compare { get { return Fields.Compare; } set { Fields.Compare = value; } }
        /// <summary>added to depth, -1..1; the sum is clamped to 0..1; default 0</summary>
        public float DepthBias { get { return Fields.DepthBias; } set { Fields.DepthBias = value; } }
        /// <summary>
        /// factor of another bias: the larger of |dz/dx| and |dz/dy| per pixel; finite;
        /// default 0
        /// </summary>
        public float DepthBiasSlope { get { return Fields.DepthBiasSlope; } set { Fields.DepthBiasSlope = value; } }
        /// <summary>default Fill.Solid</summary>
        public Fill Fill { get { return Fields.Fill; } set { Fields.Fill = value; } }
        /// <summary>width of lines and points [pixels], 1/16..64; default 0 = 1</summary>
        public float FillWidth { get { return Fields.FillWidth; } set { Fields.FillWidth = value; } }
        /// <summary>edges of Fill.Lines; default EdgeFlags.All</summary>
        public EdgeFlags Edges { get { return Fields.Edges; } set { Fields.Edges = value; } }
        /// <summary>threshold of EdgeFlags.Crease, as in EdgesDesc: -1..1; default 0.5</summary>
        public float CreaseCosine { get { return Fields.CreaseCosine; } set { Fields.CreaseCosine = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Draw Build(Call call, string name, long rows = -1)
        {
            Native.Draw made = Fields;
            made.Mesh = call.UseOrNull(Mesh, name, "Mesh");
            made.Material = call.UseOrNull(Material, name, "Material");
            made.Instances = (float*)call.Pin(Instances);
            made.InstanceCount = Instances == null ? 0 : Instances.Length;
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.Draw made);
        internal static Native.Draw* BuildAll(Call call, string name, IList<Draw> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Draw* all = (Native.Draw*)call.Memory((long)list.Count * sizeof(Native.Draw));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>
    /// A whole frame, or a window of it. All pointers are borrowed for the call. Required: framebuffer.
    ///
    /// Draws are projected to the picture. The framebuffer holds the window of the picture that begins at pixel (crop_x,
    /// crop_y). Its pixels have the same bits as in the whole picture.
    /// </summary>
    public sealed unsafe partial class RenderDesc
    {
        internal Native.RenderDesc Fields = Native.RenderDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static RenderDesc Default { get { return new RenderDesc(); } }

        /// <summary>required</summary>
        public Framebuffer Framebuffer;
        /// <summary>linear, premultiplied RGBA; default 0</summary>
        public Float4 ClearColor { get { return Fields.ClearColor; } set { Fields.ClearColor = value; } }
        /// <summary>0..1; default 1</summary>
        public float ClearDepth { get { return Fields.ClearDepth; } set { Fields.ClearDepth = value; } }
        /// <summary>default none</summary>
        public RenderFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>
        /// Replaces `view`. An aspect of 0, the default, means the aspect of the viewport, or of the picture if there is no
        /// viewport. NULL = `view`.
        /// </summary>
        public Camera? Camera;
        /// <summary>default: identity matrices, eye at 0</summary>
        public View View { get { return Fields.View; } set { Fields.View = value; } }
        /// <summary>default Visibility.Depth</summary>
        public Visibility Visibility { get { return Fields.Visibility; } set { Fields.Visibility = value; } }
        /// <summary>
        /// [draw_count], all with the same struct_size, in order; NULL if draw_count is
        /// 0
        /// </summary>
        public IList<Draw> Draws;
        /// <summary>[light_count]; NULL if light_count is 0</summary>
        public IList<Light> Lights;
        /// <summary>
        /// [light_count], each NULL or a shadow of shd/shadow.h that was rendered for a light of the same kind. The light
        /// that reaches a fragment is multiplied by the visibility at its position, with its shading normal. NULL = none.
        /// </summary>
        public IList<Shadow> Shadows;
        /// <summary>pixels, framebuffer size..65536; default 0 = framebuffer size</summary>
        public uint PictureWidth { get { return Fields.PictureWidth; } set { Fields.PictureWidth = value; } }
        /// <summary>pixels, framebuffer size..65536; default 0 = framebuffer size</summary>
        public uint PictureHeight { get { return Fields.PictureHeight; } set { Fields.PictureHeight = value; } }
        /// <summary>
        /// column of the picture at which the framebuffer begins; the framebuffer lies
        /// inside the picture; default 0
        /// </summary>
        public uint CropX { get { return Fields.CropX; } set { Fields.CropX = value; } }
        /// <summary>row of the picture at which the framebuffer begins; default 0</summary>
        public uint CropY { get { return Fields.CropY; } set { Fields.CropY = value; } }
        /// <summary>
        /// target of NDC -1..1 in the picture, not empty; cuts triangles, lines and points
        /// at its edge; NULL = the whole picture
        /// </summary>
        public Region? Viewport;
        /// <summary>pixels of the picture that may change; NULL = all</summary>
        public Region? Scissor;
        /// <summary>
        /// n, 2..16; 0 and 1 = off. The frame is drawn as a picture n times as large, up to 65536 pixels a side, with the
        /// framebuffer's number of samples in each pixel; crop, viewport and scissor are scaled by n. Colour and targets of
        /// a pixel are the plain average of its n x n pixels; depth and the other planes have the values of the top left
        /// one. Derivatives (and so footprints of textures) and raster positions in programs refer to the large picture;
        /// lines and points are n times as wide in it. With RenderFlags.Load each of the n x n pixels starts with the pixel's
        /// values. The large picture is drawn in blocks of up to 1024 x 1024 pixels; only one block is in memory. Statistics
        /// are sums over blocks, so a triangle counts in each block.
        /// </summary>
        public uint Supersampling { get { return Fields.Supersampling; } set { Fields.Supersampling = value; } }
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
        public uint PassTriangles { get { return Fields.PassTriangles; } set { Fields.PassTriangles = value; } }
        /// <summary>
        /// Light from all directions, in addition to the lights; NULL = none. Every model with lights reflects it, except
        /// GOOCH. It casts no shadows; SlotTarget.Occlusion multiplies all of its reflected light. It must
        /// have been created with the tables of the models of the draws (EnvironmentDesc.tables).
        /// </summary>
        public Environment Environment;
        /// <summary>factor of its radiance, 0..1e12; default 1</summary>
        public float EnvironmentIntensity { get { return Fields.EnvironmentIntensity; } set { Fields.EnvironmentIntensity = value; } }
        /// <summary>
        /// rotation or reflection of its directions, column-major, with orthonormal
        /// columns within 1e-3; default identity
        /// </summary>
        public Matrix3 EnvironmentToWorld { get { return Fields.EnvironmentToWorld; } set { Fields.EnvironmentToWorld = value; } }
        /// <summary>default Background.Clear</summary>
        public Background Background { get { return Fields.Background; } set { Fields.Background = value; } }
        /// <summary>
        /// roughness of the GGX lobe that blurs the environment behind the picture, 0..1;
        /// values above 0 need EnvironmentTables.Ggx; default 0 = sharp
        /// </summary>
        public float BackgroundRoughness { get { return Fields.BackgroundRoughness; } set { Fields.BackgroundRoughness = value; } }
        /// <summary>
        /// [volume_count], all with the same struct_size. They are blended over the finished draws in this order, so the
        /// caller sorts volumes from far to near. A ray of a pixel ends at the depth of a sample, with one march for all
        /// samples of equal depth. Depth decreases with the distance if clear_depth is below 1/2, and increases otherwise.
        /// Depth and planes other than colour keep their values. NULL if volume_count is 0.
        /// </summary>
        public IList<VolumeDraw> Volumes;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.RenderDesc Build(Call call, string name, long rows = -1)
        {
            Native.RenderDesc made = Fields;
            made.Framebuffer = call.UseOrNull(Framebuffer, name, "Framebuffer");
            if (Camera.HasValue) { made.Camera = (global::Shd.Camera*)call.Memory(sizeof(global::Shd.Camera)); *made.Camera = Camera.Value; }
            made.Draws = Draw.BuildAll(call, Call.Join(name, "Draws"), Draws);
            made.DrawCount = Draws == null ? 0 : Draws.Count;
            long lightCount = -1;
            made.Lights = call.UseAll(Lights, name, "Lights", ref lightCount);
            made.LightCount = Math.Max(lightCount, 0);
            made.Shadows = call.UseAll(Shadows, name, "Shadows", ref lightCount);
            made.LightCount = Math.Max(lightCount, 0);
            if (Viewport.HasValue) { made.Viewport = (global::Shd.Region*)call.Memory(sizeof(global::Shd.Region)); *made.Viewport = Viewport.Value; }
            if (Scissor.HasValue) { made.Scissor = (global::Shd.Region*)call.Memory(sizeof(global::Shd.Region)); *made.Scissor = Scissor.Value; }
            made.Environment = call.UseOrNull(Environment, name, "Environment");
            made.Volumes = VolumeDraw.BuildAll(call, Call.Join(name, "Volumes"), Volumes);
            made.VolumeCount = Volumes == null ? 0 : Volumes.Count;
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.RenderDesc made);
        internal static Native.RenderDesc* BuildAll(Call call, string name, IList<RenderDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.RenderDesc* all = (Native.RenderDesc*)call.Memory((long)list.Count * sizeof(Native.RenderDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Options and budgets of a load. A budget that would be exceeded is Result.ErrorLimit.</summary>
    public sealed unsafe partial class SceneDesc
    {
        internal Native.SceneDesc Fields = Native.SceneDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static SceneDesc Default { get { return new SceneDesc(); } }

        /// <summary>default none</summary>
        public SceneFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>
        /// flags of all meshes; meshes with uv have tangents, unless a normal map reads uv1;
        /// default none
        /// </summary>
        public MeshFlags MeshFlags { get { return Fields.MeshFlags; } set { Fields.MeshFlags = value; } }
        /// <summary>
        /// sampler of all textures; its wraps are replaced by those of the file, and
        /// its filter and magnification where the file has nearest texels or
        /// levels. Borrowed for the call; NULL = trilinear
        /// </summary>
        public SamplerDesc? Sampler;
        /// <summary>
        /// formats, flags, tables and budgets of each texture file; its color_space is
        /// ignored; worker_path is that of the model,
        /// too. Borrowed for the call; NULL = defaults
        /// </summary>
        public LoadDesc Texture;
        /// <summary>sum of the model and the files that are read with it; 0 = 2^30</summary>
        public ulong MaxFileBytes { get { return Fields.MaxFileBytes; } set { Fields.MaxFileBytes = value; } }
        /// <summary>sum over all meshes; 0 = 2^26</summary>
        public ulong MaxVertices { get { return Fields.MaxVertices; } set { Fields.MaxVertices = value; } }
        /// <summary>sum over all meshes; 0 = 2^26</summary>
        public ulong MaxTriangles { get { return Fields.MaxTriangles; } set { Fields.MaxTriangles = value; } }
        /// <summary>0 = 2^18; always at most 512 deep</summary>
        public ulong MaxNodes { get { return Fields.MaxNodes; } set { Fields.MaxNodes = value; } }
        /// <summary>up to 2^20, the maximum of a frame; 0 = 2^18</summary>
        public ulong MaxInstances { get { return Fields.MaxInstances; } set { Fields.MaxInstances = value; } }
        /// <summary>all textures with their mip levels; 0 = 2^32</summary>
        public ulong MaxTextureBytes { get { return Fields.MaxTextureBytes; } set { Fields.MaxTextureBytes = value; } }
        /// <summary>
        /// [s] 0 = 60. Ends the process that reads; with SceneFlags.InProcess checked
        /// between the steps of a reader
        /// </summary>
        public double TimeLimit { get { return Fields.TimeLimit; } set { Fields.TimeLimit = value; } }
        /// <summary>memory of the process that reads, and of what it sends; 0 = 2^32 [bytes]</summary>
        public ulong MaxReaderBytes { get { return Fields.MaxReaderBytes; } set { Fields.MaxReaderBytes = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.SceneDesc Build(Call call, string name, long rows = -1)
        {
            Native.SceneDesc made = Fields;
            if (Sampler.HasValue) { made.Sampler = (global::Shd.SamplerDesc*)call.Memory(sizeof(global::Shd.SamplerDesc)); *made.Sampler = Sampler.Value; }
            if (Texture != null) made.Texture = LoadDesc.BuildAll(call, Call.Join(name, "Texture"), new LoadDesc[] { Texture });
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.SceneDesc made);
        internal static Native.SceneDesc* BuildAll(Call call, string name, IList<SceneDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.SceneDesc* all = (Native.SceneDesc*)call.Memory((long)list.Count * sizeof(Native.SceneDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Light and draws of a map; borrowed for the call. Required: light.</summary>
    public sealed unsafe partial class ShadowRenderDesc
    {
        internal Native.ShadowRenderDesc Fields = Native.ShadowRenderDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static ShadowRenderDesc Default { get { return new ShadowRenderDesc(); } }

        /// <summary>required; directional, spot or point</summary>
        public Light Light;
        /// <summary>
        /// Draws that cast shadows, as in RenderDesc; NULL if draw_count is 0. Depth comparison, depth biases and
        /// culling of a draw are ignored; a draw with DrawFlags.KeepDepth casts no shadow. Vertex programs run with the
        /// light's view. Alpha tests and programs that drop fragments apply too, except for draws with WEIGHTED or SORTED
        /// blending. Opacity by itself has no effect.
        /// </summary>
        public IList<Draw> Draws;
        /// <summary>
        /// Range of depths, near_plane &lt; far_plane. Surfaces outside cast no shadow. Both 0 = fitted to the draws.
        /// Directional lights: measured from the origin of the world along the direction of the light, any sign. Other
        /// lights: measured from the light along the axis of the face, &gt; 0; a fitted near_plane is at least 1/256 of
        /// far_plane.
        /// </summary>
        public float NearPlane { get { return Fields.NearPlane; } set { Fields.NearPlane = value; } }
        public float FarPlane { get { return Fields.FarPlane; } set { Fields.FarPlane = value; } }
        /// <summary>
        /// Directional lights: the part of the world that needs shadows. Both 0 = the bounds of the draws. Draws between
        /// this part and the light still cast shadows. The size of texels is rounded up in steps of 1/8 to 1/16, and texels
        /// lie at multiples of their size, so shadows do not shimmer while bounds of constant size move.
        /// </summary>
        public Float3 BoundsMin { get { return Fields.BoundsMin; } set { Fields.BoundsMin = value; } }
        public Float3 BoundsMax { get { return Fields.BoundsMax; } set { Fields.BoundsMax = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.ShadowRenderDesc Build(Call call, string name, long rows = -1)
        {
            Native.ShadowRenderDesc made = Fields;
            made.Light = call.UseOrNull(Light, name, "Light");
            made.Draws = Draw.BuildAll(call, Call.Join(name, "Draws"), Draws);
            made.DrawCount = Draws == null ? 0 : Draws.Count;
            return made;
        }
        internal static Native.ShadowRenderDesc* BuildAll(Call call, string name, IList<ShadowRenderDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.ShadowRenderDesc* all = (Native.ShadowRenderDesc*)call.Memory((long)list.Count * sizeof(Native.ShadowRenderDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Points on surfaces; borrowed for the call.</summary>
    public sealed unsafe partial class ShadowLookups
    {
        internal Native.ShadowLookups Fields = Native.ShadowLookups.Default;

        /// <summary>The defaults of the library.</summary>
        public static ShadowLookups Default { get { return new ShadowLookups(); } }

        /// <summary>x, y, z, world space; required unless count is 0</summary>
        public readonly Column<float>[] Position = new Column<float>[3];
        /// <summary>unit, world space; all three columns or none</summary>
        public readonly Column<float>[] Normal = new Column<float>[3];

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.ShadowLookups Build(Call call, string name, long rows = -1)
        {
            Native.ShadowLookups made = Fields;
            for (int i = 0; i < 3; ++i) made.Position[i] = call.F32In(Position[i], name, "Position", ref rows);
            for (int i = 0; i < 3; ++i) made.Normal[i] = call.F32In(Normal[i], name, "Normal", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.ShadowLookups* BuildAll(Call call, string name, IList<ShadowLookups> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.ShadowLookups* all = (Native.ShadowLookups*)call.Memory((long)list.Count * sizeof(Native.ShadowLookups));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Output columns of a shape. They do not overlap; each may be absent.</summary>
    public sealed unsafe partial class ShapeColumns
    {
        internal Native.ShapeColumns Fields = Native.ShapeColumns.Default;

        /// <summary>The defaults of the library.</summary>
        public static ShapeColumns Default { get { return new ShapeColumns(); } }

        /// <summary>x, y, z, object space</summary>
        public readonly Column<float>[] Position = new Column<float>[3];
        /// <summary>x, y, z, unit, outwards</summary>
        public readonly Column<float>[] Normal = new Column<float>[3];
        /// <summary>u, v</summary>
        public readonly Column<float>[] Uv = new Column<float>[2];
        /// <summary>three for each triangle</summary>
        public Column<uint> Indices;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.ShapeColumns Build(Call call, string name, long rows = -1)
        {
            Native.ShapeColumns made = Fields;
            for (int i = 0; i < 3; ++i) made.Position[i] = call.F32Out(Position[i], name, "Position", ref rows);
            for (int i = 0; i < 3; ++i) made.Normal[i] = call.F32Out(Normal[i], name, "Normal", ref rows);
            for (int i = 0; i < 2; ++i) made.Uv[i] = call.F32Out(Uv[i], name, "Uv", ref rows);
            long indexCount = -1;
            made.Indices = call.U32Out(Indices, name, "Indices", ref indexCount);
            made.IndexCount = Math.Max(indexCount, 0);
            made.VertexCount = checked((uint)(Math.Max(rows, 0)));
            return made;
        }
        internal static Native.ShapeColumns* BuildAll(Call call, string name, IList<ShapeColumns> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.ShapeColumns* all = (Native.ShapeColumns*)call.Memory((long)list.Count * sizeof(Native.ShapeColumns));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.ShapeColumns made) {  }
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
    public sealed unsafe partial class Slot
    {
        internal Native.Slot Fields = Native.Slot.Default;

        /// <summary>The defaults of the library.</summary>
        public static Slot Default { get { return new Slot(); } }

        /// <summary>the coefficient; each slot of a material has a different one</summary>
        public SlotTarget Target { get { return Fields.Target; } set { Fields.Target = value; } }
        /// <summary>default SlotSource.Constant</summary>
        public SlotSource Source { get { return Fields.Source; } set { Fields.Source = value; } }
        /// <summary>SlotSource.Vertex: first column, 0..7; default 0</summary>
        public uint Attribute { get { return Fields.Attribute; } set { Fields.Attribute = value; } }
        /// <summary>
        /// SlotSource.Texture: a 2D texture, or a 3D texture that is looked up at places;
        /// else NULL; retained by the material
        /// </summary>
        public Texture Texture;
        /// <summary>SlotSource.Texture: NULL = default sampler; retained by the material</summary>
        public Sampler Sampler;
        /// <summary>channel of the texture or the solid texture for scalars, 0..3; default 0</summary>
        public uint Channel { get { return Fields.Channel; } set { Fields.Channel = value; } }
        /// <summary>coordinates for the texture: 0 = uv of the mesh, 1 = uv1; default 0</summary>
        public uint UvSet { get { return Fields.UvSet; } set { Fields.UvSet = value; } }
        /// <summary>
        /// (u', v') = (t[0] u + t[1] v + t[2], t[3] u + t[4] v + t[5]), finite; default identity. glTF's
        /// KHR_texture_transform is T R S, with the rotation r and v downwards
        /// t = {sx cos r, sy sin r, ox, -sx sin r, sy cos r, oy}.
        /// </summary>
        public Float6 UvTransform { get { return Fields.UvTransform; } set { Fields.UvTransform = value; } }
        /// <summary>
        /// Solid texture of SlotSource.Solid, else NULL; copied by the material. Colours take r, g, b and, for the
        /// diffuse slot and normals, a; scalars take `channel`. At Phong frequency, and for slots that scale light, the
        /// width of a pixel is max(|dp/dx|, |dp/dy|), with the exact derivatives of the place p by pixel steps; where lobes
        /// are evaluated at vertices or centroids it is 0. `place_width` multiplies it.
        /// </summary>
        public SolidDesc? Solid;
        /// <summary>
        /// Place = place_transform * position, column-major, affine: the last row is 0, 0, 0, 1; default identity. A solid
        /// texture is evaluated at the place. A 3D texture is looked up at (u, v, w) = place, with the derivatives of the
        /// place by pixel steps times `place_width`: it fills the cube from 0 to 1, and its sampler wraps it.
        /// </summary>
        public Matrix4 PlaceTransform { get { return Fields.PlaceTransform; } set { Fields.PlaceTransform = value; } }
        /// <summary>space of the position; default PlaceSpace.Object</summary>
        public PlaceSpace PlaceSpace { get { return Fields.PlaceSpace; } set { Fields.PlaceSpace = value; } }
        /// <summary>
        /// factor of the width of a pixel, 0..1000; 0 = no band limit, level 0 of
        /// 3D textures; default 1
        /// </summary>
        public float PlaceWidth { get { return Fields.PlaceWidth; } set { Fields.PlaceWidth = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.Slot Build(Call call, string name, long rows = -1)
        {
            Native.Slot made = Fields;
            made.Texture = call.UseOrNull(Texture, name, "Texture");
            made.Sampler = call.UseOrNull(Sampler, name, "Sampler");
            if (Solid.HasValue) { made.Solid = (global::Shd.SolidDesc*)call.Memory(sizeof(global::Shd.SolidDesc)); *made.Solid = Solid.Value; }
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.Slot made);
        internal static Native.Slot* BuildAll(Call call, string name, IList<Slot> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.Slot* all = (Native.Slot*)call.Memory((long)list.Count * sizeof(Native.Slot));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Points at which a solid texture is evaluated, as columns of `count` elements. Required: position.</summary>
    public sealed unsafe partial class SolidPoints
    {
        internal Native.SolidPoints Fields = Native.SolidPoints.Default;

        /// <summary>The defaults of the library.</summary>
        public static SolidPoints Default { get { return new SolidPoints(); } }

        /// <summary>x, y, z; required</summary>
        public readonly Column<float>[] Position = new Column<float>[3];
        /// <summary>diameter of a pixel at the point [units of the positions]; absent = 0: no band limit</summary>
        public Column<float> Width;

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.SolidPoints Build(Call call, string name, long rows = -1)
        {
            Native.SolidPoints made = Fields;
            for (int i = 0; i < 3; ++i) made.Position[i] = call.F32In(Position[i], name, "Position", ref rows);
            made.Width = call.F32In(Width, name, "Width", ref rows);
            made.Count = Math.Max(rows, 0);
            return made;
        }
        internal static Native.SolidPoints* BuildAll(Call call, string name, IList<SolidPoints> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.SolidPoints* all = (Native.SolidPoints*)call.Memory((long)list.Count * sizeof(Native.SolidPoints));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Columns for the values of a solid texture; NULL = not wanted. At least one is required.</summary>
    public sealed unsafe partial class SolidValues
    {
        internal Native.SolidValues Fields = Native.SolidValues.Default;

        /// <summary>The defaults of the library.</summary>
        public static SolidValues Default { get { return new SolidValues(); } }

        /// <summary>the pattern, in the range of its kind</summary>
        public Column<float> Value;
        /// <summary>
        /// d value / dx, dy and dz, with the width held constant, limited to -1e30..1e30. Where the pattern jumps or has no
        /// derivative the result is that of one side, or 0.
        /// </summary>
        public readonly Column<float>[] Gradient = new Column<float>[3];
        /// <summary>r, g, b, a of SolidDesc.colors at the value, linear</summary>
        public readonly Column<float>[] Color = new Column<float>[4];
        /// <summary>written: points whose position or width is not finite</summary>
        public long NonfiniteCount { get { return Fields.NonfiniteCount; } set { Fields.NonfiniteCount = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.SolidValues Build(Call call, string name, long rows = -1)
        {
            Native.SolidValues made = Fields;
            made.Value = call.F32Out(Value, name, "Value", ref rows);
            for (int i = 0; i < 3; ++i) made.Gradient[i] = call.F32Out(Gradient[i], name, "Gradient", ref rows);
            for (int i = 0; i < 4; ++i) made.Color[i] = call.F32Out(Color[i], name, "Color", ref rows);
            return made;
        }
        internal static Native.SolidValues* BuildAll(Call call, string name, IList<SolidValues> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.SolidValues* all = (Native.SolidValues*)call.Memory((long)list.Count * sizeof(Native.SolidValues));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
        internal void Take(ref Native.SolidValues made) { Fields.NonfiniteCount = made.NonfiniteCount; }
    }

    /// <summary>Options of tessellation and displacement.</summary>
    public sealed unsafe partial class TessellationDesc
    {
        internal Native.TessellationDesc Fields = Native.TessellationDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static TessellationDesc Default { get { return new TessellationDesc(); } }

        /// <summary>default TessellationMode.Uniform</summary>
        public TessellationMode Mode { get { return Fields.Mode; } set { Fields.Mode = value; } }
        /// <summary>UNIFORM: parts of an edge, 1..Constants.MaxSegments; default 1</summary>
        public uint Segments { get { return Fields.Segments; } set { Fields.Segments = value; } }
        /// <summary>ADAPTIVE: largest number of parts of an edge, 1..Constants.MaxSegments; default 64</summary>
        public uint MaxSegments { get { return Fields.MaxSegments; } set { Fields.MaxSegments = value; } }
        /// <summary>ADAPTIVE: longest part [pixels], without `view` [world units]; &gt; 0; default 8</summary>
        public float EdgeLength { get { return Fields.EdgeLength; } set { Fields.EdgeLength = value; } }
        /// <summary>ADAPTIVE with `view`: of the picture [pixels], 1..65536; default 1024</summary>
        public uint Width { get { return Fields.Width; } set { Fields.Width = value; } }
        /// <summary>ADAPTIVE with `view`: of the picture [pixels], 1..65536; default 1024</summary>
        public uint Height { get { return Fields.Height; } set { Fields.Height = value; } }
        /// <summary>the call is refused if the result would have more, 1..2^28; default 2^24</summary>
        public uint MaxTriangles { get { return Fields.MaxTriangles; } set { Fields.MaxTriangles = value; } }
        /// <summary>
        /// ADAPTIVE: view for lengths in pixels. An edge counts as turned about its middle until it is perpendicular to the
        /// line of sight; its length is then projected to the picture. An edge that passes the eye has max_segments parts,
        /// an edge behind the eye has 1. Borrowed for the call; NULL = lengths in world units.
        /// </summary>
        public View? View;
        /// <summary>ADAPTIVE: [16], column-major; borrowed for the call; NULL = identity</summary>
        public Matrix4? ObjectToWorld;
        /// <summary>channel r is the height; borrowed for the call; NULL = no displacement</summary>
        public Texture Displacement;
        /// <summary>sampler of `displacement`; borrowed for the call; NULL = the default sampler</summary>
        public Sampler Sampler;
        /// <summary>level of detail of the lookups, log2 of base texels, -32..32; default 0</summary>
        public float Lod { get { return Fields.Lod; } set { Fields.Lod = value; } }
        /// <summary>factor of heights [object units], -1e12..1e12; default 0 = no displacement</summary>
        public float Amplitude { get { return Fields.Amplitude; } set { Fields.Amplitude = value; } }
        /// <summary>height that is not displaced, -1e12..1e12; default 0</summary>
        public float Offset { get { return Fields.Offset; } set { Fields.Offset = value; } }
        /// <summary>used with displacement; default DisplacedNormals.Tilted</summary>
        public DisplacedNormals Normals { get { return Fields.Normals; } set { Fields.Normals = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.TessellationDesc Build(Call call, string name, long rows = -1)
        {
            Native.TessellationDesc made = Fields;
            if (View.HasValue) { made.View = (global::Shd.View*)call.Memory(sizeof(global::Shd.View)); *made.View = View.Value; }
            if (ObjectToWorld.HasValue) { made.ObjectToWorld = (float*)call.Memory(sizeof(Matrix4)); *(Matrix4*)made.ObjectToWorld = ObjectToWorld.Value; }
            made.Displacement = call.UseOrNull(Displacement, name, "Displacement");
            made.Sampler = call.UseOrNull(Sampler, name, "Sampler");
            return made;
        }
        internal static Native.TessellationDesc* BuildAll(Call call, string name, IList<TessellationDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.TessellationDesc* all = (Native.TessellationDesc*)call.Memory((long)list.Count * sizeof(Native.TessellationDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Texels and tables of a texture. Required: format, width, height, texels.</summary>
    public sealed unsafe partial class TextureDesc
    {
        internal Native.TextureDesc Fields = Native.TextureDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static TextureDesc Default { get { return new TextureDesc(); } }

        /// <summary>
        /// any; no default. RGB8 to RGB32F are stored as RGBA. Blocks stay compressed, and lookups
        /// decode them (docs/compressed.md): the caller gives its mip levels; other tables are
        /// kept decoded
        /// </summary>
        public Format Format { get { return Fields.Format; } set { Fields.Format = value; } }
        /// <summary>texels, 1..65536; width * height * layers at most 2^28; see `tiles` for larger ones</summary>
        public uint Width { get { return Fields.Width; } set { Fields.Width = value; } }
        /// <summary>texels, 1..65536</summary>
        public uint Height { get { return Fields.Height; } set { Fields.Height = value; } }
        /// <summary>bytes between rows of texels or blocks, at least the bytes of a row; 0 = packed</summary>
        public long RowStride { get { return Fields.RowStride; } set { Fields.RowStride = value; } }
        /// <summary>bytes between layers, at least the rows of a layer times the row stride; 0 = packed</summary>
        public long LayerStride { get { return Fields.LayerStride; } set { Fields.LayerStride = value; } }
        /// <summary>images of the array, 1..2048; default 1</summary>
        public uint Layers { get { return Fields.Layers; } set { Fields.Layers = value; } }
        /// <summary>default none</summary>
        public TextureFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>sources of r, g, b, a of lookups; default Channel.Default</summary>
        public Channel4 Swizzle { get { return Fields.Swizzle; } set { Fields.Swizzle = value; } }
        /// <summary>
        /// values of channels that the format does not have, in lookups inside and outside the
        /// image; finite; default 0, 0, 0, 1
        /// </summary>
        public Float4 Fill { get { return Fields.Fill; } set { Fields.Fill = value; } }
        /// <summary>default none</summary>
        public TableFlags Tables { get { return Fields.Tables; } set { Fields.Tables = value; } }
        /// <summary>
        /// Slices of a 3D texture, 1..65536; default 0 = a 2D texture. width * height * depth is at most 2^28, `layers` is
        /// 1, and TableFlags.Mipmap is the only table. Texels are [depth][height][width], and `layer_stride` is the distance
        /// of slices. Lookups read (u, v, w); w = 0 is the outer face of slice 0. A level halves all three sizes.
        /// </summary>
        public uint Depth { get { return Fields.Depth; } set { Fields.Depth = value; } }
        /// <summary>
        /// Default Projection.None. With any other one, lookups read (u, v, w) as a direction of any length. `width` and
        /// `height` are equal unless it is LAT_LONG; `layers` of CUBE are the 6 faces +X, -X, +Y, -Y, +Z, -Z; `depth` is 0;
        /// `tables` has TableFlags.Mipmap at most. Mip levels are averages of texels of one image, unweighted.
        /// </summary>
        public Projection Projection { get { return Fields.Projection; } set { Fields.Projection = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.TextureDesc Build(Call call, string name, long rows = -1)
        {
            Native.TextureDesc made = Fields;
            More(call, name, ref made);
            return made;
        }
        partial void More(Call call, string name, ref Native.TextureDesc made);
        internal static Native.TextureDesc* BuildAll(Call call, string name, IList<TextureDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.TextureDesc* all = (Native.TextureDesc*)call.Memory((long)list.Count * sizeof(Native.TextureDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Options of a texture in a file. Required: cache.</summary>
    public sealed unsafe partial class TileFileDesc
    {
        internal Native.TileFileDesc Fields = Native.TileFileDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static TileFileDesc Default { get { return new TileFileDesc(); } }

        /// <summary>
        /// meaning of 8-bit numbers; default AUTO = as declared by the file, sRGB if it
        /// declares nothing. Other numbers must be linear, or be declared so here
        /// </summary>
        public ColorEncoding ColorSpace { get { return Fields.ColorSpace; } set { Fields.ColorSpace = value; } }
        /// <summary>retained by the texture</summary>
        public TileCache Cache;
        /// <summary>
        /// open readers to keep, 1..4096; default 0 = 16. Each has a descriptor and some
        /// memory of OpenImageIO; more exist while more threads read. A KTX2 or DDS file
        /// has one descriptor for all threads
        /// </summary>
        public long MaxReaders { get { return Fields.MaxReaders; } set { Fields.MaxReaders = value; } }
        /// <summary>colour of absent files of a set, linear; finite; default 0, 0, 0, 1</summary>
        public Float4 Fill { get { return Fields.Fill; } set { Fields.Fill = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.TileFileDesc Build(Call call, string name, long rows = -1)
        {
            Native.TileFileDesc made = Fields;
            made.Cache = call.UseOrNull(Cache, name, "Cache");
            return made;
        }
        internal static Native.TileFileDesc* BuildAll(Call call, string name, IList<TileFileDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.TileFileDesc* all = (Native.TileFileDesc*)call.Memory((long)list.Count * sizeof(Native.TileFileDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Density, transfer function, steps and shading of a volume. Required: point_count, texture, density, extinction.</summary>
    public sealed unsafe partial class VolumeDesc
    {
        internal Native.VolumeDesc Fields = Native.VolumeDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static VolumeDesc Default { get { return new VolumeDesc(); } }

        /// <summary>3D texture; retained</summary>
        public Texture Texture;
        /// <summary>
        /// [point_count] densities of the points, -1e38..1e38, never decreasing. Values are
        /// interpolated between points; two points of one density are a jump
        /// </summary>
        public Column<float> Density;
        /// <summary>[point_count] sigma [1 / world unit], 0..1e12</summary>
        public Column<float> Extinction;
        /// <summary>
        /// [point_count] scene-linear r, g, b, 0..1e6: radiance, or the diffuse colour of
        /// `material`; absent = 1
        /// </summary>
        public readonly Column<float>[] Color = new Column<float>[3];
        /// <summary>
        /// Shades the points by the lights of the frame, with shadows and cookies, but not by its environment: an opaque
        /// material without slots and debug view, of a model that reflects light; others are Result.ErrorUnsupported. Its
        /// diffuse colour is multiplied by `color`. The normal is the direction in which density falls fastest, by central
        /// differences over two texels; it faces the viewer where the gradient is 0, and always with
        /// MaterialFlags.DoubleSided. NULL = `color` is radiance; retained.
        /// </summary>
        public Material Material;
        /// <summary>corner of the texture's (0, 0, 0) in object space, finite; default 0</summary>
        public Float3 BoxMin { get { return Fields.BoxMin; } set { Fields.BoxMin = value; } }
        /// <summary>corner of the texture's (1, 1, 1); above box_min on each axis; default 1</summary>
        public Float3 BoxMax { get { return Fields.BoxMax; } set { Fields.BoxMax = value; } }
        /// <summary>length of a step [world units], above 0, at most 1e12; default 1/256</summary>
        public float Step { get { return Fields.Step; } set { Fields.Step = value; } }
        /// <summary>
        /// the point of a step lies at a fraction 1/2 + jitter (h - 1/2) of the step, with h in [0, 1) hashed
        /// from the pixel of the picture and `seed`; 0..1; default 0
        /// </summary>
        public float Jitter { get { return Fields.Jitter; } set { Fields.Jitter = value; } }
        /// <summary>seed of the jitter; default 0</summary>
        public uint Seed { get { return Fields.Seed; } set { Fields.Seed = value; } }
        /// <summary>reserved; 0</summary>
        public uint Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.VolumeDesc Build(Call call, string name, long rows = -1)
        {
            Native.VolumeDesc made = Fields;
            made.Texture = call.UseOrNull(Texture, name, "Texture");
            made.Density = call.F32In(Density, name, "Density", ref rows);
            made.Extinction = call.F32In(Extinction, name, "Extinction", ref rows);
            for (int i = 0; i < 3; ++i) made.Color[i] = call.F32In(Color[i], name, "Color", ref rows);
            made.Material = call.UseOrNull(Material, name, "Material");
            made.PointCount = checked((uint)(Math.Max(rows, 0)));
            return made;
        }
        internal static Native.VolumeDesc* BuildAll(Call call, string name, IList<VolumeDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.VolumeDesc* all = (Native.VolumeDesc*)call.Memory((long)list.Count * sizeof(Native.VolumeDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>One volume in the frame. Required: volume.</summary>
    public sealed unsafe partial class VolumeDraw
    {
        internal Native.VolumeDraw Fields = Native.VolumeDraw.Default;

        /// <summary>The defaults of the library.</summary>
        public static VolumeDraw Default { get { return new VolumeDraw(); } }

        /// <summary>borrowed for the call</summary>
        public Volume Volume;
        /// <summary>affine, finite, invertible; default identity</summary>
        public Matrix4 ObjectToWorld { get { return Fields.ObjectToWorld; } set { Fields.ObjectToWorld = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.VolumeDraw Build(Call call, string name, long rows = -1)
        {
            Native.VolumeDraw made = Fields;
            made.Volume = call.UseOrNull(Volume, name, "Volume");
            return made;
        }
        internal static Native.VolumeDraw* BuildAll(Call call, string name, IList<VolumeDraw> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.VolumeDraw* all = (Native.VolumeDraw*)call.Memory((long)list.Count * sizeof(Native.VolumeDraw));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Files of a stack. Required: either paths and path_count, or pattern.</summary>
    public sealed unsafe partial class StackDesc
    {
        internal Native.StackDesc Fields = Native.StackDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static StackDesc Default { get { return new StackDesc(); } }

        /// <summary>[path_count] files, slice 0 first; of a single file all pages are slices</summary>
        public IList<string> Paths;
        /// <summary>
        /// A path with one place for a number, instead of `paths`: %d, %5d (padded by spaces to five characters) or %05d
        /// (by zeros); %% is a percent sign. Slice k is the file of the number first + k.
        /// </summary>
        public string Pattern;
        /// <summary>number of slice 0 of `pattern`; default 0</summary>
        public uint First { get { return Fields.First; } set { Fields.First = value; } }
        /// <summary>number of the last slice, first..first + 65535; default 0</summary>
        public uint Last { get { return Fields.Last; } set { Fields.Last = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.StackDesc Build(Call call, string name, long rows = -1)
        {
            Native.StackDesc made = Fields;
            made.Paths = call.Texts(Paths, name, "Paths");
            made.PathCount = checked((uint)(Paths == null ? 0 : Paths.Count));
            made.Pattern = call.Text(Pattern);
            return made;
        }
        internal static Native.StackDesc* BuildAll(Call call, string name, IList<StackDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.StackDesc* all = (Native.StackDesc*)call.Memory((long)list.Count * sizeof(Native.StackDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }

    /// <summary>Grid and box of an OpenVDB load.</summary>
    public sealed unsafe partial class VdbDesc
    {
        internal Native.VdbDesc Fields = Native.VdbDesc.Default;

        /// <summary>The defaults of the library.</summary>
        public static VdbDesc Default { get { return new VdbDesc(); } }

        /// <summary>default none</summary>
        public VdbFlags Flags { get { return Fields.Flags; } set { Fields.Flags = value; } }
        /// <summary>name, at most 255 bytes; default NULL = the first grid of float or double</summary>
        public string Grid;
        /// <summary>first voxel of the box, in index space, -2^30..2^30; read with VdbFlags.Box</summary>
        public Int3 BoxMin { get { return Fields.BoxMin; } set { Fields.BoxMin = value; } }
        /// <summary>last voxel of the box, at least box_min on each axis; read with VdbFlags.Box</summary>
        public Int3 BoxMax { get { return Fields.BoxMax; } set { Fields.BoxMax = value; } }

        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>
        internal Native.VdbDesc Build(Call call, string name, long rows = -1)
        {
            Native.VdbDesc made = Fields;
            made.Grid = call.Text(Grid);
            return made;
        }
        internal static Native.VdbDesc* BuildAll(Call call, string name, IList<VdbDesc> list)
        {
            if (list == null || list.Count == 0) return null;
            Native.VdbDesc* all = (Native.VdbDesc*)call.Memory((long)list.Count * sizeof(Native.VdbDesc));
            for (int i = 0; i < list.Count; ++i)
            {
                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));
                all[i] = list[i].Build(call, Call.Element(name, i));
            }
            return all;
        }
    }
}
