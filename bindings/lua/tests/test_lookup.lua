-- SPDX-License-Identifier: MIT
-- Textures, samplers and lookups.
local ffi = require "ffi"
local shd = require "shd"
local support = require "support"
local case, equal, refused, floats = support.case, support.equal, support.refused, support.floats

local context = shd.context {worker_count = 1}
local texture = support.texture(context, {{0, 1}, {2, 3}})
local sampler = shd.sampler(context, {filter = "bilinear", wrap_u = "clamp", wrap_v = "clamp"})

case("values, allocated and in place", function()
  local out = texture:sample(sampler, {u = {0.5, 0.25}, v = {0.5, 0.25}})
  equal(out.channel[1][0], 1.5)
  equal(out.channel[1][1], 0)
  equal(ffi.sizeof(out.channel[4]), 8)
  local red = floats(7, 7)
  texture:sample(sampler, {u = floats(0.5, 0.75), v = floats(0.5, 0.75)}, {channel = {red}})
  equal(red[0], 1.5)
  equal(red[1], 3)
  equal(texture:sample(sampler, {u = {0 / 0}, v = {0}}).nonfinite_count, 1)
end)

case("strides, views and derivatives", function()
  local points = floats(0.25, 0.25, 9, 0.75, 0.25, 9, 0.25, 0.75, 9)
  local u, v = shd.column(points, 0, 3), shd.column(points, 1, 3)
  local out = ffi.new("float[?]", 6)
  texture:sample(sampler, {u = u, v = v}, {channel = {shd.column(out, 0, 2)}, du = {shd.column(out, 1, 2)}})
  equal(out[0], 0)
  equal(out[2], 1)
  equal(out[4], 2)
  assert(out[1] ~= 0)
  local pointer = ffi.cast("float *", points)
  equal(texture:sample(sampler, {u = shd.view(pointer, 1), v = shd.view(pointer + 1, 1)}).channel[1][0], 0)
end)

case("columns that do not fit are refused by name", function()
  local function look(lookups, out) return texture:sample(sampler, lookups, out or {}) end
  local two = floats(0, 0)
  refused("lookups.v: 1 elements, not 2", look, {u = two, v = floats(0)})
  refused("lookups.v: 1 elements, not 2", look, {u = two, v = floats(0), count = 2})
  refused("lookups.u: 2 elements, not 3", look, {u = two, v = two, count = 3})
  refused("lookups.u: an array of float, not double", look, {u = ffi.new("double[2]"), v = two})
  refused("lookups.layer: an array of uint32_t, not float", look, {u = two, v = two, layer = two})
  refused("lookups.u: const float * has no length", look, {u = ffi.cast("const float *", two), v = two})
  refused("lookups.u[2]: a number, not string", look, {u = {0, "a"}, v = two})
  refused("lookups.layer[1]: -1 is no uint32_t", look, {u = two, v = two, layer = {-1, 0}})
  refused("texels.channel[2]: 1 elements, not 2", look, {u = two, v = two}, {channel = {two, floats(0)}})
  refused("texels.channel[1]: an array of float, not uint8_t", look, {u = two, v = two},
    {channel = {ffi.new("uint8_t[2]")}})
end)

case("columns of the wrong kind", function()
  local two = floats(0, 0)
  local function look(lookups, out) return texture:sample(sampler, lookups, out or {}) end
  refused("texels.channel[1]: an array of ffi, not table", look, {u = two, v = two}, {channel = {{}, {}}})
  refused("texels.channel[5]: there are 4 columns", look, {u = two, v = two}, {channel = {[5] = two}})
  refused("the array is const", look, {u = two, v = two}, {channel = {ffi.new("const float[2]")}})
  refused("not aligned", look, {u = shd.view(ffi.cast("float *", ffi.cast("char *", two) + 1), 1), v = {0}})
  refused("texels: a table, not number", look, {u = two, v = two}, 3)
  refused("lookups: a table, not number", texture.sample, texture, sampler, 3)
  refused("column: stride 0", shd.column, two, 0, 0)
  refused("view: 3 elements of 2", shd.view, two, 3)
  equal(shd.column(two, 5, 1).count, 0)
end)

