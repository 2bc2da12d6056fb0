// SPDX-License-Identifier: MIT
#include "cost.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "peer_texels.h"
#include "shd_pass.h"

namespace shootout {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Boxes of SHD_BOX_ORIENTED, by its definition in shd/sampler.h.
double oriented_boxes(const Lookups& q, size_t i, double edge, double most) {
  const double x = edge * std::hypot(static_cast<double>(q.dudx[i]), static_cast<double>(q.dvdx[i]));
  const double y = edge * std::hypot(static_cast<double>(q.dudy[i]), static_cast<double>(q.dvdy[i]));
  return std::clamp(std::ceil(std::max(x, y) / std::max(std::min(x, y), 1.0)), 1.0, most);
}

/// Texels of lookup i and bytes of the different ones. False if the library does not explain the filter.
bool count_texels(const ShdPass& pass, const Setting& setting, const Lookups& q, size_t i, double edge, double* texels,
                  double* bytes) {
  if (setting.sampler.filter == SHD_FILTER_SUMMED_AREA) {
    constexpr double kSums = 16, kBytesOfSum = 16;  // four channels of 4 bytes: 2^20 texels of 8 bits
    const bool oriented = setting.sampler.box == SHD_BOX_ORIENTED;
    *texels =
        kSums * (oriented ? oriented_boxes(q, i, edge, static_cast<double>(setting.sampler.max_anisotropy)) : 1.0);
    *bytes = kBytesOfSum * *texels;
    return true;
  }
  if (setting.estimated) {
    *texels = mesa_texels(setting, q, i, edge, static_cast<double>(setting.sampler.max_anisotropy));
    *bytes = 4.0 * *texels;
    return true;
  }
  std::vector<shd_tap> taps;
  shd_explanation explanation;
  if (!pass.explain(q, i, &taps, &explanation)) return false;
  std::set<std::tuple<uint32_t, uint32_t, uint32_t, uint32_t>> different;
  for (const shd_tap& tap : taps) different.insert({tap.level_u, tap.level_v, tap.x, tap.y});
  *texels = static_cast<double>(taps.size());
  *bytes = 4.0 * static_cast<double>(different.size());
  return true;
}

void count(const ShdPass& pass, const Setting& setting, const Lookups& q, double edge, CostRow* row) {
  const size_t step = q.count() > 4096 ? 37 : 7;
  double lookups = 0.0;
  row->texels = row->most_texels = row->bytes = 0.0;
  for (size_t i = step / 2; i < q.count(); i += step) {
    double texels = 0.0, bytes = 0.0;
    if (!count_texels(pass, setting, q, i, edge, &texels, &bytes)) {
      row->texels = row->most_texels = row->bytes = kNone;
      return;
    }
    row->texels += texels;
    row->most_texels = std::max(row->most_texels, texels);
    row->bytes += bytes;
    ++lookups;
  }
  row->texels /= lookups;
  row->bytes /= lookups;
}

/// 256 neighbouring lookups of the middle row, repeated.
Lookups cached_lookups(const Lookups& q, size_t count) {
  constexpr size_t kDifferent = 256;
  const size_t first = std::min(q.count() / 2, q.count() - kDifferent);
  Lookups out;
  const auto repeat = [&](const std::vector<float>& from, std::vector<float>* to) {
    for (size_t i = 0; i < count; ++i) to->push_back(from[first + i % kDifferent]);
  };
  repeat(q.u, &out.u);
  repeat(q.v, &out.v);
  repeat(q.dudx, &out.dudx);
  repeat(q.dvdx, &out.dvdx);
  repeat(q.dudy, &out.dudy);
  repeat(q.dvdy, &out.dvdy);
  return out;
}

/// Nanoseconds a lookup, the fastest of several runs.
double time_of(const ShdPass& pass, const Lookups& q, bool slow) {
  std::vector<float> rgba(4 * q.count());
  double best = 1e9;
  const double start = now();
  for (int i = 0; i < 7 && (i == 0 || now() - start < 0.03); ++i) {
    const double begin = now();
    pass.run(q, &rgba);
    best = std::min(best, now() - begin);
    if (slow) break;
  }
  return 1e9 * best / static_cast<double>(q.count());
}

}  // namespace

