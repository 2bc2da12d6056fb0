// SPDX-License-Identifier: MIT
// Mip levels of 3D textures as exact averages of boxes of the base, for any size. The steps are those of mip.cpp with
// one axis more: while all sizes halve evenly (or are 1), a level is the average of the unrounded level before it. A
// round reduces cubes of its first level by up to kCubeSteps levels in a scratch of 16 KB, and keeps the unrounded
// averages of the last level for the next round and for updates. From the first uneven step on, each level is summed
// from the base, with the integer volumes that base texels and level texels share as weights.
//
// Sums are doubles. They are exact for 8-bit texels and within 2^-50 of the sum of magnitudes for other formats. A
// texture of one slice has the levels of a 2D texture.
#include <cstring>

#include "texture/store/rows.h"
#include "texture/table/halve.h"
#include "texture/table/tables.h"

namespace shd::texture {
namespace {

constexpr uint32_t kCubeSteps = 4;
constexpr uint32_t kCube = 1u << kCubeSteps;

struct Size {
  uint32_t width, height, depth;
};

Size size_of(const Texture& texture, uint32_t level) {
  return {level_size(texture.width, level), level_size(texture.height, level), level_size(texture.depth, level)};
}

/// Returns the size after a step that halves evenly.
Size half_of(Size size) {
  const auto half = [](uint32_t n) { return n > 1 ? n / 2 : 1; };
  return {half(size.width), half(size.height), half(size.depth)};
}

/// Returns the texels of a level over a box of the base.
Box level_box(const Texture& texture, const Box& box, uint32_t level) {
  const Size size = size_of(texture, level);
  return {level_range(box.x, texture.width, size.width), level_range(box.y, texture.height, size.height),
          level_range(box.z, texture.depth, size.depth)};
}

/// Calls body(y, z) for the rows of a box on the executor.
template <class Body>
void for_box_rows(const core::Context& context, const Box& box, const Body& body) {
  for_rows(context, {0, box.y.size() * box.z.size()},
           [&](uint32_t row, uint32_t) { body(box.y.first + row % box.y.size(), box.z.first + row / box.y.size()); });
}

/// Averages two rows into the first one.
inline void average_into(double* to, const double* other, size_t count) {
  for (size_t i = 0; i < count; ++i) to[i] = 0.5 * (to[i] + other[i]);
}

/// One round over levels that halve evenly, from level `from` to level from + steps.
struct CubeRound {
  const TexelCodec& codec;
  Texture& texture;
  const double* source;  // unrounded level `from`; null for the stored base
  double* last;          // unrounded level from + steps, or null
  uint32_t from, steps;

  void run(const core::Context& context, const Box& box) const {
    const Box cubes = level_box(texture, box, from + steps);
    for_box_rows(context, cubes, [&](uint32_t y, uint32_t z) {
      for (uint32_t x = cubes.x.first; x < cubes.x.end; ++x) run_cube(x, y, z);
    });
  }

  /// Computes the texels of every level under texel (x, y, z) of the last level.
  void run_cube(uint32_t x, uint32_t y, uint32_t z) const {
    double scratch[4 * kCube * kCube * kCube / 8];
    const auto part = [&](uint32_t size) { return size < 1u << steps ? size : 1u << steps; };
    const Size whole = size_of(texture, from);
    Size size = {part(whole.width), part(whole.height), part(whole.depth)};
    halve_source(x * size.width, y * size.height, z * size.depth, size, scratch);
    for (uint32_t step = 1; step <= steps; ++step) {
      if (step > 1) halve_cube(size, scratch);
      size = half_of(size);
      store(from + step, x * size.width, y * size.height, z * size.depth, size, scratch);
    }
    if (last) {
      const Size end = size_of(texture, from + steps);
      std::memcpy(last + ((size_t{z} * end.height + y) * end.width + x) * codec.channels, scratch,
                  codec.channels * sizeof(double));
    }
  }

  /// Computes the first step of a cube whose first texel is (x, y, z).
  void halve_source(uint32_t x, uint32_t y, uint32_t z, Size size, double* to) const {
    double behind[4 * kCube / 2];
    const Size half = half_of(size);
    const uint32_t down = size.height > 1 ? 1 : 0, deep = size.depth > 1 ? 1 : 0;
    for (uint32_t k = 0; k < half.depth; ++k) {
      for (uint32_t j = 0; j < half.height; ++j, to += size_t{half.width} * codec.channels) {
        halve_pair(x, y + 2 * j, down, z + 2 * k, size.width, to);
        if (deep == 0) continue;
        halve_pair(x, y + 2 * j, down, z + 2 * k + 1, size.width, behind);
        average_into(to, behind, size_t{half.width} * codec.channels);
      }
    }
  }

