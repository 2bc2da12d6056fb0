// SPDX-License-Identifier: MIT
// Summed-area tables: entries against plain sums, memory, equal bits for any order of tasks, and the accuracy of sums
// of many or of very large texels.
#include "summed_area_fixture.h"

#include "texture/format/formats.h"
#include "texture/table/summed_area.h"

namespace {

using namespace fixture;

/// Entry of channel c right of x - 1 and below y - 1.
double entry(const Texture& texture, uint32_t layer, uint32_t x, uint32_t y, size_t c) {
  const size_t i =
      layer * shd::texture::sum_count(texture) + (size_t{y} * (texture.width + 1) + x) * texture.channels + c;
  if (shd::texture::has_integer_sums(texture)) return reinterpret_cast<const uint32_t*>(texture.sums.data())[i];
  return reinterpret_cast<const double*>(texture.sums.data())[i];
}

/// Compares every entry with the sum of its texels in long doubles, each minus the offset of the table.
void test_entries(void** state) {
  const auto& size = *static_cast<const SizeCase*>(*state);
  static long double column[4096][4];
  for (const shd_format format : kFormats) {
    Texture* texture = random_summed(format, size.width, size.height, 2);
    const bool unorm = texture->component == Component::kUnorm8 || texture->component == Component::kUnorm16;
    for (uint32_t layer = 0; layer < 2; ++layer) {
      const double* values = oracle_values(*texture, layer);
      memset(column, 0, sizeof column);
      long double magnitudes = 0;
      for (uint32_t y = 1; y <= size.height; ++y) {
        long double row[4] = {};
        for (uint32_t x = 1; x <= size.width; ++x) {
          for (size_t c = 0; c < texture->channels; ++c) {
            const double one = shd::texture::one_of(texture->component, c);
            const double origin = texture->sum_origins[layer * texture->channels + c];
            const double value = values[((y - 1) * size_t{size.width} + x - 1) * 4 + c];
            const double term = unorm ? round(value * one) - round(origin * one) : (value - origin) * one;
            row[c] += static_cast<long double>(term);
            column[x - 1][c] += row[c];
            magnitudes += static_cast<long double>(fabs(term));
            const bool srgb = texture->component == Component::kSrgb8;  // decoded to floats, which the oracle does not
                                                                        // do
            const double tolerance =
                unorm ? 0 : static_cast<double>(magnitudes) * (srgb ? 1e-6 : 0x1p-51) + srgb * 1e-7;
            const double want = static_cast<double>(column[x - 1][c]);
            if (x % 7 == 1 || x == size.width) {
              shd_assert_close(size.name, x, entry(*texture, layer, x, y, c), want, tolerance, 0);
            }
          }
        }
      }
      for (size_t c = 0; c < texture->channels; ++c) {
        assert_true(entry(*texture, layer, 0, size.height, c) == 0);
        assert_true(entry(*texture, layer, size.width, 0, c) == 0);
      }
    }
    free_texture(texture);
  }
}

/// 4 bytes per channel for 8-bit unorm, otherwise 8; no table of non-finite texels if there are none.
void test_memory(void**) {
  for (const SizeCase& size : kSizes) {
    for (const shd_format format : kFormats) {
      Texture* texture = random_summed(format, size.width, size.height, 2);
      const size_t texels = size_t{2} * size.width * size.height;
      const size_t entries = size_t{2} * (size.width + 1) * (size.height + 1) * texture->channels;
      const size_t bytes = texture->component == Component::kUnorm8 ? 4 : 8;
      assert_int_equal(shd::texture::byte_size(*texture),
                       texels * shd::texture::texel_size(*texture) + entries * bytes + 2 * texture->channels * 8);
      assert_int_equal(texture->nonfinite_sums.size(), 0);
      free_texture(texture);
    }
  }
}

void test_task_order(void**) {
  shd::core::Context* backwards = backwards_context();
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F, SHD_FORMAT_RG8_SRGB}) {
    auto* texels = static_cast<uint8_t*>(malloc(1023 * 511 * 16));
    random_texels(format, 1023 * 511, 5, texels);
    Texture* forwards = build_summed(*context(), format, 1023, 511, 1, texels);
    Texture* other = build_summed(*backwards, format, 1023, 511, 1, texels);
    assert_int_equal(forwards->sums.size(), other->sums.size());
    assert_memory_equal(forwards->sums.data(), other->sums.data(), forwards->sums.size());
    free_texture(forwards);
    shd::core::destroy(backwards->allocator, other);
    free(texels);
  }
  shd::core::release(*backwards);
}

Batch t_batch;

/// Looks up texels from (0, 0) to (width - 1, height - 1) in boxes of all sizes around many points.
void look_up(const Texture& texture, float smallest) {
  Random random{77};
  t_batch.count = kMaxPoints;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    t_batch.u[i] = random.real(-1, 2);
    t_batch.v[i] = random.real(-1, 2);
    t_batch.dudx[i] = t_batch.dvdy[i] =
        smallest * ldexpf(1, static_cast<int>(i % 14)) / static_cast<float>(texture.width);
    t_batch.dvdx[i] = t_batch.dudy[i] = 0;
  }
  run(texture, make_sampler(summed_desc(0, SHD_BOX_BOUNDING)), hwy::SupportedAndGeneratedTargets().front(),
      t_batch.lookups(true, false), &t_batch);
}