Costs measure_costs(const Options& options, const Measurements& m) {
  Costs costs;
  const Texture texture =
      make_texture(options.quick ? "checker" : "photograph", options.texture_edge, options.photograph);
  Peers peers(texture);
  std::vector<Lookups> whole, cached;
  for (const Workload& workload : m.workloads) {
    whole.push_back(lookups_of(workload));
    cached.push_back(cached_lookups(whole.back(), 8192));
  }
  for (size_t s = 0; s < m.settings.size(); ++s) {
    const Setting& setting = m.settings[s];
    const ShdPass pass(texture, setting);
    const bool own = setting.who == Who::kShd, slow = setting.sampler.filter == SHD_FILTER_EXACT;
    if (own) costs.tables.push_back({s, 1e3 * pass.build_seconds(), pass.table_bytes()});
    for (size_t w = 0; w < m.workloads.size(); ++w) {
      CostRow row = {w, s, kNone, kNone, kNone, kNone, kNone};
      count(pass, setting, whole[w], texture.edge, &row);
      if (own) {
        row.whole_ns = time_of(pass, whole[w], slow);
        row.cached_ns = slow ? kNone : time_of(pass, cached[w], false);
      } else {
        const double lookups = static_cast<double>(m.workloads[w].count());
        row.whole_ns = 1e9 * peers.seconds(setting, m.workloads[w], whole[w], 2) / lookups;
        if (setting.who != Who::kLlvmpipe) {  // it would draw the surface
          row.cached_ns = 1e9 * peers.seconds(setting, m.workloads[w], cached[w], 1) / 8192.0;
        }
      }
      costs.lookups.push_back(row);
    }
  }
  return costs;
}

std::vector<FrontRow> fronts(const Measurements& m, const Costs& costs) {
  const size_t settings = m.settings.size();
  std::vector<double> texels(m.workloads.size() * settings, kNone);
  for (const CostRow& row : costs.lookups) texels[row.workload * settings + row.setting] = row.texels;
  std::vector<double> psnrs(m.workloads.size() * m.textures.size() * settings);
  for (const Row& row : m.rows) {
    psnrs[(row.workload * m.textures.size() + row.texture) * settings + row.setting] =
        std::min(row.samples.psnr, kNoError);
  }
  std::vector<FrontRow> all;
  for (size_t i = 0; i < m.workloads.size() * m.textures.size(); ++i) {
    const size_t w = i / m.textures.size();
    for (const double budget : kBudgets) {
      size_t best[kWhoCount], best_default = SIZE_MAX;
      std::fill_n(best, kWhoCount, SIZE_MAX);
      const auto offer = [&](size_t s, size_t* mine) {
        if (*mine == SIZE_MAX || psnrs[i * settings + s] > psnrs[i * settings + *mine]) *mine = s;
      };
      for (size_t s = 0; s < settings; ++s) {
        if (!(texels[w * settings + s] <= budget + 1e-9)) continue;  // not available, or too many
        const bool own = m.settings[s].who == Who::kShd;
        offer(s, &best[static_cast<size_t>(m.settings[s].who)]);
        if (own && m.settings[s].sampler.profile == SHD_PROFILE_LEAST_ERROR) offer(s, &best_default);
      }
      for (const Who peer : kPeers) {
        const size_t own = best[0], other = best[static_cast<size_t>(peer)];
        if (other == SIZE_MAX) continue;
        const auto lead = [&](size_t s) { return psnrs[i * settings + s] - psnrs[i * settings + other]; };
        all.push_back({w, i % m.textures.size(), peer, budget, own, other, lead(own), lead(best_default)});
      }
    }
  }
  return all;
}

}  // namespace shootout
