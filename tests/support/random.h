// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace shd::tests
{

/// Deterministic random numbers, equal on every machine. Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators" (2014), the mix of SplitMix64.
struct Random {
    uint64_t state;

    uint64_t bits()
    {
        uint64_t z = state += 0x9e3779b97f4a7c15ull;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ z >> 27) * 0x94d049bb133111ebull;
        return z ^ z >> 31;
    }
    /// Uniform in [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    /// Uniform in [low, high).
    double in(double low, double high) { return low + (high - low) * unit(); }
    float real(double low, double high) { return static_cast<float>(in(low, high)); }
    /// Uniform in low..high, both included.
    int32_t whole(int64_t low, int64_t high)
    {
        return static_cast<int32_t>(low + static_cast<int64_t>(bits() % static_cast<uint64_t>(high - low + 1)));
    }
    /// Magnitudes uniform over the powers of two in [2^low, 2^high), either sign.
    float scaled(double low, double high)
    {
        const double magnitude = std::exp2(in(low, high));
        return static_cast<float>(bits() & 1 ? magnitude : -magnitude);
    }
};

}  // namespace shd::tests
