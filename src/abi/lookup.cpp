// SPDX-License-Identifier: MIT
#include <shd/lookup.h>

#include <atomic>
#include <cstring>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup_columns.h"
#include "core/executor.h"
#include "data/column.h"
#include "texture/texture.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr size_t kOutputs = texture::kOutputColumns;
constexpr size_t kChunk = 16384;  // lookups per task
constexpr uint64_t kMaxTasks = 1u << 20;
constexpr size_t kStage = 128;  // lookups per copy of strided columns: 11 KB of stack

/// The columns of one call.
struct Batch {
  LookupColumns in;
  shd_f32_out out[kOutputs];
};

constexpr const char* kOutputNames[kOutputs] = {
    "texels.channel[0]", "texels.channel[1]", "texels.channel[2]", "texels.channel[3]", "texels.du[0]", "texels.du[1]",
    "texels.du[2]",      "texels.du[3]",      "texels.dv[0]",      "texels.dv[1]",      "texels.dv[2]", "texels.dv[3]"};

/// Where a column lies: elements at first + i * stride, i < count.
struct Extent {
  uintptr_t first;
  size_t stride, count;

  Extent(const void* data, size_t column_stride, size_t column_count)
      : first(reinterpret_cast<uintptr_t>(data)), stride(column_stride ? column_stride : 4), count(column_count) {}
  uintptr_t last() const { return first + (count - 1) * stride; }
};

/// Whether `packed`, which has no gaps, holds an element of `other`.
bool holds_element(const Extent& packed, const Extent& other) {
  if (other.last() < packed.first || other.first > packed.last()) return false;
  if (other.first >= packed.first) return true;
  const size_t skipped = (packed.first - other.first + other.stride - 1) / other.stride;
  return other.first + skipped * other.stride <= packed.last();
}

/// Exact for equal strides and where one column is packed; others are not looked into.
bool overlap(const Extent& a, const Extent& b) {
  if (a.stride == 4) return holds_element(a, b);
  if (b.stride == 4) return holds_element(b, a);
  if (a.stride != b.stride || a.last() < b.first || b.last() < a.first) return false;
  return (a.first > b.first ? a.first - b.first : b.first - a.first) % a.stride == 0;
}

shd_result check_overlap(const Batch& batch) {
  const size_t count = batch.in.count;
  for (size_t c = 0; c < kOutputs; ++c) {
    if (!batch.out[c].data) continue;
    const Extent out(batch.out[c].data, batch.out[c].stride, count);
    for (size_t i = 0; i < kLookupFloats; ++i) {
      const shd_f32_in& in = batch.in.floats[i];
      if (in.data && overlap(out, Extent(in.data, in.stride, count))) {
        return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: overlaps %s", kOutputNames[c], kLookupFloatNames[i]);
      }
    }
    for (size_t i = 0; i < kLookupIntegers; ++i) {
      const shd_u32_in& in = batch.in.integers[i];
      if (in.data && overlap(out, Extent(in.data, in.stride, count))) {
        return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: overlaps %s", kOutputNames[c], kLookupIntegerNames[i]);
      }
    }
    for (size_t i = 0; i < c; ++i) {
      if (batch.out[i].data && overlap(out, Extent(batch.out[i].data, batch.out[i].stride, count))) {
        return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: overlaps %s", kOutputNames[c], kOutputNames[i]);
      }
    }
  }
  return SHD_OK;
}

shd_result check_out(const Batch& batch) {
  for (size_t c = 0; c < kOutputs; ++c) SHD_TRY(check_column(kOutputNames[c], batch.out[c], batch.in.count));
  if (batch.in.count == 0) return SHD_OK;
  bool wanted = false;
  for (const shd_f32_out& channel : batch.out) wanted = wanted || channel.data;
  if (!wanted) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texels.channel: NULL for all, and no derivative");
  return check_overlap(batch);
}

/// Whether the sampler has the derivatives that a batch asks for.
shd_result check_gradient(const Batch& batch, const texture::Sampler& sampler) {
  bool wanted = false;
  for (size_t c = 4; c < kOutputs; ++c) wanted = wanted || batch.out[c].data;
  if (!wanted) return SHD_OK;
  if (!texture::has_gradient(sampler.filter)) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texels.du: filter %d of the sampler has no derivatives",
                      static_cast<int>(sampler.filter));
  }
  if (sampler.magnification == SHD_MAGNIFICATION_NEAREST) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texels.du: NEAREST magnification has no derivatives");
  }
  return SHD_OK;
}

/// A 0.1 shd_texels may leave its struct_size 0.
shd_result read_texels(const shd_texels* in, shd_texels* out) {
  SHD_TRY(check_not_null("texels", in));
  uint32_t size;
  std::memcpy(&size, in, sizeof size);
  if (size == 0) {
    std::memcpy(out, in, sizeof *out);
  } else {
    SHD_TRY(read_desc("texels", in, false, out));
  }
  return check_zero("texels.reserved", out->reserved);
}

