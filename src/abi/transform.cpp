// SPDX-License-Identifier: MIT
#include <shd/transform.h>

#include <cmath>
#include <cstring>

#include "abi/camera.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "data/inverse.h"
#include "data/matrix.h"
#include "data/transform.h"

namespace {

using namespace shd;
using namespace shd::abi;

/// Rounds to the caller's floats, if all of them are finite then.
shd_result round_to(const char* what, const double* from, int count, float* out) {
  float rounded[16];
  for (int i = 0; i < count; ++i) {
    rounded[i] = static_cast<float>(from[i]);
    if (!std::isfinite(rounded[i])) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: the result exceeds the range of float", what);
    }
  }
  std::memcpy(out, rounded, static_cast<size_t>(count) * sizeof *out);
  return SHD_OK;
}

/// A caller's array of finite floats.
shd_result check_array(const char* name, const float* values, size_t count) {
  SHD_TRY(check_not_null(name, values));
  return check_finite(name, values, count);
}

/// (x, y, z, w) transformed; [4].
void transform(const float* m, const float* p, double w, double* out) {
  for (int r = 0; r < 4; ++r) {
    out[r] = static_cast<double>(m[r]) * static_cast<double>(p[0]) +
             static_cast<double>(m[4 + r]) * static_cast<double>(p[1]) +
             static_cast<double>(m[8 + r]) * static_cast<double>(p[2]) + static_cast<double>(m[12 + r]) * w;
  }
}

shd_result singular() {
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "matrix: has no inverse, its columns are linearly dependent");
}

}  // namespace

extern "C" {

shd_result shd_matrix_perspective(float fov_y, float aspect, float near_plane, float far_plane, shd_depth_order order,
                                  float* out_matrix) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_matrix", out_matrix));
    SHD_TRY(check_projection("perspective", fov_y, near_plane, far_plane, true));
    SHD_TRY(check_positive("perspective", "aspect", aspect));
    SHD_TRY(check_enum("perspective.order", order, 0, SHD_DEPTH_ORDER_REVERSED));
    double matrix[16];
    data::perspective(static_cast<double>(fov_y), static_cast<double>(aspect), static_cast<double>(near_plane),
                      static_cast<double>(far_plane), order == SHD_DEPTH_ORDER_REVERSED, matrix);
    return round_to("perspective", matrix, 16, out_matrix);
  });
}

shd_result shd_matrix_orthographic(const float rectangle[4], float near_plane, float far_plane, shd_depth_order order,
                                   float* out_matrix) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_matrix", out_matrix));
    SHD_TRY(check_array("orthographic.rectangle", rectangle, 4));
    SHD_TRY(check_finite("orthographic.near_plane", &near_plane, 1));
    SHD_TRY(check_finite("orthographic.far_plane", &far_plane, 1));
    SHD_TRY(check_enum("orthographic.order", order, 0, SHD_DEPTH_ORDER_REVERSED));
    if (rectangle[0] == rectangle[1] || rectangle[2] == rectangle[3]) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "orthographic.rectangle: its %s is 0",
                        rectangle[0] == rectangle[1] ? "width" : "height");
    }
    if (!(far_plane > near_plane)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "orthographic.far_plane: %g is not above near_plane %g",
                        static_cast<double>(far_plane), static_cast<double>(near_plane));
    }
    double matrix[16];
    data::orthographic(rectangle, static_cast<double>(near_plane), static_cast<double>(far_plane),
                       order == SHD_DEPTH_ORDER_REVERSED, matrix);
    return round_to("orthographic", matrix, 16, out_matrix);
  });
}

shd_result shd_matrix_look_at(const float eye[3], const float target[3], const float up[3], float* out_matrix) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_matrix", out_matrix));
    SHD_TRY(check_not_null("look_at.eye", eye));
    SHD_TRY(check_not_null("look_at.target", target));
    SHD_TRY(check_not_null("look_at.up", up));
    float matrix[16];
    SHD_TRY(make_look_at("look_at", eye, target, up, matrix));
    for (const float element : matrix) {
      if (!std::isfinite(element)) {
        return core::fail(SHD_ERROR_INVALID_ARGUMENT, "look_at: the result exceeds the range of float");
      }
    }
    std::memcpy(out_matrix, matrix, sizeof matrix);
    return SHD_OK;
  });
}

shd_result shd_matrix_from_trs(const float translation[3], const float rotation[4], const float scale[3],
                               float* out_matrix) {
  return guard([&]() -> shd_result {
    constexpr float kNone[4] = {0.0f, 0.0f, 0.0f, 1.0f}, kOne[3] = {1.0f, 1.0f, 1.0f};
    const float *t = translation ? translation : kNone, *r = rotation ? rotation : kNone, *s = scale ? scale : kOne;
    SHD_TRY(check_not_null("out_matrix", out_matrix));
    SHD_TRY(check_finite("trs.translation", t, 3));
    SHD_TRY(check_finite("trs.rotation", r, 4));
    SHD_TRY(check_finite("trs.scale", s, 3));
    if (r[0] == 0.0f && r[1] == 0.0f && r[2] == 0.0f && r[3] == 0.0f) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "trs.rotation: (0, 0, 0, 0) is no rotation");
    }
    double matrix[16];
    data::from_trs(t, r, s, matrix);
    return round_to("trs", matrix, 16, out_matrix);
  });
}

shd_result shd_matrix_multiply(const float* a, const float* b, float* out_matrix) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_matrix", out_matrix));
    SHD_TRY(check_array("a", a, 16));
    SHD_TRY(check_array("b", b, 16));
    double product[16];
    data::multiply(a, b, product);
    return round_to("multiply", product, 16, out_matrix);
  });
}

shd_result shd_matrix_invert(const float* matrix, float* out_matrix) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_matrix", out_matrix));
    SHD_TRY(check_array("matrix", matrix, 16));
    double inverse[16];
    if (!data::invert(matrix, inverse)) return singular();
    return round_to("invert", inverse, 16, out_matrix);
  });
}

shd_result shd_matrix_normal(const float* matrix, float* out_3x3) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_3x3", out_3x3));
    SHD_TRY(check_array("matrix", matrix, 16));
    double inverse[9], transposed[9];
    if (!data::invert_linear(matrix, inverse)) return singular();
    for (int i = 0; i < 9; ++i) transposed[i] = inverse[3 * (i % 3) + i / 3];
    return round_to("normal", transposed, 9, out_3x3);
  });
}

shd_result shd_matrix_transform_point(const float* matrix, const float point[3], float* out_point) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_point", out_point));
    SHD_TRY(check_array("matrix", matrix, 16));
    SHD_TRY(check_array("point", point, 3));
    double p[4];
    transform(matrix, point, 1.0, p);
    if (p[3] == 0.0) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "point: its w after transformation is 0");
    for (int i = 0; i < 3; ++i) p[i] /= p[3];
    return round_to("point", p, 3, out_point);
  });
}

shd_result shd_matrix_transform_direction(const float* matrix, const float direction[3], float* out_direction) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_direction", out_direction));
    SHD_TRY(check_array("matrix", matrix, 16));
    SHD_TRY(check_array("direction", direction, 3));
    double d[4];
    transform(matrix, direction, 0.0, d);
    return round_to("direction", d, 3, out_direction);
  });
}

}  // extern "C"
