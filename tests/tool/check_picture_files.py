# SPDX-License-Identifier: MIT
"""shd-render: standard input and output, names of series, JPEG, and what its .exr files say: matrices, distances and
Cryptomatte, which an independent decoder of the specification reads."""
import base64
import json
import math
import os
import resource
import select
import shutil
import signal
import struct
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "support")]
from exr import Exr  # noqa: E402
from png import read_png  # noqa: E402

RENDER, FOLDER = sys.argv[1:3]
SMALL = ("--size", "48x32", "--tessellation", "4", "--no-color")


def run(*args, data=None):
    return subprocess.run([RENDER, *args], input=data, capture_output=True, check=False)


def done(*args, data=None):
    result = run(*args, data=data)
    assert result.returncode == 0, (args, result.stderr)
    return result


def refused(code, text, *args, data=None):
    result = run(*args, data=data)
    assert result.returncode == code and text in result.stderr.decode(), (args, code, text, result)


def read(path):
    with open(path, "rb") as file:
        return file.read()


# Standard input and output, names.

TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def check_streams():
    done(*SMALL, "-o", "plain.png")
    for name in ("-", "png:-"):
        result = done(*SMALL, "-o", name)
        assert result.stdout == read("plain.png") and not result.stderr, result.stderr
    for kind, start in (("jpg", b"\xff\xd8\xff"), ("exr", b"\x76\x2f\x31\x01"), ("tif", b"II*\0"),
                        ("hdr", b"#?RADIANCE")):
        done(*SMALL, "-o", "plain." + kind)
        assert done(*SMALL, "-o", kind + ":-").stdout == read("plain." + kind)
        assert read("plain." + kind).startswith(start), kind
    two = done(*SMALL, "-o", "-", "--orbit", "0,0", "--orbit", "90,0").stdout
    assert two.count(b"\x89PNG\r\n") == 2
    with open("tri.obj", "wb") as file:
        file.write(TRIANGLE)
    done(*SMALL, "tri.obj", "-o", "tri.png")
    assert done(*SMALL, "obj:-", "-o", "-", data=TRIANGLE).stdout == read("tri.png")
    gltf = model(["cube"], ["white"]).encode()
    with open("one.gltf", "wb") as file:
        file.write(gltf)
    done(*SMALL, "one.gltf", "-o", "one.png")
    assert done(*SMALL, "-", "-o", "-", data=gltf).stdout == read("one.png")
    refused(3, "standard input is empty", "-", data=b"")
    refused(3, "standard input: ", "-", data=b"nothing that anybody knows")
    refused(2, "--hash prints to standard output", "--hash", "-o", "-")
    refused(2, "does not end in", "-o", "gif:-")
    full = subprocess.run([RENDER, *SMALL, "-o", "-"], stdout=open("/dev/full", "wb"), stderr=subprocess.PIPE, check=False)
    assert full.returncode == 4 and b"standard output: " in full.stderr, full


def check_closed_pipes():
    """A reader that ends early is an error of the output, and no scratch file stays, whatever ends the program."""
    os.mkdir("scratch")
    scene = ("--size", "2000x1500", "--tessellation", "4", "--no-color", "-o", "exr:-")  # more than a pipe holds

    def begin():
        return subprocess.Popen([RENDER, *scene], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={**os.environ, "TMPDIR": os.path.abspath("scratch")})

    def first_byte():
        process = begin()
        assert process.stdout.read(1) == b"\x76"
        return process

    process = first_byte()
    process.stdout.close()
    errors = process.stderr.read()
    assert process.wait() == 4 and errors == b"shd-render: standard output: Broken pipe\n", (process.returncode, errors)
    assert os.listdir("scratch") == [], os.listdir("scratch")
    process = first_byte()
    assert os.listdir("scratch") == [], os.listdir("scratch")
    process.kill()
    process.communicate()
    assert os.listdir("scratch") == [], os.listdir("scratch")
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):  # while the picture is saved
        process = begin()
        while not os.listdir("scratch") and not select.select([process.stdout], [], [], 0.001)[0]:
            pass
        process.send_signal(number)
        process.communicate()
        assert process.returncode == -number, process.returncode
        assert os.listdir("scratch") == [], os.listdir("scratch")
    for output in (("--hash",), ("-o", "closed.png"), ("-o", "-")):
        reader, writer = os.pipe()
        os.close(reader)
        result = subprocess.run([RENDER, *SMALL, *output], stdout=writer, stderr=subprocess.PIPE, check=False)
        os.close(writer)
        assert result.returncode == 4, result
        assert result.stderr == b"shd-render: standard output: Broken pipe\n", result


