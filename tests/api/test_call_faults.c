/* SPDX-License-Identifier: MIT */
/* Each allocation of each kind of call fails in turn, alone and with all later ones, with one worker and with four. A
 * failed call gives no object and keeps no memory; the same call without the fault gives the bits of the first one. */
#include "support/call_stage.h"

static uint64_t hash_mesh(const shd_mesh *mesh)
{
    static float columns[4][60000];
    shd_mesh_info info = shd_mesh_info_default();
    shd_f32_out out[4];
    uint64_t hash = SHD_HASH_START;
    size_t c;
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_true(info.vertex_count <= 60000);
    for (c = 0; c < 4; ++c) out[c] = (shd_f32_out){columns[c], 0};
    shd_assert_ok(shd_mesh_read_normals(mesh, out));
    for (c = 0; c < 3; ++c) hash = shd_hash(hash, columns[c], info.vertex_count * sizeof(float));
    shd_assert_ok(shd_mesh_read_tangents(mesh, out));
    for (c = 0; c < 4; ++c) hash = shd_hash(hash, columns[c], info.vertex_count * sizeof(float));
    return shd_hash(hash, &info.triangle_count, sizeof info.triangle_count);
}

static uint64_t hash_lookups(struct stage *s, const shd_texture *texture, shd_filter filter)
{
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    size_t i;
    for (i = 0; i < 500; ++i) s->columns[0][i] = 0.0131f * (float)i - 2.0f;
    lookups.count = 500;
    lookups.u.data = lookups.v.data = lookups.dudx.data = lookups.dvdy.data = s->columns[0];
    texels.channel[0].data = s->columns[1];
    shd_assert_ok(shd_texture_sample(texture, s->sampler[filter], &lookups, &texels));
    return shd_hash(SHD_HASH_START, s->columns[1], 500 * sizeof(float));
}

/* ---- textures and images ---- */

static shd_result make_texture(struct stage *s, shd_format format, uint32_t tables, uint32_t layers, shd_filter filter)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = (shd_texture *)s;
    shd_result result;
    desc.format = format;
    desc.width = 61;
    desc.height = 37;
    desc.layer_count = layers;
    desc.texels = s->texels;
    desc.tables = tables;
    result = shd_texture_create(s->context, &desc, &texture);
    assert_true((texture != NULL) == (result == SHD_OK));
    if (texture) s->hash = hash_lookups(s, texture, filter);
    shd_texture_release(texture);
    return result;
}
#define TEXTURE(name, format, tables, layers, filter) \
    static shd_result name(struct stage *s) { return make_texture(s, format, tables, layers, filter); }
TEXTURE(texture_plain, SHD_FORMAT_RGBA8, SHD_TABLE_NONE, 1, SHD_FILTER_BILINEAR)
TEXTURE(texture_mipmap, SHD_FORMAT_RGBA8_SRGB, SHD_TABLE_MIPMAP, 1, SHD_FILTER_TRILINEAR)
TEXTURE(texture_ripmap, SHD_FORMAT_R32F, SHD_TABLE_RIPMAP, 1, SHD_FILTER_RIPMAP)
TEXTURE(texture_sums, SHD_FORMAT_RG16, SHD_TABLE_SUMMED_AREA, 1, SHD_FILTER_SUMMED_AREA)
TEXTURE(texture_all_tables, SHD_FORMAT_RGB8, SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA, 1,
        SHD_FILTER_RIPMAP)
TEXTURE(texture_array, SHD_FORMAT_R8, SHD_TABLE_MIPMAP | SHD_TABLE_SUMMED_AREA, 3, SHD_FILTER_EWA)

static shd_result texture_update(struct stage *s)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_image image = shd_image_default();
    shd_texture *texture = NULL;
    shd_result result;
    desc.format = image.format = SHD_FORMAT_RGBA8;
    desc.width = desc.height = 32;
    desc.texels = s->texels;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_SUMMED_AREA;
    image.width = image.height = 9;
    image.pixels = s->texels + 512;
    result = shd_texture_create(s->context, &desc, &texture);
    if (result == SHD_OK) result = shd_texture_update(texture, 0, 3, 5, &image);
    if (result == SHD_OK) s->hash = hash_lookups(s, texture, SHD_FILTER_TRILINEAR);
    shd_texture_release(texture);
    return result;
}

