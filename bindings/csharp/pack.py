#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes Shd.<version>.nupkg without an SDK of .NET: pack.py FOLDER --native DIR

DIR has the built libraries, which go to runtimes/linux-x64/native under the names by which Shd.dll.config calls them.
Shd.dll is compiled by mcs of Mono for the framework 4.7.2; Mono and .NET 6 load it. Equal sources and libraries give
equal bytes. Exits with 77, as CTest skips tests, if mcs is absent (Debian: mono-mcs).
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree
import xml.sax.saxutils
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
FIRST_TIME = (1980, 1, 1, 0, 0, 0)  # of the format
CONTENT_TYPES = """<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
  <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml" />
  <Default Extension="nuspec" ContentType="application/octet" />
  <Default Extension="dll" ContentType="application/octet" />
  <Default Extension="config" ContentType="application/octet" />
  <Default Extension="md" ContentType="application/octet" />
{overrides}</Types>
"""
RELATIONS = """<?xml version="1.0" encoding="utf-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
  <Relationship Type="http://schemas.microsoft.com/packaging/2010/07/manifest" Target="/Shd.nuspec" Id="manifest" />
</Relationships>
"""
NUSPEC = """<?xml version="1.0" encoding="utf-8"?>
<package xmlns="http://schemas.microsoft.com/packaging/2013/05/nuspec.xsd">
  <metadata>
    <id>{PackageId}</id>
    <version>{Version}</version>
    <authors>The shd authors</authors>
    <license type="expression">{PackageLicenseExpression}</license>
    <readme>{PackageReadmeFile}</readme>
    <description>{Description}</description>
    <dependencies><group targetFramework=".NETFramework4.7.2" /></dependencies>
  </metadata>
</package>
"""


def project():
    """The properties of Shd.csproj."""
    tree = xml.etree.ElementTree.parse(HERE / "Shd.csproj")
    return {item.tag: item.text or "" for group in tree.iter("PropertyGroup") for item in group}


def compile_library():
    subprocess.run([sys.executable, HERE.parent / "generate.py", "csharp"], check=True)
    subprocess.run(["mcs", "@Shd.rsp"], cwd=HERE, check=True)


def native_files(folder):
    """The libraries that Shd.dll.config names, and what libshd_io and libshd_scene open."""
    names = re.findall(r'target="([^"]+)"', (HERE / "src/Shd.dll.config").read_text(encoding="utf-8"))
    files = [folder / name for name in names if (folder / name).exists()]
    if not any(path.name.startswith("libshd.so") for path in files):
        raise SystemExit(f"pack.py: {folder} has no libshd.so")
    return files + [path for path in (folder / "shd-io-worker", folder / "libshd_scene_readers.so") if path.exists()]


def contents(native):
    properties = {key: xml.sax.saxutils.escape(value) for key, value in project().items()}
    files = {f"runtimes/linux-x64/native/{path.name}": path.read_bytes() for path in native_files(native)}
    for name in ("Shd.dll", "Shd.dll.config"):
        files[f"lib/net472/{name}"] = (HERE / "src" / name).read_bytes()
    overrides = "".join(f'  <Override PartName="/{name}" ContentType="application/octet" />\n'
                        for name in sorted(files) if name.startswith("runtimes/"))
    files["README.md"] = (HERE / "README.md").read_bytes()
    files["Shd.nuspec"] = NUSPEC.format(**properties).encode()
    files["_rels/.rels"] = RELATIONS.encode()
    files["[Content_Types].xml"] = CONTENT_TYPES.format(overrides=overrides).encode()
    return f"{properties['PackageId']}.{properties['Version']}.nupkg", files


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--native", type=pathlib.Path, required=True)
    options = parser.parse_args()
    if not shutil.which("mcs"):
        print("skipped: no mcs (Debian: mono-mcs)")
        sys.exit(77)
    compile_library()
    name, files = contents(options.native)
    options.folder.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(options.folder / name, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as package:
        for path in sorted(files):
            package.writestr(zipfile.ZipInfo(path, FIRST_TIME), files[path], zipfile.ZIP_DEFLATED)


if __name__ == "__main__":
    main()
