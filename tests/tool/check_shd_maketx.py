# SPDX-License-Identifier: MIT
"""shd-maketx: levels against libshd, OpenImageIO's TextureSystem, killed and resumed runs, bad files, a full disk."""
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time

TOOL, HELPER, FOLDER = sys.argv[1:4]
SANITIZED = sys.argv[4:] == ["sanitized"]  # a sanitizer takes memory and time of its own


def run(*args, limit=None):
    """Runs the tool; `limit` is the largest file it may write."""
    before = (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))) if limit else None
    return subprocess.run([TOOL, *args], capture_output=True, text=True, preexec_fn=before, check=False)


def done(*args):
    result = run(*args)
    assert result.returncode == 0, (args, result.stderr)
    return result


def refused(code, text, *args, limit=None):
    result = run(*args, limit=limit)
    assert result.returncode == code and text in result.stderr, (args, code, text, result.returncode, result.stderr)


def helper(*args):
    subprocess.run([HELPER, *map(str, args)], check=True, stdout=subprocess.DEVNULL)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write(path, data):
    with open(path, "wb") as file:
        file.write(data)


def check_formats():
    sizes = [(64, 64), (300, 500), (1, 1), (127, 33), (256, 128), (1, 40), (96, 1025)]
    for k, kind in enumerate(("uint8", "uint16", "half", "float")):
        for channels in (3,) if SANITIZED else (1, 2, 3, 4):
            numbers = {(k + 2 * channels) % len(sizes)} | ({1} if channels == 3 else set())
            for number in sorted(numbers):
                width, height = sizes[number]
                tiles = "+tiles" if number % 2 else ""
                helper("make", "in.tif", width, height, channels, kind + tiles)
                meaning = "srgb" if kind == "uint8" and number % 3 else "linear"
                done("in.tif", "-o", "out.tx", "--force", "--" + meaning, "--quiet", "--memory", "1M", "--tile", "16")
                helper("check", "in.tif", "out.tx", meaning)
                if number == 1:
                    helper("lookup", "out.tx")
                if kind in ("half", "float") and number == 1:
                    done("in.tif", "-o", "out.exr", "--force", "--quiet")
                    helper("check", "in.tif", "out.exr")
                    helper("lookup", "out.exr")
    for channels in (3, 4):
        for kind in ("uint8", "uint16", "float"):
            helper("make", "in.tif", 130, 77, channels, kind)
            done("in.tif", "-o", "out.tx", "--force", "--normal", "--quiet")
            helper("check", "in.tif", "out.tx", "normal")


def check_same_file():
    """Threads, bands and places to continue from do not change the file."""
    helper("make", "in.tif", 1000, 2100, 3, "uint8")
    done("in.tif", "-o", "one.tx", "--quiet", "--threads", "1", "--memory", "1M", "--checkpoint", "0")
    done("in.tif", "-o", "many.tx", "--quiet", "--threads", "4", "--memory", "1G")
    assert read("one.tx") == read("many.tx")


def check_kills():
    """A run that is killed with SIGKILL at any time continues, and gives the same file, byte for byte."""
    helper("make", "in.tif", 1500, 4001, 4, "uint16")
    start = time.monotonic()
    done("in.tif", "-o", "whole.tx", "--linear", "--quiet", "--threads", "1")
    seconds = time.monotonic() - start
    wanted = read("whole.tx")
    command = [TOOL, "in.tif", "-o", "killed.tx", "--linear", "--threads", "1", "--checkpoint", "0", "--memory", "4M"]
    continued, killed = 0, 0
    generator = random.Random(5)
    for attempt in range(60):
        process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
        # The last attempts run to the end.
        wait = seconds * (0.1 + 1.1 * generator.random()) if attempt < 8 else None
        try:
            errors = process.communicate(timeout=wait)[1]
            assert process.returncode == 0, errors
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            errors = process.communicate()[1]
            killed += process.returncode == -signal.SIGKILL
        continued += "continues" in errors
        if os.path.exists("killed.tx"):
            assert read("killed.tx") == wanted, "the file differs after a kill"
            if process.returncode == 0:
                assert not os.path.exists("killed.tx.part")
            if attempt >= 8:
                break
            os.remove("killed.tx")
            shutil.rmtree("killed.tx.part", ignore_errors=True)
    assert killed >= 3 and continued >= 2, (killed, continued)
    print(f"killed {killed} runs, continued {continued}")


