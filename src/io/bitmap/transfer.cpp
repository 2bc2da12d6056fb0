// SPDX-License-Identifier: MIT
#include "io/bitmap/transfer.h"

#include <cmath>
#include <cstdlib>
#include <vector>

#include "image/channel.h"

namespace shd::io {

namespace {

// SMPTE ST 2065-1:2012 (AP0) and S-2014-004 (AP1).
constexpr float kAp0[8] = {0.7347f, 0.2653f, 0.0f, 1.0f, 0.0001f, -0.0770f, 0.32168f, 0.33767f};
constexpr float kAp1[8] = {0.713f, 0.293f, 0.165f, 0.830f, 0.128f, 0.044f, 0.32168f, 0.33767f};

bool near_all(const float* a, const float* b) {
  for (int i = 0; i < 8; ++i) {
    if (!(std::fabs(a[i] - b[i]) <= 2e-3f)) return false;
  }
  return true;
}

std::string lower(const std::string& text) {
  std::string out = text;
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  }
  return out;
}

bool is_linear_name(const std::string& reported) {
  const std::string text = lower(reported);
  return text == "linear" || text == "scene_linear" || text == "lin_srgb" || text == "lin_rec709" ||
         text == "linear rec.709" || text == "linear rec.709 (srgb)";
}

/// Decoded value of every code of an integer format; empty for other formats.
std::vector<float> code_table(const Transfer& transfer, shd_format format) {
  const bool wide = format == SHD_FORMAT_RGBA16;
  if (!wide && format != SHD_FORMAT_RGBA8 && format != SHD_FORMAT_RGBA8_SRGB) return {};
  const size_t maximum = wide ? 65535 : 255;
  std::vector<float> table(maximum + 1);
  for (size_t i = 0; i <= maximum; ++i) {
    table[i] = static_cast<float>(decode(transfer, static_cast<double>(i) / static_cast<double>(maximum)));
  }
  return table;
}

}  // namespace

// strtod is not used, because it follows the host's locale.
double parse_gamma(const std::string& text) {
  double value = 0, scale = 0;
  for (const char c : text) {
    if (c == '.' && scale == 0) {
      scale = 1;
    } else if (c >= '0' && c <= '9') {
      value = value * 10 + (c - '0');
      scale *= 10;
    } else {
      return 0;
    }
  }
  return scale > 0 ? value / scale : value;
}

Transfer transfer_of(const std::string& color_space) {
  const std::string text = lower(color_space);
  if (text == "srgb") return {Curve::kSrgb, 1};
  if (text == "rec709") return {Curve::kRec709, 1};
  if (text == "data" || text == "raw" || text == "acescg" || text == "aces2065-1" || is_linear_name(text)) {
    return {Curve::kLinear, 1};
  }
  if (text.rfind("linear (", 0) == 0) return {Curve::kLinear, 1};
  if (text.rfind("gamma", 0) == 0) {
    const double gamma = parse_gamma(text.substr(5));
    if (gamma >= 0.1 && gamma <= 10) return {Curve::kGamma, gamma};
  }
  return {};
}

std::string name_color_space(shd_color_encoding wanted, const std::string& reported, bool integers,
                             const float* chromaticities) {
  switch (wanted) {
    case SHD_COLOR_ENCODING_SRGB: return "sRGB";
    case SHD_COLOR_ENCODING_LINEAR: return "Linear Rec.709";
    case SHD_COLOR_ENCODING_DATA: return "data";
    default: break;
  }
  if (reported.empty() && integers) return "sRGB";
  if (reported.empty() || is_linear_name(reported)) {
    if (!chromaticities || near_all(chromaticities, kRec709)) return "Linear Rec.709";
    if (near_all(chromaticities, kAp1)) return "ACEScg";
    if (near_all(chromaticities, kAp0)) return "ACES2065-1";
    return "Linear (other primaries)";
  }
  if (lower(reported) == "srgb") return "sRGB";
  std::string name;
  for (const char c : reported.substr(0, 63)) name += c > 0x20 - 1 && c < 0x7f ? c : '?';
  return name;
}

double decode(const Transfer& transfer, double value) {
  if (value < 0) return -decode(transfer, -value);
  switch (transfer.curve) {
    case Curve::kSrgb: return image::srgb_to_linear(value);
    case Curve::kRec709: return value < 0.081 ? value / 4.5 : std::pow((value + 0.099) / 1.099, 1 / 0.45);
    case Curve::kGamma: return std::pow(value, transfer.gamma);
    default: return value;
  }
}

void linearise(const Transfer& transfer, shd_format format, const void* in, size_t count, float* out) {
  const std::vector<float> table = code_table(transfer, format);
  const image::FormatInfo info = image::format_info(format);
  const auto* at = static_cast<const unsigned char*>(in);
  for (size_t i = 0; i < 4 * count; ++i, at += info.channel_size) {
    if (i % 4 < 3 && !table.empty()) {
      out[i] = table[info.channel_size == 2 ? image::load_as<uint16_t>(at) : *at];
    } else {
      const double number = image::load_number(info.component, at);
      out[i] = static_cast<float>(i % 4 == 3 ? number : decode(transfer, number));
    }
  }
}

}  // namespace shd::io
