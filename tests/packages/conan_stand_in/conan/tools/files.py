# SPDX-License-Identifier: MIT
import fnmatch
import hashlib
import pathlib
import shutil
import tarfile
import urllib.request

from conan.errors import ConanException


def get(conanfile, url, sha256=None, strip_root=False, destination=None):
    """Downloads and unpacks an archive whose checksum is right."""
    data = urllib.request.urlopen(url).read()
    if sha256 and hashlib.sha256(data).hexdigest() != sha256:
        raise ConanException(f"sha256 of {url} is not {sha256}")
    folder = pathlib.Path(destination or conanfile.source_folder)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "archive.tar.gz"
    path.write_bytes(data)
    with tarfile.open(path) as archive:
        for member in archive.getmembers():
            if strip_root:
                member.name = member.name.partition("/")[2]
            if member.name and not member.name.startswith(("/", "..")):
                archive.extract(member, folder)
    path.unlink()


def copy(conanfile, pattern, src, dst):
    copied = [path for path in pathlib.Path(src).rglob("*")
              if path.is_file() and fnmatch.fnmatch(path.relative_to(src).as_posix(), pattern)]
    for path in copied:
        target = pathlib.Path(dst) / path.relative_to(src)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(path, target)
    return [str(path) for path in copied]


def rmdir(conanfile, path):
    shutil.rmtree(path, ignore_errors=True)