static shd_texture_desc solid_desc(struct stage *s)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGBA8;
    desc.kind = SHD_TEXTURE_KIND_3D;
    desc.width = desc.height = desc.depth = 16;
    desc.texels = s->texels;
    desc.tables = SHD_TABLE_MIPMAP;
    return desc;
}

static shd_result texture_solid(struct stage *s)
{
    static unsigned char texel[4];
    const shd_texture_desc desc = solid_desc(s);
    shd_image image = shd_image_default();
    shd_texture *texture = NULL;
    shd_result result = shd_texture_create(s->context, &desc, &texture);
    image.format = SHD_FORMAT_RGBA8;
    image.width = image.height = 9;
    image.pixels = s->texels + 512;
    if (result == SHD_OK) result = shd_texture_update(texture, 5, 3, 4, &image);
    image.width = image.height = 1;
    image.pixels = texel;
    if (result == SHD_OK) shd_assert_ok(shd_texture_read_level(texture, 0, 4, &image));
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, texel, 4);
    shd_texture_release(texture);
    return result;
}

/* The picture of the mipmap of compressed blocks, whose levels are decoded into temporary memory. */
static shd_result read_table(struct stage *s)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_table_desc table = shd_table_desc_default();
    shd_image half = shd_image_default();
    shd_texture *texture = NULL;
    shd_f32_out out[4];
    shd_result result;
    int c;
    for (c = 0; c < 4; ++c) out[c] = shd_f32_out_column(s->columns[c], 0);
    desc.format = half.format = SHD_FORMAT_BC1_RGBA;
    desc.width = desc.height = 16;
    half.width = half.height = 8;
    desc.texels = half.pixels = s->texels;
    desc.tables = table.table = SHD_TABLE_MIPMAP;
    desc.level_images = &half;
    desc.level_count = 1;
    table.view = SHD_TABLE_VIEW_PICTURE;
    result = shd_texture_create(s->context, &desc, &texture);
    if (result == SHD_OK) result = shd_texture_read_table(texture, &table, out);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, s->columns[0], 24 * 16 * 4);
    shd_texture_release(texture);
    return result;
}

/* A volume, and a frame with it. */
static shd_result volume(struct stage *s)
{
    static const float k_density[2] = {0.0f, 0.25f}, k_extinction[2] = {0.0f, 3.0f};
    const shd_texture_desc texture_desc = solid_desc(s);
    shd_material_desc material_desc = shd_material_desc_default();
    shd_volume_desc desc = shd_volume_desc_default();
    shd_volume_draw placed = shd_volume_draw_default();
    shd_render_desc frame = s->scene.desc;
    shd_volume *made = NULL;
    shd_result result = shd_texture_create(s->context, &texture_desc, &desc.texture);
    if (result == SHD_OK) result = shd_material_create(s->context, &material_desc, &desc.material);
    desc.point_count = 2;
    desc.density.data = k_density;
    desc.extinction.data = k_extinction;
    if (result == SHD_OK) result = shd_volume_create(s->context, &desc, &made);
    placed.volume = made;
    frame.volumes = &placed;
    frame.volume_count = 1;
    frame.draw_count = 0; /* other cases draw them */
    if (result == SHD_OK) result = shd_render(s->context, &frame);
    if (result == SHD_OK) s->hash = shd_hash_framebuffer(s->scene.framebuffer);
    shd_volume_release(made);
    shd_material_release(desc.material);
    shd_texture_release(desc.texture);
    return result;
}

