/* SPDX-License-Identifier: MIT */
/*
 * The time of a frame: a floor to the horizon with a texture of 512 x 512 texels, 640 x 480 pixels, one thread.
 * floor.mjs renders the same frame in WebAssembly.
 *
 *   floor [sse4|avx2|best] [trilinear|anisotropic|ewa]
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <shd/shd.h>

enum { SIZE = 512, WIDTH = 640, HEIGHT = 480, FRAMES = 40 };

static uint8_t s_texels[SIZE][SIZE][4], s_pixels[HEIGHT][WIDTH][4];

static void require(shd_result result) {
  if (result == SHD_OK) return;
  fprintf(stderr, "floor: %s\n", shd_last_error());
  exit(EXIT_FAILURE);
}

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1e3 * (double)time.tv_sec + 1e-6 * (double)time.tv_nsec;
}

static shd_material* create_floor_material(shd_context* context, shd_filter filter) {
  shd_texture_desc texture_desc = shd_texture_desc_default();
  shd_sampler_desc sampler_desc = shd_sampler_desc_default();
  shd_material_desc desc = shd_material_desc_default();
  shd_texture* texture = NULL;
  shd_sampler* sampler = NULL;
  shd_material* material = NULL;
  shd_slot slot;
  int x, y;
  for (y = 0; y < SIZE; ++y) {
    for (x = 0; x < SIZE; ++x) {
      s_texels[y][x][0] = (uint8_t)(x / 2);
      s_texels[y][x][1] = (uint8_t)(y / 2);
      s_texels[y][x][2] = (uint8_t)((x ^ y) & 255);
      s_texels[y][x][3] = 255;
    }
  }
  texture_desc.width = texture_desc.height = SIZE;
  texture_desc.format = SHD_FORMAT_RGBA8_SRGB;
  texture_desc.texels = s_texels;
  texture_desc.tables = SHD_TABLE_MIPMAP;
  require(shd_texture_create(context, &texture_desc, &texture));
  sampler_desc.filter = filter;
  require(shd_sampler_create(context, &sampler_desc, &sampler));
  slot = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, sampler);
  slot.uv_transform[0] = slot.uv_transform[4] = 32.0f;
  desc.model = SHD_MODEL_UNLIT;
  desc.diffuse[0] = desc.diffuse[1] = desc.diffuse[2] = 1.0f;
  desc.slots = &slot, desc.slot_count = 1;
  require(shd_material_create(context, &desc, &material));
  shd_sampler_release(sampler);
  shd_texture_release(texture);
  return material;
}

static uint64_t hash_pixels(void) {
  const uint8_t* byte = &s_pixels[0][0][0];
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  size_t i;
  for (i = 0; i < sizeof s_pixels; ++i) hash = (hash ^ byte[i]) * UINT64_C(0x100000001b3);
  return hash;
}

int main(int count, char** arguments) {
  const char *simd = count > 1 ? arguments[1] : "sse4", *filter = count > 2 ? arguments[2] : "trilinear";
  shd_context_desc context_desc = shd_context_desc_default();
  shd_framebuffer_desc framebuffer_desc = shd_framebuffer_desc_default();
  shd_shape_desc plane = shd_shape_desc_default();
  shd_camera camera = shd_camera_default();
  shd_render_desc frame = shd_render_desc_default();
  shd_draw draw = shd_draw_default();
  shd_image image = shd_image_default();
  shd_context* context = NULL;
  shd_mesh* mesh = NULL;
  shd_framebuffer* framebuffer = NULL;
  double best = 1e30;
  int i;
  context_desc.worker_count = 1;
  context_desc.simd = strcmp(simd, "sse4") == 0   ? SHD_SIMD_SSE4
                      : strcmp(simd, "avx2") == 0 ? SHD_SIMD_AVX2
                                                  : SHD_SIMD_BEST;
  require(shd_context_create(&context_desc, &context));
  plane.kind = SHD_SHAPE_PLANE;
  plane.size[0] = plane.size[2] = 32.0f;
  require(shd_mesh_create_shape(context, &plane, 0, &mesh));
  framebuffer_desc.width = WIDTH, framebuffer_desc.height = HEIGHT;
  framebuffer_desc.color_format = SHD_FORMAT_RGBA8_SRGB;
  require(shd_framebuffer_create(context, &framebuffer_desc, &framebuffer));
  camera.eye[0] = 0.0f, camera.eye[1] = 1.0f, camera.eye[2] = 8.0f;
  camera.target[1] = 0.5f;
  draw.mesh = mesh;
  draw.material = create_floor_material(context, strcmp(filter, "ewa") == 0           ? SHD_FILTER_EWA
                                                 : strcmp(filter, "anisotropic") == 0 ? SHD_FILTER_ANISOTROPIC
                                                                                      : SHD_FILTER_TRILINEAR);
  frame.framebuffer = framebuffer;
  frame.draws = &draw, frame.draw_count = 1;
  frame.camera = &camera;
  for (i = 0; i < FRAMES; ++i) {
    const double start = now();
    double time;
    require(shd_render(context, &frame));
    time = now() - start;
    if (time < best) best = time;
  }
  image.width = WIDTH, image.height = HEIGHT;
  image.format = SHD_FORMAT_RGBA8_SRGB;
  image.pixels = s_pixels;
  require(shd_framebuffer_read_color(framebuffer, &image));
  printf("%s %s %.3f ms %016llx\n", shd_context_get_simd_target(context), filter, best,
         (unsigned long long)hash_pixels());
  shd_framebuffer_release(framebuffer);
  shd_material_release((shd_material*)draw.material);
  shd_mesh_release(mesh);
  shd_context_release(context);
  return EXIT_SUCCESS;
}
