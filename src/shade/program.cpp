// SPDX-License-Identifier: MIT
#include "shade/program.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>

#include "core/status.h"

namespace shd::shade {
namespace {

/// Runs the caller's code and turns its exceptions into a Failure.
template <class Body>
void call(const DrawShading& shading, const char* name, const Body& body) {
  try {
    body();
  } catch (const std::exception& error) {
    core::refuse(SHD_ERROR_CALLBACK, "%s threw in render.draws[%u]: %s", name, shading.draw, error.what());
  } catch (...) {
    core::refuse(SHD_ERROR_CALLBACK, "%s threw in render.draws[%u]", name, shading.draw);
  }
}

void require_count(const DrawShading& shading, const char* name, size_t got, size_t expected) {
#ifndef NDEBUG
  if (got != expected) {
    core::refuse(SHD_ERROR_CALLBACK, "%s changed the count in render.draws[%u]", name, shading.draw);
  }
#else
  static_cast<void>(shading), static_cast<void>(name), static_cast<void>(got), static_cast<void>(expected);
#endif
}

}  // namespace

void make_inputs(const DrawShading& shading, const raster::Fragments& f, const raster::Varyings& varyings,
                 ProgramInputs* out) {
  shd_fragments& in = out->fragments;
  in = {};
  in.struct_size = sizeof in;
  in.draw = shading.draw;
  in.count = f.count;
  in.x = f.x, in.y = f.y, in.depth = f.depth;
  in.px = f.px, in.py = f.py, in.pz = f.pz;
  in.nx = f.nx, in.ny = f.ny, in.nz = f.nz;
  in.ox = f.ox, in.oy = f.oy, in.oz = f.oz;
  in.u = f.u, in.v = f.v;
  in.dudx = f.dudx, in.dvdx = f.dvdx, in.dudy = f.dudy, in.dvdy = f.dvdy;
  in.triangle = f.triangle;
  in.instance = shading.instance;
  in.uniforms = shading.uniforms;
  in.varying_count = shading.material->varying_count;
  in.varying = varyings.column;
  in.tx = f.tx, in.ty = f.ty, in.tz = f.tz, in.tw = f.tw;
  in.u1 = f.u1, in.v1 = f.v1;
  for (uint32_t c = 0; c < SHD_MAX_ATTRIBUTES; ++c) {
    out->attribute[c] = shading.vertices->has_attribute[c] ? f.attribute[c] : nullptr;
  }
  in.attribute = out->attribute;
  in.attribute_count = SHD_MAX_ATTRIBUTES;
}

void run_program(const DrawShading& shading, const raster::Fragments& f, const raster::Varyings& varyings,
                 uint32_t* discard, Radiance* radiance) {
  for (int c = 0; c < 4; ++c) std::fill_n(radiance->channel[c], f.count, c == 3 ? 1.0f : 0.0f);
  clear_targets(f.count, radiance);
  shd_radiance out = {};
  out.struct_size = sizeof out;
  out.r = radiance->channel[0], out.g = radiance->channel[1], out.b = radiance->channel[2];
  out.a = radiance->channel[3];
  float* target[kMaxTargets - 1][4];
  std::memcpy(target, radiance->channel + 4, sizeof target);
  out.target = target;
  out.target_count = kMaxTargets - 1;
  if (shading.material->flags & SHD_MATERIAL_DISCARDS) {
    std::memset(discard, 0, f.count * sizeof(uint32_t));
    out.discard = discard;
  }
  ProgramInputs inputs;
  make_inputs(shading, f, varyings, &inputs);
  const shd_fragments& in = inputs.fragments;
  const shd_material_program& program = shading.material->program;
  call(shading, "material.program.fragment", [&] { program.fragment(&in, &out, program.user_data); });
  require_count(shading, "material.program.fragment", in.count, f.count);
}

void call_procedure(const DrawShading& shading, const shd_fragments& in, const material::Slot& slot,
                    float* const out[4]) {
  char name[40];
  std::snprintf(name, sizeof name, "material.slots[%u].procedure", slot.index);
  const size_t count = in.count;
  call(shading, name, [&] { slot.procedure(&in, out, slot.user_data); });
  require_count(shading, name, in.count, count);
}

void clear_targets(size_t count, Radiance* radiance) {
  for (uint32_t c = 4; c < 4 * kMaxTargets; ++c) {
    if (radiance->channel[c]) std::memset(radiance->channel[c], 0, count * sizeof(float));
  }
}

}  // namespace shd::shade
