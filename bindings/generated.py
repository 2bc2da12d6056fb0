# SPDX-License-Identifier: MIT
"""Files that are generated from the headers and checked in."""
import json
import pathlib

HERE = pathlib.Path(__file__).resolve().parent


def description():
    """The content of shd.json."""
    return json.loads((HERE / "shd.json").read_text(encoding="utf-8"))


def save(path, text, check):
    """Writes a file; with `check`, compares it instead. Returns the exit code, 1 if the file is not current."""
    if not check:
        path.write_text(text, encoding="utf-8")
    elif not path.exists() or path.read_text(encoding="utf-8") != text:
        print(f"bindings/{path.relative_to(HERE)} is not current. Run bindings/update.sh")
        return 1
    print(f"{path.name}: {len(text.encode())} bytes")
    return 0
