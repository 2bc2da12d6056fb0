// SPDX-License-Identifier: MIT
#pragma once
#include "model.h"

/// The Utah teapot, y up, spout towards +x. Patches share their edges bit for bit, so that there are no cracks. Body
/// and bottom, lid, handle and spout are open only where they meet or intersect each other.
/// @param steps  divisions of each edge of the 32 patches, 1..256
Model make_teapot(int steps);
