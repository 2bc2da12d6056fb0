# SPDX-License-Identifier: MIT
"""shd-maketx: levels against libshd, OpenImageIO's TextureSystem, killed and resumed runs, damaged checkpoints, links
in the place of files, hostile inputs, a full disk."""
import filecmp
import os
import random
import resource
import shutil
import signal
import stat
import struct
import subprocess
import sys
import time

TOOL, HELPER, FALSE_DECODER, FOLDER = sys.argv[1:5]
SANITIZED = sys.argv[5:] == ["sanitized"]  # a sanitizer takes memory and time of its own


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


def helpers(*commands):
    """Runs the helper once, because OpenImageIO takes long to load."""
    words = [word for command in commands for word in ("--", *map(str, command))]
    subprocess.run([HELPER, *words[1:]], check=True, stdout=subprocess.DEVNULL)


def helper(*args):
    helpers(args)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write(path, data):
    with open(path, "wb") as file:
        file.write(data)


def check_formats():
    sizes = [(64, 64), (300, 500), (1, 1), (127, 33), (256, 128), (1, 40), (96, 1025)]
    makes, runs, checks = [], [], []

    def add(size, channels, kind, meaning, options, suffix="tx", lookup=False):
        name = f"formats-{len(runs)}"
        makes.append(("make", name + ".tif", *size, channels, kind))
        runs.append((name + ".tif", "-o", f"{name}.{suffix}", "--quiet", *options))
        checks.append(("check", name + ".tif", f"{name}.{suffix}", meaning))
        if lookup:
            checks.append(("lookup", f"{name}.{suffix}"))

    for k, kind in enumerate(("uint8", "uint16", "half", "float")):
        for channels in (3,) if SANITIZED else (1, 2, 3, 4):
            numbers = {(k + 2 * channels) % len(sizes)} | ({1} if channels == 3 else set())
            for number in sorted(numbers):
                tiles = "+tiles" if number % 2 else ""
                meaning = "srgb" if kind == "uint8" and number % 3 else "linear"
                add(sizes[number], channels, kind + tiles, meaning, ("--" + meaning, "--memory", "1M", "--tile", "16"),
                    lookup=number == 1)
                if kind in ("half", "float") and number == 1:
                    add(sizes[number], channels, kind + tiles, "linear", (), "exr", lookup=True)
    for channels in (3, 4):
        for kind in ("uint8", "uint16", "float"):
            add((130, 77), channels, kind, "normal", ("--normal",))
    helpers(*makes)
    for arguments in runs:
        done(*arguments)
    helpers(*checks)


def check_same_file():
    """Threads, bands and places to continue from do not change the file."""
    helper("make", "in.tif", 1000, 2100, 3, "uint8")
    done("in.tif", "-o", "one.tx", "--quiet", "--threads", "1", "--memory", "1M", "--checkpoint", "0")
    done("in.tif", "-o", "many.tx", "--quiet", "--threads", "4", "--memory", "1G")
    assert read("one.tx") == read("many.tx")


def saved_state():
    """What tells the states that a run has saved apart, or None."""
    try:
        found = os.stat("killed.tx.part/state")
    except FileNotFoundError:
        return None
    return found.st_ino, found.st_mtime_ns


def check_kills():
    """A run that is killed with SIGKILL at any time continues, and gives the same file, byte for byte."""
    helper("make", "in.tif", 1500, 4001, 4, "uint16")
    done("in.tif", "-o", "whole.tx", "--linear", "--quiet", "--threads", "1")
    wanted = read("whole.tx")
    command = [TOOL, "in.tif", "-o", "killed.tx", "--linear", "--threads", "1", "--checkpoint", "0", "--memory", "4M"]
    continued, killed = 0, 0
    generator = random.Random(5)
    for attempt in range(9):
        process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
        # Each run saves a few states and is then killed, somewhere in its next band. The last one runs to the end.
        states, before = (generator.randint(0, 4) if attempt < 8 else None), saved_state()
        while process.poll() is None and states != 0:
            now = saved_state()
            states = states - 1 if states and now != before else states
            before = now
            time.sleep(0.001)
        time.sleep(0.02 * generator.random())
        process.kill()
        errors = process.communicate()[1]
        assert process.returncode in (0, -signal.SIGKILL), errors
        killed += process.returncode == -signal.SIGKILL
        continued += "continues" in errors
        if os.path.exists("killed.tx"):
            assert read("killed.tx") == wanted, "the file differs after a kill"
            if process.returncode == 0:
                assert not os.path.exists("killed.tx.part")
            os.remove("killed.tx")
            shutil.rmtree("killed.tx.part", ignore_errors=True)
    assert process.returncode == 0 and killed >= 3 and continued >= 2, (process.returncode, killed, continued)
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
    done("in.tif", "-o", "part.tx", "--quiet")
    assert read("part.tx") == read("good.tx") and not os.path.exists("part.tx.part")


