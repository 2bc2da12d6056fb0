// SPDX-License-Identifier: MIT
// The table of support.h: every cell is called through the public functions. Cells that work give a constant texture's
// value, within its bounds, with derivatives of 0, and the same bits on every target. The others are refused with the
// reason of the table. docs/support.md is the page of the table: run this program with --print to write it.
#include "texture/support.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <shd/shd.h>

#include "support/check.h"

namespace {

using namespace shd::texture;

constexpr shd_filter kFilters[] = {
    SHD_FILTER_NEAREST,           SHD_FILTER_BILINEAR,  SHD_FILTER_BICUBIC,    SHD_FILTER_NEAREST_MIP,
    SHD_FILTER_BILINEAR_MIP,      SHD_FILTER_TRILINEAR, SHD_FILTER_RIPMAP,     SHD_FILTER_SUMMED_AREA,
    SHD_FILTER_ANISOTROPIC,       SHD_FILTER_EWA,       SHD_FILTER_STOCHASTIC, SHD_FILTER_EXACT,
    SHD_FILTER_NEAREST_MIP_LINEAR};

template <class Body>
void for_each_cell(const Body& body) {
  for (const shd_filter filter : kFilters) {
    for (uint32_t domain = 0; domain < kDomains; ++domain) {
      for (uint32_t store = 0; store < kStores; ++store) {
        for (uint32_t use = 0; use < kUses; ++use) {
          body(SupportCell{filter, static_cast<Domain>(domain), static_cast<Store>(store), static_cast<Use>(use)});
        }
      }
    }
  }
}

std::string text_of(const SupportCell& cell) {
  return std::string(name_of(cell.filter)) + ", " + name_of(cell.domain) + ", " + name_of(cell.store) + ", " +
         name_of(cell.use);
}

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
      out << "| " << name_of(filter);
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

constexpr uint32_t kSide = 8, kLevels = 4;
constexpr uint8_t kCode = 132;  // 5 bits of BC1 have it

/// A block of BC1 with one colour, red = blue = 132, green = 130, or a pixel of it.
struct Constant {
  std::vector<uint8_t> texels;
  std::vector<shd_image> levels;

  Constant(shd_format format, uint32_t images) : texels(size_t{kSide} * kSide * 4 * kSide + SHD_TEXTURE_PADDING) {
    constexpr uint8_t kBlock[8] = {0x10, 0x84, 0x10, 0x84, 0, 0, 0, 0};
    const bool blocks = format == SHD_FORMAT_BC1_RGB;
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = blocks ? kBlock[i % 8] : i % 4 == 1 ? 130 : kCode;
    for (uint32_t i = 0; i < images * (kLevels - 1); ++i) {
      shd_image image = shd_image_default();
      image.format = format;
      image.pixels = texels.data();
      levels.push_back(image);
    }
  }
};

shd_result load_constant(void* user_data, const shd_tile* tiles, size_t count) {
  const auto& constant = *static_cast<const Constant*>(user_data);
  for (size_t i = 0; i < count; ++i) {
    const bool blocks = constant.levels[0].format == SHD_FORMAT_BC1_RGB;
    const size_t rows = blocks ? (tiles[i].height + 3) / 4 : tiles[i].height;
    for (size_t y = 0; y < rows; ++y) {
      memcpy(static_cast<uint8_t*>(tiles[i].texels) + y * tiles[i].row_stride, constant.texels.data(),
             blocks ? (tiles[i].width + 3) / 4 * 8 : tiles[i].width * 4);
    }
  }
  return SHD_OK;
}

/// A texture of one colour. Returns the result of its creation.
shd_result make_texture(shd_context* context, shd_tile_cache* cache, const SupportCell& cell, Constant* constant,
                        shd_texture** out) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = constant->levels[0].format;
  desc.width = desc.height = kSide;
  if (cell.domain == Domain::kSlices) desc.depth = kSide;
  if (cell.domain == Domain::kDirections) desc.projection = SHD_PROJECTION_CUBE, desc.layers = 6;
  desc.tables = SHD_TABLE_MIPMAP;
  if (cell.filter == SHD_FILTER_RIPMAP) desc.tables |= SHD_TABLE_RIPMAP;
  if (cell.filter == SHD_FILTER_SUMMED_AREA) desc.tables |= SHD_TABLE_SUMMED_AREA;
  if (cell.store == Store::kTiles || cell.store == Store::kTilesOfBlocks) {
    desc.tiles = {cache, load_constant, nullptr, constant};
    return shd_texture_create(context, &desc, out);
  }
  desc.texels = constant->texels.data();
  if (cell.store == Store::kBorrowed && desc.layers == 1) desc.flags = SHD_TEXTURE_BORROW;
  if (cell.store != Store::kBlocks) return shd_texture_create(context, &desc, out);
  size_t next = 0;
  for (uint32_t layer = 0; layer < desc.layers; ++layer) {
    for (uint32_t l = 1; l < kLevels; ++l) {
      for (uint32_t slice = 0; slice < (desc.depth ? desc.depth >> l : 1); ++slice) {
        constant->levels[next].width = constant->levels[next].height = kSide >> l;
        ++next;
      }
    }
  }
  desc.levels = constant->levels.data();
  desc.level_count = kLevels - 1;
  return shd_texture_create(context, &desc, out);
}

