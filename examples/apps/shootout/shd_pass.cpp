// SPDX-License-Identifier: MIT
#include "shd_pass.h"

#include <chrono>

namespace shootout {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

shd_lookups columns_of(const Lookups& q) {
  shd::lookups columns;
  columns.count = q.count();
  columns.u = shd::in(q.u);
  columns.v = shd::in(q.v);
  columns.dudx = shd::in(q.dudx);
  columns.dvdx = shd::in(q.dvdx);
  columns.dudy = shd::in(q.dudy);
  columns.dvdy = shd::in(q.dvdy);
  return columns;
}

ShdPass::ShdPass(const Texture& texture, const Setting& setting) {
  shd::context_desc context;
  context.worker_count = 1;
  context_ = shd::context_create(&context);
  sampler_ = shd::sampler_create(context_, &setting.sampler);
  shd::texture_desc desc;
  desc.format = SHD_FORMAT_RGBA8;
  desc.width = desc.height = texture.edge;
  desc.texels = texture.rgba.data();
  desc.tables = setting.tables;
  const double start = now();
  texture_ = shd::texture_create(context_, &desc);
  build_seconds_ = now() - start;
  shd::texture_info info;
  shd::check(shd_texture_get_info(texture_, &info));
  table_bytes_ = info.byte_size;
}

void ShdPass::run(const Lookups& q, std::vector<float>* rgba) const {
  const shd_lookups columns = columns_of(q);
  shd::texels out;
  for (size_t c = 0; c < 4; ++c) out.channel[c] = shd_f32_out_column(rgba->data() + c, 4 * sizeof(float));
  shd::check(shd_texture_sample(texture_, sampler_, &columns, &out));
}

std::vector<float> ShdPass::filter(const Lookups& q) const {
  std::vector<float> rgba(4 * q.count());
  run(q, &rgba);
  return rgba;
}

std::vector<float> ShdPass::levels(const Lookups& q) const {
  const shd_lookups columns = columns_of(q);
  std::vector<float> lod(q.count());
  shd::levels out;
  out.lod = shd::out(lod);
  shd::check(shd_texture_query_levels(texture_, sampler_, &columns, &out));
  return lod;
}

bool ShdPass::explain(const Lookups& q, size_t index, std::vector<shd_tap>* taps, shd_explanation* explanation) const {
  const shd_lookups columns = columns_of(q);
  *explanation = shd_explanation_default();
  const shd_result result = shd_texture_explain(texture_, sampler_, &columns, index, explanation);
  if (result == SHD_ERROR_UNSUPPORTED) return false;
  shd::check(result);
  taps->resize(explanation->tap_count);
  explanation->taps = taps->data();
  explanation->tap_capacity = explanation->tap_count;
  shd::check(shd_texture_explain(texture_, sampler_, &columns, index, explanation));
  return true;
}

}  // namespace shootout
