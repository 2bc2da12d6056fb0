// SPDX-License-Identifier: MIT
#version 450
// One lookup for kInvocations neighbouring invocations; the first one stores the result. With IMPLICIT, differences
// between each four invocations are the derivatives, as in fragment shaders.
#ifdef IMPLICIT
#extension GL_NV_compute_shader_derivatives : require
#endif
layout(local_size_x = 256) in;
#ifdef IMPLICIT
layout(derivative_group_linearNV) in;
#endif
layout(constant_id = 0) const uint kInvocations = 1;
layout(constant_id = 1) const bool kLevels = true;

layout(binding = 0) uniform sampler2D image;
// u, v, du/dx, dv/dx, du/dy, dv/dy, `count` of each
layout(std430, binding = 1) readonly buffer Columns { float columns[]; };
layout(std430, binding = 2) writeonly buffer Results { vec4 rgba[]; };
layout(push_constant) uniform Constants { uint count; };

vec2 pair(uint column, uint i) { return vec2(columns[column * count + i], columns[(column + 1) * count + i]); }

void main() {
  const uint lane = gl_GlobalInvocationID.x % kInvocations;
  const uint i = gl_GlobalInvocationID.x / kInvocations;
  // No early return: the neighbours of a lookup have its differences, so that all of them have to run.
  const uint at = min(i, count - 1);
  vec2 uv = pair(0, at);
  vec4 colour;
  if (kLevels) {
    const vec2 dx = pair(2, at), dy = pair(4, at);
    if (kInvocations > 1) uv += float(lane & 1) * dx + float(lane >> 1 & 1) * dy;  // each four are 2 x 2 pixels
#ifdef IMPLICIT
    colour = texture(image, uv);
#else
    colour = textureGrad(image, uv, dx, dy);
#endif
  } else {
    colour = textureLod(image, uv, 0.0);
  }
  if (lane == 0 && i < count) rgba[i] = colour;
}
