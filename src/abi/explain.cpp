// SPDX-License-Identifier: MIT
#include <shd/explain.h>

#include <cstddef>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup.h"
#include "texture/oracle/explain.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr uint64_t kMaxElement = 1u << 12;  // bytes of a tap or a blend of the caller

shd_result check_multiple(const char* field, uint32_t size, size_t alignment) {
  if (size % alignment == 0) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u is not a multiple of %zu", field, size, alignment);
}

shd_result check_explanation(const shd_explanation& explanation) {
  SHD_TRY(check_count("explanation.tap_size", explanation.tap_size, sizeof(shd_tap), kMaxElement));
  SHD_TRY(check_count("explanation.blend_size", explanation.blend_size, sizeof(shd_blend_step), kMaxElement));
  SHD_TRY(check_multiple("explanation.tap_size", explanation.tap_size, alignof(shd_tap)));
  SHD_TRY(check_multiple("explanation.blend_size", explanation.blend_size, alignof(shd_blend_step)));
  if (explanation.tap_capacity > 0) SHD_TRY(check_not_null("explanation.taps", explanation.taps));
  if (explanation.blend_capacity > 0) SHD_TRY(check_not_null("explanation.blends", explanation.blends));
  return SHD_OK;
}

}  // namespace

extern "C" shd_result shd_texture_explain(const shd_texture* texture, const shd_sampler* sampler,
                                          const shd_lookups* lookups, size_t index, shd_explanation* explanation) {
  return guard([&]() -> shd_result {
    const texture::Texture* texture_body;
    const texture::Sampler* sampler_body;
    SHD_TRY(read_texture_and_sampler(texture, sampler, &texture_body, &sampler_body));
    SHD_TRY(check_lookups(*texture_body, *sampler_body, texture::Use::kExplanation));
    Batch<kLookupColumns, 0> batch;
    SHD_TRY(read_lookups(lookups, *texture_body, &batch.in, &batch.count));
    if (index >= batch.count) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "index: %zu is not below lookups.count %zu", index, batch.count);
    }
    shd_explanation out = shd_explanation_default();
    SHD_TRY(read_desc("explanation", explanation, false, &out));
    SHD_TRY(check_explanation(out));
    const core::Context& context = *object_of(texture)->context;
    run_element(batch, index, [&](const auto& piece) {
      texture::explain(context, *texture_body, *sampler_body, lookups_of(piece), &out);
    });
    write_desc(out, explanation);
    return SHD_OK;
  });
}
