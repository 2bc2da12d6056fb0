// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>Shades the rows of `fragments` into `radiance`. Runs on any worker, concurrently.</summary>
    public delegate void FragmentProgram(Fragments fragments, Radiance radiance);

    /// <summary>Changes the rows of `vertices` in `outputs`. Runs on any worker, concurrently.</summary>
    public delegate void VertexProgram(Vertices vertices, VertexOutputs outputs);

    /// <summary>Computes a coefficient of a material: r, g, b, a of each row. Runs on any worker.</summary>
    public delegate void SlotProcedure(Fragments fragments, SlotChannels channels);

    /// <summary>Receives a finished tile. Runs on any worker, concurrently.</summary>
    public delegate void TileProgram(Tile tile);

    /// <summary>Sets blocked[i] to 1 if ray i meets a surface, else to 0. Runs on any worker.</summary>
    public delegate void TraceProgram(Rays rays, Span<uint> blocked);

    /// <summary>
    /// Writes the texels of tiles, in the format of the texture. Runs on any thread, concurrently for different tiles.
    /// What it throws, the call that needed the tiles throws.
    /// </summary>
    public delegate void TileLoader(TextureTiles tiles);

    /// <summary>
    /// The bytes of a file that a model names, or null if there is no such file. Runs on the thread of the load. The load
    /// throws what it throws.
    /// </summary>
    public delegate byte[] FileFinder(string name);

    /// <summary>A FileFinder and the load that runs it.</summary>
    internal sealed class FindCall
    {
        internal readonly Call Call;
        internal readonly FileFinder Find;

        internal FindCall(Call call, FileFinder find)
        {
            Call = call;
            Find = find;
        }
    }

    /// <summary>The source of the tiles of a texture.</summary>
    public sealed class TileSource
    {
        public TileCache Cache;
        public TileLoader Load;
        internal int PixelSize;

        public TileSource() { }
        public TileSource(TileCache cache, TileLoader load)
        {
            Cache = cache;
            Load = load;
        }
    }

    /// <summary>The programs of a material of Model.Program.</summary>
    public sealed class MaterialProgram
    {
        public FragmentProgram Fragment;
        public VertexProgram Vertex;
    }

    /// <summary>Memory of a context. Its methods run on any thread, and must not call the library.</summary>
    public abstract class Allocator
    {
        /// <summary>`size` bytes aligned to `alignment`; IntPtr.Zero if there are none.</summary>
        public abstract IntPtr Allocate(long size, long alignment);
        public abstract void Free(IntPtr memory, long size, long alignment);
    }

    /// <summary>Threads of a context.</summary>
    public abstract class Executor
    {
        /// <summary>Values of `worker` are below this number, 1..1024.</summary>
        public abstract int WorkerCount { get; }

        /// <summary>Calls task.Run(i, worker) once for each i in [0, count), and returns when all are done.</summary>
        public abstract void ParallelFor(long count, ParallelTask task);
    }

    /// <summary>The tasks of one ParallelFor.</summary>
    public readonly unsafe struct ParallelTask
    {
        private readonly Native.TaskFn task;
        private readonly IntPtr data;

        internal ParallelTask(Native.TaskFn task, void* data)
        {
            this.task = task;
            this.data = (IntPtr)data;
        }

        public void Run(long index, int worker)
        {
            task((UIntPtr)checked((ulong)index), (UIntPtr)checked((uint)worker), (void*)data);
        }
    }

    /// <summary>The channels r, g, b, a that a procedure of a slot writes.</summary>
    public readonly unsafe ref struct SlotChannels
    {
        private readonly float** channels;
        private readonly int count;

        internal SlotChannels(float** from, int rows)
        {
            channels = from;
            count = rows;
        }

        /// <summary>A column; empty for channels that the slot does not use.</summary>
        public Span<float> this[int channel]
        {
            get { return Inline.Write<float>(channels[Inline.Check(channel, 4)], count); }
        }
    }

    /// <summary>Finished pixels of a frame.</summary>
    public readonly unsafe ref struct Tile
    {
        private readonly Native.PresentTile* raw;

        internal Tile(Native.PresentTile* from) { raw = from; }

        public int Worker { get { return (int)raw->Worker; } }
        /// <summary>Pixels of the framebuffer.</summary>
        public Region Area { get { return raw->Area; } }

        /// <summary>Row `y` of the tile, of channel r, g, b or a.</summary>
        public ReadOnlySpan<float> Row(int channel, int y)
        {
            byte* first = (byte*)raw->Channel[Inline.Check(channel, 4)];
            return Inline.Read<float>(first == null ? null : first + Inline.Check(y, raw->Area.Height) * raw->RowStride,
                                      (int)raw->Area.Width);
        }
    }

    /// <summary>Tiles to write. Their memory ends with the call of the TileLoader.</summary>
    public readonly unsafe ref struct TextureTiles
    {
        private readonly Native.Tile* raw;
        private readonly int pixelSize;
        public readonly int Count;

        internal TextureTiles(Native.Tile* from, int count, int size)
        {
            raw = from;
            Count = count;
            pixelSize = size;
        }

        public TextureTile this[int index]
        {
            get { return new TextureTile(raw + Inline.Check(index, Count), pixelSize); }
        }
    }

    /// <summary>A rectangle of a level of a texture.</summary>
    public readonly unsafe ref struct TextureTile
    {
        private readonly Native.Tile* raw;
        private readonly int pixelSize;

        internal TextureTile(Native.Tile* from, int size)
        {
            raw = from;
            pixelSize = size;
        }

        public int Layer { get { return (int)raw->Layer; } }
        /// <summary>0 = the base level.</summary>
        public int Level { get { return (int)raw->Level; } }
        /// <summary>Texels of the level to write.</summary>
        public Region Area { get { return raw->Area; } }

        /// <summary>The bytes of row `y` of the tile, to be written.</summary>
        public Span<byte> Row(int y)
        {
            return new Span<byte>((byte*)raw->Texels + Inline.Check(y, raw->Area.Height) * raw->RowStride,
                                  (int)raw->Area.Width * pixelSize);
        }

        /// <summary>Row `y` as channels or pixels of another type.</summary>
        public Span<T> Row<T>(int y) where T : struct { return MemoryMarshal.Cast<byte, T>(Row(y)); }
    }
}
