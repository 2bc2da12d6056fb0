// SPDX-License-Identifier: MIT
using System;
using System.Numerics;
using System.Text;

namespace Shd
{
    /// <summary>Bounds of arrays inside structs, and spans over columns of the library.</summary>
    internal static unsafe class Inline
    {
        internal static int Check(int index, long length)
        {
            if (index < 0 || index >= length)
                throw new ArgumentOutOfRangeException("index", index + " is not in [0, " + length + ")");
            return index;
        }

        internal static ReadOnlySpan<T> Read<T>(void* column, int count) where T : struct
        {
            return column == null ? default(ReadOnlySpan<T>) : new ReadOnlySpan<T>(column, count);
        }

        internal static Span<T> Write<T>(void* column, int count) where T : struct
        {
            return column == null ? default(Span<T>) : new Span<T>(column, count);
        }
    }

    public partial struct Float2
    {
        public static implicit operator Float2(Vector2 from) { return new Float2(from.X, from.Y); }
        public static implicit operator Vector2(Float2 from) { return new Vector2(from.X, from.Y); }
    }

    public partial struct Float3
    {
        public static implicit operator Float3(Vector3 from) { return new Float3(from.X, from.Y, from.Z); }
        public static implicit operator Vector3(Float3 from) { return new Vector3(from.X, from.Y, from.Z); }
    }

    public partial struct Float4
    {
        public static implicit operator Float4(Vector4 from) { return new Float4(from.X, from.Y, from.Z, from.W); }
        public static implicit operator Vector4(Float4 from) { return new Vector4(from.X, from.Y, from.Z, from.W); }
    }

    /// <summary>
    /// 4 x 4 matrix, column-major, for column vectors. Matrix4x4 of System.Numerics is row-major for row vectors, so
    /// both have the same numbers in memory.
    /// </summary>
    public unsafe partial struct Matrix4
    {
        public static Matrix4 Identity { get { return Matrix4x4.Identity; } }

        public static implicit operator Matrix4(Matrix4x4 from) { return *(Matrix4*)&from; }
        public static implicit operator Matrix4x4(Matrix4 from) { return *(Matrix4x4*)&from; }
    }

    public partial struct Matrix3
    {
        public static Matrix3 Identity
        {
            get
            {
                Matrix3 made = new Matrix3();
                made[0] = made[4] = made[8] = 1;
                return made;
            }
        }
    }

    public unsafe partial struct Bytes64
    {
        /// <summary>The text that the bytes have, up to the first zero.</summary>
        public override string ToString()
        {
            int length = 0;
            while (length < Length && this[length] != 0) ++length;
            fixed (byte* first = &e0) return length == 0 ? "" : Encoding.UTF8.GetString(first, length);
        }
    }
}
