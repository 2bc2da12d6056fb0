-- SPDX-License-Identifier: MIT
-- Values of Lua to structs of C. A struct is a table of its fields; fields that are absent have the library's defaults.
--
-- `state` belongs to one call. `keep` has the memory that must live until its end. `anchors` has what the objects that
-- it makes must keep. `rows` is the number of rows of output columns. `after` has structs that are read after it.
local ffi = require "ffi"
local array = require "shd.array"
local callback = require "shd.callback"
local enums = require "shd.enums"
local library = require "shd.native"
local object = require "shd.object"
local sizes = require "shd.sizes"
local tables = require "shd.tables"
local C, refuse = library.C, library.refuse

local convert = {}

local WRITABLE = {shd_f32_out = true, shd_u32_out = true}
local COLUMNS = {shd_f32_in = "float", shd_f32_out = "float", shd_u32_in = "uint32_t", shd_u32_out = "uint32_t",
  shd_u16_in = "uint16_t"}
local LIMITS = {uint8_t = {0, 2 ^ 8}, uint16_t = {0, 2 ^ 16}, uint32_t = {0, 2 ^ 32}, int32_t = {-2 ^ 31, 2 ^ 31},
  uint64_t = {0, 2 ^ 53}, size_t = {0, 2 ^ 53}, int = {-2 ^ 31, 2 ^ 31}}

local templates, types = {}, {}

--- A struct with the defaults of the library.
function convert.new(base)
  local entry = tables.structs[base]
  if not templates[base] then
    local template = ffi.new(base)
    if entry.desc_kind > 0 then library.check(C.shd_desc_init(entry.desc_kind, template, entry.size)) end
    templates[base], types[base] = template, ffi.typeof(base)
  end
  local made = types[base]()
  ffi.copy(made, templates[base], entry.size)
  return made
end

-- The name of a struct in errors, which is that of the library: shd_texture_desc is texture.
local function short(base) return (base:gsub("^shd_", ""):gsub("_desc$", "")) end

--- A number of a type of C.
function convert.number(value, base, label)
  if type(value) == "cdata" and (ffi.istype("uint64_t", value) or ffi.istype("int64_t", value)) then
    value = tonumber(value)
  end
  if type(value) == "boolean" and base == "uint32_t" then value = value and 1 or 0 end
  if type(value) ~= "number" then refuse("%s: a number, not %s", label, type(value)) end
  local limits = LIMITS[base]
  if limits and not (value % 1 == 0 and value >= limits[1] and value < limits[2]) then
    refuse("%s: %s is no %s", label, tostring(value), base)
  end
  return value
end

local function list(value, label)
  if type(value) ~= "table" or object.is_object(value) then refuse("%s: a list, not %s", label, type(value)) end
  return value, #value
end

-- Numbers of a field such as float[16], from a list or an array of ffi.
local function fill_numbers(target, value, field, label)
  local rows, width = unpack(field.array)
  if width then  -- a list of rows; it may be shorter than the field
    local _, count = list(value, label)
    if count > rows then refuse("%s: %d rows, not at most %d", label, count, rows) end
    for i = 1, count do
      fill_numbers(target[i - 1], value[i], {array = {width}, nil, nil, field[3]}, ("%s[%d]"):format(label, i))
    end
    return
  end
  local first = 1
  if type(value) == "cdata" then
    local _, _, count = array.elements(value, field[3], false, label, {})
    if count ~= rows then refuse("%s: %d numbers, not %d", label, count, rows) end
    first = 0
  else
    local _, count = list(value, label)
    if count ~= rows then refuse("%s: %d numbers, not %d", label, count, rows) end
  end
  for i = 0, rows - 1 do target[i] = convert.number(value[i + first], field[3], ("%s[%d]"):format(label, i + first)) end
end

-- Compares the length of a column with the rows that the struct or the call has.
local function check_rows(count, counter, state, label)
  local given, expected = state.counts[counter], state.counts[counter] or state.rows
  if counter ~= "rows" and not given then
    state.counts[counter] = count
  elseif counter == "rows" then
    if not state.rows then refuse("%s: the number of rows is not known", label) end
    if count < state.rows then refuse("%s: %d elements, not %d", label, count, state.rows) end
  elseif count ~= expected and not (state.explicit[counter] and count > expected) then
    refuse("%s: %d elements, not %d", label, count, expected)
  end
