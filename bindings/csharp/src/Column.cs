// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>
    /// A column: equally spaced elements of an array, of memory, or at an address. Arrays and Memory convert to packed
    /// columns. The memory is pinned during the call that uses the column, and is neither copied nor kept.
    /// </summary>
    public readonly struct Column<T> where T : struct
    {
        private readonly Array array;
        private readonly Memory<T> memory;
        private readonly IntPtr address;
        private readonly long offset;
        private readonly bool isReadOnly;

        /// <summary>Number of elements.</summary>
        public readonly long Count;
        /// <summary>Bytes between elements; 0 = packed.</summary>
        internal readonly long Stride;

        internal Column(Array array, long offset, long stride, long count)
            : this(array, default(Memory<T>), IntPtr.Zero, offset, stride, count, false) { }

        internal Column(Memory<T> memory, bool isReadOnly)
            : this(null, memory, IntPtr.Zero, 0, 0, memory.Length, isReadOnly) { }

        internal Column(IntPtr address, long stride, long count)
            : this(null, default(Memory<T>), address, 0, stride, count, false) { }

        private Column(Array array, Memory<T> memory, IntPtr address, long offset, long stride, long count,
                       bool isReadOnly)
        {
            this.array = array;
            this.memory = memory;
            this.address = address;
            this.offset = offset;
            this.isReadOnly = isReadOnly;
            Stride = stride;
            Count = count;
        }

        public static implicit operator Column<T>(T[] from)
        {
            return from == null ? default(Column<T>) : new Column<T>(from, 0, 0, from.Length);
        }

        public static implicit operator Column<T>(Memory<T> from) { return new Column<T>(from, false); }

        /// <summary>A column that the library may only read.</summary>
        public static implicit operator Column<T>(ReadOnlyMemory<T> from)
        {
            return new Column<T>(MemoryMarshal.AsMemory(from), true);
        }

        internal bool IsAbsent { get { return array == null && memory.IsEmpty && address == IntPtr.Zero; } }

        /// <summary>The address of the first element; null for an absent column.</summary>
        internal unsafe void* Pin(Call call, string name, string field, bool isWritten, ref long rows)
        {
            if (IsAbsent) return null;
            Call.CheckRows(Count, name, field, ref rows);
            if (isWritten && isReadOnly)
                throw new ArgumentException(Call.Join(name, field) + ": the memory is read-only", field);
            if (array != null) return array.Length == 0 ? null : (byte*)call.Pin(array) + offset;
            return address != IntPtr.Zero ? (void*)address : call.Pin(memory.Pin());
        }
    }

    /// <summary>Columns that are not packed arrays.</summary>
    public static class Column
    {
        private static void CheckRange(long start, long step, long count, long length)
        {
            if (start < 0) throw new ArgumentOutOfRangeException("start", start + " is negative");
            if (step < 1) throw new ArgumentOutOfRangeException("step", step + " is not positive");
            if (count < 0 || (count > 0 && (start >= length || (length - 1 - start) / step < count - 1)))
                throw new ArgumentOutOfRangeException("count", count + " elements from " + start + " in steps of " +
                                                      step + " do not lie in an array of " + length);
        }

        /// <summary>Elements start, start + step, ... of an array.</summary>
        public static Column<T> Of<T>(T[] array, int start, int step, int count) where T : struct
        {
            if (array == null) throw new ArgumentNullException("array");
            CheckRange(start, step, count, array.Length);
            int size = Marshal.SizeOf(typeof(T));
            return new Column<T>(array, (long)start * size, (long)step * size, count);
        }

        /// <summary>Column `index` of an array [rows][columns].</summary>
        public static Column<T> Of<T>(T[,] array, int index) where T : struct
        {
            if (array == null) throw new ArgumentNullException("array");
            int size = Marshal.SizeOf(typeof(T)), width = array.GetLength(1);
            CheckRange(index, 1, 1, width);
            return new Column<T>(array, (long)index * size, (long)width * size, array.GetLength(0));
        }

        /// <summary>One field of records: Column.OfField&lt;float, Vertex&gt;(vertices, "X").</summary>
        public static Column<T> OfField<T, TRecord>(TRecord[] records, string field)
            where T : struct where TRecord : struct
        {
            if (records == null) throw new ArgumentNullException("records");
            var info = typeof(TRecord).GetField(field, System.Reflection.BindingFlags.Instance |
                                                System.Reflection.BindingFlags.Public |
                                                System.Reflection.BindingFlags.NonPublic);
            if (info == null)
                throw new ArgumentException(typeof(TRecord).Name + " has no field " + field, "field");
            if (info.FieldType != typeof(T))
                throw new ArgumentException("field " + field + " is " + info.FieldType.Name + ", not " +
                                            typeof(T).Name, "field");
            return new Column<T>(records, (long)Marshal.OffsetOf(typeof(TRecord), field),
                                 Marshal.SizeOf(typeof(TRecord)), records.Length);
        }

        /// <summary>Elements at an address, which the caller keeps valid; `stride` in bytes, 0 = packed.</summary>
        public static Column<T> At<T>(IntPtr address, long count, long stride) where T : struct
        {
            if (count < 0) throw new ArgumentOutOfRangeException("count", count + " is negative");
            if (stride < 0) throw new ArgumentOutOfRangeException("stride", stride + " is negative");
            return new Column<T>(address, stride, count);
        }

        /// <summary>
        /// Sets all columns from rows of as many elements: Column.Set(mesh.Position, positions). `rows` is an array
        /// [n][columns] of T, a packed array of T, or an array of structs of that many T, such as Vector3.
        /// </summary>
        public static void Set<T>(Column<T>[] columns, Array rows) where T : struct
        {
            if (columns == null) throw new ArgumentNullException("columns");
            if (rows == null) throw new ArgumentNullException("rows");
            Type element = rows.GetType().GetElementType();
            long size = Marshal.SizeOf(typeof(T)), row = size * columns.Length;
            bool isNumbers = element == typeof(T);
            if (!isNumbers && (element.IsPrimitive || !element.IsValueType || Marshal.SizeOf(element) != row))
                throw new ArgumentException("rows: elements are " + element.Name + ", not " + typeof(T).Name +
                                            " or structs of " + columns.Length + " of them", "rows");
            if (rows.Rank == 2 && isNumbers && rows.GetLength(1) != columns.Length)
                throw new ArgumentException("rows: " + rows.GetLength(1) + " columns, not " + columns.Length, "rows");
            if (isNumbers && rows.Length % columns.Length != 0)
                throw new ArgumentException("rows: " + rows.Length + " elements are not rows of " + columns.Length,
                                            "rows");
            long count = isNumbers ? rows.Length / columns.Length : rows.Length;
            for (int i = 0; i < columns.Length; ++i) columns[i] = new Column<T>(rows, i * size, row, count);
        }
    }
}