constexpr size_t kCount = 19;

/// The lookups of all cells, and the results of one.
struct Lookups {
  float column[9][kCount], out[16][kCount];

  Lookups() {
    for (size_t i = 0; i < kCount; ++i) {
      for (int c = 0; c < 9; ++c) {
        const float place = static_cast<float>((i * 7 + static_cast<size_t>(c) * 5) % 23) / 23.0f;
        column[c][i] = c < 3 ? place - 0.3f : (place - 0.5f) * (i < 9 ? 0.1f : 1.5f);
      }
    }
  }
  shd_lookups in() const {
    shd_lookups in = shd_lookups_default();
    in.count = kCount;
    shd_f32_in* const ins[9] = {&in.u, &in.v, &in.w, &in.dudx, &in.dvdx, &in.dwdx, &in.dudy, &in.dvdy, &in.dwdy};
    for (int c = 0; c < 9; ++c) *ins[c] = shd_f32_column(column[c], 0);
    return in;
  }
  /// Sets `count` columns from `first` on as the channels of texels.
  void set(int first, shd_f32_out* channels) {
    for (int c = 0; c < 4; ++c) channels[c] = shd_f32_out_column(out[first + c], 0);
  }
};

/// Calls the function of a cell. Writes values to the first columns, and others behind them.
shd_result call(const SupportCell& cell, const shd_texture* texture, const shd_sampler* sampler, Lookups* lookups) {
  const shd_lookups in = lookups->in();
  shd_texels texels = shd_texels_default(), lower = shd_texels_default();
  lookups->set(0, texels.channel);
  const shd_result values = shd_texture_sample(texture, sampler, &in, &texels);
  if (values != SHD_OK) return values;
  if (cell.use == Use::kGradients) {
    lookups->set(4, texels.du);
    lookups->set(8, texels.dv);
    if (cell.domain == Domain::kSlices) lookups->set(12, texels.dw);
    return shd_texture_sample(texture, sampler, &in, &texels);
  }
  if (cell.use == Use::kBounds) {
    lookups->set(4, lower.channel);
    lookups->set(8, texels.channel);
    return shd_texture_bounds(texture, sampler, &in, nullptr, &lower, &texels);
  }
  if (cell.use != Use::kExplanation) return SHD_OK;
  shd_explanation explanation = shd_explanation_default();
  for (size_t i = 0; i < kCount; ++i) {
    const shd_result result = shd_texture_explain(texture, sampler, &in, i, &explanation);
    if (result != SHD_OK) return result;
    for (int c = 0; c < 4; ++c) lookups->out[4 + c][i] = explanation.result[c];
  }
  return SHD_OK;
}

void check_values(const SupportCell& cell, const Lookups& lookups) {
  const float want[4] = {132.0f / 255.0f, 130.0f / 255.0f, 132.0f / 255.0f, 1.0f};
  const float slack = cell.use == Use::kFast ? 0x1p-11f : 0x1p-22f;
  for (size_t i = 0; i < kCount; ++i) {
    for (int c = 0; c < 4; ++c) {
      const float value = lookups.out[c][i], *const other = &lookups.out[4 + c][i],
                  *const last = &lookups.out[8 + c][i];
      const float wanted =
          c == 3 && cell.store != Store::kBlocks && cell.store != Store::kTilesOfBlocks ? 132.0f / 255.0f : want[c];
      const bool compares = cell.use == Use::kComparison;  // 0 < texel
      bool right = compares ? value == (c == 0 || c == 3 ? 1.0f : 0.0f) : std::fabs(value - wanted) <= slack;
      if (cell.use == Use::kGradients) right = right && *other == 0.0f && *last == 0.0f;
      if (cell.use == Use::kExplanation) right = right && *other == value;
      if (cell.use == Use::kBounds) right = right && *other <= value && value <= *last && *last - *other <= 0.03f;
      if (!right) {
        fail_msg("%s: lookup %zu channel %d: %g, then %g, %g", text_of(cell).c_str(), i, c, double{value},
                 double{*other}, double{*last});
      }
    }
  }
}

