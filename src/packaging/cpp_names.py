# SPDX-License-Identifier: MIT
"""Names that a C++ source declares at namespace scope, and their replacement.

This reads declarations in the style of this project; it is no parser of all of C++. A name that it misses clashes
when the joined file is compiled, so a mistake cannot stay unseen.
"""
import re

TOKEN = re.compile(
    r"""(?P<comment>//[^\n]*|/\*.*?\*/)"""
    r"""|(?P<line>^[ \t]*\#(?:\\\n|[^\n])*)"""
    r"""|(?P<text>R"(?P<mark>\w*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\])+')"""
    r"""|(?P<word>[A-Za-z_]\w*)|(?P<number>\.?[0-9](?:[\w.']|(?<=[eEpP])[+-])*)"""
    r"""|(?P<sign>::|->|\S)""", re.S | re.M)
OPEN, CLOSE = {"(": ")", "[": "]", "{": "}"}, {")", "]", "}"}
CALLS = {"__attribute__", "alignas", "decltype", "noexcept"}
KEYS = {"static", "inline", "constexpr", "const", "extern", "HWY_INLINE", "HWY_NOINLINE", "HWY_API", "HWY_MAYBE_UNUSED",
        "SHD_KERNEL_PART", "unsigned", "volatile", "thread_local", "class", "struct"}


def tokens(text):
    """The words, numbers, strings and signs of the code."""
    return [m.group() for m in TOKEN.finditer(text) if m.lastgroup not in ("comment", "line")]


def is_word(token):
    return re.fullmatch(r"[A-Za-z_]\w*", token) is not None


def skip_pair(items, i):
    """The index after the bracket that closes items[i]."""
    depth = 0
    while i < len(items):
        depth += (items[i] in OPEN) - (items[i] in CLOSE)
        i += 1
        if depth == 0:
            break
    return i


def skip_angles(items, i):
    """The index after the > that closes items[i] = <."""
    depth = 0
    while i < len(items):
        if items[i] in OPEN:
            i = skip_pair(items, i)
            continue
        depth += (items[i] == "<") - (items[i] == ">")
        i += 1
        if depth == 0:
            break
    return i


def enumerators(body):
    """Constants of an enum without a scope: the words after { and after each comma outside brackets."""
    i = 1
    while i < len(body) - 1:
        yield body[i]
        while i < len(body) - 1 and body[i] != ",":
            i = skip_pair(body, i) if body[i] in OPEN else i + 1
        i += 1


def names_of_type(items):
    """struct, class, union or enum at the start of a statement."""
    i = 1
    scoped = items[1] in ("class", "struct")
    i += scoped
    while items[i] in CALLS:
        i = skip_pair(items, i + 1)
    if is_word(items[i]) and items[i] != "final":
        yield items[i]
    if items[0] == "enum" and not scoped and "{" in items:
        start = items.index("{")
        yield from enumerators(items[start:skip_pair(items, start)])


def names_of_value(items):
    """A function, or variables separated by commas."""
    i, seen = 0, 0
    while i < len(items):
        token = items[i]
        if token in CALLS and i + 1 < len(items) and items[i + 1] == "(":
            i = skip_pair(items, i + 1)
        elif token == "[" and items[i + 1] == "[":
            i = skip_pair(items, i)
        elif token == "<" and i and is_word(items[i - 1]):
            i = skip_angles(items, i)
        elif token in ("(", "=", "[", "{", ","):
            # A name follows a type; a macro call such as HWY_EXPORT(name) and a qualified name do not count.
            name = items[i - 1]
            if seen > 0 and is_word(name) and name != "operator" and items[i - 2] not in ("::", ".", "->"):
                yield name
            if token == "(" and seen:
                return
            while i < len(items) and items[i] != ",":
                i = skip_pair(items, i) if items[i] in OPEN else i + 1
            i += 1
        else:
            seen += token not in KEYS and i > 0
            i += 1
    if items and seen and is_word(items[-1]) and items[-1] not in ("const", "noexcept", "override"):
        yield items[-1]


def names_of(items):
    """The names that one statement at namespace scope declares."""
    while items and items[0] in ("template", "[") or items[:1] == ["HWY_ATTR"]:
        if items[0] == "template":
            if items[1] != "<":
                return  # an explicit instantiation
            items = items[skip_angles(items, 1):]
        else:
            items = items[skip_pair(items, 0):] if items[0] == "[" else items[1:]
    if not items or items[0] in ("static_assert", "namespace", "friend"):
        return
    if items[0] == "using":
        if len(items) > 2 and items[2] == "=":
            yield items[1]
    elif items[0] == "typedef":
        yield items[-1]
    elif items[0] in ("struct", "class", "union", "enum"):
        yield from names_of_type(items)
    else:
        yield from names_of_value(items)


def is_function(items):
    """Whether a { that follows these tokens opens the body of a function."""
    if items and items[0] == "template":
        items = items[skip_angles(items, 1):]
    return "(" in items and "=" not in items and items[0] not in ("struct", "class", "union", "enum")


def declarations(text):
    """(namespace, is_internal, name) of each declaration at namespace scope; unnamed namespaces are left out."""
    items, scopes, statement, i = tokens(text), [], [], 0

    def declared():
        internal = "" in sum(scopes, []) or "static" in statement[:3]
        namespace = tuple(part for part in sum(scopes, []) if part)
        return [(namespace, internal, name) for name in names_of(statement)]

    while i < len(items):
        token = items[i]
        if token == "{" and "namespace" in statement[:2]:
            path = [word for word in statement if is_word(word) and word not in ("namespace", "inline")]
            scopes.append(path or [""])
        elif token == "{" and statement[:1] == ["extern"] and len(statement) == 2:
            scopes.append([])
        elif token == "{":
            end = skip_pair(items, i)
            function = is_function(statement)
            statement += items[i:end]
            i = end
            if function:
                yield from declared()
                statement = []
            continue
        elif token == "}":
            scopes.pop()
        elif token == ";":
            yield from declared()
        else:
            statement.append(token)
            i += 1
            continue
        statement = []
        i += 1


def rename(text, new_names):
    """The text with names replaced, except members and qualified names, comments and strings."""
    if not new_names:
        return text
    out, last, previous = [], 0, ""
    for match in TOKEN.finditer(text):
        kind, token = match.lastgroup, match.group()
        if kind == "line" and not re.match(r"\s*#\s*include", token):
            body = re.sub(r"(?<![\w.\"'])[A-Za-z_]\w*", lambda m: new_names.get(m.group(), m.group()), token)
            out += [text[last:match.start()], body]
            last = match.end()
        elif kind == "word" and token in new_names and previous not in (".", "->", "::"):
            out += [text[last:match.start()], new_names[token]]
            last = match.end()
        if kind not in ("comment", "line"):
            previous = token
    return "".join(out) + text[last:]
