-- SPDX-License-Identifier: MIT
-- The generated declarations, and the conversions that the tables of all functions describe.
local ffi = require "ffi"
local shd = require "shd"
local sizes = require "shd.sizes"
local support = require "support"
local tables = require "shd.tables"
local case, equal, refused = support.case, support.equal, support.refused

case("sizes of structs are those of the description", function()
  for name, struct in pairs(tables.structs) do equal(ffi.sizeof(name), struct.size, name) end
end)

case("every function of libshd is exported", function()
  local count = 0
  for name, entry in pairs(tables.functions) do
    if entry.library == "shd" then
      assert(shd.C[name] ~= nil, name)
      count = count + 1
    end
  end
  assert(count > 100, count)
  assert(not pcall(function() return shd.C.shd_nothing end))
end)

-- A column whose length nothing states could be written beyond its end.
case("every function with columns has a number of rows", function()
  for name, entry in pairs(tables.functions) do
    local needs, has = false, sizes.rows[name] ~= nil
    for _, parameter in ipairs(entry) do
      needs = needs or parameter[2] == "columns"
      for _, field in ipairs(tables.structs[parameter[3]] or {}) do has = has or field[1] == "count" end
    end
    assert(has or not needs, name)
  end
end)

case("defaults are those of the library", function()
  local sampler = require("shd.convert").new("shd_sampler_desc")
  equal(sampler.struct_size, ffi.sizeof "shd_sampler_desc")
  equal(tonumber(sampler.filter), 0)
  support.close_to(require("shd.convert").new("shd_camera").fov_y, 0.8, 1e-6)
end)

case("functions without objects", function()
  local matrix = shd.matrix_look_at({0, 0, 3}, {0, 0, 0}, {0, 1, 0})
  equal(matrix[14], -3)
  local inverse = shd.matrix_invert(matrix)
  equal(shd.matrix_multiply(matrix, inverse)[0], 1)
  local vertices, indices = shd.shape_count {kind = "box"}
  assert(vertices >= 8 and indices == 36)
  local x, y = shd.sample_position(1, 0)
  equal(x, 0.5)
  equal(y, 0.5)
  equal(shd.result_name(0), "SHD_OK")
  equal(shd.format_size("rgba16f"), 8)
  equal(shd.constants.MAX_ATTRIBUTES, 8)
  local view = shd.view_from_camera {eye = {0, 0, 3}}
  equal(view.eye[3], 3)
  refused("matrix: 3 elements, not 16", shd.matrix_invert, {1, 2, 3})
  refused("eye: 2 elements, not 3", shd.matrix_look_at, {0, 0}, {0, 0, 0}, {0, 1, 0})
  refused("shd_matrix_invert: 2 arguments, not 1", shd.matrix_invert, matrix, matrix)
  refused("only library.C has it", shd.context_allocate)
end)

case("fields", function()
  local context = shd.context {worker_count = 1}
  local function sampler(desc) return shd.sampler(context, desc) end
  refused("sampler: shd_sampler_desc has no field fliter", sampler, {fliter = "ewa"})
  refused('sampler.filter: "ewwa" is none of trilinear', sampler, {filter = "ewwa"})
  refused('"ewa|nearest", but only flags can be joined', sampler, {filter = "ewa|nearest"})
  refused("sampler.filter: a string or a number, not boolean", sampler, {filter = true})
  refused("sampler.seed: -1 is no uint32_t", sampler, {seed = -1})
  refused("sampler.seed: 0.5 is no uint32_t", sampler, {seed = 0.5})
  refused("sampler.seed: 4294967296 is no uint32_t", sampler, {seed = 2 ^ 32})
  refused("sampler.seed: nan is no uint32_t", sampler, {seed = -(0 / 0)})
  refused("sampler.blur_u: a number, not string", sampler, {blur_u = "1"})
  refused("sampler.border: 3 numbers, not 4", sampler, {border = {0, 0, 0}})
  refused("sampler.border[2]: a number, not string", sampler, {border = {0, "x", 0, 0}})
  refused("sampler.border: a list, not number", sampler, {border = 1})
  refused("sampler: a table", sampler, context)
  equal(refused("max_anisotropy", sampler, {max_anisotropy = -1}).result, "error_invalid_argument")
  sampler {border = support.floats(0, 0, 0, 1), filter = 3}
  sampler()
end)

case("flags have names and join", function()
  local context = shd.context {worker_count = 1}
  local framebuffer = shd.framebuffer(context, {width = 4, height = 4, aovs = "uv | normal"})
  equal(framebuffer:get_info().aovs, "uv|normal")
  equal(framebuffer:get_info().color_format, "rgba32f")
end)

case("a desc with a list of rows", function()
  local context = shd.context {worker_count = 1}
  local points = {position = {{0.5, 1.5}, {0.5, 0.5}, {0, 0}}}
  local out = {channel = {}}
  for i = 1, 4 do out.channel[i] = ffi.new "float[2]" end
  context:solid_evaluate({kind = "checker", color_count = 2, colors = {{1, 0, 0, 1}, {0, 0, 1, 1}}}, points, out)
  assert(out.channel[1][0] ~= out.channel[1][1])
  equal(out.nonfinite_count, 0)
  out.channel[2] = ffi.new "float[1]"
  refused("solid_values.channel[2]: 1 elements, not 2", context.solid_evaluate, context, {kind = "checker"}, points,
    out)
end)
