// SPDX-License-Identifier: MIT
// Lookups in a texture, and a frame that shows it: owners release the objects, and errors are exceptions.
#include <array>
#include <cstdio>
#include <shd.hpp>
#include <vector>

namespace {

struct vertex {
  float x, y, z, u, v;
};

float look_up(const shd_texture* texture, const shd_sampler* sampler) {
  const std::array<float, 3> u = {0.25f, 0.5f, 0.75f}, v = {0.25f, 0.5f, 0.25f};
  std::array<float, 3> red{};
  shd::lookups lookups;
  shd::texels texels;
  lookups.count = u.size();
  lookups.u = shd::in(u);
  lookups.v = shd::in(v);
  texels.channel[0] = shd::out(red);
  shd::texture_sample(texture, sampler, &lookups, &texels);
  return red[1];
}

/// Red of the pixel in the middle of a square that shows the texture.
float draw(shd_context* context, shd_texture* texture, shd_sampler* sampler) {
  const std::vector<vertex> corners = {
      {-1, 1, 0.5f, 0, 0}, {-1, -1, 0.5f, 0, 1}, {1, 1, 0.5f, 1, 0}, {1, -1, 0.5f, 1, 1}};
  shd::mesh_desc mesh_desc;
  mesh_desc.vertex_count = 4;
  mesh_desc.topology = SHD_TOPOLOGY_STRIP;
  mesh_desc.position[0] = shd::in(corners, &vertex::x);
  mesh_desc.position[1] = shd::in(corners, &vertex::y);
  mesh_desc.position[2] = shd::in(corners, &vertex::z);
  mesh_desc.uv[0] = shd::in(corners, &vertex::u);
  mesh_desc.uv[1] = shd::in(corners, &vertex::v);
  const shd::mesh mesh = shd::mesh_create(context, &mesh_desc);

  const shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, sampler);
  shd::material_desc material_desc;
  material_desc.model = SHD_MODEL_UNLIT;
  material_desc.diffuse[0] = 1.0f;
  material_desc.slots = &slot, material_desc.slot_count = 1;
  const shd::material material = shd::material_create(context, &material_desc);

  shd::framebuffer_desc size;
  size.width = 65, size.height = 65;
  const shd::framebuffer framebuffer = shd::framebuffer_create(context, &size);
  shd::draw square;
  square.mesh = mesh, square.material = material;
  shd::render_desc frame;
  frame.framebuffer = framebuffer;
  frame.draws = &square, frame.draw_count = 1;
  shd::render(context, &frame);
  const shd_plane_view red = shd::framebuffer_view_plane(framebuffer, SHD_PLANE_R);
  return red.f32[32 * red.row_stride / sizeof(float) + 32];
}

}  // namespace

int main() {
  try {
    const std::uint8_t pixels[4] = {0, 255, 255, 255};
    const shd::context context = shd::context_create(nullptr);
    const shd::sampler sampler = shd::sampler_create(context, nullptr);
    shd::texture_desc desc;
    desc.format = SHD_FORMAT_R8;
    desc.width = 2, desc.height = 2;
    desc.texels = pixels;
    const shd::texture texture = shd::texture_create(context, &desc);
    const float looked_up = look_up(texture, sampler), drawn = draw(context, texture, sampler);
    std::printf("the middle of the texture is %.2f, the middle of the picture %.2f\n", looked_up, drawn);
    return looked_up == 0.75f && drawn == 0.75f ? 0 : 1;
  } catch (const shd::error& failure) {
    std::fprintf(stderr, "hello: %s: %s\n", shd_result_name(failure.result()), failure.what());
    return 1;
  }
}
