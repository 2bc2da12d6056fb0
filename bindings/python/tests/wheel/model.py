# SPDX-License-Identifier: MIT
"""model.py PICTURE: draws a binary glTF file with two textures, PNG and JPEG, which the worker of the wheel decodes. Checks
pixels of both, and the texts about files that the wheel does not read."""
import base64
import json
import pathlib
import struct
import sys
import tempfile
import zlib

import numpy as np
import shd
import shd.io

# 8 x 8 pixels of sRGB (43, 160, 79)
JPEG = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVtVkVGZIhlbXd7gYKBTmCN"
    "l4x9lnN+gXz/2wBDARUXFx4aHjshITt8U0ZTfHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHz/wAAR"
    "CAAIAAgDAREAAhEBAxEB/8QAFAABAAAAAAAAAAAAAAAAAAAAA//EABQQAQAAAAAAAAAAAAAAAAAAAAD/xAAVAQEBAAAAAAAAAAAAAAAAAAAE"
    "Bf/EABQRAQAAAAAAAAAAAAAAAAAAAAD/2gAMAwEAAhEDEQA/ACHS3//Z")


def png(rgb):
    """8 x 8 pixels of one colour."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = (b"\0" + bytes(rgb) * 8) * 8
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 8, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def glb(pictures):
    """Unit squares side by side in the plane z = 0, each with the light of one of the pictures [(type, bytes)]."""
    position = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    uv = np.float32([[0, 1], [1, 1], [1, 0], [0, 0]])
    index = np.uint16([0, 1, 2, 0, 2, 3])
    views, data = [], b""
    for part in (position.tobytes(), uv.tobytes(), index.tobytes(), *(p for _, p in pictures)):
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
        data += part + b"\0" * (-len(part) % 4)
    count = range(len(pictures))
    document = {
        "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_materials_unlit"],
        "buffers": [{"byteLength": len(data)}], "bufferViews": views,
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "images": [{"bufferView": 3 + i, "mimeType": pictures[i][0]} for i in count],
        "textures": [{"source": i} for i in count],
        "materials": [{"extensions": {"KHR_materials_unlit": {}},
                       "pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in count],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": i}]}
                   for i in count],
        "nodes": [{"mesh": i, "translation": [i, 0, 0]} for i in count],
        "scenes": [{"nodes": list(count)}], "scene": 0}
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") + text
            + struct.pack("<I4s", len(data), b"BIN\0") + data)


def refused(call, *words):
    """Checks that a call fails with a text that has these words."""
    try:
        call()
    except (shd.Error, ImportError) as problem:
        assert all(word in str(problem) for word in words), problem
        return
    raise AssertionError(f"not refused: {words}")


with tempfile.TemporaryDirectory() as name:
    folder, context = pathlib.Path(name), shd.Context()
    (folder / "model.glb").write_bytes(glb([("image/png", png((200, 30, 60))), ("image/jpeg", JPEG)]))
    with shd.Renderer(96, 48) as renderer:
        renderer.add(str(folder / "model.glb"))
        renderer.look_at(eye=(1, 0.5, 2), target=(1, 0.5, 0))
        color, depth = renderer.render(alpha=True)
    assert abs(color[24, 36, :3].astype(int) - [200, 30, 60]).max() <= 1, color[24, 36]
    assert abs(color[24, 60, :3].astype(int) - [43, 160, 79]).max() <= 1, color[24, 60]
    assert abs(depth[24, 36] - 2) < 1e-4, depth[24, 36]
    shd.io.save(color, str(folder / "saved.png"), srgb=True)
    saved = shd.io.load(context, str(folder / "saved.png"))
    assert saved.color_space == "sRGB" and (saved.pixels == color).all()
    light = np.full((4, 9, 4), 0.25, np.float32)
    shd.io.save(light, str(folder / "light.hdr"))
    assert (shd.io.load(context, str(folder / "light.hdr")).pixels[:, :, :3] == 0.25).all()
    (folder / "model.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    assert len(shd.Scene(context, str(folder / "model.obj")).draws) == 1
    (folder / "model.dae").write_text('<?xml version="1.0"?><COLLADA version="1.4.1"></COLLADA>')
    refused(lambda: shd.Scene(context, str(folder / "model.dae")), "glTF 2.0, OBJ, PLY or STL")
    refused(lambda: shd.io.save(light, str(folder / "light.exr")), "writes .png and .hdr")
    refused(lambda: shd.io.load(context, b"GIF89a\1\0\1\0\0\0\0", formats="gif"), "reads PNG, JPEG and Radiance HDR")
    refused(lambda: shd.Color(context), "Install the wheel shd-color")
    shd.save_png(sys.argv[1], color[:, :, :3])