def flip(data):
    changed = bytearray(data)
    changed[len(data) // 3] ^= 4
    return bytes(changed)


def swap_blocks(data):
    return data[64:128] + data[:64] + data[128:]


def check_damage():
    """A checkpoint that is damaged anywhere is not used: the run begins anew, says so, and gives the same file."""
    helper("make", "in.tif", 600, 900, 3, "uint8")
    done("in.tif", "-o", "undamaged.tx", "--quiet")
    # All levels are made before the file becomes too large.
    refused(4, "cannot", "in.tif", "-o", "kept.tx", "--quiet", "--checkpoint", "0", "--memory", "1M", limit=500000)
    names = sorted(name for name in os.listdir("kept.tx.part") if os.path.getsize("kept.tx.part/" + name) > 0)
    assert len(names) > 6 and "state" in names, names
    damages = [(name, flip) for name in names]
    for name in ("level-1", "level-3", "state"):
        damages += [(name, lambda data: data[:-1]), (name, swap_blocks)]
    for name, damage in damages[::6] if SANITIZED else damages:
        shutil.copytree("kept.tx.part", "part.tx.part")
        before = read("part.tx.part/" + name)
        assert damage(before) != before, name
        write("part.tx.part/" + name, damage(before))
        errors = done("in.tif", "-o", "part.tx", "--force").stderr
        assert name + " of the unfinished run is damaged: begins anew" in errors and "continues" not in errors, errors
        assert read("part.tx") == read("undamaged.tx") and not os.path.exists("part.tx.part"), (name, damage)
    os.rename("kept.tx.part", "part.tx.part")
    errors = done("in.tif", "-o", "part.tx", "--force").stderr
    assert "continues" in errors and "damaged" not in errors, errors
    assert read("part.tx") == read("undamaged.tx")
    print(f"{len(damages)} damages of a checkpoint")


def snapshot(folder):
    return {name: read(os.path.join(folder, name)) for name in sorted(os.listdir(folder))}


def check_links():
    """Who makes OUTPUT.part or files in it first does not decide which files are written."""
    helper("make", "in.tif", 200, 300, 3, "uint8")
    done("in.tif", "-o", "links.tx", "--quiet")
    os.mkdir("victims")
    victims = ["file", "lock", "state", "state.new", "level-1"]
    for name in victims:
        write("victims/" + name, b"precious")
    before = snapshot("victims")

    def attack(name, prepare, text):
        """Runs beside what `prepare` has made; without a text, the run is to succeed."""
        prepare()
        if text:
            refused(4, text, "in.tif", "-o", "x.tx", "--quiet")
        else:
            done("in.tif", "-o", "x.tx", "--quiet", "--force")
            assert read("x.tx") == read("links.tx") and stat.S_ISREG(os.lstat("x.tx").st_mode), name
            os.remove("x.tx")
        assert snapshot("victims") == before, name
        if os.path.islink("x.tx.part") or os.path.isfile("x.tx.part"):
            os.remove("x.tx.part")
        shutil.rmtree("x.tx.part", ignore_errors=True)

    def folder(mode, fill=None, *names):
        os.mkdir("x.tx.part")
        if fill:
            fill(*names)
        os.chmod("x.tx.part", mode)

    attack("part/link", lambda: os.symlink("victims", "x.tx.part"), "cannot use as a folder")
    attack("part/dangling", lambda: os.symlink("absent", "x.tx.part"), "cannot use as a folder")
    attack("part/file", lambda: write("x.tx.part", b""), "cannot use as a folder")
    attack("part/group", lambda: folder(0o770), "other users may write to")
    attack("part/world", lambda: folder(0o707), "other users may write to")
    if os.geteuid() == 0:
        attack("part/owner", lambda: folder(0o700, os.chown, "x.tx.part", 54321, 54321), "another user")
    for name in victims:
        place = "x.tx.part/" + name
        text = None if name in ("file", "state.new") else "cannot open " + name
        attack("link/" + name, lambda: folder(0o700, os.symlink, "../victims/" + name, place), text)
        text = text and name + '" is no regular file with one name'
        attack("hard_link/" + name, lambda: folder(0o755, os.link, "victims/" + name, place), text)
        attack("fifo/" + name, lambda: folder(0o700, os.mkfifo, place), text)
    attack("output/link", lambda: os.symlink("victims/file", "x.tx"), None)


def children(pid):
    """Processes that a process has started."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            fields = read(f"/proc/{entry}/stat").decode("latin-1").rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[1]) == pid and fields[0] != "Z":
            found.append(int(entry))
    return found


def wait_for(condition, what):
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end, what
        time.sleep(0.002)


def begin(name, *options):
    """A run on large.tif that has made a checkpoint and is stopped, and its decoder."""
    process = subprocess.Popen([TOOL, "large.tif", "-o", name, "--linear", "--quiet", "--checkpoint", "0",
                                "--memory", "8M", *options],
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    wait_for(lambda: os.path.exists(name + ".part/state") or process.poll() is not None, "no checkpoint")
    process.send_signal(signal.SIGSTOP)
    decoders = children(process.pid)
    assert process.poll() is None and len(decoders) == 1, (process.poll(), decoders)
    return process, decoders[0]


def ends(process, code, text):
    process.send_signal(signal.SIGCONT)
    errors = process.communicate(timeout=60)[1]
    assert process.returncode == code and text in errors, (process.returncode, errors)


def check_decoder():
    """A decoder that dies or stops ends the run with an error, and another run continues."""
    helper("make", "large.tif", 3000, 4000, 3, "uint16")
    done("large.tif", "-o", "undisturbed.tx", "--linear", "--quiet")
    for name, number, text in (("dead", signal.SIGKILL, "the decoder died on the file (signal 9)"),
                               ("stopped", signal.SIGSTOP, "the decoder has sent nothing for 15 s (--stall-limit)")):
        process, decoder = begin(name + ".tx", "--stall-limit", "15")
        os.kill(decoder, number)
        ends(process, 3, text)
        assert not os.path.exists(f"/proc/{decoder}"), "the decoder is still there"
        assert not os.path.exists(name + ".tx") and os.path.isdir(name + ".tx.part")
        assert "continues" in done("large.tif", "-o", name + ".tx", "--linear").stderr
        assert filecmp.cmp(name + ".tx", "undisturbed.tx", shallow=False)
    refused(1, "not done within --time-limit", "large.tif", "-o", "late.tx", "--linear", "--quiet",
            "--time-limit", "0.1")
    assert not os.path.exists("late.tx") and not os.path.exists("late.tx.part")
    process, decoder = begin("alone.tx")
    process.kill()
    process.communicate()
    wait_for(lambda: not os.path.exists(f"/proc/{decoder}"), "the decoder outlives its run")

    # Another user who may write to the folder of OUTPUT moves the folder away in the middle, and puts a link there.
    process, _ = begin("moved.tx")
    assert stat.S_IMODE(os.stat("moved.tx.part").st_mode) == 0o700
    os.rename("moved.tx.part", "elsewhere")
    os.mkdir("trap")
    for name in ("file", "state", "lock", "level-1"):
        write("trap/" + name, b"precious")
    before = snapshot("trap")
    os.symlink("trap", "moved.tx.part")
    ends(process, 0, "")
    assert filecmp.cmp("moved.tx", "undisturbed.tx", shallow=False)
    assert snapshot("trap") == before and not os.listdir("elsewhere")
    mask = os.umask(0)
    os.umask(mask)
    assert stat.S_IMODE(os.stat("moved.tx").st_mode) == 0o666 & ~mask
    os.remove("large.tif")


def check_false_decoder():
    """Whatever the decoder sends, the run ends with an error or with an image of a valid description."""
    helper("make", "in.tif", 300, 200, 3, "uint8")
    fields = ("width height depth x y full_x full_y full_width full_height tile_width tile_height channels alpha "
              "base_type deep straight color_space").split()
    at = {name: f"1 {4 * i}" for i, name in enumerate(fields)}
    names = 4 * (len(fields) - 1) + 64 + 32
    for text, lie in (("wrong piece", "0 0 7"), ("wrong piece", "0 4 2"), ("wrong piece", "0 0 2 0 4 1025"),
                      ("without pixels", at["height"] + " -1"), ("each side may have", at["width"] + " 1048577"),
                      ("data window", at["width"] + " 600"), ("choose the first 1 to 4", at["channels"] + " 99"),
                      ("the decoder died", f"{at['width']} 600 {at['full_width']} 600"),
                      ("the decoder died", f"{at['height']} 400 {at['full_height']} 400"),
                      ("bad tile size", at["tile_height"] + " -1"), ("no known type", at["base_type"] + " -1"),
                      ("no known type", at["base_type"] + " 1000"), ("volumes", at["depth"] + " 2"),
                      ("colour space", at["color_space"] + " 0x6d6d6d6d"),
                      ("", at["alpha"] + " 1000"), ("", f"1 {names} 0x01010101"), ("", f"1 {names} 71"),
                      ("wrong piece", "2 4 0"), ("wrong piece", "2 4 201"), ("wrong piece", "2 4 100"),
                      ("the decoder died", "1 end"), ("the decoder died", "3 end")):
        shutil.copy("in.tif", "bad.tif")
        lies = {"LD_PRELOAD": FALSE_DECODER, "LD_FALSE_DECODER": lie}
        result = subprocess.run([TOOL, "bad.tif", "-o", "x.tx", "--quiet", "--force", "--stall-limit", "20"],
                                env={**os.environ, **lies}, capture_output=True, text=True, check=False)
        assert result.returncode == (3 if text else 0), (lie, result)
        assert text in result.stderr and (not text or '"bad.tif"' in result.stderr), (lie, result)
        assert not os.path.exists("x.tx.part")
        if not text:
            helper("check", "in.tif", "x.tx", "srgb")


def check_hostile():
    """Damaged inputs, and some that end OpenImageIO 2.4 by a signal: an error that names the file, or an image."""
    # Pixels of 32 bits are indices of a palette with one colour.
    for kind in (1, 9):
        header = struct.pack("<BBBHHBHHHHBB", 0, 1, kind, 0, 1, 24, 0, 0, 2, 2, 32, 0)
        write("palette.tga", header + b"\1\2\3" + b"\xff" * 40)
        refused(3, "palette.tga", "palette.tga", "-o", "x.tx", "--quiet")
    os.mkfifo("fifo.png")
    refused(3, "not a regular file", "fifo.png", "-o", "x.tx", "--quiet")
    generator = random.Random(7)
    results = {0: 0, 3: 0}
    for suffix, kind in (("png", "uint8"), ("tif", "uint16"), ("exr", "half"), ("tga", "uint8")):
        helper("make", "whole." + suffix, 61, 83, 4, kind)
        whole = read("whole." + suffix)
        for attempt in range(2 if SANITIZED else 7):
            data = bytearray(whole)
            for _ in range(1 + attempt % 3):
                data[generator.randrange(400 if attempt % 2 else len(data))] = generator.randrange(256)
            if attempt % 4 == 3:
                data = data[:generator.randrange(1, len(data))]
            name = "bad." + suffix
            write(name, data)
            result = run(name, "-o", "x.tx", "--quiet", "--force", "--format", "half", "--linear",
                         "--stall-limit", "20")
            code = result.returncode
            assert code in results and (code == 0 or f'"{name}":' in result.stderr), (suffix, attempt, result)
            assert not os.path.exists("x.tx.part")
            results[code] += 1
    print(f"damaged inputs: {results[0]} images, {results[3]} errors")
    assert results[0] and results[3]


def check_refusals():
    helper("make", "in.tif", 300, 200, 3, "uint8")
    if os.path.exists("x.tx"):  # of a damaged file that was readable
        os.remove("x.tx")
    refused(2, "no INPUT")
    refused(2, "no OUTPUT", "in.tif")
    refused(2, "2 inputs: -o must be a folder, which ends in /", "in.tif", "b.tif", "-o", "x.tx")
    refused(2, "is not a name that ends in", "in.tif", "-o", "x.png")
    refused(2, "is not a multiple of 16", "in.tif", "-o", "x.tx", "--tile", "40")
    refused(2, "is not one of", "in.tif", "-o", "x.tx", "--compression", "jpeg")
    refused(2, "is not an option", "in.tif", "-o", "x.tx", "--what", "1")
    refused(2, "did you mean --format?", "in.tif", "-o", "x.tx", "--fromat", "half")
    refused(2, "--tile needs a value: a multiple of 16", "in.tif", "-o", "x.tx", "--tile")
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
    checks = [check_formats, check_same_file, check_part, check_damage, check_links, check_hostile, check_refusals]
    if not SANITIZED:
        checks += [check_memory, check_kills, check_decoder, check_false_decoder]
    for check in checks:
        start = time.monotonic()
        check()
        print(f"{check.__name__}: {time.monotonic() - start:.1f} s")
    assert "shd-maketx 0" in done("--version").stdout and "Usage:" in done("--help").stdout
    print("shd-maketx: all checks passed")


main()
