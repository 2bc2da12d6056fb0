# SPDX-License-Identifier: MIT
"""Descs with objects and arrays in place of pointers, and the spans of callbacks."""
from cs_native import field_name, is_size
from cs_types import COLUMNS, VIEWS, camel

# Fields that the partial class of src/ has.
BY_HAND = {("shd_texture_desc", "tiles"), ("shd_context_desc", "allocator"), ("shd_context_desc", "executor"),
           ("shd_context_desc", "log"),
           ("shd_texture_desc", "kind"), ("shd_texture_desc", "texels"), ("shd_texture_desc", "level_images"),
           ("shd_texture_desc", "level_count"),
           ("shd_image", "pixels"), ("shd_draw", "uniforms"), ("shd_slot", "procedure"), ("shd_slot", "user_data"),
           ("shd_material_desc", "program"), ("shd_render_desc", "stats"), ("shd_render_desc", "progress"),
           ("shd_render_desc", "present"), ("shd_save_desc", "display"), ("shd_occlusion_desc", "tracer"),
           ("shd_bake_desc", "stats"), ("shd_occlusion_atlas", "stats"), ("shd_scene_desc", "find"),
           ("shd_scene_desc", "user_data")}
# The field with the number of rows of the columns.
ROWS = {"shd_mesh_desc": "vertex_count", "shd_volume_desc": "point_count", "shd_polygon_desc": "vertex_count",
        "shd_shape_columns": "vertex_count", "shd_polyhedron_desc": "vertex_count"}
# Columns of another length, with the field that has it.
OTHER_ROWS = {("shd_mesh_desc", "indices"): "index_count", ("shd_mesh_desc", "indices16"): "index_count",
              ("shd_shape_columns", "indices"): "index_count", ("shd_polyhedron_desc", "indices"): "index_count"}
# Lists whose comments name no length.
LISTS = {("shd_occlusion_desc", "draws"): "draw_count", ("shd_shadow_render_desc", "draws"): "draw_count",
         ("shd_direction_images", "images"): None}
# A number that is set without its list, too.
SHOWN_COUNTS = {("shd_material_desc", "varying_count")}
DROPPED = {"struct_size"}


