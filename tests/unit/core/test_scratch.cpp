// SPDX-License-Identifier: MIT
// Working memory that is kept between calls: blocks never overlap, equal calls allocate nothing, and memory goes back.
#include "core/scratch.h"

#include <vector>

#include "support/check.h"
#include "support/fault_allocator.h"

namespace {

using shd::core::Allocator;
using shd::core::Scratch;

struct Host {
  shd_fault_allocator memory = {};
  Allocator allocator() { return {{shd_fault_allocate, shd_fault_free, &memory}}; }
};

struct Block {
  unsigned char* bytes;
  size_t size;
  unsigned char value;
};

uint32_t next_random(uint32_t* state) {
  *state = *state * 1664525u + 1013904223u;
  return *state >> 8;
}

/// Sizes around every step between two classes, and around the limit of small blocks.
size_t random_size(uint32_t* state) {
  const size_t base = size_t{1} << (next_random(state) % 20);
  const size_t size = base + base / 8 * (next_random(state) % 8);
  return size + next_random(state) % 3;
}

Block take(Scratch* scratch, size_t size, unsigned char value) {
  auto* bytes = static_cast<unsigned char*>(scratch->allocate(size));
  assert_non_null(bytes);
  assert_int_equal(reinterpret_cast<uintptr_t>(bytes) % shd::core::kAlignment, 0);
  memset(bytes, value, size);
  return {bytes, size, value};
}

void give(Scratch* scratch, const Block& block) {
  for (size_t i = 0; i < block.size; ++i) {
    if (block.bytes[i] != block.value) fail_msg("byte %zu of a block of %zu changed", i, block.size);
  }
  scratch->free(block.bytes, block.size);
}

/// A call with many blocks that live at the same time and end in any order.
void call(Scratch* scratch, uint32_t seed) {
  std::vector<Block> blocks;
  scratch->begin();
  for (uint32_t i = 0; i < 400; ++i) {
    if (blocks.size() > 20 && next_random(&seed) % 2) {
      const size_t k = next_random(&seed) % blocks.size();
      give(scratch, blocks[k]);
      blocks[k] = blocks.back();
      blocks.pop_back();
    }
    blocks.push_back(take(scratch, random_size(&seed), static_cast<unsigned char>(i)));
  }
  for (const Block& block : blocks) give(scratch, block);
  scratch->end();
}

void test_equal_calls(void**) {
  Host host;
  {
    Scratch scratch(host.allocator(), true);
    call(&scratch, 5);
    const size_t calls = host.memory.calls, bytes = host.memory.live_bytes;
    assert_int_equal(scratch.peak(), bytes);
    assert_int_equal(host.memory.peak_bytes, bytes);
    for (int i = 0; i < 40; ++i) call(&scratch, 5);
    assert_int_equal(host.memory.calls, calls);
    assert_int_equal(host.memory.live_bytes, bytes);
    for (uint32_t seed = 6; seed < 30; ++seed) call(&scratch, seed);
  }
  shd_assert_all_freed("equal_calls", &host.memory);
}

void test_nothing_kept(void**) {
  Host host;
  Scratch scratch(host.allocator(), false);
  call(&scratch, 5);
  assert_int_equal(host.memory.calls, 400);
  assert_int_equal(scratch.peak(), host.memory.peak_bytes);
  shd_assert_all_freed("nothing_kept", &host.memory);
}

/// Every size takes less than an eighth more, beyond the smallest block.
void test_rounding(void**) {
  Host host;
  Scratch scratch(host.allocator(), true);
  for (size_t size = 16385; size < (size_t{1} << 26); size += size / 7 + 1) {
    const size_t before = host.memory.live_bytes;
    give(&scratch, take(&scratch, size, 1));
    const size_t taken = host.memory.live_bytes - before;
    if (taken < size || 8 * (taken - size) >= size) fail_msg("%zu bytes for %zu", taken, size);
  }
}

/// If the host has no memory, free blocks go back to it before the allocation fails.
void test_no_memory(void**) {
  Host host;
  {
    Scratch scratch(host.allocator(), true);
    scratch.begin();
    give(&scratch, take(&scratch, 100000, 1));
    shd_fault_arm(&host.memory, 1, 0);
    const Block block = take(&scratch, 200000, 2);  // the first request fails, the second one does not
    assert_int_equal(host.memory.calls, 2);
    assert_int_equal(host.memory.live_blocks, 1);
    shd_fault_arm(&host.memory, 1, 1);
    assert_null(scratch.allocate(300000));
    assert_null(scratch.allocate(1));
    shd_fault_arm(&host.memory, 0, 0);
    give(&scratch, block);
    scratch.end();
    assert_int_equal(host.memory.live_bytes, 0);
    call(&scratch, 8);
  }
  shd_assert_all_freed("no_memory", &host.memory);
}

/// Sixteen calls in a row that need less than a quarter return the memory; a large call in between keeps it.
void test_small_calls(void**) {
  Host host;
  Scratch scratch(host.allocator(), true);
  const auto use = [&](size_t size) {
    scratch.begin();
    give(&scratch, take(&scratch, size, 3));
    scratch.end();
  };
  use(1000000);
  for (int i = 0; i < 15; ++i) use(100000);
  use(1000000);
  for (int i = 0; i < 15; ++i) use(100000);
  assert_true(host.memory.live_bytes > 1000000);
  use(100000);
  assert_int_equal(host.memory.live_bytes, 0);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      {"equal_calls", test_equal_calls, nullptr, nullptr, nullptr},
      {"nothing_kept", test_nothing_kept, nullptr, nullptr, nullptr},
      {"rounding", test_rounding, nullptr, nullptr, nullptr},
      {"no_memory", test_no_memory, nullptr, nullptr, nullptr},
      {"small_calls", test_small_calls, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.core.scratch", tests, sizeof tests / sizeof tests[0], nullptr, nullptr);
}
