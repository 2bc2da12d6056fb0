// SPDX-License-Identifier: MIT
using System;

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

        public void Run(long index, int worker) { task((void*)data, checked((uint)index), (uint)worker); }
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
        public int X { get { return (int)raw->X; } }
        public int Y { get { return (int)raw->Y; } }
        public int Width { get { return (int)raw->Width; } }
        public int Height { get { return (int)raw->Height; } }

        /// <summary>Row `y` of the tile, of channel r, g, b or a.</summary>
        public ReadOnlySpan<float> Row(int channel, int y)
        {
            byte* first = (byte*)raw->Channel[Inline.Check(channel, 4)];
            return Inline.Read<float>(first == null ? null : first + Inline.Check(y, raw->Height) * raw->RowStride,
                                      Width);
        }
    }
}
