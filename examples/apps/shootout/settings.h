// SPDX-License-Identifier: MIT
#pragma once

#include <shd/shd.h>

#include <string>
#include <vector>

#include "../../../bench/peers/peers.h"

namespace shootout {

enum class Who { kShd, kOpenImageIO, kLlvmpipe, kLavapipe };
constexpr size_t kWhoCount = 4;
constexpr Who kPeers[] = {Who::kOpenImageIO, Who::kLlvmpipe, Who::kLavapipe};
const char* name_of(Who who);

/// A row of the report: a filter with all its options.
struct Setting {
  std::string name, title;
  Who who = Who::kShd;
  shd_sampler_desc sampler;  // shd's options; for a peer, the options that read the same texels
  shd_table_flags tables = SHD_TABLE_MIPMAP;
  shd::bench::PeerFilter peer = shd::bench::PeerFilter::kNone;
  bool estimated = false;  // the number of texels is an estimate
  double mesa = 0.0;       // version of Mesa, for its filters
  bool pictured = true;    // the page has its pictures
};

/// Every row that this build can run: shd's, then the peers'.
std::vector<Setting> all_settings();
/// A message for each peer that this build or this machine does not have; empty = all are there.
std::vector<std::string> missing_peers();
/// Leaves out the rows of a peer from now on; the message is one of missing_peers().
void drop_peer(Who who, const std::string& message);
/// Versions of the peers.
std::vector<std::string> peer_descriptions();
/// A row by its name; fails for an unknown name.
const Setting& setting_named(const std::vector<Setting>& settings, const std::string& name);

}  // namespace shootout
