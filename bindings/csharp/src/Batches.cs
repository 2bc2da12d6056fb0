// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace Shd
{
    // Batches and images that need no object but the context.
    public sealed unsafe partial class Context
    {
        /// <summary>Evaluates a solid texture, whose desc began as SolidDesc.Default, at points.</summary>
        public void EvaluateSolid(SolidDesc desc, SolidPoints points, SolidValues output)
        {
            if (points == null) throw new ArgumentNullException("points");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.SolidPoints built = points.Build(call, "points");
                Native.SolidValues values = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.SolidEvaluate(call.Use(this, "context"), &desc, &built, &values));
                output.Take(ref values);
            }
        }

        /// <summary>Barycentric coordinates of points in a polygon.</summary>
        public void EvaluatePolygon(PolygonDesc desc, PolygonPoints points, PolygonWeights output)
        {
            if (desc == null) throw new ArgumentNullException("desc");
            if (points == null) throw new ArgumentNullException("points");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.PolygonDesc polygon = desc.Build(call, "desc");
                Native.PolygonPoints built = points.Build(call, "points");
                Native.PolygonWeights weights = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.PolygonEvaluate(call.Use(this, "context"), &polygon, &built, &weights));
                output.Take(ref weights);
            }
        }

        /// <summary>Points of an image that show directions.</summary>
        public void Project(Directions directions, ProjectedPoints output)
        {
            if (directions == null) throw new ArgumentNullException("directions");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.Directions built = directions.Build(call, "directions");
                Native.ProjectedPoints points = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.ProjectionProject(call.Use(this, "context"), &built, &points));
                output.Take(ref points);
            }
        }

        /// <summary>Directions that points of an image show.</summary>
        public void Unproject(ImagePoints points, PointDirections output)
        {
            if (points == null) throw new ArgumentNullException("points");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.ImagePoints built = points.Build(call, "points");
                Native.PointDirections directions = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.ProjectionUnproject(call.Use(this, "context"), &built, &directions));
                output.Take(ref directions);
            }
        }

        /// <summary>Converts images of directions between projections.</summary>
        public void Convert(DirectionImages from, DirectionImages to)
        {
            if (from == null) throw new ArgumentNullException("from");
            if (to == null) throw new ArgumentNullException("to");
            using (Call call = new Call())
            {
                Native.DirectionImages source = from.Build(call, "from"), target = to.Build(call, "to");
                call.Check(Native.LibShd.ProjectionConvert(call.Use(this, "context"), &source, &target));
            }
        }

        /// <summary>Ambient occlusion of points.</summary>
        public void ComputeOcclusion(OcclusionDesc desc, OcclusionPoints points, OcclusionValues output)
        {
            if (desc == null) throw new ArgumentNullException("desc");
            if (points == null) throw new ArgumentNullException("points");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "context");
                Native.OcclusionDesc built = desc.Build(call, "desc");
                Native.OcclusionPoints rows = points.Build(call, "points");
                Native.OcclusionValues values = output.Build(call, "output", rows.Count);
                call.Check(Native.LibShd.OcclusionCompute(self, &built, &rows, &values));
                output.Take(ref values);
            }
        }

        /// <summary>Ambient occlusion of the vertices of a draw.</summary>
        public void ComputeOcclusion(OcclusionDesc desc, Draw draw, Column<float> output)
        {
            if (desc == null) throw new ArgumentNullException("desc");
            if (draw == null) throw new ArgumentNullException("draw");
            if (draw.Mesh == null) throw new ArgumentNullException("draw.Mesh");
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "context");
                Native.OcclusionDesc built = desc.Build(call, "desc");
                Native.Draw one = draw.Build(call, "draw");
                long count = draw.Mesh.Info.VertexCount;
                Native.F32Out column = call.F32Out(output, "", "output", ref count);
                call.Check(Native.LibShd.OcclusionComputeVertices(self, &built, &one, &column));
            }
        }

        /// <summary>Ambient occlusion of the texels of an atlas, [Height][Width].</summary>
        public BakeStats BakeOcclusion(OcclusionDesc desc, OcclusionAtlas atlas, Column<float> output)
        {
            if (desc == null) throw new ArgumentNullException("desc");
            if (atlas == null) throw new ArgumentNullException("atlas");
            using (Call call = new Call())
            {
                IntPtr self = call.Use(this, "context");
                long count = (long)atlas.Width * atlas.Height;
                Native.OcclusionDesc built = desc.Build(call, "desc");
                Native.OcclusionAtlas texels = atlas.Build(call, "atlas", count);
                Native.F32Out column = call.F32Out(output, "", "output", ref count);
                BakeStats stats = BakeStats.Default;
                texels.Stats = &stats;
                call.Check(Native.LibShd.OcclusionBake(self, &built, &texels, &column));
                return stats;
            }
        }

        /// <summary>Builds mip levels of an image into the pixels of `levels`.</summary>
        public void BuildMips(Image image, MipDesc desc, IList<Image> levels)
        {
            if (image == null) throw new ArgumentNullException("image");
            if (levels == null) throw new ArgumentNullException("levels");
            using (Call call = new Call())
            {
                Native.Image pixels = image.Build(call, "image");
                Native.Image* all = Image.BuildAll(call, "levels", levels);
                call.Check(Native.LibShd.MipBuild(call.Use(this, "context"), &pixels, &desc,
                                                  (UIntPtr)(uint)levels.Count, all));
            }
        }

        /// <summary>Derivatives of texture coordinates from ray differentials.</summary>
        public void DerivativesFromDifferentials(RayDifferentials rays, Derivatives output)
        {
            if (rays == null) throw new ArgumentNullException("rays");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.RayDifferentials built = rays.Build(call, "rays");
                Native.Derivatives made = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.DerivativesFromDifferentials(call.Use(this, "context"), &built, &made));
                output.Take(ref made);
            }
        }

        /// <summary>Derivatives of texture coordinates from ray cones.</summary>
        public void DerivativesFromCones(RayCones cones, Derivatives output)
        {
            if (cones == null) throw new ArgumentNullException("cones");
            if (output == null) throw new ArgumentNullException("output");
            using (Call call = new Call())
            {
                Native.RayCones built = cones.Build(call, "cones");
                Native.Derivatives made = output.Build(call, "output", built.Count);
                call.Check(Native.LibShd.DerivativesFromCones(call.Use(this, "context"), &built, &made));
                output.Take(ref made);
            }
        }
    }
}
