// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cfloat>

#include "color/ocio_transform.h"

namespace shd::color {
namespace {

namespace ocio = OCIO_NAMESPACE;

bool is_forward(const ocio::Transform& transform) {
  return transform.getDirection() == ocio::TRANSFORM_DIR_FORWARD;
}

/// A matrix that neither reads nor writes alpha.
bool read_matrix(const ocio::ConstTransformRcPtr& transform, Part* part) {
  const auto matrix = ocio::DynamicPtrCast<const ocio::MatrixTransform>(transform);
  if (!matrix || !is_forward(*matrix)) return false;
  double m[16], offset[4];
  matrix->getMatrix(m);
  matrix->getOffset(offset);
  for (int row = 0; row < 3; ++row) {
    if (m[4 * row + 3] != 0.0) return false;
    for (int column = 0; column < 3; ++column) part->matrix[row][column] = m[4 * row + column];
    part->matrix[row][3] = offset[row];
  }
  part->kind = PartKind::kMatrix;
  return true;
}

/// A range that clamps and does not scale.
bool read_clamp(const ocio::ConstTransformRcPtr& transform, Part* part) {
  const auto range = ocio::DynamicPtrCast<const ocio::RangeTransform>(transform);
  if (!range || !is_forward(*range) || range->getStyle() != ocio::RANGE_CLAMP) return false;
  part->low = -FLT_MAX;
  part->high = FLT_MAX;
  if (range->hasMinInValue()) {
    if (range->getMinInValue() != range->getMinOutValue()) return false;
    part->low = static_cast<float>(range->getMinInValue());
  }
  if (range->hasMaxInValue()) {
    if (range->getMaxInValue() != range->getMaxOutValue()) return false;
    part->high = static_cast<float>(range->getMaxInValue());
  }
  part->kind = PartKind::kClamp;
  return part->low <= part->high;
}

void set_surround(const float (&luminance)[3], float floor, double gamma, Part* part) {
  part->kind = PartKind::kSurround;
  for (int c = 0; c < 3; ++c) part->luminance[c] = luminance[c];
  part->floor = floor;
  part->exponent = static_cast<float>(gamma) - 1.0f;
}

/// ACES modules: Academy TB-2014-004 and the ACES 1.0 reference code; surround of HLG: ITU-R BT.2100, table 5.
bool read_fixed_function(const ocio::ConstTransformRcPtr& transform, Part* part) {
  const auto fixed = ocio::DynamicPtrCast<const ocio::FixedFunctionTransform>(transform);
  if (!fixed) return false;
  const bool forward = is_forward(*fixed);
  static const float kAp1[3] = {0.272228718f, 0.674081743f, 0.0536895171f};
  static const float kRec2020[3] = {0.2627f, 0.6780f, 0.0593f};
  switch (fixed->getStyle()) {
    case ocio::FIXED_FUNCTION_ACES_GLOW_10: part->kind = PartKind::kGlow; return forward;
    case ocio::FIXED_FUNCTION_ACES_RED_MOD_10: part->kind = PartKind::kRedModifier; return forward;
    case ocio::FIXED_FUNCTION_ACES_DARK_TO_DIM_10:
      set_surround(kAp1, 1e-10f, forward ? 0.9811 : 1 / 0.9811, part);
      return true;
    case ocio::FIXED_FUNCTION_REC2100_SURROUND: {
      if (fixed->getNumParams() != 1) return false;
      double gamma;
      fixed->getParams(&gamma);
      set_surround(kRec2020, 1e-4f, forward ? gamma : 1 / gamma, part);
      return true;
    }
    default: return false;
  }
}

bool read_lut3d(const ocio::ConstTransformRcPtr& transform, Part* part) {
  const auto lut = ocio::DynamicPtrCast<const ocio::Lut3DTransform>(transform);
  if (!lut || !is_forward(*lut) || lut->getGridSize() < 2) return false;
  part->grid = static_cast<unsigned>(lut->getGridSize());
  part->tetrahedral =
      lut->getInterpolation() == ocio::INTERP_TETRAHEDRAL || lut->getInterpolation() == ocio::INTERP_BEST;
  part->nodes.resize(size_t{4} * part->grid * part->grid * part->grid);
  float* node = part->nodes.data();
  for (unsigned r = 0; r < part->grid; ++r) {
    for (unsigned g = 0; g < part->grid; ++g) {
      for (unsigned b = 0; b < part->grid; ++b, node += 4) lut->getValue(r, g, b, node[0], node[1], node[2]);
    }
  }
  part->kind = PartKind::kLut3d;
  return true;
}

/// Reads transforms one by one and joins neighbours that are curves.
class Splitter {
 public:
  explicit Splitter(ocio::ConstConfigRcPtr config) : config_(std::move(config)) {}