static shd_result build_mips(struct stage *s, shd_mip_kernel kernel, shd_texel_content content)
{
    static unsigned char levels[3][32 * 32 * 4];
    shd_mip_desc desc = shd_mip_desc_default();
    shd_image base = shd_image_default(), out[3];
    shd_result result;
    uint32_t l;
    desc.kernel = kernel;
    desc.content = content;
    base.format = SHD_FORMAT_RGBA8;
    base.width = base.height = 64;
    base.pixels = s->texels;
    for (l = 0; l < 3; ++l) {
        out[l] = base;
        out[l].width = out[l].height = 32u >> l;
        out[l].pixels = levels[l];
    }
    result = shd_mip_build(s->context, &base, &desc, 3, out);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, levels, sizeof levels);
    return result;
}
#define MIPS(name, kernel, content) \
    static shd_result name(struct stage *s) { return build_mips(s, kernel, content); }
MIPS(mips_box, SHD_MIP_KERNEL_BOX, SHD_TEXEL_CONTENT_COLOR)
MIPS(mips_kaiser, SHD_MIP_KERNEL_KAISER, SHD_TEXEL_CONTENT_DATA)
MIPS(mips_normal, SHD_MIP_KERNEL_LANCZOS, SHD_TEXEL_CONTENT_NORMAL)
MIPS(mips_coverage, SHD_MIP_KERNEL_TRIANGLE, SHD_TEXEL_CONTENT_ALPHA_COVERAGE)

static shd_result normal_moments(struct stage *s)
{
    static float moments[64 * 64 * 4];
    shd_image normals = shd_image_default(), out = shd_image_default();
    shd_result result;
    normals.format = SHD_FORMAT_RGBA8;
    out.format = SHD_FORMAT_RGBA32F;
    normals.width = normals.height = out.width = out.height = 64;
    normals.pixels = s->texels;
    out.pixels = moments;
    result = shd_mip_build_moments(s->context, &normals, &out, NULL);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, moments, sizeof moments);
    return result;
}

static shd_result normals_of_heights(struct stage *s)
{
    static float normals[64 * 64 * 3];
    shd_image heights = shd_image_default(), out = shd_image_default();
    shd_result result;
    heights.format = SHD_FORMAT_RGBA8;
    out.format = SHD_FORMAT_RGB32F;
    heights.width = heights.height = out.width = out.height = 64;
    heights.pixels = s->texels;
    out.pixels = normals;
    result = shd_mip_build_normals(s->context, &heights, NULL, &out);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, normals, sizeof normals);
    return result;
}

static shd_result sample_many(struct stage *s)
{
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    shd_result result;
    lookups.count = 20000;
    lookups.u.data = lookups.v.data = s->columns[3];
    texels.channel[0].data = s->columns[2];
    result = shd_texture_sample(s->heights, s->sampler[SHD_FILTER_TRILINEAR], &lookups, &texels);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, s->columns[2], sizeof s->columns[2]);
    return result;
}
static shd_result explain(struct stage *s)
{
    shd_lookups lookups = shd_lookups_default();
    shd_explanation explanation = shd_explanation_default();
    shd_result result;
    lookups.count = 1;
    lookups.u.data = lookups.v.data = s->columns[3];
    result = shd_texture_explain(s->heights, s->sampler[SHD_FILTER_TRILINEAR], &lookups, 0, &explanation);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, explanation.result, sizeof explanation.result);
    return result;
}

/* ---- meshes ---- */

