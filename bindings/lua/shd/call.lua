-- SPDX-License-Identifier: MIT
-- Any function of the library with values of Lua: call("shd_matrix_look_at", {0, 0, 3}, {0, 0, 0}, {0, 1, 0}).
--
-- Parameters named out_... are results instead. A parameter that is the length of a list is left out.
local ffi = require "ffi"
local array = require "shd.array"
local callback = require "shd.callback"
local convert = require "shd.convert"
local enums = require "shd.enums"
local library = require "shd.native"
local object = require "shd.object"
local read = require "shd.read"
local sizes = require "shd.sizes"
local tables = require "shd.tables"
local C, refuse = library.C, library.refuse

-- Functions for which values of Lua make no sense; library.C has them.
local RAW = {shd_context_allocate = true, shd_context_free = true, shd_context_parallel_for = true,
  shd_color_apply_view = true, shd_report_error = true, shd_desc_init = true, shd_texture_explain = true}

for _, entry in pairs(tables.functions) do
  for _, parameter in ipairs(entry) do
    parameter.is_out = parameter[1]:match("^out_") ~= nil and parameter[2] ~= "columns"
  end
end

-- The parameters that are lengths of lists, kept in the entry of the function.
local function lengths_of(entry)
  if entry.lengths then return entry.lengths end
  local lengths = {}
  for _, parameter in ipairs(entry) do
    for _, other in ipairs(entry) do
      if parameter.length and parameter.length[1] == other[1] then lengths[other[1]] = parameter end
    end
  end
  entry.lengths = lengths
  return lengths
end

-- Memory for a result, and the function that reads it.
local function make_out(parameter, state)
  local base = parameter[3]
  if parameter[2] == "out_handle" then
    local out = ffi.new(base .. " *[1]")
    return out, function() return out[0] ~= nil and object.wrap(base, out[0], state) or nil end
  elseif parameter[2] == "structs" then
    local out = convert.new(base)
    return out, function()
      local made = read(base, out, state)
      made.owner = tables.structs[base].has_pointer and state.first or nil
      return made
    end
  elseif parameter.length then
    local out = ffi.new(base .. "[?]", tonumber(parameter.length[1]))
    return out, function() return out end
  end
  local out = ffi.new(base .. "[1]")
  return out, function() return tonumber(out[0]) end
end

local function is_pointer(class) return class == "data" or class == "callback" end

for _, entry in pairs(tables.structs) do
  for _, field in ipairs(entry) do entry.has_pointer = entry.has_pointer or is_pointer(field[2]) end
end

-- A parameter of each class: give(parameter, value, state, label) -> value of C, length.
local give = {}

function give.number(parameter, value, _, label) return convert.number(value, parameter[3], label) end
function give.enum(parameter, value, _, label) return enums.value(parameter[3], value, label) end
function give.string(_, value, state, label) return convert.string(value, state, label) end

function give.handle(parameter, value, state, label)
  state.first = state.first or value
  return object.handle(value, parameter[3], state, label)
end

function give.structs(parameter, value, state, label)
  return convert.struct_pointer(parameter, value, state, label)
end

function give.columns(parameter, value, state, label)
  local count = parameter.length and tonumber(parameter.length[1]) or 1
  local made = ffi.new(parameter[3] .. "[?]", count)
  convert.columns(made, parameter[3], count, value, "rows", state, label)
  return made
end

function give.data(parameter, value, state, label)
  local base, needed = parameter[3], parameter.length and tonumber(parameter.length[1]) or sizes.vectors[parameter[1]]
  if base == "void" then return array.bytes(value, nil, not parameter.const, label, state.keep) end
  local pointer, stride, count = array.elements(value, base, not parameter.const, label, state.keep)
  if stride ~= ffi.sizeof(base) then refuse("%s: the array is not packed", label) end
  if needed and count < needed then refuse("%s: %d elements, not %d", label, count, needed) end
  return pointer, count
end

-- Other classes may be NULL; the library refuses a NULL that it cannot use.
local REQUIRED = {number = true, enum = true, handle = true}

