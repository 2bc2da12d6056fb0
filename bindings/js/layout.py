# SPDX-License-Identifier: MIT
"""The API of libshd as WebAssembly has it: sizes and offsets with pointers of four bytes, and names of JavaScript.

A type is packed into a word that lib/layout.js reads:

    f32 f64 u8 u16 u32 i32 u64        numbers; size_t is u32
    enum:filter flags:aov             constants by name
    struct:view                       a nested struct
    column:f32:in                     shd_f32_in: an address and a stride
    function:fragment_fn              the address of a function
    text handle:mesh handles:light    pointers to text, to an object, to addresses of objects
    data:f32 list:draw numbers:cubic  pointers to numbers, to structs, to constants
    bytes size                        parameters: the bytes of a file, and their number
    address                           any other pointer
"""
import re

SIZES = {"float": 4, "double": 8, "size_t": 4, "int32_t": 4, "uint8_t": 1, "uint16_t": 2, "uint32_t": 4, "uint64_t": 8,
         "int": 4, "char": 1, "int64_t": 8}
NUMBERS = {"float": "f32", "double": "f64", "size_t": "u32", "int32_t": "i32", "int": "i32", "uint8_t": "u8",
           "uint16_t": "u16", "uint32_t": "u32", "uint64_t": "u64", "char": "u8"}
# Lengths of numbers that functions read or write through a pointer.
LENGTHS = {"matrix": 16, "a": 16, "b": 16, "out_matrix": 16, "out_3x3": 9, "rotation": 4, "rectangle": 4}
VECTORS = {"bounds_min", "bounds_max", "eye", "target", "up", "translation", "scale", "point", "direction", "out_point",
           "out_direction"}

# Parts of the module: the library, and the readers of images and models, whose files are bytes in memory.
LIBRARIES = {"core": {"shd"}, "models": {"shd_io", "shd_scene"}}
# Structs and fields for files on disk, for a process of its own, and for OpenVDB.
NEED_FILES = {"shd_save_desc", "shd_file_attribute", "shd_file_channel", "shd_ktx2_desc", "shd_stack_desc",
              "shd_vdb_desc", "shd_vdb_info"}
FIELDS_OF_FILES = {"worker_path"}


def short(name):
    return name.removeprefix("shd_")


def camel(name):
    """max_anisotropy -> maxAnisotropy."""
    head, *rest = name.split("_")
    return head + "".join(part.capitalize() for part in rest)


def base_of(text):
    return re.sub(r"const|\*", "", text).split("(")[0].strip()


def part_of(function):
    """The part of the module that has a function, or None."""
    if any(p["name"] == "path" for p in function["parameters"]):
        return None
    return next((part for part, libraries in LIBRARIES.items() if function.get("library") in libraries), None)


