-- SPDX-License-Identifier: MIT
-- Modules of LÖVE. In the test mode (--test) there is no window.
function love.conf(t)
  local is_test = false
  for _, value in ipairs(arg) do is_test = is_test or value == "--test" end
  t.version = "11.4"
  t.identity = nil
  t.window.title = "shd"
  t.window.width, t.window.height = 640, 400
  for _, name in ipairs {"audio", "sound", "physics", "joystick", "video", "touch"} do t.modules[name] = false end
  if is_test then
    for _, name in ipairs {"window", "graphics", "mouse", "font", "keyboard"} do t.modules[name] = false end
  end
end
