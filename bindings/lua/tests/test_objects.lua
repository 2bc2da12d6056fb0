-- SPDX-License-Identifier: MIT
-- Lifetime of objects, meshes, framebuffers and frames.
local ffi = require "ffi"
local shd = require "shd"
local support = require "support"
local case, equal, refused, floats = support.case, support.equal, support.refused, support.floats

local context = shd.context {worker_count = 1}

-- Whether the library still has an object; its handle is refused after the last release.
local function is_alive(handle)
  local info = require("shd.convert").new("shd_texture_info")
  return shd.C.shd_texture_get_info(handle, info) == 0
end

-- The handle without the object's finalizer; a cast to the same type would give the same cdata.
local function raw(object) return ffi.cast("shd_texture *", ffi.cast("void *", object._handle)) end

case("close", function()
  local texture = support.texture(context, {{1}})
  local handle = raw(texture)
  assert(is_alive(handle))
  shd.C.shd_texture_retain(handle)
  texture:close()
  texture:close()
  assert(is_alive(handle), "the second close dropped a second reference")
  shd.C.shd_texture_release(handle)
  assert(not is_alive(handle))
  equal(tostring(texture), "texture (closed)")
  refused("texture: the texture is closed", texture.get_info, texture)
  refused("texture: a texture, not nil", texture.get_info)
  refused("texture: a texture, not a context", texture.get_info, context)
end)

case("the garbage collector releases", function()
  local function make() return raw(support.texture(context, {{1}})) end
  local handle = make()
  collectgarbage()
  collectgarbage()
  assert(not is_alive(handle))
end)

case("a batch holds one reference", function()
  local texture = support.texture(context, {{1}})
  local handle = raw(texture)
  local batch = texture:prepare(shd.sampler(context), {u = floats(0), v = floats(0)}, {})
  texture:close()
  assert(is_alive(handle))
  batch:close()
  batch = nil
  collectgarbage()
  collectgarbage()
  assert(not is_alive(handle))
end)

case("objects keep those that they were made from", function()
  local own = shd.context {worker_count = 1}
  local texture = support.texture(own, {{1}})
  local handle = raw(texture)
  local material = shd.material(own, {slots = {{target = "diffuse", texture = texture}}})
  own:close()
  texture:close()
  assert(is_alive(handle))
  local second = shd.context {worker_count = 1}
  material:close()
  second:close()
  refused("context: the context is closed", shd.sampler, own)
end)

case("meshes", function()
  local mesh = shd.mesh(context, {position = {0, 0, 0, 1, 0, 0, 0, 1, 0}, indices = {0, 1, 2},
    uv = floats(0, 0, 1, 0, 0, 1)})
  equal(mesh:get_info().vertex_count, 3)
  equal(mesh:get_info().triangle_count, 1)
  equal(mesh:read_positions()[3], 1)
  equal(mesh:read_indices()[2], 2)
  local x, y, z = floats(0, 1, 0), floats(0, 0, 1), floats(0, 0, 0)
  local columns = shd.mesh(context, {position = {x, y, z}, indices16 = ffi.new("uint16_t[3]", 0, 1, 2)})
  equal(columns:get_info().bounds_max[1], 1)
  local own = {ffi.new "float[3]", ffi.new "float[3]", ffi.new "float[3]"}
  columns:read_positions(own)
  equal(own[2][2], 1)
  own[3] = ffi.new "float[2]"
  refused("out[3]: 2 elements, not 3", columns.read_positions, columns, own)
  refused("out: 8 elements are no rows of 3", columns.read_positions, columns, ffi.new "float[8]")
  refused("out: an array of uint32_t, not float", columns.read_indices, columns, ffi.new "float[3]")
  refused("mesh.position[3]: 2 elements, not 3", shd.mesh, context, {position = {x, y, floats(0, 0)}})
  refused("mesh.uv: 2 elements, not 3", shd.mesh, context, {position = {x, y, z}, uv = floats(0, 0, 0, 0)})
  refused("mesh.indices: 3 elements, not 6", shd.mesh, context,
    {position = {x, y, z}, index_count = 6, indices = {0, 1, 2}})
  refused("indices", shd.mesh, context, {position = {x, y, z}, indices = {0, 1, 3}})
  local attributes = shd.mesh(context, {position = {x, y, z}, attributes = {x, floats(4, 5, 6)}})
  local out = ffi.new "float[3]"
  attributes:read_attribute(1, out)
  equal(out[1], 5)
end)