/// Samples elements first..first + count - 1 of a batch on this thread, strided columns through copies.
class Chunk {
 public:
  Chunk(const texture::Texture& texture, const texture::Sampler& sampler, const core::SimdTarget& simd,
        const Batch& batch)
      : texture_(texture), sampler_(sampler), simd_(simd), batch_(batch) {}

  size_t run(size_t first, size_t count) const {
    bool packed = true;
    for (const shd_f32_in& column : batch_.in.floats)
      packed = packed && (!column.data || data::is_packed(column.stride));
    for (const shd_u32_in& column : batch_.in.integers)
      packed = packed && (!column.data || data::is_packed(column.stride));
    for (const shd_f32_out& column : batch_.out) packed = packed && (!column.data || data::is_packed(column.stride));
    if (packed) return run_packed(first, count);
    size_t nonfinite = 0;
    for (size_t done = 0; done < count; done += kStage) {
      nonfinite += run_staged(first + done, count - done < kStage ? count - done : kStage);
    }
    return nonfinite;
  }

 private:
  size_t run_packed(size_t first, size_t count) const {
    const float* in[kLookupFloats];
    const uint32_t* integers[kLookupIntegers];
    texture::Texels out;
    for (size_t i = 0; i < kLookupFloats; ++i)
      in[i] = batch_.in.floats[i].data ? batch_.in.floats[i].data + first : nullptr;
    for (size_t i = 0; i < kLookupIntegers; ++i) {
      integers[i] = batch_.in.integers[i].data ? batch_.in.integers[i].data + first : nullptr;
    }
    for (size_t c = 0; c < kOutputs; ++c) out.column(c) = batch_.out[c].data ? batch_.out[c].data + first : nullptr;
    const texture::Lookups lookups = {count, in[0], in[1], in[2], in[3], in[4], in[5], in[6], integers[0], integers[1]};
    return texture::sample(texture_, sampler_, simd_, lookups, out);
  }

  size_t run_staged(size_t first, size_t count) const {
    LookupStage<kStage> stage;
    float out_copy[kOutputs][kStage];
    texture::Texels out = {};
    for (size_t c = 0; c < kOutputs; ++c) out.column(c) = batch_.out[c].data ? out_copy[c] : nullptr;
    const size_t nonfinite = texture::sample(texture_, sampler_, simd_, stage.load(batch_.in, first, count), out);
    for (size_t c = 0; c < kOutputs; ++c) {
      if (!batch_.out[c].data) continue;
      for (size_t k = 0; k < count; ++k) data::store(batch_.out[c], first + k, out_copy[c][k]);
    }
    return nonfinite;
  }

  const texture::Texture& texture_;
  const texture::Sampler& sampler_;
  const core::SimdTarget& simd_;
  const Batch& batch_;
};

/// Splits the batch over the executor; the bits do not depend on where.
size_t run_batch(const core::Context& context, const Chunk& chunk, size_t count) {
  const size_t size = count / kMaxTasks < kChunk ? kChunk : count / kMaxTasks + 1;
  const auto tasks = static_cast<uint32_t>(count / size + (count % size != 0));
  std::atomic<size_t> nonfinite{0};
  core::parallel_for(context, tasks, [&](uint32_t task, uint32_t) {
    const size_t first = task * size;
    nonfinite.fetch_add(chunk.run(first, count - first < size ? count - first : size), std::memory_order_relaxed);
  });
  return nonfinite.load(std::memory_order_relaxed);
}

}  // namespace

extern "C" shd_result shd_texture_sample(const shd_texture* texture, const shd_sampler* sampler,
                                         const shd_lookups* lookups, shd_texels* out) {
  return guard([&]() -> shd_result {
    const texture::Texture* texture_body;
    const texture::Sampler* sampler_body;
    SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, &texture_body));
    SHD_TRY(read_handle("sampler", sampler, core::ObjectType::kSampler, &sampler_body));
    SHD_TRY(check_tables(*texture_body, *sampler_body));
    Batch batch;
    SHD_TRY(read_lookups(lookups, &batch.in));
    shd_texels texels;
    SHD_TRY(read_texels(out, &texels));
    for (size_t c = 0; c < 4; ++c) {
      batch.out[c] = texels.channel[c];
      batch.out[4 + c] = texels.du[c];
      batch.out[8 + c] = texels.dv[c];
    }
    SHD_TRY(check_gradient(batch, *sampler_body));
    SHD_TRY(check_out(batch));

    const core::Context& context = *object_of(texture)->context;
    const Chunk chunk(*texture_body, *sampler_body, context.simd, batch);
    out->nonfinite_count = run_batch(context, chunk, batch.in.count);
    return SHD_OK;
  });
}
