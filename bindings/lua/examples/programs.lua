-- SPDX-License-Identifier: MIT
-- The three programs that every binding has (bindings/c/programs.c).
--
--   luajit programs.lua            prints the hashes
--   luajit programs.lua --speed    prints the time of a call of one lookup, and of a batch of 2^20
package.path = (arg[0]:match("^(.*)/examples/") or "..") .. "/?.lua;" .. package.path
local ffi = require "ffi"
local shd = require "shd"

local SIZE, LOOKUPS, WIDTH, HEIGHT, BATCH, CALLS = 64, 16384, 320, 200, 2 ^ 20, 200000

-- FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte.
local function hash_bytes(hash, array)
  local bytes = ffi.cast("const uint8_t *", array)
  for i = 0, ffi.sizeof(array) - 1 do hash = bit.bxor(hash, bytes[i]) * 0x100000001b3ULL end
  return hash
end

local function print_hash(name, ...)
  local hash = 0xcbf29ce484222325ULL
  for _, array in ipairs {...} do hash = hash_bytes(hash, array) end
  print(name .. " " .. bit.tohex(hash))
end

local function create_texture(context)
  local texels = ffi.new("uint8_t[?]", SIZE * SIZE * 4)
  for y = 0, SIZE - 1 do
    for x = 0, SIZE - 1 do
      local i = (y * SIZE + x) * 4
      texels[i], texels[i + 1], texels[i + 2], texels[i + 3] = x * 4, y * 4, bit.bxor(x, y) * 4, 255
    end
  end
  return shd.texture(context, {width = SIZE, height = SIZE, format = "rgba8_srgb", texels = texels, tables = "mipmap"})
end

local function columns(count, ...)
  local made = {}
  for i, name in ipairs {...} do made[name], made[i] = ffi.new("float[?]", count), nil end
  return made
end

-- 1. A batch of lookups: footprints of many sizes and directions, filtered with EWA.
local function look_up(context)
  local texture = create_texture(context)
  local sampler = shd.sampler(context, {filter = "ewa", max_anisotropy = 16})
  local q = columns(LOOKUPS, "u", "v", "dudx", "dvdx", "dudy", "dvdy")
  for i = 0, LOOKUPS - 1 do
    q.u[i] = i % 128 / 64
    q.v[i] = math.floor(i / 128) / 128
    q.dudx[i] = (1 + i % 7) / 256
    q.dvdx[i] = i % 5 / 512
    q.dudy[i] = i % 3 / -512
    q.dvdy[i] = (1 + i % 11) / 1024
  end
  print_hash("lookup", unpack(texture:sample(sampler, q).channel))
end

-- Renders a torus of one material in the light of the sun, with four samples a pixel.
local function draw(context, name, material)
  local torus = shd.mesh_create_shape(context, {kind = "torus"}, 0)
  local sun = shd.light(context, {kind = "directional", direction = {-0.5, -1, -0.25}})
  local framebuffer = shd.framebuffer(context, {width = WIDTH, height = HEIGHT, sample_count = 4})
  context:render {framebuffer = framebuffer, draws = {{mesh = torus, material = material}}, lights = {sun},
    camera = {eye = {0.5, 1.5, 2}}}
  print_hash(name, framebuffer:read_color("rgba8_srgb"))
end

-- 2. A frame: the material has a texture.
local function draw_textured(context)
  local texture = create_texture(context)
  local sampler = shd.sampler(context, {filter = "trilinear", max_anisotropy = 16})
  draw(context, "frame", shd.material(context, {model = "blinn_phong",
    slots = {{target = "diffuse", texture = texture, sampler = sampler}}}))
end

-- 3. A fragment program: shows the texture coordinates.
local function draw_program(context)
  local blue = 0.25
  local function uv_as_colour(input, out)
    for i = 0, tonumber(input.count) - 1 do
      out.r[i] = input.u[i]
      out.g[i] = input.v[i]
      out.b[i] = blue
    end
  end
  draw(context, "program", shd.material(context, {model = "program", program = {fragment = uv_as_colour}}))
end

ffi.cdef [[
typedef struct { long seconds, nanoseconds; } programs_time;
int clock_gettime(int clock, programs_time *time);
]]
local time = ffi.new "programs_time"

local function now()
  ffi.C.clock_gettime(1, time)  -- CLOCK_MONOTONIC
  return tonumber(time.seconds) + 1e-9 * tonumber(time.nanoseconds)
end

-- Seconds of `calls` runs of a batch, the best of seven.
local function measure(batch, calls)
  local best = math.huge
  for _ = 1, 7 do
    local start = now()
    for _ = 1, calls do batch() end
    best = math.min(best, now() - start)
  end
  return best
end

local function print_speed()
  local context = shd.context {worker_count = 1}
  local texture = create_texture(context)
  local sampler = shd.sampler(context, {filter = "trilinear", max_anisotropy = 16})
  local q = columns(BATCH, "u", "v", "lod")
  for i = 0, BATCH - 1 do q.u[i], q.v[i], q.lod[i] = i % 1024 / 1024, math.floor(i / 1024) / 1024, i % 16 / 8 end
  local out = {channel = {}}
  for i = 1, 4 do out.channel[i] = ffi.new("float[?]", BATCH) end
  q.count = 1
  print(("call %.2f ns"):format(1e9 * measure(texture:prepare(sampler, q, out), CALLS) / CALLS))
  q.count = BATCH
  print(("batch %.4f ms"):format(1e3 * measure(texture:prepare(sampler, q, out), 3) / 3))
end

if arg[1] == "--speed" then
  print_speed()
else
  local context = shd.context {worker_count = 1}
  look_up(context)
  draw_textured(context)
  draw_program(context)
end
