// SPDX-License-Identifier: MIT
#include <shd/environment.h>

#include <algorithm>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "environment/environment.h"
#include "environment/look_up.h"
#include "projection/projection.h"

namespace {

using namespace shd;
using namespace shd::abi;
using environment::Environment;

constexpr core::ObjectType kEnvironmentType = core::ObjectType::kEnvironment;
constexpr uint64_t kMaxEnvironmentPixels = uint64_t{1} << 26;

/// Columns of shd_environment_lookups.
enum EnvironmentColumn { kRoughness = 3, kExponent = 4, kEnvironmentColumns = 5 };
using EnvironmentBatch = Batch<kEnvironmentColumns, 3>;
using EnvironmentPiece = Piece<kEnvironmentColumns, 3>;

/// Reads the image, and checks its size for the projection.
shd_result read_source_image(const shd_environment_desc& desc, shd_image* out) {
  SHD_TRY(read_image("environment.image", desc.image, out));
  SHD_TRY(check_count("environment.image.width * environment.image.height", uint64_t{out->width} * out->height, 1,
                      kMaxEnvironmentPixels));
  if (desc.projection == SHD_PROJECTION_LAT_LONG) return SHD_OK;
  const uint64_t height = uint64_t{out->width} * projection::face_count(desc.projection);
  if (out->height == height) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "environment.image.height: %u is not %llu, which projection %u takes",
                    out->height, static_cast<unsigned long long>(height), enum_bits(desc.projection));
}

shd_result check_environment_desc(const shd_environment_desc& desc) {
  SHD_TRY(check_enum("environment.projection", desc.projection, SHD_PROJECTION_LAT_LONG, projection::kLastProjection));
  SHD_TRY(check_enum("environment.irradiance", desc.irradiance, 0, SHD_IRRADIANCE_CONVOLVED));
  return check_flags("environment.tables", desc.tables, SHD_ENVIRONMENT_TABLE_ALL);
}

shd_result require_table(bool exists, const char* table) {
  if (exists) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "environment: made without %s", table);
}

/// Reads the columns of a call.
shd_result read_lookups(const shd_environment_lookups* lookups, const shd_environment_values* out,
                        EnvironmentBatch* batch, shd_environment_values* values) {
  shd_environment_lookups in = shd_environment_lookups_default();
  SHD_TRY(read_desc("lookups", lookups, false, &in));
  *values = shd_environment_values_default();
  SHD_TRY(read_desc("values", out, false, values));
  batch->count = in.count;
  for (int c = 0; c < 3; ++c) {
    const auto k = static_cast<size_t>(c);
    batch->in[k] = in_column("lookups.direction", in.direction[c], Need::kRequired, c);
    batch->out[k] = out_column("values.channel", values->channel[c], Need::kOptional, c);
  }
  batch->in[kRoughness] = in_column("lookups.roughness", in.roughness, Need::kOptional);
  batch->in[kExponent] = in_column("lookups.exponent", in.exponent, Need::kOptional);
  return check_batch(*batch);
}

/// The kernel of a kind of lookup, and the column of its width.
using LookUp = void (*)(const core::SimdTarget&, const Environment&, const environment::LookUps&, float* const[3]);

/// Returns the number of lookups that are not finite.
size_t run(const shd_environment* handle, const Environment& body, const EnvironmentBatch& batch, LookUp look_up,
           size_t width) {
  const core::Context& context = *object_of(handle)->context;
  return run_counting(context, batch, batch.in.size(), [&](const EnvironmentPiece& piece) {
    float* const out[3] = {piece.out_floats(0), piece.out_floats(1), piece.out_floats(2)};
    look_up(context.simd, body, {piece.count, {piece.floats(0), piece.floats(1), piece.floats(2)}, piece.floats(width)},
            out);
  });
}

}  // namespace

