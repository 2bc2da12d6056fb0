// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::environment {

/// Reflection of uniform light of radiance 1, without coefficients, by the lobes of the models. Row k is the precision
/// 2^k: 1 / alpha^2 of GGX lobes, p + 1 of the others. Column j is n.v = (j / (kLobeColumns - 1))^2.
constexpr uint32_t kLobeRows = 16, kLobeColumns = 32;
enum LobeSum : uint32_t {
  kSumGgxF0,             // D V n.l (1 - f) with f = (1 - v.h)^5 (Karis, "Real Shading in Unreal Engine 4", 2013)
  kSumGgxF90,            // D V n.l f
  kSumPhong,             // part of the lobe max(0, r.l)^p where n.l > 0
  kSumBlinnPhong,        // max(0, n.h)^p where n.l > 0, divided by 8 pi / (p + 1)
  kSumBlinnPhongCosine,  // max(0, n.h)^p max(0, n.l), divided by 8 pi / (p + 1)
  kLobeSums
};

struct LobeTable {
  float sum[kLobeSums][kLobeRows][kLobeColumns];
  float diffuse[kLobeColumns];  // n.l (1 - f) / pi
};

/// The table, which the first call in the process computes. Within 0.004 of the exact integrals at its nodes.
const LobeTable& lobe_table();

}  // namespace shd::environment
