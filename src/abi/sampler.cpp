// SPDX-License-Identifier: MIT
#include <shd/sampler.h>

#include <cstring>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "texture/texture.h"

namespace {

using namespace shd;
using namespace shd::abi;

shd_result check_sampler_desc(const shd_sampler_desc& desc) {
  SHD_TRY(check_enum("sampler.filter", desc.filter, SHD_FILTER_TRILINEAR, SHD_FILTER_BILINEAR));
  SHD_TRY(check_enum("sampler.wrap_u", desc.wrap_u, SHD_WRAP_REPEAT, SHD_WRAP_BORDER));
  SHD_TRY(check_enum("sampler.wrap_v", desc.wrap_v, SHD_WRAP_REPEAT, SHD_WRAP_BORDER));
  SHD_TRY(check_finite("sampler.border", desc.border, 4));
  SHD_TRY(check_range("sampler.lod_bias", static_cast<double>(desc.lod_bias), -15, 15));
  SHD_TRY(check_range("sampler.lod_min", static_cast<double>(desc.lod_min), 0, 32));
  SHD_TRY(check_range("sampler.lod_max", static_cast<double>(desc.lod_max), 0, 32));
  return check_zero("sampler.reserved", desc.reserved);
}

}  // namespace

extern "C" {

shd_result shd_sampler_create(shd_context* context, const shd_sampler_desc* desc, shd_sampler** out_sampler) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_sampler", out_sampler));
    *out_sampler = nullptr;
    SHD_TRY(check_context(context));
    shd_sampler_desc read = shd_sampler_desc_default();
    SHD_TRY(read_desc("sampler", desc, true, &read));
    SHD_TRY(check_sampler_desc(read));

    core::Context& owner = context_of(context);
    auto* body = core::create<texture::Sampler>(owner.allocator);
    body->filter = read.filter;
    body->wrap_u = read.wrap_u;
    body->wrap_v = read.wrap_v;
    std::memcpy(body->border, read.border, sizeof body->border);
    body->lod_bias = read.lod_bias;
    body->lod_min = read.lod_min;
    body->lod_max = read.lod_max < read.lod_min ? read.lod_min : read.lod_max;
    make_handle(owner, core::ObjectType::kSampler, body, out_sampler);
    return SHD_OK;
  });
}

void shd_sampler_retain(shd_sampler* sampler) {
  retain_handle(sampler, core::ObjectType::kSampler);
}

void shd_sampler_release(shd_sampler* sampler) {
  release_handle(sampler, core::ObjectType::kSampler);
}

}  // extern "C"
