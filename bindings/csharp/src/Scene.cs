// SPDX-License-Identifier: MIT
using System;

namespace Shd
{
    /// <summary>A model file in memory: meshes, materials, lights and cameras. Needs libshd_scene.</summary>
    public sealed unsafe class Scene : ShdObject
    {
        public Scene(Context context, string path, SceneDesc desc = null) : base(new SceneHandle())
        {
            if (path == null) throw new ArgumentNullException("path");
            using (Call call = new Call())
            {
                Native.SceneDesc built = (desc ?? new SceneDesc()).Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShdScene.SceneLoad(call.Use(context, "context"), call.Text(path), &built, &made));
                Adopt(made, call);
            }
        }

        /// <summary>
        /// A model in memory. desc.Find gives the files that it names. `name` is that of the model, such as "model.obj",
        /// for formats without a mark of their own.
        /// </summary>
        public Scene(Context context, byte[] file, string name = null, SceneDesc desc = null) : base(new SceneHandle())
        {
            if (file == null) throw new ArgumentNullException("file");
            using (Call call = new Call())
            {
                Native.SceneDesc built = (desc ?? new SceneDesc()).Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShdScene.SceneLoadMemory(call.Use(context, "context"), call.Pin(file),
                                                              (UIntPtr)(uint)file.Length, call.Text(name), &built,
                                                              &made));
                Adopt(made, call);
            }
        }

        private Scene() : base(new SceneHandle()) { }

        /// <summary>Keeps the callbacks of the context; a FileFinder was for the load.</summary>
        private void Adopt(IntPtr made, Call call)
        {
            Handle.Adopt(made, call.Roots.FindAll(root => !(root.Target is FindCall)));
        }

        public SceneInfo Info
        {
            get
            {
                using (Call call = new Call())
                {
                    SceneInfo info = SceneInfo.Default;
                    call.Check(Native.LibShdScene.SceneGetInfo(call.Use(this, "scene"), &info));
                    return info;
                }
            }
        }

        /// <summary>A part of the file that was left out or changed.</summary>
        public string Warning(int index)
        {
            Inline.Check(index, Info.WarningCount);
            using (Call call = new Call())
                return Utf8.Read(Native.LibShdScene.SceneGetWarning(call.Use(this, "scene"), (UIntPtr)(uint)index));
        }

        /// <summary>Name of a part in the file.</summary>
        public string Name(ScenePart part, int index)
        {
            using (Call call = new Call())
                return Utf8.Read(Native.LibShdScene.SceneGetName(call.Use(this, "scene"), part,
                                                            (UIntPtr)checked((uint)index)));
        }

        /// <summary>A mesh of the file, as an object of its own.</summary>
        public Mesh Mesh(int index)
        {
            Inline.Check(index, Info.MeshCount);
            using (Call call = new Call())
            {
                IntPtr shared = Native.LibShdScene.SceneGetMesh(call.Use(this, "scene"), (UIntPtr)(uint)index);
                Native.LibShd.MeshRetain(shared);
                Mesh made = new Mesh();
                made.Handle.Adopt(shared, call.Roots);
                return made;
            }
        }

        /// <summary>A material of the file, as an object of its own.</summary>
        public Material Material(int index)
        {
            Inline.Check(index, Info.MaterialCount);
            using (Call call = new Call())
            {
                IntPtr shared = Native.LibShdScene.SceneGetMaterial(call.Use(this, "scene"), (UIntPtr)(uint)index);
                Native.LibShd.MaterialRetain(shared);
                Material made = new Material();
                made.Handle.Adopt(shared, call.Roots);
                return made;
            }
        }

        /// <summary>A texture of the file, as an object of its own.</summary>
        public Texture Texture(int index)
        {
            Inline.Check(index, Info.TextureCount);
            using (Call call = new Call())
            {
                IntPtr shared = Native.LibShdScene.SceneGetTexture(call.Use(this, "scene"), (UIntPtr)(uint)index);
                Native.LibShd.TextureRetain(shared);
                Texture made = new Texture();
                made.Handle.Adopt(shared, call.Roots);
                return made;
            }
        }

        /// <summary>A light of the file, as an object of its own.</summary>
        public Light Light(int index)
        {
            Inline.Check(index, Info.LightCount);
            using (Call call = new Call())
            {
                IntPtr shared = Native.LibShdScene.SceneGetLight(call.Use(this, "scene"), (UIntPtr)(uint)index);
                Native.LibShd.LightRetain(shared);
                Light made = new Light();
                made.Handle.Adopt(shared, call.Roots);
                return made;
            }
        }

        public Camera Camera(int index)
        {
            using (Call call = new Call())
            {
                Camera camera = Shd.Camera.Default;
                call.Check(Native.LibShdScene.SceneGetCamera(call.Use(this, "scene"), (UIntPtr)checked((uint)index),
                                                             &camera));
                return camera;
            }
        }

        public SceneInstance Instance(int index)
        {
            using (Call call = new Call())
            {
                SceneInstance instance = SceneInstance.Default;
                call.Check(Native.LibShdScene.SceneGetInstance(call.Use(this, "scene"), (UIntPtr)checked((uint)index),
                                                               &instance));
                return instance;
            }
        }

        /// <summary>The times of an animation [s]: its first key and its last one.</summary>
        public void AnimationTimes(int animation, out double first, out double last)
        {
            double begin = 0, end = 0;
            using (Call call = new Call())
                call.Check(Native.LibShdScene.SceneGetAnimationTimes(call.Use(this, "scene"),
                                                                     (UIntPtr)checked((uint)animation), &begin, &end));
            first = begin;
            last = end;
        }

        /// <summary>A scene of the file at some second of an animation.</summary>
        public Scene Pose(int animation, double seconds)
        {
            using (Call call = new Call())
            {
                IntPtr made;
                call.Check(Native.LibShdScene.ScenePose(call.Use(this, "scene"), (UIntPtr)checked((uint)animation),
                                                        seconds, &made));
                Scene pose = new Scene();
                pose.Handle.Adopt(made, call.Roots);
                return pose;
            }
        }

        /// <summary>
        /// Renders the whole scene: its draws and lights replace those of the frame, which has the framebuffer, the
        /// camera and the other settings.
        /// </summary>
        public RenderStats Render(Context context, RenderDesc frame)
        {
            if (frame == null) throw new ArgumentNullException("frame");
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "scene"), where = call.Use(context, "context");
                if (frame.Framebuffer != null) call.UseAlone(frame.Framebuffer, "frame.Framebuffer");
                Native.RenderDesc built = frame.Build(call, "frame");
                call.Check(Native.LibShdScene.SceneFillRender(self, &built));
                RenderStats stats = RenderStats.Default;
                built.Stats = &stats;
                call.Check(Native.LibShd.Render(where, &built));
                return stats;
            }
        }
    }
}
