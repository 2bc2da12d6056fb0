// SPDX-License-Identifier: MIT
#include <shd/lookup.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup_columns.h"
#include "core/executor.h"
#include "data/column.h"
#include "texture/footprint/lod.h"
#include "texture/footprint/profile.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr size_t kStage = 512;  // lookups per task

}  // namespace

extern "C" shd_result shd_texture_query_levels(const shd_texture* texture, const shd_sampler* sampler,
                                               const shd_lookups* lookups, const shd_levels* out) {
  return guard([&]() -> shd_result {
    const texture::Texture* texture_body;
    const texture::Sampler* sampler_body;
    SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, &texture_body));
    SHD_TRY(read_handle("sampler", sampler, core::ObjectType::kSampler, &sampler_body));
    LookupColumns columns;
    SHD_TRY(read_lookups(lookups, &columns));
    SHD_TRY(check_not_null("levels", out));
    SHD_TRY(check_column("levels.lod", out->lod, columns.count));
    SHD_TRY(check_column("levels.level", out->level, columns.count));
    SHD_TRY(check_count("lookups.count", columns.count, 0, uint64_t{kStage} * UINT32_MAX));

    const core::Context& context = *object_of(texture)->context;
    const auto tasks = static_cast<uint32_t>((columns.count + kStage - 1) / kStage);
    const texture::LodRange range = texture::lod_range(*texture_body, *sampler_body);
    core::parallel_for(context, tasks, [&](uint32_t task, uint32_t) {
      LookupStage<kStage> stage;
      float lod[kStage];
      const size_t first = task * kStage;
      const size_t count = columns.count - first < kStage ? columns.count - first : kStage;
      texture::find_lods(*texture_body, *sampler_body, range, texture::LodAxis::kLonger, context.simd,
                         stage.load(columns, first, count), lod);
      for (size_t i = 0; i < count; ++i) {
        if (out->lod.data) data::store(out->lod, first + i, lod[i]);
        if (out->level.data) {
          data::store(out->level, first + i, texture::nearest_level(*sampler_body, lod[i]));
        }
      }
    });
    return SHD_OK;
  });
}
