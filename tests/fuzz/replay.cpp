// SPDX-License-Identifier: MIT
// Runs a fuzz target without libFuzzer: on files, or on seeded random input.
//   fuzz_lookup [iterations [seed]]    fuzz_lookup file...
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

/// Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators" (2014), as splitmix64.
uint64_t next_random(uint64_t& state) {
  uint64_t z = state += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

bool replay_file(const char* path) {
  std::FILE* file = std::fopen(path, "rb");
  if (!file) return false;
  std::vector<uint8_t> bytes;
  for (int c; (c = std::fgetc(file)) != EOF;) bytes.push_back(static_cast<uint8_t>(c));
  std::fclose(file);
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  return true;
}

void replay_random(uint64_t iterations, uint64_t seed) {
  std::vector<uint8_t> bytes;
  for (uint64_t i = 0; i < iterations; ++i) {
    uint64_t state = seed * 0x100000001b3u + i;  // each iteration can be replayed alone
    bytes.resize(next_random(state) % 16384);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(next_random(state));
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("%llu inputs of seed %llu\n", static_cast<unsigned long long>(iterations),
              static_cast<unsigned long long>(seed));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && !std::isdigit(static_cast<unsigned char>(argv[1][0]))) {
    for (int i = 1; i < argc; ++i) {
      if (!replay_file(argv[i])) return 1;
    }
    return 0;
  }
  replay_random(argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000,
                argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  return 0;
}
