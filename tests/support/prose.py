# SPDX-License-Identifier: MIT
"""Comments in plain English: patterns that a script can find, and the samples that prove each pattern works.

A rule names what to write instead. Code in backticks and quoted titles are not prose and are skipped.
"""
import re

# Folders and files that are checked. A folder includes its subfolders; Markdown outside docs/ is listed file by file.
FOLDERS = [".github/CONTRIBUTING.md", ".github/SECURITY.md", "CHANGELOG.md", "README.md", "bench", "bindings", "docs",
           "examples", "include", "src", "tests"]
SUFFIXES = {".c", ".cpp", ".h", ".hpp", ".inc", ".py", ".sh", ".cmake", ".txt", ".md"}
MARKS = {".py": "#", ".sh": "#", ".cmake": "#", ".txt": "#"}

# Words after a pronoun without a noun.
NO_NOUN = (r"(?:of|in|at|on|with|without|that|which|whose|after|before|behind|beyond|below|above|for|to|from|by|when|"
           r"if|where|while|is|are|was|were|has|have|do|does|can|may|must|will|would|times|plus|and|or|but|as|alone|"
           r"holds|goes|come|comes|go)\b")
GREATER = r"(?:more|less|better|worse|higher|lower|larger|smaller|longer|shorter|nearer|farther|closer|earlier|later)"
PERSON = r"(?:callers?|hosts?|users?|readers?|authors?|people|programmers?|maintainers?|reviewers?|who|you|we)"

# rule -> (pattern, what to write). Patterns that begin with ^ are matched against each sentence.
RULES = {
    "headless": (r"^(?:Of|Likewise)\b|^(?:That|Those|These|The same)(?= " + NO_NOUN + r"|[,.;:]|$)",
                 "begin with the noun"),
    "question": (r"^(?:What|How|Which)\b(?!.*\?)", "name the thing instead of a question about it"),
    "verb": (r"\b(?:knows?|tells?|told|wants?|wish|wishes|says?|said|asks|sees|thinks)\b",
             "objects do not know, tell, want, say, ask or see"),
    "by_for": (r"\b(?:goes? by|went by|going by|stands? for|stood for)\b", "use: is determined by, means, represents"),
    "except": (r"\bbut for\b", "use: except"),
    "negation": (r"\b(?:has|have|had) (?:it|them|one|none|any) not\b", "use: has no"),
    "inversion": (r"^(?:Were|Had|Should) (?:there|it|they|this|these|all|one|any|the|a|an)\b", "use: if"),
    "goes": (r"\bas \w+(?: as)?(?: \w+)? goes?\b", "state the limit"),
    "time": (r"\bat a time\b", "use: concurrently, one by one, or per step"),
    "alike": (r"\ball alike\b", "use: equal, uniform"),
    "comparative": (r"\b[Tt]he " + GREATER + r"(?: the|[^.;:]*, the) " + GREATER + r"\b", "state the order"),
    "iff": (r"\biff\b", "use: if and only if"),
    "whatever": (r"\b[Ww]h(?:at|ich|o|ere)ever\b|\bhowever (?:many|much|large|small)\b", "use: for any, even if"),
    "which_one": (r"\bthe ones? (?:before|after)\b|\bthat many\b", "name the thing or the number"),
}
PERSON_BEFORE = re.compile(r"\b" + PERSON + r"(?: \w+){0,3}$", re.IGNORECASE)

BAD = [
    ("headless", "Of colours `stride` floats apart."),
    ("headless", "Clears them. Likewise for depth."),
    ("headless", "That of the light."),
    ("headless", "Those after depth are the values of the latest fragment."),
    ("headless", "These are read by kernels."),
    ("headless", "The same with a program in between."),
    ("headless", "The same."),
    ("headless", "of the latest row"),
    ("question", "What facets may be steeper than their normals say"),
    ("question", "How far the draws are spent."),
    ("question", "Which limits a vertex lies beyond."),
    ("verb", "0 = it knows no lights"),
    ("verb", "what hides the others must not tell"),
    ("verb", "length as the weighting wants it"),
    ("verb", "A triangle as its edges sees it."),
    ("by_for", "what alpha drops goes by colour's a"),
    ("by_for", "vertices that stand for all at their place"),
    ("except", "All lanes but for the last one."),
    ("negation", "NULL if the framebuffer has them not"),
    ("inversion", "Were there none, then all would lie on this side."),
    ("goes", "up is as near to the wanted one as it goes"),
    ("goes", "As the table goes, so as speed goes."),
    ("time", "Threads load several tiles at a time."),
    ("alike", "in [0, 1), all alike"),
    ("comparative", "the better the higher; what is unseen lies outside"),
    ("comparative", "the longer the list, the later it ends"),
    ("iff", "Set iff the triangle covers a sample."),
    ("whatever", "Corners are merged, whatever their vertices."),
    ("whatever", "The bits are the same however many workers run."),
    ("which_one", "The finer level is the one before."),
    ("which_one", "Each draw as instances, against that many draws."),
]
GOOD = [
    "These functions use libm, which determines their last bits.",
    "The same transform with a program of the caller in between.",
    "Those lights are culled. That sum is exact.",
    "What is a lobe?",
    "The host says so; the caller of a kernel knows its count.",
    "After Blinn, \"What Pixels Want\" (1998), and `iff(x)`.",
    "The number of rows, the order of columns and the smaller box.",
    "All triangles except the last one.",
    "Returns whether the slab was known.",
    "Each draw has a material; however, it may be NULL.",
    "|error| of a component <= 1e-6",
]
SNIPPET = '''const char* k = "Of strings, // Those are not checked";  // units
int x;  /* Of blocks, they are */ int y;
/// Sum of two
/// columns. Those of the light.
'''


