// SPDX-License-Identifier: MIT
// Runs a fuzz target without libFuzzer: on files and folders, on mutations of them, and on seeded random input.
//   fuzz_lookup file...    fuzz_lookup iterations [seed [file...]]
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size, unsigned seed);
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace {

using Bytes = std::vector<uint8_t>;

constexpr size_t kMaxSize = 1024;

/// Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators" (2014), as splitmix64.
uint64_t next_random(uint64_t& state) {
  uint64_t z = state += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

uint64_t g_state;  // random numbers of the current iteration, for LLVMFuzzerMutate

/// Runs in a block of exactly that size, so that an address sanitizer catches every access beyond it.
void run(const Bytes& input) {
  const Bytes exact(input.begin(), input.end());
  LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

bool read_inputs(const std::filesystem::path& path, std::vector<Bytes>& inputs) {
  if (std::filesystem::is_directory(path)) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(path)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return std::all_of(files.begin(), files.end(), [&](const auto& file) { return read_inputs(file, inputs); });
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
    return false;
  }
  inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  return true;
}

/// Half of the iterations mutate a file one to eight times, the others run random bytes.
void run_iteration(uint64_t iteration, uint64_t seed, const std::vector<Bytes>& inputs) {
  g_state = seed * 0x100000001b3u + iteration;  // each iteration can be replayed alone
  Bytes bytes(kMaxSize);
  size_t size = next_random(g_state) % kMaxSize;
  if (inputs.empty() || iteration % 2 == 0) {
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(next_random(g_state));
  } else {
    const Bytes& input = inputs[next_random(g_state) % inputs.size()];
    size = std::min(input.size(), kMaxSize);
    std::copy_n(input.begin(), size, bytes.begin());
    for (uint64_t n = 1 + next_random(g_state) % 8; n > 0; --n) {
      size = LLVMFuzzerCustomMutator(bytes.data(), size, kMaxSize, static_cast<unsigned>(next_random(g_state)));
    }
  }
  bytes.resize(size);
  run(bytes);
}

}  // namespace

/// Stands in for libFuzzer's own mutations: changes a byte, or the size.
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size) {
  if (size == 0 || next_random(g_state) % 8 == 0) {
    const size_t new_size = 1 + next_random(g_state) % max_size;
    for (size_t i = size; i < new_size; ++i) data[i] = static_cast<uint8_t>(next_random(g_state));
    return new_size;
  }
  data[next_random(g_state) % size] = static_cast<uint8_t>(next_random(g_state));
  return size;
}

int main(int argc, char** argv) {
  const bool has_count = argc > 1 && std::isdigit(static_cast<unsigned char>(argv[1][0]));
  std::vector<Bytes> inputs;
  for (int i = has_count ? 3 : 1; i < argc; ++i) {
    if (!read_inputs(argv[i], inputs)) return 1;
  }
  for (const Bytes& input : inputs) run(input);
  const uint64_t iterations = has_count ? std::strtoull(argv[1], nullptr, 10) : inputs.empty() ? 1000 : 0;
  const uint64_t seed = argc > 2 && has_count ? std::strtoull(argv[2], nullptr, 10) : 1;
  for (uint64_t i = 0; i < iterations; ++i) run_iteration(i, seed, inputs);
  std::printf("%zu files, %llu inputs of seed %llu\n", inputs.size(), static_cast<unsigned long long>(iterations),
              static_cast<unsigned long long>(seed));
  return 0;
}
