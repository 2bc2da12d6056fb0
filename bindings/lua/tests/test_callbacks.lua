-- SPDX-License-Identifier: MIT
-- Functions of Lua that the library calls.
local ffi = require "ffi"
local shd = require "shd"
local support = require "support"
local case, equal, refused, floats = support.case, support.equal, support.refused, support.floats

local context = shd.context {worker_count = 1}
local framebuffer = shd.framebuffer(context, {width = 48, height = 32})

local function program(run, more)
  local desc = {model = "program", program = {fragment = run}}
  for key, value in pairs(more or {}) do desc[key] = value end
  return shd.material(context, desc)
end

local function fill(input, out)
  for i = 0, tonumber(input.count) - 1 do out.r[i], out.g[i], out.b[i] = 1, 0.5, 0 end
end

case("a fragment program", function()
  local rows = 0
  support.frame(context, framebuffer, program(function(input, out)
    rows = rows + tonumber(input.count)
    fill(input, out)
  end))
  assert(rows > 100)
  equal(framebuffer:read_plane("r")[16 * 48 + 12], 1)
end)

case("an error in a program", function()
  local kept, count = {"mine"}, 0
  local bad = program(function()
    count = count + 1
    error(kept)
  end)
  for _ = 1, 50 do
    local good, problem = pcall(support.frame, context, framebuffer, bad)
    assert(not good and problem == kept)
  end
  equal(count, 50)
  support.frame(context, framebuffer, program(fill))
  local good, problem = pcall(support.frame, context, framebuffer, program(function() error(nil) end))
  assert(not good and problem == nil)
  good, problem = pcall(support.frame, context, framebuffer, program(function() coroutine.yield(1) end))
  assert(not good and tostring(problem):find("yield"), problem)
  good, problem = pcall(support.frame, context, framebuffer, program(function(input) return input.nothing end))
  assert(not good and tostring(problem):find("nothing"), problem)
end)

case("in a coroutine, and with the compiler at work", function()
  local material = program(fill)
  local run = coroutine.wrap(function()
    for _ = 1, 100 do support.frame(context, framebuffer, material) end
    return "done"
  end)
  equal(run(), "done")
end)

case("programs need one worker", function()
  local two = shd.context {worker_count = 2}
  if two:get_worker_count() == 1 then
    print("skipped: the machine has one core")
    return
  end
  local text = "material.program.fragment: a function of Lua needs a context with worker_count = 1, not 2"
  refused(text, shd.material, two, {model = "program", program = {fragment = fill}})
  refused(text, support.frame, two, shd.framebuffer(two, {width = 8, height = 8}), program(fill))
  refused("context.log.write: a function of Lua needs a context with worker_count = 1", shd.context,
    {log = {write = print}})
  refused("render.progress.report", support.frame, two, shd.framebuffer(two, {width = 8, height = 8}), nil,
    {progress = {report = print}})
  refused("context.allocator.allocate: a function of C", shd.context,
    {worker_count = 1, allocator = {allocate = print}})
  refused("material.program.fragment: a function, not string", shd.material, context, {program = {fragment = "x"}})
end)

case("a program may look up, and must not call more", function()
  local texture, sampler = support.texture(context, {{0.75}}), shd.sampler(context)
  local red = floats(0)
  local batch = texture:prepare(sampler, {u = floats(0.5), v = floats(0.5)}, {channel = {red}})
  support.frame(context, framebuffer, program(function(input, out)
    batch()
    equal(texture:sample(sampler, {u = {0.5}, v = {0.5}}).channel[1][0], red[0])
    for i = 0, tonumber(input.count) - 1 do out.r[i], out.g[i], out.b[i] = red[0], 0, 0 end
  end))
  equal(framebuffer:read_plane("r")[16 * 48 + 12], 0.75)
  refused("shd_render: a callback must not call it", support.frame, context, framebuffer, program(function()
    context:render {framebuffer = framebuffer}
  end))
  refused("shd_framebuffer_get_info: a callback must not call it", support.frame, context, framebuffer,
    program(function() framebuffer:get_info() end))
end)

