// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.CompilerServices;
using Shd;
using Plane = Shd.Plane;

/// <summary>Objects beside those of a plain frame, and the components, which may be missing.</summary>
public static class Components
{
    private static Image White(int width, int height)
    {
        float[] pixels = new float[4 * width * height];
        for (int i = 0; i < pixels.Length; ++i) pixels[i] = 1;
        return new Image(Format.Rgba32f, width, height, pixels);
    }

    [Test]
    public static void Environments()
    {
        using (Context context = new Context())
        using (Shd.Environment environment = new Shd.Environment(context, new EnvironmentDesc {
            Projection = Projection.LatLong, Image = White(8, 4) }))
        {
            EnvironmentLookups lookups = new EnvironmentLookups();
            Column.Set(lookups.Direction, new float[,] { { 0, 1, 0 }, { 1, 0, 0 } });
            EnvironmentValues values = new EnvironmentValues();
            float[] red = new float[2];
            values.Channel[0] = red;
            environment.SampleIrradiance(lookups, values);
            Check.IsTrue(Math.Abs(red[0] - red[1]) < 0.05f * red[0] && red[0] > 0.5f,
                         "irradiance: " + red[0] + " " + red[1]);
            Check.IsTrue(Math.Abs(environment.Info.Mean[1] - 1) < 0.01f, "Mean");
            Check.Equal(0L, values.NonfiniteCount, "NonfiniteCount");
            Column.Set(lookups.Direction, new float[,] { { 0, float.NaN, 0 }, { 1, 0, 0 } });
            environment.SampleIrradiance(lookups, values);
            Check.Equal(1L, values.NonfiniteCount, "NonfiniteCount");
            values.Channel[1] = new float[3];
            Check.Throws<ArgumentException>(() => environment.SampleIrradiance(lookups, values),
                                            "output.Channel: 3 elements, not 2");
            using (Framebuffer framebuffer = new Framebuffer(context, 8, 8))
            {
                context.Render(new RenderDesc { Framebuffer = framebuffer, Environment = environment,
                                                Background = Background.Environment, Camera = Camera.Default });
                Check.IsTrue(Math.Abs(framebuffer.ReadPlane(Plane.G)[4, 4] - 1) < 0.01f, "background");
            }
        }
    }

    [Test]
    public static void Shadows()
    {
        using (Context context = new Context())
        using (Mesh mesh = Mesh.FromShape(context, ShapeDesc.Default))
        using (Light sun = new Light(context, new LightDesc { Kind = LightKind.Directional,
                                                              Direction = new Float3(0, -1, 0) }))
        using (Shadow shadow = new Shadow(context))
        {
            shadow.Render(context, new ShadowRenderDesc { Light = sun, Draws = new[] { new Draw(mesh) },
                BoundsMin = new Float3(-3, -3, -3), BoundsMax = new Float3(3, 3, 3) });
            ShadowLookups lookups = new ShadowLookups();
            Column.Set(lookups.Position, new float[,] { { 0, -2, 0 }, { 2.5f, -2, 0 } });
            float[] visibility = new float[2];
            ShadowValues values = new ShadowValues { Visibility = visibility };
            shadow.Sample(lookups, values);
            Check.Equal("0 1 0", visibility[0] + " " + visibility[1] + " " + values.NonfiniteCount, "visibility");
            Column.Set(lookups.Position, new float[,] { { 0, -2, 0 }, { float.PositiveInfinity, -2, 0 } });
            shadow.Sample(lookups, values);
            Check.Equal(1L, values.NonfiniteCount, "NonfiniteCount");
            values.Visibility = new float[3];
            Check.Throws<ArgumentException>(() => shadow.Sample(lookups, values),
                                            "output.Visibility: 3 elements, not 2");
        }
    }

    [Test]
    public static void Volumes()
    {
        byte[] texels = new byte[8];
        for (int i = 0; i < 8; ++i) texels[i] = 255;
        Camera camera = Camera.Default;
        camera.Target = new Float3(0.5f, 0.5f, 0.5f); // the middle of the box
        VolumeDesc desc = new VolumeDesc { Density = new float[] { 0.1f, 1 } };
        using (Context context = new Context())
        using (Texture texture = new Texture(context, new TextureDesc(Format.R8, 2, 2, texels) { Depth = 2 }))
        using (Framebuffer framebuffer = new Framebuffer(context, 8, 8))
        {
            desc.Texture = texture;
            desc.Extinction = new float[3];
            Check.Throws<ArgumentException>(() => new Volume(context, desc), "desc.Extinction: 3 elements, not 2");
            desc.Extinction = new float[] { 0, 20 };
            using (Volume volume = new Volume(context, desc))
            {
                texture.Dispose(); // the volume keeps it
                context.Render(new RenderDesc { Framebuffer = framebuffer, Camera = camera,
                                                Volumes = new[] { new VolumeDraw { Volume = volume } } });
                Check.IsTrue(framebuffer.ReadPlane(Plane.A)[4, 4] > 0.5f, "alpha");
            }
        }
    }

