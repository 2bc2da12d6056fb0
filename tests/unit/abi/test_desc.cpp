// SPDX-License-Identifier: MIT
// Structs of callers with older and newer headers.
#include "abi/desc.h"

#include "support/check.h"

namespace shd::tests {
namespace {

/// The struct in the version of the library.
struct Desc {
  uint32_t struct_size;
  uint32_t first;
  uint32_t appended;
};

/// The memory of a caller: its struct with two fields of a later version, and room behind.
struct Newer {
  Desc desc;
  uint32_t later[2];
};
struct Caller {
  Newer newer;
  uint32_t canary[2];
};

struct WriteCase {
  const char* name;
  uint32_t struct_size;
  uint32_t appended;  // its value in the struct after the call
  uint32_t later;
};
constexpr WriteCase kWriteCases[] = {
    {"write_desc/same", sizeof(Desc), 3, 77},
    {"write_desc/older", offsetof(Desc, appended), 77, 77},
    {"write_desc/newer", sizeof(Newer), 3, 0},
};

void test_write(void** state) {
  const WriteCase& c = *static_cast<const WriteCase*>(*state);
  Caller caller = {{{c.struct_size, 77, 77}, {77, 77}}, {77, 77}};
  const Desc& desc = caller.newer.desc;
  abi::write_desc(Desc{1, 2, 3}, &caller.newer.desc);
  assert_int_equal(desc.struct_size, c.struct_size);
  assert_int_equal(desc.first, 2);
  assert_int_equal(desc.appended, c.appended);
  for (uint32_t later : caller.newer.later) assert_int_equal(later, c.later);
  for (uint32_t canary : caller.canary) assert_int_equal(canary, 77);
  core::clear_desc_bytes(&caller.newer.desc);
  assert_int_equal(desc.struct_size, c.struct_size);
  assert_int_equal(desc.first, 0);
  assert_int_equal(desc.appended, c.appended == 77 ? 77 : 0);
  for (uint32_t later : caller.newer.later) assert_int_equal(later, c.later);
  for (uint32_t canary : caller.canary) assert_int_equal(canary, 77);
}

struct ReadCase {
  const char* name;
  uint32_t struct_size;
  uint32_t unknown;  // value of the bytes beyond this version
  shd_result result;
  uint32_t appended;  // value after reading; 9 = the default
  size_t alignment = alignof(Desc);
};
constexpr ReadCase kReadCases[] = {
    {"read_desc/same", sizeof(Desc), 5, SHD_OK, 3},
    {"read_desc/older", offsetof(Desc, appended), 5, SHD_OK, 9},
    {"read_desc/newer", sizeof(Newer), 0, SHD_OK, 3},
    {"read_desc/newer_and_set", sizeof(Newer), 5, SHD_ERROR_UNSUPPORTED, 9},
    {"read_desc/below_minimum", 4, 0, SHD_ERROR_INVALID_ARGUMENT, 9},
    {"read_desc/half_a_field", sizeof(Desc) - 2, 0, SHD_ERROR_INVALID_ARGUMENT, 9},
    {"read_desc/newer_half_a_field", sizeof(Newer) - 1, 0, SHD_ERROR_INVALID_ARGUMENT, 9},
    {"read_desc/half_a_pointer", sizeof(Desc), 0, SHD_ERROR_INVALID_ARGUMENT, 9, 8},
    {"read_desc/whole_pointers", sizeof(Desc) + 4, 0, SHD_OK, 3, 8},
};

void test_read(void** state) {
  const ReadCase& c = *static_cast<const ReadCase*>(*state);
  const Newer caller = {{c.struct_size, 2, 3}, {0, c.unknown}};
  Desc out = {0, 9, 9};
  const shd_result result =
      core::read_desc_bytes(core::fail, "desc", &caller, {offsetof(Desc, appended), c.alignment}, &out, sizeof out);
  assert_int_equal(result, c.result);
  assert_int_equal(out.first, result == SHD_OK ? 2 : 9);
  assert_int_equal(out.appended, c.appended);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  static CMUnitTest tests[16];
  size_t n = 0;
  for (const WriteCase& c : kWriteCases)
    tests[n++] = {c.name, test_write, nullptr, nullptr, const_cast<WriteCase*>(&c)};
  for (const ReadCase& c : kReadCases) tests[n++] = {c.name, test_read, nullptr, nullptr, const_cast<ReadCase*>(&c)};
  return _cmocka_run_group_tests("unit.abi.desc", tests, n, nullptr, nullptr);
}
