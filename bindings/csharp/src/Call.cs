// SPDX-License-Identifier: MIT
using System;
using System.Buffers;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace Shd
{
    /// <summary>
    /// What one call of the library needs until it ends: references of objects, pinned arrays, memory for structs and
    /// texts, and callbacks.
    /// </summary>
    internal sealed unsafe class Call : IDisposable
    {
        private readonly List<ObjectHandle> used = new List<ObjectHandle>();
        private List<GCHandle> pins;
        private List<MemoryHandle> spans;
        private List<IntPtr> blocks;
        private List<ShdObject> written;

        /// <summary>Callbacks of the objects in use, and those of the call itself.</summary>
        internal readonly List<CallbackRoot> Roots = new List<CallbackRoot>();

        internal static string Element(string name, int index) { return name + "[" + index + "]"; }

        internal static string Join(string name, string field)
        {
            return string.IsNullOrEmpty(name) ? field : name + "." + field;
        }

        /// <summary>The handle of an object, which lives until the end of the call.</summary>
        internal IntPtr Use(ShdObject item, string name)
        {
            if (item == null) throw new ArgumentNullException(name);
            bool isAdded = false;
            try { item.Handle.DangerousAddRef(ref isAdded); }
            catch (ObjectDisposedException) { }
            if (!isAdded)
                throw new ObjectDisposedException(item.GetType().Name, name + ": the " + item.GetType().Name +
                                                  " was disposed");
            used.Add(item.Handle);
            foreach (CallbackRoot root in item.Handle.Roots)
                if (!Roots.Contains(root)) { root.Retain(); Roots.Add(root); }
            return item.Handle.DangerousGetHandle();
        }

        internal IntPtr UseOrNull(ShdObject item, string name, string field)
        {
            return item == null ? IntPtr.Zero : Use(item, Join(name, field));
        }

        /// <summary>The handle of an object that the call needs for itself.</summary>
        internal IntPtr UseAlone(ShdObject item, string name)
        {
            IntPtr handle = Use(item, name);
            if (!item.TryBeginWrite())
                throw new InvalidOperationException(name + ": another call writes to the " + item.GetType().Name);
            if (written == null) written = new List<ShdObject>();
            written.Add(item);
            return handle;
        }

        /// <summary>Handles of a list. Lists of one number of elements share `count`, which starts as -1.</summary>
        internal IntPtr* UseAll<T>(IList<T> list, string name, string field, ref long count) where T : ShdObject
        {
            if (list == null) return null;
            CheckRows(list.Count, name, field, ref count);
            if (list.Count == 0) return null;
            IntPtr* all = (IntPtr*)Memory((long)list.Count * sizeof(IntPtr));
            for (int i = 0; i < list.Count; ++i) all[i] = UseOrNull(list[i], name, Element(field, i));
            return all;
        }

        internal static void CheckRows(long got, string name, string field, ref long rows)
        {
            if (rows < 0) rows = got;
            if (got != rows)
                throw new ArgumentException(Join(name, field) + ": " + got + " elements, not " + rows, field);
        }

        /// <summary>A callback that lives as long as the call, and the objects that adopt its roots.</summary>
        internal CallbackRoot Callback(object target)
        {
            CallbackRoot root = new CallbackRoot(target);
            Roots.Add(root);
            return root;
        }

        /// <summary>The address of an array that does not move until the end of the call.</summary>
        internal void* Pin(Array array)
        {
            if (array == null || array.Length == 0) return null;
            GCHandle pin = GCHandle.Alloc(array, GCHandleType.Pinned);
            if (pins == null) pins = new List<GCHandle>();
            pins.Add(pin);
            return (void*)pin.AddrOfPinnedObject();
        }

        internal void* Pin(MemoryHandle memory)
        {
            if (spans == null) spans = new List<MemoryHandle>();
            spans.Add(memory);
            return memory.Pointer;
        }

        /// <summary>Memory of zeros until the end of the call.</summary>
        internal void* Memory(long size)
        {
            IntPtr block = Marshal.AllocHGlobal((IntPtr)size);
            if (blocks == null) blocks = new List<IntPtr>();
            blocks.Add(block);
            for (long i = 0; i < size; ++i) ((byte*)block)[i] = 0;
            return (void*)block;
        }

        internal byte* Text(string text)
        {
            if (text == null) return null;
            byte[] bytes = Encoding.UTF8.GetBytes(text);
            byte* copy = (byte*)Memory(bytes.Length + 1);
            Marshal.Copy(bytes, 0, (IntPtr)copy, bytes.Length);
            return copy;
        }

        internal byte** Texts(IList<string> texts, string name, string field)
        {
            if (texts == null || texts.Count == 0) return null;
            byte** all = (byte**)Memory((long)texts.Count * sizeof(byte*));
            for (int i = 0; i < texts.Count; ++i)
            {
                if (texts[i] == null) throw new ArgumentNullException(Join(name, Element(field, i)));
                all[i] = Text(texts[i]);
            }
            return all;
        }

        internal Native.F32In F32In(Column<float> column, string name, string field, ref long rows)
        {
            Native.F32In made = new Native.F32In();
            made.Data = (float*)column.Pin(this, name, field, false, ref rows);
            made.Stride = column.Stride;
            return made;
        }

        internal Native.F32In* F32Ins(Column<float>[] columns, string name, string field, ref long rows)
        {
            if (columns == null || columns.Length == 0) return null;
            Native.F32In* all = (Native.F32In*)Memory((long)columns.Length * sizeof(Native.F32In));
            for (int i = 0; i < columns.Length; ++i) all[i] = F32In(columns[i], name, Element(field, i), ref rows);
            return all;
        }

        internal Native.F32Out F32Out(Column<float> column, string name, string field, ref long rows)
        {
            Native.F32Out made = new Native.F32Out();
            made.Data = (float*)column.Pin(this, name, field, true, ref rows);
            made.Stride = column.Stride;
            return made;
        }

        internal Native.F32Out* F32Outs(Column<float>[] columns, string name, string field, ref long rows)
        {
            if (columns == null || columns.Length == 0) return null;
            Native.F32Out* all = (Native.F32Out*)Memory((long)columns.Length * sizeof(Native.F32Out));
            for (int i = 0; i < columns.Length; ++i) all[i] = F32Out(columns[i], name, Element(field, i), ref rows);
            return all;
        }

        internal Native.U32In U32In(Column<uint> column, string name, string field, ref long rows)
        {
            Native.U32In made = new Native.U32In();
            made.Data = (uint*)column.Pin(this, name, field, false, ref rows);
            made.Stride = column.Stride;
            return made;
        }

        internal Native.U32Out U32Out(Column<uint> column, string name, string field, ref long rows)
        {
            Native.U32Out made = new Native.U32Out();
            made.Data = (uint*)column.Pin(this, name, field, true, ref rows);
            made.Stride = column.Stride;
            return made;
        }

        internal Native.U16In U16In(Column<ushort> column, string name, string field, ref long rows)
        {
            Native.U16In made = new Native.U16In();
            made.Data = (ushort*)column.Pin(this, name, field, false, ref rows);
            made.Stride = column.Stride;
            return made;
        }

        /// <summary>Throws the exception of a callback, or ShdException unless the call succeeded.</summary>
        internal void Check(Result result)
        {
            string text = result == Result.Ok ? null : ShdException.LastError();
            foreach (CallbackRoot root in Roots) root.Rethrow();
            if (result != Result.Ok) throw new ShdException(result, text);
        }

        public void Dispose()
        {
            if (written != null) foreach (ShdObject item in written) item.EndWrite();
            foreach (ObjectHandle handle in used) handle.DangerousRelease();
            foreach (CallbackRoot root in Roots) root.Release();
            if (pins != null) foreach (GCHandle pin in pins) pin.Free();
            if (spans != null) foreach (MemoryHandle memory in spans) memory.Dispose();
            if (blocks != null) foreach (IntPtr block in blocks) Marshal.FreeHGlobal(block);
        }
    }
}