static shd_result keep_mesh(struct stage *s, shd_result result, shd_mesh *mesh)
{
    assert_true((mesh != NULL) == (result == SHD_OK));
    if (mesh) s->hash = hash_mesh(mesh);
    shd_mesh_release(mesh);
    return result;
}
static shd_result make_shape(struct stage *s, shd_shape shape, uint32_t flags)
{
    shd_shape_desc desc = shd_shape_desc_default();
    shd_mesh *mesh = (shd_mesh *)s;
    shd_result result;
    desc.kind = shape;
    result = shd_mesh_create_shape(s->context, &desc, (shd_mesh_flags)flags, &mesh);
    return keep_mesh(s, result, mesh);
}
static shd_result shape_sphere(struct stage *s) { return make_shape(s, SHD_SHAPE_SPHERE, SHD_MESH_TANGENTS); }
static shd_result shape_box(struct stage *s) { return make_shape(s, SHD_SHAPE_BOX, SHD_MESH_ADJACENCY); }
static shd_result shape_plane(struct stage *s) { return make_shape(s, SHD_SHAPE_PLANE, SHD_MESH_NONE); }
static shd_result shape_torus(struct stage *s) { return make_shape(s, SHD_SHAPE_TORUS, SHD_MESH_NONE); }
static shd_result shape_teapot(struct stage *s)
{
    return make_shape(s, SHD_SHAPE_TEAPOT, SHD_MESH_TANGENTS | SHD_MESH_ADJACENCY);
}
static shd_result make_mesh(struct stage *s, shd_topology topology, uint32_t flags)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = (shd_mesh *)s;
    shd_result result;
    int c;
    desc.vertex_count = 999;
    for (c = 0; c < 3; ++c) desc.position[c] = shd_f32_column(s->columns[3] + 17 * c, 0);
    for (c = 0; c < 2; ++c) desc.uv[c] = shd_f32_column(s->columns[3] + 5 + 3 * c, 0);
    desc.topology = topology;
    desc.flags = flags;
    result = shd_mesh_create(s->context, &desc, &mesh);
    return keep_mesh(s, result, mesh);
}
static shd_result mesh_triangles(struct stage *s) { return make_mesh(s, SHD_TOPOLOGY_TRIANGLES, SHD_MESH_NONE); }
static shd_result mesh_strip(struct stage *s)
{
    return make_mesh(s, SHD_TOPOLOGY_STRIP, SHD_MESH_TANGENTS | SHD_MESH_ADJACENCY);
}
static shd_result mesh_fan(struct stage *s) { return make_mesh(s, SHD_TOPOLOGY_FAN, SHD_MESH_ADJACENCY); }

static shd_result find_edges(struct stage *s)
{
    const shd_edges_desc desc = shd_edges_desc_default();
    size_t count = 0;
    const shd_result result = shd_mesh_find_edges(s->mesh, &desc, 0, NULL, &count);
    if (result == SHD_OK) s->hash = count;
    return result;
}
static shd_result tessellate(struct stage *s, shd_tessellation_mode mode, int displaced, shd_displaced_normals normals)
{
    shd_tessellation_desc desc = shd_tessellation_desc_default();
    shd_mesh *mesh = (shd_mesh *)s;
    shd_result result;
    desc.mode = mode;
    desc.segments = 3;
    desc.edge_length = 0.1f;
    desc.displacement = displaced ? s->heights : NULL;
    desc.amplitude = 0.1f;
    desc.normals = normals;
    result = shd_mesh_tessellate(s->context, s->mesh, &desc, &mesh);
    return keep_mesh(s, result, mesh);
}
#define TESSELLATE(name, mode, displaced, normals) \
    static shd_result name(struct stage *s) { return tessellate(s, mode, displaced, normals); }
TESSELLATE(tessellate_plain, SHD_TESSELLATION_MODE_UNIFORM, 0, SHD_DISPLACED_NORMALS_TILTED)
TESSELLATE(tessellate_adaptive, SHD_TESSELLATION_MODE_ADAPTIVE, 0, SHD_DISPLACED_NORMALS_TILTED)
TESSELLATE(tessellate_tilted, SHD_TESSELLATION_MODE_UNIFORM, 1, SHD_DISPLACED_NORMALS_TILTED)
TESSELLATE(tessellate_faces, SHD_TESSELLATION_MODE_UNIFORM, 1, SHD_DISPLACED_NORMALS_FACES)

/* ---- shadows, framebuffers, frames ---- */

