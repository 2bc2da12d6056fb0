// SPDX-License-Identifier: MIT
// Damaged model files, read in this process: a Failure is good, anything else that leaves the reader ends the test.
#ifndef SHD_TESTS_SUPPORT_MODEL_MUTANTS_H
#define SHD_TESTS_SUPPORT_MODEL_MUTANTS_H

#include <string>

#include "core/failure.h"
#include "support/check.h"
#include "support/scene_model.h"

namespace shd_test
{

inline bool ends_by_reading(const std::string &text, const char *name)
{
    shd::scene::Limits limits;
    limits.file_bytes = 1 << 22;
    limits.vertices = limits.triangles = 1 << 16;
    limits.seconds = 5;
    try {
        read_text(text, name, {}, limits);
        return true;
    } catch (const shd::core::Failure &) {
        return false;
    }
}

/// A file that is cut at up to 500 places, and 3000 others with up to four changed bytes behind the first `kept` ones.
inline void assert_mutants_end(const std::string &good, const char *name, size_t kept)
{
    uint32_t state = 12345;
    const auto random = [&](size_t below) {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) % below;
    };
    assert_true(ends_by_reading(good, name));
    for (size_t n = 0; n < good.size(); n += 1 + good.size() / 500) ends_by_reading(good.substr(0, n), name);
    for (int i = 0; i < 3000; ++i) {
        std::string changed = good;
        for (size_t k = 0; k <= random(4); ++k) {
            char &byte = changed[kept + random(changed.size() - kept)];
            byte = random(2) ? static_cast<char>(random(256)) : "0123456789-.,:[]{}\"e"[random(20)];
        }
        ends_by_reading(changed, name);
    }
}

}  // namespace shd_test

#endif  // SHD_TESTS_SUPPORT_MODEL_MUTANTS_H
