-- SPDX-License-Identifier: MIT
-- Random values for every function of libshd: nothing crashes, and each error is one of the module.
local ffi = require "ffi"
local shd = require "shd"
local support = require "support"
local tables = require "shd.tables"

local CALLS = tonumber(os.getenv "SHD_CALLS") or 6000

-- Park and Miller, "Random Number Generators: Good Ones Are Hard to Find" (1988).
local seed = tonumber(os.getenv "SHD_SEED") or 1
local function random(count)
  seed = seed * 16807 % 2147483647
  return seed % count + 1
end

local function pick(list) return list[random(#list)] end

local context = shd.context {worker_count = 1}
local closed = support.texture(context, {{1}})
closed:close()
local objects = {
  shd_context = context,
  shd_texture = support.texture(context, {{0, 1}, {2, 3}}, {tables = "mipmap"}),
  shd_sampler = shd.sampler(context),
  shd_mesh = shd.mesh_create_shape(context, {kind = "box"}, 0),
  shd_material = shd.material(context),
  shd_light = shd.light(context),
  shd_framebuffer = shd.framebuffer(context, {width = 8, height = 8}),
  shd_shadow = shd.shadow(context, {size = 16}),
}

local NUMBERS = {0, 1, 1, 2, 3, 7, 8, -1, 0.5, 1e9, 2 ^ 32 - 1, 2 ^ 53, 0 / 0, 1 / 0, -1 / 0, 1e-40}
local GARBAGE = {false, true, "", "x", "ewa|nearest", print, context, closed, {}, {1, 2, 3}, {{}}, {x = 1},
  ffi.new "float[8]", ffi.new "uint8_t[3]", ffi.new "uint32_t[4]", ffi.cast("float *", nil), ffi.new "double[2]",
  ffi.new "uint64_t", coroutine.create(print), shd.view(ffi.new "float[8]", 2), 0 / 0, -5}

local make = {}

local function list(run, ...)
  local made = {}
  for i = 1, random(4) - 1 do made[i] = run(...) end
  return made
end

local function value(field, depth)
  if random(12) == 1 or not make[field[2]] then return pick(GARBAGE) end
  return make[field[2]](field, depth)
end

local function struct(base, depth)
  local made = {}
  if depth > 4 then return made end
  local chance = random(6)
  for _, field in ipairs(tables.structs[base]) do
    if random(6) <= chance then made[field[1]] = value(field, depth + 1) end
  end
  return made
end

local function floats() return ffi.new("float[?]", pick {1, 2, 4, 8, 16}) end
local function integers() return ffi.new("uint32_t[?]", pick {1, 3, 6, 64}) end

function make.number() return pick(NUMBERS) end
function make.enum(field) return random(3) == 1 and pick(NUMBERS) or pick(tables.enums[field[3]])[1] end
function make.numbers(field) return random(2) == 1 and floats() or list(make.number, field) end
function make.enums(field) return list(make.enum, field) end
function make.string() return pick {"", "/nonexistent/name.png", "a\0b"} end
function make.column(field) return field[3]:match("u32") and integers() or floats() end
function make.columns(field) return random(2) == 1 and make.column(field) or list(make.column, field) end
function make.data(field) return field[3] == "float" and floats() or ffi.new("uint8_t[?]", pick {4, 64, 1024}) end
function make.handle(field) return objects[field[3]] end
function make.handles(field) return list(make.handle, field) end
function make.struct(field, depth) return struct(field[3], depth) end
function make.structs(field, depth)
  return random(2) == 1 and struct(field[3], depth) or list(struct, field[3], depth)
end
function make.enumlist(field) return list(make.enum, field) end
function make.callback() return function() error({}) end end

local names = {}
for name, entry in pairs(tables.functions) do
  if entry.library == "shd" and not name:match("_retain$") and not name:match("_release$") then
    names[#names + 1] = name
  end
end
table.sort(names)

local function try(name)
  local entry, arguments, count = tables.functions[name], {}, 0
  for _, parameter in ipairs(entry) do
    if not parameter.is_out and not entry.lengths[parameter[1]] then
      count = count + 1
      arguments[count] = value(parameter, 0)
    end
  end
  local good, problem = pcall(require "shd.call", name, unpack(arguments, 1, count))
  -- The error of a callback above is an empty table.
  if not good and not shd.is_error(problem) and not (type(problem) == "table" and next(problem) == nil) then
    error(name .. ": " .. tostring(problem), 0)
  end
  return good
end

support.case("random values", function()
  local passed = 0
  for _, name in ipairs(names) do pcall(require "shd.call", name) end  -- fills entry.lengths
  for _, entry in pairs(tables.functions) do entry.lengths = entry.lengths or {} end
  for _ = 1, CALLS do
    if try(pick(names)) then passed = passed + 1 end
  end
  assert(passed > CALLS / 20, passed .. " calls passed")
end)
