// SPDX-License-Identifier: MIT
// Random textures, samplers and lookups, valid and invalid. No call may crash, leak, write outside its columns, give a
// non-finite value from finite texels, or give different bits on another SIMD target.
#include "source.h"

namespace shd::fuzz {
namespace {

constexpr float kCanary = -12345.75f;

/// The arguments that one input describes, so that they can run on several contexts.
struct Case {
  shd_texture_desc texture = shd_texture_desc_default();
  shd_sampler_desc sampler = shd_sampler_desc_default();
  std::vector<uint8_t> texels;
  std::vector<float> columns[7];
  size_t column_stride[7] = {};
  size_t count = 0;
  std::vector<uint32_t> integers[2];
  size_t out_stride[4] = {};
  uint32_t channels = 0;
  bool integer_texels = false;
};

uint32_t random_edge(Source& source) {
  constexpr uint32_t kEdges[] = {0, 1, 2, 3, 5, 7, 13, 16, 17, 31, 64, 65536, 65537, 0xffffffffu};
  return source.one_in(3) ? 1 + source.below(70) : kEdges[source.below(sizeof kEdges / sizeof kEdges[0])];
}

void fill_texture(Source& source, Case& c) {
  shd_texture_desc& desc = c.texture;
  desc.format = static_cast<shd_format>(source.one_in(16) ? source.word() & 0x7fffffff : 1 + source.below(20));
  desc.width = random_edge(source);
  desc.height = random_edge(source);
  if (uint64_t{desc.width} * desc.height > 1 << 18 && desc.width <= 65536 && desc.height <= 65536) desc.height = 1;
  desc.tables = source.one_in(16) ? source.word() : source.below(8);
  if (source.one_in(4)) desc.layers = source.one_in(8) ? source.word() | 4096 : 1 + source.below(3);
  for (shd_channel& channel : desc.swizzle) channel = static_cast<shd_channel>(source.below(source.one_in(32) ? 9 : 6));
  for (float& value : desc.fill) value = source.one_in(32) ? source.hostile() : source.unit();
  if (source.one_in(64)) desc.struct_size = source.one_in(2) ? source.below(sizeof desc) : 0x80000000u | source.word();
  const size_t pixel = shd_format_size(desc.format);
  const size_t packed = desc.width * pixel;
  if (source.one_in(4)) desc.row_stride = source.one_in(8) ? source.word() : packed + 16 * source.below(4);
  const size_t rows = size_t{desc.height} > 65536 ? 1 : desc.height;
  const size_t stride = desc.row_stride > packed && desc.row_stride < packed + 64 ? desc.row_stride : packed;
  const size_t size = rows * stride * (desc.layers > 3 ? 1 : desc.layers);
  c.texels.assign(size <= size_t{1} << 24 ? size : 16, 0);
  const bool floats = desc.format == SHD_FORMAT_RGBA32F || desc.format >= SHD_FORMAT_R32F;
  const bool halves =
      desc.format == SHD_FORMAT_RGBA16F || (desc.format >= SHD_FORMAT_R16F && desc.format <= SHD_FORMAT_RGB16F);
  c.integer_texels = !floats && !halves;
  for (size_t i = 0; i + 4 <= c.texels.size() && i < 4096; i += 4) {
    const float value = floats ? source.hostile() : 0.0f;
    const uint32_t bits = source.word();
    std::memcpy(&c.texels[i], floats ? static_cast<const void*>(&value) : &bits, 4);
  }
  // With an unusual stride the library may read beyond the buffer, which is correct: skip such a case here.
  if (desc.row_stride > packed + 64 && desc.height > 1) desc.row_stride = packed;
  desc.texels = source.one_in(32) ? nullptr : c.texels.data();
}

void fill_sampler(Source& source, Case& c) {
  shd_sampler_desc& desc = c.sampler;
  desc.filter = static_cast<shd_filter>(source.one_in(32) ? source.word() & 0x7fffffff : source.below(12));
  desc.magnification = static_cast<shd_magnification>(source.below(source.one_in(32) ? 9 : 4));
  desc.max_anisotropy = source.one_in(16) ? source.hostile() : 1.0f + static_cast<float>(source.below(64));
  desc.probe_weights = static_cast<shd_probe_weights>(source.below(2));
  desc.cubic = static_cast<shd_cubic>(source.below(3));
  desc.box = static_cast<shd_box>(source.below(2));
  desc.stochastic_filter = static_cast<shd_filter>(source.below(11));
  desc.profile = static_cast<shd_profile>(source.below(source.one_in(32) ? 9 : 4));
  desc.seed = source.word();
  desc.width_x = source.one_in(8) ? source.hostile() : 1.0f;
  desc.width_y = source.one_in(8) ? source.hostile() : 1.0f;
  desc.blur_u = source.one_in(8) ? source.hostile() : 0.0f;
  desc.blur_v = source.one_in(8) ? source.hostile() : 0.0f;
  desc.tolerance = source.one_in(8) ? source.hostile() : 0.125f;
  desc.wrap_u = static_cast<shd_wrap>(source.below(source.one_in(32) ? 200 : 5));
  desc.wrap_v = static_cast<shd_wrap>(source.below(source.one_in(32) ? 200 : 5));
  for (float& value : desc.border) value = source.one_in(16) ? source.hostile() : source.unit();
  desc.lod_bias = source.one_in(16) ? source.hostile() : source.unit() * 15.0f;
  desc.lod_min = source.one_in(16) ? source.hostile() : static_cast<float>(source.below(33));
  desc.lod_max = source.one_in(16) ? source.hostile() : static_cast<float>(source.below(33));
}

void fill_lookups(Source& source, Case& c) {
  c.count = source.below(100);
  for (int k = 0; k < 7; ++k) {
    if (k >= 2 && source.one_in(3)) continue;
    if (k == 6 && !source.one_in(3)) continue;
    c.column_stride[k] = 4 * (1 + source.below(3));
    c.columns[k].resize(c.count * c.column_stride[k] / 4 + 1);
    for (float& value : c.columns[k]) value = source.hostile();
  }
  for (std::vector<uint32_t>& column : c.integers) {
    if (!source.one_in(4)) continue;
    column.resize(c.count + 1);
    for (uint32_t& value : column) value = source.one_in(2) ? source.word() : source.below(4);
  }
  c.channels = 1 + source.below(15);  // a call without outputs is refused
  for (size_t& stride : c.out_stride) stride = 4 * (1 + source.below(3));
}

shd_lookups make_lookups(const Case& c) {
  shd_lookups lookups = shd_lookups_default();
  lookups.count = c.count;
  shd_f32_in* columns[7] = {&lookups.u,    &lookups.v,    &lookups.dudx, &lookups.dvdx,
                            &lookups.dudy, &lookups.dvdy, &lookups.lod};
  for (int k = 0; k < 7; ++k) {
    if (c.columns[k].empty()) continue;
    columns[k]->data = c.columns[k].data();
    columns[k]->stride = c.column_stride[k];
  }
  if (!c.integers[0].empty()) lookups.layer.data = c.integers[0].data();
  if (!c.integers[1].empty()) lookups.random.data = c.integers[1].data();
  return lookups;
}

/// Output columns, with canaries between and after the elements.
struct Output {
  std::vector<float> channel[4];
  size_t nonfinite_count = 0;
};

void check_output(const Case& c, const Output& output, int channel) {
  const size_t step = c.out_stride[channel] / 4;
  const std::vector<float>& values = output.channel[channel];
  for (size_t i = 0; i < values.size(); ++i) {
    const bool written = i % step == 0 && i / step < c.count;
    if (!written) SHD_FUZZ_CHECK(values[i] == kCanary);
    if (written && c.integer_texels) SHD_FUZZ_CHECK(std::isfinite(values[i]));
  }
}

/// Runs the case on one target. Returns false if the texture or sampler was refused.
bool run(const Case& c, shd_simd simd, Output& output) {
  Memory memory;
  shd_context* context = make_context(memory, simd);
  shd_texture* texture = nullptr;
  shd_sampler* sampler = nullptr;
  const bool made = shd_texture_create(context, &c.texture, &texture) == SHD_OK &&
                    shd_sampler_create(context, &c.sampler, &sampler) == SHD_OK;
  if (made) {
    const shd_lookups lookups = make_lookups(c);
    shd_texels out = {};
    for (int k = 0; k < 4; ++k) {
      if (!(c.channels >> k & 1)) continue;
      output.channel[k].assign(c.count * c.out_stride[k] / 4 + 1, kCanary);
      out.channel[k].data = output.channel[k].data();
      out.channel[k].stride = c.out_stride[k];
    }
    const shd_result result = shd_texture_sample(texture, sampler, &lookups, &out);
    const bool lacks_table =
        (c.sampler.filter == SHD_FILTER_RIPMAP && !(c.texture.tables & SHD_TABLE_RIPMAP)) ||
        (c.sampler.filter == SHD_FILTER_SUMMED_AREA && !(c.texture.tables & SHD_TABLE_SUMMED_AREA));
    SHD_FUZZ_CHECK(result == (lacks_table ? SHD_ERROR_INVALID_ARGUMENT : SHD_OK));
    if (lacks_table) output = {};
    SHD_FUZZ_CHECK(out.nonfinite_count <= c.count);
    output.nonfinite_count = out.nonfinite_count;
    for (int k = 0; k < 4; ++k) check_output(c, output, k);
  } else {
    SHD_FUZZ_CHECK(shd_last_error()[0] != '\0');
  }
  shd_sampler_release(sampler);
  shd_texture_release(texture);
  shd_context_release(context);
  SHD_FUZZ_CHECK(memory.live == 0);
  return made;
}

}  // namespace
}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  Source source(data, size);
  Case c;
  fill_texture(source, c);
  fill_sampler(source, c);
  fill_lookups(source, c);
  Output best, baseline;
  const bool made = run(c, SHD_SIMD_BEST, best);
  SHD_FUZZ_CHECK(run(c, SHD_SIMD_BASELINE, baseline) == made);
  SHD_FUZZ_CHECK(best.nonfinite_count == baseline.nonfinite_count);
  for (int k = 0; k < 4; ++k) SHD_FUZZ_CHECK(same_values(best.channel[k], baseline.channel[k]));
  return 0;
}
