/* SPDX-License-Identifier: MIT */
/*
 * The three programs that every binding has: a batch of lookups, a frame, and a fragment program. Each prints a hash of
 * its result. All inputs are exact in binary floating point, so the hashes of bindings/programs.txt hold for every
 * language and machine.
 *
 *   programs            prints the hashes
 *   programs --speed    prints the time of a call of one lookup, and of a batch of 2^20
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <shd/shd.h>

enum { SIZE = 64, LOOKUPS = 16384, WIDTH = 320, HEIGHT = 200, BATCH = 1 << 20, CALLS = 200000 };

static uint8_t s_pixels[WIDTH * HEIGHT * 4];

static void require(shd_result result) {
  if (result == SHD_OK) return;
  fprintf(stderr, "programs: %s\n", shd_last_error());
  exit(EXIT_FAILURE);
}

/* FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte. */
static uint64_t hash_bytes(uint64_t hash, const void* bytes, size_t count) {
  const uint8_t* byte = (const uint8_t*)bytes;
  size_t i;
  for (i = 0; i < count; ++i) hash = (hash ^ byte[i]) * UINT64_C(0x100000001b3);
  return hash;
}

static void print_hash(const char* name, uint64_t hash) {
  printf("%s %08x%08x\n", name, (unsigned)(hash >> 32), (unsigned)(hash & 0xffffffffu));
}

static shd_texture* create_texture(shd_context* context) {
  static uint8_t texels[SIZE][SIZE][4];
  shd_texture_desc desc = shd_texture_desc_default();
  shd_texture* texture = NULL;
  int x, y;
  for (y = 0; y < SIZE; ++y) {
    for (x = 0; x < SIZE; ++x) {
      texels[y][x][0] = (uint8_t)(x * 4);
      texels[y][x][1] = (uint8_t)(y * 4);
      texels[y][x][2] = (uint8_t)((x ^ y) * 4);
      texels[y][x][3] = 255;
    }
  }
  desc.width = desc.height = SIZE;
  desc.format = SHD_FORMAT_RGBA8_SRGB;
  desc.texels = texels;
  desc.tables = SHD_TABLE_MIPMAP;
  require(shd_texture_create(context, &desc, &texture));
  return texture;
}

static shd_sampler* create_sampler(shd_context* context, shd_filter filter) {
  shd_sampler_desc desc = shd_sampler_desc_default();
  shd_sampler* sampler = NULL;
  desc.filter = filter;
  desc.max_anisotropy = 16.0f;
  require(shd_sampler_create(context, &desc, &sampler));
  return sampler;
}

/* 1. A batch of lookups: footprints of many sizes and directions, filtered with EWA. */
static void look_up(shd_context* context) {
  static float in[6][LOOKUPS], out[4][LOOKUPS];
  shd_texture* texture = create_texture(context);
  shd_sampler* sampler = create_sampler(context, SHD_FILTER_EWA);
  shd_lookups lookups = shd_lookups_default();
  shd_texels texels = shd_texels_default();
  int i;
  for (i = 0; i < LOOKUPS; ++i) {
    in[0][i] = (float)(i % 128) / 64.0f;
    in[1][i] = (float)(i / 128) / 128.0f;
    in[2][i] = (float)(1 + i % 7) / 256.0f;   /* dudx */
    in[3][i] = (float)(i % 5) / 512.0f;       /* dvdx */
    in[4][i] = (float)(i % 3) / -512.0f;      /* dudy */
    in[5][i] = (float)(1 + i % 11) / 1024.0f; /* dvdy */
  }
  lookups.count = LOOKUPS;
  lookups.u.data = in[0], lookups.v.data = in[1];
  lookups.dudx.data = in[2], lookups.dvdx.data = in[3], lookups.dudy.data = in[4], lookups.dvdy.data = in[5];
  for (i = 0; i < 4; ++i) texels.channel[i].data = out[i];
  require(shd_texture_sample(texture, sampler, &lookups, &texels));
  print_hash("lookup", hash_bytes(UINT64_C(0xcbf29ce484222325), out, sizeof out));
  shd_sampler_release(sampler);
  shd_texture_release(texture);
}

/* Renders a torus of one material in the light of the sun, with four samples a pixel, and prints the hash of its pixels
   as RGBA8 in sRGB. */
