// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/ewa.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/ewa-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

size_t RunEwa(const FilterCall& call) {
  return Run<Ewa>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
