// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tool/check/textures.h"

/// One possible reason of refusals: another implementation, or another meaning of a column.
struct Hypothesis {
  std::string subject;  // a pair has two subjects
  std::string option;   // "--wrap clamp"; "--assume NAME" for a change that no other option makes
  std::string text;     // "texels outside are those of clamp"
  std::function<void(Case&)> change;
};

/// The name of a hypothesis for --assume; empty if another option makes its change.
std::string assumed_name(const Hypothesis& hypothesis);

/// All hypotheses that change a case, the likelier ones first, those with wider bounds last.
std::vector<Hypothesis> hypotheses_of(const Case& judged, const Textures& textures);

/// Changes a case by the names of `--assume`. Throws Failure for a name that does not apply to the case.
void assume(const std::vector<std::string>& names, const Textures& textures, Case& judged);
