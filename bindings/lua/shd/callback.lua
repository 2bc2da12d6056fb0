-- SPDX-License-Identifier: MIT
-- Functions of Lua that the library calls.
--
-- LuaJIT runs a callback only on the thread of its Lua state, so the context must have one worker, except for callbacks
-- of a load, which run on the thread of the call. There is one C function for each type of callback. The user_data of C
-- is a number that selects the function of Lua: a function that was collected is then an error and not a stale pointer.
-- An error does not unwind through C: it is kept, and the call of the library raises it.
local ffi = require "ffi"
local array = require "shd.array"
local enums = require "shd.enums"
local library = require "shd.native"
local tables = require "shd.tables"
local C = library.C

local callback = {}

local ERROR_NOT_FOUND, ERROR_CANCELLED, ERROR_CALLBACK = 4, 8, 9
local LOOKUPS = {shd_texture_sample = true, shd_solid_evaluate = true}
-- Functions of the library that a callback may call; true = all.
local ALLOWED = {shd_fragment_fn = LOOKUPS, shd_vertex_fn = LOOKUPS, shd_slot_fn = LOOKUPS, shd_load_tiles_fn = true,
  ["shd_display.apply"] = true, ["shd_executor.parallel_for"] = true}

--- `depth` is the number of callbacks that run, `restricted` the set of functions that the innermost may call (nil =
--- all).
callback.status = {depth = 0, restricted = nil}
local status = callback.status

local entries = setmetatable({}, {__mode = "v"})
local entry_count = 0
local has_failed, failure = false, nil
local borrow  -- makes an object of a handle, for the time of a callback

function callback.set_borrow(make) borrow = make end

--- Callbacks that run on the thread of the call and end with it, so the context may have any number of workers.
callback.OF_CALL = {["shd_scene_desc.find"] = true}

-- The arguments of C as arguments of Lua, and the result of Lua as the result of C.
local adapters = {
  shd_fragment_fn = function(run, input, output) run(input, output) end,
  shd_vertex_fn = function(run, input, output) run(input, output) end,
  shd_slot_fn = function(run, input, output) run(input, output) end,
  shd_trace_fn = function(run, rays, blocked) run(rays, blocked) end,
  shd_load_tiles_fn = function(run, tiles, count)
    run(tiles, tonumber(count))
    return 0
  end,
  ["shd_scene_desc.find"] = function(run, name, out_bytes, out_size, entry)
    local answer = run(ffi.string(name))
    if answer == nil then return ERROR_NOT_FOUND end
    out_bytes[0], out_size[0] = array.bytes(answer, nil, false, "scene.find", entry)  -- which the call keeps
    return 0
  end,
  ["shd_log.write"] = function(run, level, text)
    run(enums.name("shd_log_level", tonumber(level)), ffi.string(text))
  end,
  ["shd_progress.report"] = function(run, fraction) return run(fraction) == false and ERROR_CANCELLED or 0 end,
  ["shd_present.tile"] = function(run, tile)
    run(tile)
    return 0
  end,
}

adapters["shd_display.apply"] = function(run, framebuffer, image)
  local object = borrow("shd_framebuffer", framebuffer)
  local good, problem = pcall(run, object, image)
  object._handle = nil
  if not good then error(problem, 0) end
  return 0
end

adapters["shd_executor.parallel_for"] = function(run, count, task, task_data)
  local is_open = true
  local function run_task(index, worker)
    if not is_open then library.refuse("task: the call of parallel_for has ended") end
    task(index, worker or 0, task_data)
  end
  jit.off(run_task)
  local good, problem = pcall(run, tonumber(count), run_task)
  is_open = false
  if not good then error(problem, 0) end
  return 0
end

local function fail(problem)
  if not has_failed then has_failed, failure = true, problem end
end

local function dispatch(name, user_data, a, b, c)
  local result = tables.callbacks[name].result
  local failed = result ~= "void" and ERROR_CALLBACK or nil
  if has_failed and result == "void" and name ~= "shd_log.write" then return failed end
  local entry = entries[tonumber(ffi.cast("uintptr_t", user_data))]
  if not entry then
    fail(setmetatable({result = "error_callback", message = name .. ": the function was collected"}, library.Error))
    return failed
  end
  local before, allowed = status.restricted, ALLOWED[name] or {}
  if allowed ~= true then status.restricted = allowed end
  status.depth = status.depth + 1
  local good, returned = pcall(adapters[name], entry[name], a, b, c, entry)
  status.depth = status.depth - 1
  status.restricted = before
  if not good then
    fail(returned)
    return failed
  end
  return returned
end

-- The functions for C by their number of parameters. The last one is user_data.
local runners = {
  [2] = function(name) return function(a, user_data) return dispatch(name, user_data, a) end end,
  [3] = function(name) return function(a, b, user_data) return dispatch(name, user_data, a, b) end end,
  [4] = function(name) return function(a, b, c, user_data) return dispatch(name, user_data, a, b, c) end end,
}

local trampolines = {}

-- The C function of a type of callback. It is never freed.
local function trampoline(name)
  if not trampolines[name] then
    local callback_type = tables.callbacks[name]
    trampolines[name] = ffi.cast(callback_type.type, runners[callback_type.parameters](name))
  end
  return trampolines[name]
end

--- The C function for a field of a struct. `state.entry` has the functions of one user_data.
function callback.bind(name, run, state, label)
  if not adapters[name] then library.refuse("%s: a function of C, not of Lua; it runs on any thread", label) end
  if not state.entry then
    entry_count = entry_count + 1
    state.entry = {id = entry_count}
    entries[entry_count] = state.entry
  end
  state.entry[name] = run
  return trampoline(name), ffi.cast("void *", state.entry.id)
end

--- Refuses a call in which functions of Lua might run on another thread.
function callback.check_workers(state)
  if state.callbacks and state.workers > 1 then
    library.refuse("%s: a function of Lua needs a context with worker_count = 1, not %s", state.callbacks,
      state.workers == math.huge and "an executor of C" or state.workers)
  end
end

--- Refuses a call that the running callback must not make.
function callback.guard(name)
  local allowed = status.restricted
  if allowed and not allowed[name] then library.refuse("%s: a callback must not call it", name) end
end

--- Whether finish() will raise an error.
function callback.has_failed() return status.depth == 0 and has_failed end

--- After a call: raises the error of a callback that ran in it.
function callback.finish()
  if status.depth > 0 or not has_failed then return end
  local problem = failure
  has_failed, failure = false, nil
  error(problem, 0)
end

return callback
