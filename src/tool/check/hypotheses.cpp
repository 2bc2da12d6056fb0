// SPDX-License-Identifier: MIT
#include "tool/check/hypotheses.h"

#include <algorithm>
#include <numeric>

#include "command/names.h"
#include "command/suggest.h"
#include "tool/check/columns.h"

using namespace command;

namespace {

const std::string kAssume = "--assume ";

/// Collects the hypotheses of a case.
struct List {
  const Case& base;
  const Textures& textures;
  std::vector<Hypothesis> all;

  void add(const std::string& subject, const std::string& option, const std::string& text,
           const std::function<void(Case&)>& change) {
    all.push_back({subject, option, text, change});
  }
  /// A hypothesis that no option but --assume has.
  void named(const std::string& subject, const std::string& name, const std::string& text,
             const std::function<void(Case&)>& change) {
    add(subject, kAssume + name, text, change);
  }
  bool reads_levels() const { return ::reads_levels(base.sampler.filter); }
  bool has_derivatives() const { return base.has(kDudx) || base.has(kDvdx) || base.has(kDudy) || base.has(kDvdy); }
  bool uses_derivatives() const { return reads_levels() && has_derivatives() && !base.has(kLod); }
};

void add_wraps(List& list) {
  if (list.textures.is_cube()) return;
  const auto wraps = names_of(shd_wrap_name);
  const shd_wrap was_u = list.base.sampler.wrap_u, was_v = list.base.sampler.wrap_v;
  const auto add = [&](const Name<shd_wrap>& u, const Name<shd_wrap>& v) {
    if (u.value == was_u && v.value == was_v) return;
    const bool same = u.value == v.value;
    list.add("wrap", "--wrap " + u.name + (same ? "" : "," + v.name),
             "texels outside are those of " + u.name + (same ? "" : " along u and of " + v.name + " along v"),
             [=](Case& judged) { judged.sampler.wrap_u = u.value, judged.sampler.wrap_v = v.value; });
  };
  for (const auto& both : wraps) add(both, both);
  for (const auto& u : wraps) {
    for (const auto& v : wraps) {
      if (u.value != v.value) add(u, v);
    }
  }
}

/// Shifts by half a texel, of each level that is read or of level 0.
void add_shifts(List& list) {
  if (list.textures.is_cube()) return;
  const char* const names[3][3] = {
      {"left-up", "up", "right-up"}, {"left", "", "right"}, {"left-down", "down", "right-down"}};
  const auto say = [](int u, int v) {
    const auto side = [](const char* name, int sign) {
      return std::string(name) + " is half a texel " + (sign < 0 ? "smaller" : "larger");
    };
    return u && v ? side("u", u) + ", and " + side("v", v) : u ? side("u", u) : side("v", v);
  };
  const bool of_levels = list.base.sampler.filter != SHD_FILTER_ANISOTROPIC;
  constexpr int kSteps[8][2] = {{1, 1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}};
  for (const auto& [u, v] : kSteps) {
    const std::string where = names[v + 1][u + 1];
    const float du = 0.5f * static_cast<float>(u), dv = 0.5f * static_cast<float>(v);
    if (of_levels) {
      list.named("shift", "half-texel-" + where, say(u, v) + (list.reads_levels() ? ", on each level" : ""),
                 [=](Case& judged) {
                   judged.shift = {du, dv};
                 });
    }
    if (!list.reads_levels()) continue;
    const float width = static_cast<float>(list.textures.base().width);
    const float height = static_cast<float>(list.textures.base().height);
    list.named("shift", "half-base-texel-" + where, say(u, v) + ", of level 0",
               [=](Case& judged) { move_coordinates(judged, du / width, dv / height); });
  }
}

void add_axes(List& list) {
  const bool cube = list.textures.is_cube();
  const auto flip = [&](Input axis, const std::string& name) {
    list.named("flip-" + name, "flipped-" + name, cube ? name + " has the other sign" : name + " is 1 - " + name,
               [=](Case& judged) { flip_axis(judged, axis, cube); });
  };
  flip(kV, "v");
  flip(kU, "u");
  if (cube) flip(kW, "w");
  const auto swap = [&](Input one, Input other, const std::string& name, const std::string& text) {
    list.named("axes", "swapped-" + name, text, [=](Case& judged) { swap_axes(judged, one, other); });
  };
  swap(kU, kV, "uv", "u and v, and their derivatives, are swapped");
  if (cube) swap(kV, kW, "vw", "v and w, and their derivatives, are swapped");
  if (cube) swap(kU, kW, "uw", "u and w, and their derivatives, are swapped");
  const uint32_t width = list.textures.base().width, height = list.textures.base().height;
  const auto scale_u = 1.0f / static_cast<float>(width), scale_v = 1.0f / static_cast<float>(height);
  if (!cube) {
    list.named("coordinate unit", "coordinates-in-texels", "u and v are in texels", [=](Case& judged) {
      scale(judged, {kU}, scale_u);
      scale(judged, {kV}, scale_v);
    });
  }
  if (list.textures.base().layers > 1 && !cube) {
    list.named("layer", "next-layer", "the layer is the next one", [](Case& judged) {
      judged.layer.resize(judged.count());
      for (uint32_t& layer : judged.layer) ++layer;
    });
    list.named("layer", "previous-layer", "the layer is the one before", [](Case& judged) {
      for (uint32_t& layer : judged.layer) layer -= layer > 0;
    });
    list.named("layer", "layer-0", "the column layer has no effect", [](Case& judged) { judged.layer.clear(); });
  }
}

void add_channels(List& list) {
  std::vector<size_t> given;
  for (size_t c = 0; c < 4; ++c) {
    if (!list.base.result[c].empty()) given.push_back(c);
  }
  std::vector<size_t> order = given;
  while (std::next_permutation(order.begin(), order.end())) {
    std::string from, to;
    for (const size_t c : given) to += kChannelNames[c];
    for (const size_t c : order) from += kChannelNames[c];
    list.named("channels", "order-" + from, "the columns " + to + " are " + from, [=](Case& judged) {
      auto columns = judged.result;
      for (size_t i = 0; i < given.size(); ++i) judged.result[order[i]] = columns[given[i]];
    });
  }
  // Swaps of two channels are the likeliest ones.
  const auto changes = [&given](const Hypothesis& row) {
    const std::string order_text = row.option.substr(row.option.rfind('-') + 1);
    size_t count = 0;
    for (size_t i = 0; i < given.size(); ++i) count += order_text[i] != kChannelNames[given[i]][0];
    return count;
  };
  const auto first =
      std::find_if(list.all.begin(), list.all.end(), [](const auto& row) { return row.subject == "channels"; });
  std::stable_sort(first, list.all.end(), [&](const auto& a, const auto& b) { return changes(a) < changes(b); });
  list.named("result unit", "results-in-codes", "results are codes 0..255", [](Case& judged) {
    for (auto& column : judged.result) {
      for (float& value : column) value /= 255.0f;
    }
  });
}

void add_colors(List& list) {
  const bool srgb = list.base.decode == Decode::kSrgb;
  const auto decode = [&](const std::string& name, const std::string& text, Decode texels, Curve results) {
    list.named("colour", name, text, [=](Case& judged) { judged.decode = texels, judged.curve = results; });
  };
  const Decode as_given = list.base.decode;
  if (has_codes(list.textures.base())) {
    if (srgb) {
      decode("srgb-not-decoded", "sRGB texels are not decoded", Decode::kAsStored, Curve::kNone);
      decode("srgb-decoded-late", "sRGB texels are decoded after the filter", Decode::kAsStored, Curve::kDecoded);
      decode("srgb-decoded-twice", "sRGB texels are decoded twice before the filter", Decode::kTwice, Curve::kNone);
      decode("alpha-decoded", "alpha is decoded as sRGB, too", Decode::kAlphaToo, Curve::kNone);
      decode("power-2.2", "sRGB texels are decoded by the power 2.2", Decode::kPower, Curve::kNone);
    } else {
      list.add("colour", "--srgb", "texels are decoded as sRGB", [](Case& judged) { judged.decode = Decode::kSrgb; });
      decode("srgb-decoded-late", "results are decoded as sRGB", Decode::kAsStored, Curve::kDecoded);
    }
  }
  if (srgb || !has_codes(list.textures.base()))
    decode("srgb-decoded-again", "results are decoded as sRGB once more", as_given, Curve::kDecoded);
  decode("srgb-encoded", "results are encoded as sRGB", as_given, Curve::kEncoded);
}

void add_filters(List& list) {
  for (const auto& row : filters_with_bounds()) {
    if (row.value == list.base.sampler.filter) continue;
    list.add("filter", "--filter " + row.name, "the filter is " + row.name,
             [value = row.value](Case& judged) { judged.sampler.filter = value; });
  }
  if (list.base.sampler.filter == SHD_FILTER_ANISOTROPIC) {
    for (const float ratio : {2.0f, 4.0f, 8.0f, 16.0f, 64.0f}) {
      if (ratio == list.base.sampler.max_anisotropy) continue;
      const std::string number = digits(static_cast<double>(ratio));
      list.add("anisotropy", "--max-anisotropy " + number, "the largest ratio is " + number,
               [ratio](Case& judged) { judged.sampler.max_anisotropy = ratio; });
    }
  }
  if (!list.base.sampler.compares) return;
  for (const auto& row : names_of(shd_compare_name)) {
    if (row.value == list.base.sampler.compare) continue;
    list.add("comparison", "--compare " + row.name, "the comparison is " + row.name,
             [value = row.value](Case& judged) { judged.sampler.compare = value; });
  }
}

void add_borders(List& list) {
  if (list.base.sampler.wrap_u != SHD_WRAP_BORDER && list.base.sampler.wrap_v != SHD_WRAP_BORDER) return;
  const std::array<float, 4> colors[] = {{0, 0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1, 1}};
  for (const auto& color : colors) {
    if (std::equal(color.begin(), color.end(), list.base.sampler.border)) continue;
    std::string text;
    for (const float x : color) text += (text.empty() ? "" : ",") + digits(static_cast<double>(x));
    list.add("border", "--border " + text, "the border is " + text,
             [color](Case& judged) { std::copy(color.begin(), color.end(), judged.sampler.border); });
  }
}

void add_levels(List& list) {
  if (!list.reads_levels()) return;
  const shd_sampler_desc& sampler = list.base.sampler;
  std::vector<float> biases;
  for (const float step : {1.0f, -1.0f, 0.5f, -0.5f}) biases.push_back(sampler.lod_bias + step);
  if (sampler.lod_bias != 0.0f) biases.insert(biases.begin(), 0.0f);
  for (const float bias : biases) {
    if (bias < -15.0f || bias > 15.0f) continue;
    const std::string number = digits(static_cast<double>(bias));
    list.add("bias", "--bias " + number, "the bias of the level is " + number,
             [bias](Case& judged) { judged.sampler.lod_bias = bias; });
  }
  if (sampler.lod_max > 0.0f) {
    list.add("clamp", "--lod-min 0 --lod-max 0", "only level 0 is read",
             [](Case& judged) { judged.sampler.lod_min = judged.sampler.lod_max = 0.0f; });
  }
  if (sampler.lod_min > 0.0f || sampler.lod_max < 32.0f) {
    list.add("clamp", "--lod-min 0 --lod-max 32", "levels are not clamped",
             [](Case& judged) { judged.sampler.lod_min = 0.0f, judged.sampler.lod_max = 32.0f; });
  }
  const bool scales = list.base.has(kLod) || (list.uses_derivatives() && !list.textures.is_cube());
  const auto width = static_cast<float>(list.textures.base().width);
  const auto height = static_cast<float>(list.textures.base().height);
  const auto times = [&](const std::string& name, float factor, const std::string& text) {
    list.named("level", name, text, [=](Case& judged) { scale_levels(judged, factor, width, height); });
  };
  if (!scales) return;
  times("level-doubled", 2.0f, "the level is doubled, as log2 of a squared size is");
  times("level-halved", 0.5f, "the level is half as large");
  times("level-natural-log", 0.693147f, "the level is a natural logarithm");
}

void add_derivatives(List& list) {
  if (!list.uses_derivatives()) return;
  const auto named = [&](const std::string& name, const std::string& text, const std::function<void(Case&)>& change) {
    list.named("derivatives", name, text, change);
  };
  named("no-derivatives-in-x", "derivatives in x have no effect", [](Case& judged) {
    scale(judged, {kDudx, kDvdx, kDwdx}, 0.0f);
  });
  named("no-derivatives-in-y", "derivatives in y have no effect", [](Case& judged) {
    scale(judged, {kDudy, kDvdy, kDwdy}, 0.0f);
  });
  named("transposed-derivatives", "dvdx and dudy are swapped",
        [](Case& judged) { swap_columns(judged, kDvdx, kDudy); });
  named("swapped-derivatives", "derivatives of u and of v are swapped", [](Case& judged) {
    swap_columns(judged, kDudx, kDvdx);
    swap_columns(judged, kDudy, kDvdy);
  });
  if (list.textures.is_cube()) return;
  const auto width = static_cast<float>(list.textures.base().width);
  const auto height = static_cast<float>(list.textures.base().height);
  named("derivatives-in-texels", "derivatives are in texels", [=](Case& judged) {
    scale(judged, {kDudx, kDudy}, 1.0f / width);
    scale(judged, {kDvdx, kDvdy}, 1.0f / height);
  });
  named("shorter-axis", "the shorter derivative decides the level",
        [=](Case& judged) { keep_shorter_axis(judged, width, height); });
  if (width == height) return;
  named("width-for-both", "derivatives of both coordinates are multiplied by the width", [=](Case& judged) {
    scale(judged, {kDvdx, kDvdy}, width / height);
  });
  named("height-for-both", "derivatives of both coordinates are multiplied by the height", [=](Case& judged) {
    scale(judged, {kDudx, kDudy}, height / width);
  });
}

/// Less precision. These bounds are wider than those of the case.
void add_precision(List& list) {
  const auto bits = [&](const std::string& name, uint32_t shd_bounds_desc::*field, uint32_t least, uint32_t most,
                        const std::string& of) {
    const uint32_t now = list.base.bounds.*field ? list.base.bounds.*field : 25u;
    for (uint32_t count = std::min(now - 1, most); count >= least && now > least; --count) {
      const std::string number = std::to_string(count);
      list.add(name, "--" + name + " " + number, of + " have " + number + (count == 1 ? " bit" : " bits"),
               [=](Case& judged) { judged.bounds.*field = count; });
    }
  };
  bits("weight-bits", &shd_bounds_desc::weight_bits, 6, 8, "weights of texels");
  if (is_unorm(list.textures.base())) bits("result-bits", &shd_bounds_desc::result_bits, 6, 7, "results");
  bits("subtexel-bits", &shd_bounds_desc::subtexel_bits, 2, 8, "texel coordinates");
  if (list.reads_levels()) bits("level-bits", &shd_bounds_desc::level_bits, 1, 8, "levels");
  const auto error = [&](const std::string& name, float shd_bounds_desc::*field, float value, const std::string& text) {
    if (list.base.bounds.*field >= value) return;
    list.add(name, "--" + name + " " + digits(static_cast<double>(value)), text,
             [=](Case& judged) { judged.bounds.*field = value; });
  };
  error("relative-error", &shd_bounds_desc::relative_error, 1.0f / 2048.0f, "results are half floats");
  error("coordinate-error", &shd_bounds_desc::coordinate_error, 1.0f / 65536.0f, "coordinates have 16 bits");
  error("coordinate-error", &shd_bounds_desc::coordinate_error, 1.0f / 2048.0f, "coordinates are half floats");
  if (list.base.decode == Decode::kSrgb)
    error("srgb-error", &shd_bounds_desc::srgb_error, 1.0f, "decoded sRGB texels are a code off");
  for (const auto& row : kRules) {
    if (row.value == list.base.rules) continue;
    list.add("rules", "--rules " + row.name, "the rules are those of " + row.name, [value = row.value](Case& judged) {
      judged.bounds = judged.bounds_of_rules[value], judged.rules = value;
    });
  }
}

}  // namespace

std::string assumed_name(const Hypothesis& hypothesis) {
  const std::string& option = hypothesis.option;
  return option.compare(0, kAssume.size(), kAssume) == 0 ? option.substr(kAssume.size()) : "";
}

std::vector<Hypothesis> hypotheses_of(const Case& judged, const Textures& textures) {
  List list = {judged, textures, {}};
  add_channels(list);
  add_wraps(list);
  add_shifts(list);
  add_axes(list);
  add_colors(list);
  add_filters(list);
  add_borders(list);
  add_levels(list);
  add_derivatives(list);
  add_precision(list);
  return std::move(list.all);
}

void assume(const std::vector<std::string>& names, const Textures& textures, Case& judged) {
  for (const std::string& name : names) {
    const std::vector<Hypothesis> all = hypotheses_of(judged, textures);
    std::vector<std::string> known;
    const Hypothesis* found = nullptr;
    for (const Hypothesis& row : all) {
      if (assumed_name(row).empty()) continue;
      known.push_back(assumed_name(row));
      if (known.back() == name) found = &row;
    }
    if (!found) command::refuse("--assume", name, "one of " + join(known) + " for this table", known);
    found->change(judged);
  }
}
