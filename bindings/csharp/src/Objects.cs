// SPDX-License-Identifier: MIT
using System;

namespace Shd
{
    /// <summary>A filter with its settings, for any texture.</summary>
    public sealed unsafe class Sampler : ShdObject
    {
        /// <summary>A sampler of a desc that began as SamplerDesc.Default; null = all defaults.</summary>
        public Sampler(Context context, SamplerDesc? desc = null) : base(new SamplerHandle())
        {
            using (Call call = new Call())
            {
                SamplerDesc built = desc ?? SamplerDesc.Default;
                IntPtr made;
                call.Check(Native.LibShd.SamplerCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }
    }

    /// <summary>A source of light in world space.</summary>
    public sealed unsafe class Light : ShdObject
    {
        public Light(Context context, LightDesc desc) : this()
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.LightDesc built = desc.Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.LightCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        internal Light() : base(new LightHandle()) { }
    }

    /// <summary>Reflectance of a surface. It keeps its programs, textures and samplers.</summary>
    public sealed unsafe class Material : ShdObject
    {
        public Material(Context context, MaterialDesc desc) : this()
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.MaterialDesc built = desc.Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.MaterialCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        internal Material() : base(new MaterialHandle()) { }
    }

    /// <summary>Light from all directions.</summary>
    public sealed unsafe class Environment : ShdObject
    {
        public Environment(Context context, EnvironmentDesc desc) : base(new EnvironmentHandle())
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.EnvironmentDesc built = desc.Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.EnvironmentCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        public EnvironmentInfo Info
        {
            get
            {
                using (Call call = new Call())
                {
                    EnvironmentInfo info = EnvironmentInfo.Default;
                    call.Check(Native.LibShd.EnvironmentGetInfo(call.Use(this, "environment"), &info));
                    return info;
                }
            }
        }

        /// <summary>Irradiance around directions.</summary>
        public void SampleIrradiance(EnvironmentLookups lookups, EnvironmentValues output)
        {
            Sample(lookups, output, true);
        }

        /// <summary>Radiance through the lobes of rough materials.</summary>
        public void SampleRadiance(EnvironmentLookups lookups, EnvironmentValues output)
        {
            Sample(lookups, output, false);
        }

        private void Sample(EnvironmentLookups lookups, EnvironmentValues output, bool isIrradiance)
        {
            if (lookups == null) throw new ArgumentNullException("lookups");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "environment");
                Native.EnvironmentLookups built = lookups.Build(call, "lookups");
                Native.EnvironmentValues values = output.Build(call, "output", built.Count);
                call.Check(isIrradiance ? Native.LibShd.EnvironmentSampleIrradiance(self, &built, &values)
                                        : Native.LibShd.EnvironmentSampleRadiance(self, &built, &values));
                output.Take(ref values);
            }
        }
    }