extern "C" {

shd_result shd_environment_create(shd_context* context, const shd_environment_desc* desc,
                                  shd_environment** out_environment) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_environment", out_environment));
    *out_environment = nullptr;
    SHD_TRY(check_context(context));
    shd_environment_desc read = shd_environment_desc_default();
    SHD_TRY(read_desc("environment", desc, false, &read));
    SHD_TRY(check_environment_desc(read));
    shd_image image;
    SHD_TRY(read_source_image(read, &image));
    read.image = &image;
    core::Context& owner = context_of(context);
    const auto build = [&](Environment* body) {
      environment::build(owner, read, body);
      return SHD_OK;
    };
    return create_handle<Environment>(owner, kEnvironmentType, build, out_environment);
  });
}

void shd_environment_retain(shd_environment* environment) {
  retain_handle(environment, kEnvironmentType);
}

void shd_environment_release(shd_environment* environment) {
  release_handle(environment, kEnvironmentType);
}

shd_result shd_environment_get_info(const shd_environment* environment, shd_environment_info* out_info) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_info", out_info));
    const Environment* body;
    SHD_TRY(read_handle("environment", environment, kEnvironmentType, &body));
    shd_environment_info info = shd_environment_info_default();
    info.projection = body->projection;
    info.irradiance = body->irradiance.size ? SHD_IRRADIANCE_CONVOLVED : SHD_IRRADIANCE_HARMONICS;
    if (body->radiance.count) info.tables |= SHD_ENVIRONMENT_TABLE_RADIANCE;
    if (body->ggx.count) info.tables |= SHD_ENVIRONMENT_TABLE_GGX;
    if (body->phong.count) info.tables |= SHD_ENVIRONMENT_TABLE_PHONG;
    info.map_size = body->radiance.count ? body->radiance.level[body->radiance.count - 1].size : 0;
    info.replaced_count = body->replaced;
    std::copy_n(body->mean, 3, info.mean);
    info.byte_size = sizeof *body + body->texels.size() * sizeof(environment::PackedTexel);
    write_desc(info, out_info);
    return SHD_OK;
  });
}

shd_result shd_environment_sample_irradiance(const shd_environment* environment, const shd_environment_lookups* lookups,
                                             shd_environment_values* out) {
  return guard([&]() -> shd_result {
    const Environment* body;
    SHD_TRY(read_handle("environment", environment, kEnvironmentType, &body));
    EnvironmentBatch batch;
    shd_environment_values values;
    SHD_TRY(read_lookups(lookups, out, &batch, &values));
    for (const size_t column : {size_t{kRoughness}, size_t{kExponent}}) {
      if (!batch.in[column].data) continue;
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: set, but irradiance has no lobe", batch.in[column].name);
    }
    values.nonfinite_count = run(environment, *body, batch, environment::look_up_irradiance, kRoughness);
    write_desc(values, out);
    return SHD_OK;
  });
}

shd_result shd_environment_sample_radiance(const shd_environment* environment, const shd_environment_lookups* lookups,
                                           shd_environment_values* out) {
  return guard([&]() -> shd_result {
    const Environment* body;
    SHD_TRY(read_handle("environment", environment, kEnvironmentType, &body));
    EnvironmentBatch batch;
    shd_environment_values values;
    SHD_TRY(read_lookups(lookups, out, &batch, &values));
    if (batch.in[kRoughness].data && batch.in[kExponent].data) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "lookups.exponent: set, but so is lookups.roughness");
    }
    if (batch.in[kRoughness].data) {
      SHD_TRY(require_table(body->ggx.count != 0, "SHD_ENVIRONMENT_TABLE_GGX"));
      values.nonfinite_count = run(environment, *body, batch, environment::look_up_ggx, kRoughness);
    } else if (batch.in[kExponent].data) {
      SHD_TRY(require_table(body->phong.count != 0, "SHD_ENVIRONMENT_TABLE_PHONG"));
      values.nonfinite_count = run(environment, *body, batch, environment::look_up_phong, kExponent);
    } else {
      SHD_TRY(require_table(body->radiance.count != 0, "SHD_ENVIRONMENT_TABLE_RADIANCE"));
      values.nonfinite_count = run(environment, *body, batch, environment::look_up_radiance, kRoughness);
    }
    write_desc(values, out);
    return SHD_OK;
  });
}

}  // extern "C"
