-- SPDX-License-Identifier: MIT
-- Methods that allocate their results. Every other method is a function of C (object.lua).
local ffi = require "ffi"
local array = require "shd.array"
local call = require "shd.call"
local callback = require "shd.callback"
local convert = require "shd.convert"
local enums = require "shd.enums"
local library = require "shd.native"
local lookup = require "shd.lookup"
local object = require "shd.object"
local read = require "shd.read"
local sizes = require "shd.sizes"
local C, refuse = library.C, library.refuse

local texture = object.methods "shd_texture"
local framebuffer = object.methods "shd_framebuffer"
local mesh = object.methods "shd_mesh"
local CHANNELS = 4

texture.prepare = lookup.prepare

-- The number of lookups: that of `count`, else that of column u.
local function row_count(lookups)
  if type(lookups) ~= "table" then refuse("lookups: a table, not %s", type(lookups)) end
  if lookups.count then return lookups.count end
  if type(lookups.u) == "table" and getmetatable(lookups.u) == nil then return #lookups.u end
  if lookups.u == nil then refuse("lookups.u: required") end
  return array.describe(lookups.u, "lookups.u").count
end

--- Filtered values, as columns: out.channel[1..4]. Without `out` four packed arrays are made.
function texture:sample(sampler, lookups, out)
  if out == nil then
    out = {channel = {}}
    for i = 1, CHANNELS do out.channel[i] = ffi.new("float[?]", row_count(lookups)) end
  end
  call("shd_texture_sample", self, sampler, lookups, out)
  return out
end

--- Levels of detail of trilinear filtering, as an array.
function texture:query_levels(sampler, lookups, out)
  out = out or {lod = ffi.new("float[?]", row_count(lookups))}
  call("shd_texture_query_levels", self, sampler, lookups, out)
  return out
end

--- The taps and blends of one lookup; `index` is its row, from 0 on.
function texture:explain(sampler, lookups, index)
  callback.guard("shd_texture_explain")
  local state = convert.state()
  local own = object.handle(self, "shd_texture", state, "texture")
  local other = object.handle(sampler, "shd_sampler", state, "sampler")
  local columns = convert.build("shd_lookups", lookups, state, "lookups")
  index = convert.number(index or 0, "size_t", "index")
  local explanation = convert.new("shd_explanation")
  library.check(C.shd_texture_explain(own, other, columns, index, explanation))
  local taps = ffi.new("shd_tap[?]", math.max(1, tonumber(explanation.tap_count)))
  local blends = ffi.new("shd_blend_step[?]", math.max(1, tonumber(explanation.blend_count)))
  explanation.taps, explanation.tap_capacity = taps, explanation.tap_count
  explanation.blends, explanation.blend_capacity = blends, explanation.blend_count
  library.check(C.shd_texture_explain(own, other, columns, index, explanation))
  object.flush()
  callback.finish()
  return read("shd_explanation", explanation, state)
end

jit.off(texture.explain)  -- as every call of C in which a function of Lua may run

-- An image over `target`, or over a new array.
local function image_of(format, width, height, target)
  local ctype, channels = sizes.format(enums.value("shd_format", format, "format"))
  if not ctype then refuse("format: %s has no pixels", tostring(format)) end
  target = target or ffi.new(ctype .. "[?]", width * height * channels)
  return {format = format, width = width, height = height, pixels = target}, target
end

--- Colour as interleaved pixels in `target`, or in a new array: framebuffer:read_color("rgba8_srgb").
function framebuffer:read_color(format, target)
  if type(format) == "table" then return call("shd_framebuffer_read_color", self, format) end
  local info = self:get_info()
  local image, pixels = image_of(format or "rgba32f", info.width, info.height, target)
  call("shd_framebuffer_read_color", self, image)
  return pixels
end

--- A float plane as an array: framebuffer:read_plane("depth").
function framebuffer:read_plane(plane, out)
  local info = self:get_info()
  out = out or ffi.new("float[?]", info.width * info.height)
  call("shd_framebuffer_read_plane", self, plane, out)
  return out
end

function framebuffer:read_u32_plane(plane, out)
  local info = self:get_info()
  out = out or ffi.new("uint32_t[?]", info.width * info.height)
  call("shd_framebuffer_read_u32_plane", self, plane, out)
  return out
end

--- A mip level as stored: an array and its width and height.
function texture:read_level(layer, level, target)
  if type(target) == "table" and target.format then
    return call("shd_texture_read_level", self, layer, level, target)
  end
  local info = self:get_info()
  local function part(size) return math.max(1, math.floor(size / 2 ^ (level or 0))) end
  local image, texels = image_of(info.format, part(info.width), part(info.height), target)
  call("shd_texture_read_level", self, layer or 0, level or 0, image)
  return texels, image.width, image.height
end

for name, width in pairs {positions = 3, normals = 3, tangents = 4, uv = 2, uv1 = 2} do
  --- Columns of the mesh as one interleaved array, or into those of `out`.
  mesh["read_" .. name] = function(self, out)
    out = out or ffi.new("float[?]", width * self:get_info().vertex_count)
    call("shd_mesh_read_" .. name, self, out)
    return out
  end
end

function mesh:read_indices(out)
  out = out or ffi.new("uint32_t[?]", 3 * self:get_info().triangle_count)
  call("shd_mesh_read_indices", self, out)
  return out
end
