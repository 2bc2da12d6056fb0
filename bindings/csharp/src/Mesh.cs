// SPDX-License-Identifier: MIT
using System;

namespace Shd
{
    /// <summary>Vertices and triangles, in object space.</summary>
    public sealed unsafe class Mesh : ShdObject
    {
        public Mesh(Context context, MeshDesc desc) : this()
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.MeshDesc built = desc.Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.MeshCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        internal Mesh() : base(new MeshHandle()) { }

        /// <summary>The mesh of a shape, whose desc began as ShapeDesc.Default.</summary>
        public static Mesh FromShape(Context context, ShapeDesc desc, MeshFlags flags = MeshFlags.None)
        {
            using (Call call = new Call())
            {
                IntPtr made;
                call.Check(Native.LibShd.MeshCreateShape(call.Use(context, "context"), &desc, flags, &made));
                Mesh mesh = new Mesh();
                mesh.Handle.Adopt(made, call.Roots);
                return mesh;
            }
        }

        /// <summary>A mesh of smaller triangles, displaced if the desc has a texture.</summary>
        public Mesh Tessellate(Context context, TessellationDesc desc)
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.TessellationDesc built = desc.Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.MeshTessellate(call.Use(context, "context"), call.Use(this, "mesh"), &built,
                                                        &made));
                Mesh mesh = new Mesh();
                mesh.Handle.Adopt(made, call.Roots);
                return mesh;
            }
        }

        public MeshInfo Info
        {
            get
            {
                using (Call call = new Call())
                {
                    MeshInfo info = MeshInfo.Default;
                    call.Check(Native.LibShd.MeshGetInfo(call.Use(this, "mesh"), &info));
                    return info;
                }
            }
        }

        /// <summary>Copies [vertices][3].</summary>
        public float[,] ReadPositions() { return ReadFloats(3, 0); }
        /// <summary>Copies [vertices][3].</summary>
        public float[,] ReadNormals() { return ReadFloats(3, 1); }
        /// <summary>Copies [vertices][4]: tangent and handedness.</summary>
        public float[,] ReadTangents() { return ReadFloats(4, 2); }
        /// <summary>Copies [vertices][2].</summary>
        public float[,] ReadUv() { return ReadFloats(2, 3); }
        /// <summary>Copies [vertices][2] of the second set.</summary>
        public float[,] ReadUv1() { return ReadFloats(2, 4); }

        private float[,] ReadFloats(int width, int which)
        {
            float[,] rows = new float[Info.VertexCount, width];
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "mesh");
                Native.F32Out* columns = stackalloc Native.F32Out[4];
                float* first = (float*)call.Pin(rows);
                for (int i = 0; i < width; ++i)
                {
                    columns[i].Data = first + i;
                    columns[i].Stride = width * sizeof(float);
                }
                call.Check(which == 0 ? Native.LibShd.MeshReadPositions(self, columns)
                           : which == 1 ? Native.LibShd.MeshReadNormals(self, columns)
                           : which == 2 ? Native.LibShd.MeshReadTangents(self, columns)
                           : which == 3 ? Native.LibShd.MeshReadUv(self, columns)
                                        : Native.LibShd.MeshReadUv1(self, columns));
            }
            return rows;
        }

        /// <summary>Copies one of the caller's own columns.</summary>
        public float[] ReadAttribute(int index)
        {
            float[] values = new float[Info.VertexCount];
            using (Call call = new Call())
            {
                long rows = -1;
                Native.F32Out column = call.F32Out(values, "", "values", ref rows);
                call.Check(Native.LibShd.MeshReadAttribute(call.Use(this, "mesh"), checked((uint)index), &column));
            }
            return values;
        }

        /// <summary>Copies three indices for each triangle.</summary>
        public uint[] ReadIndices()
        {
            uint[] indices = new uint[3L * Info.TriangleCount];
            using (Call call = new Call())
            {
                long rows = -1;
                Native.U32Out column = call.U32Out(indices, "", "indices", ref rows);
                call.Check(Native.LibShd.MeshReadIndices(call.Use(this, "mesh"), &column));
            }
            return indices;
        }

        /// <summary>Finds edges, and returns their number. With null in place of `output` it only counts.</summary>
        public long FindEdges(EdgesDesc desc, Edges output, long capacity)
        {
            using (Call call = new Call())
            {
                Native.Edges built = (output ?? new Edges()).Build(call, "output", output == null ? -1 : capacity);
                UIntPtr count;
                call.Check(Native.LibShd.MeshFindEdges(call.Use(this, "mesh"), &desc,
                                                       (UIntPtr)checked((ulong)(output == null ? 0 : capacity)),
                                                       output == null ? null : &built, &count));
                return (long)count;
            }
        }
    }
}
