# SPDX-License-Identifier: MIT
"""The native layer: enums, structs with the layout of C, delegates, functions and handles."""
from cs_types import camel, lower

ARGUMENT_LETTERS = "XYZW"


def field_name(field):
    return camel(field["name"])


def stored_name(field):
    """Name of the field in memory: a size_t is private, behind a property of type long."""
    return lower(field["name"]).lstrip("@") + "Word" if is_size(field) else field_name(field)


def is_size(field):
    return field["type"] == "size_t" and "array" not in field


class Native:
    def __init__(self, types):
        self.types = types

    def enums(self):
        for entry in self.types.table["enums"]:
            name = self.types.enums[entry["name"]]
            is_flags = entry["name"] in self.types.flags
            yield from self.types.comment(entry.get("doc"), "    ")
            yield from ["    [Flags]"] * is_flags
            yield f"    public enum {name}{' : uint' if is_flags else ''}"
            yield "    {"
            for constant in entry["constants"]:
                if not constant["name"].endswith("_MAX_ENUM"):
                    yield from self.types.comment(constant.get("doc"), "        ")
                    yield f"        {self.types.constant(entry, constant)} = {constant['value']},"
            yield from ["    }", ""]

    def constants(self):
        yield from ["    /// <summary>Limits of the library, and the version of its headers.</summary>",
                    "    public static class Constants", "    {"]
        for entry in self.types.table["constants"]:
            yield from self.types.comment(entry.get("doc") or "Part of the version of the headers.", "        ")
            yield f"        public const int {camel(entry['name'].removeprefix('SHD_'))} = {entry['value']};"
        yield from ["    }", ""]

    def struct(self, entry):
        name = camel(entry["name"])
        yield from self.types.comment(entry.get("doc"), "    ")
        yield "    [StructLayout(LayoutKind.Sequential)]"
        yield f"    public unsafe struct {name}"
        yield "    {"
        for field in entry["fields"]:
            yield from self.types.comment(field.get("doc"), "        ")
            if is_size(field):
                stored, shown = stored_name(field), field_name(field)
                yield (f"        public long {shown} {{ get {{ return (long){stored}; }} "
                       f"set {{ {stored} = (UIntPtr)checked((ulong)value); }} }}")
                yield f"        private UIntPtr {stored};"
            else:
                yield f"        public {self.types.field_type(field)} {field_name(field)};"
        if entry.get("desc_kind"):
            yield from self.default(entry, name)
        yield from ["    }", ""]

    def default(self, entry, name):
        kind = self.types.words[entry["desc_kind"]]
        yield from ["", "        /// <summary>The defaults of the library.</summary>",
                    f"        public static {name} Default", "        {", "            get", "            {",
                    f"                {name} made;",
                    f"                ShdException.Check(Native.LibShd.DescInit({kind}, &made, "
                    f"(UIntPtr)sizeof({name})));",
                    "                return made;", "            }", "        }"]

    def structs(self, plain):
        for entry in self.types.table["structs"]:
            if (entry["name"] in self.types.plain) == plain:
                yield from self.struct(entry)

    def inline_arrays(self, native):
        """Arrays inside structs; those of pointers and columns are native."""
        for name, (element, dims) in sorted(self.types.inline.items()):
            if (element.endswith("*") or element.endswith("In") or element.endswith("Out")) == native:
                yield from self.inline_array(name, element, dims)

    def inline_array(self, name, element, dims):
        total = 1
        for n in dims:
            total *= n
        shown = total <= 4 and element in ("float", "uint", "int")
        names = list(ARGUMENT_LETTERS[:total]) if shown else [f"e{i}" for i in range(total)]
        yield f"    /// <summary>{' x '.join(map(str, dims))} elements inside a struct.</summary>"
        yield "    [StructLayout(LayoutKind.Sequential)]"
        yield f"    public unsafe partial struct {name}"
        yield "    {"
        yield f"        public const int Length = {total};"
        for i in range(0, total, 8):
            yield f"        {'public' if shown else 'private'} {element} {', '.join(names[i:i + 8])};"
        if shown:
            arguments = ", ".join(f"{element} {n.lower()}" for n in names)
            yield f"        public {name}({arguments})"
            yield f"        {{ {' '.join(f'{n} = {n.lower()};' for n in names)} }}"
        yield f"        /// <summary>Element 0 .. {total - 1}.</summary>"
        yield f"        public {element} this[int index]"
        yield "        {"
        for accessor, action in (("get", "return first[index];"), ("set", "first[index] = value;")):
            yield (f"            {accessor} {{ Inline.Check(index, Length); "
                   f"fixed ({element}* first = &{names[0]}) {action} }}")
        yield "        }"
        if len(dims) == 2:
            yield f"        public {element} this[int row, int column]"
            yield "        {"
            yield f"            get {{ Inline.Check(column, {dims[1]}); return this[row * {dims[1]} + column]; }}"
            yield f"            set {{ Inline.Check(column, {dims[1]}); this[row * {dims[1]} + column] = value; }}"
            yield "        }"
        yield from ["    }", ""]

    def delegates(self):
        for entry in self.types.table["callbacks"]:
            yield from self.types.comment(entry.get("doc") or f"Type of {entry['name']}.", "    ")
            yield "    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]"
            parameters = ", ".join(self.parameter(p) for p in entry["parameters"])
            name = camel(entry["name"]).removesuffix("Fn") + "Fn"
            yield f"    public unsafe delegate {self.types.type_of(entry['result'])} {name}({parameters});"
            yield ""

    def parameter(self, parameter):
        return f"{self.types.type_of(parameter['type'])} {lower(parameter['name'])}"

    def functions(self, library):
        cls = camel("lib_" + library)
        name = library.removeprefix("shd_") if library != "shd" else "the core"
        yield f"    /// <summary>Functions of {library}, as in C.</summary>"
        yield f"    public static unsafe class {cls}"
        yield "    {"
        yield "#if NET5_0_OR_GREATER"
        yield f"        static {cls}() {{ Library.SetResolver(); }}"
        yield "#endif"
        yield ""
        for entry in self.types.table["functions"]:
            if entry.get("library") != library:
                continue
            yield from self.types.comment(entry.get("doc"), "        ")
            yield (f'        [DllImport("{library}", EntryPoint = "{entry["name"]}", '
                   "CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]")
            parameters = ", ".join(map(self.parameter, entry["parameters"]))
            line = f"        public static extern {self.types.type_of(entry['result'])} {camel(entry['name'])}("
            yield line + (parameters if len(line + parameters) < 118 else "\n            " + parameters) + ");"
            yield ""
        yield from ["    }", ""]

    def libraries(self):
        return sorted({f["library"] for f in self.types.table["functions"] if f.get("library")})

    def safe_handles(self):
        for handle in self.types.table["handles"]:
            release = self.types.functions[handle["release"]]
            if len(release["parameters"]) != 1:
                continue  # objects of extensions have a type that the extension chose
            name = camel(handle["name"]) + "Handle"
            yield f"    /// <summary>One reference to: {handle['doc'].rstrip('.')}.</summary>"
            yield f"    internal sealed class {name} : ObjectHandle"
            yield "    {"
            yield (f"        protected override void Drop(IntPtr reference) "
                   f"{{ Native.{camel('lib_' + release['library'])}.{camel(release['name'])}(reference); }}")
            yield from ["    }", ""]

    def layout(self):
        """Size of each struct and offset of each field on 64-bit machines, for the test."""
        for entry in self.types.table["structs"]:
            space = "Shd" if entry["name"] in self.types.plain else "Shd.Native"
            yield f"struct {space}.{camel(entry['name'])} {entry['size']}"
            yield from (f"field {stored_name(f)} {f['offset']}" for f in entry["fields"])
