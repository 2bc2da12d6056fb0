// SPDX-License-Identifier: MIT
#include "material/model.h"

#include <hwy/highway.h>

#include "material/models-inl.h"

namespace shd::material {
namespace {

namespace target = HWY_NAMESPACE;

constexpr uint32_t row_of(ModelKey key) {
  return static_cast<uint32_t>(key);
}

template <class... Rows>
constexpr uint32_t last_of(target::ModelTable<Rows...>) {
  uint32_t last = row_of(ModelKey::kProgram);
  ((last = row_of(Rows::kModel) > last ? row_of(Rows::kModel) : last), ...);
  return last;
}

template <class... Rows>
constexpr uint32_t last_model_of(target::ModelTable<Rows...>) {
  uint32_t last = row_of(ModelKey::kProgram);
  ((last = row_of(Rows::kModel) > last && Rows::kModel < ModelKey::kFirstView ? row_of(Rows::kModel) : last), ...);
  return last;
}

struct ModelInfos {
  ModelInfo of[last_of(target::Models()) + 1];
};

template <class Model>
constexpr ModelInfo make_info() {
  using Lighting = typename Model::Lighting;
  using Shape = typename Lighting::Shape;
  static_assert(Lighting::kLobes <= kMaxLobes && Shape::kColumns <= kMaxShapeColumns,
                "columns of shade/ hold all models");
  return {Model::kSlots,
          Lighting::kLobes,
          Shape::kSlots,
          Shape::kColumns,
          Model::kShownColumns,
          Lighting::kNeedsEye,
          Model::kHasNormal,
          Lighting::kIgnoresIrradiance,
          Model::kColorsAmbient,
          Lighting::kReflectsEnvironment,
          Lighting::kEnvironmentTables};
}

template <class... Rows>
constexpr ModelInfos make_infos(target::ModelTable<Rows...>) {
  ModelInfos infos = {};
  ((infos.of[row_of(Rows::kModel)] = make_info<typename Rows::Model>()), ...);
  return infos;
}
constexpr ModelInfos kInfos = make_infos(target::Models());

}  // namespace

const ModelInfo& info_of(ModelKey model) {
  return kInfos.of[row_of(model)];
}

shd_model last_model() {
  return static_cast<shd_model>(last_model_of(target::Models()));
}

void show(const ShowInputs& in, float* const out[3]) {
  target::VisitModel(in.material.model, [&](auto model) { model.Show(in, out); });
}

}  // namespace shd::material
