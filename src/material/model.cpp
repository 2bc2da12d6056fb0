// SPDX-License-Identifier: MIT
#include "material/model.h"

#include <hwy/highway.h>

#include "material/models-inl.h"

namespace shd::material {
namespace {

namespace target = HWY_NAMESPACE;

template <class... Rows>
constexpr shd_model last_of(target::ModelTable<Rows...>) {
  shd_model last = SHD_MODEL_PROGRAM;
  ((last = Rows::kModel > last ? Rows::kModel : last), ...);
  return last;
}
constexpr shd_model kLastModel = last_of(target::Models());

struct ModelInfos {
  ModelInfo of[kLastModel + 1];
};

template <class Model>
constexpr ModelInfo make_info() {
  using Lighting = typename Model::Lighting;
  using Shape = typename Lighting::Shape;
  static_assert(Lighting::kLobes <= kMaxLobes && Shape::kColumns <= kMaxShapeColumns,
                "columns of shade/ hold all models");
  return {Model::kSlots,        Lighting::kLobes,    Shape::kSlots,     Shape::kColumns,
          Model::kShownColumns, Lighting::kNeedsEye, Model::kHasNormal, Lighting::kIgnoresIrradiance};
}

template <class... Rows>
constexpr ModelInfos make_infos(target::ModelTable<Rows...>) {
  ModelInfos infos = {};
  ((infos.of[Rows::kModel] = make_info<typename Rows::Model>()), ...);
  return infos;
}
constexpr ModelInfos kInfos = make_infos(target::Models());

}  // namespace

const ModelInfo& info_of(shd_model model) {
  return kInfos.of[model];
}

shd_model last_model() {
  return kLastModel;
}

void show(const ShowInputs& in, float* const out[3]) {
  target::VisitModel(in.material.model, [&](auto model) { model.Show(in, out); });
}

}  // namespace shd::material
