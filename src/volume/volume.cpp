// SPDX-License-Identifier: MIT
#include "volume/volume.h"

#include "data/column.h"
#include "volume/blocks.h"

namespace shd::volume {
namespace {

Transfer make_transfer(const shd_volume_desc& desc) {
  Transfer transfer = {};
  transfer.count = desc.point_count;
  for (uint32_t i = 0; i < desc.point_count; ++i) {
    TransferPoint& point = transfer.point[i];
    transfer.density[i] = point.density = data::load(desc.density, i);
    point.value[0] = data::load(desc.extinction, i);
    for (int c = 0; c < 3; ++c) point.value[1 + c] = desc.color[c].data ? data::load(desc.color[c], i) : 1.0f;
  }
  for (uint32_t i = 0; i + 1 < desc.point_count; ++i) {
    TransferPoint& point = transfer.point[i];
    const TransferPoint& next = transfer.point[i + 1];
    const double width = static_cast<double>(next.density) - static_cast<double>(point.density);
    point.inverse_width = width > 0.0 ? static_cast<float>(1.0 / width) : 0.0f;
    for (int c = 0; c < 4; ++c) point.slope[c] = next.value[c] - point.value[c];
  }
  return transfer;
}

}  // namespace

Volume::~Volume() {
  if (texture_object) core::release(texture_object, static_cast<uint32_t>(core::ObjectType::kTexture));
  if (material_object) core::release(material_object, static_cast<uint32_t>(core::ObjectType::kMaterial));
}

void build(const core::Context& context, const shd_volume_desc& desc, Volume* out) {
  shd_sampler_desc sampler = shd_sampler_desc_default();
  sampler.filter = SHD_FILTER_BILINEAR;
  sampler.wrap_u = sampler.wrap_v = sampler.wrap_w = SHD_WRAP_CLAMP;
  out->sampler = texture::make_sampler(sampler);
  out->transfer = make_transfer(desc);
  for (int c = 0; c < 3; ++c) {
    out->box_min[c] = static_cast<double>(desc.bounds_min[c]);
    out->box_max[c] = static_cast<double>(desc.bounds_max[c]);
  }
  out->step = desc.step;
  out->jitter = desc.jitter;
  out->seed = desc.seed;
  find_distances(context, out);
}

}  // namespace shd::volume