class Twin:
    """A class for one struct with pointers: `members` are its fields, `build` are the statements that fill the struct
    of C from them, `take` those that read results from it."""

    def __init__(self, types, entry):
        self.types, self.entry, self.name = types, entry, camel(entry["name"])
        self.fields = {f["name"]: f for f in entry["fields"]}
        self.members, self.build, self.take = [], [], []
        self.rows = ROWS.get(entry["name"], "count" if "count" in self.fields else None)
        self.counts = {self.rows, *(r for (s, _), r in OTHER_ROWS.items() if s == entry["name"])}
        for field in entry["fields"]:
            self.counts.add(self.length(field))
        for field in entry["fields"]:
            key = (entry["name"], field["name"])
            if field["name"] not in DROPPED and key not in BY_HAND:
                if field["name"] not in self.counts or key in SHOWN_COUNTS:
                    self.add(field)

    def length(self, field):
        """The field with the number of elements of a list; None for a pointer to one element."""
        key = (self.entry["name"], field["name"])
        if key in LISTS:
            return LISTS[key]
        words = field.get("length", [])
        return words[0] if words and words[0] in self.fields and key not in BY_HAND else None

    def add(self, field):
        base, stars = self.types.base(field["type"]), field["type"].count("*")
        if base in COLUMNS:
            self.column(field, base, stars)
        elif base in self.types.handles:
            self.handle(field, base, stars)
        elif base == "char" and stars:
            self.text(field, stars)
        elif stars:
            self.pointer(field, base)
        else:
            self.value(field)

    def member(self, field, text):
        self.members += [*self.types.comment(field.get("doc"), "        "), f"        {text}"]

    def value(self, field):
        name, kind = field_name(field), "long" if is_size(field) else self.types.field_type(field)
        self.member(field, f"public {kind} {name} {{ get {{ return Fields.{name}; }} set {{ Fields.{name} = value; }} }}")
        self.take.append(f"Fields.{name} = made.{name};")

    def set_count(self, name, value):
        """A statement that sets a field with a number of elements."""
        value = f"checked((uint)({value}))" if self.fields[name]["type"] == "uint32_t" else value
        return f"made.{camel(name)} = {value};"

    def column(self, field, base, stars):
        name, read, kind = field_name(field), camel(base), f"Column<{COLUMNS[base]}>"
        rows = "rows"
        other = OTHER_ROWS.get((self.entry["name"], field["name"]))
        if other:
            rows = f"{camel(other)[0].lower()}{camel(other)[1:]}"
            if f"long {rows} = -1;" not in self.build:
                self.build.append(f"long {rows} = -1;")
        if stars:
            self.member(field, f"public {kind}[] {name};")
            self.build.append(f"made.{name} = call.{read}s({name}, name, \"{name}\", ref {rows});")
            self.build.append(self.set_count(self.length(field), f"{name} == null ? 0 : {name}.Length"))
        elif "array" in field:
            count = field["array"][0]
            self.member(field, f"public readonly {kind}[] {name} = new {kind}[{count}];")
            self.build.append(f"for (int i = 0; i < {count}; ++i) "
                              f"made.{name}[i] = call.{read}({name}[i], name, \"{name}\", ref {rows});")
        else:
            self.member(field, f"public {kind} {name};")
            self.build.append(f"made.{name} = call.{read}({name}, name, \"{name}\", ref {rows});")
        if other:
            self.build.append(self.set_count(other, f"Math.Max({rows}, 0)"))

    def handle(self, field, base, stars):
        name, kind = field_name(field), camel(base)
        if stars == 1:
            self.member(field, f"public {kind} {name};")
            self.build.append(f"made.{name} = call.UseOrNull({name}, name, \"{name}\");")
            return
        count = self.length(field)
        self.member(field, f"public IList<{kind}> {name};")
        local = f"{camel(count)[0].lower()}{camel(count)[1:]}"
        if f"long {local} = -1;" not in self.build:
            self.build.append(f"long {local} = -1;")
        self.build.append(f"made.{name} = call.UseAll({name}, name, \"{name}\", ref {local});")
        self.build.append(self.set_count(count, f"Math.Max({local}, 0)"))

    def text(self, field, stars):
        name = field_name(field)
        if stars == 1:
            self.member(field, f"public string {name};")
            self.build.append(f"made.{name} = call.Text({name});")
            return
        self.member(field, f"public IList<string> {name};")
        self.build.append(f"made.{name} = call.Texts({name}, name, \"{name}\");")
        self.build.append(self.set_count(self.length(field), f"{name} == null ? 0 : {name}.Count"))

    def pointer(self, field, base):
        name, words = field_name(field), field.get("length", [])
        is_list = self.length(field) or (self.entry["name"], field["name"]) in LISTS
        kind = self.types.type_of(base) if base in self.types.enums else camel(base)
        if words[-1:] == ["16"]:
            self.matrices(field, name, bool(is_list))
        elif base in self.types.enums:
            self.member(field, f"public {kind}[] {name};")
            self.build.append(f"if ({name} != null) made.{name} = ({kind}*)call.Pin({name});")
            self.build.append(f"if ({name} != null) {self.set_count(self.length(field), f'{name}.Length')}")
        elif base in self.types.plain:
            self.structs(field, name, kind, is_list)
        elif is_list:
            self.member(field, f"public IList<{kind}> {name};")
            self.build.append(f"made.{name} = {kind}.BuildAll(call, Call.Join(name, \"{name}\"), {name});")
            if self.length(field):
                self.build.append(self.set_count(self.length(field), f"{name} == null ? 0 : {name}.Count"))
        else:
            self.member(field, f"public {kind} {name};")
            self.build.append(f"if ({name} != null) made.{name} = {kind}.BuildAll(call, Call.Join(name, \"{name}\"), "
                              f"new {kind}[] {{ {name} }});")

    def matrices(self, field, name, is_list):
        if not is_list:
            self.member(field, f"public Matrix4? {name};")
            self.build.append(f"if ({name}.HasValue) {{ made.{name} = (float*)call.Memory(sizeof(Matrix4)); "
                              f"*(Matrix4*)made.{name} = {name}.Value; }}")
            return
        self.member(field, f"public Matrix4[] {name};")
        self.build.append(f"made.{name} = (float*)call.Pin({name});")
        self.build.append(self.set_count(self.length(field), f"{name} == null ? 0 : {name}.Length"))

    def structs(self, field, name, kind, is_list):
        if is_list:
            self.member(field, f"public {kind}[] {name};")
            self.build.append(f"made.{name} = (global::Shd.{kind}*)call.Pin({name});")
            self.build.append(self.set_count(self.length(field), f"{name} == null ? 0 : {name}.Length"))
            return
        self.member(field, f"public {kind}? {name};")
        self.build.append(f"if ({name}.HasValue) {{ made.{name} = (global::Shd.{kind}*)call.Memory("
                          f"sizeof(global::Shd.{kind})); *made.{name} = {name}.Value; }}")

    def has_hook(self):
        return any(struct == self.entry["name"] for struct, _ in BY_HAND)

    def text_of_class(self):
        native = f"Native.{self.name}"
        initial = f"{native}.Default" if self.entry.get("desc_kind") else f"new {native}()"
        yield from self.types.comment(self.entry.get("doc"), "    ")
        yield f"    public sealed unsafe partial class {self.name}"
        yield from ["    {", f"        internal {native} Fields = {initial};", "",
                    "        /// <summary>The defaults of the library.</summary>",
                    f"        public static {self.name} Default {{ get {{ return new {self.name}(); }} }}", ""]
        yield from [*self.members, ""]
        yield "        /// <summary>The struct of C for a call. `rows` is the given length of columns, or -1.</summary>"
        yield f"        internal {native} Build(Call call, string name, long rows = -1)"
        yield "        {"
        yield f"            {native} made = Fields;"
        yield from (f"            {line}" for line in self.build)
        if self.rows:
            yield f"            {self.set_count(self.rows, 'Math.Max(rows, 0)')}"
        if self.has_hook():
            yield "            More(call, name, ref made);"
        yield from ["            return made;", "        }"]
        if self.has_hook():
            yield f"        partial void More(Call call, string name, ref {native} made);"
        yield from self.build_all(native)
        if any(COLUMNS.get(self.types.base(f["type"])) and f["type"].find("_out") > 0 for f in self.entry["fields"]):
            yield f"        internal void Take(ref {native} made) {{ {' '.join(self.take)} }}"
        yield from ["    }", ""]

    def build_all(self, native):
        yield f"        internal static {native}* BuildAll(Call call, string name, IList<{self.name}> list)"
        yield "        {"
        yield "            if (list == null || list.Count == 0) return null;"
        yield f"            {native}* all = ({native}*)call.Memory((long)list.Count * sizeof({native}));"
        yield "            for (int i = 0; i < list.Count; ++i)"
        yield "            {"
        yield "                if (list[i] == null) throw new ArgumentNullException(Call.Element(name, i));"
        yield "                all[i] = list[i].Build(call, Call.Element(name, i));"
        yield "            }"
        yield "            return all;"
        yield "        }"


