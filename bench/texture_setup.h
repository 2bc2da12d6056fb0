// SPDX-License-Identifier: MIT
#pragma once

#include "bench.h"
#include "peers/peers.h"
#include "workload.h"

/// Filters, formats and objects that the rows of textures share.
namespace shd::bench {

/// A filter of shd, the data that it reads, and the equivalent filter of peers.
struct Filter {
  const char* name;
  shd_filter filter;
  uint32_t tables;
  bool reads_derivatives;
  const char* peer_row;  // name of the peers' rows to compare with; empty = none
  PeerFilter peer;
  uint32_t every;       // one lookup in `every` is run, to keep slow filters short
  bool on_all_formats;  // has rows beyond RGBA8 at the larger size
  shd_filter stochastic_filter = SHD_FILTER_TRILINEAR;
  shd_box box = SHD_BOX_BOUNDING;
  shd_profile profile = SHD_PROFILE_LEAST_ERROR;
  shd_precision precision = SHD_PRECISION_FULL;
  float probe_slack = 0.125f, level_blend = 1.0f;
  float bias = 0.0f, width = 1.0f, max_anisotropy = 16.0f;
  shd_stochastic stochastic = SHD_STOCHASTIC_TEXEL;
};

/// A row of a filter of kFilters with SHD_PRECISION_FAST. Other probes than the default ones are compared with
/// SHD_PROFILE_EXACT.
constexpr Filter fast(const char* name, shd_filter filter, bool reads_derivatives, const char* peer_row,
                      PeerFilter peer, bool on_all_formats, float probe_slack = 0.125f, float level_blend = 1.0f) {
  Filter row = {name, filter, SHD_TABLE_MIPMAP, reads_derivatives, peer_row, peer, 1, on_all_formats};
  row.profile = level_blend < 1.0f ? SHD_PROFILE_EXACT : SHD_PROFILE_LEAST_ERROR;
  row.precision = SHD_PRECISION_FAST;
  row.probe_slack = probe_slack;
  row.level_blend = level_blend;
  return row;
}

/// A row of SHD_FILTER_STOCHASTIC that draws quads.
constexpr Filter quads(const char* name, shd_filter stochastic_filter) {
  Filter filter = {name,  SHD_FILTER_STOCHASTIC, SHD_TABLE_MIPMAP, true, "", PeerFilter::kNone, 1,
                   false, stochastic_filter};
  filter.stochastic = SHD_STOCHASTIC_QUAD;
  return filter;
}

constexpr Filter kFilters[] = {
    {"nearest", SHD_FILTER_NEAREST, SHD_TABLE_MIPMAP, false, "nearest", PeerFilter::kNearest, 1, true},
    {"bilinear", SHD_FILTER_BILINEAR, SHD_TABLE_MIPMAP, false, "bilinear", PeerFilter::kBilinear, 1, true},
    {"bicubic", SHD_FILTER_BICUBIC, SHD_TABLE_MIPMAP, false, "", PeerFilter::kNone, 1, false},
    {"hermite", SHD_FILTER_HERMITE, SHD_TABLE_MIPMAP, false, "", PeerFilter::kNone, 1, false},
    {"nearest_mip", SHD_FILTER_NEAREST_MIP, SHD_TABLE_MIPMAP, true, "nearest_mip", PeerFilter::kNearestMip, 1, false},
    {"bilinear_mip", SHD_FILTER_BILINEAR_MIP, SHD_TABLE_MIPMAP, true, "bilinear_mip", PeerFilter::kBilinearMip, 1,
     false},
    {"trilinear", SHD_FILTER_TRILINEAR, SHD_TABLE_MIPMAP, true, "trilinear", PeerFilter::kTrilinear, 1, true},
    {"ripmap", SHD_FILTER_RIPMAP, SHD_TABLE_RIPMAP, true, "", PeerFilter::kNone, 1, false},
    {"summed_area", SHD_FILTER_SUMMED_AREA, SHD_TABLE_SUMMED_AREA, true, "", PeerFilter::kNone, 1, false},
    {"summed_area_oriented", SHD_FILTER_SUMMED_AREA, SHD_TABLE_SUMMED_AREA, true, "", PeerFilter::kNone, 1, false,
     SHD_FILTER_TRILINEAR, SHD_BOX_ORIENTED},
    {"anisotropic", SHD_FILTER_ANISOTROPIC, SHD_TABLE_MIPMAP, true, "anisotropic", PeerFilter::kAnisotropic16, 1, true},
    {"trilinear_vulkan", SHD_FILTER_TRILINEAR, SHD_TABLE_MIPMAP, true, "trilinear", PeerFilter::kTrilinear, 1, false,
     SHD_FILTER_TRILINEAR, SHD_BOX_BOUNDING, SHD_PROFILE_VULKAN},
    {"trilinear_oiio", SHD_FILTER_TRILINEAR, SHD_TABLE_MIPMAP, true, "trilinear", PeerFilter::kTrilinear, 1, false,
     SHD_FILTER_TRILINEAR, SHD_BOX_BOUNDING, SHD_PROFILE_OIIO},
    {"anisotropic_vulkan", SHD_FILTER_ANISOTROPIC, SHD_TABLE_MIPMAP, true, "anisotropic", PeerFilter::kAnisotropic16, 1,
     false, SHD_FILTER_TRILINEAR, SHD_BOX_BOUNDING, SHD_PROFILE_VULKAN},
    {"anisotropic_d3d11", SHD_FILTER_ANISOTROPIC, SHD_TABLE_MIPMAP, true, "anisotropic", PeerFilter::kAnisotropic16, 1,
     false, SHD_FILTER_TRILINEAR, SHD_BOX_BOUNDING, SHD_PROFILE_D3D11},
    {"anisotropic_oiio", SHD_FILTER_ANISOTROPIC, SHD_TABLE_MIPMAP, true, "anisotropic", PeerFilter::kAnisotropic16, 1,
     false, SHD_FILTER_TRILINEAR, SHD_BOX_BOUNDING, SHD_PROFILE_OIIO},
    fast("bilinear_fast", SHD_FILTER_BILINEAR, false, "bilinear", PeerFilter::kBilinear, true),
    fast("bilinear_mip_fast", SHD_FILTER_BILINEAR_MIP, true, "bilinear_mip", PeerFilter::kBilinearMip, false),
    fast("trilinear_fast", SHD_FILTER_TRILINEAR, true, "trilinear", PeerFilter::kTrilinear, true),
    fast("anisotropic_fast", SHD_FILTER_ANISOTROPIC, true, "anisotropic", PeerFilter::kAnisotropic16, true),
    fast("anisotropic_one_level_fast", SHD_FILTER_ANISOTROPIC, true, "anisotropic", PeerFilter::kAnisotropic16, false,
         0.35f, 0.03125f),
    {"ewa", SHD_FILTER_EWA, SHD_TABLE_MIPMAP, true, "anisotropic", PeerFilter::kAnisotropic16, 1, false},
    {"stochastic", SHD_FILTER_STOCHASTIC, SHD_TABLE_MIPMAP, true, "", PeerFilter::kNone, 1, false},
    {"stochastic_anisotropic", SHD_FILTER_STOCHASTIC, SHD_TABLE_MIPMAP, true, "", PeerFilter::kNone, 1, false,
     SHD_FILTER_ANISOTROPIC},
    {"stochastic_ewa", SHD_FILTER_STOCHASTIC, SHD_TABLE_MIPMAP, true, "", PeerFilter::kNone, 1, false, SHD_FILTER_EWA},
    quads("stochastic_quad", SHD_FILTER_TRILINEAR),
    quads("stochastic_anisotropic_quad", SHD_FILTER_ANISOTROPIC),
    {"exact", SHD_FILTER_EXACT, SHD_TABLE_MIPMAP, true, "", PeerFilter::kNone, 61, false},
};

/// Whether the peers' rows use this filter, and not another one that it is compared with.
inline bool has_own_peers(const Filter& filter) {
  return std::string(filter.name) == filter.peer_row;
}

struct Format {
  const char* name;
  shd_format format;
  int channels;
  bool random_blocks = false;  // blocks of random bits, not of the compressed texels
  bool in_tiles = false;
};
constexpr Format kFormats[] = {{"r8", SHD_FORMAT_R8, 1},
                               {"rgba8", SHD_FORMAT_RGBA8, 4},
                               {"rgba8_srgb", SHD_FORMAT_RGBA8_SRGB, 4},
                               {"rgba16f", SHD_FORMAT_RGBA16F, 4},
                               {"rgba32f", SHD_FORMAT_RGBA32F, 4}};
/// Blocks of the texels of the other rows, and blocks of random bits, which have all modes.
constexpr Format kBlockFormats[] = {{"bc1", SHD_FORMAT_BC1_RGBA, 4, true},
                                    {"bc7", SHD_FORMAT_BC7, 4, true},
                                    {"bc1_image", SHD_FORMAT_BC1_RGBA, 4},
                                    {"bc7_image", SHD_FORMAT_BC7, 4}};
/// RGBA8 in a cache of tiles, which holds the whole texture after the first run.
constexpr Format kTiles = {"rgba8_tiles", SHD_FORMAT_RGBA8, 4, false, true};
/// The format of the peers' rows.
constexpr Format kRgba8 = kFormats[1];

/// Converts RGBA8 texels to another format of pixels, whose channels are the first ones.
std::vector<uint8_t> convert(const std::vector<uint8_t>& rgba, const Format& format);

/// A context with a texture and a sampler for `filter`.
class Sampling {
 public:
  Sampling(shd_simd simd, const Filter& filter, const Format& format, uint32_t edge, const std::vector<uint8_t>& texels,
           uint32_t workers = 1);
  ~Sampling();
  Sampling(const Sampling&) = delete;
  Sampling& operator=(const Sampling&) = delete;

  /// Filters `columns` into `out`.
  void run(const shd_lookups& columns, shd_texels* out) const;

 private:
  shd_context* context_ = nullptr;
  void move_into_tiles(const shd_texture_desc& desc);

  shd_texture* texture_ = nullptr;
  shd_sampler* sampler_ = nullptr;
  std::vector<std::vector<uint8_t>> levels_;  // source of a texture in tiles
};

/// The columns that `filter` reads, with one lookup in filter.every.
shd_lookups columns_of(const Lookups& lookups, const Filter& filter);

/// Every lookup as RGBA.
std::vector<float> filtered_image(const Filter& filter, const Lookups& lookups, uint32_t edge,
                                  const std::vector<uint8_t>& texels);

}  // namespace shd::bench
