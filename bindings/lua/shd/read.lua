-- SPDX-License-Identifier: MIT
-- Structs of C to tables of Lua.
local ffi = require "ffi"
local enums = require "shd.enums"
local object = require "shd.object"
local tables = require "shd.tables"

local function numbers(array, dimensions)
  local made = {}
  for i = 1, dimensions[1] do
    made[i] = dimensions[2] and numbers(array[i - 1], {dimensions[2]}) or tonumber(array[i - 1])
  end
  return made
end

local read

-- The length of a list, from the field that has it.
local function length(struct, field)
  local total = 1
  for _, name in ipairs(field.length or {}) do total = total * tonumber(tonumber(name) or struct[name]) end
  return total
end

-- A value of each class: get(value, field, struct, state).
local get = {}

function get.number(value) return tonumber(value) end
function get.enum(value, field) return enums.name(field[3], tonumber(value)) end
function get.numbers(value, field) return numbers(value, field.array) end
function get.chars(value) return ffi.string(value) end
function get.string(value) return value ~= nil and ffi.string(value) or nil end
function get.data(value) return value ~= nil and value or nil end
get.callback = get.data

function get.enums(value, field)
  local made = {}
  for i = 1, field.array[1] do made[i] = enums.name(field[3], tonumber(value[i - 1])) end
  return made
end

function get.struct(value, field, _, state) return read(field[3], value, state) end

function get.handle(value, field, _, state)
  return value ~= nil and object.share(field[3], value, state) or nil
end

function get.structs(value, field, struct, state)
  if value == nil then return nil end
  if not field.length then return read(field[3], value, state) end
  local made = {}
  for i = 1, length(struct, field) do made[i] = read(field[3], value[i - 1], state) end
  return made
end

function get.handles(value, field, struct, state)
  if value == nil then return nil end
  local made = {}
  for i = 1, length(struct, field) do made[i] = get.handle(value[i - 1], field, struct, state) or false end
  return made
end

function get.enumlist(value, field, struct)
  if value == nil then return nil end
  local made = {}
  for i = 1, length(struct, field) do made[i] = enums.name(field[3], tonumber(value[i - 1])) end
  return made
end

--- The table of a struct, without columns. Objects of `state` are those of the call.
function read(base, struct, state, into)
  local made = into or {}
  for _, field in ipairs(tables.structs[base]) do
    if get[field[2]] and field[1] ~= "user_data" or field[2] == "data" then
      made[field[1]] = get[field[2]](struct[field[1]], field, struct, state)
    end
  end
  return made
end

return read
