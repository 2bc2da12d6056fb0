-- SPDX-License-Identifier: MIT
-- A teapot on a checkered floor that goes to the horizon; the camera goes around it. The frame of a tick depends on the
-- tick and the filter alone, so that LÖVE and plain luajit draw the same bits.
local ffi = require "ffi"
local shd = require "shd"

local scene = {}
scene.__index = scene

scene.filters = {"nearest", "bilinear", "trilinear", "ripmap", "summed_area", "anisotropic", "ewa"}

local SIZE = 128

-- Cells in two colours, with lines between them.
local function create_texture(context)
  local texels = ffi.new("uint8_t[?]", SIZE * SIZE * 4)
  for y = 0, SIZE - 1 do
    for x = 0, SIZE - 1 do
      local i, cell = (y * SIZE + x) * 4, (math.floor(x / 32) + math.floor(y / 32)) % 2
      local is_line = x % 32 < 2 or y % 32 < 2
      texels[i] = is_line and 25 or cell == 0 and 235 or 45
      texels[i + 1] = is_line and 30 or cell == 0 and 225 or 95
      texels[i + 2] = is_line and 40 or cell == 0 and 205 or 150
      texels[i + 3] = 255
    end
  end
  return shd.texture(context, {width = SIZE, height = SIZE, format = "rgba8_srgb", texels = texels,
    tables = "mipmap|ripmap|summed_area"})
end

local function create_material(context, texture, filter, scale)
  local sampler = shd.sampler(context, {filter = filter, max_anisotropy = 16})
  return shd.material(context, {model = "blinn_phong", specular = {0.3, 0.3, 0.3}, exponent = 60, ambient_share = 0.25,
    slots = {{target = "diffuse", texture = texture, sampler = sampler, uv_transform = {scale, 0, 0, 0, scale, 0}}}})
end

--- A scene whose frames have a width and a height.
function scene.new(width, height)
  local self = setmetatable({width = width, height = height, materials = {}}, scene)
  local context = shd.context()
  local texture = create_texture(context)
  for i, filter in ipairs(scene.filters) do
    self.materials[i] = {floor = create_material(context, texture, filter, 60),
      teapot = create_material(context, texture, filter, 1)}
  end
  self.context = context
  self.teapot = shd.mesh_create_shape(context, {kind = "teapot"}, 0)
  self.floor = shd.mesh_create_shape(context, {kind = "plane", size = {240, 1, 240}}, 0)
  self.lights = {
    shd.light(context, {kind = "directional", direction = {-0.5, -1, -0.4}, intensity = {1.4, 1.35, 1.25}}),
    shd.light(context, {kind = "ambient", intensity = {0.5, 0.55, 0.65}})}
  self.framebuffer = shd.framebuffer(context, {width = width, height = height, sample_count = 4,
    color_format = "rgba8_srgb"})
  return self
end

--- Draws the frame of a tick with a filter, 1..7, into width * height RGBA8 pixels at a pointer.
function scene:draw(tick, filter, pointer)
  local angle = tick * math.pi / 120
  local material = self.materials[filter]
  self.context:render {framebuffer = self.framebuffer, lights = self.lights, clear_color = {0.35, 0.5, 0.75, 1},
    draws = {{mesh = self.floor, material = material.floor}, {mesh = self.teapot, material = material.teapot}},
    camera = {eye = {8 * math.sin(angle), 3.5, 8 * math.cos(angle)}, target = {0, 1.2, 0}, far_plane = 300}}
  self.framebuffer:read_color("rgba8_srgb", shd.view(pointer, self.width * self.height * 4, "uint8_t"))
end

--- FNV-1a of 64 bits (Fowler, Noll and Vo, 1991) of bytes at a pointer, after those of `hash`.
function scene.hash(hash, pointer, count)
  local bytes = ffi.cast("const uint8_t *", pointer)
  hash = hash or 0xcbf29ce484222325ULL
  for i = 0, count - 1 do hash = bit.bxor(hash, bytes[i]) * 0x100000001b3ULL end
  return hash
end

return scene