def check_scratch():
    """Files that are too large, and folders that are not there, are errors of the output."""
    os.makedirs("scratch", exist_ok=True)
    for name in ("-", "exr:-", "large.png"):
        result = subprocess.run([RENDER, *SMALL, "-o", name], capture_output=True, check=False,
                                env={**os.environ, "TMPDIR": os.path.abspath("scratch")},
                                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
        assert result.returncode == 4 and not result.stdout, result
        assert result.stderr.count(b"\n") == 1 and b"File too large" in result.stderr, result
        assert os.listdir("scratch") == [] and not os.path.exists("large.png"), name
    result = subprocess.run([RENDER, *SMALL, "-o", "-"], capture_output=True, check=False,
                            env={**os.environ, "TMPDIR": os.path.abspath("absent")})
    assert result.returncode == 4 and not result.stdout, result
    assert b"absent/shd-render-" in result.stderr and b"No such file" in result.stderr, result


def check_names():
    done(*SMALL, "--turntable", "3", "-o", "a.%04d.png")
    assert [os.path.exists(f"a.{i:04}.png") for i in range(5)] == [False, True, True, True, False]
    done(*SMALL, "--orbit", "0,0", "--orbit", "120,10", "-o", "view%d.png")
    done(*SMALL, "--orbit", "120,10", "-o", "single.png")
    assert read("view2.png") == read("single.png") != read("view1.png")
    done(*SMALL, "--orbit", "0,0", "--orbit", "120,10", "-o", "views.png")
    assert read("views-0002.png") == read("single.png")
    done(*SMALL, "-o", "one-%02d.png")
    assert os.path.exists("one-01.png")
    done(*SMALL, "-o", "100%.png")
    assert os.path.exists("100%.png")
    refused(2, "has several places for a number", "-o", "%d-%d.png")
    refused(2, "--turntable and --frames take one view", "--orbit", "0,0", "--orbit", "9,9", "--turntable", "2")
    refused(4, 'there is no folder "absent/"', "-o", "absent/a.%04d.png")


def check_jpeg():
    """JPEG is the PNG over black, up to the loss of JPEG."""
    for name in ("ball.png", "ball.jpg"):
        done("--size", "64x64", "--shape", "sphere", "-o", name, *(["--compression", "100"] if "jpg" in name else []))
    png, pixels = png_pixels("ball.png"), jpeg_pixels("ball.jpg")
    worst = 0
    for (r, g, b, a), shown in zip(png, pixels):
        for code, got in zip((r, g, b), shown):
            worst = max(worst, abs(code * a / 255 - got))
    assert worst <= 12, worst
    small = len(done("--size", "64x64", "-o", "jpg:-", "--compression", "20").stdout)
    large = len(done("--size", "64x64", "-o", "jpg:-", "--compression", "100").stdout)
    assert small < large / 2, (small, large)
    for name, compression in (("a.jpg", "0"), ("a.jpg", "101"), ("a.jpg", "zip"), ("a.exr", "lzw"), ("a.tif", "piz"),
                              ("a.png", "zip"), ("a.exr", "none rle")):
        refused(2, "--compression: save.compression", "-o", name, "--compression", compression)
        assert not os.path.exists(name)
    sizes = {c: len(done(*SMALL, "-o", "exr:-", "--compression", c).stdout) for c in ("none", "zip", "piz", "rle")}
    assert sizes["none"] == max(sizes.values()) and len(set(sizes.values())) == 4, sizes


def jpeg_pixels(path):
    """Pixels of a JPEG, or none without PIL."""
    try:
        from PIL import Image
    except ImportError:
        print("skipped: pixels of a JPEG (Debian: python3-pil)")
        return []
    return list(Image.open(path).convert("RGB").getdata())


def png_pixels(path):
    """Pixels of an RGBA PNG of 8 bits."""
    _, _, channels, rows = read_png(path)
    assert channels == 4, channels
    return [tuple(row[i:i + 4]) for row in rows for i in range(0, len(row), 4)]


# Headers of OpenEXR.

def times(point, matrix):
    """A row vector times a matrix, as Imath multiplies."""
    return [sum(point[k] * matrix[k][c] for k in range(4)) for c in range(4)]


def check_headers():
    done("--size", "64x48", "--shape", "sphere", "--orbit", "30,20,3", "--samples", "1", "--aovs", "position,draw", "-o",
         "ball.exr")
    exr = Exr("ball.exr")
    assert exr.string("Software").startswith("shd-render 0."), exr.string("Software")
    camera, ndc = exr.matrix("worldToCamera"), exr.matrix("worldToNDC")
    # The eye of --orbit 30,20,3 is 3 radii away from the centre of a ball of radius 1, whose box gives sqrt(3).
    az, el, far = math.radians(30), math.radians(20), 3 * math.sqrt(3)
    eye = [far * math.cos(el) * math.sin(az), far * math.sin(el), far * math.cos(el) * math.cos(az), 1]
    for value in times(eye, camera)[:3]:
        assert abs(value) < 2e-5, times(eye, camera)
    assert all(abs(a - b) < 2e-5 for a, b in zip(times([0, 0, 0, 1], camera), [0, 0, far, 1])), "not left-handed"
    assert times([0, 1, 0, 1], camera)[1] > 0.9, "+Y is not up"
    middle = times([0, 0, 0, 1], ndc)
    assert abs(middle[0] / middle[3] - 0.5) < 1e-5 and abs(middle[1] / middle[3] - 0.5) < 1e-5, middle
    depths, offsets, nothing = [], [], set()
    for y in range(exr.height):
        for x in range(exr.width):
            z = exr.channels["Z"][y][x]
            if exr.channels["draw"][y][x] == 0xffffffff:
                nothing.add(z)
                continue
            place = [exr.channels[c][y][x] for c in ("P.x", "P.y", "P.z")] + [1]
            depths.append(abs(times(place, camera)[2] - z))
            projected = times(place, ndc)
            got = projected[0] / projected[3] * exr.width, projected[1] / projected[3] * exr.height
            offsets.append(max(abs(got[0] - x - 0.5), abs(got[1] - y - 0.5)))
    # Corners are rounded to 1/256 pixel before depth is computed, which counts where a surface is seen from its side.
    assert len(depths) > 500 and sorted(depths)[len(depths) * 9 // 10] < 2e-4 and max(depths) < 0.02, max(depths)
    assert max(offsets) < 0.01, max(offsets)
    assert nothing and min(nothing) > far + 1, nothing


# Cryptomatte.

def model(meshes, materials, places=None):
    """A glTF of triangles side by side: names of meshes and of materials; `places` are (mesh, x)."""
    buffer = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    places = places or [(i, 0.9 * i) for i in range(len(meshes))]
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(places)))}],
        "nodes": [{"mesh": mesh, "translation": [x, 0, -0.1 * i]} for i, (mesh, x) in enumerate(places)],
        "materials": [{"name": name, "doubleSided": True} for name in materials],
        "meshes": [{"name": name, "primitives": [{"attributes": {"POSITION": 0}, "material": i % len(materials)}]}
                   for i, name in enumerate(meshes)],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," +
                     base64.b64encode(buffer).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
                       "max": [1, 1, 0]}]})


