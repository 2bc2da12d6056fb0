// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace Shd
{
    // Fields of descs that the generator leaves to this file: callbacks and untyped arrays.

    public sealed unsafe partial class ContextDesc
    {
        /// <summary>Memory of the context and its objects; null = malloc and free.</summary>
        public Allocator Allocator;
        /// <summary>
        /// Threads; null = the built-in executor of the library, or with Mono a ThreadExecutor of WorkerCount threads.
        /// </summary>
        public Executor Executor;
        /// <summary>Receives messages on any thread, and must not call the library; null = none.</summary>
        public Action<LogLevel, string> Log;

        partial void More(Call call, string name, ref Native.ContextDesc made)
        {
            Executor executor = Executor;
            int cores = System.Environment.ProcessorCount;
            if (executor == null && ThreadExecutor.IsMono && WorkerCount != 1 && WorkerCount <= 1024)
                executor = new ThreadExecutor((int)Math.Min(WorkerCount, cores));
            if (Allocator == null && executor == null && Log == null) return;
            ContextDesc kept = new ContextDesc { Allocator = Allocator, Executor = executor, Log = Log };
            void* root = call.Callback(kept).UserData;
            if (Allocator != null)
            {
                made.Allocator.Allocate = ContextThunks.Allocate;
                made.Allocator.Free = ContextThunks.Free;
                made.Allocator.UserData = root;
            }
            if (executor != null)
            {
                made.Executor.ParallelFor = ContextThunks.ParallelFor;
                made.Executor.UserData = root;
                made.Executor.WorkerCount = executor.WorkerCount;
            }
            if (Log == null) return;
            made.Log.Write = ContextThunks.Write;
            made.Log.UserData = root;
        }
    }

    public sealed unsafe partial class MaterialDesc
    {
        /// <summary>Programs of Model.Program, kept with the material.</summary>
        public MaterialProgram Program;

        partial void More(Call call, string name, ref Native.MaterialDesc made)
        {
            if (Program == null) return;
            MaterialProgram kept = new MaterialProgram { Fragment = Program.Fragment, Vertex = Program.Vertex };
            made.Program.UserData = call.Callback(kept).UserData;
            if (kept.Fragment != null) made.Program.Fragment = Thunks.Fragment;
            if (kept.Vertex != null) made.Program.Vertex = Thunks.Vertex;
        }
    }

    public sealed unsafe partial class Slot
    {
        /// <summary>The source of SlotSource.Procedure, kept with the material.</summary>
        public SlotProcedure Procedure;

        partial void More(Call call, string name, ref Native.Slot made)
        {
            if (Procedure == null) return;
            made.Procedure = Thunks.Slot;
            made.UserData = call.Callback(Procedure).UserData;
        }

        /// <summary>A slot that takes its value from a texture; a null sampler has the defaults.</summary>
        public static Slot FromTexture(SlotTarget target, Texture texture, Sampler sampler = null)
        {
            return new Slot { Target = target, Source = SlotSource.Texture, Texture = texture, Sampler = sampler };
        }

        /// <summary>A slot that takes its value from a column of the mesh.</summary>
        public static Slot FromVertex(SlotTarget target, int attribute)
        {
            return new Slot { Target = target, Source = SlotSource.Vertex, Attribute = checked((uint)attribute) };
        }

        /// <summary>A slot with a function that computes its value.</summary>
        public static Slot FromProcedure(SlotTarget target, SlotProcedure procedure)
        {
            return new Slot { Target = target, Source = SlotSource.Procedure, Procedure = procedure };
        }

        /// <summary>A slot with a solid texture.</summary>
        public static Slot FromSolid(SlotTarget target, SolidDesc solid)
        {
            return new Slot { Target = target, Source = SlotSource.Solid, Solid = solid };
        }
    }

    public sealed unsafe partial class Draw
    {
        public Draw() { }
        public Draw(Mesh mesh, Material material = null)
        {
            Mesh = mesh;
            Material = material;
        }

        /// <summary>An array of numbers or structs that programs of the draw see as an address.</summary>
        public Array Uniforms;

        partial void More(Call call, string name, ref Native.Draw made) { made.Uniforms = call.Pin(Uniforms); }
    }

    public sealed unsafe partial class RenderDesc
    {
        /// <summary>Receives the finished tiles.</summary>
        public TileProgram Present;
        /// <summary>
        /// Receives the finished fraction, never concurrently. A result other than Result.Ok, such as
        /// Result.ErrorCancelled, ends the frame, whose ShdException has this result.
        /// </summary>
        public Func<float, Result> Progress;

        partial void More(Call call, string name, ref Native.RenderDesc made)
        {
            if (Present != null)
            {
                made.Present.Tile = Thunks.Tile;
                made.Present.UserData = call.Callback(Present).UserData;
            }
            if (Progress == null) return;
            made.Progress.Report = Thunks.Progress;
            made.Progress.UserData = call.Callback(Progress).UserData;
        }
    }

    public sealed unsafe partial class OcclusionDesc
    {
        /// <summary>Traces the rays; null = the library's own tree, or Embree.</summary>
        public TraceProgram Trace;
        /// <summary>A tree of Embree that traces the rays in place of Trace.</summary>
        public Embree Embree;

        partial void More(Call call, string name, ref Native.OcclusionDesc made)
        {
            if (Embree != null)
            {
                Native.Tracer tracer;
                call.Check(Native.LibShdEmbree.EmbreeGetTracer(call.Use(Embree, Call.Join(name, "Embree")), &tracer));
                made.Tracer = tracer;
            }
            if (Trace == null) return;
            made.Tracer.Trace = Thunks.Trace;
            made.Tracer.UserData = call.Callback(Trace).UserData;
        }
    }

    public sealed unsafe partial class SceneDesc
    {
        /// <summary>
        /// Answers the names of the model's files, in place of its folder; null = the folder, or no file for a model in
        /// memory.
        /// </summary>
        public FileFinder Find;

        partial void More(Call call, string name, ref Native.SceneDesc made)
        {
            if (Find == null) return;
            made.Find = Thunks.Find;
            made.UserData = call.Callback(new FindCall(call, Find)).UserData;
        }
    }

    public sealed unsafe partial class SaveDesc
    {
        /// <summary>The display and view of a colour config that pixels are saved for; null = as Color says.</summary>
        public ColorView Display;

        partial void More(Call call, string name, ref Native.SaveDesc made)
        {
            if (Display == null) return;
            made.Display.Apply = Thunks.Display;
            made.Display.UserData = call.Callback(Display.Build(call, Call.Join(name, "Display"))).UserData;
        }
    }
}