case("a frame", function()
  local framebuffer = shd.framebuffer(context, {width = 32, height = 16, aovs = "normal"})
  local stats = {}
  support.frame(context, framebuffer, nil, {clear_color = {0.25, 0, 0, 1}, stats = stats})
  assert(stats.triangle_count > 100)
  local pixels = framebuffer:read_color("rgba8_srgb")
  equal(ffi.sizeof(pixels), 32 * 16 * 4)
  equal(pixels[0], 137)
  local depth = framebuffer:read_plane("depth")
  equal(depth[0], 1)
  local own = ffi.new("uint8_t[?]", 32 * 16 * 4)
  equal(framebuffer:read_color("rgba8_srgb", own), own)
  framebuffer:read_color("rgba8", shd.view(ffi.cast("void *", own), 32 * 16 * 4, "uint8_t"))
  refused("image.pixels: 2048 bytes, not 8192", framebuffer.read_color, framebuffer, "rgba32f", ffi.new "float[512]")
  refused("image.pixels: an array of uint8_t, not float", framebuffer.read_color, framebuffer, "rgba8", floats(0))
  refused("out: 4 elements, not 512", framebuffer.read_plane, framebuffer, "depth", floats(0, 0, 0, 0))
  local view = framebuffer:view_plane("depth")
  equal(view.f32[0], 1)
  equal(view.owner, framebuffer)
  refused('plane: "dept" is none of', framebuffer.read_plane, framebuffer, "dept")
end)

case("frames with bad parts", function()
  local framebuffer = shd.framebuffer(context, {width = 8, height = 8})
  local mesh = shd.mesh_create_shape(context, {kind = "box"}, 0)
  local function render(frame)
    frame.framebuffer = frame.framebuffer or framebuffer
    return context:render(frame)
  end
  refused("render.draws[2].mesh: a mesh, not string", render, {draws = {{mesh = mesh}, {mesh = "box"}}})
  refused("render.draws: a table, not number", render, {draws = 3})
  refused("render.lights[1]: a light, not a mesh", render, {lights = {mesh}})
  refused("render.framebuffer: a framebuffer, not a mesh", render, {framebuffer = mesh})
  refused("render.draws[1].instances: 17 elements are no rows of 16", render,
    {draws = {{mesh = mesh, instances = ffi.new "float[17]"}}})
  refused("render.draws[1].object_to_world: 2 numbers, not 16", render,
    {draws = {{mesh = mesh, object_to_world = {1, 2}}}})
  refused("render.draws: 1 elements, not 4", render, {draws = {{mesh = mesh}}, draw_count = 4})
  refused("render.shadows: 2 elements, not 1", render,
    {lights = {shd.light(context)}, shadows = {false, false}})
  mesh:close()
  refused("render.draws[1].mesh: the mesh is closed", render, {draws = {{mesh = mesh}}})
  render {draws = {}, lights = {}}
end)

case("instances and uniforms", function()
  local framebuffer = shd.framebuffer(context, {width = 8, height = 8})
  local mesh = shd.mesh_create_shape(context, {kind = "box"}, 0)
  local instances, stats = ffi.new "float[32]", {}
  for i = 0, 30, 16 do
    for k = 0, 15, 5 do instances[i + k] = 1 end
  end
  context:render {framebuffer = framebuffer, stats = stats,
    draws = {{mesh = mesh, instances = instances, uniforms = floats(1, 2)}}}
  equal(stats.triangle_count, 24)
end)

case("lookups in environments and shadows", function()
  local pixels = ffi.new("float[?]", 8 * 4)
  for i = 0, 31 do pixels[i] = 0.5 end
  local environment = shd.environment(context, {image = {format = "r32f", width = 8, height = 4, pixels = pixels}})
  local lookups = {direction = {{0, 0 / 0}, {1, 0}, {0, 0}}}
  for name, expected in pairs {sample_irradiance = math.pi / 2, sample_radiance = 0.5} do
    local out = {channel = {floats(7, 7)}}
    environment[name](environment, lookups, out)
    support.close_to(out.channel[1][0], expected, 1e-2)
    equal(out.nonfinite_count, 1)
    refused("environment_values.channel[1]: 1 elements, not 2", environment[name], environment, lookups,
      {channel = {floats(7)}})
  end
  local torus = shd.mesh_create_shape(context, {kind = "torus"}, 0)
  local shadow = shd.shadow(context, {size = 64})
  context:shadow_render(shadow, {light = shd.light(context, {kind = "directional", direction = {0, -1, 0}}),
    draws = {{mesh = torus}}, near_plane = -5, far_plane = 5, bounds_min = {-2, -2, -2}, bounds_max = {2, 2, 2}})
  local points, out = {position = {{0, 1, 0 / 0}, {-1, -1, 0}, {0, 0, 0}}}, {visibility = floats(7, 7, 7)}
  shadow:sample(points, out)  -- below the hole, below the ring, nowhere
  equal(out.visibility[0], 1)
  equal(out.visibility[1], 0)
  equal(out.nonfinite_count, 1)
end)
