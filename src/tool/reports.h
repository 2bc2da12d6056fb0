// SPDX-License-Identifier: MIT
#pragma once
#include "tool/model.h"
#include "tool/options.h"

/// Reports on stderr what the options leave out of a model, and what its surfaces need and do not have.
void report_model(const Options& options, const Model& model);
