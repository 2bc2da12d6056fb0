// SPDX-License-Identifier: MIT
// The table of support.h: docs/support.md is its page, and its refusals are those of the public functions, with the
// reasons of the table. test_support_cells.cpp has the cells that work. Run this program with --print to write the
// page.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/enum_names.h"
#include "support/check.h"
#include "support_cells.h"

namespace {

using namespace cells;

// ---- The page ----

/// Numbers of the reasons, in their order on the page.
int number_of(const std::string& reason, std::vector<std::string>* reasons) {
  for (size_t i = 0; i < reasons->size(); ++i) {
    if ((*reasons)[i] == reason) return static_cast<int>(i + 1);
  }
  reasons->push_back(reason);
  return static_cast<int>(reasons->size());
}

/// The entry of a filter, a domain and a use: yes, or the stores without it and the numbers of the reasons.
std::string entry_of(shd_filter filter, Domain domain, Use use, std::vector<std::string>* reasons) {
  std::string without;
  uint32_t refused = 0;
  int number = 0;
  bool one_reason = true;
  for (uint32_t store = 0; store < kStores; ++store) {
    const char* const reason = refusal_of({filter, domain, static_cast<Store>(store), use});
    if (!reason) continue;
    const int reason_number = number_of(reason, reasons);
    one_reason = one_reason && (number == 0 || number == reason_number);
    number = reason_number;
    without += std::string(refused++ ? ", " : "") + name_of(static_cast<Store>(store)) + " (" +
               std::to_string(reason_number) + ")";
  }
  if (refused == 0) return "yes";
  return refused == kStores && one_reason ? "no (" + std::to_string(number) + ")" : "yes; not " + without;
}

std::string page() {
  std::ostringstream out;
  std::vector<std::string> reasons;
  out << "# Combinations that work\n"
         "A lookup combines a filter, a domain, a store and a use. All combinations work, except those of these "
         "tables.\n"
         "`test_unit_texture_support --print` writes this page from the table that the checks of the library read.\n\n"
         "Domains: 2D textures and arrays, 3D textures, and textures of directions (cube maps and other projections).\n"
         "Stores: ";
  for (uint32_t store = 0; store < kStores; ++store) {
    out << (store == 0 ? "" : store + 1 == kStores ? " and " : ", ") << name_of(static_cast<Store>(store));
  }
  out << ".\nFixed point is `SHD_PRECISION_FAST`. Lookups without it are not refused: they have the values of "
         "`SHD_PRECISION_FULL`.\n";
  for (uint32_t domain = 0; domain < kDomains; ++domain) {
    out << "\n## " << name_of(static_cast<Domain>(domain)) << "\n|";
    for (uint32_t use = 0; use < kUses; ++use) out << " | " << name_of(static_cast<Use>(use));
    out << " |\n|---|";
    for (uint32_t use = 0; use < kUses; ++use) out << "---|";
    out << "\n";
    for (const shd_filter filter : kFilters) {
      out << "| " << shd::core::value_name(filter);
      for (uint32_t use = 0; use < kUses; ++use) {
        out << " | " << entry_of(filter, static_cast<Domain>(domain), static_cast<Use>(use), &reasons);
      }
      out << " |\n";
    }
  }
  out << "\n## Reasons\n";
  for (size_t i = 0; i < reasons.size(); ++i) out << i + 1 << ". " << reasons[i] << "\n";
  return out.str();
}

void test_page(void**) {
  std::ifstream file(SHD_SUPPORT_DOCUMENT);
  std::stringstream text;
  text << file.rdbuf();
  assert_string_equal(text.str().c_str(), page().c_str());
}

// ---- The cells ----

/// A sampler of a cell, released at the end of its scope.
struct CellSampler {
  shd_sampler* sampler = nullptr;

  CellSampler(shd_context* context, shd_filter filter, Use use) {
    const shd_sampler_desc desc = sampler_desc(filter, use, 0);
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
  }
  ~CellSampler() { shd_sampler_release(sampler); }
  CellSampler(const CellSampler&) = delete;
  CellSampler& operator=(const CellSampler&) = delete;
};

/// A cell that is refused has the reason of the table. A cell without fixed point has the values of full precision.
void check_refusal(const SupportCell& cell, const char* reason, const Textures& textures, size_t shape) {
  const shd_texture* const texture = textures.at(shape, cell.store);
  const CellSampler given(textures.context(), cell.filter, cell.use);
  const CellLookups lookups(kShapes[shape]);
  Results results, full;
  const shd_result result = call(cell.use, cell.domain, texture, given.sampler, lookups, &results);
  if (cell.use != Use::kFast || refusal_of({cell.filter, cell.domain, cell.store, Use::kValues})) {
    if (result != SHD_ERROR_UNSUPPORTED || !strstr(shd_last_error(), reason)) {
      fail_msg("%s: %s, %s; the table has: %s", text_of(cell).c_str(), shd_result_name(result), shd_last_error(),
               reason);
    }
    return;
  }
  const CellSampler other(textures.context(), cell.filter, Use::kValues);
  shd_assert_ok(result);
  shd_assert_ok(call(Use::kValues, cell.domain, texture, other.sampler, lookups, &full));
  if (memcmp(results.out, full.out, sizeof full.out) != 0) fail_msg("%s: other values", text_of(cell).c_str());
}

void test_refusals(void**) {
  for_each_target([](int, const Textures& textures) {
    size_t refused = 0;
    for_each_cell([&](const SupportCell& cell) {
      const char* const reason = refusal_of(cell);
      if (!reason) return;
      for (size_t shape = 0; shape < kShapeCount; ++shape) {
        if (kShapes[shape].domain == cell.domain && has_store(kShapes[shape], cell.store))
          check_refusal(cell, reason, textures, shape);
      }
      ++refused;
    });
    assert_true(refused > 0);
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && strcmp(argv[1], "--print") == 0) {
    fputs(page().c_str(), stdout);
    return 0;
  }
  const CMUnitTest tests[] = {cmocka_unit_test(test_page), cmocka_unit_test(test_refusals)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
