// SPDX-License-Identifier: MIT
// For the files that include OpenColorIO.
#pragma once

#include <vector>

#include <OpenColorIO/OpenColorIO.h>

#include "color/parts.h"

namespace shd::color {

/// A processor as OpenColorIO runs it.
class OcioTransform final : public Transform {
 public:
  explicit OcioTransform(const OCIO_NAMESPACE::ConstProcessorRcPtr& processor)
      : cpu_(processor->getDefaultCPUProcessor()) {}
  void apply(float* r, float* g, float* b, size_t count) const override {
    OCIO_NAMESPACE::PlanarImageDesc planes(r, g, b, nullptr, static_cast<long>(count), 1);
    cpu_->apply(planes);
  }

 private:
  OCIO_NAMESPACE::ConstCPUProcessorRcPtr cpu_;
};

/// The parts of a processor. OpenColorIO's exceptions pass through.
std::vector<Part> split_processor(const OCIO_NAMESPACE::ConstConfigRcPtr& config,
                                  const OCIO_NAMESPACE::ConstProcessorRcPtr& processor);

}  // namespace shd::color
