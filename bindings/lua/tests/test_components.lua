-- SPDX-License-Identifier: MIT
-- Functions of the other libraries, as far as they are built.
local ffi = require "ffi"
local library = require "shd.native"
local shd = require "shd"
local support = require "support"
local equal, refused, floats = support.equal, support.refused, support.floats

local context = shd.context {worker_count = 1}

-- A case that is skipped without a library.
local function case(name, component, run)
  support.case(name, function()
    if pcall(library.load, component) then
      run()
    else
      print("skipped: " .. name .. "; lib" .. component .. " is not built")
    end
  end)
end

local function temporary(suffix)
  local path = os.tmpname()
  os.remove(path)
  return path .. suffix
end

case("a picture to disk and back", "shd_io", function()
  local path = temporary ".png"
  local pixels = ffi.new("uint8_t[16]", 10, 20, 30, 255, 40, 50, 60, 255, 70, 80, 90, 255, 1, 2, 3, 255)
  shd.image_save({width = 2, height = 2, format = "rgba8_srgb", pixels = pixels}, path)
  local file = assert(io.open(path, "rb"))
  local bytes = file:read "*a"
  file:close()
  local texture = shd.texture_load_memory(context, bytes, {tables = "mipmap", flags = "in_process"})
  equal(texture:get_info().width, 2)
  equal(texture:get_info().tables, "mipmap")
  local bitmap = shd.bitmap_load(context, path, {flags = "in_process"})
  os.remove(path)
  equal(bitmap:get_info().file_format, "png")
  local image = bitmap:image()
  equal(image.owner, bitmap)
  equal(ffi.cast("uint8_t *", image.pixels)[1], 20)
  equal(refused("/nothing.png", shd.texture_load, context, "/nothing.png", {}).result, "error_not_found")
  refused("path: the string has a zero byte", shd.bitmap_load, context, "a\0b")
end)

case("a display transform", "shd_color", function()
  local color = shd.color(context)
  assert(#color:default_display() > 0)
  local framebuffer = shd.framebuffer(context, {width = 2, height = 1})
  context:render {framebuffer = framebuffer, clear_color = {0.18, 0.18, 0.18, 1}}
  local pixels = ffi.new "uint8_t[8]"
  color:apply_display(framebuffer, nil, nil, {width = 2, height = 1, format = "rgba8", pixels = pixels})
  assert(pixels[0] > 50 and pixels[7] == 255, pixels[0])
  refused("image.pixels: 8 bytes, not 16", color.apply_display, color, framebuffer, nil, nil,
    {width = 2, height = 2, format = "rgba8", pixels = pixels})
  local lines = 0
  context:render {framebuffer = framebuffer, progress = {report = function() lines = lines + 1 end}}
  assert(lines > 0)
end)

case("a tracer of Embree", "shd_embree", function()
  local mesh = shd.mesh_create_shape(context, {shape = "plane", size = {10, 1, 10}}, 0)
  local embree = shd.embree(context, {{mesh = mesh}})
  local tracer, out = embree:get_tracer(), floats(7, 7)
  equal(tracer.owner, embree)
  local points = {position = {0, -1, 0, 0, 1, 0}, normal = {0, 1, 0, 0, 1, 0}}
  context:occlusion_compute({rays = 64, tracer = tracer}, points, out)
  assert(out[0] ~= out[1], out[0])
  embree:close()
  refused("occlusion.tracer.owner: the embree is closed", context.occlusion_compute, context,
    {rays = 64, tracer = tracer}, points, out)
  refused("out: 1 elements, not 2", context.occlusion_compute, context, {rays = 4}, points, floats(0))
end)

case("a model file", "shd_scene", function()
  local path = temporary ".obj"
  local file = assert(io.open(path, "w"))
  file:write("v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n")
  file:close()
  local scene = shd.scene_load(context, path)
  os.remove(path)
  equal(scene:get_info().triangle_count, 1)
  equal(scene:mesh(0):get_info().triangle_count, 1)
  equal(scene:mesh(7), nil)
  local frame = {framebuffer = shd.framebuffer(context, {width = 8, height = 8}), camera = {eye = {0, 0, 3}}}
  scene:fill_render(frame)
  equal(#frame.draws, 1)
  scene:close()
  frame.stats = {}
  context:render(frame)
  equal(frame.stats.triangles, 1)
  equal(refused("nothing.obj", shd.scene_load, context, "/nothing.obj").result, "error_not_found")
end)
