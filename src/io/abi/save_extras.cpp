// SPDX-License-Identifier: MIT
#include "io/abi/save_extras.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/printable.h"
#include "data/inverse.h"
#include "data/matrix.h"
#include "extension/error.h"
#include "io/file/printable.h"

namespace shd::io {

namespace {

using extension::refuse;

constexpr size_t kMostExtras = 1024, kLongestName = 255;

/// Attributes that the writer sets itself (OpenEXR, "File Layout", "Header Attributes"; OpenImageIO's own names).
constexpr const char* kReserved[] = {"channels",
                                     "compression",
                                     "dataWindow",
                                     "displayWindow",
                                     "lineOrder",
                                     "pixelAspectRatio",
                                     "screenWindowCenter",
                                     "screenWindowWidth",
                                     "tiles",
                                     "type",
                                     "name",
                                     "view",
                                     "version",
                                     "chunkCount",
                                     "chromaticities",
                                     "worldToCamera",
                                     "worldToNDC"};

/// Refuses a name that is empty, too long or not printable. `field` is such as "attributes[3].name".
void check_name(const std::string& field, const char* name) {
  if (!name) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.%s: NULL", field.c_str());
  const size_t size = ::strnlen(name, kLongestName + 1);
  size_t at = 0;
  while (at < size && core::printable_length(name + at, size - at) > 0)
    at += core::printable_length(name + at, size - at);
  if (size == 0 || size > kLongestName || at < size) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.%s: \"%s\" is not 1..%zu printable bytes", field.c_str(),
           printable(std::string(name, size)).c_str(), kLongestName);
  }
}

template <class Item>
void check_list(const char* field, const Item* items, size_t count) {
  if (count > kMostExtras) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.%s_count: %zu is not in 0..%zu", field, count, kMostExtras);
  }
  if (count > 0 && !items) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.%ss: NULL, but the count is %zu", field, count);
}

std::string item(const char* list, size_t i, const char* member) {
  return std::string(list) + "[" + std::to_string(i) + "]." + member;
}

void check_matrix(const char* name, const float matrix[16]) {
  for (int i = 0; i < 16; ++i) {
    if (std::isfinite(matrix[i])) continue;
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.view.%s[%d]: %g is not finite", name, i, static_cast<double>(matrix[i]));
  }
}

}  // namespace

void add_attributes(const shd_save_desc& desc, bool is_exr, EncodeJob* job) {
  check_list("attribute", desc.attributes, desc.attribute_count);
  for (size_t i = 0; i < desc.attribute_count; ++i) {
    const shd_file_attribute& from = desc.attributes[i];
    check_name(item("attributes", i, "name"), from.name);
    for (const char* const reserved : kReserved) {
      if (std::strcmp(from.name, reserved) != 0) continue;
      refuse(SHD_ERROR_INVALID_ARGUMENT, "save.attributes[%zu].name: \"%s\" is set by the writer", i, reserved);
    }
    if (!from.text) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.attributes[%zu].text: NULL", i);
    if (is_exr) job->attributes.push_back({from.name, from.text, {}});
  }
}

void add_matrices(const shd_view& view, EncodeJob* job) {
  // OpenEXR's matrices are rows of M in p' = p M, so they have the order of columns of shd's M in p' = M p.
  check_matrix("world_to_view", view.world_to_view);
  check_matrix("view_to_clip", view.view_to_clip);
  std::vector<float> camera(view.world_to_view, view.world_to_view + 16), ndc(16);
  for (size_t c = 0; c < 4; ++c) camera[4 * c + 2] = -camera[4 * c + 2];
  double world_to_clip[16];
  data::multiply(view.view_to_clip, view.world_to_view, world_to_clip);
  for (size_t c = 0; c < 4; ++c) {
    const double* const clip = world_to_clip + 4 * c;
    ndc[4 * c] = static_cast<float>(0.5 * (clip[3] + clip[0]));
    ndc[4 * c + 1] = static_cast<float>(0.5 * (clip[3] - clip[1]));
    ndc[4 * c + 2] = static_cast<float>(clip[2]);
    ndc[4 * c + 3] = static_cast<float>(clip[3]);
  }
  job->attributes.push_back({"worldtocamera", "", camera});  // OpenImageIO's names
  job->attributes.push_back({"worldToNDC", "", ndc});
}

void add_channels(const shd_save_desc& desc, bool is_exr, PlaneRows* rows, EncodeJob* job) {
  check_list("channel", desc.channels, desc.channel_count);
  for (size_t i = 0; i < desc.channel_count; ++i) {
    const shd_file_channel& from = desc.channels[i];
    check_name(item("channels", i, "name"), from.name);
    if (!from.column.data) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.channels[%zu].column.data: NULL", i);
    if (!is_exr) continue;
    for (const EncodeChannel& other : job->channels) {
      if (other.name != from.name) continue;
      refuse(SHD_ERROR_INVALID_ARGUMENT, "save.channels[%zu].name: there are two channels \"%s\"", i, from.name);
    }
    PlaneChannel channel = {shd_plane_view_default(), Sample::kFloat};
    channel.step = from.column.stride ? from.column.stride : sizeof(float);
    channel.view.f32 = from.column.data;
    channel.view.row_stride = channel.step * rows->width;
    rows->channels.push_back(channel);
    job->channels.push_back({from.name, Sample::kFloat});
  }
}

Buffer make_distances(const shd_view& view, const shd_plane_view& depth, uint32_t width, uint32_t height,
                      const Memory& memory) {
  double inverse[16];
  if (!data::invert(view.view_to_clip, inverse)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.view.view_to_clip: the matrix has no inverse");
  }
  Buffer buffer(memory, sizeof(float) * width * height);
  auto* out = reinterpret_cast<float*>(buffer.data());
  for (uint32_t y = 0; y < height; ++y) {
    const auto* const row =
        reinterpret_cast<const float*>(reinterpret_cast<const char*>(depth.f32) + y * depth.row_stride);
    for (uint32_t x = 0; x < width; ++x) {
      const double place[4] = {2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height, static_cast<double>(row[x]), 1};
      double z = 0, w = 0;
      for (int k = 0; k < 4; ++k) z += inverse[4 * k + 2] * place[k], w += inverse[4 * k + 3] * place[k];
      *out++ = static_cast<float>(w == 0 ? HUGE_VAL : -z / w);
    }
  }
  return buffer;
}

}  // namespace shd::io