/// Checks that a texture without fixed point has the values of full precision.
void check_full(const SupportCell& cell, const shd_texture* texture, shd_sampler_desc* desc, shd_context* context,
                const Lookups& fast) {
  Lookups full;
  shd_sampler* sampler = nullptr;
  desc->precision = SHD_PRECISION_FULL;
  assert_int_equal(shd_sampler_create(context, desc, &sampler), SHD_OK);
  memset(full.out, 0, sizeof full.out);
  assert_int_equal(call({cell.filter, cell.domain, cell.store, Use::kValues}, texture, sampler, &full), SHD_OK);
  assert_memory_equal(full.out, fast.out, sizeof full.out);
  shd_sampler_release(sampler);
}

void check_cell(const SupportCell& cell, shd_context* context, shd_tile_cache* cache, Lookups* lookups) {
  const bool blocks = cell.store == Store::kBlocks || cell.store == Store::kTilesOfBlocks;
  Constant constant(blocks ? SHD_FORMAT_BC1_RGB : SHD_FORMAT_RGBA8, kSide);
  const char* const reason = refusal_of(cell);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = cell.filter;
  desc.tolerance = 1.0f;
  desc.compares = cell.use == Use::kComparison;
  desc.precision = cell.use == Use::kFast ? SHD_PRECISION_FAST : SHD_PRECISION_FULL;
  shd_sampler* sampler = nullptr;
  shd_texture* texture = nullptr;
  assert_int_equal(shd_sampler_create(context, &desc, &sampler), SHD_OK);
  const shd_result made = make_texture(context, cache, cell, &constant, &texture);
  const shd_result result = made == SHD_OK ? call(cell, texture, sampler, lookups) : made;
  const bool refused = result == SHD_ERROR_UNSUPPORTED || (made != SHD_OK && result == SHD_ERROR_INVALID_ARGUMENT);
  if (!reason && result != SHD_OK) fail_msg("%s: %s", text_of(cell).c_str(), shd_last_error());
  if (reason && cell.use == Use::kFast && !refusal_of({cell.filter, cell.domain, cell.store, Use::kValues})) {
    check_full(cell, texture, &desc, context, *lookups);
  } else if (reason && (!refused || (made == SHD_OK && !strstr(shd_last_error(), reason)))) {
    fail_msg("%s: %s, %s; the table has: %s", text_of(cell).c_str(), shd_result_name(result), shd_last_error(), reason);
  }
  if (!reason) check_values(cell, *lookups);
  shd_texture_release(texture);
  shd_sampler_release(sampler);
}

void test_cells(void**) {
  std::vector<Lookups> first;
  for (int simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
    shd_context_desc desc = shd_context_desc_default();
    desc.simd = static_cast<shd_simd>(simd);
    shd_context* context = nullptr;
    if (shd_context_create(&desc, &context) != SHD_OK) continue;
    shd_tile_cache* cache = nullptr;
    assert_int_equal(shd_tile_cache_create(context, nullptr, &cache), SHD_OK);
    size_t number = 0;
    for_each_cell([&](const SupportCell& cell) {
      Lookups lookups;
      memset(lookups.out, 0, sizeof lookups.out);
      check_cell(cell, context, cache, &lookups);
      if (number == first.size()) first.push_back(lookups);
      if (memcmp(first[number].out, lookups.out, sizeof lookups.out) != 0)
        fail_msg("%s: other bits on target %d", text_of(cell).c_str(), simd);
      ++number;
    });
    shd_tile_cache_release(cache);
    shd_context_release(context);
  }
  assert_int_equal(first.size(), sizeof kFilters / sizeof *kFilters * kDomains * kStores * kUses);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && strcmp(argv[1], "--print") == 0) {
    fputs(page().c_str(), stdout);
    return 0;
  }
  const CMUnitTest tests[] = {cmocka_unit_test(test_page), cmocka_unit_test(test_cells)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