class Managed:
    def __init__(self, types):
        self.types = types

    def twins(self):
        for name in self.types.twins():
            yield from Twin(self.types, self.types.structs[name]).text_of_class()

    def views(self):
        for name in VIEWS:
            yield from self.view(self.types.structs[name])

    def view(self, entry):
        """A struct of a callback. Spans end with the callback; the compiler refuses to keep a ref struct."""
        name = camel(entry["name"])
        has_count = any(f["name"] == "count" for f in entry["fields"])
        yield from self.types.comment(entry.get("doc"), "    ")
        yield f"    public readonly unsafe ref struct {name}"
        yield "    {"
        yield f"        private readonly Native.{name}* raw;"
        yield "        /// <summary>Rows.</summary>"
        yield "        public readonly int Count;"
        if has_count:
            yield f"        internal {name}(Native.{name}* from) {{ raw = from; Count = (int)from->Count; }}"
        else:
            yield f"        internal {name}(Native.{name}* from, int rows) {{ raw = from; Count = rows; }}"
        for field in entry["fields"]:
            if field["name"] not in ("struct_size", "count"):
                yield from self.types.comment(field.get("doc"), "        ")
                yield f"        {self.view_field(field)}"
        yield from ["    }", ""]

    def view_field(self, field):
        name, text, length = field_name(field), field["type"], field.get("length", [])
        if "*" not in text:
            kind = "long" if is_size(field) else self.types.type_of(text)
            return f"public {kind} {name} {{ get {{ return raw->{name}; }} }}"
        if "void" in text:
            return f"public IntPtr {name} {{ get {{ return (IntPtr)raw->{name}; }} }}"
        if length and length[0].isdigit():
            kind = {"16": "Matrix4", "3": "Float3"}[length[0]]
            return f"public {kind} {name} {{ get {{ return *({kind}*)raw->{name}; }} }}"
        is_const = text.startswith("const ")
        element = self.types.type_of(self.types.base(text))
        span = f"{'ReadOnlySpan' if is_const else 'Span'}<{element}>"
        if "(*)[4]" in text:
            column = f"Inline.Check(index, raw->{camel(length[0])}) * 4 + Inline.Check(channel, 4)"
            return (f"public {span} {name}(int index, int channel) {{ return Inline.Write<{element}>("
                    f"raw->{name} == null ? null : raw->{name}[{column}], Count); }}")
        if text.count("*") == 2:
            return (f"public {span} {name}(int index) {{ return Inline.{'Read' if is_const else 'Write'}<{element}>("
                    f"raw->{name}[Inline.Check(index, raw->{camel(length[0])})], Count); }}")
        return (f"public {span} {name} {{ get {{ return Inline.{'Read' if is_const else 'Write'}<{element}>("
                f"raw->{name}, Count); }} }}")