static shd_result make_shadow(struct stage *s, shd_shadow_filter filter)
{
    static const float k_points[3][4] = {{0, 0.3f, -2, 1}, {0, -1, 2, 0.2f}, {0, 0.1f, 3, -0.7f}};
    shd_shadow_desc desc = shd_shadow_desc_default();
    shd_shadow_render_desc render = shd_shadow_render_desc_default();
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    shd_shadow_values out = {sizeof out, {s->columns[2], 0}, 0};
    shd_shadow *shadow = NULL;
    shd_result result;
    int c;
    desc.size = 64;
    desc.filter = filter;
    render.light = s->light;
    render.draws = s->scene.draw;
    render.draw_count = 2;
    result = shd_shadow_create(s->context, &desc, &shadow);
    if (result == SHD_OK) result = shd_shadow_render(s->context, shadow, &render);
    lookups.count = 4;
    for (c = 0; c < 3; ++c) lookups.position[c].data = k_points[c];
    if (result == SHD_OK) result = shd_shadow_sample(shadow, &lookups, &out);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, s->columns[2], 4 * sizeof(float));
    shd_shadow_release(shadow);
    return result;
}
static shd_result shadow_hard(struct stage *s) { return make_shadow(s, SHD_SHADOW_FILTER_HARD); }
static shd_result shadow_pcf(struct stage *s) { return make_shadow(s, SHD_SHADOW_FILTER_PCF); }
static shd_result shadow_variance(struct stage *s) { return make_shadow(s, SHD_SHADOW_FILTER_VARIANCE); }
static shd_result shadow_sums(struct stage *s) { return make_shadow(s, SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE); }
static shd_result shadow_pcss(struct stage *s) { return make_shadow(s, SHD_SHADOW_FILTER_PCSS); }

static shd_result make_framebuffer(struct stage *s, uint32_t samples, uint32_t aovs)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = (shd_framebuffer *)s;
    shd_result result;
    desc.width = 130;
    desc.height = 70;
    desc.sample_count = samples;
    desc.aovs = aovs;
    result = shd_framebuffer_create(s->context, &desc, &framebuffer);
    assert_true((framebuffer != NULL) == (result == SHD_OK));
    if (framebuffer) s->hash = shd_hash_framebuffer(framebuffer);
    shd_framebuffer_release(framebuffer);
    return result;
}
static shd_result framebuffer_plain(struct stage *s) { return make_framebuffer(s, 1, 0); }
static shd_result framebuffer_all(struct stage *s) { return make_framebuffer(s, 16, 2 * SHD_AOV_TARGET3 - 1); }

static shd_result render(struct stage *s, const shd_render_desc *desc)
{
    const shd_result result = shd_render(s->context, desc);
    if (result == SHD_OK) s->hash = shd_hash_framebuffer(s->scene.framebuffer);
    return result;
}
static shd_result render_supersampled(struct stage *s)
{
    shd_render_desc desc = s->scene.desc;
    desc.supersampling = 2;
    return render(s, &desc);
}
static shd_result render_painter(struct stage *s)
{
    shd_render_desc desc = s->scene.desc;
    desc.visibility = SHD_VISIBILITY_PAINTER;
    return render(s, &desc);
}
static shd_result render_newell(struct stage *s)
{
    shd_render_desc desc = s->scene.desc;
    desc.visibility = SHD_VISIBILITY_NEWELL;
    return render(s, &desc);
}
static shd_result render_lines(struct stage *s)
{
    shd_render_desc desc = s->scene.desc;
    shd_draw draw = s->scene.draw[0];
    draw.mesh = s->mesh;
    draw.fill = SHD_FILL_LINES;
    desc.draws = &draw;
    desc.draw_count = 1;
    return render(s, &desc);
}

static shd_result render_solid(struct stage *s)
{
    shd_material_desc material = shd_material_desc_default();
    shd_solid_desc solid = shd_solid_desc_default();
    shd_render_desc desc = s->scene.desc;
    shd_draw draw = s->scene.draw[0];
    shd_material *made = (shd_material *)s;
    shd_slot slots[2];
    shd_result result;
    solid.kind = SHD_SOLID_PERLIN;
    slots[0] = shd_slot_solid(SHD_SLOT_DIFFUSE, &solid);
    slots[1] = shd_slot_solid(SHD_SLOT_AMBIENT, &solid);
    material.slots = slots;
    material.slot_count = 2;
    result = shd_material_create(s->context, &material, &made);
    assert_true((made != NULL) == (result == SHD_OK));
    draw.material = made;
    desc.draws = &draw;
    desc.draw_count = 1;
    if (result == SHD_OK) result = render(s, &desc);
    shd_material_release(made);
    return result;
}

static void block_all(const shd_rays *rays, uint32_t *blocked, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < rays->count; ++i) blocked[i] = rays->dy[i] > 0.3f;
}

