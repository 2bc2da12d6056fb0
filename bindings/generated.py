# SPDX-License-Identifier: MIT
"""The description of the API, and the files that are generated from it."""
import json
import os
import pathlib
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def description():
    """The content of shd.json."""
    return json.loads((HERE / "shd.json").read_text(encoding="utf-8"))


def is_current(path, text):
    return path.exists() and path.read_text(encoding="utf-8") == text


def save(path, text):
    """Writes a file, which two builds may do at once. A file that is current only gets a new time, for make and ninja."""
    if is_current(path, text):
        os.utime(path)
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=path.parent, encoding="utf-8", delete=False) as file:
        file.write(text)
    os.chmod(file.name, 0o644)
    os.replace(file.name, path)


def save_all(folder, texts):
    """Writes the files of a binding: a dictionary from names to texts."""
    for name, text in texts.items():
        save(folder / name, text)


def keep(path, text, check):
    """Writes a file that is in git; with `check`, compares it instead. Returns the exit code, 1 if it is not current."""
    if not check:
        save(path, text)
    elif not is_current(path, text):
        print(f"bindings/{path.relative_to(HERE)} is not current. Run tests/abi/update.sh")
        return 1
    print(f"{path.name}: {len(text.encode())} bytes")
    return 0
