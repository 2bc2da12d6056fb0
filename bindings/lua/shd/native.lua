-- SPDX-License-Identifier: MIT
-- The shared libraries, their functions, and errors.
local ffi = require "ffi"
local tables = require "shd.tables"

ffi.cdef(require "shd.cdef")

local library = {}

-- An error: `result` is the name of the shd_result, `message` the text.
local Error = {}
Error.__index = Error
function Error.__tostring(problem) return problem.message end
library.Error = Error

local function raise(result, message)
  error(setmetatable({result = result, message = message}, Error), 0)
end

--- Refuses an argument. The text is a format and its values.
function library.refuse(text, ...)
  raise("error_invalid_argument", text:format(...))
end

local function is_file(path)
  local file = io.open(path, "rb")
  if file then file:close() end
  return file ~= nil
end

-- Paths and names of a library, best first. SHD_LIBRARY is the path of libshd or its folder.
local function candidates(name)
  local found = {}
  local given = os.getenv("SHD_LIBRARY") or ""
  local version = tables.constants.VERSION_MAJOR .. "." .. tables.constants.VERSION_MINOR
  if given ~= "" then
    if name == "shd" and given:match("%.so[%d.]*$") then found[1] = given end
    local folder = given:match("%.so[%d.]*$") and (given:match("^(.*)/") or ".") or given
    for _, file in ipairs {"lib" .. name .. ".so", "lib" .. name .. ".so." .. version} do
      if is_file(folder .. "/" .. file) then found[#found + 1] = folder .. "/" .. file end
    end
  end
  found[#found + 1] = "lib" .. name .. ".so." .. version
  found[#found + 1] = name
  return found
end

local loaded = {}

--- The namespace of a library: "shd", "shd_io", "shd_color", "shd_scene", "shd_embree".
function library.load(name)
  if loaded[name] then return loaded[name] end
  local problems = {}
  for _, candidate in ipairs(candidates(name)) do
    local good, result = pcall(ffi.load, candidate)
    if good then
      loaded[name] = result
      return result
    end
    problems[#problems + 1] = tostring(result)
  end
  raise("error_not_found", "lib" .. name .. " was not found. Set SHD_LIBRARY to the path of libshd. " ..
    table.concat(problems, "; "))
end

--- The functions of C without checks: library.C.shd_render(context, desc).
library.C = setmetatable({}, {__index = function(self, name)
  local entry = tables.functions[name]
  if not entry then error("libshd has no function " .. tostring(name), 2) end
  local namespace = library.load(entry.library)
  self[name] = namespace[name]
  return self[name]
end})
local C = library.C

--- Raises the error of a call unless its result is SHD_OK.
function library.check(result)
  if result == 0 then return end
  local name = ffi.string(C.shd_result_name(result)):lower():gsub("^shd_", "")
  raise(name, ffi.string(C.shd_last_error()))
end

--- Version of the library as major, minor, patch.
function library.version()
  local version = C.shd_version()
  return bit.rshift(version, 16), bit.band(bit.rshift(version, 8), 255), bit.band(version, 255)
end

local function check_version()
  local major, minor = library.version()
  local constants = tables.constants
  if major ~= constants.VERSION_MAJOR or minor ~= constants.VERSION_MINOR then
    raise("error_unsupported", ("libshd is version %d.%d, not %d.%d"):format(major, minor, constants.VERSION_MAJOR,
      constants.VERSION_MINOR))
  end
end

check_version()
return library
