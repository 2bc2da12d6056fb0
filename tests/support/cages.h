// SPDX-License-Identifier: MIT
// Closed triangle meshes as cages of points.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "ref/polyhedron_ref.h"

namespace shd::tests
{

using Cage = ref::PolyhedronMesh;

/// The vertices that a call reads are floats.
inline ref::PolyhedronPoint rounded(double x, double y, double z)
{
    return {double{static_cast<float>(x)}, double{static_cast<float>(y)}, double{static_cast<float>(z)}};
}

inline Cage tetrahedron()
{
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
}

/// The unit cube; vertex i has the bits of i as x, y and z.
inline Cage cube()
{
    Cage cage;
    for (int i = 0; i < 8; ++i) cage.vertex.push_back(rounded(i & 1, i >> 1 & 1, i >> 2 & 1));
    cage.index = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                  2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return cage;
}

inline Cage octahedron()
{
    return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}};
}

/// A ball of 2 (rings - 1) sides triangles. `spikes` moves every other vertex away from the centre.
inline Cage ball(uint32_t rings, uint32_t sides, double spikes)
{
    const double pi = 3.14159265358979324;
    Cage cage;
    cage.vertex.push_back({0, 0, 1});
    for (uint32_t r = 1; r < rings; ++r) {
        for (uint32_t s = 0; s < sides; ++s) {
            const double a = pi * r / rings, b = 2 * pi * s / sides, radius = 1 + ((r + s) % 2 ? spikes : 0);
            cage.vertex.push_back(
                rounded(radius * std::sin(a) * std::cos(b), radius * std::sin(a) * std::sin(b), radius * std::cos(a)));
        }
    }
    const auto last = static_cast<uint32_t>(cage.vertex.size());
    cage.vertex.push_back({0, 0, -1});
    const auto at = [&](uint32_t r, uint32_t s) { return 1 + (r - 1) * sides + s % sides; };
    for (uint32_t s = 0; s < sides; ++s) {
        cage.index.insert(cage.index.end(), {0, at(1, s), at(1, s + 1)});
        for (uint32_t r = 1; r + 1 < rings; ++r) {
            const uint32_t a = at(r, s), b = at(r, s + 1), c = at(r + 1, s), d = at(r + 1, s + 1);
            cage.index.insert(cage.index.end(), {a, c, d, a, d, b});
        }
        cage.index.insert(cage.index.end(), {last, at(rings - 1, s + 1), at(rings - 1, s)});
    }
    return cage;
}

/// A ring around z of 2 sides^2 triangles.
inline Cage torus(uint32_t sides)
{
    const double pi = 3.14159265358979324;
    Cage cage;
    for (uint32_t i = 0; i < sides; ++i) {
        for (uint32_t k = 0; k < sides; ++k) {
            const double a = 2 * pi * i / sides, b = 2 * pi * k / sides, r = 1 + 0.4 * std::cos(b);
            cage.vertex.push_back(rounded(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)));
            const uint32_t i2 = (i + 1) % sides, k2 = (k + 1) % sides;
            const uint32_t p = i * sides + k, q = i2 * sides + k, s = i * sides + k2, t = i2 * sides + k2;
            cage.index.insert(cage.index.end(), {p, q, t, p, t, s});
        }
    }
    return cage;
}

/// Two tetrahedra apart from each other.
inline Cage pair()
{
    Cage cage = tetrahedron();
    for (int i = 0; i < 4; ++i)
        cage.vertex.push_back(cage.vertex[static_cast<size_t>(i)] + ref::PolyhedronPoint{2, 0.5, 0.25});
    for (int i = 0; i < 12; ++i) cage.index.push_back(cage.index[static_cast<size_t>(i)] + 4);
    return cage;
}

}  // namespace shd::tests
