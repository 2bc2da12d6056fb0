// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Shd;

/// <summary>Models and textures in memory.</summary>
public static class Models
{
    /// <summary>
    /// A triangle whose buffer is the file a.bin, with an animation to x = 4 in 2 s, and a texture that no file has.
    /// </summary>
    private const string Triangle = @"{'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}],
        'nodes': [{'mesh': 0}], 'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'material': 0}]}],
        'materials': [{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}}}],
        'textures': [{'source': 0}], 'images': [{'uri': 'none.png'}],
        'buffers': [{'uri': 'a.bin', 'byteLength': 68}],
        'bufferViews': [{'buffer': 0, 'byteLength': 36}, {'buffer': 0, 'byteOffset': 36, 'byteLength': 8},
                        {'buffer': 0, 'byteOffset': 44, 'byteLength': 24}],
        'accessors': [
            {'bufferView': 0, 'componentType': 5126, 'count': 3, 'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 1, 0]},
            {'bufferView': 1, 'componentType': 5126, 'count': 2, 'type': 'SCALAR', 'min': [0], 'max': [2]},
            {'bufferView': 2, 'componentType': 5126, 'count': 2, 'type': 'VEC3'}],
        'animations': [{'name': 'Move', 'samplers': [{'input': 1, 'output': 2}],
                        'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'translation'}}]}]}";

    private sealed class Problem : Exception { }

    private static byte[] Buffer()
    {
        float[] numbers = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 4, 0, 0 };
        byte[] bytes = new byte[68];
        System.Buffer.BlockCopy(numbers, 0, bytes, 0, bytes.Length);
        return bytes;
    }

    [Test]
    public static void Memory()
    {
        byte[] model = Encoding.UTF8.GetBytes(Triangle.Replace('\'', '"'));
        FileFinder find = name => name == "a.bin" ? Buffer() : null;
        using (Context context = new Context())
            foreach (SceneFlags flags in new[] { SceneFlags.None, SceneFlags.InProcess })
            {
                SceneDesc desc = new SceneDesc { Flags = flags, Find = find };
                using (Scene scene = new Scene(context, model, null, desc))
                {
                    Check.Equal(1L, scene.Info.TriangleCount, "triangles");
                    List<string> warnings = new List<string>();
                    for (int i = 0; i < scene.Info.WarningCount; ++i) warnings.Add(scene.Warning(i));
                    Check.IsTrue(warnings.Exists(text => text.Contains("none.png")), string.Join("; ", warnings));
                    Check.Equal("Move", scene.Name(ScenePart.Animation, 0), "animation");
                    double first, last;
                    scene.AnimationTimes(0, out first, out last);
                    using (Scene pose = scene.Pose(0, (first + last) / 2))
                        Check.Equal(2.0f, pose.Instance(0).ObjectToWorld[12], "x at 1 s");
                    Check.Throws<ShdException>(() => scene.Pose(1, 0), "animation: 1");
                }
                desc.Find = name => { throw new Problem(); };
                Check.Throws<Problem>(() => new Scene(context, model, null, desc));
                desc.Find = null;
                Check.Throws<ShdException>(() => new Scene(context, model, null, desc), "a.bin");
                using (Scene obj = new Scene(context, Encoding.UTF8.GetBytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                                             "model.obj", desc))
                    Check.Equal(1L, obj.Info.TriangleCount, "triangles of OBJ");
            }
    }

    [Test]
    public static void Containers()
    {
        string path = Path.GetTempFileName();
        byte[] texels = { 10, 20, 30, 40 };
        try
        {
            using (Context context = new Context())
            using (Texture texture = new Texture(context, new TextureDesc(Format.R8, 2, 2, texels)))
            {
                Files.SaveKtx2(texture, path);
                LoadDesc desc = new LoadDesc { Info = TextureFileInfo.Default };
                byte[] read = new byte[4];
                using (Texture loaded = Files.LoadTexture(context, File.ReadAllBytes(path), desc))
                    loaded.ReadLevel(0, 0, new Image(Format.R8, 2, 2, read));
                Check.Equal(TextureFileKind.Ktx2, desc.Info.Value.Kind, "Kind");
                Check.Equal("10 20 30 40", string.Join(" ", read), "texels");
                RawDesc raw = RawDesc.Default;
                raw.Width = raw.Height = 1;
                raw.Depth = 4;
                using (Texture volume = Files.LoadTexture(context, texels, new LoadDesc { Raw = raw }))
                    Check.Equal(4u, volume.Info.Depth, "Depth");
                desc = new LoadDesc { Vdb = new VdbDesc() };
                Check.Throws<ShdException>(() => Files.LoadTexture(context, texels, desc));
            }
        }
        finally { File.Delete(path); }
    }
}