local function give_parameter(parameter, value, state)
  local label = parameter[2] == "structs" and convert.short(parameter[3]) or parameter[1]
  if not give[parameter[2]] then refuse("%s: only library.C takes it", parameter[1]) end
  if value == nil and not REQUIRED[parameter[2]] then return nil end
  if value == nil and parameter.nullable then return nil end
  return give[parameter[2]](parameter, value, state, label)
end

-- The executor of the desc of a context. A null pointer of ffi equals nil but is a value, so only tables count.
local function executor_of(desc)
  local executor = type(desc) == "table" and desc.executor
  return type(executor) == "table" and executor.parallel_for ~= nil and executor or nil
end

-- The number of workers of a new context, as far as functions of Lua may run on them. An executor of C may run its one
-- worker on another thread.
local function workers_of(context, desc)
  local executor = executor_of(desc)
  return executor and type(executor.parallel_for) == "cdata" and math.huge or tonumber(C.shd_context_get_worker_count(context))
end

-- A function of Lua in the desc of a context must have one worker before the context is made.
local function check_new_context(state, desc)
  if not state.callbacks then return end
  local executor = executor_of(desc)
  if (executor or desc).worker_count ~= 1 or (executor and type(executor.parallel_for) == "cdata") then
    refuse("%s: a function of Lua needs a context with worker_count = 1", state.callbacks)
  end
end

local RENDERS = {shd_render = true, shd_bake = true, shd_color_render = true}

-- Calls C. A callback may run, so this must not be part of a trace of the compiler.
local function invoke(name, count, values, state)
  local framebuffer = RENDERS[name] and state.framebuffer
  if not framebuffer then return C[name](unpack(values, 1, count)) end
  framebuffer._busy = true
  local good, returned = pcall(C[name], unpack(values, 1, count))
  framebuffer._busy = nil
  if not good then error(returned, 0) end
  return returned
end
jit.off(invoke)

local function results_of(entry, returned, outs, state)
  local class, base = entry.result[1], entry.result[2]
  if base == "shd_result" then
    library.check(returned)
  elseif base ~= "void" then
    local value = returned
    if class == "handle" then
      value = returned ~= nil and object.share(base, returned, state) or nil
    elseif class == "string" then
      value = returned ~= nil and ffi.string(returned) or nil
    else
      value = tonumber(returned)
    end
    return value
  end
  for i, out in ipairs(outs) do outs[i] = out() end
  return unpack(outs)
end

-- The values of C for the values of Lua.
local function values_of(name, entry, state, ...)
  local values, outs, given, lengths = {}, {}, 0, lengths_of(entry)
  local counts = {}
  for i, parameter in ipairs(entry) do
    if parameter.is_out then
      values[i], outs[#outs + 1] = make_out(parameter, state)
    elseif not lengths[parameter[1]] then
      given = given + 1
      local value, count = give_parameter(parameter, (select(given, ...)), state)
      values[i] = value
      if parameter.length then counts[parameter.length[1]] = count or 0 end
    end
  end
  for i, parameter in ipairs(entry) do
    if lengths[parameter[1]] then values[i] = counts[parameter[1]] end
  end
  if select("#", ...) > given then refuse("%s: %d arguments, not %d", name, select("#", ...), given) end
  return values, outs
end

local function call(name, ...)
  local entry = tables.functions[name]
  if RAW[name] or name:match("^shd_object_") then refuse("%s: only library.C has it", name) end
  callback.guard(name)
  local state = convert.state()
  state.rows = sizes.rows_of(name, ...)
  local values, outs = values_of(name, entry, state, ...)
  if name == "shd_context_create" then check_new_context(state, ...) end
  callback.check_workers(state)
  local returned = invoke(name, #entry, values, state)
  object.flush()
  if callback.has_failed() then
    pcall(results_of, entry, returned, outs, state)  -- the collector releases what the call made
    callback.finish()
  end
  if name == "shd_context_create" and tonumber(returned) == 0 then
    state.workers = workers_of(values[2][0], ...)
  end
  for _, item in ipairs(state.after) do
    if entry.result[2] ~= "shd_result" or returned == 0 then read(item[1], item[2], state, item[3]) end
  end
  return results_of(entry, returned, outs, state)
end

object.set_call(call)
return call
