# SPDX-License-Identifier: MIT
"""One page for each language: its part of docs/bindings.md, the README of its binding, and a reference from its sources.

A reference is a list of parts: heading, text and rows of a declaration, its comment and its function of C, if it has one.
"""
import ast
import re

import extras
import pages
import reference

# File of the page, heading in bindings.md, folder of the binding.
LANGUAGES = [("cpp", "C++", "cpp"), ("python", "Python", "python"), ("javascript", "JavaScript", "js"), ("lua", "Lua", "lua"),
             ("rust", "Rust", "rust"), ("csharp", "C sharp", "csharp")]
TITLES = {"csharp": "C\\#"}  # a mark at the end of a heading needs the backslash
LINK = re.compile(r"\[([^\]]+)\]\((?!https?:|#)([^)#]*)(#[^)]*)?\)")


def read(folder, pattern):
    return [(path, path.read_text(encoding="utf-8")) for path in sorted(folder.glob(pattern))]


def python_parts(folder, _):
    """Classes and functions of the package and its modules, with the first paragraphs of their comments."""
    exported, modules = python_names(ast.parse((folder / "shd/__init__.py").read_text(encoding="utf-8")))
    for name, module in exported.items():
        yield from python_definitions(folder / f"shd/{module}.py", "shd.", lambda found, name=name: found == name)
    for module in modules:
        if module not in exported.values():
            yield from python_module(folder / "shd" / module, exported)


def python_module(path, exported):
    """The definitions of a module that the package does not export, or of a folder of modules: those that it exports."""
    prefix, package = f"shd.{path.name}.", path / "__init__.py"
    if not package.exists():
        yield from python_definitions(path.with_suffix(".py"), prefix,
                                      lambda found: not found.startswith("_") and found not in exported)
        return
    tree = ast.parse(package.read_text(encoding="utf-8"))
    names, _ = python_names(tree)
    for source in [package, *sorted(path.glob("*.py"))[1:]]:
        yield from python_definitions(source, prefix, lambda found, source=source: not found.startswith("_") and (
            source == package or names.get(found) == source.stem))


def python_names(tree):
    """The modules that define the names of the package, and its public modules."""
    exported, modules = {}, []
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.level == 1 and node.module:
            exported.update({alias.name: node.module for alias in node.names if alias.name[0] != "_"})
        if isinstance(node, ast.Assign) and node.targets[0].id == "_modules":
            exported.update(ast.literal_eval(node.value))
        if isinstance(node, ast.Assign) and node.targets[0].id == "_submodules":
            modules = ast.literal_eval(node.value)
    return dict(sorted(exported.items())), modules


def python_definitions(path, prefix, is_wanted):
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        doc = ast.get_docstring(node) if isinstance(node, (ast.ClassDef, ast.FunctionDef)) else None
        if not doc or not is_wanted(node.name):
            continue
        members = [item for item in node.body if isinstance(item, ast.FunctionDef) and not item.name.startswith("_")]
        rows = [python_signature(item) for item in (members if isinstance(node, ast.ClassDef) else [node])]
        yield prefix + node.name, doc.split("\n\n")[0], rows


def python_signature(node):
    arguments = ast.unparse(node.args).removeprefix("self, ").removeprefix("self")
    is_property = any(isinstance(item, ast.Name) and item.id == "property" for item in node.decorator_list)
    return node.name if is_property else f"{node.name}({arguments})", ast.get_docstring(node)


def comment(text):
    """The text of a comment without its marks, tags of XML, and brackets of links in Rust."""
    lines = [line.strip().removeprefix("///").strip() for line in (text or "").splitlines()]
    text = re.sub(r"</?\w+ ?[^>]*>", "", " ".join(lines))
    return re.sub(r"\[(`[^`]+`)\](?!\()", r"\1", text)


