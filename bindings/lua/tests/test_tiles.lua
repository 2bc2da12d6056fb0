-- SPDX-License-Identifier: MIT
-- Textures in tile caches.
local ffi = require "ffi"
local library = require "shd.native"
local shd = require "shd"
local support = require "support"
local case, equal, refused = support.case, support.equal, support.refused

local WIDTH, HEIGHT, COUNT = 100, 70, 500
local REGION = {level = 1, area = {width = 50, height = 35}}
local context = shd.context {worker_count = 1}

local texels = ffi.new("uint8_t[?]", WIDTH * HEIGHT * 4)
for i = 0, WIDTH * HEIGHT * 4 - 1 do texels[i] = (i * 7919) % 251 end
local memory = shd.texture(context, {format = "rgba8", width = WIDTH, height = HEIGHT, tables = "mipmap",
  texels = texels})
local levels = {}
for level = 0, memory:get_info().level_count - 1 do
  local bytes, width = memory:read_level(0, level)
  levels[level] = {bytes = bytes, width = width}
end

local lookups = {u = ffi.new("float[?]", COUNT), v = ffi.new("float[?]", COUNT), lod = ffi.new("float[?]", COUNT)}
for i = 0, COUNT - 1 do
  lookups.u[i], lookups.v[i], lookups.lod[i] = (i * 37 % COUNT) / COUNT, (i * 91 % COUNT) / COUNT, i / 83
end

-- A cache, and a texture in it; `source.problem` is raised in place of the next tiles.
local function make(more)
  local source = {calls = 0, tiles = 0}
  local cache = shd.tile_cache(context, {tile_bytes = 1024, budget_bytes = 2 ^ 20})
  local function load(tiles, count)
    source.calls, source.tiles = source.calls + 1, source.tiles + count
    local problem = source.problem
    source.problem = nil
    if problem then error(problem, 0) end
    for i = 0, count - 1 do
      local tile, level, area = tiles[i], levels[tiles[i].level], tiles[i].area
      for y = 0, area.height - 1 do
        ffi.copy(ffi.cast("uint8_t *", tile.texels) + y * tile.row_stride,
          level.bytes + ((area.y + y) * level.width + area.x) * 4, area.width * 4)
      end
    end
  end
  local desc = {format = "rgba8", width = WIDTH, height = HEIGHT, tables = "mipmap",
    tiles = {cache = cache, load = load}}
  for key, value in pairs(more or {}) do desc[key] = value end
  return shd.texture(context, desc), cache, source
end

local function sample(texture, missing)
  local sampler = shd.sampler(context, {filter = "trilinear", missing_tiles = missing})
  local out = texture:sample(sampler, lookups)
  local bytes = {}
  for i = 1, 4 do bytes[i] = ffi.string(out.channel[i], 4 * COUNT) end
  return table.concat(bytes)
end

local expected = sample(memory)

case("tiles have the bits of memory", function()
  local texture, cache, source = make()
  assert(sample(texture) == expected)
  local stats = cache:get_stats()
  equal(tonumber(stats.load_count), source.calls)
  equal(tonumber(stats.loaded_tile_count), source.tiles)
  equal(stats.resident_tile_count, source.tiles)
  assert(sample(texture) == expected)
  equal(source.calls, tonumber(stats.load_count))
  local other, _, count = make()
  local out = {channel = {ffi.new("float[?]", COUNT)}}
  local batch = other:prepare(shd.sampler(context, {filter = "trilinear"}), lookups, out)
  for _ = 1, 100 do batch() end
  assert(count.calls > 0 and ffi.string(out.channel[1], 4 * COUNT) == expected:sub(1, 4 * COUNT))
end)

case("an error of the function", function()
  local texture, cache, source = make()
  local kept = {"mine"}
  for _, run in ipairs {function() sample(texture) end, function() texture:load_tiles(REGION) end,
    function() texture:pin_tiles(REGION) end} do
    source.problem = kept
    local good, problem = pcall(run)
    assert(not good and problem == kept)
    texture:drop_tiles {level = 0, area = {width = WIDTH, height = HEIGHT}}
  end
  assert(tonumber(cache:get_stats().failed_tile_count) >= 3)
  assert(sample(texture) == expected)
end)

case("requested tiles", function()
  local texture, cache, source = make()
  assert(sample(texture, "coarser") ~= expected)
  equal(source.calls, 0)
  source.problem = "no tile"
  local good, problem = pcall(cache.load_requested, cache, 0)
  assert(not good and problem == "no tile", problem)
  repeat sample(texture, "coarser") until cache:load_requested(8) == 0
  assert(sample(texture, "coarser") == expected)
  equal(source.tiles, tonumber(cache:get_stats().loaded_tile_count + cache:get_stats().failed_tile_count))
end)

case("regions", function()
  local texture, cache, source = make()
  texture:pin_tiles(REGION)
  equal(cache:get_stats().pinned_tile_count, 12)
  texture:unpin_tiles(REGION)
  equal(cache:get_stats().pinned_tile_count, 0)
  refused("pinned", texture.unpin_tiles, texture, REGION)
  texture:load_tiles(REGION)
  equal(source.tiles, 12)
  texture:drop_tiles(REGION)
  texture:load_tiles(REGION)
  equal(source.tiles, 24)
end)

case("a function lives as long as its texture", function()
  local alive = setmetatable({}, {__mode = "v"})
  local texture = make()
  do
    local held = {}
    alive[1] = held
    texture = shd.texture(context, {format = "r8", width = 1, height = 1, tiles = {
      cache = shd.tile_cache(context, {budget_bytes = 2 ^ 20}), load = function() held.used = true end}})
  end
  local material = shd.material(context, {model = "unlit", slots = {{target = "diffuse", texture = texture}}})
  texture:close()
  texture = nil
  jit.flush()  -- traces keep what they refer to
  collectgarbage() collectgarbage()
  assert(alive[1])
  material:close()
  material = nil
  jit.flush()  -- traces keep what they refer to
  collectgarbage() collectgarbage()
  assert(not alive[1])
end)

case("what is refused", function()
  refused("layer_count", make, {layer_count = 0})
  refused("texture.tiles.load: a function", make, {tiles = {load = 3}})
  refused("texture.tiles.release: a function of C", make, {tiles = {release = print}})
  refused("texture.tiles.cache: a tile_cache, not a context", make, {tiles = {cache = context}})
  refused("budget_bytes: 1 is not", shd.tile_cache, context, {budget_bytes = 1})
  refused("texture", memory.load_tiles, memory, REGION)
  refused("tile_region has no field left", memory.load_tiles, memory, {left = 1})
end)

case("a tiled file", function()
  if not pcall(library.load, "shd_io") then
    print("skipped: a tiled file; libshd_io is not built")
    return
  end
  local path = arg[0]:match("^(.*)/") .. "/../../tiled.tif"
  local cache = shd.tile_cache(context, {budget_bytes = 2 ^ 20})
  local texture, info = shd.texture_open(context, path, {cache = cache, encoding = "linear"})
  equal(info.file_count, 1)
  equal(info.tile_width, 16)
  local bytes = ffi.new("uint8_t[256]")
  for i = 0, 255 do bytes[i] = i end
  assert(sample(texture) == sample(shd.texture(context, {format = "r8", width = 16, height = 16, texels = bytes})))
  equal(refused("nothing.tif", shd.texture_open, context, "nothing.tif", {cache = cache}).result, "error_not_found")
end)
