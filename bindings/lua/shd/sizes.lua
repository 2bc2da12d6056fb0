-- SPDX-License-Identifier: MIT
-- Sizes of the memory that arguments need, where the struct alone does not have them.
local ffi = require "ffi"
local library = require "shd.native"
local tables = require "shd.tables"
local C = library.C

local sizes = {}

local BORROW, FACES = 1, 6
local ELEMENTS = {["8"] = "uint8_t", ["16"] = "uint16_t", ["16f"] = "uint16_t", ["32f"] = "float"}
local formats = {}
for _, pair in ipairs(tables.enums.shd_format) do
  local layout, kind = pair[1]:match("^([rgba]+)(%d+f?)")
  if layout then formats[pair[2]] = {ctype = ELEMENTS[kind], channels = #layout} end
end

--- Type of the elements and number of channels of a format; nil if there is none.
function sizes.format(format)
  local entry = formats[tonumber(format)]
  if entry then return entry.ctype, entry.channels end
end

-- Bytes of an image, between its rows, and number of rows: of texels, or of compressed blocks of 4 x 4 texels.
local function image_bytes(struct)
  local columns, rows, size = struct.width, struct.height, tonumber(C.shd_format_size(struct.format))
  local block = tonumber(C.shd_format_block_size(struct.format))
  if block > 0 then columns, rows, size = math.ceil(columns / 4), math.ceil(rows / 4), block end
  local row, stride = columns * size, tonumber(struct.row_stride)
  if stride == 0 then stride = row end
  return math.max(0, rows - 1) * stride + row, stride, rows
end

--- Images of the base level of a texture: slices, faces or layers.
function sizes.images(struct)
  local kind = tonumber(struct.kind)
  if kind == ffi.C.SHD_TEXTURE_KIND_3D then return struct.depth end
  local is_cube = kind == ffi.C.SHD_TEXTURE_KIND_DIRECTIONS and tonumber(struct.projection) == ffi.C.SHD_PROJECTION_CUBE
  return is_cube and FACES or tonumber(struct.layer_count)
end

--- Bytes behind a pointer, and the type of its elements, by struct and field.
sizes.bytes = {
  ["shd_image.pixels"] = function(struct)
    return (image_bytes(struct)), (sizes.format(struct.format))
  end,
  ["shd_texture_desc.texels"] = function(struct)
    local bytes, stride, rows = image_bytes(struct)
    local layer = tonumber(struct.layer_stride)
    if layer == 0 then layer = rows * stride end
    bytes = bytes + (math.max(1, sizes.images(struct)) - 1) * layer
    if bit.band(struct.flags, BORROW) ~= 0 then bytes = bytes + tables.constants.TEXTURE_PADDING end
    return bytes, (sizes.format(struct.format))
  end,
}

--- Numbers of parameters that are vectors.
sizes.vectors = {eye = 3, target = 3, up = 3, point = 3, direction = 3, translation = 3, scale = 3, rotation = 4,
  rectangle = 4}

--- Pixels of a framebuffer, or elements of a face of a shadow.
local function pixels(object)
  local info = object:get_info()
  return info.width * info.height
end

local function vertices(mesh) return mesh:get_info().vertex_count end

--- Rows of output columns of functions whose inputs have no count, from the arguments.
sizes.rows = {
  shd_texture_read_table = function(texture, desc)
    local info = texture:get_table_info(desc)
    return info.width * info.height
  end,
  shd_shadow_read_map = pixels,
  shd_framebuffer_read_plane = pixels,
  shd_framebuffer_read_u32_plane = pixels,
  shd_bake = function(_, frame) return pixels(frame.framebuffer) end,
  shd_occlusion_bake = function(_, _, atlas) return atlas.width * atlas.height end,
  shd_occlusion_compute_vertices = function(_, _, draw) return vertices(draw.mesh) end,
  shd_mesh_read_positions = vertices,
  shd_mesh_read_normals = vertices,
  shd_mesh_read_tangents = vertices,
  shd_mesh_read_uv = vertices,
  shd_mesh_read_uv1 = vertices,
  shd_mesh_read_attribute = vertices,
  shd_mesh_read_indices = function(mesh) return 3 * mesh:get_info().triangle_count end,
  shd_mesh_find_edges = function(_, _, capacity) return capacity end,
}

--- Rows for a call. Bad arguments give nil; the call refuses them itself, or refuses their columns.
function sizes.rows_of(name, ...)
  if not sizes.rows[name] then return nil end
  local good, rows = pcall(sizes.rows[name], ...)
  return good and type(rows) == "number" and rows or nil
end

return sizes
