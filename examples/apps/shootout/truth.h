// SPDX-License-Identifier: MIT
#pragma once

#include "textures.h"
#include "workloads/workload.h"

namespace shootout {

/// A frame whose pixels are means of samples x samples regular points of the bilinear reconstruction, each shaded by
/// itself. With `phases` of 2 or more, which divides `samples`, the frame has a mean of one pixel around each of
/// phases x phases places a pixel, as lookups_of() has them; the workload is smooth.
Picture supersample(const Workload& workload, const Texture& texture, uint32_t samples, uint32_t phases = 1);

/// The shaded points themselves in row y of samples, `count` of them from the left.
void sample_row(const Workload& workload, const Texture& texture, uint32_t samples_x, uint32_t samples_y, uint32_t y,
                size_t count, std::vector<float>* rgb);

}  // namespace shootout