  void add(const ocio::TransformRcPtr& transform) {
    const auto cdl = ocio::DynamicPtrCast<const ocio::CDLTransform>(transform);
    const auto grading = ocio::DynamicPtrCast<const ocio::GradingPrimaryTransform>(transform);
    if (cdl && is_forward(*cdl)) return add_cdl(*cdl);
    if (grading && is_forward(*grading)) return add_grading(*grading);
    add_single(transform);
  }

  std::vector<Part> finish() {
    finish_run();
    return std::move(parts_);
  }

 private:
  /// Slope, offset and power of each channel; saturation; a clamp in one of the styles: ASC CDL 1.2.
  void add_cdl(const ocio::CDLTransform& cdl) {
    const auto power = ocio::DynamicPtrCast<ocio::CDLTransform>(cdl.createEditableCopy());
    power->setSat(1.0);
    add_single(power);
    double luminance[3];
    cdl.getSatLumaCoefs(luminance);
    add_saturation(cdl.getSat(), luminance);
    if (cdl.getStyle() == ocio::CDL_ASC) add_clamp(0.0, 1.0);
  }

  /// Curves of each channel, saturation, a clamp.
  void add_grading(const ocio::GradingPrimaryTransform& grading) {
    ocio::GradingPrimary values = grading.getValue();
    const double saturation = values.m_saturation, black = values.m_clampBlack, white = values.m_clampWhite;
    const auto curves = ocio::DynamicPtrCast<ocio::GradingPrimaryTransform>(grading.createEditableCopy());
    values.m_saturation = 1.0;
    values.m_clampBlack = ocio::GradingPrimary::NoClampBlack();
    values.m_clampWhite = ocio::GradingPrimary::NoClampWhite();
    curves->setValue(values);
    add_single(curves);
    static const double kRec709[3] = {0.2126, 0.7152, 0.0722};
    add_saturation(saturation, kRec709);
    add_clamp(black, white);
  }

  void add_saturation(double saturation, const double (&luminance)[3]) {
    if (saturation == 1.0) return;
    Part part;
    part.kind = PartKind::kMatrix;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        part.matrix[row][column] = (1.0 - saturation) * luminance[column] + (row == column ? saturation : 0.0);
      }
    }
    add_part(std::move(part));
  }

  void add_clamp(double low, double high) {
    Part part;
    part.kind = PartKind::kClamp;
    part.low = static_cast<float>(std::max<double>(low, -FLT_MAX));
    part.high = static_cast<float>(std::min<double>(high, FLT_MAX));
    add_part(std::move(part));
  }

  void add_part(Part part) {
    finish_run();
    parts_.push_back(std::move(part));
  }

  void add_single(const ocio::TransformRcPtr& transform) {
    Part part;
    const bool known = read_matrix(transform, &part) || read_clamp(transform, &part) ||
                       read_fixed_function(transform, &part) || read_lut3d(transform, &part);
    if (!known) part.kind = PartKind::kOther;
    const bool crosses = config_->getProcessor(transform)->hasChannelCrosstalk();
    const bool scales = part.kind == PartKind::kMatrix && !crosses;
    if (scales || (!known && !crosses)) return add_to_run(transform);
    add_part(std::move(part));
  }

  void add_to_run(const ocio::TransformRcPtr& transform) {
    if (!run_) run_ = ocio::GroupTransform::Create();
    run_->appendTransform(transform);
  }

  void finish_run() {
    if (!run_) return;
    Part part;
    part.kind = PartKind::kCurve;
    part.transform = std::make_shared<OcioTransform>(config_->getProcessor(run_));
    parts_.push_back(std::move(part));
    run_.reset();
  }

  ocio::ConstConfigRcPtr config_;
  std::vector<Part> parts_;
  ocio::GroupTransformRcPtr run_;  // curves not yet in parts_
};

}  // namespace

std::vector<Part> split_processor(const ocio::ConstConfigRcPtr& config, const ocio::ConstProcessorRcPtr& processor) {
  const auto group = processor->getOptimizedProcessor(ocio::OPTIMIZATION_DEFAULT)->createGroupTransform();
  Splitter splitter(config);
  for (int i = 0; i < group->getNumTransforms(); ++i) splitter.add(group->getTransform(i));
  return splitter.finish();
}

}  // namespace shd::color