class Api:
    """The parts of shd.json that the module has, laid out for 32-bit addresses."""

    def __init__(self, table):
        libraries = set.union(*LIBRARIES.values())
        headers = {h["name"] for h in table["headers"] if h["library"] in libraries and h["name"] != "tile_file"}
        keep = lambda entries: {e["name"]: e for e in entries if e["header"] in headers}
        self.typedefs, self.enums = keep(table["typedefs"]), keep(table["enums"])
        self.structs, self.handles = keep(table["structs"]), keep(table["handles"])
        self.callbacks = keep(table["callbacks"])
        self.functions = {f["name"]: f for f in table["functions"] if part_of(f)}
        kinds = {c["name"]: c["value"] for c in self.enums["shd_desc_kind"]["constants"]}
        self.bits = {t["name"]: t["bits_of"] for t in self.typedefs.values() if "bits_of" in t}
        for struct in self.structs.values():
            struct["kind"] = kinds.get(struct.get("desc_kind"), 0)
            self.lay_out(struct)
        for name in NEED_FILES:
            del self.structs[name]
        for struct in self.structs.values():
            struct["fields"] = [f for f in struct["fields"]
                                if base_of(f["type"]) not in NEED_FILES and f["name"] not in FIELDS_OF_FILES]

    def size_and_alignment(self, text):
        text = text.removeprefix("const ")
        if "*" in text or text in self.callbacks:
            return 4, 4
        if text in self.structs:
            if "laid_out" not in self.structs[text]:
                self.lay_out(self.structs[text])
            return self.structs[text]["size"], self.structs[text]["alignment"]
        if text in self.typedefs:
            return self.size_and_alignment(self.typedefs[text]["type"])
        size = 4 if text in self.enums else SIZES[text]
        return size, size

    def lay_out(self, struct):
        """Offsets by the rules of C: each field is aligned to its own size, int64_t and double to eight bytes."""
        end = alignment = 0
        struct["laid_out"] = True
        for field in struct["fields"]:
            size, align = self.size_and_alignment(field["type"])
            for length in field.get("array", []):
                size *= length
            field["offset"], field["size"] = (end + align - 1) // align * align, size
            end, alignment = field["offset"] + size, max(alignment, align)
        struct["size"], struct["alignment"] = (end + alignment - 1) // alignment * alignment, alignment
        names = {f["name"] for f in struct["fields"]}
        for field in struct["fields"]:
            field["js"] = camel(field["name"])
            field["rows"] = self.rows_of(field, names)
            count = 1
            for length in field.get("array", []):
                count *= length
            field["packed"] = [field["offset"], self.packed(field["type"]), count, field["rows"]]
            while field["packed"][-1] in ("", 1) and len(field["packed"]) > 2:
                field["packed"].pop()

    def rows_of(self, field, names):
        """The field that has the length of a list or column, and the elements of a unit: a number or a field."""
        kind = self.packed(field["type"])
        length = field.get("length", [])
        if kind.startswith(("list:", "handles:", "data:", "numbers:")):
            counts = [n for n in length if n in names and n.endswith("_count")]
            if len(counts) == 2:  # level_images: [layer_count][level_count]
                return f"{camel(counts[1])}*{camel(counts[0])}"
            if counts and length[1:] and not length[1].isdigit():  # texels: [layer_count][height][width]
                return ""
            if counts:
                return camel(counts[0]) + (f"*{length[1]}" if length[1:] else "")
            counter = re.sub(r"s$", "_count", field["name"])
            return camel(counter) if counter in names and counter != field["name"] else ""
        if not kind.startswith("column:"):
            return ""
        if field["name"].startswith("indices"):
            return "indexCount" if "index_count" in names else ""
        return next((camel(n) for n in ("count", "vertex_count", "point_count") if n in names), "")

    def packed(self, text):
        """The word for a type."""
        base = base_of(text)
        column = re.match(r"shd_(f32|u32|u16)_(in|out)$", base)
        if text == "const char *":
            return "text"
        if "*" in text:
            if base in self.handles:
                return ("handles:" if text.count("*") > 1 else "handle:") + short(base)
            if text.count("*") > 1 or base in ("void", "char"):
                return "address" if base != "void" else "data:u8"
            if base in self.structs:
                return f"list:{short(base)}"
            return f"data:{NUMBERS[base]}" if base in NUMBERS else f"numbers:{short(base)}"
        if column:
            return f"column:{column[1]}:{column[2]}"
        if text in self.callbacks:
            return f"function:{short(text)}"
        if text in self.structs:
            return f"struct:{short(text)}"
        if text in self.bits:
            return f"flags:{short(self.bits[text])}"
        return f"enum:{short(text)}" if text in self.enums else NUMBERS[text]

    def member(self, entry, constant):
        """SHD_FILTER_EWA -> ewa."""
        noun = re.sub(r"_(flag|target)$", "", short(entry["name"])).upper()
        return constant["name"].removeprefix(f"SHD_{noun}_").removeprefix("SHD_").lower()

    def enum_values(self, entry):
        return {self.member(entry, c): c["value"] for c in entry["constants"] if not c["name"].endswith("_MAX_ENUM")}

    def packed_callback(self, index, entry):
        return [index, entry["result"],
                [[camel(p["name"]), p["type"] if p["type"] in self.callbacks else self.packed(p["type"])]
                 for p in entry["parameters"]]]

    def c_parameter(self, parameter):
        text = parameter["type"]
        return f"{text}{'' if text.endswith('*') else ' '}{parameter['name']}"

    def packed_function(self, entry):
        """Result and parameters. Parameters are in: a word, out: a word and a length, or both: a struct to be read."""
        result = entry["result"]
        return [result if result in ("void", "shd_result") else self.packed(result),
                [[camel(re.sub("^out_", "", p["name"])), *self.packed_parameter(p, entry["parameters"])]
                 for p in entry["parameters"]]]

    def packed_parameter(self, parameter, parameters):
        name, text = parameter["name"], parameter["type"]
        base = base_of(text)
        is_file = lambda p: p["name"] == "bytes" and p["type"] == "const void *" and p.get("length") == ["size"]
        if is_file(parameter):
            return ["bytes"]
        if name == "size" and any(is_file(p) for p in parameters):
            return ["size"]
        if text.endswith("**"):
            return [f"new:{short(base)}"]
        if "(*" in text or text in self.callbacks:
            return ["address"]
        if text == "float *const *" or base == "void":
            return ["address"]
        if "*" in text and base in self.structs:
            if name.startswith("out_") and not text.startswith("const"):
                return [f"read:{short(base)}"]
            return [("in:" if text.startswith("const") else "inout:") + short(base)]
        if "*" in text and base in NUMBERS and base != "char":
            length = LENGTHS.get(name, 3 if name in VECTORS else 1)
            return [("write:" if name.startswith("out") else "numbers:") + NUMBERS[base], length]
        return [self.packed(text)]
