-- SPDX-License-Identifier: MIT
-- Constants by name: SHD_FILTER_EWA is "ewa", SHD_AOV_UV | SHD_AOV_NORMAL is "uv|normal".
local refuse = require "shd.native".refuse
local tables = require "shd.tables"

local enums = {}

local values = {}
for name, entry in pairs(tables.enums) do
  values[name] = {}
  for _, pair in ipairs(entry) do values[name][pair[1]] = pair[2] end
end

local function all_names(entry)
  local names = {}
  for i, pair in ipairs(entry) do names[i] = pair[1] end
  return table.concat(names, ", ")
end

--- The value of a name, of names joined by "|", or of a number. `label` names the argument in errors.
function enums.value(enum, given, label)
  if type(given) == "number" then
    if given % 1 ~= 0 or given < 0 or given > 0xffffffff then refuse("%s: %s is no constant", label, given) end
    return given
  end
  local entry = tables.enums[enum]
  if type(given) ~= "string" then refuse("%s: a string or a number, not %s", label, type(given)) end
  if values[enum][given] then return values[enum][given] end
  local total = 0
  for part in (given .. "|"):gmatch("%s*(.-)%s*|") do
    local value = values[enum][part]
    if not value then refuse("%s: %q is none of %s", label, part, all_names(entry)) end
    if not entry.flags and part ~= given then refuse("%s: %q, but only flags can be joined", label, given) end
    total = bit.bor(total, value)
  end
  return total % 2 ^ 32
end

--- The name of a value; flags are joined by "|". A value without a name stays a number.
function enums.name(enum, value)
  local entry, parts, rest = tables.enums[enum], {}, value
  for _, pair in ipairs(entry) do
    if pair[2] == value then return pair[1] end
    if entry.flags and pair[2] ~= 0 and bit.band(rest, pair[2]) == pair[2] then
      parts[#parts + 1] = pair[1]
      rest = bit.band(rest, bit.bnot(pair[2]))
    end
  end
  return #parts > 0 and rest == 0 and table.concat(parts, "|") or value
end

return enums
