/* SPDX-License-Identifier: MIT */
/* Environments in double: every texel is a directional light, and sums run over all texels. */
#ifndef SHD_TESTS_REF_ENVIRONMENT_REF_H
#define SHD_TESTS_REF_ENVIRONMENT_REF_H

#include <math.h>
#include <stdlib.h>

#include <shd/image.h>

#include "ref/projection_ref.h"

typedef struct ref_texel_light {
  double direction[3];
  double solid_angle;
  double radiance[3];
} ref_texel_light;

typedef struct ref_environment {
  size_t count;
  ref_texel_light* lights;
} ref_environment;

static inline double ref_dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The texels of an RGB32F image; free lights afterwards. Solid angles add up to 4 pi. */
static inline ref_environment ref_environment_of(shd_projection projection, const shd_image* image) {
  const uint32_t faces = projection == SHD_PROJECTION_CUBE ? 6 : 1, height = image->height / faces;
  const float* texels = (const float*)image->pixels;
  ref_environment out = {0, NULL};
  double total = 0.0;
  out.lights = (ref_texel_light*)malloc((size_t)image->width * image->height * sizeof *out.lights);
  for (uint32_t y = 0; y < image->height; ++y) {
    for (uint32_t x = 0; x < image->width; ++x) {
      const long double u = (x + 0.5L) / image->width, v = (y % height + 0.5L) / height;
      ref_texel_light* light = &out.lights[out.count];
      long double n[3], density = projection == SHD_PROJECTION_LAT_LONG ? sinl(REF_PI * v) : 0.0L;
      if (!ref_unproject(projection, u, v, y / height, n)) continue;
      if (projection != SHD_PROJECTION_LAT_LONG) density = ref_density(projection, u, v, y / height);
      light->solid_angle = (double)density;
      total += light->solid_angle;
      for (int c = 0; c < 3; ++c) {
        light->direction[c] = (double)n[c];
        light->radiance[c] = (double)texels[3 * ((size_t)y * image->width + x) + (size_t)c];
      }
      ++out.count;
    }
  }
  for (size_t i = 0; i < out.count; ++i) out.lights[i].solid_angle *= 4.0 * (double)REF_PI / total;
  return out;
}

static inline void ref_irradiance(const ref_environment* environment, const double* n, double* rgb) {
  rgb[0] = rgb[1] = rgb[2] = 0.0;
  for (size_t i = 0; i < environment->count; ++i) {
    const ref_texel_light* light = &environment->lights[i];
    const double weight = fmax(0.0, ref_dot(n, light->direction)) * light->solid_angle;
    for (int c = 0; c < 3; ++c) rgb[c] += weight * light->radiance[c];
  }
}

/* Irradiance of the harmonics of the orders 0 to 2, from their usual definition. */
static inline void ref_harmonics_at(const double* n, double* y) {
  y[0] = 0.28209479177387814;
  for (int c = 0; c < 3; ++c) y[1 + c] = 0.48860251190291992 * n[c];
  y[4] = 1.0925484305920792 * n[0] * n[1];
  y[5] = 1.0925484305920792 * n[1] * n[2];
  y[6] = 1.0925484305920792 * n[0] * n[2];
  y[7] = 0.31539156525252005 * (3.0 * n[2] * n[2] - 1.0);
  y[8] = 0.54627421529603959 * (n[0] * n[0] - n[1] * n[1]);
}
static inline void ref_harmonic_irradiance(const ref_environment* environment, const double* n, double* rgb) {
  const double pi = (double)REF_PI;
  double at[9], of[9], sum[3][9] = {{0}};
  ref_harmonics_at(n, at);
  for (size_t i = 0; i < environment->count; ++i) {
    const ref_texel_light* light = &environment->lights[i];
    ref_harmonics_at(light->direction, of);
    for (int k = 0; k < 27; ++k) sum[k / 9][k % 9] += light->radiance[k / 9] * light->solid_angle * of[k % 9];
  }
  for (int c = 0; c < 3; ++c) {
    rgb[c] = 0.0;
    for (int k = 0; k < 9; ++k) rgb[c] += (k == 0 ? pi : k < 4 ? 2.0 * pi / 3.0 : pi / 4.0) * sum[c][k] * at[k];
    rgb[c] = fmax(rgb[c], 0.0);
  }
}

/* Weight of a lobe around r. GGX: D(h) n.l for n = v = r. */
static inline double ref_ggx_lobe(double r_dot_l, double alpha) {
  const double h2 = 0.5 * (1.0 + r_dot_l), spread = h2 * (alpha * alpha - 1.0) + 1.0;
  return r_dot_l > 0.0 ? r_dot_l / (spread * spread) : 0.0;
}
static inline double ref_phong_lobe(double r_dot_l, double exponent) {
  return r_dot_l > 0.0 ? pow(r_dot_l, exponent) : 0.0;
}

/* Integral of a lobe over all directions. */
static inline double ref_lobe_integral(double (*lobe)(double, double), double parameter) {
  const int steps = 200000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double a = (i + 0.5) / steps, angle = 0.5 * (double)REF_PI * a * a; /* denser near the axis */
    sum += lobe(cos(angle), parameter) * sin(angle) * a / steps;
  }
  return 2.0 * (double)REF_PI * (double)REF_PI * sum;
}

/* Sum of a lobe over the texels, divided by its integral. */
static inline void ref_lobe_mean(const ref_environment* environment, double (*lobe)(double, double), double parameter,
                                 double integral, const double* r, double* rgb) {
  rgb[0] = rgb[1] = rgb[2] = 0.0;
  for (size_t i = 0; i < environment->count; ++i) {
    const ref_texel_light* light = &environment->lights[i];
    const double weight = lobe(ref_dot(r, light->direction), parameter) * light->solid_angle / integral;
    for (int c = 0; c < 3; ++c) rgb[c] += weight * light->radiance[c];
  }
}

#endif /* SHD_TESTS_REF_ENVIRONMENT_REF_H */
