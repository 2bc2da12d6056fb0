// SPDX-License-Identifier: MIT
// Memory that is lent to a pipe and used again: never the bytes that the pipe may still refer to, and not more memory
// than the pipe and two pieces need.
#include "io/server/memory.h"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <thread>
#include <vector>

#include "support/check.h"

namespace {

using shd::io::LentRing;

uint32_t next_random(uint32_t* state) {
  *state = *state * 1664525u + 1013904223u;
  return *state >> 8;
}

struct Piece {
  unsigned char* bytes;
  size_t size;
};

/// Sizes of the pieces of a case, below or above the capacity.
struct Sizes {
  const char* name;
  size_t capacity, least, most;
};

const Sizes kSizes[] = {
    {"small", 65536, 1, 5000},         {"page", 65536, 4096, 4096},     {"mixed", 65536, 1, 40000},
    {"capacity", 65536, 65536, 65536}, {"large", 65536, 60000, 200000}, {"default", 1 << 20, 1, 260000},
};

/// Part of a pipe's capacity that a piece takes: whole places of a page each.
size_t places_of(size_t size) {
  return (size + 4095) / 4096 * 4096;
}

/// A reader that is as slow as the pipe allows: what was lent last is still in it, up to the capacity.
void test_distance(void** state) {
  const Sizes& sizes = *static_cast<const Sizes*>(*state);
  LentRing ring(sizes.capacity);
  std::deque<Piece> lent;  // the first one may be in part
  size_t held = 0;
  uint32_t random = 5;
  unsigned char *low = nullptr, *high = nullptr;
  size_t largest = 0;
  for (int i = 0; i < 4000; ++i) {
    const size_t span = sizes.most - sizes.least + 1;
    const size_t size = i == 0 ? sizes.most : sizes.least + next_random(&random) % span;
    unsigned char* const room = ring.room(size);
    for (size_t k = 0; k < lent.size(); ++k) {
      const Piece& piece = lent[k];
      assert_true(room + size <= piece.bytes || room >= piece.bytes + piece.size);
    }
    lent.push_back({room, places_of(size)});
    held += places_of(size);
    while (held > sizes.capacity) {
      Piece& first = lent.front();
      const size_t gone = std::min(first.size, held - sizes.capacity);
      first = {first.bytes + gone, first.size - gone};
      held -= gone;
      if (first.size == 0) lent.pop_front();
    }
    low = low ? std::min(low, room) : room;
    high = std::max(high, room + size);
    largest = std::max(largest, size);
  }
  assert_true(static_cast<size_t>(high - low) <= sizes.capacity + 2 * (largest + 4096));
}

/// Pieces that grow: each one is larger than all before it.
void test_growth(void**) {
  LentRing ring(65536);
  std::vector<Piece> all;
  for (size_t size = 1000; size < 1000000; size = size * 5 / 4) {
    const Piece piece = {ring.room(size), size};
    size_t later = 0;  // places of the pieces after `other`
    for (size_t k = all.size(); k-- > 0; later += places_of(all[k].size)) {
      const Piece& other = all[k];
      if (later >= 65536) break;
      assert_true(piece.bytes + size <= other.bytes || piece.bytes >= other.bytes + other.size);
    }
    std::fill(piece.bytes, piece.bytes + size, static_cast<unsigned char>(1));
    all.push_back(piece);
  }
}

unsigned char value_at(size_t i) {
  return static_cast<unsigned char>((i * 2654435761u) >> 24);
}

void lend_pieces(int pipe, size_t total) {
  const int capacity = fcntl(pipe, F_GETPIPE_SZ);
  assert_true(capacity > 0);
  LentRing ring(static_cast<size_t>(capacity));
  uint32_t random = 9;
  for (size_t at = 0; at < total;) {
    const size_t size = std::min<size_t>(total - at, 1 + next_random(&random) % 100000);
    unsigned char* const room = ring.room(size);
    for (size_t i = 0; i < size; ++i) room[i] = value_at(at + i);
    for (size_t done = 0; done < size;) {
      const iovec part = {room + done, size - done};
      const ssize_t put = vmsplice(pipe, &part, 1, 0);
      assert_true(put > 0);
      done += static_cast<size_t>(put);
    }
    at += size;
  }
}

/// A real pipe, and a reader that stops after random amounts so that the pipe is full most of the time.
void test_pipe(void**) {
  int ends[2];
  assert_int_equal(pipe2(ends, O_CLOEXEC), 0);
  const size_t total = size_t{1} << 25;
  std::thread writer([&] { lend_pieces(ends[1], total); });
  std::vector<unsigned char> bytes(70000);
  uint32_t random = 3;
  size_t wrong = 0, at = 0;
  while (at < total) {
    const size_t size = std::min<size_t>(total - at, 1 + next_random(&random) % bytes.size());
    const ssize_t got = read(ends[0], bytes.data(), size);
    assert_true(got > 0);
    for (size_t i = 0; i < static_cast<size_t>(got); ++i) wrong += bytes[i] != value_at(at + i);
    at += static_cast<size_t>(got);
    if (next_random(&random) % 8 == 0) (void)usleep(1000);
  }
  writer.join();
  assert_int_equal(wrong, 0);
  (void)close(ends[0]);
  (void)close(ends[1]);
}

}  // namespace

int main() {
  std::vector<CMUnitTest> tests;
  for (const Sizes& sizes : kSizes)
    tests.push_back({sizes.name, test_distance, nullptr, nullptr, const_cast<Sizes*>(&sizes)});
  tests.push_back({"growth", test_growth, nullptr, nullptr, nullptr});
  tests.push_back({"pipe", test_pipe, nullptr, nullptr, nullptr});
  return _cmocka_run_group_tests("unit.io.lent_ring", tests.data(), tests.size(), nullptr, nullptr);
}
