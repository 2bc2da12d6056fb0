// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "tool/check/bounds.h"
#include "tool/check/diagnose.h"

/// A refused row.
struct Refusal {
  size_t place, channel;  // the channel that is farthest outside
  float excess;
};

/// The verdict on a table.
struct Verdict {
  std::vector<Refusal> refusals;  // the farthest first
  bool diagnosed = false;
  Diagnosis diagnosis;
};

/// The refused rows of a table, the farthest first; rows that are as far keep their order.
std::vector<Refusal> find_refusals(const Case& judged, const Bounds& bounds);

/// Prints a refused row: the result, its bounds, the nearest legal value, the lookup, and the texels of shd's own one.
void describe(Textures& textures, const Case& judged, const Bounds& bounds, const Refusal& refusal);

/// Prints the number of refusals and the farthest one.
void summarize(const Case& judged, const std::vector<Refusal>& refusals);

void print_diagnosis(const Diagnosis& diagnosis);

/// Writes the verdict on each row as CSV, or the verdict with its refused rows as JSON, by the name of the file.
/// Throws Failure.
void write_report(const std::string& path, const Case& judged, const Bounds& bounds, const Verdict& verdict);
