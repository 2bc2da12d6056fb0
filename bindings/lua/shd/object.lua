-- SPDX-License-Identifier: MIT
-- Objects: one reference of C each, dropped by close() or by the garbage collector.
local ffi = require "ffi"
local callback = require "shd.callback"
local library = require "shd.native"
local tables = require "shd.tables"
local C, refuse = library.C, library.refuse

local object = {}

-- A running call uses objects, and most callbacks must not call the library: while a callback runs, releases wait until
-- the outermost call ends.
local deferred = {}
local status = callback.status

local function drop(kind, handle)
  if status.depth > 0 then
    deferred[#deferred + 1] = {kind, handle}
  else
    C[tables.handles[kind].release](handle)
  end
end
jit.off(drop)

--- Releases what was dropped while a callback ran.
function object.flush()
  while #deferred > 0 and status.depth == 0 do
    local kind, handle = unpack(table.remove(deferred))
    C[tables.handles[kind].release](handle)
  end
end
jit.off(object.flush)

local finalizers = {}
for kind in pairs(tables.handles) do
  finalizers[kind] = function(handle) drop(kind, handle) end
  jit.off(finalizers[kind])
end

local function short(kind) return (kind:gsub("^shd_", "")) end

local methods, metatables = {}, {}

--- Methods of the objects of a kind, to which other modules add.
function object.methods(kind)
  methods[kind] = methods[kind] or {}
  return methods[kind]
end

local call  -- the generic call; set by call.lua
function object.set_call(run) call = run end

-- A method that is a function of C whose first argument is the object.
local function find_method(kind, key)
  for _, name in ipairs {kind .. "_" .. tostring(key), "shd_" .. tostring(key)} do
    local entry = tables.functions[name]
    if entry and entry[1] and entry[1][2] == "handle" and entry[1][3] == kind and key ~= "retain" and
      key ~= "release" then
      return function(...) return call(name, ...) end
    end
  end
end

local function metatable_of(kind)
  if not metatables[kind] then
    local own = object.methods(kind)
    function own.close(self) object.close(self) end
    metatables[kind] = {
      __index = function(_, key)
        if own[key] == nil and type(key) == "string" and key:sub(1, 1) ~= "_" then own[key] = find_method(kind, key) end
        return own[key]
      end,
      __tostring = function(self) return short(kind) .. (self._handle and "" or " (closed)") end,
    }
  end
  return metatables[kind]
end

--- An object over a reference, which it owns. `state` is the call that made it: what the call used stays in memory as
--- long as the object, as far as the library uses it after the call.
function object.wrap(kind, handle, state)
  return setmetatable({_kind = kind, _handle = ffi.gc(handle, finalizers[kind]), _workers = state.workers,
    _callbacks = state.callbacks, _anchors = state.anchors}, metatable_of(kind))
end

--- Another object for a handle whose reference belongs to someone else.
function object.share(kind, handle, state)
  -- A cast to the type that a cdata already has gives the same cdata, which has its own finalizer.
  local own = ffi.cast(kind .. " *", ffi.cast("void *", handle))
  C[tables.handles[kind].retain](own)
  return object.wrap(kind, own, state)
end

callback.set_borrow(function(kind, handle)
  return setmetatable({_kind = kind, _handle = handle, _workers = 1, _anchors = {}}, metatable_of(kind))
end)

--- Drops the reference. Closing again has no effect.
function object.close(self)
  local handle = rawget(self, "_handle")
  if handle == nil then return end
  self._handle = nil
  drop(self._kind, ffi.gc(handle, nil))
end

function object.is_object(value)
  return type(value) == "table" and rawget(value, "_kind") ~= nil
end

--- The handle of an object for a call.
function object.handle(value, kind, state, label)
  if not object.is_object(value) then refuse("%s: a %s, not %s", label, short(kind), type(value)) end
  if value._kind ~= kind then refuse("%s: a %s, not a %s", label, short(kind), short(value._kind)) end
  if value._handle == nil then refuse("%s: the %s is closed", label, short(kind)) end
  if kind == "shd_framebuffer" then
    if value._busy then refuse("%s: another call renders to it", label) end
    state.framebuffer = value
  end
  state.workers = math.max(state.workers, value._workers)
  state.callbacks = state.callbacks or value._callbacks
  state.anchors[#state.anchors + 1] = value._anchors
  state.keep[#state.keep + 1] = value
  return value._handle
end

return object
