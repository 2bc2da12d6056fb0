// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "tool/check/hypotheses.h"

/// A hypothesis, or two of them, and what it makes of the table.
struct Finding {
  std::string options;  // "--wrap clamp --assume flipped-v"
  std::string text;     // in words
  size_t legal;         // legal rows under the hypothesis
  size_t explained;     // legal rows that are refused without it
};

struct Diagnosis {
  size_t rows = 0;        // rows with finite results
  size_t refused = 0;     // refused rows with finite results
  size_t not_finite = 0;  // rows that no hypothesis can explain
  size_t hypotheses = 0;  // hypotheses that were tried one by one
  bool tried_pairs = false;
  size_t complete = 0;            // findings that make all rows legal
  std::vector<Finding> findings;  // findings that explain half of the refused rows, best first
  Finding best = {};              // the best one of all
};

/// Judges a table under each hypothesis, and under pairs if none makes all rows legal. `refused` has a flag per row.
Diagnosis diagnose(Textures& textures, const Case& judged, const std::vector<bool>& refused);
