// SPDX-License-Identifier: MIT
// The table of the models.

#if defined(SHD_MATERIAL_MODELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_MODELS_INL_H_
#undef SHD_MATERIAL_MODELS_INL_H_
#else
#define SHD_MATERIAL_MODELS_INL_H_
#endif

#include "material/blinn_phong-inl.h"
#include "material/blinn_phong_normalized-inl.h"
#include "material/clear_coat-inl.h"
#include "material/combined-inl.h"
#include "material/glass-inl.h"
#include "material/gooch-inl.h"
#include "material/lambert-inl.h"
#include "material/matcap-inl.h"
#include "material/metallic_roughness-inl.h"
#include "material/phong-inl.h"
#include "material/show_barycentrics-inl.h"
#include "material/show_level-inl.h"
#include "material/show_normal-inl.h"
#include "material/show_uv-inl.h"
#include "material/toon-inl.h"
#include "material/unlit-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A model or a debug view, and its key.
template <auto kName, class Struct>
struct ModelRow {
  static constexpr ModelKey kModel = key_of(kName);
  using Model = Struct;
};

template <class... Rows>
struct ModelTable {};

/// Every model except SHD_MODEL_PROGRAM, which has no reflectance of its own, and every debug view. A new model is one
/// file and one row.
// clang-format off
using Models = ModelTable<
    ModelRow<SHD_MODEL_LAMBERT, Lambert>,
    ModelRow<SHD_MODEL_BLINN_PHONG, BlinnPhong>,
    ModelRow<SHD_MODEL_UNLIT, Unlit>,
    ModelRow<SHD_MODEL_PHONG, Phong>,
    ModelRow<SHD_MODEL_BLINN_PHONG_NORMALIZED, BlinnPhongNormalized>,
    ModelRow<SHD_MODEL_COMBINED, Combined>,
    ModelRow<SHD_MODEL_GOOCH, Gooch>,
    ModelRow<SHD_MODEL_TOON, Toon>,
    ModelRow<SHD_MODEL_METALLIC_ROUGHNESS, MetallicRoughness>,
    ModelRow<SHD_MODEL_MATCAP, Matcap>,
    ModelRow<SHD_MODEL_GLASS, Glass>,
    ModelRow<ModelKey::kClearCoat, ClearCoat>,
    ModelRow<SHD_DEBUG_VIEW_NORMAL, ShowNormal>,
    ModelRow<SHD_DEBUG_VIEW_UV, ShowUv>,
    ModelRow<SHD_DEBUG_VIEW_LEVEL, ShowLevel>,
    ModelRow<SHD_DEBUG_VIEW_BARYCENTRICS, ShowBarycentrics>>;
// clang-format on

template <class Visit, class... Rows>
HWY_INLINE void VisitRow(ModelKey model, const Visit& visit, ModelTable<Rows...>) {
  (void)((Rows::kModel == model ? (visit(typename Rows::Model()), true) : false) || ...);
}

/// Calls visit(Model()) with the struct of a model.
template <class Visit>
HWY_INLINE void VisitModel(ModelKey model, const Visit& visit) {
  VisitRow(model, visit, Models());
}

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_MODELS_INL_H_