case("a prepared batch", function()
  local u, v, red = floats(0.25, 0.75), floats(0.25, 0.75), floats(0, 0)
  local batch = texture:prepare(sampler, {u = u, v = v}, {channel = {red}})
  batch()
  equal(red[1], 3)
  u[1], v[1] = 0.25, 0.25
  for _ = 1, 1000 do batch:run() end  -- the compiled trace
  equal(red[1], 0)
  u[0] = 0 / 0
  batch()
  equal(batch.nonfinite_count, 1)
  batch:close()
  batch:close()
  refused("lookup: the batch is closed", batch)
end)

case("a batch keeps its texture, sampler and arrays", function()
  local own = support.texture(context, {{5}})
  local other = shd.sampler(context, {filter = "nearest"})
  local red = floats(0)
  local batch = own:prepare(other, {u = floats(0.5), v = floats(0.5)}, {channel = {red}})
  own:close()
  other:close()
  own, other = nil, nil
  for _ = 1, 3 do collectgarbage() end
  batch()
  equal(red[0], 5)
  refused("texture: the texture is closed", texture.prepare, (function()
    local closed = support.texture(context, {{5}})
    closed:close()
    return closed
  end)(), sampler, {u = {0}, v = {0}}, {})
end)

case("an error of the library in a batch", function()
  local batch = texture:prepare(sampler, {u = floats(0), v = floats(0)}, {channel = {floats(0)}})
  batch._lookups.u.stride = 3
  local problem
  for _ = 1, 200 do problem = refused("stride", batch) end
  equal(problem.result, "error_invalid_argument")
end)

case("texels", function()
  local bytes = ffi.new "uint8_t[16]"
  local function make(more)
    local desc = {width = 2, height = 2, format = "rgba8", texels = bytes}
    for key, value in pairs(more) do desc[key] = value end
    return shd.texture(context, desc)
  end
  make {}
  make {texels = ("\0"):rep(16)}
  refused("texture.texels: 16 bytes, not 24", make, {height = 3})
  refused("texture.texels: 16 bytes, not 20", make, {row_stride = 12})
  refused("texture.texels: 16 bytes, not 48", make, {layer_count = 3})
  refused("texture.texels: 15 bytes, not 16", make, {texels = ("x"):rep(15)})
  refused("texture.texels: 16 bytes, not 144", make, {flags = "borrow"})
  refused("texture.texels: an array of float, not uint8_t", make, {format = "rgba32f"})
  refused("texture.texels: an array of ffi, not table", make, {texels = {1, 2}})
  refused("texture.texels: ", make, {width = 2 ^ 32 - 1, height = 2 ^ 32 - 1})
  refused("texture.width: 0", make, {width = 0})
  refused("texture.format", make, {format = "none"})
  refused("texture.level_images: 3 elements, not 2", make, {level_count = 2, level_images = {{}, {}, {}}})
end)

case("kinds of textures", function()
  local texels = floats(0, 1, 2, 3, 4, 5)
  local function make(more)
    local desc = {width = 1, height = 1, format = "r32f", texels = texels}
    for key, value in pairs(more) do desc[key] = value end
    return shd.texture(context, desc)
  end
  local function info(more)
    local made = make(more):get_info()
    return ("%s %d %d"):format(made.kind, made.depth, made.layer_count)
  end
  equal(info {}, "2d 0 1")
  equal(info {depth = 6}, "3d 6 1")
  equal(info {kind = "2d", layer_count = 6}, "2d 0 6")
  equal(info {projection = "lat_long"}, "directions 0 1")
  equal(info {projection = "lat_long", layer_count = 3}, "directions 0 3")
  equal(info {projection = "cube", layer_count = 6}, "directions 0 6")
  local axes = {u = {1, -1, 0, 0, 0, 0}, v = {0, 0, 1, -1, 0, 0}, w = {0, 0, 0, 0, 1, -1}}
  local found = make({projection = "cube"}):sample(shd.sampler(context, {filter = "nearest"}), axes).channel[1]
  for i = 0, 5 do equal(found[i], i) end
  local images = {}
  for i = 1, 6 do images[i] = {width = 1, height = 1, format = "r32f", pixels = floats(10 + i)} end
  local cube = make {width = 2, height = 2, texels = ffi.new "float[24]", projection = "cube", tables = "mipmap",
    level_images = images}
  for i = 1, 6 do equal(cube:read_level(i - 1, 1)[0], 10 + i) end
  refused("texture.level_images: 5 elements, not a multiple of 6", make, {width = 2, height = 2,
    texels = ffi.new "float[24]", projection = "cube", tables = "mipmap",
    level_images = {images[1], images[2], images[3], images[4], images[5]}})
  refused("texture.kind: depth is of 3D textures and projection of directions", make, {depth = 6, projection = "cube"})
  refused("texture.projection: 4, but texture.kind", make, {depth = 6, kind = "3d", projection = "cube"})
  refused("texture.depth: 7, but texture.kind is not", make, {depth = 7, kind = "2d", layer_count = 6})
  refused("texture.layer_count: 9", make, {projection = "cube", layer_count = 9})
  refused("texture.texels: 24 bytes, not 28", make, {depth = 7})
  refused("texture.texels: 8 bytes, not 24", make, {projection = "cube", texels = floats(1, 2)})
  refused('texture.kind: "4d" is none of 2d, 3d, directions', make, {kind = "4d"})
  refused("texture.projection", make, {projection = "none"})
end)

