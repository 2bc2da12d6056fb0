// SPDX-License-Identifier: MIT
#pragma once

#include "workload.h"

/// Pictures for judging the quality of filters, and the result of perfect filtering.
namespace shd::bench {

/// A square texture, repeated over the plane.
struct Picture {
  std::string name;
  uint32_t edge;  // a power of two
  std::vector<uint8_t> rgba;
};

/// Black and white squares of `square` texels.
Picture make_checker(uint32_t edge, uint32_t square);
/// Value noise whose octaves decrease as 1 / frequency, as the spectra of photographs do.
Picture make_noise(uint32_t edge);

/// The frame as RGBA: each pixel the mean of samples x samples regular points of the bilinear reconstruction, projected
/// exactly, in doubles.
std::vector<float> supersample(const Floor& floor, const Picture& picture, int samples);

/// Adds the bilinear reconstruction of r, g, b at one point, in steps of 8 bits.
void add_bilinear(const Picture& picture, double u, double v, double* sum);

/// Peak signal-to-noise ratio of r, g, b clamped to [0, 1], for a peak of 1 [dB].
double psnr(const std::vector<float>& rgba, const std::vector<float>& truth);

}  // namespace shd::bench
