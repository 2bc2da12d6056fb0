-- SPDX-License-Identifier: MIT
-- Cases of the tests, and what they compare with.
local ffi = require "ffi"
local shd = require "shd"

local support = {failures = 0, count = 0}

--- Runs a case and prints its problem.
function support.case(name, run)
  support.count = support.count + 1
  local good, problem = xpcall(run, function(text)
    return type(text) == "string" and debug.traceback(text, 2) or tostring(text)
  end)
  collectgarbage()
  if not good then
    support.failures = support.failures + 1
    print("FAILED " .. name .. ": " .. tostring(problem))
  end
end

function support.equal(got, expected, text)
  if got ~= expected then
    error(("%s%s, not %s"):format(text and text .. ": " or "", tostring(got), tostring(expected)), 2)
  end
end

--- A call must raise an error of the module whose message contains a text.
function support.refused(text, run, ...)
  local good, problem = pcall(run, ...)
  if good then error("no error; expected " .. text, 2) end
  if not shd.is_error(problem) then error("not an error of shd: " .. tostring(problem), 2) end
  if not problem.message:find(text, 1, true) then error(problem.message .. " does not contain " .. text, 2) end
  support.equal(tostring(problem), problem.message)
  return problem
end

function support.close_to(got, expected, tolerance)
  if not (math.abs(got - expected) <= tolerance) then
    error(("%.9g is not %.9g within %g"):format(got, expected, tolerance), 2)
  end
end

function support.floats(...) return ffi.new("float[?]", select("#", ...), {...}) end

--- A texture of one channel with the given rows of floats.
function support.texture(context, rows, more)
  local texels, width = {}, #rows[1]
  for _, row in ipairs(rows) do
    for _, value in ipairs(row) do texels[#texels + 1] = value end
  end
  local desc = {width = width, height = #rows, format = "r32f", texels = ffi.new("float[?]", #texels, texels)}
  for key, value in pairs(more or {}) do desc[key] = value end
  return shd.texture(context, desc)
end

--- A frame of a torus, with the fields of `more`.
function support.frame(context, framebuffer, material, more)
  local torus = shd.mesh_create_shape(context, {kind = "torus"}, 0)
  local frame = {framebuffer = framebuffer, draws = {{mesh = torus, material = material}}}
  for key, value in pairs(more or {}) do frame[key] = value end
  return context:render(frame)
end

return support
