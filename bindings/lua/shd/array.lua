-- SPDX-License-Identifier: MIT
-- Arrays of ffi as memory and columns. They are used in place; lists of Lua are copied.
local ffi = require "ffi"
local refuse = require "shd.native".refuse

local array = {}

-- Names of the types of C as ffi prints them.
local SPELLINGS = {["unsigned char"] = "uint8_t", ["unsigned short"] = "uint16_t", ["unsigned int"] = "uint32_t",
  ["int"] = "int32_t", ["short"] = "int16_t", ["char"] = "int8_t", ["signed char"] = "int8_t"}
local SIZES = {float = 4, double = 8, uint8_t = 1, int8_t = 1, uint16_t = 2, int16_t = 2, uint32_t = 4, int32_t = 4,
  uint64_t = 8, int64_t = 8}
local POINTERS = {}
for name in pairs(SIZES) do
  POINTERS[name] = {[true] = ffi.typeof(name .. " *"), [false] = ffi.typeof("const " .. name .. " *")}
end

local View = {}
View.__index = View

-- Element type, whether it is const, and whether there is a length, by the number of a type of C.
local types = {}

local function inspect_type(ctype)
  local text = tostring(ctype):match("^ctype<(.*)>$"):gsub("%s*%(&%)", "")
  local base = text:gsub("^const ", ""):match("^([%w_ ]-)%s*[%[*]") or text
  base = SPELLINGS[base] or base
  return {base = base, is_const = text:match("^const ") ~= nil, is_array = text:match("%[") and SIZES[base] ~= nil}
end

-- Element type of a cdata, whether it is const, and the number of elements; the number is nil for pointers.
local function inspect(value)
  local ctype = ffi.typeof(value)
  local number = tonumber(ctype)
  local entry = types[number]
  if not entry then
    entry = inspect_type(ctype)
    types[number] = entry
  end
  return entry.base, entry.is_const, entry.is_array and ffi.sizeof(value) / SIZES[entry.base] or nil
end

--- Memory behind a pointer: shd.view(pointer, count). The caller keeps the memory alive. The type is that of the
--- pointer, or `ctype`, such as "uint8_t".
function array.view(pointer, count, ctype)
  if type(pointer) ~= "cdata" then refuse("view: a pointer of ffi, not %s", type(pointer)) end
  if type(count) ~= "number" or count < 0 or count % 1 ~= 0 then refuse("view: count %s", tostring(count)) end
  local base, is_const, length = inspect(pointer)
  if ctype and not SIZES[ctype] then refuse("view: %s is no type of elements", tostring(ctype)) end
  if not ctype and not SIZES[base] then refuse("view: %s has no type of elements; give one", base) end
  if length and ctype == nil and count > length then refuse("view: %d elements of %d", count, length) end
  return setmetatable({source = pointer, base = ctype or base, is_const = is_const, count = count, offset = 0,
    stride = 1}, View)
end

--- Every `stride`-th element from `offset` on, both in elements: shd.column(vertices, 3, 5).
function array.column(source, offset, stride)
  local whole = array.describe(source, "column")
  for name, value in pairs {offset = offset, stride = stride} do
    if type(value) ~= "number" or value % 1 ~= 0 or value < 0 then
      refuse("column: %s %s is no number of elements", name, tostring(value))
    end
  end
  if stride == 0 then refuse("column: stride 0") end
  local count = math.max(0, math.ceil((whole.count - offset) / stride))
  return setmetatable({source = whole.source, base = whole.base, is_const = whole.is_const, count = count,
    offset = whole.offset + offset * whole.stride, stride = stride * whole.stride}, View)
end

--- The view of a value: an array of ffi, or a view itself.
function array.describe(value, label)
  if getmetatable(value) == View then return value end
  if type(value) ~= "cdata" then refuse("%s: an array of ffi, not %s", label, type(value)) end
  local base, is_const, count = inspect(value)
  if not count then
    refuse("%s: %s has no length; use shd.view(pointer, count)", label, tostring(ffi.typeof(value)):match("<(.*)>"))
  end
  return setmetatable({source = value, base = base, is_const = is_const, count = count, offset = 0, stride = 1}, View)
end

-- A list of numbers as an array of one type.
local function from_list(list, base, label)
  local count = #list
  local made = ffi.new(base .. "[?]", math.max(count, 1))
  for i = 1, count do
    local number = list[i]
    if type(number) ~= "number" then refuse("%s[%d]: a number, not %s", label, i, type(number)) end
    if base ~= "float" and base ~= "double" and (number % 1 ~= 0 or number < 0 or number >= 2 ^ (8 * SIZES[base])) then
      refuse("%s[%d]: %s is no %s", label, i, tostring(number), base)
    end
    made[i - 1] = number
  end
  return setmetatable({source = made, base = base, is_const = false, count = count, offset = 0, stride = 1}, View)
end

--- Pointer, stride [bytes] and number of elements of an array that must be of a type. `keep` gets its memory.
function array.elements(value, base, writable, label, keep)
  if type(value) == "table" and getmetatable(value) ~= View and not writable then
    value = from_list(value, base, label)
  end
  local view = array.describe(value, label)
  if view.base ~= base then refuse("%s: an array of %s, not %s", label, base, view.base) end
  if writable and view.is_const then refuse("%s: the array is const", label) end
  local pointer = ffi.cast(POINTERS[base][writable], view.source) + view.offset
  if tonumber(ffi.cast("uintptr_t", pointer) % SIZES[base]) ~= 0 then
    refuse("%s: the array is not aligned to %d bytes", label, SIZES[base])
  end
  keep[#keep + 1] = view.source
  return pointer, view.stride * SIZES[base], view.count
end

--- Pointer and size of packed memory: an array of any of the types, or a string if it is only read.
function array.bytes(value, base, writable, label, keep)
  keep[#keep + 1] = value
  if type(value) == "string" and not writable then return ffi.cast("const uint8_t *", value), #value end
  local view = array.describe(value, label)
  if base and view.base ~= base then refuse("%s: an array of %s, not %s", label, base, view.base) end
  if not SIZES[view.base] then refuse("%s: an array of numbers, not %s", label, view.base) end
  if view.stride ~= 1 then refuse("%s: the array has a stride of %d elements, not 1", label, view.stride) end
  local pointer, _, count = array.elements(value, view.base, writable, label, keep)
  return pointer, count * SIZES[view.base]
end

--- Whether a value is one array instead of a list of several.
function array.is_single(value)
  return type(value) == "cdata" or getmetatable(value) == View or
    (type(value) == "table" and type(value[1]) == "number")
end

return array
