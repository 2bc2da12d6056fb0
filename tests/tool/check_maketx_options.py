# SPDX-License-Identifier: MIT
"""shd-maketx beside OpenImageIO's maketx: wrap modes, filters, properties, mean and hash as OpenImageIO reads them, -u,
several files, UDIM sets, environments and colour spaces."""
import hashlib
import os
import resource
import shutil
import struct
import subprocess
import sys
import time

TOOL, HELPER, FOLDER, HAS_COLOR = sys.argv[1:5]
WRAPS = {"black": 3, "clamp": 1, "periodic": 0, "mirror": 2}
MAKETX = shutil.which("maketx")


def run(*args, **settings):
    return subprocess.run([TOOL, *args, "--quiet"], capture_output=True, text=True, check=False, **settings)


def done(*args):
    result = run(*args)
    assert result.returncode == 0, (args, result.stderr)
    return result


def refused(code, text, *args):
    result = run(*args)
    assert result.returncode == code and text in result.stderr, (args, code, text, result)


def helper(*args):
    return subprocess.run([HELPER, *map(str, args)], check=True, capture_output=True, text=True).stdout


def infos(*paths):
    """What OpenImageIO says of files, by one call, because it takes long to load."""
    words = [word for path in paths for word in ("--", "info", path)]
    found = []
    for line in helper(*words[1:]).splitlines():
        name, _, value = line.partition("=")
        if name == "file":
            found.append({})
        found[-1][name] = value
    assert [one["file"] for one in found] == list(paths)
    return found


def info(path):
    return infos(path)[0]


def raw(path):
    helper("raw", path, "raw.bin")
    with open("raw.bin", "rb") as file:
        return file.read()


def read(path):
    with open(path, "rb") as file:
        return file.read()


def close(text, wanted, tolerance):
    got = [float(number) for number in text.split(",")]
    assert len(got) == len(wanted) and all(abs(a - b) <= tolerance for a, b in zip(got, wanted)), (text, wanted)


def check_wraps():
    helper("make", "in.tif", 130, 70, 3, "uint8")
    cases = {"a.tx": ("mirror,mirror", "--wrap", "mirror"), "b.tx": ("clamp,black", "--swrap", "clamp"),
             "c.tx": ("black,periodic", "--twrap", "periodic"), "d.tx": ("black,black",),
             "e.exr": ("clamp,mirror", "--wrap", "clamp", "--twrap", "mirror", "--format", "half", "--linear")}
    for output, (_, *options) in cases.items():
        done("in.tif", "-o", output, *options)
    for found in infos(*cases):
        assert found["wrapmodes"] == cases[found["file"]][0], found
    refused(2, "--twrap: \"round\" is not one of black", "in.tif", "-o", "x.tx", "--twrap", "round")


def check_filters():
    """The levels are those of shd_mip_build(), bit for bit, and the edges have the wrap modes."""
    helper("make", "color.tif", 130, 77, 3, "uint8")
    helper("make", "wide.tif", 96, 200, 4, "float")
    seen, checks = set(), []
    for number, kernel in enumerate(("box", "triangle", "kaiser", "lanczos")):
        for source, wraps, options in (("color.tif", ("periodic", "clamp"), ()),
                                       ("wide.tif", ("mirror", "black"), ("--linear",))):
            name = f"filter-{len(seen)}.tx"
            done(source, "-o", name, "--filter", kernel, "--swrap", wraps[0], "--twrap", wraps[1], *options)
            checks += ["--", "filter", name, number, WRAPS[wraps[0]], WRAPS[wraps[1]]]
            seen.add(read(name))
    assert len(seen) == 8, "two filters gave one file"
    helper(*checks[1:])
    helper("make", "normal.tif", 64, 48, 3, "uint8")
    done("normal.tif", "-o", "n.tx", "--normal", "--filter", "kaiser", "--wrap", "periodic")
    helper("filter", "n.tx", 2, 0, 0, "normal")
    done("color.tif", "-o", "one.tx", "--filter", "kaiser", "--threads", "1")
    done("color.tif", "-o", "many.tx", "--filter", "kaiser", "--threads", "4", "--checkpoint", "0")
    assert read("one.tx") == read("many.tx")
    helper("make", "large.tif", 1200, 1000, 3, "uint8")
    refused(2, "--filter holds the image in memory: --memory ", "large.tif", "-o", "x.tx", "--filter", "kaiser",
            "--memory", "3M")
    refused(2, "did you mean lanczos?", "color.tif", "-o", "x.tx", "--filter", "lanczos3")


