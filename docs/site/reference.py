# SPDX-License-Identifier: MIT
"""The C interface for the manual: bindings/shd.json, which has every comment, and the tags of Doxygen, which have places."""
import json
import re
import xml.etree.ElementTree

FOLDER = "c"  # of the reference in the site
LIBRARIES = {"shd": "libshd", "shd_color": "libshd_color", "shd_io": "libshd_io", "shd_scene": "libshd_scene",
             "shd_embree": "libshd_embree"}


def read_description(path):
    return json.loads(path.read_text(encoding="utf-8"))


def read_places(tags):
    """Addresses in the site of headers, functions, structs, enumerations and constants, by their names."""
    places = {}
    for compound in xml.etree.ElementTree.parse(tags).getroot().iter("compound"):
        page = f"{FOLDER}/{compound.findtext('filename')}"
        page += "" if page.endswith(".html") else ".html"
        if compound.get("kind") == "struct":
            places[compound.findtext("name")] = page
        if compound.get("kind") != "file":
            continue
        places[f"shd/{compound.findtext('name')}"] = page
        for member in compound.iter("member"):
            place = f"{FOLDER}/{member.findtext('anchorfile')}#{member.findtext('anchor')}"
            places.setdefault(member.findtext("name"), place)
    return places


def plain(doc):
    """The text of a comment without commands of Doxygen and code."""
    doc = re.sub(r"@code.*?@endcode", "", doc, flags=re.S)
    doc = re.sub(r"^\* @brief |@(?:par|ref|page \w+|brief|p|c|note|see|f\$) ?", "", doc, flags=re.M)
    return re.sub(r"\s+", " ", doc).strip()


def first_sentence(text):
    """The first sentence of a text, or its first part before a colon or a semicolon."""
    return re.split(r"(?<=[.:;])\s", re.sub(r"\s+", " ", text).strip(), maxsplit=1)[0].rstrip(":;")


def brief(doc):
    """The first sentence of a comment of a header."""
    return first_sentence(plain(doc.split("\n\n")[0]))


def headers_by_library(description):
    """Pairs of a library's name and its headers, in the order of LIBRARIES."""
    for library, title in LIBRARIES.items():
        headers = [header for header in description["headers"] if header["library"] == library]
        yield title, sorted(headers, key=lambda header: header["name"])


def of_header(description, kind, header):
    return [item for item in description[kind] if item["header"] == header["name"]]


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def rows(items, places):
    for item in items:
        name = item["name"]
        if name in places:
            yield f"| [`{name}`]({places[name]}) | {cell(brief(item.get('doc', '')))} |"


def page(description, places):
    """The page of the C interface: every function and struct with a line and a link, header by header."""
    yield "# C\n"
    yield f"[The reference of the headers]({FOLDER}/index.html) has every function, struct, field and constant with its"
    yield "units, ranges and errors. This page lists all functions and structs, header by header. Every name here and in the"
    yield "other pages of this manual is a link to its place there, and the search finds it there.\n"
    yield "`shd/shd.h` includes all headers of libshd; [Build](build.md#libraries-and-packages) has the libraries, and the"
    yield "[cheat sheet](cheatsheet.html) one page to print.\n"
    for library, headers in headers_by_library(description):
        for header in headers:
            functions = of_header(description, "functions", header)
            structs = of_header(description, "structs", header)
            handles = of_header(description, "handles", header)
            if not functions and not structs:
                continue
            name = f"shd/{header['name']}.h"
            yield f"\n## {name}\n"
            yield f"{plain(header['doc'].split(chr(10) * 2)[0])} Library: {library}; [the header]({places[name]}).\n"
            yield "| name | purpose |\n|---|---|"
            functions.sort(key=lambda function: "library" not in function or function["library"] == "inline")
            yield from rows([*handles, *functions, *structs], places)


def search_entries(description, places):
    """Entries of the search for headers, functions, structs and enumerations. Each leads to the reference itself."""
    for _, headers in headers_by_library(description):
        for header in headers:
            name = f"shd/{header['name']}.h"
            yield {"location": places[name], "title": name, "text": plain(header["doc"].split("\n\n")[0])}
            yield from entries_of_header(description, places, header)


def entries_of_header(description, places, header):
    for function in of_header(description, "functions", header):
        parameters = " ".join(parameter["name"] for parameter in function["parameters"])
        yield entry(places, function["name"], f"{plain(function['doc'])} {parameters}")
    for struct in of_header(description, "structs", header):
        fields = " ".join(field["name"] for field in struct["fields"])
        yield entry(places, struct["name"], f"{plain(struct['doc'])} {fields}")
    for enum in of_header(description, "enums", header):
        constants = " ".join(constant["name"] for constant in enum["constants"])
        yield entry(places, enum["name"], f"{plain(enum['doc'])} {constants}")


def entry(places, name, text):
    """The search folds places of one page into one result. The name as a query keeps them apart; reference.js finds it."""
    page, is_part, _ = places[name].partition("#")
    return {"location": f"{page}?{name}" if is_part else page, "title": name, "text": text}


def pages_of_headers(pages):
    """Titles and addresses of the pages that name each header, for links from the reference. `pages`: texts by names."""
    found = {}
    for name, text in sorted(pages.items()):
        title = re.search(r"^# (.*)$", text, re.M)[1]
        for header in sorted(set(re.findall(r"(?<![\w/])shd/(\w+\.h)\b", text))):
            found.setdefault(header, []).append([title, f"../{name}.html"])
    return found
