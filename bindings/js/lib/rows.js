// SPDX-License-Identifier: MIT
// Lengths of columns that only the other arguments determine. A shorter array is refused before C reads or writes it.

const pixels = ({ width, height }) => width * height;

const ROWS = {
  shd_mesh_read_indices: ([mesh]) => 3 * mesh.info.triangleCount,
  shd_mesh_find_edges: ([, , capacity]) => capacity,
  shd_texture_read_table: ([texture, desc]) => pixels(texture.tableInfo(desc)),
  shd_shadow_read_map: ([shadow]) => pixels(shadow.info),
  shd_framebuffer_read_plane: ([framebuffer]) => pixels(framebuffer.info),
  shd_framebuffer_read_u32_plane: ([framebuffer]) => pixels(framebuffer.info),
  shd_occlusion_compute_vertices: ([, , draw]) => draw.mesh.info.vertexCount,
  shd_occlusion_bake: ([, , atlas]) => pixels(atlas),
  shd_bake: ([, frame]) => pixels(frame.framebuffer.info),
};
for (const part of ["positions", "normals", "tangents", "uv", "uv1", "attribute"]) {
  ROWS[`shd_mesh_read_${part}`] = ([mesh]) => mesh.info.vertexCount;
}

// Lists of columns whose length is not that of the other columns of the call.
const ROWS_OF_LISTS = {
  shd_polyhedron_interpolate: ([polyhedron]) => ({ vertexValue: polyhedron?.vertexCount }),
};

/** Lengths of lists of columns of a call, by their fields. */
export const rowsOfLists = (name, values) => ROWS_OF_LISTS[name]?.(values) ?? {};

/** Rows of the columns of a call, or undefined if the structs of the call have a count. */
export function rowsOf(name, values) {
  if (!ROWS[name]) return undefined;
  try {
    return ROWS[name](values);
  } catch {
    return undefined;  // an argument is missing or of another type, which the call refuses
  }
}
