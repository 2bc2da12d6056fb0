// SPDX-License-Identifier: MIT
#include "abi/lookup.h"

#include <atomic>
#include <cstddef>
#include <cstring>
#include <iterator>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "texture/sample.h"

namespace shd::abi {

namespace {

/// The columns of a caller's lookups, in the order of texture::Lookups::real() and integer().
template <class Column>
struct Row {
  const char* name;
  Need need;
  Column shd_lookups::*column;
};

constexpr Row<shd_f32_in> kFloatRows[] = {
    {"lookups.u", Need::kRequired, &shd_lookups::u},       {"lookups.v", Need::kRequired, &shd_lookups::v},
    {"lookups.dudx", Need::kOptional, &shd_lookups::dudx}, {"lookups.dvdx", Need::kOptional, &shd_lookups::dvdx},
    {"lookups.dudy", Need::kOptional, &shd_lookups::dudy}, {"lookups.dvdy", Need::kOptional, &shd_lookups::dvdy},
    {"lookups.lod", Need::kOptional, &shd_lookups::lod},
};
constexpr Row<shd_u32_in> kIntegerRows[] = {
    {"lookups.layer", Need::kOptional, &shd_lookups::layer},
    {"lookups.random", Need::kOptional, &shd_lookups::random},
};
static_assert(std::size(kFloatRows) == texture::kFloatColumns && std::size(kIntegerRows) == texture::kIntegerColumns);

}  // namespace

shd_result read_texture_and_sampler(const shd_texture* texture, const shd_sampler* sampler,
                                    const texture::Texture** texture_body, const texture::Sampler** sampler_body) {
  SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, texture_body));
  return read_handle("sampler", sampler, core::ObjectType::kSampler, sampler_body);
}

shd_result read_lookups(const shd_lookups* in, LookupColumns* columns, size_t* count) {
  shd_lookups read = shd_lookups_default();
  SHD_TRY(read_desc("lookups", in, false, &read));
  InColumn* next = columns->data();
  for (const auto& row : kFloatRows) *next++ = in_column(row.name, read.*row.column, row.need);
  for (const auto& row : kIntegerRows) *next++ = in_column(row.name, read.*row.column, row.need);
  *count = read.count;
  return check_columns(columns->data(), columns->size(), read.count);
}

shd_result check_tables(const texture::Texture& texture, const texture::Sampler& sampler) {
  if (sampler.filter == SHD_FILTER_RIPMAP && !(texture.tables & SHD_TABLE_RIPMAP)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "sampler.filter: RIPMAP, but the texture has no SHD_TABLE_RIPMAP");
  }
  if (sampler.filter == SHD_FILTER_SUMMED_AREA && !(texture.tables & SHD_TABLE_SUMMED_AREA)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "sampler.filter: SUMMED_AREA, but the texture has no SHD_TABLE_SUMMED_AREA");
  }
  return SHD_OK;
}

}  // namespace shd::abi

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

/// The first bytes of columns that a call has.
template <size_t kMax>
struct Places {
  size_t count = 0;
  uintptr_t first[kMax];
};

/// A call that kernels can serve in place: every column is sound, packed (or has one element) and apart from the
/// others, and no derivatives are wanted. Most calls are in place, and reading them takes a few nanoseconds. Other
/// calls, and all wrong ones, are checked column by column with a message for each error.
class CallInPlace {
 public:
  texture::Lookups in;
  texture::Texels out;

  /// Returns false if the call is wrong or needs copies.
  bool read(const shd_lookups* lookups, const shd_texels* texels) {
    if (!has_size(lookups, sizeof *lookups)) return false;
    if (!has_size(texels, sizeof *texels) && !has_size(texels, 0)) return false;
    count_ = in.count = lookups->count;
    if (count_ == 0 || count_ > batch_detail::kTaskElements) return false;
    for (size_t c = 0; c < std::size(kFloatRows); ++c) in.real(c) = use(lookups->*kFloatRows[c].column, &read_);
    for (size_t c = 0; c < std::size(kIntegerRows); ++c) in.integer(c) = use(lookups->*kIntegerRows[c].column, &read_);
    for (size_t c = 0; c < 4; ++c) {
      out.channel[c] = use(texels->channel[c], &written_);
      out.du[c] = out.dv[c] = nullptr;
      sound_ = sound_ && !texels->du[c].data && !texels->dv[c].data;
    }
    return sound_ && in.u && in.v && written_.count > 0 && are_apart();
  }

 private:
  size_t count_;
  bool sound_ = true;
  Places<kLookupColumns> read_;
  Places<4> written_;

  template <class Desc>
  static bool has_size(const Desc* desc, size_t size) {
    return desc && reinterpret_cast<uintptr_t>(desc) % alignof(Desc) == 0 && desc->struct_size == size;
  }

  /// Returns the elements of a column.
  template <class Column, size_t kMax>
  decltype(Column::data) use(const Column& column, Places<kMax>* places) {
    if (!column.data) return nullptr;
    const auto address = reinterpret_cast<uintptr_t>(column.data);
    const bool adjacent = data::is_packed(column.stride) || (count_ == 1 && column.stride <= PTRDIFF_MAX);
    sound_ = sound_ && adjacent && (address | column.stride) % batch_detail::kElementSize == 0;
    places->first[places->count++] = address;
    return column.data;
  }

  bool are_apart() const {
    const size_t size = count_ * batch_detail::kElementSize;
    bool apart = true;
    const auto compare = [&](uintptr_t a, uintptr_t b) { apart = apart && a - b + size - 1 >= 2 * size - 1; };
    for (size_t w = 0; w < written_.count; ++w) {
      for (size_t r = 0; r < read_.count; ++r) compare(written_.first[w], read_.first[r]);
      for (size_t other = 0; other < w; ++other) compare(written_.first[w], written_.first[other]);
    }
    return apart;
  }
};

/// Checks a call column by column, and serves it.
shd_result sample_columns(const core::Context& context, const texture::Texture& texture,
                          const texture::Sampler& sampler, const shd_lookups* lookups, shd_texels* out) {
  LookupBatch batch;
  SHD_TRY(read_lookups(lookups, &batch.in, &batch.count));
  shd_texels texels = {};
  SHD_TRY(read_texels(out, &texels));
  set_outputs(texels, &batch);
  SHD_TRY(check_gradient(batch, sampler));
  SHD_TRY(check_outputs(batch));
  std::atomic<size_t> nonfinite{0};
  run_batch(&context, batch, [&](const Piece<kLookupColumns, kOutputs>& piece) {
    texture::Texels to;
    for (size_t c = 0; c < kOutputs; ++c) to.column(c) = piece.out_floats(c);
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
    SHD_TRY(check_tables(*texture_body, *sampler_body));
    const core::Context& context = *object_of(texture)->context;
    CallInPlace call;
    if (!call.read(lookups, out)) return sample_columns(context, *texture_body, *sampler_body, lookups, out);
    write_nonfinite(texture::sample(*texture_body, *sampler_body, context.simd, call.in, call.out), out);
    return SHD_OK;
  });
}
