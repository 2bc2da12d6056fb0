// SPDX-License-Identifier: MIT
#include <shd/view.h>

#include <cstring>

#include "abi/camera.h"
#include "abi/desc.h"
#include "abi/guard.h"

extern "C" shd_result shd_view_from_camera(const shd_camera* camera, shd_view* out_view) {
  using namespace shd::abi;
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_view", out_view));
    std::memset(out_view, 0, sizeof *out_view);
    return read_camera(camera, 1.0f, out_view);
  });
}
