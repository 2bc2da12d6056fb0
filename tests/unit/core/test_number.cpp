// SPDX-License-Identifier: MIT
// Texts that are numbers, and texts that are none.
#include "core/number.h"

#include <cmath>

#include "support/check.h"

namespace {

using shd::core::to_number;

void test_numbers(void**) {
  const std::pair<const char*, double> rows[] = {
      {"0", 0},        {"12", 12},    {"+7", 7},         {"-3", -3},          {".25", 0.25},         {"5.", 5},
      {"1.5e3", 1500}, {"2E-1", 0.2}, {"0.1", 0.1},      {"1e400", INFINITY}, {"-inf", -INFINITY},   {"1e-400", 0},
      {"0e999", 0},    {"0.0", 0},    {"INF", INFINITY}, {"1e+2", 100},       {"infinity", INFINITY}};
  for (const auto& [text, value] : rows) {
    double out = 8;
    if (!to_number(text, &out) || out != value) fail_msg("\"%s\" is %g", text, out);
  }
  double out = 8;
  assert_true(to_number("nan", &out) && std::isnan(out));
}

void test_others(void**) {
  for (const char* const text : {"", "+", "-", ".", "e5", "1e", "++1", "+-1", "--1", " 1", "1 ", "\t1", "1,5", "0x10",
                                 "1x", "one", "1\n", "1 2"}) {
    double out = 8;
    if (to_number(text, &out) || out != 8) fail_msg("\"%s\" is %g", text, out);
  }
  double out = 8;
  assert_false(to_number(std::string_view("1\0", 2), &out));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      {"numbers", test_numbers, nullptr, nullptr, nullptr},
      {"others", test_others, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.core.number", tests, sizeof tests / sizeof tests[0], nullptr, nullptr);
}