/// A large texture of one value, up to the largest half, gives this value; also for 8-bit codes below and above the
/// size from which sums are doubles.
void test_large_constants(void**) {
  struct Constant {
    shd_format format;
    uint32_t width, height;
    double value;
  };
  const Constant constants[] = {{SHD_FORMAT_R32F, 4096, 2048, 1},   {SHD_FORMAT_R32F, 4096, 2048, 65504},
                                {SHD_FORMAT_R32F, 2048, 2048, 0.1}, {SHD_FORMAT_R8, 4096, 4096, 1},
                                {SHD_FORMAT_R8, 4096, 4112, 1},     {SHD_FORMAT_R8, 4096, 4096, 77 / 255.0},
                                {SHD_FORMAT_R8_SRGB, 2048, 2048, 1}};
  for (const Constant& k : constants) {
    const size_t count = size_t{k.width} * k.height, size = shd_format_size(k.format);
    auto* texels = static_cast<uint8_t*>(malloc(count * size));
    const auto value = static_cast<float>(k.value);
    if (size == 1) memset(texels, static_cast<int>(lround(k.value * 255)), count);
    for (size_t i = 0; size == 4 && i < count; ++i) memcpy(texels + 4 * i, &value, 4);
    Texture* texture = build_summed(*context(), k.format, k.width, k.height, 1, texels);
    free(texels);
    look_up(*texture, 1);
    for (size_t i = 0; i < kMaxPoints; ++i) assert_true(t_batch.out[0][i] == value);
    free_texture(texture);
  }
}

struct FirstCase {
  const char* name;
  uint32_t edge;
  float first, others;
  double bound;  // relative error
};
// Sums are relative to the first texel, so a constant texture of any size has sums of 0. Another first texel makes the
// sums as large as they can be: the last row of the third case has the sums of 2^24 texels of 65504, 2^40.
const FirstCase k_firsts[] = {
    {"first_texel/65504_of_1.1", 2048, 65504, 1.1f, 1e-4},
    {"first_texel/0_of_1", 4096, 0, 1, 1e-6},
    {"first_texel/0_of_65504", 4096, 0, 65504, 1e-6},
    {"first_texel/-65504_of_65504", 4096, -65504, 65504, 1e-6},
    {"first_texel/1e-30_of_0.001", 2048, 1e-30f, 0.001f, 1e-6},
};

/// A texture of one value, except its first texel: boxes beyond that texel have this value.
void test_first_texel(void** state) {
  const auto& c = *static_cast<const FirstCase*>(*state);
  const size_t count = size_t{c.edge} * c.edge;
  auto* texels = static_cast<float*>(malloc(count * sizeof(float)));
  for (size_t i = 0; i < count; ++i) texels[i] = c.others;
  texels[0] = c.first;
  Texture* texture = build_summed(*context(), SHD_FORMAT_R32F, c.edge, c.edge, 1, texels);
  t_batch.count = 64;
  double worst = 0;
  for (size_t i = 0; i < 64; ++i) {
    t_batch.u[i] = t_batch.v[i] = 0.97f;
    t_batch.dudx[i] = t_batch.dvdy[i] = static_cast<float>(i) / static_cast<float>(c.edge);
    t_batch.dvdx[i] = t_batch.dudy[i] = 0;
  }
  run(*texture, make_sampler(summed_desc(0, SHD_BOX_BOUNDING)), hwy::SupportedAndGeneratedTargets().front(),
      t_batch.lookups(true, false), &t_batch);
  const auto others = static_cast<double>(c.others);
  for (size_t i = 0; i < 64; ++i) worst = fmax(worst, fabs(static_cast<double>(t_batch.out[0][i]) / others - 1));
  print_message("%s: relative error %.2g\n", c.name, worst);
  assert_true(worst <= c.bound);
  free_texture(texture);
  free(texels);
}

}  // namespace

int main() {
  CMUnitTest tests[24];
  size_t n = 0;
  for (const SizeCase& c : kSizes) {
    tests[n++] = {c.name, test_entries, nullptr, nullptr, const_cast<SizeCase*>(&c)};
  }
  tests[n++] = {"memory", test_memory, nullptr, nullptr, nullptr};
  tests[n++] = {"task_order", test_task_order, nullptr, nullptr, nullptr};
  tests[n++] = {"large_constants", test_large_constants, nullptr, nullptr, nullptr};
  for (const FirstCase& c : k_firsts) {
    tests[n++] = {c.name, test_first_texel, nullptr, nullptr, const_cast<FirstCase*>(&c)};
  }
  return _cmocka_run_group_tests("unit.texture.summed_area_table", tests, n, nullptr, nullptr);
}