end

local function set_column(target, base, value, counter, state, label)
  local writable = WRITABLE[base] or false
  local pointer, stride, count = array.elements(value, COLUMNS[base], writable, label, state.keep)
  check_rows(count, counter, state, label)
  target.data, target.stride = pointer, stride
end

--- Columns of a field or parameter such as position[3]: a list of arrays, or one array that has them interleaved.
function convert.columns(target, base, count, value, counter, state, label)
  if array.is_single(value) then
    local pointer, stride, total = array.elements(value, COLUMNS[base], WRITABLE[base] or false, label, state.keep)
    if total % count ~= 0 then refuse("%s: %d elements are no rows of %d", label, total, count) end
    check_rows(total / count, counter, state, label)
    local step = stride / ffi.sizeof(COLUMNS[base])
    for i = 0, count - 1 do target[i].data, target[i].stride = pointer + i * step, stride * count end
    return
  end
  if type(value) ~= "table" then refuse("%s: an array or a list of columns, not %s", label, type(value)) end
  for i, column in pairs(value) do
    if type(i) ~= "number" or i % 1 ~= 0 or i < 1 or i > count then
      refuse("%s[%s]: there are %d columns", label, tostring(i), count)
    end
    if column then set_column(target[i - 1], base, column, counter, state, ("%s[%d]"):format(label, i)) end
  end
end

-- The field with the length of a column.
local function counter_of(names, name)
  if names.count then return "count" end
  if names.index_count and name:match("^indices") then return "index_count" end
  return names.vertex_count and "vertex_count" or names.point_count and "point_count" or "rows"
end

