// SPDX-License-Identifier: MIT
#include "color/bake.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/channel.h"

namespace shd::color {
namespace {

constexpr float kLargestCurveInput = 1e15f;  // above what a matrix makes of the largest input
constexpr float kLargestTableValue = 1e16f;
constexpr double kLargestNumber = 1e18;  // squares and their sums are still finite

constexpr int kCurveShift[kTableSizes] = {14, 11};  // keys of a curve's step, as a power of two
constexpr int kGainShift = 17;                      // 64 steps an octave: a power of 0.98 is off by less than 1e-6
constexpr float kNoLimit = 3e38f;
constexpr size_t kMostCodeWords = size_t{1} << 20;

float from_key(int32_t key) {
  const int32_t bits = mirror_key(key);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

int32_t to_key(float value) {
  int32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return mirror_key(bits);
}

/// `value` rounded down to a multiple of 2^shift.
int32_t round_down(int32_t value, int shift) {
  return static_cast<int32_t>(static_cast<uint32_t>(value) & (~uint32_t{0} << shift));
}

/// A number for a table: NaN becomes 0, others are clamped.
float clean(float value) {
  const float limit = kLargestTableValue;
  return value == value ? std::min(std::max(value, -limit), limit) : 0.0f;
}

/// Three planes of numbers.
struct Triple {
  std::vector<float> c[3];

  explicit Triple(size_t count) {
    for (auto& channel : c) channel.resize(count);
  }
  size_t count() const { return c[0].size(); }
  void apply(const Transform& transform) {
    constexpr size_t kPiece = 4096;
    for (size_t i = 0; i < count(); i += kPiece) {
      transform.apply(&c[0][i], &c[1][i], &c[2][i], std::min(kPiece, count() - i));
    }
    for (auto& channel : c) std::transform(channel.begin(), channel.end(), channel.begin(), clean);
  }
};

/// The curves of `transform` at keys `first`, `first` + 2^shift, ...; null = no change.
Triple sample_curves(const Transform* transform, int32_t first, size_t count, int shift) {
  Triple values(count);
  for (size_t i = 0; i < count; ++i) {
    const auto key = static_cast<int32_t>(first + (static_cast<int64_t>(i) << shift));
    values.c[0][i] = values.c[1][i] = values.c[2][i] = from_key(key);
  }
  if (transform) values.apply(*transform);
  return values;
}

size_t steps_between(int32_t first, int32_t end, int shift) {
  return static_cast<size_t>((static_cast<int64_t>(end) - first) >> shift);
}

/// A range of keys outside of which some values are constant.
struct KeyRange {
  int32_t first, end;
};

/// Smallest range of whole steps in which samples of a wider range change.
template <class Differ>
KeyRange find_range(KeyRange wide, int shift, const Differ& differ) {
  const size_t steps = steps_between(wide.first, wide.end, shift);
  size_t begin = 0, end = steps;
  while (begin < end && !differ(begin)) ++begin;
  while (end > begin && !differ(end - 1)) --end;
  if (begin == end) end = begin + 1;
  const auto key = [&](size_t step) {
    return static_cast<int32_t>(wide.first + (static_cast<int64_t>(step) << shift));
  };
  return {key(begin), key(std::min(end, steps))};
}

KeyRange widest_range(int shift) {
  return {round_down(to_key(-kLargestCurveInput), shift), round_down(to_key(kLargestCurveInput), shift)};
}

class Baker {
 public:
  Baker(shd_context* context, int curve_shift)
      : context_(context), curve_shift_(curve_shift), program_(std::make_unique<Program>()) {}

  std::unique_ptr<Program> bake(const std::vector<Part>& parts) {
    const bool ends_in_curve = !parts.empty() && parts.back().kind == PartKind::kCurve;
    const size_t stages = parts.size() - (ends_in_curve ? 1 : 0);
    for (size_t i = 0; i < stages; ++i) {
      if (!add_stage(parts[i])) return nullptr;
    }
    if (!add_codes(ends_in_curve ? parts.back().transform.get() : nullptr)) return nullptr;
    return std::move(program_);
  }

 private:
  /// False if there is no stage for the part, or if numbers could overflow.
  bool add_stage(const Part& part) {
    if (join_clamp(part)) return true;
    Stage stage = {};
    switch (part.kind) {
      case PartKind::kMatrix: set_matrix(part, &stage); break;
      case PartKind::kClamp: set_clamp(part, &stage); break;
      case PartKind::kCurve: set_curves(*part.transform, &stage); break;
      case PartKind::kGlow:
        stage.kind = StageKind::kGlow;
        bound_ *= 1.1;
        break;
      case PartKind::kRedModifier: set_red_modifier(&stage); break;
      case PartKind::kSurround: set_surround(part, &stage); break;
      case PartKind::kLut3d: set_lut3d(part, &stage); break;
      case PartKind::kOther: return false;
    }
    program_->stages.push_back(stage);
    return bound_ <= kLargestNumber;
  }

  template <class T>
  T* allocate(size_t count) {
    program_->arrays.emplace_back(context_, count * sizeof(T));
    return program_->arrays.back().as<T>();
  }

  void set_matrix(const Part& part, Stage* stage) {
    stage->kind = StageKind::kMatrix;
    double largest = 0.0;
    for (int row = 0; row < 3; ++row) {
      double sum = std::fabs(part.matrix[row][3]);
      for (int column = 0; column < 4; ++column) {
        stage->matrix[row][column] = static_cast<float>(part.matrix[row][column]);
        if (column < 3) sum += std::fabs(part.matrix[row][column]) * bound_;
      }
      largest = sum <= largest ? largest : sum;  // NaN stays
    }
    bound_ = largest;
    stage->low = -kNoLimit;
    stage->high = kNoLimit;
  }

  /// Joins a clamp with the matrix before it.
  bool join_clamp(const Part& part) {
    if (part.kind != PartKind::kClamp || program_->stages.empty()) return false;
    Stage& before = program_->stages.back();
    if (before.kind != StageKind::kMatrix || before.high != kNoLimit || before.low != -kNoLimit) return false;
    before.low = part.low;
    before.high = part.high;
    return true;
  }

  void set_clamp(const Part& part, Stage* stage) {
    stage->kind = StageKind::kClamp;
    stage->low = part.low;
    stage->high = part.high;
    bound_ =
        std::min(bound_, std::max(std::fabs(static_cast<double>(part.low)), std::fabs(static_cast<double>(part.high))));
  }

  void set_curves(const Transform& transform, Stage* stage) {
    constexpr int kCoarse = 16;
    const KeyRange wide = widest_range(kCoarse);
    const Triple coarse =
        sample_curves(&transform, wide.first, steps_between(wide.first, wide.end, kCoarse) + 1, kCoarse);
    const KeyRange range = find_range(wide, kCoarse, [&](size_t step) {
      const auto changes = [&](const std::vector<float>& c) { return c[step] != c[step + 1]; };
      return changes(coarse.c[0]) || changes(coarse.c[1]) || changes(coarse.c[2]);
    });
    const int shift = curve_shift_;
    const size_t steps = steps_between(range.first, range.end, shift);
    const Triple fine = sample_curves(&transform, range.first, steps + 1, shift);
    stage->curves.shift = shift;
    stage->kind = StageKind::kCurves;
    stage->curves.first = range.first;
    stage->curves.last = range.end - 1;
    bound_ = 0.0;
    for (int c = 0; c < 3; ++c) {
      stage->curves.value[c] = share(fine.c, c, stage->curves.value);
      for (const float value : fine.c[c]) bound_ = std::max(bound_, std::fabs(static_cast<double>(value)));
    }
  }

  /// A copy of channel c in the context's memory, or the copy of an earlier equal channel.
  template <class T>
  const T* share(const std::vector<T> (&channels)[3], int c, const T* const (&copies)[3]) {
    for (int earlier = 0; earlier < c; ++earlier) {
      if (channels[earlier] == channels[c]) return copies[earlier];
    }
    T* copy = allocate<T>(channels[c].size());
    std::copy(channels[c].begin(), channels[c].end(), copy);
    return copy;
  }

  /// The weight is a quadratic B-spline over 135 degrees of hue around red.
  void set_red_modifier(Stage* stage) {
    float* weights = allocate<float>(kHueSteps + 1);
    for (int i = 0; i <= kHueSteps; ++i) {
      const double ratio = 2.0 * i / kHueSteps - 1.0;
      const double hue = std::atan2(ratio, 1.0 - std::fabs(ratio));
      const double x = std::fabs(hue) * 4.0 / (135.0 * 3.14159265358979324 / 180.0);  // in knots
      double weight = 0.0;
      if (x < 1.0) weight = 1.0 - 1.5 * x * x + 0.75 * x * x * x;
      if (x >= 1.0 && x < 2.0) weight = 0.25 * (2.0 - x) * (2.0 - x) * (2.0 - x);
      weights[i] = static_cast<float>(weight);
    }
    stage->kind = StageKind::kRedModifier;
    stage->hue_weight = weights;
    bound_ *= 1.2;
  }

  void set_surround(const Part& part, Stage* stage) {
    stage->kind = StageKind::kSurround;
    std::copy(part.luminance, part.luminance + 3, stage->luminance);
    stage->floor = part.floor;
    set_gains(part, stage);
    const double gain = std::max(std::pow(static_cast<double>(part.floor), static_cast<double>(part.exponent)),
                                 std::pow(std::max(bound_, 1.0), static_cast<double>(part.exponent)));
    bound_ *= gain <= 1.0 ? 1.0 : gain;
  }

  /// The power of luminance, from the floor to the largest luminance that numbers within the bound have.
  void set_gains(const Part& part, Stage* stage) {
    double largest = 2.0 * static_cast<double>(part.floor);
    for (const float weight : part.luminance) largest += std::fabs(static_cast<double>(weight)) * bound_;
    const int32_t first = round_down(to_key(part.floor), kGainShift), step = 1 << kGainShift;
    const int32_t end = round_down(to_key(static_cast<float>(largest)), kGainShift) + step;
    const size_t steps = steps_between(first, end, kGainShift);
    float* gains = allocate<float>(steps + 1);
    for (size_t i = 0; i <= steps; ++i) {
      const double luminance = static_cast<double>(from_key(first + static_cast<int32_t>(i) * step));
      gains[i] = static_cast<float>(std::pow(luminance, static_cast<double>(part.exponent)));
    }
    stage->curves.value[0] = gains;
    stage->curves.first = first;
    stage->curves.last = end - 1;
    stage->curves.shift = kGainShift;
  }

  void set_lut3d(const Part& part, Stage* stage) {
    float* nodes = allocate<float>(part.nodes.size());
    std::transform(part.nodes.begin(), part.nodes.end(), nodes, clean);
    stage->kind = StageKind::kLattice;
    stage->lattice = {nodes, static_cast<int32_t>(part.grid), part.tetrahedral};
    bound_ = static_cast<double>(kLargestTableValue);
  }

  bool add_codes(const Transform* transform);

  shd_context* context_;
  int curve_shift_;
  std::unique_ptr<Program> program_;
  double bound_ = 1e12;  // bound of the numbers between stages
};

/// The code of a number of a display.
uint8_t code_of(float value) {
  return image::unorm_code<uint8_t>(static_cast<double>(value));
}

/// Finds where the code of one channel changes within each step. All steps are bisected together.
class ChangeFinder {
 public:
  ChangeFinder(const Transform* transform, KeyRange range, int shift)
      : transform_(transform), range_(range), shift_(shift), steps_(steps_between(range.first, range.end, shift)) {}

  /// Words of the channels; false if a step has more than one change.
  bool find(std::vector<uint32_t> (&words)[3]) {
    const Triple starts = sample_curves(transform_, range_.first, steps_, shift_);
    const Triple ends = sample_curves(transform_, range_.first + (1 << shift_) - 1, steps_, shift_);
    for (int c = 0; c < 3; ++c) {
      words[c].resize(steps_);
      changes_.clear();
      for (size_t i = 0; i < steps_; ++i) {
        const uint8_t before = code_of(starts.c[c][i]), after = code_of(ends.c[c][i]);
        words[c][i] = uint32_t{before} | uint32_t{after} << 8;
        if (before != after) changes_.push_back({i, 0, (1 << shift_) - 1, before, after});
      }
      if (!bisect(c)) return false;
      for (const Change& change : changes_) words[c][change.step] |= static_cast<uint32_t>(change.above) << 16;
    }
    return true;
  }

 private:
  /// The code is `before` at `below` and `after` at `above`, both distances from the start of the step.
  struct Change {
    size_t step;
    int32_t below, above;
    uint8_t before, after;
  };

  bool bisect(int channel) {
    for (int round = 0; round < shift_; ++round) {
      Triple middle(changes_.size());
      for (size_t i = 0; i < changes_.size(); ++i) {
        const Change& change = changes_[i];
        const int32_t key = range_.first + static_cast<int32_t>(change.step << shift_);
        const float number = from_key(key + (change.below + change.above) / 2);
        middle.c[0][i] = middle.c[1][i] = middle.c[2][i] = number;
      }
      if (transform_) middle.apply(*transform_);
      for (size_t i = 0; i < changes_.size(); ++i) {
        Change& change = changes_[i];
        if (change.above - change.below <= 1) continue;
        const uint8_t code = code_of(middle.c[channel][i]);
        if (code != change.before && code != change.after) return false;
        (code == change.before ? change.below : change.above) = (change.below + change.above) / 2;
      }
    }
    return true;
  }

  const Transform* transform_;
  KeyRange range_;
  int shift_;
  size_t steps_;
  std::vector<Change> changes_;
};

bool Baker::add_codes(const Transform* transform) {
  constexpr int kCoarse = 16;
  const KeyRange wide = widest_range(kCoarse);
  const Triple coarse = sample_curves(transform, wide.first, steps_between(wide.first, wide.end, kCoarse) + 1, kCoarse);
  const KeyRange range = find_range(wide, kCoarse, [&](size_t step) {
    const auto changes = [&](const std::vector<float>& c) { return code_of(c[step]) != code_of(c[step + 1]); };
    return changes(coarse.c[0]) || changes(coarse.c[1]) || changes(coarse.c[2]);
  });
  for (int shift = kCoarse; shift >= 8; --shift) {
    if (steps_between(range.first, range.end, shift) > kMostCodeWords) return false;
    std::vector<uint32_t> words[3];
    if (!ChangeFinder(transform, range, shift).find(words)) continue;
    program_->codes.first = range.first;
    program_->codes.last = range.end - 1;
    program_->codes.shift = shift;
    for (int c = 0; c < 3; ++c) program_->codes.word[c] = share(words, c, program_->codes.word);
    return true;
  }
  return false;
}

}  // namespace

std::unique_ptr<Program> bake(shd_context* context, const std::vector<Part>& parts, int size) {
  return Baker(context, kCurveShift[size]).bake(parts);
}

size_t Program::bytes() const {
  size_t sum = 0;
  for (const Array& array : arrays) sum += array.bytes();
  return sum;
}

}  // namespace shd::color
