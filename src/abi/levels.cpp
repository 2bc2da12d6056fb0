// SPDX-License-Identifier: MIT
#include <shd/lookup.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup.h"
#include "texture/domain/lod.h"
#include "texture/domain/profile.h"

namespace {

using namespace shd;
using namespace shd::abi;

using LevelBatch = Batch<kLookupColumns, 2>;
enum LevelOutput { kLod, kLevel };

/// Levels of detail of one piece of a batch.
void query_piece(const core::SimdTarget& simd, const texture::Texture& texture, const texture::Sampler& sampler,
                 const Piece<kLookupColumns, 2>& piece) {
  constexpr size_t kBlock = 256;
  const texture::LodRange range = texture::lod_range(texture, sampler);
  for (size_t first = 0; first < piece.count; first += kBlock) {
    const size_t count = piece.count - first < kBlock ? piece.count - first : kBlock;
    float lod[kBlock];
    texture::find_lods(texture, sampler, range, texture::LodAxis::kLonger, simd,
                       lookups_of(part_of(piece, first, count)), lod);
    for (size_t i = 0; i < count; ++i) {
      if (piece.out[kLod]) piece.out_floats(kLod)[first + i] = lod[i];
      if (piece.out[kLevel]) piece.out_integers(kLevel)[first + i] = texture::nearest_level(sampler, lod[i]);
    }
  }
}

}  // namespace

extern "C" shd_result shd_texture_query_levels(const shd_texture* texture, const shd_sampler* sampler,
                                               const shd_lookups* lookups, shd_levels* out) {
  return guard([&]() -> shd_result {
    const texture::Texture* texture_body;
    const texture::Sampler* sampler_body;
    SHD_TRY(read_texture_and_sampler(texture, sampler, &texture_body, &sampler_body));
    LevelBatch batch;
    SHD_TRY(read_lookups(lookups, *texture_body, &batch.in, &batch.count));
    shd_levels levels = shd_levels_default();
    SHD_TRY(read_desc("levels", out, false, &levels));
    batch.out[kLod] = out_column("levels.lod", levels.lod, Need::kOptional);
    batch.out[kLevel] = out_column("levels.level", levels.level, Need::kOptional);
    SHD_TRY(check_batch(batch));
    const core::Context& context = *object_of(texture)->context;
    levels.nonfinite_count = run_counting(context, batch, texture::kPlaceColumns, [&](const auto& piece) {
      query_piece(context.simd, *texture_body, *sampler_body, piece);
    });
    write_desc(levels, out);
    return SHD_OK;
  });
}