def check_part():
    """Folders of other runs, and damaged ones."""
    helper("make", "in.tif", 600, 900, 3, "uint8")
    done("in.tif", "-o", "good.tx", "--quiet")
    refused(4, "cannot", "in.tif", "-o", "part.tx", "--quiet", "--checkpoint", "0", "--memory", "1M", limit=300000)
    assert os.path.isdir("part.tx.part") and not os.path.exists("part.tx") and not os.path.exists("part.tx.part/file")
    refused(4, "other options: --force begins anew", "in.tif", "-o", "part.tx", "--tile", "32")
    state = bytearray(read("part.tx.part/state"))
    state[len(state) // 2] ^= 1
    for damaged in (bytes(state), b"", bytes(state[:100])):
        write("part.tx.part/state", damaged)
        done("in.tif", "-o", "part.tx", "--quiet")
        assert read("part.tx") == read("good.tx")
        os.remove("part.tx")
        refused(4, "cannot", "in.tif", "-o", "part.tx", "--quiet", "--checkpoint", "0", "--memory", "1M", limit=300000)
    os.truncate("part.tx.part/level-1", 10)
    done("in.tif", "-o", "part.tx", "--quiet")
    assert read("part.tx") == read("good.tx") and not os.path.exists("part.tx.part")


def check_refusals():
    helper("make", "in.tif", 300, 200, 3, "uint8")
    refused(2, "no INPUT")
    refused(2, "no OUTPUT", "in.tif")
    refused(2, "two inputs", "in.tif", "b.tif", "-o", "x.tx")
    refused(2, "is not a name that ends in", "in.tif", "-o", "x.png")
    refused(2, "is not a multiple of 16", "in.tif", "-o", "x.tx", "--tile", "40")
    refused(2, "is not one of", "in.tif", "-o", "x.tx", "--compression", "jpeg")
    refused(2, "is not an option", "in.tif", "-o", "x.tx", "--what", "1")
    refused(2, "exclude each other", "in.tif", "-o", "x.tx", "--srgb", "--linear")
    refused(2, "--memory", "in.tif", "-o", "x.tx", "--memory", "1K")
    refused(2, "OpenEXR stores no uint8", "in.tif", "-o", "x.exr")
    refused(3, "No such file", "absent.tif", "-o", "x.tx")
    refused(3, "not a regular file", ".", "-o", "x.tx")
    write("empty.tif", b"")
    refused(3, "the file is empty", "empty.tif", "-o", "x.tx")
    write("noise.tif", bytes(range(256)) * 10)
    refused(3, "cannot read", "noise.tif", "-o", "x.tx")
    refused(3, "--channels 4, but the file has 3", "in.tif", "-o", "x.tx", "--channels", "4")
    refused(3, "sRGB-encoded numbers of type float", "in.tif", "-o", "x.tx", "--srgb", "--format", "float")
    helper("make", "cut.tif", 300, 2000, 3, "uint8")
    write("cut.tif", read("cut.tif")[:400000])
    refused(3, "cut.tif", "cut.tif", "-o", "x.tx", "--quiet")
    assert not os.path.exists("x.tx.part")
    helper("make", "many.tif", 20, 20, 6, "uint8")
    refused(3, "choose the first 1 to 4 with --channels", "many.tif", "-o", "x.tx")
    helper("make", "wide.tif", 70000, 16, 4, "float")
    refused(2, "need", "wide.tif", "-o", "x.tx", "--memory", "4M")
    refused(4, "cannot make", "in.tif", "-o", "absent/x.tx")
    write("old.tx", b"old")
    refused(4, "exists: --force replaces it", "in.tif", "-o", "old.tx")
    refused(4, "cannot", "in.tif", "-o", "old.tx", "--force", "--quiet", limit=20000)
    assert read("old.tx") == b"old" and not os.path.exists("x.tx")


def check_memory():
    """Rows in memory are bounded: 400 MB of pixels with 16 MB."""
    helper("make", "large.tif", 4096, 8192, 3, "float")
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    process = subprocess.Popen([TOOL, "large.tif", "-o", "large.tx", "--linear", "--quiet", "--memory", "16M",
                                "--compression", "none"])
    _, status, usage = os.wait4(process.pid, 0)
    assert status == 0
    print(f"large image: {usage.ru_maxrss >> 10} MB at most (helper {before >> 10} MB)")
    assert usage.ru_maxrss < 150 << 10
    os.remove("large.tif")
    os.remove("large.tx")


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(FOLDER)
    os.chdir(FOLDER)
    checks = [check_formats, check_same_file, check_part, check_refusals]
    if not SANITIZED:
        checks += [check_kills, check_memory]
    for check in checks:
        start = time.monotonic()
        check()
        print(f"{check.__name__}: {time.monotonic() - start:.1f} s")
    assert "shd-maketx 0" in done("--version").stdout and "Usage:" in done("--help").stdout
    print("shd-maketx: all checks passed")


main()