case("compressed blocks", function()
  -- The first row of BC1 is red, blue and colours between them; BC7 is one colour, in mode 6.
  local bc1 = string.char(0x00, 0xf8, 0x1f, 0x00, 0xe4, 0, 0, 0)
  local bc7 = string.char(192, 255, 159, 66, 1, 0, 254, 255, 1, 0, 0, 0, 0, 0, 0, 0)
  local nearest = shd.sampler(context, {filter = "nearest_mip"})
  local function sample(desc, lod)
    local out = shd.texture(context, desc):sample(nearest, {u = {0.375}, v = {0.125}, lod = {lod}})
    local codes = {}
    for c = 1, 4 do codes[c] = math.floor(out.channel[c][0] * 255 + 0.5) end
    return table.concat(codes, " ")
  end
  equal(sample({width = 4, height = 4, format = "bc1_rgb", texels = bc1}, 0), "0 0 255 255")
  equal(sample({width = 3, height = 1, format = "bc7", texels = bc7}, 0), "255 41 1 255")
  local pixels = ffi.new("uint8_t[16]")
  ffi.copy(pixels, bc7, 16)
  local levels = {{width = 4, height = 2, format = "bc7", pixels = pixels}}
  local desc = {width = 8, height = 4, format = "bc7", texels = ("\0"):rep(32), tables = "mipmap",
    level_images = levels}
  equal(sample(desc, 0), "0 0 0 0")
  equal(sample(desc, 1), "255 41 1 255")
  refused("texture.texels: 16 bytes, not 32", sample, {width = 5, height = 4, format = "bc7", texels = bc7}, 0)
  levels[1].pixels = ffi.new "uint8_t[8]"
  refused("pixels: 8 bytes, not 16", sample, desc, 0)
end)

case("borrowed texels live as long as their texture", function()
  local big = ffi.new("float[?]", 1 + 32)
  big[0] = 4
  local borrowed = shd.texture(context, {width = 1, height = 1, format = "r32f", texels = big, flags = "borrow"})
  local weak = setmetatable({big}, {__mode = "v"})
  big = nil
  collectgarbage()
  assert(weak[1])
  equal(borrowed:sample(sampler, {u = {0}, v = {0}}).channel[1][0], 4)
end)

case("levels, explanations, updates", function()
  local pyramid = support.texture(context, {{0, 1}, {2, 3}}, {tables = "mipmap"})
  local texels, width, height = pyramid:read_level(0, 1)
  equal(texels[0], 1.5)
  equal(width * height, 1)
  local explained = texture:explain(sampler, {u = {0.5}, v = {0.5}})
  equal(#explained.taps, 4)
  equal(explained.taps[1].weight, 0.25)
  equal(explained.filter, "bilinear")
  refused("index", texture.explain, texture, sampler, {u = {0.5}, v = {0.5}}, 1)
  pyramid:update(0, 1, 1, {width = 1, height = 1, format = "r32f", pixels = floats(9)})
  equal(pyramid:read_level()[3], 9)
  refused("image.pixels: 4 bytes, not 8", pyramid.update, pyramid, 0, 0, 0,
    {width = 2, height = 1, format = "r32f", pixels = floats(9)})
  equal(pyramid:query_levels(sampler, {u = {0}, v = {0}, dudx = {0.5}}).lod[0], 0)
end)
