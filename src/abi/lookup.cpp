// SPDX-License-Identifier: MIT
#include <shd/lookup.h>

#include <atomic>
#include <cstddef>
#include <cstring>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup_columns.h"
#include "texture/texture.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr size_t kOutputs = texture::kOutputColumns;
using LookupBatch = Batch<kLookupColumns, kOutputs>;

void set_outputs(const shd_texels& texels, LookupBatch* batch) {
  for (size_t c = 0; c < 4; ++c) {
    const int index = static_cast<int>(c);
    batch->out[c] = out_column("texels.channel", texels.channel[c], Need::kOptional, index);
    batch->out[4 + c] = out_column("texels.du", texels.du[c], Need::kOptional, index);
    batch->out[8 + c] = out_column("texels.dv", texels.dv[c], Need::kOptional, index);
  }
}

shd_result check_outputs(const LookupBatch& batch) {
  SHD_TRY(check_columns(batch.out.data(), kOutputs, batch.count));
  bool wanted = batch.count == 0;
  for (const OutColumn& column : batch.out) wanted = wanted || column.data;
  if (!wanted) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texels.channel: NULL for all, and no derivative");
  return check_overlap(batch.in.data(), kLookupColumns, batch.out.data(), kOutputs, batch.count);
}

/// Whether the sampler has the derivatives that a batch requests.
shd_result check_gradient(const LookupBatch& batch, const texture::Sampler& sampler) {
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

/// Reads the caller's texels. A struct_size of 0 is that of 0.1.
shd_result read_texels(const shd_texels* in, shd_texels* out) {
  SHD_TRY(check_not_null("texels", in));
  if (core::struct_size_of(in) != 0) return read_desc("texels", in, false, out);
  std::memcpy(static_cast<void*>(out), in, core::DescSize<shd_texels>::kFirst);
  return SHD_OK;
}

/// Stores the count in the caller's texels if they have the field.
void write_nonfinite(size_t count, shd_texels* out) {
  constexpr size_t kEnd = offsetof(shd_texels, nonfinite_count) + sizeof out->nonfinite_count;
  if (out->struct_size == 0 || out->struct_size >= kEnd) out->nonfinite_count = count;
}

/// Samples a batch on the executor; returns how many lookups were not finite.
size_t sample_batch(const core::Context& context, const texture::Texture& texture, const texture::Sampler& sampler,
                    const LookupBatch& batch) {
  std::atomic<size_t> nonfinite{0};
  run_batch(context, batch, [&](const Piece<kLookupColumns, kOutputs>& piece) {
    texture::Texels out;
    for (size_t c = 0; c < kOutputs; ++c) out.column(c) = piece.out_floats(c);
    const size_t found = texture::sample(texture, sampler, context.simd, lookups_of(piece), out);
    if (found) nonfinite.fetch_add(found, std::memory_order_relaxed);
  });
  return nonfinite.load(std::memory_order_relaxed);
}

}  // namespace

extern "C" shd_result shd_texture_sample(const shd_texture* texture, const shd_sampler* sampler,
                                         const shd_lookups* lookups, shd_texels* out) {
  return guard([&]() -> shd_result {
    const texture::Texture* texture_body;
    const texture::Sampler* sampler_body;
    SHD_TRY(read_texture_and_sampler(texture, sampler, &texture_body, &sampler_body));
    SHD_TRY(check_tables(*texture_body, *sampler_body));
    LookupBatch batch;
    SHD_TRY(read_lookups(lookups, &batch.in, &batch.count));
    shd_texels texels = {};
    SHD_TRY(read_texels(out, &texels));
    set_outputs(texels, &batch);
    SHD_TRY(check_gradient(batch, *sampler_body));
    SHD_TRY(check_outputs(batch));
    write_nonfinite(sample_batch(*object_of(texture)->context, *texture_body, *sampler_body, batch), out);
    return SHD_OK;
  });
}