  /// Averages squares of 2 x 2 texels of two rows of a slice of the first level.
  void halve_pair(uint32_t x, uint32_t y, uint32_t down, uint32_t z, uint32_t width, double* to) const {
    if (source) {
      const Size whole = size_of(texture, from);
      const size_t pitch = size_t{whole.width} * codec.channels;
      halve_rows(codec.channels, source + (size_t{z} * whole.height + y) * pitch + x * codec.channels, down * pitch,
                 width, to);
    } else {
      halve_texels(codec, row_of(texture, z, 0, y) + size_t{x} * codec.size,
                   row_of(texture, z, 0, y + down) + size_t{x} * codec.size, width, to);
    }
  }

  /// Averages cubes of 2 x 2 x 2 texels of a packed cube in place.
  void halve_cube(Size size, double* cube) const {
    double behind[4 * kCube / 4];
    const Size half = half_of(size);
    const size_t pitch = size_t{size.width} * codec.channels, down = size.height > 1 ? pitch : 0;
    double* to = cube;
    for (uint32_t k = 0; k < half.depth; ++k) {
      for (uint32_t j = 0; j < half.height; ++j, to += size_t{half.width} * codec.channels) {
        const double* front = cube + (size_t{2} * k * size.height + 2 * j) * pitch;
        if (size.depth > 1) halve_rows(codec.channels, front + size.height * pitch, down, size.width, behind);
        halve_rows(codec.channels, front, down, size.width, to);
        if (size.depth > 1) average_into(to, behind, size_t{half.width} * codec.channels);
      }
    }
  }

  void store(uint32_t level, uint32_t x, uint32_t y, uint32_t z, Size size, const double* average) const {
    for (uint32_t k = 0; k < size.depth; ++k) {
      for (uint32_t j = 0; j < size.height; ++j) {
        codec.store(average, size.width, row_of(texture, z + k, level, y + j) + size_t{x} * codec.size);
        average += size_t{size.width} * codec.channels;
      }
    }
  }
};

/// Sums one level from the base.
void sum_level(const core::Context& context, const TexelCodec& codec, Texture& texture, uint32_t level,
               const Box& box) {
  const Size size = size_of(texture, level);
  const double volume = static_cast<double>(texture.width) * texture.height * texture.depth;
  const Box texels = level_box(texture, box, level);
  for_box_rows(context, texels, [&](uint32_t y, uint32_t z) {
    const AxisSpan down(y, texture.height, size.height), deep(z, texture.depth, size.depth);
    uint8_t* texel = row_of(texture, z, level, y) + size_t{texels.x.first} * codec.size;
    for (uint32_t x = texels.x.first; x < texels.x.end; ++x, texel += codec.size) {
      const AxisSpan across(x, texture.width, size.width);
      double sum[4] = {};
      for (uint32_t slice = deep.first; slice <= deep.last; ++slice) {
        for (uint32_t row = down.first; row <= down.last; ++row) {
          add_row(codec, row_of(texture, slice, 0, row), across, down.weight(row) * deep.weight(slice), sum);
        }
      }
      store_averages(codec, sum, volume, 1, texel);
    }
  });
}

/// Returns the number of levels after the base that halve evenly.
uint32_t even_slice_steps(const Texture& texture) {
  const auto is_even = [](uint32_t n) { return n == 1 || n % 2 == 0; };
  Size size = size_of(texture, 0);
  uint32_t steps = 0;
  while (steps + 1 < texture.level_count && is_even(size.width) && is_even(size.height) && is_even(size.depth)) {
    size = half_of(size);
    ++steps;
  }
  return steps;
}

/// Returns the number of unrounded averages of one level.
size_t averages_of(const Texture& texture, uint32_t level) {
  const Size size = size_of(texture, level);
  return size_t{size.width} * size.height * size.depth * texture.channels;
}

}  // namespace

size_t slice_sums_size(const Texture& texture) {
  const uint32_t even = even_slice_steps(texture);
  size_t size = 0;
  for (uint32_t level = kCubeSteps; level < even; level += kCubeSteps) size += averages_of(texture, level);
  return size;
}

void build_slice_levels(const core::Context& context, Texture* texture, const Box& box, double* sums) {
  const TexelCodec& codec = codec_of(texture->component, texture->channels);
  const uint32_t even = even_slice_steps(*texture);
  const double* source = nullptr;
  for (uint32_t from = 0, steps; from < even; from += steps) {
    steps = even - from < kCubeSteps ? even - from : kCubeSteps;
    double* last = from + steps < even ? sums : nullptr;
    CubeRound{codec, *texture, source, last, from, steps}.run(context, box);
    source = last;
    if (last) sums += averages_of(*texture, from + steps);
  }
  for (uint32_t level = even + 1; level < texture->level_count; ++level) {
    sum_level(context, codec, *texture, level, box);
  }
}

}  // namespace shd::texture
