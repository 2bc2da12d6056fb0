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
  local image = bitmap:get_image()
  equal(image.owner, bitmap)
  equal(ffi.cast("uint8_t *", image.pixels)[1], 20)
  equal(refused("/nothing.png", shd.texture_load, context, "/nothing.png", {}).result, "error_not_found")
  refused("path: the string has a zero byte", shd.bitmap_load, context, "a\0b")
end)

case("a display transform", "shd_color", function()
  local color = shd.color(context)
  assert(#color:get_default_display() > 0)
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
  local mesh = shd.mesh_create_shape(context, {kind = "plane", size = {10, 1, 10}}, 0)
  local embree = shd.embree(context, {{mesh = mesh}})
  local tracer, out = embree:get_tracer(), floats(7, 7)
  equal(tracer.owner, embree)
  local points = {position = {0, -1, 0, 0, 1, 0}, normal = {0, 1, 0, 0, 1, 0}}
  context:occlusion_compute({ray_count = 64, tracer = tracer}, points, {visibility = out})
  assert(out[0] ~= out[1], out[0])
  embree:close()
  refused("occlusion.tracer.owner: the embree is closed", context.occlusion_compute, context,
    {ray_count = 64, tracer = tracer}, points, {visibility = out})
  refused("occlusion_values.visibility: 1 elements, not 2", context.occlusion_compute, context, {ray_count = 4},
    points, {visibility = floats(0)})
end)

case("a model file", "shd_scene", function()
  local path = temporary ".obj"
  local file = assert(io.open(path, "w"))
  file:write("v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n")
  file:close()
  local scene = shd.scene_load(context, path)
  os.remove(path)
  equal(scene:get_info().triangle_count, 1)
  equal(scene:get_mesh(0):get_info().triangle_count, 1)
  equal(scene:get_mesh(7), nil)
  local frame = {framebuffer = shd.framebuffer(context, {width = 8, height = 8}), camera = {eye = {0, 0, 3}}}
  scene:fill_render(frame)
  equal(#frame.draws, 1)
  scene:close()
  frame.stats = {}
  context:render(frame)
  equal(frame.stats.triangle_count, 1)
  equal(refused("nothing.obj", shd.scene_load, context, "/nothing.obj").result, "error_not_found")
end)

-- A triangle whose buffer is the file a.bin, with an animation to x = 4 in 2 s, and a texture that no file has.
local MODEL = [[{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
  "textures": [{"source": 0}], "images": [{"uri": "none.png"}], "buffers": [{"uri": "a.bin", "byteLength": 68}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
    {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
    {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [2]},
    {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
  "animations": [{"name": "Move", "samplers": [{"input": 1, "output": 2}],
    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]}]]

case("a model in memory", "shd_scene", function()
  local buffer = floats(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 4, 0, 0)
  local many = shd.context()  -- the function runs on the thread of the load
  for _, flags in ipairs {"none", "in_process"} do
    for _, answer in ipairs {buffer, ffi.string(buffer, 68)} do
      local scene = shd.scene_load_memory(many, MODEL, nil, {flags = flags, find = function(name)
        return name == "a.bin" and answer or nil
      end})
      collectgarbage()
      local info = scene:get_info()
      equal(info.triangle_count, 1)
      local warnings = {}
      for i = 0, info.warning_count - 1 do warnings[#warnings + 1] = scene:get_warning(i) end
      assert(table.concat(warnings, "; "):find("none.png", 1, true), table.concat(warnings, "; "))
      equal(scene:get_name("animation", 0), "Move")
      local first, last = scene:get_animation_times(0)
      equal(scene:pose(0, (first + last) / 2):get_instance(0).object_to_world[13], 2)
      refused("animation: 1", scene.pose, scene, 1, 0)
    end
    local kept = {"mine"}
    local good, problem = pcall(shd.scene_load_memory, many, MODEL, nil,
      {flags = flags, find = function() error(kept, 0) end})
    assert(not good and problem == kept)
    refused("scene.find: an array of ffi, not table", shd.scene_load_memory, many, MODEL, nil,
      {flags = flags, find = function() return {} end})
    refused("a.bin", shd.scene_load_memory, many, MODEL, nil, {flags = flags})
  end
  local alive = setmetatable({}, {__mode = "v"})
  local scene
  do
    local held = {bytes = buffer}
    alive[1] = held
    scene = shd.scene_load_memory(many, MODEL, nil, {find = function(name)
      return name == "a.bin" and held.bytes or nil
    end})
  end
  jit.flush()  -- traces keep what they refer to
  collectgarbage() collectgarbage()
  assert(not alive[1] and scene:get_info().triangle_count == 1)
end)

case("textures in memory", "shd_io", function()
  local path = temporary ".ktx2"
  local texture = support.texture(context, {{1, 2}, {3, 4}})
  texture:save_ktx2(path)
  local file = assert(io.open(path, "rb"))
  local bytes = file:read "*a"
  file:close()
  os.remove(path)
  local info = {}
  local loaded = shd.texture_load_memory(context, bytes, {info = info})
  equal(info.kind, "ktx2")
  equal(loaded:read_level(0, 0)[3], 4)
  local volume = shd.texture_load_memory(context, "abcd", {raw = {width = 1, height = 1, depth = 4}})
  equal(volume:get_info().depth, 4)
  refused("", shd.texture_load_memory, context, "abcd", {vdb = {grid = "density"}})
end)