def expected_hash(data, row, extra):
    """computePixelHashSHA1() of OpenImageIO 2.4 with blocks of 256 rows."""
    blocks = [data[at:at + 256 * row] for at in range(0, len(data), 256 * row)]
    if len(blocks) == 1:
        return hashlib.sha1(data + extra).hexdigest().upper()
    digests = b"".join(hashlib.sha1(block).hexdigest().upper().encode() for block in blocks)
    return hashlib.sha1(digests + extra).hexdigest().upper()


def mean(data, code, channels, one):
    numbers = struct.unpack(f"<{len(data) // struct.calcsize(code)}{code}", data)
    return [sum(numbers[c::channels]) / (len(numbers) // channels) / one for c in range(channels)]


def check_marks():
    """Hash, mean and constant colour are where OpenImageIO looks for them."""
    hashes = set()
    for kind, code, one, height in (("uint8", "B", 255, 200), ("uint8", "B", 255, 700), ("uint16", "H", 65535, 300),
                                    ("half", "e", 1, 90), ("float", "f", 1, 513)):
        helper("make", "m.tif", 100, height, 3, kind)
        data = raw("m.tif")
        wanted = expected_hash(data, len(data) // height, b"shd box ")
        for suffix in ("tx",) if code in "BH" else ("tx", "exr"):
            done("m.tif", "-o", "m." + suffix, "--force", "--linear")
            found = info("m." + suffix)
            assert found["oiio:SHA-1"] == wanted, (kind, found, wanted)
            close(found["averagecolor"], mean(data, code, 3, one), 1e-6)
            close(found["oiio:AverageColor"], mean(data, code, 3, one), 1e-5)
            assert "constantcolor" not in found
            assert abs(float(found["fovcot"]) - 100 / height) < 1e-5
        hashes.add(wanted)
    for options in (("--srgb",), ("--linear", "--filter", "kaiser"),
                    ("--linear", "--filter", "kaiser", "--wrap", "clamp"), ("--linear", "--wrap", "mirror")):
        helper("make", "m.tif", 100, 200, 3, "uint8")
        done("m.tif", "-o", "m.tx", "--force", *options)
        hashes.add(info("m.tx")["oiio:SHA-1"])
    assert len(hashes) == 5 + 3, "levels that differ need hashes that differ, and tags alone do not count"
    for kind, value in (("uint8+grey", 64 / 255), ("float+grey", 0.25)):
        helper("make", "grey.tif", 40, 30, 3, kind)
        done("grey.tif", "-o", "grey.tx", "--force", "--linear")
        close(info("grey.tx")["constantcolor"], [value] * 3, 1e-5)
    helper("make", "nan.tif", 40, 30, 3, "float+nan")
    done("nan.tif", "-o", "nan.tx", "--linear")
    assert "nan" not in info("nan.tx")["oiio:AverageColor"]
    refused(3, '"nan.tif": G of pixel 3, 15 is NaN (--checknan)', "nan.tif", "-o", "x.tx", "--linear", "--checknan")
    done("grey.tif", "-o", "checked.tx", "--linear", "--checknan")


def check_maketx():
    """Files of maketx for the same options say the same."""
    if not MAKETX:
        print("skipped: files of maketx (Debian: openimageio-tools)")
        return
    helper("make", "in.tif", 120, 300, 3, "uint8")
    for options in ((), ("--wrap", "clamp"), ("--swrap", "mirror", "--twrap", "periodic"), ("--envlatl",)):
        subprocess.run([MAKETX, "in.tif", "-o", "theirs.tx", *options], check=True, capture_output=True)
        done("in.tif", "-o", "ours.tx", "--force", *options)
        ours, theirs = info("ours.tx"), info("theirs.tx")
        for name in ("textureformat", "wrapmodes", "oiio:AverageColor", "fovcot", "size", "type", "planarconfig",
                     "compression"):
            assert ours[name] == theirs[name], (options, name, ours[name], theirs[name])
        assert len(ours["oiio:SHA-1"]) == len(theirs["oiio:SHA-1"]) == 40
    ramp = [c for y in range(127, -1, -1) for x in range(128) for c in (x / 128, y / 128, 0.5)]
    with open("ramp.pfm", "wb") as file:  # of floats, because maketx 2.4 reads bytes of other probes as floats
        file.write(b"PF\n128 128\n-1.0\n" + struct.pack(f"<{len(ramp)}f", *ramp))
    subprocess.run([MAKETX, "ramp.pfm", "-o", "theirs.tx", "-d", "float", "--lightprobe"], check=True,
                   capture_output=True)
    done("ramp.pfm", "-o", "ours.tx", "--force", "--linear", "--format", "float", "--lightprobe")
    ours, theirs = (struct.unpack(f"<{3 * 128 * 64}f", raw(name)) for name in ("ours.tx", "theirs.tx"))
    differences = sorted(abs(a - b) for a, b in zip(ours, theirs))
    # Behind the viewer a probe is a rim, where they average differently.
    assert differences[len(differences) * 99 // 100] < 5e-3, "a probe has other directions"
    subprocess.run([MAKETX, "in.tif", "-o", "theirs.exr", "-d", "half", "--attrib", "seed", "7", "--sattrib", "unit",
                    "m"], check=True, capture_output=True)
    done("in.tif", "-o", "ours.exr", "--format", "half", "--linear", "--attrib", "seed=7", "--attrib", "unit=m")
    ours, theirs = info("ours.exr"), info("theirs.exr")
    assert all(ours[name] == theirs[name] for name in ("seed", "unit", "textureformat", "wrapmodes"))


def check_attributes():
    helper("make", "in.tif", 60, 40, 3, "float")
    done("in.tif", "-o", "a.exr", "--attrib", "shot=ab_010", "--attrib", "frame=1001", "--attrib", "gain=0.5",
         "--attrib", "note=a=b c")
    found = info("a.exr")
    assert (found["shot"], found["frame"], found["gain"], found["note"]) == ("ab_010", "1001", "0.5", "a=b c"), found
    done("in.tif", "-o", "texts.tx", "--linear", "--attrib", "Artist=me", "--attrib", "ImageDescription=a wall")
    found = info("texts.tx")
    assert found["Artist"] == "me" and "a wall" in found["ImageDescription"] and len(found["oiio:SHA-1"]) == 40, found
    refused(2, 'TIFF files of OpenImageIO have no "shot": write .exr', "in.tif", "-o", "x.tx", "--attrib", "shot=1")
    refused(2, '"wrapmodes" is set by shd-maketx', "in.tif", "-o", "x.exr", "--attrib", "wrapmodes=x")
    refused(2, '"oiio:SHA-1" is set by shd-maketx', "in.tif", "-o", "x.exr", "--attrib", "oiio:SHA-1=x")
    refused(2, "is not NAME=VALUE", "in.tif", "-o", "x.exr", "--attrib", "shot")
    refused(2, "is not NAME=VALUE", "in.tif", "-o", "x.exr", "--attrib", "=1")


def check_update():
    helper("make", "u.tif", 60, 40, 3, "float")
    for output in ("u.tx", "u.exr"):
        command = ("u.tif", "-o", output, "--linear", "-u")

        def made(*options):
            """Whether a run makes the file anew."""
            result = done(*command, *options)
            assert ("is up to date" in result.stdout) != ("levels" in result.stdout), result.stdout
            return "levels" in result.stdout

        assert made() and not made() and not made("--threads", "2", "--memory", "9M")
        assert made("--wrap", "clamp") and not made("--wrap", "clamp") and made()
        assert made("--filter", "kaiser") and made("--attrib", "Artist=me") and made()
        before = os.stat(output)
        time.sleep(0.02)
        os.utime("u.tif")
        assert made() and os.stat(output).st_mtime_ns > before.st_mtime_ns
        shutil.copy("u.tif", "v.tif")
        os.utime("v.tif", ns=(os.stat("u.tif").st_atime_ns, os.stat("u.tif").st_mtime_ns))
        assert "levels" in done("v.tif", *command[1:]).stdout, "another input is another file"
        with open(output, "wb") as file:
            file.write(b"no image at all")
        assert made() and not made()
        with open(output, "r+b") as file:
            file.truncate(200)
        assert made()
        refused(4, "exists: --force replaces it", *command[:-1])
    for output in ("key.tx", "key.exr"):
        for text in ("shd:key=zz", "shd:key=0123456789abcdef and more", "shd:key="):
            command = ("u.tif", "-o", output, "--linear", "-u", "--attrib", "ImageDescription=" + text)
            assert "levels" in done(*command).stdout and "is up to date" in done(*command).stdout, (output, text)
    refused(3, "No such file", "absent.tif", "-o", "u.tx", "-u")
    if MAKETX:
        subprocess.run([MAKETX, "u.tif", "-o", "u.tx"], check=True, capture_output=True)
        assert "levels" in done("u.tif", "-o", "u.tx", "--linear", "-u").stdout, "a file of maketx has no key"


def check_batch():
    os.mkdir("out")
    for name in ("a.tif", "b.png", "c.tif"):
        helper("make", name, 50, 30, 3, "uint8")
    lines = done("a.tif", "b.png", "c.tif", "-o", "out/").stdout.splitlines()
    assert sorted(os.listdir("out")) == ["a.tx", "b.tx", "c.tx"] and len(lines) == 3, lines
    assert read("out/a.tx") == read(single("a.tif"))
    assert done("a.tif", "b.png", "c.tif", "-o", "out", "-u").stdout.count("is up to date") == 3
    with open("bad.tif", "wb") as file:
        file.write(b"no image")
    result = run("bad.tif", "a.tif", "-o", "out", "--force")
    assert result.returncode == 3 and "bad.tif" in result.stderr and "out/a.tx: 50 x 30" in result.stdout, result
    refused(2, "2 inputs: -o must be a folder", "a.tif", "b.png", "-o", "x.tx")
    refused(4, 'there is no folder "absent/"', "a.tif", "-o", "absent/")
    shutil.copy("a.tif", "out/a.tif")
    refused(2, '"a.tif" and "out/a.tif" would be one file: "out/a.tx"', "a.tif", "out/a.tif", "-o", "out", "--force")


def single(name):
    done(name, "-o", "single.tx", "--force")
    return "single.tx"


def check_udim():
    os.mkdir("udim")
    for number in (1001, 1002, 1011):
        helper("make", f"skin.{number}.tif", 40 + number % 7, 30, 3, "uint8")
    done("skin.<UDIM>.tif", "-o", "udim/")
    assert sorted(os.listdir("udim")) == [f"skin.{n}.tx" for n in (1001, 1002, 1011)]
    done("skin.<UDIM>.tif", "-o", "udim/s_<UDIM>.tx")
    assert read("udim/s_1011.tx") == read("udim/skin.1011.tx")
    assert info("udim/s_1002.tx")["size"] == f"{40 + 1002 % 7},30,3"
    refused(3, 'no file is named "none.<UDIM>.tif"', "none.<UDIM>.tif", "-o", "udim/")
    refused(2, "INPUT and OUTPUT have <UDIM>, or neither", "skin.<UDIM>.tif", "-o", "x.tx")
    refused(2, "INPUT and OUTPUT have <UDIM>, or neither", "a.tif", "-o", "x<UDIM>.tx")


def check_environments():
    helper("make", "sky.tif", 128, 64, 3, "float")
    done("sky.tif", "-o", "sky.tx", "--envlatl", "--linear")
    found = info("sky.tx")
    assert found["textureformat"] == "LatLong Environment" and found["wrapmodes"] == "periodic,clamp", found
    assert raw("sky.tx") == raw("sky.tif")
    done("sky.tif", "-o", "soft.tx", "--envlatl", "--linear", "--filter", "lanczos")
    helper("filter", "soft.tx", 3, WRAPS["periodic"], WRAPS["clamp"])
    refused(2, "lie on the borders: write .tx", "sky.tif", "-o", "x.exr", "--envlatl")
    for kind, value in (("float+grey", 0.25), ("uint8+grey", 64 / 255)):
        helper("make", "probe.tif", 64, 64, 3, kind)
        done("probe.tif", "-o", "probe.tx", "--lightprobe", "--linear", "--force")
        found = info("probe.tx")
        assert found["size"] == "64,32,3" and found["textureformat"] == "LatLong Environment", found
        close(found["constantcolor"], [value] * 3, 1e-5)
    helper("make", "probe.tif", 64, 64, 3, "float")
    done("probe.tif", "-o", "probe.tx", "--lightprobe", "--linear", "--force")
    done("probe.tif", "-o", "again.tx", "--lightprobe", "--linear", "--threads", "1")
    assert read("probe.tx") == read("again.tx")
    refused(3, "a --lightprobe is a square", "sky.tif", "-o", "x.tx", "--lightprobe", "--linear")
    helper("make", "big.tif", 512, 512, 3, "float")
    refused(2, "--lightprobe holds the image in memory: --memory 9M, not 4M", "big.tif", "-o", "x.tx", "--lightprobe",
            "--linear", "--memory", "4M")
    refused(2, "exclude each other", "probe.tif", "-o", "x.tx", "--lightprobe", "--envlatl")
    for content in ("--envlatl", "--lightprobe"):
        for wrap in ("--wrap", "--swrap", "--twrap"):
            for options in ((content, wrap, "periodic"), (wrap, "black", content)):
                refused(2, "--envlatl and --lightprobe set the wraps: no --wrap, --swrap and --twrap", "probe.tif", "-o",
                        "x.tx", "--linear", *options)
    assert not os.path.exists("x.tx")
    refused(2, "--normal: vectors are no light", "probe.tif", "-o", "x.tx", "--normal", "--envlatl")


TEXTURE = "sRGB - Texture"  # of the built-in config


def to_linear(x):
    return x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4


CONFIG = """ocio_profile_version: 2
search_path: ""
roles: {{default: base, scene_linear: base}}
file_rules: [!<Rule> {{name: Default, colorspace: default}}]
displays: {{screen: [!<View> {{name: Raw, colorspace: base}}]}}
colorspaces:
  - !<ColorSpace> {{name: base}}
  - !<ColorSpace>
    name: scaled
    from_scene_reference: !<MatrixTransform> {{matrix: [{0}, 0, 0, 0, 0, {0}, 0, 0, 0, 0, {0}, 0, 0, 0, 0, 1]}}
"""


def check_config():
    """A file belongs to the config that $OCIO names: to its path, size and time."""
    helper("make", "flat.tif", 300, 600, 3, "uint8+grey")
    command = ("flat.tif", "-o", "config.tx", "--colorconvert", "base", "scaled", "--format", "float")

    def write_config(name, factor):
        with open(name, "w", encoding="ascii") as file:
            file.write(CONFIG.format(factor))

    def made(config, factor):
        """Whether -u makes the file anew; it has the colours of the config in any case."""
        result = run(*command, "-u", env={**os.environ, "OCIO": config})
        assert result.returncode == 0, result.stderr
        close(info("config.tx")["oiio:AverageColor"], [64 / 255 * factor] * 3, 1e-5)
        return "is up to date" not in result.stdout

    for name, factor in (("half.ocio", 0.5), ("more.ocio", 1.5)):
        write_config(name, factor)
    assert made("half.ocio", 0.5) and not made("half.ocio", 0.5) and not made(os.path.abspath("half.ocio"), 0.5)
    assert made("more.ocio", 1.5) and made("half.ocio", 0.5)
    write_config("half.ocio", 0.25)
    assert made("half.ocio", 0.25) and not made("half.ocio", 0.25)
    absent = run(*command, "-u", env={**os.environ, "OCIO": "absent.ocio"})
    assert absent.returncode == 1 and 'no file "absent.ocio"' in absent.stderr, absent
    plain = ("flat.tif", "-o", "plain.tx", "-u")
    done(*plain)
    assert "is up to date" in run(*plain, env={**os.environ, "OCIO": "half.ocio"}).stdout, "no conversion, no config"
    # The limit is above the levels and below the file.
    os.remove("config.tx")
    slices = ("--checkpoint", "0", "--memory", "4M", "--compression", "none")
    full = run(*command, *slices, env={**os.environ, "OCIO": "half.ocio"},
               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 20, 1 << 20)))
    assert full.returncode == 4 and os.path.isdir("config.tx.part"), full
    other = run(*command, *slices, env={**os.environ, "OCIO": "more.ocio"})
    assert other.returncode == 4 and "--force" in other.stderr and not os.path.exists("config.tx"), other
    assert run(*command, *slices, env={**os.environ, "OCIO": "half.ocio"}).returncode == 0
    close(info("config.tx")["oiio:AverageColor"], [64 / 255 * 0.25] * 3, 1e-5)


def check_colors():
    helper("make", "c.tif", 50, 30, 3, "uint8+grey")
    convert = ("c.tif", "-o", "c.tx", "--force", "--colorconvert")
    if HAS_COLOR != "1":
        refused(2, "was built without libshd_color", *convert, "sRGB", "ACEScg")
        return
    done(*convert, TEXTURE, "Linear Rec.709")
    found = info("c.tx")
    assert found["type"] == "half", found
    close(found["oiio:AverageColor"], [to_linear(64 / 255)] * 3, 1e-4)
    done(*convert, TEXTURE, "ACEScg", "--format", "float")
    close(info("c.tx")["oiio:AverageColor"], [to_linear(64 / 255)] * 3, 1e-4)  # greys stay grey
    done(*convert, TEXTURE, TEXTURE, "--format", "uint8")
    close(info("c.tx")["oiio:AverageColor"], [64 / 255] * 3, 1e-5)
    helper("make", "noise.tif", 50, 30, 4, "uint8")
    done("noise.tif", "-o", "c.tx", "--force", "--colorconvert", TEXTURE, TEXTURE, "--format", "uint8")
    assert raw("c.tx") == raw("noise.tif"), "there and back"
    check_config()
    refused(2, '--colorconvert: "sRBG" is not a colour space or role of the config: did you mean sRGB?', *convert,
            "sRBG", "ACEScg")
    refused(2, "--colorconvert needs a value: two colour spaces", *convert, "sRGB")
    refused(2, "no --srgb and no --linear", *convert, "sRGB", "ACEScg", "--linear")
    helper("make", "two.tif", 50, 30, 2, "uint8")
    refused(3, "--colorconvert needs 3 or 4 channels, not 2", "two.tif", *convert[1:], "sRGB", "ACEScg")


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(FOLDER)
    os.chdir(FOLDER)
    for check in (check_wraps, check_filters, check_marks, check_maketx, check_attributes, check_update, check_batch,
                  check_udim, check_environments, check_colors):
        start = time.monotonic()
        check()
        print(f"{check.__name__}: {time.monotonic() - start:.1f} s")
    print("shd-maketx: all checks of options passed")


main()
