// SPDX-License-Identifier: MIT
#include "abi/lookup.h"

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include <hwy/base.h>

#include "abi/call_in_place.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "core/enum_names.h"
#include "texture/lookup/magnify.h"
#include "texture/lookup/sample.h"

namespace shd::abi {

shd_result read_texture_and_sampler(const shd_texture* texture, const shd_sampler* sampler,
                                    const texture::Texture** texture_body, const texture::Sampler** sampler_body) {
  SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, texture_body));
  return read_handle("sampler", sampler, core::ObjectType::kSampler, sampler_body);
}

namespace {

/// Whether `count` lookups have the third coordinate that the texture needs. Other textures ignore it.
shd_result take_third(const texture::Texture& texture, size_t count, LookupColumns* columns) {
  if (texture::needs_w(texture)) {
    if (count == 0 || (*columns)[kColumnW].data) return SHD_OK;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "lookups.w.data: NULL, but the texture is %s",
                      texture.depth ? "3D" : "one of directions");
  }
  for (size_t c = kColumnW; c < texture::kPlaceColumns; ++c) (*columns)[c].data = nullptr;
  return SHD_OK;
}

}  // namespace

shd_result read_lookups(const shd_lookups* in, const texture::Texture& texture, LookupColumns* columns, size_t* count) {
  shd_lookups read = shd_lookups_default();
  SHD_TRY(read_desc("lookups", in, false, &read));
  InColumn* next = columns->data();
  for (const auto& row : kFloatRows) *next++ = in_column(row.name, read.*row.column, row.need);
  for (const auto& row : kIntegerRows) *next++ = in_column(row.name, read.*row.column, row.need);
  *count = read.count;
  SHD_TRY(take_third(texture, read.count, columns));
  return check_columns(columns->data(), columns->size(), read.count);
}

namespace {

/// Writes what a texture is: "is 3D", "has projection CUBE", "is in tiles".
struct TextureKind {
  char text[64];

  explicit TextureKind(const texture::Texture& texture) {
    if (texture.projection != SHD_PROJECTION_NONE) {
      std::snprintf(text, sizeof text, "has projection %s", core::value_name(texture.projection));
    } else {
      const bool flat = texture.depth == 0;
      std::snprintf(text, sizeof text, "is %s%s", flat ? "in " : "",
                    flat ? name_of(texture.store) : name_of(domain_of(texture)));
    }
  }
};

shd_result refuse(const char* field, const char* value, const texture::Texture& texture, texture::Use use,
                  const char* reason) {
  const TextureKind kind(texture);
  if (use == texture::Use::kValues)
    return core::fail(SHD_ERROR_UNSUPPORTED, "%s: %s, but the texture %s: %s", field, value, kind.text, reason);
  return core::fail(SHD_ERROR_UNSUPPORTED, "%s: %s has no %s (the texture %s): %s", field, value, name_of(use),
                    kind.text, reason);
}

/// Options of samplers that 3D textures do not have.
shd_result check_slice_options(const texture::Sampler& sampler) {
  if (sampler.profile != SHD_PROFILE_LEAST_ERROR && sampler.profile != SHD_PROFILE_EXACT) {
    return core::fail(SHD_ERROR_UNSUPPORTED,
                      "sampler.profile: %s, but the texture is 3D, which needs LEAST_ERROR or EXACT",
                      core::value_name(sampler.profile));
  }
  if (sampler.blur_u != 0.0f || sampler.blur_v != 0.0f) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "sampler.blur_%c: not 0, but the texture is 3D",
                      sampler.blur_u != 0.0f ? 'u' : 'v');
  }
  return SHD_OK;
}

/// check_use() of the cells of support.h.
shd_result check_cells(const texture::Texture& texture, const texture::Sampler& sampler, texture::Use use) {
  texture::SupportCell cell = {sampler.filter, domain_of(texture), texture.store, use};
  if (const char* const reason = refusal_of(cell))
    return refuse("sampler.filter", core::value_name(sampler.filter), texture, use, reason);
  const shd_filter near = texture::magnifier(sampler).filter;
  if (near == sampler.filter) return SHD_OK;
  cell.filter = near;
  if (const char* const reason = refusal_of(cell))
    return refuse("sampler.magnification", core::value_name(near), texture, use, reason);
  return SHD_OK;
}

}  // namespace

shd_result check_flat(const char* field, const texture::Texture& texture) {
  if (!texture::needs_w(texture)) return SHD_OK;
  return core::fail(SHD_ERROR_UNSUPPORTED, "%s: a texture %s, not a 2D one", field,
                    texture.depth != 0 ? "of 3D" : "of directions");
}

shd_result check_lookups(const texture::Texture& texture, const texture::Sampler& sampler, texture::Use use) {
  SHD_TRY(check_cells(texture, sampler, texture::Use::kValues));
  if (use != texture::Use::kValues) SHD_TRY(check_cells(texture, sampler, use));
  if (HWY_UNLIKELY(sampler.compares)) {
    SHD_TRY(check_cells(texture, sampler, texture::Use::kComparison));
    if (use == texture::Use::kGradients)
      return core::fail(SHD_ERROR_UNSUPPORTED, "sampler.compares: 1, but comparisons have no derivatives");
  }
  if (HWY_UNLIKELY(texture.depth != 0)) SHD_TRY(check_slice_options(sampler));
  if (sampler.filter == SHD_FILTER_RIPMAP && !(texture.tables & SHD_TABLE_RIPMAP)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "sampler.filter: RIPMAP, but the texture has no SHD_TABLE_RIPMAP");
  }
  if (sampler.filter == SHD_FILTER_SUMMED_AREA && !(texture.tables & SHD_TABLE_SUMMED_AREA)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "sampler.filter: SUMMED_AREA, but the texture has no SHD_TABLE_SUMMED_AREA");
  }
  return SHD_OK;
}