def murmur(data):
    """MurmurHash3_x86_32 with seed 0, from its description: Appleby, SMHasher."""
    def mix(k):
        k = k * 0xcc9e2d51 % 2**32
        return (k << 15 | k >> 17) % 2**32 * 0x1b873593 % 2**32

    h = 0
    for at in range(0, len(data) - 3, 4):
        h ^= mix(int.from_bytes(data[at:at + 4], "little"))
        h = ((h << 13 | h >> 19) % 2**32 * 5 + 0xe6546b64) % 2**32
    h ^= mix(int.from_bytes(data[len(data) & ~3:], "little")) ^ len(data)
    for shift, factor in ((16, 0x85ebca6b), (13, 0xc2b2ae35)):
        h = (h ^ h >> shift) * factor % 2**32
    return h ^ h >> 16


def bits_of(name):
    h = murmur(name.encode())
    return h ^ 1 << 23 if h >> 23 & 255 in (0, 255) else h


def bits(value):
    return struct.unpack("<I", struct.pack("<f", value))[0]


# Cryptomatte Specification 1.2.0, "Example code and conversions" and "Metadata"; and CryptoHashing in
# nuke/cryptomatte_utilities_tests.py of github.com/Psyop/Cryptomatte.
KNOWN = {"torus": -1.54943624832e+30, "\u0440\u0430\u0432\u043d\u0438\u043d\u0430": -1.31926312124e-25,
         "hello": 6.0705627102400005616e-17, "cube": -4.08461912519e+15, "sphere": 2.79018604383e+15,
         "plane": 3.66557617593e-11, "m\u00e4dchen": 6.2361298211599995797e+25}
