// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::environment {

constexpr uint32_t kLobeColumns = 32;

/// Rows of GGX lobes: kGgxRowsPerOctave of PrecisionLog2(), from precision 1 to 2^20. Column j is n.v = x^8 with x from
/// kGgxLeastRoot in column 0, where n.v is 1e-4, to 1: shadowing depends on the ratio of n.v and alpha.
constexpr uint32_t kGgxRowsPerOctave = 4, kGgxRows = 20 * kGgxRowsPerOctave + 1;
constexpr float kGgxLeastRoot = 0.316227766f, kGgxLeastCosine = 1e-4f;

/// Rows of the other lobes: row k is the precision ((kPhongRows - 1) / k)^2, and row 0 the limit of narrow lobes.
constexpr uint32_t kPhongRows = 48;

/// One sum for n.v and the precision of a lobe: 1 / alpha^2 of GGX lobes, p + 1 of the others.
template <uint32_t kRows>
struct LobeSum {
  float at[kRows][kLobeColumns];
};

/// Reflection of uniform light of radiance 1, without coefficients, by the lobes of the models.
struct LobeTable {
  LobeSum<kGgxRows> ggx_f0;   // D V n.l (1 - f) with f = (1 - v.h)^5 (Karis, "Real Shading in Unreal Engine 4", 2013)
  LobeSum<kGgxRows> ggx_f90;  // D V n.l f
  LobeSum<kPhongRows> phong;  // part of the lobe max(0, r.l)^p where n.l > 0; column j is n.v = 1 - (1 - j / 31)^2
  LobeSum<kPhongRows> blinn_phong;         // max(0, n.h)^p where n.l > 0, divided by 8 pi / (p + 1); n.v = (j / 31)^2
  LobeSum<kPhongRows> blinn_phong_cosine;  // max(0, n.h)^p n.l, as blinn_phong
  float diffuse[kLobeColumns];             // n.l (1 - f) / pi; columns of GGX lobes
};

/// The table, which the first call in the process computes. The bits are the same on every machine. Models that look it
/// up reflect uniform light within 0.004 of the exact integrals, at every n.v >= 1e-4 and every precision
/// (unit.shade.uniform_light; measured: 0.0026).
const LobeTable& lobe_table();

}  // namespace shd::environment
