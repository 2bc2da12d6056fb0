// SPDX-License-Identifier: MIT
#include "command/values.h"
#include "tool/option_groups.h"

using namespace command;

namespace {

/// u8, i16be ...
Values format_values(VolumeOptions& out) {
  const std::vector<std::string> names = {"u8", "u16", "f16", "f32", "i8", "i16", "u32", "i32"};  // as shd_raw_sample
  const auto read = [&out, names](const std::string& text) {
    const bool big = ends_with(text, "be");
    const auto found = std::find(names.begin(), names.end(), big ? text.substr(0, text.size() - 2) : text);
    out.sample = static_cast<shd_raw_sample>(found - names.begin());
    out.order = big ? SHD_BYTE_ORDER_BIG : SHD_BYTE_ORDER_LITTLE;
    return found != names.end();
  };
  return {"one of " + join(names) + ", with be behind it for the highest byte first", names, "u8", read};
}

Values header_values(uint64_t& out) {
  const auto read = [&out](const std::string& text) {
    out = SHD_RAW_HEADER_REST;
    return text == "rest" || number(out, 0, 16777216).read(text);
  };
  return {"a number of bytes 0..16777216, or rest", {}, "0", read};
}

Values slice_values(VolumeOptions& out) {
  const auto read = [&out](const std::string& text) {
    const std::vector<std::string> ends = split(text, ',');
    return ends.size() == 2 && number(out.first, 0, 16777215).read(ends[0]) &&
           number(out.last, out.first, 16777215).read(ends[1]);
  };
  return {"FIRST,LAST: whole numbers, the last one not smaller", {}, "0,0", read};
}

Values spacing_values(std::array<float, 3>& out) {
  const auto read = [&out](const std::string& text) {
    const auto numbers = read_numbers(text);
    if (!numbers || numbers->size() != out.size()) return false;
    std::copy(numbers->begin(), numbers->end(), out.begin());
    return std::all_of(out.begin(), out.end(), [](float s) { return s >= 1e-6f && s <= 1e6f; });
  };
  return {"X,Y,Z, each 1e-6..1e6", {}, "1,1,1", read};
}

Values range_values(std::optional<std::array<float, 2>>& out) {
  const auto read = [&out](const std::string& text) {
    const auto numbers = read_numbers(text);
    if (!numbers || numbers->size() != 2) return false;
    out = {(*numbers)[0], (*numbers)[1]};
    return (*numbers)[0] < (*numbers)[1];
  };
  return {"LOW,HIGH, rising", {}, "the smallest and the largest one", read};
}

}  // namespace

Group volume_options(VolumeOptions& out) {
  const Name<bool> kAxes[] = {{"y", false}, {"z", true}};
  return {
      "Volume",
      {{"--volume", "FILE", file(out.file),
        "A volume instead of a model: an OpenVDB file (.vdb); a pattern of images such as slice_%03d.tif; a TIFF or "
        "EXR whose pages are the slices; or voxels without a format, for which --volume-size is needed. It is lit, "
        "except fog of OpenVDB; --model unlit shows its colours, without light."},
       {"--volume-size", "WxHxD", size({out.size[0], out.size[1], out.size[2]}, 65536), "Size of a file of voxels."},
       {"--volume-format", "F", format_values(out), "Format of its numbers."},
       {"--volume-header", "N", header_values(out.header),
        "Bytes in front of its voxels. With rest, the voxels end the file."},
       {"--volume-slices", "FIRST,LAST", slice_values(out), "First and last number of a pattern."},
       {"--volume-grid", "NAME", initially(text(out.grid), "the first one of float or double"),
        "Grid of an OpenVDB file."},
       {"--volume-spacing", "X,Y,Z", spacing_values(out.spacing), "Distances of voxels, except in OpenVDB files."},
       {"--volume-up", "AXIS", named(out.slices_up, kAxes),
        "With y, rows go down and slices away from the viewer; with z, slices go up."},
       {"--volume-range", "LOW,HIGH", range_values(out.range), "Densities from clear to opaque."},
       {"--volume-density", "F", number(out.density, 0, 1e6), "Factor of opacity."}}};
}
