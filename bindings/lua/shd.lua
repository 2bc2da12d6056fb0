-- SPDX-License-Identifier: MIT
--- shd for LuaJIT: texture filtering, shading and software rasterisation on the CPU.
---
---   local shd = require "shd"
---   local context = shd.context {worker_count = 1}
---   local texture = shd.texture(context, {width = 2, height = 2, format = "rgba8_srgb", texels = texels})
---
--- shd.<noun> makes an object: shd_mesh_create is shd.mesh. Every other function of C has its name without "shd_", and
--- is a method of its first argument: shd.render(context, frame), context:render(frame).
if not pcall(require, "shd.tables") then
  error("shd/tables.lua is not in git: run `python3 bindings/generate.py lua` in the clone", 0)
end
local array = require "shd.array"
local call = require "shd.call"
local library = require "shd.native"
local tables = require "shd.tables"
require "shd.methods"

local shd = {
  version = library.version,
  view = array.view,
  column = array.column,
  C = library.C,
  Error = library.Error,
  constants = tables.constants,
}

--- Whether a value is an error of the library or of this module.
function shd.is_error(value)
  return getmetatable(value) == library.Error
end

return setmetatable(shd, {__index = function(self, key)
  for _, name in ipairs {"shd_" .. tostring(key) .. "_create", "shd_" .. tostring(key)} do
    local entry = tables.functions[name]
    if entry then
      local own = entry[1] and entry[1][2] == "handle" and name ~= "shd_" .. key .. "_create"
      self[key] = function(first, ...)
        if own and type(first) == "table" then
          local kind = entry[1][3]
          local method = key:gsub("^" .. kind:gsub("^shd_", "") .. "_", "")
          if rawget(first, "_kind") == kind then return first[method](first, ...) end
        end
        return call(name, first, ...)
      end
      return self[key]
    end
  end
end})
