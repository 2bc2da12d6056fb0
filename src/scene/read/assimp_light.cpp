// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <assimp/camera.h>
#include <assimp/light.h>
#include <assimp/scene.h>

#include "scene/read/assimp_parts.h"

namespace shd::scene {
namespace {

constexpr int kMaxParents = 1024;

bool copy_finite(const aiVector3D& from, float* out) {
  for (unsigned c = 0; c < 3; ++c) out[c] = from[c];
  return std::isfinite(from.x) && std::isfinite(from.y) && std::isfinite(from.z);
}

aiVector3D turned(const aiMatrix4x4& m, const aiVector3D& v) {
  return {m.a1 * v.x + m.a2 * v.y + m.a3 * v.z, m.b1 * v.x + m.b2 * v.y + m.b3 * v.z,
          m.c1 * v.x + m.c2 * v.y + m.c3 * v.z};
}

bool is_zero(const aiVector3D& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

/// Returns the factor of the light's colours. shd's lights decrease with the square of the distance. With this factor
/// they equal the file's light at every distance if it decreases in the same way, else at the distance `radius`.
double strength_of(const aiLight& light, double radius) {
  const double a = static_cast<double>(light.mAttenuationConstant), b = static_cast<double>(light.mAttenuationLinear),
               c = static_cast<double>(light.mAttenuationQuadratic);
  const double fall = a + b * radius + c * radius * radius;
  if (!(fall > 0.0)) return 1.0;
  return a == 0.0 && b == 0.0 ? 1.0 / c : radius * radius / fall;
}

/// glTF's inner and outer angles are half angles of the cone. The angles of other formats are read in the same way.
void set_cone(const aiLight& light, shd_light_desc& desc) {
  const float outer = light.mAngleOuterCone;
  if (std::isfinite(outer)) desc.outer_angle = std::clamp(outer, 0.001f, 1.5707963f);
  const float inner = light.mAngleInnerCone;
  desc.inner_angle = std::isfinite(inner) ? std::clamp(inner, 0.0f, desc.outer_angle) : 0.0f;
}

bool kind_of(const aiLight& light, shd_light_kind* kind) {
  switch (light.mType) {
    case aiLightSource_DIRECTIONAL: *kind = SHD_LIGHT_KIND_DIRECTIONAL; return true;
    case aiLightSource_POINT: *kind = SHD_LIGHT_KIND_POINT; return true;
    case aiLightSource_SPOT: *kind = SHD_LIGHT_KIND_SPOT; return true;
    case aiLightSource_AMBIENT: *kind = SHD_LIGHT_KIND_AMBIENT; return true;
    default: return false;
  }
}

/// Returns false if a number of the light is not usable.
bool set_light(const aiLight& light, const aiMatrix4x4& world, double radius, shd_light_desc& desc) {
  const bool is_ambient = desc.kind == SHD_LIGHT_KIND_AMBIENT, is_far = desc.kind == SHD_LIGHT_KIND_DIRECTIONAL;
  const double strength = is_ambient || is_far ? 1.0 : strength_of(light, radius);
  const aiColor3D& color = is_ambient && light.mColorDiffuse.IsBlack() ? light.mColorAmbient : light.mColorDiffuse;
  const float channels[3] = {color.r, color.g, color.b};
  for (int c = 0; c < 3; ++c) {
    desc.intensity[c] = static_cast<float>(static_cast<double>(channels[c]) * strength);
    if (!(desc.intensity[c] >= 0.0f && desc.intensity[c] <= 1e12f)) return false;
  }
  if (is_ambient) return true;
  if (!is_far && !copy_finite(world * light.mPosition, desc.position)) return false;
  if (desc.kind == SHD_LIGHT_KIND_POINT) return true;
  const aiVector3D direction = turned(world, light.mDirection);
  if (desc.kind == SHD_LIGHT_KIND_SPOT) set_cone(light, desc);
  return copy_finite(direction, desc.direction) && !is_zero(direction);
}

/// Vertical field of view of a camera, or 0 if it has no usable one.
float fov_of(const aiCamera& camera, float aspect) {
  const float fov = 2.0f * std::atan(std::tan(0.5f * camera.mHorizontalFOV) / aspect);
  return fov > 1e-3f && fov < 3.14f ? fov : 0.0f;
}

bool set_camera(const aiCamera& from, const aiMatrix4x4& world, shd_camera& camera) {
  const float aspect = from.mAspect > 1e-3f && from.mAspect < 1e3f ? from.mAspect : 0.0f;
  camera.fov_y = fov_of(from, aspect > 0.0f ? aspect : 1.0f);
  camera.aspect = aspect;
  camera.near_plane = std::isfinite(from.mClipPlaneNear) ? std::max(from.mClipPlaneNear, 0.0f) : 0.0f;
  camera.far_plane = std::isfinite(from.mClipPlaneFar) ? std::max(from.mClipPlaneFar, 0.0f) : 0.0f;
  const aiVector3D eye = world * from.mPosition, ahead = turned(world, from.mLookAt);
  return camera.fov_y > 0.0f && !is_zero(ahead) && copy_finite(eye, camera.eye) &&
         copy_finite(eye + aiVector3D(ahead).Normalize(), camera.target) &&
         copy_finite(turned(world, from.mUp), camera.up);
}

}  // namespace

aiMatrix4x4 world_of(const aiScene& scene, const std::string& name) {
  aiMatrix4x4 world;
  int depth = 0;
  for (const aiNode* at = scene.mRootNode->FindNode(name.c_str()); at && depth < kMaxParents;
       at = at->mParent, ++depth) {
    world = at->mTransformation * world;
  }
  return world;
}

void add_lights(const aiScene& scene, double radius, Model& model) {
  for (unsigned i = 0; i < scene.mNumLights; ++i) {
    const aiLight& light = *scene.mLights[i];
    const aiMatrix4x4 world = world_of(scene, light.mName.C_Str());
    NamedLight made = {text_of(light.mName.C_Str()), shd_light_desc_default()};
    if (!kind_of(light, &made.desc.kind)) {
      model.warnings.push_back("light \"" + made.name + "\": its kind is not supported");
    } else if (!set_light(light, world, radius, made.desc)) {
      model.warnings.push_back("light \"" + made.name + "\": its numbers are out of range");
    } else {
      model.lights.push_back(std::move(made));
    }
  }
}

void add_cameras(const aiScene& scene, Model& model) {
  for (unsigned i = 0; i < scene.mNumCameras; ++i) {
    const aiCamera& camera = *scene.mCameras[i];
    const aiMatrix4x4 world = world_of(scene, camera.mName.C_Str());
    NamedCamera made = {text_of(camera.mName.C_Str()), shd_camera_default()};
    if (camera.mHorizontalFOV == 0.0f && camera.mOrthographicWidth != 0.0f) {
      model.warnings.push_back("camera \"" + made.name + "\": it has no perspective");
    } else if (!set_camera(camera, world, made.camera)) {
      model.warnings.push_back("camera \"" + made.name + "\": its numbers are out of range");
    } else {
      model.cameras.push_back(std::move(made));
    }
  }
}

}  // namespace shd::scene