def grouped(text, group, member):
    """Parts of a source: `group` matches a comment and the name of a type, `member` a comment and a declaration."""
    starts = list(re.finditer(group, text, re.M))
    for start, end in zip(starts, [*starts[1:], None]):
        body = text[start.end():end.start() if end else None]
        rows = [(re.sub(r"\s+", " ", match[2]).strip(), comment(match[1])) for match in re.finditer(member, body, re.M)]
        yield start[2], comment(start[1]), rows


def rust_parts(folder, _):
    group = r"((?:^/// ?.*\n)+)?(?:^#\[.*\n)*^(?:pub (?:struct|enum|trait)|impl(?:<[^>]*>)?) (\w+)"
    member = r"((?:^    /// ?.*\n)+)(?:^    #\[.*\n)*^    pub ((?:const |unsafe )*fn [\s\S]*?)(?= \{\n| \{.*\}\n|\n    where|;\n)"
    parts = {}
    for path, text in read(folder / "shd/src", "*.rs"):
        if path.stem == "descs":
            continue
        for name, doc, rows in grouped(text, group, member):
            old = parts.setdefault(name, ["", []])
            old[0] = old[0] or doc
            old[1] += rows
    return [(name, doc, rows) for name, (doc, rows) in sorted(parts.items()) if doc]


def csharp_parts(folder, _):
    group = r"((?:^    /// ?.*\n)+)?^    public [\w ]*(?:class|struct|interface) (\w+)"
    member = r"((?:^        /// ?.*\n)+)^        public ([^{;=]*)"
    for _, text in read(folder / "src", "*.cs"):
        yield from (part for part in grouped(text, group, member) if part[1])


def javascript_parts(folder, _):
    """Each exported type with its whole declaration."""
    lines = (folder / "lib/index.d.ts").read_text(encoding="utf-8").splitlines()
    above = []
    while lines:
        start = re.match(r"export (?:declare )?(?:class|interface|function|const|type) (\w+)", lines[0])
        if start:
            declaration = take_declaration(lines)
            text = " ".join(re.sub(r"^/?\*+/?|\*/$", "", line.strip()).strip() for line in above)
            yield start[1], f"{text}\n\n```ts\n{declaration}\n```", []
            above = []
        else:
            line = lines.pop(0)
            above = [*above, line] if re.match(r"/\*\*| \*", line) else []


def take_declaration(lines):
    """Removes the lines of a declaration: up to the end of its braces, or to a semicolon outside of braces."""
    taken, depth = [], 0
    while lines:
        taken.append(lines.pop(0))
        depth += taken[-1].count("{") - taken[-1].count("}")
        if depth == 0 and taken[-1].rstrip().endswith(("}", ";")):
            break
    return "\n".join(taken)


def cpp_parts(folder, functions):
    """Functions of the header that is generated, by the headers of C."""
    names = set(re.findall(r"^inline [\w:]+[*&]? (\w+)\(", (folder / "shd_api.hpp").read_text(encoding="utf-8"), re.M))
    by_header = {}
    for function in functions:
        if (name := function["name"].removeprefix("shd_")) in names:
            by_header.setdefault(function["header"], []).append((f"shd::{name}", function["doc"], function["name"]))
    return [(f"shd/{header}.h", "", rows) for header, rows in sorted(by_header.items())]


def lua_parts(_, functions):
    """Functions as methods of their first arguments, as bindings/lua/README.md has the rule."""
    by_kind = {}
    for function in functions:
        parameters = function["parameters"]
        name = function["name"].removeprefix("shd_")
        handle = re.fullmatch(r"(?:const )?shd_(\w+) \*", parameters[0]["type"]) if parameters else None
        if function.get("library", "inline") == "inline" or name.endswith(("_retain", "_release")) or not handle:
            continue
        kind = handle[1]
        if name == f"{kind}_create" or name.endswith("_create") and kind == "context":
            made = name.removesuffix("_create")
            by_kind.setdefault(made, []).insert(0, (f"shd.{made}(context, desc)", function["doc"], function["name"]))
        else:
            method = f"{kind}:{name.removeprefix(kind + '_')}(...)"
            by_kind.setdefault(kind, []).append((method, function["doc"], function["name"]))
    return [(kind, "", rows) for kind, rows in sorted(by_kind.items())]


