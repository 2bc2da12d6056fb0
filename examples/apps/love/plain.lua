-- SPDX-License-Identifier: MIT
-- The frames of main.lua's test mode without LÖVE, and their hash: luajit plain.lua TICKS
local here = arg[0]:match("^(.*)/") or "."
package.path = here .. "/?.lua;" .. here .. "/../../../bindings/lua/?.lua;" .. package.path
local ffi = require "ffi"
local scene = require "scene"

local WIDTH, HEIGHT = 640, 400
local stage, pixels, hash = scene.new(WIDTH, HEIGHT), ffi.new("uint8_t[?]", WIDTH * HEIGHT * 4), nil
for tick = 1, tonumber(arg[1]) do
  stage:draw(tick, (tick - 1) % #scene.filters + 1, pixels)
  hash = scene.hash(hash, pixels, ffi.sizeof(pixels))
end
print("love " .. bit.tohex(hash))