def c_comments(text):
    """(line, text, begins_line) of every comment of C or C++."""
    token = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
    for match in token.finditer(text):
        if match.group(0)[:2] not in ("//", "/*"):
            continue
        first = text.count("\n", 0, match.start()) + 1
        begins = not text[text.rfind("\n", 0, match.start()) + 1:match.start()].strip()
        for offset, line in enumerate(match.group(0).split("\n")):
            line = re.sub(r"^\s*(?:///?<?|/\*+<?|\*(?!/))|\*+/\s*$", "", line)
            yield first + offset, line, begins or offset > 0


def marked_comments(text, mark):
    for number, line in enumerate(text.splitlines(), start=1):
        match = re.match(r"\s*" + mark + r"(?!!)(.*)", line)
        if match:
            yield number, match.group(1), True


def markdown(text):
    code = False
    for number, line in enumerate(text.splitlines(), start=1):
        code ^= line.lstrip().startswith("```")
        if not code and not line.lstrip().startswith("```"):
            yield number, line, True


def comments(text, suffix):
    if suffix == ".md":
        return markdown(text)
    return marked_comments(text, MARKS[suffix]) if suffix in MARKS else c_comments(text)


def paragraphs(lines):
    """Joins the lines of a comment: lists of (line, text). Tables, lists, tags and blank lines separate them."""
    current, last = [], -1
    for number, text, begins in lines:
        body = text.strip()
        starts = not body or re.match(r"[@#\\]|\|[ -]|[-*] |\d+\. ", body) or body.startswith("SPDX")
        if current and (number != last + 1 or starts or not begins):
            yield current
            current = []
        last = number
        if not body or body.startswith("SPDX"):
            continue
        if re.match(r"\|[ -]", body):
            for cell in body.strip("|").split("|"):
                yield [(number, cell.strip())]
            continue
        current.append((number, re.sub(r"^@param(?:\[\w+\])? \S+\s*|^@\w+\s*|^[-*#] ", "", body)))
    if current:
        yield current


def sentences(paragraph):
    """(line, text) of each sentence of a paragraph, without code and titles."""
    text = "".join(f"\0{number}\0{body} " for number, body in paragraph)
    text = re.sub(r"`[^`]*`|\"[^\"]*\"", lambda m: "Q" + "".join(re.findall(r"\0\d+\0", m.group(0))), text)
    line = paragraph[0][0]
    for part in re.split(r"(?<=[.!?])\s+(?=(?:\0\d+\0)?[A-Z\"(])", text):
        marks = re.findall(r"\0(\d+)\0", part)
        if part.startswith("\0"):
            line = int(marks[0])
        yield line, " ".join(re.sub(r"\0\d+\0", " ", part).split())
        if marks:
            line = int(marks[-1])


def find(text, suffix):
    """(line, rule, sentence) of everything that breaks a rule."""
    for paragraph in paragraphs(comments(text, suffix)):
        for i, (line, sentence) in enumerate(sentences(paragraph)):
            if i == 0:
                sentence = sentence[:1].upper() + sentence[1:]  # notes after code begin in lower case
            for rule, (pattern, _) in RULES.items():
                for match in re.finditer(pattern, sentence):
                    if rule == "verb" and PERSON_BEFORE.search(sentence[:match.start()].rstrip()):
                        continue
                    yield line, rule, sentence
                    break


def self_test():
    """What is wrong with the rules themselves; a check that cannot fail is no check."""
    for rule, text in BAD:
        if rule not in [found for _, found, _ in find("// " + text, ".h")]:
            yield f"prose.{rule} does not find: {text}"
    for text in GOOD:
        for _, rule, _ in find("// " + text, ".h"):
            yield f"prose.{rule} finds a good sentence: {text}"
    for rule in set(RULES) - {rule for rule, _ in BAD}:
        yield f"prose.{rule} has no sample"
    if [line for line, _, _ in find(SNIPPET, ".h")] != [2, 4]:
        yield f"prose finds {list(find(SNIPPET, '.h'))} in the snippet"
    if [line for line, _, _ in find("x = 1\n# Of a list.\n", ".py")] != [2]:
        yield "prose does not read # comments"
    if [line for line, _, _ in find("A list.\n\n```\n// Of code\n```\nOf a page.\n", ".md")] != [6]:
        yield "prose does not read Markdown"


def check(root):
    yield from self_test()
    for folder in FOLDERS:
        base = root / folder
        files = [base] if base.is_file() else sorted(p for p in base.rglob("*") if p.suffix in SUFFIXES - {".md"} or folder == "docs" and p.suffix == ".md")
        if not any(True for path in files for _ in comments(path.read_text(encoding="utf-8"), path.suffix)):
            yield f"{folder}: no comments to check"
        for path in files:
            for line, rule, sentence in find(path.read_text(encoding="utf-8"), path.suffix):
                yield f"{path.relative_to(root)}:{line}: {rule} ({RULES[rule][1]}): {sentence[:100]}"
