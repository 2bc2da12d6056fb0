// SPDX-License-Identifier: MIT
// Texts of failures: formats, places before them, and the end of long ones.
#include "core/status.h"

#include <string>

#include "support/check.h"
#undef fail  // cmocka's macro

namespace {

using shd::core::fail;
using shd::core::fail_within;
using shd::core::kErrorTextSize;
using shd::core::last_error;

void test_texts(void**) {
  assert_int_equal(fail(SHD_ERROR_IO, "%s: %d", "size", 3), SHD_ERROR_IO);
  assert_string_equal(last_error(), "size: 3");
  assert_int_equal(fail_within(SHD_ERROR_CANCELLED, "draws[%d].", 7), SHD_ERROR_CANCELLED);
  assert_string_equal(last_error(), "draws[7].size: 3");
  fail_within(SHD_ERROR_IO, "%s", "");
  assert_string_equal(last_error(), "draws[7].size: 3");
  fail(SHD_ERROR_IO, "%s", "");
  fail_within(SHD_ERROR_IO, "a: ");
  assert_string_equal(last_error(), "a: ");
}

/// Text and place of any length give the longest beginning that fits.
void test_long(void**) {
  const std::string text(kErrorTextSize + 100, 'x'), place(400, 'p');
  fail(SHD_ERROR_IO, "%s", text.c_str());
  assert_string_equal(last_error(), text.substr(0, kErrorTextSize - 1).c_str());
  fail_within(SHD_ERROR_IO, "ab");
  assert_string_equal(last_error(), ("ab" + text).substr(0, kErrorTextSize - 1).c_str());
  fail(SHD_ERROR_IO, "y");
  fail_within(SHD_ERROR_IO, "%s", place.c_str());
  assert_string_equal(last_error(), (place.substr(0, 159) + "y").c_str());
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      {"texts", test_texts, nullptr, nullptr, nullptr},
      {"long", test_long, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.core.status", tests, sizeof tests / sizeof tests[0], nullptr, nullptr);
}