/* Occlusion in a small texture, by depth maps or a tracer. */
static shd_result occlusion(struct stage *s, shd_trace_fn trace)
{
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_atlas atlas = shd_occlusion_atlas_default();
    const shd_f32_out out = {s->columns[1], 0};
    shd_draw draw = shd_draw_default();
    shd_result result;
    draw.mesh = s->mesh;
    desc.ray_count = trace ? 7 : 1;
    desc.map_size = 16;
    desc.tracer.trace = trace;
    desc.draws = atlas.draws = &draw;
    desc.draw_count = atlas.draw_count = 1;
    atlas.width = atlas.height = 16;
    atlas.dilation = 2;
    result = shd_occlusion_bake(s->context, &desc, &atlas, &out);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, s->columns[1], 256 * sizeof(float));
    return result;
}
static shd_result occlusion_maps(struct stage *s) { return occlusion(s, NULL); }
static shd_result occlusion_traced(struct stage *s) { return occlusion(s, block_all); }

static shd_result bake(struct stage *s)
{
    shd_render_desc frame = shd_render_desc_default();
    shd_bake_desc desc = shd_bake_desc_default();
    shd_framebuffer_desc target = shd_framebuffer_desc_default();
    shd_draw draw = s->scene.draw[0];
    shd_result result;
    target.width = target.height = 70;
    target.aovs = SHD_AOV_POSITION;
    result = shd_framebuffer_create(s->context, &target, &frame.framebuffer);
    frame.draws = &draw;
    frame.draw_count = 1;
    desc.dilation = 3;
    if (result == SHD_OK) result = shd_bake(s->context, &frame, &desc);
    if (result == SHD_OK) s->hash = shd_hash_framebuffer(frame.framebuffer);
    shd_framebuffer_release(frame.framebuffer);
    return result;
}

static const struct call_case k_calls[] = {
    {"texture/plain", texture_plain},
    {"texture/mipmap", texture_mipmap},
    {"texture/ripmap", texture_ripmap},
    {"texture/summed_area", texture_sums},
    {"texture/all_tables", texture_all_tables},
    {"texture/array", texture_array},
    {"texture/update", texture_update},
    {"texture/read_table", read_table},
    {"mips/box", mips_box},
    {"mips/kaiser", mips_kaiser},
    {"mips/normals", mips_normal},
    {"mips/coverage", mips_coverage},
    {"normal_moments", normal_moments},
    {"normals_of_heights", normals_of_heights},
    {"sample/20000", sample_many},
    {"explain", explain},
    {"shape/sphere", shape_sphere},
    {"shape/box", shape_box},
    {"shape/plane", shape_plane},
    {"shape/torus", shape_torus},
    {"shape/teapot", shape_teapot},
    {"mesh/triangles", mesh_triangles},
    {"mesh/strip", mesh_strip},
    {"mesh/fan", mesh_fan},
    {"edges", find_edges},
    {"tessellate/uniform", tessellate_plain},
    {"tessellate/adaptive", tessellate_adaptive},
    {"tessellate/displaced", tessellate_tilted},
    {"tessellate/displaced_faces", tessellate_faces},
    {"shadow/hard", shadow_hard},
    {"shadow/pcf", shadow_pcf},
    {"shadow/variance", shadow_variance},
    {"shadow/summed_area", shadow_sums},
    {"shadow/pcss", shadow_pcss},
    {"framebuffer/plain", framebuffer_plain},
    {"framebuffer/16_samples_all_planes", framebuffer_all},
    {"render/supersampled", render_supersampled},
    {"render/painter", render_painter},
    {"render/newell", render_newell},
    {"render/lines", render_lines},
    {"texture/3d", texture_solid},
    {"volume", volume},
    {"render/solid", render_solid},
    {"bake", bake},
    {"occlusion/maps", occlusion_maps},
    {"occlusion/traced", occlusion_traced},
};

int main(void)
{
    ADD_ROWS(k_calls, test_call);
    return _cmocka_run_group_tests("api.call_faults", g_tests, g_count, NULL, NULL);
}