case("releases wait for the end of the call", function()
  local own = shd.framebuffer(context, {width = 8, height = 8})
  local handle = ffi.cast("shd_framebuffer *", ffi.cast("void *", own._handle))
  local info = require("shd.convert").new("shd_framebuffer_info")
  local material
  material = program(function(input, out)
    own:close()
    material:close()
    collectgarbage()
    assert(shd.C.shd_framebuffer_get_info(handle, info) == 0)
    fill(input, out)
  end)
  support.frame(context, own, material)
  assert(shd.C.shd_framebuffer_get_info(handle, info) ~= 0)
  refused("render.draws[1].material: the material is closed", support.frame, context, framebuffer, material)
end)

case("a function that was collected is an error", function()
  local material = program(fill)
  material._anchors = nil
  collectgarbage()
  collectgarbage()
  local handle = material._handle
  material._anchors = {}
  local problem = refused("the function was collected", support.frame, context, framebuffer, material)
  equal(problem.result, "error_callback")
  assert(handle ~= nil)
end)

case("materials inside other objects keep their programs", function()
  local slot = {target = "diffuse", procedure = function(input, out)
    for i = 0, tonumber(input.count) - 1 do out[0][i] = 0.125 end
  end}
  local material = shd.material(context, {diffuse = {1, 1, 1}, ambient = {0, 0, 0}, slots = {slot}})
  slot = nil
  collectgarbage()
  collectgarbage()
  support.frame(context, framebuffer, material)
end)

case("progress, tiles, log and executor", function()
  local last, tiles, lines, order = 0, 0, {}, {}
  local own = shd.context {log = {write = function(level, text) lines[#lines + 1] = level .. " " .. text end},
    executor = {worker_count = 1, parallel_for = function(count, task)
      for i = count - 1, 0, -1 do
        order[#order + 1] = i
        task(i)
      end
    end}}
  own:log("warning", "here")
  equal(lines[1], "warning here")
  local target = shd.framebuffer(own, {width = 96, height = 96})
  support.frame(own, target, nil, {progress = {report = function(fraction) last = fraction end},
    present = {tile = function(tile) tiles = tiles + tile.area.width * tile.area.height end}})
  equal(last, 1)
  equal(tiles, 96 * 96)
  assert(#order > 1)
  support.frame(own, target, nil, {progress = {report = function() return true end}})
  local problem = refused("SHD_ERROR_CANCELLED", support.frame, own, target, nil,
    {progress = {report = function() return false end}})
  equal(problem.result, "error_cancelled")
  local good, text = pcall(support.frame, own, target, nil, {present = {tile = function() error("tile", 0) end}})
  assert(not good and text == "tile", text)
end)

case("two frames into one framebuffer", function()
  local target, nested
  local own = shd.context {executor = {worker_count = 1, parallel_for = function(count, task)
    if nested then
      nested = false
      support.frame(shd.context {worker_count = 1}, target)
    end
    for i = 0, count - 1 do task(i) end
  end}}
  target = shd.framebuffer(own, {width = 96, height = 96})
  nested = true
  refused("render.framebuffer: another call renders to it", support.frame, own, target)
  support.frame(own, target)
end)

case("a task after its call", function()
  local kept
  local own = shd.context {executor = {worker_count = 1, parallel_for = function(count, task)
    kept = task
    for i = 0, count - 1 do task(i) end
  end}}
  support.frame(own, shd.framebuffer(own, {width = 96, height = 96}))
  refused("task: the call of parallel_for has ended", kept, 0)
end)

case("an executor of C", function()
  local run = ffi.cast("shd_executor_parallel_for_fn", function() return 9 end)
  local own = shd.context {executor = {worker_count = 1, parallel_for = run}}
  refused("needs a context with worker_count = 1, not an executor of C", shd.material, own,
    {model = "program", program = {fragment = fill}})
  refused("context.log.write: a function of Lua", shd.context,
    {executor = {worker_count = 1, parallel_for = run}, log = {write = print}})
  local problem = refused("", support.frame, own, shd.framebuffer(own, {width = 96, height = 96}))
  equal(problem.result, "error_callback")
  own:close()
  collectgarbage()
  collectgarbage()
  run:free()
end)

case("an error in the log", function()
  local own = shd.context {worker_count = 1, log = {write = function(_, text) error(text, 0) end}}
  local good, problem = pcall(own.log, own, "error", "from the log")
  assert(not good and problem == "from the log")
  local texture = support.texture(own, {{2}})
  local batch = texture:prepare(shd.sampler(own), {u = {0}, v = {0}}, {channel = {floats(0)}})
  for _ = 1, 200 do batch() end
  batch:close()
  refused("lookup: the batch is closed", batch)
end)
