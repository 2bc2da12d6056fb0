// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Shd
{
    /// <summary>
    /// The functions that the library calls. They exist once and are never collected; user_data finds the root with the
    /// function of the user. No exception leaves them: the root stores it for the call that ran the function.
    /// </summary>
    internal static unsafe class Thunks
    {
        private static readonly Native.FragmentFn fragment = OnFragment;
        private static readonly Native.VertexFn vertex = OnVertex;
        private static readonly Native.SlotFn slot = OnSlot;
        private static readonly Native.TraceFn trace = OnTrace;
        private static readonly Native.PresentTileFn tile = OnTile;
        private static readonly Native.ProgressReportFn progress = OnProgress;
        private static readonly Native.DisplayApplyFn display = OnDisplay;
        private static readonly Native.LoadTilesFn load = OnLoad;
        private static readonly Native.SceneDescFindFn find = OnFind;

        internal static readonly IntPtr Fragment = Marshal.GetFunctionPointerForDelegate(fragment);
        internal static readonly IntPtr Vertex = Marshal.GetFunctionPointerForDelegate(vertex);
        internal static readonly IntPtr Slot = Marshal.GetFunctionPointerForDelegate(slot);
        internal static readonly IntPtr Trace = Marshal.GetFunctionPointerForDelegate(trace);
        internal static readonly IntPtr Tile = Marshal.GetFunctionPointerForDelegate(tile);
        internal static readonly IntPtr Progress = Marshal.GetFunctionPointerForDelegate(progress);
        internal static readonly IntPtr Display = Marshal.GetFunctionPointerForDelegate(display);
        internal static readonly IntPtr Load = Marshal.GetFunctionPointerForDelegate(load);
        internal static readonly IntPtr Find = Marshal.GetFunctionPointerForDelegate(find);

        private static void OnFragment(Native.Fragments* input, Native.Radiance* output, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            if (root.HasFailed) return; // the rest of the frame is not worth its time
            try
            {
                Fragments fragments = new Fragments(input);
                ((MaterialProgram)root.Target).Fragment(fragments, new Radiance(output, fragments.Count));
            }
            catch (Exception problem) { root.Fail(problem); }
        }

        private static void OnVertex(Native.Vertices* input, Native.VertexOutputs* output, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            if (root.HasFailed) return;
            try
            {
                Vertices vertices = new Vertices(input);
                ((MaterialProgram)root.Target).Vertex(vertices, new VertexOutputs(output, vertices.Count));
            }
            catch (Exception problem) { root.Fail(problem); }
        }

        private static void OnSlot(Native.Fragments* input, float** output, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            if (root.HasFailed) return;
            try
            {
                Fragments fragments = new Fragments(input);
                ((SlotProcedure)root.Target)(fragments, new SlotChannels(output, fragments.Count));
            }
            catch (Exception problem) { root.Fail(problem); }
        }

        private static void OnTrace(Native.Rays* input, uint* blocked, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            if (root.HasFailed) return;
            try
            {
                Rays rays = new Rays(input);
                ((TraceProgram)root.Target)(rays, new Span<uint>(blocked, rays.Count));
            }
            catch (Exception problem) { root.Fail(problem); }
        }

        private static Result OnTile(Native.PresentTile* input, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            try { ((TileProgram)root.Target)(new Tile(input)); }
            catch (Exception problem) { root.Fail(problem); }
            return root.HasFailed ? Result.ErrorCallback : Result.Ok;
        }

        private static Result OnProgress(float fraction, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            try { return ((Func<float, Result>)root.Target)(fraction); }
            catch (Exception problem) { root.Fail(problem); }
            return Result.ErrorCallback;
        }

        private static Result OnDisplay(IntPtr framebuffer, Native.Image* output, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            try { return ((DisplayCall)root.Target).Apply(framebuffer, output); }
            catch (Exception problem) { root.Fail(problem); }
            return Result.ErrorCallback;
        }

        private static Result OnLoad(Native.Tile* tiles, UIntPtr count, void* userData)
        {
            TileSource source = (TileSource)CallbackRoot.Of(userData).Target;
            try
            {
                source.Load(new TextureTiles(tiles, (int)count, source.PixelSize));
                return Result.Ok;
            }
            catch (Exception problem) { source.Cache.Failure.Fail(problem); }
            return Result.ErrorCallback;
        }

        private static Result OnFind(byte* name, void** bytes, UIntPtr* size, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            try
            {
                FindCall load = (FindCall)root.Target;
                byte[] found = load.Find(Utf8.Read(name));
                if (found == null) return Result.ErrorNotFound;
                *bytes = found.Length > 0 ? load.Call.Pin(found) : load.Call.Memory(1); // until the load ends
                *size = (UIntPtr)(uint)found.Length;
                return Result.Ok;
            }
            catch (Exception problem) { root.Fail(problem); }
            return Result.ErrorCallback;
        }
    }

    /// <summary>The functions that a context calls until the release of its last object.</summary>
    internal static unsafe class ContextThunks
    {
        private static readonly Native.AllocatorAllocateFn allocate = OnAllocate;
        private static readonly Native.AllocatorFreeFn free = OnFree;
        private static readonly Native.ExecutorParallelForFn parallelFor = OnParallelFor;
        private static readonly Native.LogWriteFn write = OnWrite;

        internal static readonly IntPtr Allocate = Marshal.GetFunctionPointerForDelegate(allocate);
        internal static readonly IntPtr Free = Marshal.GetFunctionPointerForDelegate(free);
        internal static readonly IntPtr ParallelFor = Marshal.GetFunctionPointerForDelegate(parallelFor);
        internal static readonly IntPtr Write = Marshal.GetFunctionPointerForDelegate(write);

        private static void* OnAllocate(UIntPtr size, UIntPtr alignment, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            try { return (void*)((ContextDesc)root.Target).Allocator.Allocate((long)size, (long)alignment); }
            catch (Exception problem) { root.Fail(problem); }
            return null;
        }

        private static void OnFree(void* memory, UIntPtr size, UIntPtr alignment, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            try { ((ContextDesc)root.Target).Allocator.Free((IntPtr)memory, (long)size, (long)alignment); }
            catch (Exception problem) { root.Fail(problem); }
        }

        private static Result OnParallelFor(UIntPtr count, IntPtr task, void* data, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            try
            {
                Native.TaskFn function = Marshal.GetDelegateForFunctionPointer<Native.TaskFn>(task);
                ((ContextDesc)root.Target).Executor.ParallelFor((long)count, new ParallelTask(function, data));
                return Result.Ok;
            }
            catch (Exception problem) { root.Fail(problem); }
            return Result.ErrorCallback;
        }

        private static void OnWrite(LogLevel level, byte* message, void* userData)
        {
            CallbackRoot root = CallbackRoot.Of(userData);
            try { ((ContextDesc)root.Target).Log(level, Utf8.Read(message)); }
            catch (Exception problem) { root.Fail(problem); }
        }
    }
}