MANIFESTS = {"bunny": "13851a76", "default": "42c9679f", "bunny_porcelain_mat": "b24b26d4"}


def decode(exr, name):
    """The manifest, and for each pixel {id: coverage} of a Cryptomatte."""
    key = f"cryptomatte/{murmur(name.encode()):08x}"[:19] + "/"  # seven digits, as the specification suggests
    assert exr.string(key + "name") == name and exr.string(key + "hash") == "MurmurHash3_32"
    assert exr.string(key + "conversion") == "uint32_to_float32"
    manifest = json.loads(exr.string(key + "manifest"))
    pixels = []
    for y in range(exr.height):
        for x in range(exr.width):
            found, last = {}, 1.0
            for layer in range(3):
                for pair in ("rg", "ba"):
                    value, cover = (exr.channels[f"{name}{layer:02}.{c}"][y][x] for c in pair)
                    assert cover <= last, "ranks are not in order"
                    last = cover
                    if cover > 0:
                        assert bits(value) not in found, "an id has two ranks"
                        found[bits(value)] = cover
                    else:
                        assert bits(value) == 0
            pixels.append(found)
    return manifest, pixels


def covered(pixels, name):
    return sum(found.get(bits_of(name), 0) for found in pixels)


def check_hash():
    for name, value in KNOWN.items():
        got, = struct.unpack("<f", struct.pack("<I", bits_of(name)))
        assert abs(got - value) <= 1e-6 * abs(value), (name, got, value)
    for name, digits in MANIFESTS.items():
        assert f"{bits_of(name):08x}" == digits


def check_known_names():
    """Names of the specification, in pictures: the ids are theirs."""
    names = list(KNOWN) + list(MANIFESTS)
    with open("names.gltf", "w", encoding="utf-8") as file:
        file.write(model(names, ["default", 'quo"te\\']))
    done("--size", "160x40", "--orbit", "0,0", "--samples", "4", "--cryptomatte", "object,material", "names.gltf",
         "-o", "names.exr")
    exr = Exr("names.exr")
    manifest, pixels = decode(exr, "CryptoObject")
    assert manifest == {name: f"{bits_of(name):08x}" for name in names}, manifest
    for name in names:
        assert covered(pixels, name) > 5, name
    for name, value in KNOWN.items():
        assert any(abs(struct.unpack("<f", struct.pack("<I", i))[0] - value) <= 1e-6 * abs(value)
                   for found in pixels for i in found), name
    manifest, materials = decode(exr, "CryptoMaterial")
    assert set(manifest) == {"default", 'quo"te\\'} and manifest["default"] == MANIFESTS["default"], manifest
    assert covered(materials, "default") > 20 and covered(materials, 'quo"te\\') > 20
    check_coverage(exr, pixels)
    check_coverage(exr, materials)


