// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "../picture.h"

/// Differences of pictures of equal size. Values are sRGB-encoded, in [0, 1].
namespace shootout {

/// The largest value of psnr(), for equal pictures [dB].
constexpr double kBestPsnr = 120.0;

/// Peak signal-to-noise ratio of r, g and b for a peak of 1, at most kBestPsnr [dB].
double psnr(const Picture& picture, const Picture& truth);

/// Mean of the structural similarity of the luma, over windows of 11 x 11 pixels inside the picture (Wang, Bovik,
/// Sheikh and Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", 2004). Sizes are
/// at least 11.
double ssim(const Picture& picture, const Picture& truth);

struct Difference {
  double mean, max;
};
/// Mean and largest absolute difference of r, g and b.
Difference difference(const Picture& picture, const Picture& truth);

/// A picture as a viewer perceives it: filtered colours (CIELAB with the Hunt effect), and the strength of edges and
/// points.
struct FlipInput {
  std::vector<std::array<double, 3>> colours;
  std::vector<double> edges, points;
};
/// The default is the viewer of the paper: 67 pixels a degree.
FlipInput flip_input(const Picture& picture, double pixels_per_degree = 67.0206);
/// The error map of the LDR-FLIP evaluator, 0..1 for each pixel (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom
/// and Fairchild, "FLIP: A Difference Evaluator for Alternating Images", 2020).
std::vector<float> flip_map(const FlipInput& picture, const FlipInput& truth);
double mean_of(const std::vector<float>& map);

/// Energy that a filter adds and removes, as shares of the energy of the truth without its mean.
struct Spectrum {
  double aliasing;  // power above the Nyquist frequency of the pixels, beyond the truth's
  double blur;      // power missing below it
};
/// Compares the luma of frames with `phases` x `phases` values a pixel, under a Hann window. Power above half a cycle a
/// pixel folds onto lower frequencies when one value a pixel remains. Power is summed over rings of equal frequency.
Spectrum spectrum(const Picture& picture, const Picture& truth, uint32_t phases);

/// In-place Fourier transform of a power of two of complex numbers, interleaved (Cooley and Tukey 1965).
void fourier(double* values, size_t count);

struct Motion {
  double psnr;     // mean over the frames [dB]
  double flicker;  // root mean square of the second difference in time of the error
};
/// Compares movies whose frames of edge x edge pixels lie side by side, `columns` in a row.
Motion motion(const Picture& movie, const Picture& truth, uint32_t edge, uint32_t columns, uint32_t frames);

}  // namespace shootout