shd_result check_use(const texture::Texture& texture, const texture::Sampler& sampler) {
  if (sampler.compares) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "sampler.compares: 1, but only lookups have a reference");
  }
  return check_lookups(texture, sampler, texture::Use::kValues);
}

}  // namespace shd::abi

namespace {

using namespace shd;
using namespace shd::abi;

/// Whether check_lookups() accepts values without further checks: all filters have them in 2D and in memory.
bool is_common(const texture::Texture& texture, const texture::Sampler& sampler) {
  return !texture::needs_w(texture) && texture::is_in_memory(texture) && !sampler.compares &&
         sampler.filter != SHD_FILTER_RIPMAP && sampler.filter != SHD_FILTER_SUMMED_AREA;
}

constexpr size_t kCoarser = texture::kOutputColumns, kTexelOutputs = kCoarser + 1;
using LookupBatch = Batch<kLookupColumns, kTexelOutputs>;

void set_outputs(const shd_texels& texels, LookupBatch* batch) {
  for (size_t c = 0; c < 4; ++c) {
    const int index = static_cast<int>(c);
    batch->out[c] = out_column("texels.channel", texels.channel[c], Need::kOptional, index);
    batch->out[4 + c] = out_column("texels.du", texels.du[c], Need::kOptional, index);
    batch->out[8 + c] = out_column("texels.dv", texels.dv[c], Need::kOptional, index);
    batch->out[12 + c] = out_column("texels.dw", texels.dw[c], Need::kOptional, index);
  }
  batch->out[kCoarser] = out_column("texels.coarser", texels.coarser, Need::kOptional);
}

shd_result check_outputs(const LookupBatch& batch) {
  SHD_TRY(check_columns(batch.out.data(), kTexelOutputs, batch.count));
  bool wanted = batch.count == 0;
  for (const OutColumn& column : batch.out) wanted = wanted || column.data;
  if (!wanted) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texels.channel: NULL for all, and no derivative");
  return check_overlap(batch.in.data(), kLookupColumns, batch.out.data(), kTexelOutputs, batch.count);
}

/// Whether the texture and the sampler have the derivatives that a batch requests.
shd_result check_gradient(const LookupBatch& batch, const texture::Texture& texture, const texture::Sampler& sampler) {
  bool wanted = false, along_w = false;
  for (size_t c = 4; c < kCoarser; ++c) wanted = wanted || batch.out[c].data;
  for (size_t c = 12; c < kCoarser; ++c) along_w = along_w || batch.out[c].data;
  if (!wanted) return SHD_OK;
  if (along_w && !texture::needs_w(texture)) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texels.dw: set, but the texture is 2D");
  }
  return check_lookups(texture, sampler, texture::Use::kGradients);
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

/// Checks a call column by column, and serves it. Calls in place must not pay for its stack frame.
[[gnu::noinline]] shd_result sample_columns(const core::Context& context, const texture::Texture& texture,
                                            const texture::Sampler& sampler, const shd_lookups* lookups,
                                            shd_texels* out) {
  LookupBatch batch;
  SHD_TRY(read_lookups(lookups, texture, &batch.in, &batch.count));
  shd_texels texels = {};
  SHD_TRY(read_texels(out, &texels));
  set_outputs(texels, &batch);
  SHD_TRY(check_gradient(batch, texture, sampler));
  SHD_TRY(check_outputs(batch));
  std::atomic<size_t> nonfinite{0};
  run_batch(context, batch, [&](const Piece<kLookupColumns, kTexelOutputs>& piece) {
    texture::Texels to;
    for (size_t c = 0; c < kCoarser; ++c) to.column(c) = piece.out_floats(c);
    to.coarser = piece.out_integers(kCoarser);
    const size_t found = texture::sample(texture, sampler, context.simd, lookups_of(piece), to);
    if (found) nonfinite.fetch_add(found, std::memory_order_relaxed);
  });
  write_nonfinite(nonfinite.load(std::memory_order_relaxed), out);
  return SHD_OK;
}

}  // namespace

extern "C" shd_result shd_texture_sample(const shd_texture* texture, const shd_sampler* sampler,
                                         const shd_lookups* lookups, shd_texels* out) {
  return guard([&]() -> shd_result {
    const texture::Texture* texture_body;
    const texture::Sampler* sampler_body;
    SHD_TRY(read_texture_and_sampler(texture, sampler, &texture_body, &sampler_body));
    if (HWY_UNLIKELY(!is_common(*texture_body, *sampler_body)))
      SHD_TRY(check_lookups(*texture_body, *sampler_body, texture::Use::kValues));
    const core::Context& context = *object_of(texture)->context;
    CallInPlace call;
    if (!call.read(lookups, out, texture::needs_w(*texture_body), sampler_body->compares))
      return sample_columns(context, *texture_body, *sampler_body, lookups, out);
    write_nonfinite(texture::sample(*texture_body, *sampler_body, context.simd, call.in, call.out), out);
    return SHD_OK;
  });
}
