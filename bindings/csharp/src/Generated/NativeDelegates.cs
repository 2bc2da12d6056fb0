// SPDX-License-Identifier: MIT
// Written by generate.py; do not edit.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Shd.Native
{
    /// <summary>Returns `size` &gt; 0 bytes aligned to `alignment` (a power of two, at least 8), or NULL.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void* AllocatorAllocateFn(void* userData, UIntPtr size, UIntPtr alignment);

    /// <summary>
    /// Frees memory that `allocate` returned. `size` and `alignment` are those of its allocation; `memory` is never
    /// NULL.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void AllocatorFreeFn(void* userData, void* memory, UIntPtr size, UIntPtr alignment);

    /// <summary>One task of a parallel_for: `index` in [0, count), `worker` in [0, worker_count).</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void TaskFn(void* taskData, uint index, uint worker);

    /// <summary>
    /// Runs task(task_data, i, worker) once for every i in [0, count), in any order and on any threads, and returns when
    /// all are done. Tasks that run concurrently must have different values of `worker`. A result other than Result.Ok
    /// makes the call of shd fail with Result.ErrorCallback. Runs on the thread that called shd; must not throw or
    /// longjmp; may call shd.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate Result ExecutorParallelForFn(void* userData, uint count, IntPtr task, void* taskData);

    /// <summary>Takes one line without newline. Any thread, calls may be concurrent; must not throw, longjmp or call shd.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void LogWriteFn(void* userData, LogLevel level, byte* message);

    /// <summary>called with `body` by the thread that releases the last reference; must not throw</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void ObjectCreateDestroyFn(void* body);

    /// <summary>
    /// A fragment program: reads in-&gt;count rows and writes the same number of rows.
    ///
    /// The framebuffer keeps all values, even NaN and infinity; RenderStats.nonfinite_fragments counts these.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FragmentFn(Fragments* @in, Radiance* @out, void* userData);

    /// <summary>
    /// Fills every pixel of `out`, a packed RGBA32F image of the framebuffer's size, with display colour: encoded,
    /// straight alpha, 0..1. Runs on the thread of the call that takes the Display; must not throw or longjmp. A
    /// result other than Result.Ok, with its text from shd_report_error(), becomes the result of the call. NULL = none.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate Result DisplayApplyFn(void* userData, IntPtr framebuffer, Image* @out);

    /// <summary>
    /// A tracer of the host: sets blocked[i] to a value other than 0 if ray i meets an occluder. All start as 0.
    ///
    /// Runs on any worker of the executor, and calls may be concurrent. It must not throw, longjmp or call shd.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void TraceFn(Rays* rays, uint* blocked, void* userData);

    /// <summary>
    /// Called once for each tile of the framebuffer in no particular order, also for tiles that the frame does not
    /// change. In a frame of several passes (RenderDesc.pass_triangles) this is in the last pass, and with
    /// supersampling after the last block. A result other than Result.Ok, with its text from shd_report_error(), becomes
    /// the result of the render; tiles that follow are skipped. NULL = none.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate Result PresentTileFn(void* userData, PresentTile* tile);

    /// <summary>
    /// Called after each piece of the frame, with the finished fraction of the frame, (0, 1]. Runs on any worker; calls
    /// are never concurrent. Must not throw, longjmp or call shd. A result other than 0 cancels: the render returns
    /// Result.ErrorCancelled and the framebuffer holds a part of the frame.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int ProgressReportFn(void* userData, float fraction);

    /// <summary>
    /// Answers the names of the model's files, in place of its folder: for archives and memory. The bytes are borrowed
    /// until the load returns. Result.ErrorNotFound = no such file; any other result than Result.Ok ends the load. Runs on
    /// the thread of the load; must not throw or longjmp. NULL = the folder of the model, or no file for a model in
    /// memory.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate Result SceneDescFindFn(void* userData, byte* name, void** outBytes, UIntPtr* outSize);

    /// <summary>
    /// A function that gives the values of a slot: writes in-&gt;count values to each column.
    /// @param out  packed columns, initially 1: three for colours, four for the diffuse slot, the tint and for normals, one
    ///             for scalars; the others are NULL
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void SlotFn(Fragments* @in, float** @out, void* userData);

    /// <summary>
    /// Writes the texels of tiles of one level of a layer, face or slice, in the format of the texture. Tiles of a
    /// compressed texture are written as rows of blocks; the last blocks of a row or column may reach beyond the level. The
    /// cache keeps them decoded. It is called without a lock, from any thread that looks texels up, and by several threads
    /// at once, sometimes for the same tile, whose memory is then another. It may call shd: see the rules above.
    /// @return  Result.Ok, or the reason of a failure. Then no tile of the call is kept, the lookup returns Result.ErrorCallback,
    ///          or Result.ErrorCancelled for Result.ErrorCancelled, and the next lookup calls again
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate Result LoadTilesFn(void* userData, Tile* tiles, UIntPtr count);

    /// <summary>
    /// called once, after the last `load`, when the texture is destroyed; may be
    /// NULL. It is not called if shd_texture_create() fails
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void TileSourceReleaseFn(void* userData);

    /// <summary>
    /// A vertex program: reads and writes in-&gt;count rows.
    ///
    /// Each row must depend on its own inputs alone. Otherwise the frame depends on the grouping of vertices.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void VertexFn(Vertices* @in, VertexOutputs* @out, void* userData);
}