PARTS = {"cpp": cpp_parts, "python": python_parts, "javascript": javascript_parts, "lua": lua_parts, "rust": rust_parts,
         "csharp": csharp_parts}
REMARKS = {
    "cpp": "Every function below throws `shd::error`, and has the rules of its function of C.",
    "python": "Descs and enums of all headers are attributes of the package, with the fields of [the structs of C](c.md).",
    "javascript": "Descs, enums and constants follow [the structs of C](c.md), in camelCase; `lib/api.d.ts` has each of them.",
    "lua": "Methods that follow from the functions of C. Their rules are those of C.",
    "rust": "Descs and enums follow [the structs of C](c.md).",
    "csharp": "Descs and enums follow [the structs of C](c.md), in PascalCase.",
}


def reference_lines(name, parts, places):
    yield f"## Reference\n\n{REMARKS[name]}\n"
    for heading, text, rows in parts:
        yield f"\n### {heading}\n\n{pages.convert(text, places).strip()}\n"
        if rows:
            yield "| declaration | purpose |\n|---|---|"
        for declaration, doc, *function in rows:
            place = places.get(function[0]) if function else None
            code = f"`{declaration.replace('|', chr(92) + '|')}`"
            yield f"| {f'[{code}]({place})' if place else code} | {reference.cell(reference.first_sentence(doc or ''))} |"


def readme(folder, known):
    """The README of a binding without its title, one level lower. Links to what the site lacks keep their text."""
    path = folder / "README.md"
    if not path.is_file():
        return ""
    text = re.sub(r"^# .*\n", "", path.read_text(encoding="utf-8"))
    text = "\n".join(f"#{line}" if line.startswith("##") and is_text else line
                     for line, is_text in lines_with_code(text))
    text = LINK.sub(lambda link: f"[{link[1]}]({link[2].rpartition('/')[2]}{link[3] or ''})"
                    if link[2].rpartition("/")[2] in known else link[1], text)
    return f"## The package\n\n{text.strip()}\n"


def lines_with_code(text):
    is_code = False
    for line in text.splitlines():
        is_code ^= line.startswith("```")
        yield line, not is_code


def make(root, stage, description, places):
    """Pages of languages, from the page of all of them, which loses their parts and whose links follow."""
    page = stage / "bindings.md"
    text = page.read_text(encoding="utf-8")
    known = {path.name for path in stage.glob("*.md")}
    functions = description["functions"]
    for name, heading, folder in LANGUAGES:
        start = text.find(f"\n## {heading}\n")
        end = text.find("\n## ", start + 4)
        if start < 0 or end < 0:
            raise extras.SiteError(f"bindings.md: no heading {heading}, or no heading after it")
        section = text[start:end].split("\n", 2)[2]
        title = TITLES.get(name, heading)
        text = text[:start] + f"\n## {heading}\n\n[{title}]({name}.md) has a page of its own.\n" + text[end:]
        source = root / "bindings" / folder
        lines = reference_lines(name, PARTS[name](source, functions), places)
        body = "\n".join([f"# {title}\n{section}", pages.convert(readme(source, known), places), *lines])
        (stage / f"{name}.md").write_text(body + "\n", encoding="utf-8")
    page.write_text(text, encoding="utf-8")
    for other in stage.glob("*.md"):
        old = other.read_text(encoding="utf-8")
        new = old
        for name, heading, _ in LANGUAGES:
            new = new.replace(f"](bindings.md#{pages.slug(heading)})", f"]({name}.md)")
        if new != old:
            other.write_text(new, encoding="utf-8")
