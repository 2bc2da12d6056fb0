# SPDX-License-Identifier: MIT
"""Comments of the headers, and the ownership, NULL and thread words in them."""
import re

OWNERSHIP = [("copied", r"\bcopied\b"), ("borrowed until release", r"\bborrowed until release\b"),
             ("borrowed for the call", r"\bborrowed for the call\b"), ("retained", r"\bretained\b"),
             ("owned", r"\bowned\b")]
NULLABLE = re.compile(r"\bNULL\b(?: data)? (?:=|is ignored|if|with)|\bmay be NULL\b|\bdefault (?:NULL|none)\b")
LENGTH = re.compile(r"^[^.;(]*?((?:\[\w[\w /]*\])+)")


def plain(comment):
    """Text of a comment without its marks; `comment` begins after the opening mark."""
    body = comment.split("*/")[0]
    lines = [re.sub(r"^\s*\*(?!\*) ?|^\s+$", "", l) if i else l.strip() for i, l in enumerate(body.split("\n"))]
    if not any(re.match(r"\s*\*", l) for l in body.split("\n")[1:]):
        lines = [l.strip() for l in lines]
    return "\n".join(l.rstrip() for l in lines).strip()


def comment_of(text, offset, end):
    """The comment of the declaration whose name lies at `offset`: behind one of the characters of `end`, or before the
    declaration. None as `end` = before it."""
    if end:
        stop = re.compile(f"[{end}]").search(text, offset).end()
        behind = re.compile(r"[ \t]*/\*\*<").match(text, stop)
        if behind:
            return plain(text[behind.end():])
    close = text.rfind("*/", 0, offset)
    begin = text.rfind("/*", 0, close)
    if close < 0 or re.search(r"[;{}#]", text[close:offset].rsplit("struct", 1)[0]):
        return ""
    if text[begin:begin + 3] != "/**" or text[begin:begin + 4] == "/**<":
        return ""
    return plain(text[begin + 3:])


def split_tags(doc):
    """Text, parameters, return value and version of a function's comment."""
    doc = re.sub(r"(?<!^)(?<!\n)@since", "\n@since", doc)
    parts = re.split(r"^(?=@(?:param|return|since)\b)", doc, flags=re.M)
    tags = {"doc": parts[0].strip(), "parameters": {}, "returns": "", "since": ""}
    for part in parts[1:]:
        tag, rest = part.split(None, 1)
        rest = re.sub(r"\n +", "\n", rest.strip())
        if tag == "@since":
            tags["since"], _, more = rest.partition("\n")
            tags["doc"] = "\n".join(filter(None, [tags["doc"], more.strip()]))
        elif tag == "@return":
            tags["returns"] = rest
        else:
            names, _, text = rest.partition(" ")
            for name in names.split(","):
                tags["parameters"][name] = text.strip()
    return tags


def file_doc(text):
    """The comment at the head of a header, without its tags."""
    match = re.search(r"/\*\*\n \* @file\n(.*?)\*/", text, re.S)
    return re.sub(r"^@brief ", "", plain(match.group(1))) if match else ""


def ownership(doc):
    return [word for word, pattern in OWNERSHIP if re.search(pattern, doc)]


def length(doc):
    """The lengths of an array that a pointer points at: numbers, names of fields, or words."""
    match = LENGTH.match(doc)
    return re.findall(r"\[([^\]]+)\]", match.group(1)) if match else []


def mark_fields(fields, doc):
    """Which fields are required, which pointers may be NULL, and who owns what they point at."""
    match = re.search(r"Required: ([\w, ]+?)(?:, and|\.)", doc)
    required = set(re.split(r", ", match.group(1))) if match else set()
    for field in fields:
        is_pointer = "*" in field["type"]
        if field["name"] in required:
            field["required"] = True
        elif is_pointer and NULLABLE.search(field["doc"]):
            field["nullable"] = True
        if is_pointer and length(field["doc"]):
            field["length"] = length(field["doc"])
        if is_pointer and ownership(field["doc"]):
            field["ownership"] = ownership(field["doc"])


def mark_parameter(parameter, doc):
    """Direction, ownership and NULL of a parameter that is a pointer."""
    text = parameter["type"]
    if not text.endswith("*"):
        return
    is_out = parameter["name"].startswith("out")
    if not text.startswith("const ") or text.endswith("**"):
        parameter["direction"] = "out" if is_out else "inout"
    else:
        parameter["direction"] = "in"
    if NULLABLE.search(parameter["doc"]) or "NULL is ignored" in doc:
        parameter["nullable"] = True
    if length(parameter["doc"]):
        parameter["length"] = length(parameter["doc"])
    if ownership(parameter["doc"]):
        parameter["ownership"] = ownership(parameter["doc"])


def sentences(doc, pattern):
    flat = " ".join(doc.split())
    return " ".join(s for s in re.split(r"(?<=\.)\s+(?=[A-Z`])", flat) if re.search(pattern, s))


def mark_callback(entry, structs, functions, header):
    """The documented thread of a callback, the rules for it, and the lifetime of its user_data."""
    owner = entry["name"].split(".")[0]
    safety = re.search(r"^ \* Thread safety: (.*?)\n \*\n", header, re.S | re.M)
    texts = [entry["doc"], structs[owner]["doc"] if owner in structs else "",
             functions[owner].get("doc", "") if owner in functions else "",
             " ".join(re.sub(r"^ \*\s*", "", l) for l in safety.group(1).split("\n")) if safety else ""]
    for key, pattern in (("thread", r"\bthreads?\b|\bworkers?\b"), ("rules", r"\b(?:[Mm]ust not|may call|may look)\b")):
        rule = next(filter(None, (sentences(t, pattern) for t in texts)), "")
        if rule:
            entry[key] = rule
    for field in structs.get(owner, {"fields": []})["fields"]:
        if field["name"] == "user_data":
            entry["user_data"] = field["doc"]