def check_coverage(exr, pixels):
    """The coverages of a pixel sum to its alpha, except where a sample lies on an edge."""
    alpha = [value for row in exr.channels["A"] for value in row]
    off = [abs(sum(found.values()) - a) > 1e-3 for found, a in zip(pixels, alpha)]
    assert sum(off) <= len(off) / 500, f"{sum(off)} of {len(off)} pixels"
    partial = sum(0 < a < 0.999 for a in alpha)
    assert partial > 10, partial


def check_samples():
    for options in (("--samples", "8"), ("--samples", "2", "--supersampling", "3"), ("--supersampling", "4")):
        done("--size", "40x40", "--shape", "torus", *options, "--cryptomatte", "object", "--floor", "-o", "torus.exr")
        exr = Exr("torus.exr")
        manifest, pixels = decode(exr, "CryptoObject")
        assert manifest == {"torus": f"{bits_of('torus'):08x}", "floor": f"{bits_of('floor'):08x}"}
        check_coverage(exr, pixels)
        assert any(len(found) == 2 for found in pixels), "no pixel has two objects"
    done("--size", "40x40", "--shape", "torus", "--samples", "1", "--cryptomatte", "object", "-o", "hard.exr")
    assert {cover for found in decode(Exr("hard.exr"), "CryptoObject")[1] for cover in found.values()} == {1.0}
    same = [done("--size", "40x40", "--shape", "torus", "--samples", "4", "--cryptomatte", "object,material", "-o",
                 "exr:-", "--threads", n, "--simd", simd).stdout for n, simd in (("1", "baseline"), ("3", "best"))]
    assert same[0] == same[1]


def check_instances():
    """Instances of a mesh are objects of their own; parts of one name at one place are one object."""
    with open("twice.gltf", "w", encoding="utf-8") as file:
        file.write(model(["chair", "wheel", "wheel"], ["wood"], [(0, 0), (0, 1.5), (1, 3), (2, 4.5)]))
    done("--size", "160x40", "--orbit", "0,0", "--cryptomatte", "object", "twice.gltf", "-o", "twice.exr")
    manifest, pixels = decode(Exr("twice.exr"), "CryptoObject")
    assert set(manifest) == {"chair", "chair_2", "wheel", "wheel_2"}, manifest
    shares = [covered(pixels, name) for name in manifest]
    assert min(shares) > 100 and max(shares) < 1.4 * min(shares), shares
    done("--size", "160x40", "--orbit", "0,0", "--lines", "2", "--cryptomatte", "material", "twice.gltf", "-o",
         "lines.exr")
    assert set(decode(Exr("lines.exr"), "CryptoMaterial")[0]) == {"wood", "lines"}
    refused(2, "does not end in .exr", "--cryptomatte", "object", "-o", "a.png")
    refused(2, "need -o FILE.exr", "--cryptomatte", "object", "--hash")
    refused(2, "dwaa and dwab change the ids", "--cryptomatte", "object", "-o", "a.exr", "--compression", "dwaa")
    refused(2, "did you mean object?", "--cryptomatte", "objct", "-o", "a.exr")


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(FOLDER)
    os.chdir(FOLDER)
    for check in (check_hash, check_streams, check_closed_pipes, check_scratch, check_names, check_jpeg,
                  check_headers, check_known_names, check_samples, check_instances):
        check()
        print(check.__name__)
    print("shd-render: all checks of files passed")


main()