static void draw(shd_context* context, const char* name, const shd_material_desc* material_desc) {
  shd_shape_desc torus = shd_shape_desc_default();
  shd_light_desc sun_desc = shd_light_desc_default();
  shd_framebuffer_desc framebuffer_desc = shd_framebuffer_desc_default();
  shd_camera camera = shd_camera_default();
  shd_render_desc frame = shd_render_desc_default();
  shd_draw one = shd_draw_default();
  shd_image image = shd_image_default();
  shd_mesh* mesh = NULL;
  shd_material* material = NULL;
  shd_light* sun = NULL;
  shd_framebuffer* framebuffer = NULL;

  torus.kind = SHD_SHAPE_TORUS;
  require(shd_mesh_create_shape(context, &torus, 0, &mesh));
  require(shd_material_create(context, material_desc, &material));
  sun_desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  sun_desc.direction[0] = -0.5f, sun_desc.direction[1] = -1.0f, sun_desc.direction[2] = -0.25f;
  require(shd_light_create(context, &sun_desc, &sun));
  framebuffer_desc.width = WIDTH, framebuffer_desc.height = HEIGHT;
  framebuffer_desc.sample_count = 4;
  require(shd_framebuffer_create(context, &framebuffer_desc, &framebuffer));

  camera.eye[0] = 0.5f, camera.eye[1] = 1.5f, camera.eye[2] = 2.0f;
  one.mesh = mesh, one.material = material;
  frame.framebuffer = framebuffer;
  frame.draws = &one, frame.draw_count = 1;
  frame.lights = (const shd_light* const*)&sun, frame.light_count = 1;
  frame.camera = &camera;
  require(shd_render(context, &frame));

  image.width = WIDTH, image.height = HEIGHT;
  image.format = SHD_FORMAT_RGBA8_SRGB;
  image.pixels = s_pixels;
  require(shd_framebuffer_read_color(framebuffer, &image));
  print_hash(name, hash_bytes(UINT64_C(0xcbf29ce484222325), s_pixels, sizeof s_pixels));
  shd_framebuffer_release(framebuffer);
  shd_light_release(sun);
  shd_material_release(material);
  shd_mesh_release(mesh);
}

/* 2. A frame: the material has a texture. */
static void draw_textured(shd_context* context) {
  shd_texture* texture = create_texture(context);
  shd_sampler* sampler = create_sampler(context, SHD_FILTER_TRILINEAR);
  shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, sampler);
  shd_material_desc desc = shd_material_desc_default();
  desc.model = SHD_MODEL_BLINN_PHONG;
  desc.slots = &slot, desc.slot_count = 1;
  draw(context, "frame", &desc);
  shd_sampler_release(sampler);
  shd_texture_release(texture);
}

/* 3. A fragment program: shows the texture coordinates. */
static void uv_as_colour(const shd_fragments* in, shd_radiance* out, void* user_data) {
  const float* blue = (const float*)user_data;
  size_t i;
  for (i = 0; i < in->count; ++i) {
    out->r[i] = in->u[i];
    out->g[i] = in->v[i];
    out->b[i] = *blue;
  }
}

static void draw_program(shd_context* context) {
  float blue = 0.25f;
  shd_material_desc desc = shd_material_desc_default();
  desc.model = SHD_MODEL_PROGRAM;
  desc.program.fragment = uv_as_colour;
  desc.program.user_data = &blue;
  draw(context, "program", &desc);
}

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Seconds of `calls` calls, the best of seven. */
static double measure(const shd_texture* texture, const shd_sampler* sampler, const shd_lookups* lookups,
                      shd_texels* texels, int calls) {
  double best = 1e30;
  int trial, i;
  for (trial = 0; trial < 7; ++trial) {
    const double start = now();
    double seconds;
    for (i = 0; i < calls; ++i) require(shd_texture_sample(texture, sampler, lookups, texels));
    seconds = now() - start;
    if (seconds < best) best = seconds;
  }
  return best;
}

static void print_speed(void) {
  static float u[BATCH], v[BATCH], lod[BATCH], out[4][BATCH];
  shd_context_desc desc = shd_context_desc_default();
  shd_context* context = NULL;
  shd_texture* texture;
  shd_sampler* sampler;
  shd_lookups lookups = shd_lookups_default();
  shd_texels texels = shd_texels_default();
  int i;
  desc.worker_count = 1;
  require(shd_context_create(&desc, &context));
  texture = create_texture(context);
  sampler = create_sampler(context, SHD_FILTER_TRILINEAR);
  for (i = 0; i < BATCH; ++i) {
    u[i] = (float)(i % 1024) / 1024.0f;
    v[i] = (float)(i / 1024) / 1024.0f;
    lod[i] = (float)(i % 16) / 8.0f;
  }
  lookups.u.data = u, lookups.v.data = v, lookups.lod.data = lod;
  for (i = 0; i < 4; ++i) texels.channel[i].data = out[i];
  lookups.count = 1;
  printf("call %.2f ns\n", 1e9 * measure(texture, sampler, &lookups, &texels, CALLS) / CALLS);
  lookups.count = BATCH;
  printf("batch %.4f ms\n", 1e3 * measure(texture, sampler, &lookups, &texels, 3) / 3);
  shd_sampler_release(sampler);
  shd_texture_release(texture);
  shd_context_release(context);
}

int main(int count, char** arguments) {
  shd_context* context = NULL;
  if (count > 1 && strcmp(arguments[1], "--speed") == 0) {
    print_speed();
    return EXIT_SUCCESS;
  }
  require(shd_context_create(NULL, &context));
  look_up(context);
  draw_textured(context);
  draw_program(context);
  if (count > 1) { /* the pixels of the last frame, for a look at them */
    FILE* file = fopen(arguments[1], "wb");
    if (!file || fwrite(s_pixels, sizeof s_pixels, 1, file) != 1 || fclose(file)) return EXIT_FAILURE;
  }
  shd_context_release(context);
  return EXIT_SUCCESS;
}
