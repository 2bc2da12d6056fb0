// SPDX-License-Identifier: MIT
// Oracle of the solid textures: the formulas of shd/solid.h for one point, in double.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <shd/solid.h>

namespace ref {

/// A lattice point or cell.
struct Lattice {
  int64_t x, y, z;
};

inline uint32_t solid_mix(uint32_t h) {
  h = (h ^ h >> 16) * 0x7feb352du;
  h = (h ^ h >> 15) * 0x846ca68bu;
  return h ^ h >> 16;
}

/// Hash of a lattice point: the fractions of the square roots of 2, 3 and 5 as factors.
inline uint32_t solid_hash(Lattice p, uint32_t seed) {
  return solid_mix(static_cast<uint32_t>(p.x) * 0x6a09e667u + static_cast<uint32_t>(p.y) * 0xbb67ae85u +
                   static_cast<uint32_t>(p.z) * 0x3c6ef373u + seed);
}

/// The gradient function of Perlin's reference implementation of 2002, with the highest bits of the hash.
inline double solid_edge(uint32_t hash, double x, double y, double z) {
  const uint32_t h = hash >> 28;
  const double u = h < 8 ? x : y, v = h < 4 ? y : h == 12 || h == 14 ? x : z;
  return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
}

/// Weight of a lattice point at distance t along an axis.
inline double solid_weight(shd_solid_fade fade, double t) {
  const double s = 1 - std::fabs(t);
  if (s <= 0) return 0;
  switch (fade) {
    case SHD_SOLID_FADE_LINEAR: return s;
    case SHD_SOLID_FADE_CUBIC: return 2 * std::fabs(t * t * t) - 3 * t * t + 1;
    default: return s * s * s * (6 * s * s - 15 * s + 10);
  }
}

/// Sum over the eight lattice points around a place of their weights times value(point, x - i, y - j, z - k).
template <class Value>
double solid_lattice_sum(shd_solid_fade fade, const double (&p)[3], const Value& value) {
  const Lattice cell = {static_cast<int64_t>(std::floor(p[0])), static_cast<int64_t>(std::floor(p[1])),
                        static_cast<int64_t>(std::floor(p[2]))};
  double sum = 0;
  for (int64_t i = cell.x; i <= cell.x + 1; ++i) {
    for (int64_t j = cell.y; j <= cell.y + 1; ++j) {
      for (int64_t k = cell.z; k <= cell.z + 1; ++k) {
        const double u = p[0] - static_cast<double>(i), v = p[1] - static_cast<double>(j),
                     w = p[2] - static_cast<double>(k);
        sum += solid_weight(fade, u) * solid_weight(fade, v) * solid_weight(fade, w) * value(Lattice{i, j, k}, u, v, w);
      }
    }
  }
  return sum;
}

/// Tables of the classic form.
struct SolidTable {
  const int32_t* phi;         // [256]
  const float *gx, *gy, *gz;  // [256] G(phi(i))
};

inline double solid_table_perlin(const SolidTable& table, shd_solid_fade fade, const double (&p)[3]) {
  return solid_lattice_sum(fade, p, [&](Lattice at, double u, double v, double w) {
    const int64_t jk = at.y + table.phi[at.z & 255];
    const int64_t ijk = (at.x + table.phi[jk & 255]) & 255;
    return static_cast<double>(table.gx[ijk]) * u + static_cast<double>(table.gy[ijk]) * v +
           static_cast<double>(table.gz[ijk]) * w;
  });
}

/// The factor that brings hashed Perlin noise to -1..1.
inline double solid_factor(shd_solid_fade fade) {
  return fade == SHD_SOLID_FADE_LINEAR ? 0.9391 : fade == SHD_SOLID_FADE_CUBIC ? 0.957 : 0.9649;
}

inline double solid_hashed_perlin(shd_solid_fade fade, const double (&p)[3], uint32_t seed) {
  const double sum = solid_lattice_sum(
      fade, p, [&](Lattice at, double u, double v, double w) { return solid_edge(solid_hash(at, seed), u, v, w); });
  return solid_factor(fade) * sum;
}

inline double solid_value(shd_solid_fade fade, const double (&p)[3], uint32_t seed) {
  return solid_lattice_sum(fade, p, [&](Lattice at, double, double, double) {
    const auto hash = static_cast<int32_t>(solid_hash(at, seed));
    return std::floor(static_cast<double>(hash) / 256) / 8388608;
  });
}

/// The skewed lattice points of all tetrahedra near a place; those farther than sqrt(1/2) have no weight.
inline double solid_simplex(const double (&p)[3], uint32_t seed) {
  const double skew = (p[0] + p[1] + p[2]) / 3;
  const auto i0 = static_cast<int64_t>(std::floor(p[0] + skew)), j0 = static_cast<int64_t>(std::floor(p[1] + skew)),
             k0 = static_cast<int64_t>(std::floor(p[2] + skew));
  double sum = 0;
  for (int64_t i = i0 - 1; i <= i0 + 2; ++i) {
    for (int64_t j = j0 - 1; j <= j0 + 2; ++j) {
      for (int64_t k = k0 - 1; k <= k0 + 2; ++k) {
        const double unskew = static_cast<double>(i + j + k) / 6;
        const double x = p[0] - static_cast<double>(i) + unskew, y = p[1] - static_cast<double>(j) + unskew,
                     z = p[2] - static_cast<double>(k) + unskew;
        const double t = std::fmax(0.5 - x * x - y * y - z * z, 0);
        sum += t * t * t * t * solid_edge(solid_hash({i, j, k}, seed), x, y, z);
      }
    }
  }
  return 76.88 * sum;
}

/// F1, F2 or F2 - F1 over the feature points of 7^3 cells, divided by sqrt(3).
inline double solid_worley(shd_solid_distance distance, const double (&p)[3], uint32_t seed) {
  double first = 1e9, second = 1e9;
  const double cell[3] = {std::floor(p[0]), std::floor(p[1]), std::floor(p[2])};
  for (int n = 0; n < 343; ++n) {
    const double at[3] = {cell[0] + n % 7 - 3, cell[1] + n / 7 % 7 - 3, cell[2] + n / 49 - 3};
    const uint32_t hash =
        solid_hash({static_cast<int64_t>(at[0]), static_cast<int64_t>(at[1]), static_cast<int64_t>(at[2])}, seed);
    const uint32_t part[3] = {0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u};
    double square = 0;
    for (int c = 0; c < 3; ++c) {
      const double to = at[c] + static_cast<double>(hash * part[c] >> 8) / 16777216 - p[c];
      square += to * to;
    }
    const double length = std::sqrt(square);
    if (length < first) {
      second = first;
      first = length;
    } else if (length < second) {
      second = length;
    }
  }
  const double value = distance == SHD_SOLID_DISTANCE_F1   ? first
                       : distance == SHD_SOLID_DISTANCE_F2 ? second
                                                           : second - first;
  return value / std::sqrt(3.0);
}

/// One octave of a kind.
inline double solid_noise(const shd_solid_desc& desc, const SolidTable& table, const double (&p)[3], uint32_t seed) {
  const shd_solid_fade fade = desc.fade;
  if (desc.kind == SHD_SOLID_PERLIN && desc.gradients == SHD_SOLID_GRADIENTS_TABLE)
    return solid_table_perlin(table, fade, p);
  if (desc.kind == SHD_SOLID_VALUE) return solid_value(fade, p, seed);
  if (desc.kind == SHD_SOLID_SIMPLEX) return solid_simplex(p, seed);
  if (desc.kind == SHD_SOLID_WORLEY) return solid_worley(desc.distance, p, seed);
  return solid_hashed_perlin(fade, p, seed);
}

/// Share of an octave that is kept, for waves per pixel.
inline double solid_kept(double waves) {
  return std::fmin(std::fmax(2 - 2 * waves, 0), 1);
}

/// Sum of octaves at a place in cells, with the pixel's width in cells. `mean` replaces octaves that are too fine.
inline double solid_sum(const shd_solid_desc& desc, const SolidTable& table, bool turbulence, double mean,
                        const double (&p)[3], double width) {
  double sum = 0, amplitudes = 0, frequency = 1, amplitude = 1;
  for (uint32_t i = 0; i < desc.octaves; ++i) {
    const double q[3] = {frequency * p[0], frequency * p[1], frequency * p[2]};
    double n = solid_noise(desc, table, q, desc.seed + i * 0x9e3779b9u);
    if (turbulence) n = std::fabs(n);
    sum += amplitude * (mean + solid_kept(width * frequency) * (n - mean));
    amplitudes += amplitude;
    frequency *= static_cast<double>(desc.lacunarity);
    amplitude *= static_cast<double>(desc.gain);
  }
  return sum / amplitudes;
}

/// Average over [x - width / 2, x + width / 2] of the wave that is 1 in [2 k, 2 k + 1) and -1 elsewhere.
inline double solid_wave(double x, double width) {
  if (width == 0) return std::fmod(std::floor(x), 2) == 0 ? 1 : -1;
  double sum = 0;
  for (double k = std::floor(x - width / 2); k <= x + width / 2; ++k) {
    const double begin = std::fmax(k, x - width / 2), end = std::fmin(k + 1, x + width / 2);
    sum += (std::fmod(k, 2) == 0 ? 1 : -1) * std::fmax(end - begin, 0);
  }
  return sum / width;
}

inline double solid_step(double begin, double end, double t) {
  const double s = std::fmin(std::fmax((t - begin) / (end - begin), 0), 1);
  return s * s * (3 - 2 * s);
}

/// The value of a solid texture. `mean` is that of one octave.
inline double solid(const shd_solid_desc& desc, const SolidTable& table, double mean, const double (&place)[3],
                    double width) {
  const double pi = 3.14159265358979324, size = static_cast<double>(desc.size);
  const double p[3] = {place[0] / size, place[1] / size, place[2] / size}, w = width / size;
  const double distortion = static_cast<double>(desc.distortion);
  switch (desc.kind) {
    case SHD_SOLID_STRIPES:
      if (w == 0) return std::sin(pi * std::fmod(p[0], 2)) > 0 && p[0] != std::floor(p[0]) ? 0 : 1;
      return (1 - solid_wave(p[0], w)) / 2;
    case SHD_SOLID_CHECKER: return (1 - solid_wave(p[0], w) * solid_wave(p[1], w) * solid_wave(p[2], w)) / 2;
    case SHD_SOLID_MARBLE: {
      const double t = p[0] + distortion * solid_sum(desc, table, true, mean, p, w);
      return 0.5 + 0.5 * solid_kept(w / 2) * std::sin(pi * t);
    }
    case SHD_SOLID_WOOD: {
      const double t = std::sqrt(p[0] * p[0] + p[2] * p[2]) + distortion * solid_sum(desc, table, false, 0, p, w);
      const double f = t - std::floor(t), ring = solid_step(0, 0.8, f) - solid_step(0.83, 1, f);
      return 0.515 + solid_kept(w) * (ring - 0.515);
    }
    default: {
      const bool turbulence = desc.kind != SHD_SOLID_WORLEY && desc.sum == SHD_SOLID_SUM_TURBULENCE;
      return solid_sum(desc, table, turbulence, mean, p, w);
    }
  }
}

}  // namespace ref