    /// <summary>Cones that meet a plane at right angles.</summary>
    private static RayCones Cones(params float[] widths)
    {
        RayCones cones = new RayCones { Width = widths };
        Column.Set(cones.Dpdu, new float[,] { { 1, 0, 0 }, { 1, 0, 0 } });
        Column.Set(cones.Dpdv, new float[,] { { 0, 1, 0 }, { 0, 1, 0 } });
        Column.Set(cones.Direction, new float[,] { { 0, 0, -1 }, { 0, 0, -1 } });
        return cones;
    }

    [Test]
    public static void Batches()
    {
        using (Context context = new Context())
        {
            SolidPoints points = new SolidPoints();
            Column.Set(points.Position, new float[,] { { 0.5f, 0.5f, 0.5f }, { 1.5f, 0.5f, 0.5f } });
            SolidDesc checker = SolidDesc.Default;
            checker.Kind = Solid.Checker;
            float[] value = new float[2];
            context.EvaluateSolid(checker, points, new SolidValues { Value = value });
            Check.IsTrue(value[0] != value[1], "checker: " + value[0] + " " + value[1]);
            PolygonDesc polygon = new PolygonDesc();
            Column.Set(polygon.Vertex, new float[,] { { 0, 0 }, { 1, 0 }, { 0, 1 } });
            PolygonPoints places = new PolygonPoints();
            Column.Set(places.Position, new float[,] { { 0.25f, 0.25f } });
            float[] a = new float[1], b = new float[1], c = new float[1];
            context.EvaluatePolygon(polygon, places, new PolygonWeights { Weight = new Column<float>[] { a, b, c } });
            Check.Equal("0.5 0.25 0.25", a[0] + " " + b[0] + " " + c[0], "weights");
            PolyhedronDesc cage = new PolyhedronDesc { Indices = new uint[] { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 } };
            Column.Set(cage.Position, new float[,] { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
            PolyhedronPoints inside = new PolyhedronPoints();
            Column.Set(inside.Position, new float[,] { { 0.25f, 0.25f, 0.25f } });
            float[] d = new float[1];
            using (Polyhedron polyhedron = new Polyhedron(context, cage))
                polyhedron.Evaluate(inside, new PolyhedronWeights { Weight = new Column<float>[] { a, b, c, d } });
            Check.IsTrue(Math.Abs(a[0] - 0.25f) + Math.Abs(d[0] - 0.25f) < 1e-5f, "cage: " + a[0] + " " + d[0]);
            Directions directions = new Directions { Projection = Projection.LatLong };
            Column.Set(directions.Direction, new float[,] { { 0, 1, 0 } });
            float[] v = { -1 };
            context.Project(directions, new ProjectedPoints { V = v });
            Check.Equal(0.0f, v[0], "v of the zenith");
            float[] dudx = new float[2], dvdx = new float[2];
            RayCones cones = Cones(0.5f, float.NaN);
            Derivatives derivatives = new Derivatives { Dudx = dudx, Dvdx = dvdx };
            context.DerivativesFromCones(cones, derivatives);
            Check.IsTrue(Math.Abs(dudx[0] * dudx[0] + dvdx[0] * dvdx[0] - 0.25f) < 1e-5f, "dudx: " + dudx[0]);
            Check.Equal(1L, derivatives.NonfiniteCount, "NonfiniteCount");
            derivatives.Dudx = new float[3];
            Check.Throws<ArgumentException>(() => context.DerivativesFromCones(cones, derivatives),
                                            "output.Dudx: 3 elements, not 2");
        }
    }

    [Test]
    public static void Occlusion()
    {
        using (Context context = new Context())
        using (Mesh mesh = Make.Square(context))
        {
            OcclusionPoints points = new OcclusionPoints();
            Column.Set(points.Position, new float[,] { { 0, 0, 0.4f }, { 0, 0, 0.6f } });
            Column.Set(points.Normal, new float[,] { { 0, 0, 1 }, { 0, 0, 1 } });
            float[] own = new float[2], traced = new float[2];
            OcclusionValues values = new OcclusionValues { Visibility = own };
            context.ComputeOcclusion(new OcclusionDesc { Draws = new[] { new Draw(mesh) } }, points, values);
            Check.IsTrue(own[0] != own[1], "occlusion: " + own[0] + " " + own[1]);
            TraceProgram trace = (rays, blocked) =>
            {
                for (int i = 0; i < rays.Count; ++i) blocked[i] = rays.Oz[i] < 0.5f ? 1u : 0;
            };
            context.ComputeOcclusion(new OcclusionDesc { Trace = trace }, points,
                                     new OcclusionValues { Visibility = traced });
            Check.IsTrue(traced[0] != traced[1], "occlusion: " + traced[0] + " " + traced[1]);
            Check.Throws<NotSupportedException>(() => context.ComputeOcclusion(new OcclusionDesc {
                Trace = (rays, blocked) => { throw new NotSupportedException("from the tracer"); } }, points, values));
            values.Visibility = new float[3];
            Check.Throws<ArgumentException>(() => context.ComputeOcclusion(new OcclusionDesc { Trace = trace }, points,
                values), "output.Visibility: 3 elements, not 2");
            values.Visibility = own;
            Column.Set(points.Position, new float[,] { { 0, 0, 0.4f }, { 0, float.NaN, 0.6f } });
            context.ComputeOcclusion(new OcclusionDesc { Trace = trace }, points, values);
            Check.Equal(1L, values.NonfiniteCount, "NonfiniteCount");
        }
    }

    [Test]
    public static void Embree()
    {
        using (Context context = new Context())
        using (Mesh mesh = Make.Square(context))
        using (Shd.Embree tree = MakeTree(context, mesh))
        {
            OcclusionPoints points = new OcclusionPoints();
            Column.Set(points.Position, new float[,] { { 0, 0, 0.4f }, { 0, 0, 0.6f } });
            Column.Set(points.Normal, new float[,] { { 0, 0, 1 }, { 0, 0, 1 } });
            float[] traced = new float[2];
            context.ComputeOcclusion(new OcclusionDesc { Embree = tree }, points,
                                     new OcclusionValues { Visibility = traced });
            Check.IsTrue(traced[0] != traced[1], "occlusion: " + traced[0] + " " + traced[1]);
        }
    }

    // A method of its own: Mono loads a component when it compiles a method that calls it.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Shd.Embree MakeTree(Context context, Mesh mesh) { return new Shd.Embree(context, new Draw(mesh)); }

    [Test]
    public static void FilesAndColours()
    {
        string path = Path.GetTempFileName(), picture = path + ".png";
        try
        {
            using (Context context = new Context())
            using (Color color = new Color(context))
            using (Framebuffer framebuffer = new Framebuffer(context, 4, 3))
            {
                context.Render(new RenderDesc { Framebuffer = framebuffer, ClearColor = new Float4(1, 0.25f, 0, 1) });
                byte[] shown = new byte[4 * 4 * 3];
                color.ApplyDisplay(framebuffer, new Image(Format.Rgba8, 4, 3, shown));
                Check.IsTrue(color.Displays.Count > 0 && color.Views(color.Displays[0]).Count > 0, "displays");
                Files.Save(framebuffer, picture, new SaveDesc { Display = new ColorView { Color = color } });
                LoadDesc plain = new LoadDesc { Flags = LoadFlags.InProcess };
                using (Bitmap bitmap = new Bitmap(context, picture, plain))
                {
                    Check.Equal(FileFormatFlags.Png, bitmap.Info.FileFormat, "FileFormat");
                    byte[] read = (byte[])bitmap.Read().Pixels;
                    for (int i = 0; i < 3; ++i)
                        Check.IsTrue(Math.Abs(read[i] - shown[i]) <= 1, "pixel: " + read[i] + ", not " + shown[i]);
                }
                using (Texture texture = Files.LoadTexture(context, File.ReadAllBytes(picture), plain))
                    Check.Equal(4u, texture.Info.Width, "Width");
                ShdException missing = Check.Throws<ShdException>(
                    () => Files.LoadTexture(context, "/nonexistent/picture.png"), "/nonexistent/picture.png");
                Check.Equal(Result.ErrorNotFound, missing.Result, "Result");
                Check.Throws<ShdException>(() => color.ApplyDisplay(framebuffer, new Image(Format.Rgba8, 4, 3, shown),
                                                                    "no display"), "no display");
            }
        }
        finally
        {
            File.Delete(path);
            File.Delete(picture);
        }
    }

    [Test]
    public static void Scenes()
    {
        string path = Path.GetTempFileName() + ".obj";
        File.WriteAllText(path, "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
        try
        {
            using (Context context = new Context())
            using (Scene scene = new Scene(context, path))
            using (Mesh mesh = scene.Mesh(0))
            using (Framebuffer framebuffer = new Framebuffer(context, 16, 16))
            {
                Check.Equal(1L, mesh.Info.TriangleCount, "triangles");
                Camera camera = Camera.Default;
                camera.Eye = new Float3(0, 0, 3);
                scene.Render(context, new RenderDesc { Framebuffer = framebuffer, Camera = camera });
                Check.IsTrue(framebuffer.ReadPlane(Plane.Depth)[8, 8] < 1, "depth");
                Check.Throws<ArgumentOutOfRangeException>(() => scene.Mesh(1), "1 is not in [0, 1)");
                scene.Dispose();
                Check.Throws<ObjectDisposedException>(() => { SceneInfo info = scene.Info; });
                Check.Equal(3L, mesh.Info.VertexCount, "the mesh keeps its vertices");
            }
        }
        finally { File.Delete(path); }
    }
}
