// SPDX-License-Identifier: MIT
#pragma once

namespace shd::data {

/// An axis and the direction along it.
struct Direction {
  int axis;
  bool backwards;
};

/// A side of a box, seen from outside with +Y up; the sides +Y and -Y have +X to the right. u runs right, v runs down.
struct BoxSide {
  Direction normal, right, down;
};

/// +X, -X, +Y, -Y, +Z, -Z.
constexpr BoxSide kBoxSides[6] = {{{0, false}, {2, true}, {1, true}},   {{0, true}, {2, false}, {1, true}},  //
                                  {{1, false}, {0, false}, {2, false}}, {{1, true}, {0, false}, {2, true}},  //
                                  {{2, false}, {0, false}, {1, true}},  {{2, true}, {0, true}, {1, true}}};

}  // namespace shd::data
