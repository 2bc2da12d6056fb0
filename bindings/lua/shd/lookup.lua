-- SPDX-License-Identifier: MIT
-- Batches of lookups that are prepared once and run many times.
local callback = require "shd.callback"
local convert = require "shd.convert"
local library = require "shd.native"
local object = require "shd.object"
local C, refuse = library.C, library.refuse

local lookup = {}

local status = callback.status
local texture_sample = C.shd_texture_sample

-- The call of C stays in a trace of the compiler: no function of Lua can run in it.
local function run(self)
  local allowed = status.restricted
  if allowed and not allowed.shd_texture_sample then callback.guard("shd_texture_sample") end
  if not self._texture then refuse("lookup: the batch is closed") end
  local result = texture_sample(self._texture, self._sampler, self._lookups, self._texels)
  if result ~= 0 then library.check(result) end
end

-- With a log or an executor in Lua, a function of Lua may run in the call.
local function run_hosted(self)
  callback.guard("shd_texture_sample")
  if not self._texture then refuse("lookup: the batch is closed") end
  local result = texture_sample(self._texture, self._sampler, self._lookups, self._texels)
  object.flush()
  callback.finish()
  library.check(result)
end
jit.off(run_hosted)

local function close(self)
  self._texture, self._sampler = nil, nil
end

local function index(methods)
  methods.close = close
  return function(self, key)
    if key == "nonfinite_count" then return tonumber(rawget(self, "_texels").nonfinite_count) end
    return methods[key]
  end
end

local Batch = {__index = index {run = run}, __call = run}
local HostedBatch = {__index = index {run = run_hosted}, __call = run_hosted}

-- A handle that keeps the object of C in use until it is collected.
local function hold(value, kind, state, label)
  return object.share(kind, object.handle(value, kind, state, label), state)
end

--- A batch: batch() reads the columns of `lookups` and writes those of `out` anew. The arrays, the texture and the
--- sampler stay in use as long as the batch.
function lookup.prepare(texture, sampler, lookups, out)
  callback.guard("shd_texture_sample")
  local state = convert.state()
  local objects = {hold(texture, "shd_texture", state, "texture"), hold(sampler, "shd_sampler", state, "sampler")}
  local columns = convert.build("shd_lookups", lookups, state, "lookups")
  local texels = convert.build("shd_texels", out, state, "texels")
  callback.check_workers(state)
  return setmetatable({_texture = objects[1]._handle, _sampler = objects[2]._handle, _lookups = columns,
    _texels = texels, _keep = {state, objects}}, state.callbacks and HostedBatch or Batch)
end

return lookup