    /// <summary>Depths as seen from a light.</summary>
    public sealed unsafe class Shadow : ShdObject
    {
        public Shadow(Context context, ShadowDesc? desc = null) : base(new ShadowHandle())
        {
            using (Call call = new Call())
            {
                ShadowDesc built = desc ?? ShadowDesc.Default;
                IntPtr made;
                call.Check(Native.LibShd.ShadowCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        /// <summary>Draws the depths. A shadow serves one Render, without concurrent uses.</summary>
        public void Render(Context context, ShadowRenderDesc desc)
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.ShadowRenderDesc built = desc.Build(call, "desc");
                call.Check(Native.LibShd.ShadowRender(call.Use(context, "context"), call.UseAlone(this, "shadow"),
                                                      &built));
            }
        }

        /// <summary>Visibility of the light at positions.</summary>
        public void Sample(ShadowLookups lookups, ShadowValues output)
        {
            if (lookups == null) throw new ArgumentNullException("lookups");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.ShadowLookups built = lookups.Build(call, "lookups");
                Native.ShadowValues values = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.ShadowSample(call.Use(this, "shadow"), &built, &values));
                output.Take(ref values);
            }
        }
    }

    /// <summary>A density field with its transfer function.</summary>
    public sealed unsafe class Volume : ShdObject
    {
        public Volume(Context context, VolumeDesc desc) : base(new VolumeHandle())
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.VolumeDesc built = desc.Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.VolumeCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }
    }

    /// <summary>A closed mesh of triangles as a cage, for coordinates of points.</summary>
    public sealed unsafe class Polyhedron : ShdObject
    {
        public Polyhedron(Context context, PolyhedronDesc desc) : base(new PolyhedronHandle())
        {
            if (desc == null) throw new ArgumentNullException("desc");
            using (Call call = new Call())
            {
                Native.PolyhedronDesc built = desc.Build(call, "desc");
                IntPtr made;
                call.Check(Native.LibShd.PolyhedronCreate(call.Use(context, "context"), &built, &made));
                Handle.Adopt(made, call.Roots);
            }
        }

        /// <summary>The coordinates of points: Weight has a column for each vertex.</summary>
        public void Evaluate(PolyhedronPoints points, PolyhedronWeights output)
        {
            if (points == null) throw new ArgumentNullException("points");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.PolyhedronPoints built = points.Build(call, "points");
                Native.PolyhedronWeights weights = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.PolyhedronEvaluate(call.Use(this, "polyhedron"), &built, &weights));
                output.Take(ref weights);
            }
        }
    }

    /// <summary>Memory of a fixed size for the tiles of textures.</summary>
    public sealed unsafe class TileCache : ShdObject
    {
        /// <summary>Has the exception of a function that loads tiles, until the call that needed them ends.</summary>
        internal readonly CallbackRoot Failure;

        /// <summary>A cache of a desc that began as TileCacheDesc.Default; null = all defaults.</summary>
        public TileCache(Context context, TileCacheDesc? desc = null) : base(new TileCacheHandle())
        {
            using (Call call = new Call())
            {
                TileCacheDesc built = desc ?? TileCacheDesc.Default;
                IntPtr made;
                call.Check(Native.LibShd.TileCacheCreate(call.Use(context, "context"), &built, &made));
                Failure = call.Callback(this);
                Handle.Adopt(made, call.Roots);
            }
        }

        /// <summary>Counters since the creation.</summary>
        public TileCacheStats Stats
        {
            get
            {
                using (Call call = new Call())
                {
                    TileCacheStats stats = TileCacheStats.Default;
                    call.Check(Native.LibShd.TileCacheGetStats(call.Use(this, "cache"), &stats));
                    return stats;
                }
            }
        }

        /// <summary>
        /// Loads up to `maxTiles` tiles that lookups with MissingTiles.Coarser did not find, 0 = all of them, and returns
        /// their number.
        /// </summary>
        public long LoadRequested(long maxTiles = 0)
        {
            using (Call call = new Call())
            {
                UIntPtr loaded;
                call.Check(Native.LibShd.TileCacheLoadRequested(call.Use(this, "cache"),
                                                                (UIntPtr)checked((ulong)maxTiles), &loaded));
                return (long)loaded;
            }
        }
    }

    /// <summary>The triangles of draws in a tree of Embree, which traces rays for OcclusionDesc.</summary>
    public sealed unsafe class Embree : ShdObject
    {
        public Embree(Context context, params Draw[] draws) : base(new EmbreeHandle())
        {
            if (draws == null) throw new ArgumentNullException("draws");
            using (Call call = new Call())
            {
                Native.Draw* all = Draw.BuildAll(call, "draws", draws);
                IntPtr made;
                call.Check(Native.LibShdEmbree.EmbreeCreate(call.Use(context, "context"), all,
                                                            (UIntPtr)(uint)draws.Length,
                                                            &made));
                Handle.Adopt(made, call.Roots);
            }
        }
    }
}