-- Sets the field that has the length of a list.
local function set_length(struct, names, field, count, state, label)
  local lengths = field.length or {}
  local counter = lengths[#lengths]
  if counter and tonumber(counter) then counter = lengths[#lengths - 1] end
  if not counter or not names[counter] then
    if count ~= 1 then refuse("%s: %d elements, not 1", label, count) end
    return
  end
  local rows = #lengths > 1 and names[lengths[1]] and lengths[1] ~= counter and
    math.max(1, tonumber(struct[lengths[1]])) or 1
  local expected = state.counts[counter]
  if count % rows ~= 0 or (expected and expected ~= count / rows) then
    refuse("%s: %d elements, not %s", label, count, expected and expected * rows or "a multiple of " .. rows)
  end
  state.counts[counter] = count / rows
  struct[counter] = count / rows
end

local build

--- An array of structs from a list of tables.
function convert.structs(base, value, state, label)
  local _, count = list(value, label)
  local made, size = ffi.new(base .. "[?]", math.max(count, 1)), tables.structs[base].size
  state.keep[#state.keep + 1] = made
  for i = 1, count do
    ffi.copy(made + (i - 1), build(base, value[i], state, ("%s[%d]"):format(label, i)), size)
  end
  return count > 0 and made or nil, count
end

--- An array of handles from a list of objects; false is NULL.
function convert.handles(base, value, state, label)
  local _, count = list(value, label)
  local made = ffi.new(base .. " *[?]", math.max(count, 1))
  state.keep[#state.keep + 1] = made
  for i = 1, count do
    if value[i] then made[i - 1] = object.handle(value[i], base, state, ("%s[%d]"):format(label, i)) end
  end
  return ffi.cast("void *", made), count
end

function convert.string(value, state, label)
  if type(value) ~= "string" then refuse("%s: a string, not %s", label, type(value)) end
  if value:find("\0", 1, true) then refuse("%s: the string has a zero byte", label) end
  state.keep[#state.keep + 1] = value
  return ffi.cast("const char *", value)
end

--- A pointer to one struct or to a list of them. The library's values of a struct that is not const go back into its
--- table after the call.
function convert.struct_pointer(field, value, state, label)
  local base = field[3]
  if type(value) ~= "table" then refuse("%s: a table, not %s", label, type(value)) end
  if field.const and #value > 0 then return convert.structs(base, value, state, label) end
  if field.const and field.length and next(value) == nil then return nil, 0 end
  local made = build(base, value, state, label)
  if not field.const then state.after[#state.after + 1] = {base, made, value} end
  return made, 1
end

-- Memory behind a pointer: texels, uniforms, matrices.
local function data(struct, base, names, field, value, state, label)
  if field[1]:match("user_data$") then
    if type(value) ~= "cdata" or not tostring(ffi.typeof(value)):find("[%*%[]") then
      refuse("%s: a pointer of ffi, not %s", label, type(value))
    end
    state.keep[#state.keep + 1] = value
    return ffi.cast("void *", value)
  end
  local rule = sizes.bytes[base .. "." .. field[1]]
  if rule then
    local needed, ctype = rule(struct)
    local pointer, bytes = array.bytes(value, ctype, not field.const, label, state.keep)
    if bytes < needed then refuse("%s: %.0f bytes, not %.0f", label, bytes, needed) end
    return pointer
  end
  if field[3] == "void" then return (array.bytes(value, nil, not field.const, label, state.keep)) end
  local pointer, stride, count = array.elements(value, field[3], not field.const, label, state.keep)
  if stride ~= ffi.sizeof(field[3]) then refuse("%s: the array is not packed", label) end
  local width = tonumber(field.length[#field.length]) or 1
  if #field.length == 1 and tonumber(field.length[1]) then
    if count < width then refuse("%s: %d elements, not %d", label, count, width) end
  else
    if count % width ~= 0 then refuse("%s: %d elements are no rows of %d", label, count, width) end
    set_length(struct, names, field, count / width, state, label)
  end
  return pointer
end

local function set_callback(struct, names, field, value, state, label)
  if type(value) == "cdata" then
    local ctype = tables.callbacks[field[3]].type
    if not ffi.istype(ctype, value) then refuse("%s: a function of Lua or a %s of C", label, ctype) end
    struct[field[1]] = value
    return
  end
  if type(value) ~= "function" then refuse("%s: a function, not %s", label, type(value)) end
  local run, user_data = callback.bind(field[3], value, state, label)
  struct[field[1]], struct.user_data = run, user_data
  if callback.OF_CALL[field[3]] then
    state.keep[#state.keep + 1] = state.entry
    return
  end
  state.callbacks = state.callbacks or label
  state.anchors[#state.anchors + 1] = state.entry
end

-- A field of each class: set(struct, base, names, field, value, state, label).
local set = {}

function set.number(struct, _, _, field, value, state, label)
  local number = convert.number(value, field[3], label)
  struct[field[1]] = number
  if field[1]:match("count$") then state.counts[field[1]], state.explicit[field[1]] = number, true end
end

function set.enum(struct, _, _, field, value, _, label) struct[field[1]] = enums.value(field[3], value, label) end
function set.numbers(struct, _, _, field, value, _, label) fill_numbers(struct[field[1]], value, field, label) end

function set.enums(struct, _, _, field, value, _, label)
  local _, count = list(value, label)
  if count ~= field.array[1] then refuse("%s: %d names, not %d", label, count, field.array[1]) end
  for i = 1, count do struct[field[1]][i - 1] = enums.value(field[3], value[i], label) end
end

function set.column(struct, _, names, field, value, state, label)
  local counter = counter_of(names, field[1])
  if field.array then
    convert.columns(struct[field[1]], field[3], field.array[1], value, counter, state, label)
  else
    set_column(struct[field[1]], field[3], value, counter, state, label)
  end
end

function set.columns(struct, _, names, field, value, state, label)
  local _, count = list(value, label)
  local made = ffi.new(field[3] .. "[?]", math.max(count, 1))
  state.keep[#state.keep + 1] = made
  convert.columns(made, field[3], count, value, counter_of(names, ""), state, label)
  set_length(struct, names, field, count, state, label)
  struct[field[1]] = made
end

function set.struct(struct, _, _, field, value, state, label)
  ffi.copy(struct[field[1]], build(field[3], value, state, label), tables.structs[field[3]].size)
end

function set.structs(struct, _, names, field, value, state, label)
  local pointer, count = convert.struct_pointer(field, value, state, label)
  struct[field[1]] = pointer
  set_length(struct, names, field, count, state, label)
end

function set.handle(struct, _, _, field, value, state, label)
  struct[field[1]] = object.handle(value, field[3], state, label)
end

function set.handles(struct, _, names, field, value, state, label)
  local pointer, count = convert.handles(field[3], value, state, label)
  struct[field[1]] = pointer
  set_length(struct, names, field, count, state, label)
end

function set.enumlist(struct, _, names, field, value, state, label)
  local _, count = list(value, label)
  local made = ffi.new(field[3] .. "[?]", math.max(count, 1))
  state.keep[#state.keep + 1] = made
  for i = 1, count do made[i - 1] = enums.value(field[3], value[i], ("%s[%d]"):format(label, i)) end
  set_length(struct, names, field, count, state, label)
  struct[field[1]] = made
end

function set.strings(struct, _, names, field, value, state, label)
  local _, count = list(value, label)
  local made = ffi.new("const char *[?]", math.max(count, 1))
  state.keep[#state.keep + 1] = made
  for i = 1, count do made[i - 1] = convert.string(value[i], state, ("%s[%d]"):format(label, i)) end
  set_length(struct, names, field, count, state, label)
  struct[field[1]] = made
end

function set.string(struct, _, _, field, value, state, label)
  struct[field[1]] = convert.string(value, state, label)
end

function set.data(struct, base, names, field, value, state, label)
  struct[field[1]] = data(struct, base, names, field, value, state, label)
end

function set.callback(struct, _, names, field, value, state, label)
  set_callback(struct, names, field, value, state, label)
end

-- Numbers come first: lengths and memory depend on them.
local FIRST = {number = true, enum = true}
local names_of = {}

local function names_in(base)
  if not names_of[base] then
    names_of[base] = {}
    for _, field in ipairs(tables.structs[base]) do names_of[base][field[1]] = field end
  end
  return names_of[base]
end

local function check_fields(base, value, names, state, label)
  if type(value) ~= "table" or object.is_object(value) then
    refuse("%s: a table of the fields of %s, not %s", label, base, type(value))
  end
  for name in pairs(value) do
    if name == "owner" then
      object.handle(value.owner, object.is_object(value.owner) and value.owner._kind or "shd_object", state,
        label .. ".owner")
    elseif not names[name] or not set[names[name][2]] then
      refuse("%s: %s has no field %s", label, base, tostring(name))
    end
  end
end

--- The source of a slot is determined by what it has.
local function slot_source(struct, value)
  for i, name in ipairs {"texture", "attribute", "procedure", "solid"} do
    if value[name] ~= nil and value.source == nil then struct.source = i end
  end
end

-- A depth or a projection that is given without a kind decides the kind of a texture.
local function texture_kind(struct, value, label)
  if value.kind ~= nil then return end
  if value.depth ~= nil and value.projection ~= nil then
    refuse("%s.kind: depth is of 3D textures and projection of directions; give the kind, too", label)
  end
  if value.depth ~= nil then struct.kind = ffi.C.SHD_TEXTURE_KIND_3D end
  if value.projection ~= nil then struct.kind = ffi.C.SHD_TEXTURE_KIND_DIRECTIONS end
end

--- A struct from a table of its fields.
function build(base, value, state, label)
  local names = names_in(base)
  check_fields(base, value, names, state, label)
  local made = convert.new(base)
  local counts, explicit, entry = state.counts, state.explicit, state.entry
  state.counts, state.explicit, state.entry = {}, {}, nil
  state.keep[#state.keep + 1] = made
  if base == "shd_texture_desc" then texture_kind(made, value, label) end
  for _, is_first in ipairs {true, false} do
    if base == "shd_texture_desc" and not is_first and value.depth == nil and made.layer_count == 1 then
      made.layer_count = sizes.images(made)  -- six of a cube: the length of level_images depends on it
    end
    for _, field in ipairs(tables.structs[base]) do
      if value[field[1]] ~= nil and (FIRST[field[2]] or false) == is_first then
        set[field[2]](made, base, names, field, value[field[1]], state, label .. "." .. field[1])
      end
    end
  end
  for _, counter in ipairs {"count", "vertex_count", "index_count", "point_count"} do
    if names[counter] and state.counts[counter] then made[counter] = state.counts[counter] end
  end
  if names.count then state.rows = tonumber(made.count) end
  if base == "shd_slot" then slot_source(made, value) end
  if base == "shd_texture_desc" and made.flags ~= 0 then state.anchors[#state.anchors + 1] = state.keep end
  state.counts, state.explicit, state.entry = counts, explicit, entry
  return made
end

convert.build = build
convert.short = short

function convert.state()
  return {keep = {}, anchors = {}, after = {}, counts = {}, explicit = {}, workers = 1}
end

return convert
