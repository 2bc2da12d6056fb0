-- SPDX-License-Identifier: MIT
-- A window of LÖVE that shows frames of shd. The keys 1 to 7 choose the filter, space stops the camera.
--
--   love examples/apps/love                            the window
--   love examples/apps/love --test TICKS PICTURE.png   draws without a window, prints a hash, and writes the last frame
--
-- SHD_LIBRARY is the path of libshd.
package.path = love.filesystem.getSource() .. "/../../../bindings/lua/?.lua;" .. package.path
local scene = require "scene"

local WIDTH, HEIGHT = 640, 400
local stage, image_data, image
local tick, filter, is_moving = 0, 3, true

local function draw_tick()
  stage:draw(tick, filter, image_data:getFFIPointer())
end

local function test(ticks, path)
  local hash
  for i = 1, ticks do
    tick, filter = i, (i - 1) % #scene.filters + 1
    draw_tick()
    hash = scene.hash(hash, image_data:getFFIPointer(), image_data:getSize())
  end
  print("love " .. bit.tohex(hash))
  local file = assert(io.open(path, "wb"))
  file:write(image_data:encode("png"):getString())
  file:close()
end

function love.load(arguments)
  stage = scene.new(WIDTH, HEIGHT)
  image_data = love.image.newImageData(WIDTH, HEIGHT)
  if arguments[1] == "--test" then
    test(tonumber(arguments[2]), arguments[3])
    love.event.quit()
    return
  end
  draw_tick()
  image = love.graphics.newImage(image_data)
end

function love.update()
  if not image then return end
  if is_moving then tick = tick + 1 end
  draw_tick()
  image:replacePixels(image_data)
end

function love.draw()
  love.graphics.draw(image)
  love.graphics.print(("%d: %s   %d frames/s"):format(filter, scene.filters[filter], love.timer.getFPS()), 10, 10)
end

function love.keypressed(key)
  local number = tonumber(key)
  if number and scene.filters[number] then filter = number end
  if key == "space" then is_moving = not is_moving end
  if key == "escape" then love.event.quit() end
end
