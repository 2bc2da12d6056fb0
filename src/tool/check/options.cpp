// SPDX-License-Identifier: MIT
#include "tool/check/options.h"

#include <algorithm>

#include "command/names.h"

using namespace command;

namespace {

constexpr const char* kDescription =
    R"(Reads a texture, lookups and their results, and prints the results that a graphics API does not allow, whatever
the implementation. For each it prints the legal interval, the nearest legal value, and the texels of the lookup.

TEXTURE is a .npy array [height][width][channels], or [layers][height][width][channels], of uint8, uint16, float16 or
float32, or an image file that libshd_io reads. LOOKUPS is one of

  CSV        the first line names the columns
  .npy       a structured array, or [rows][columns] with --columns
  SHDLOOK1   this word, uint32 columns, uint64 rows, names of 16 bytes, columns of float32; little-endian

Columns: u v w dudx dvdx dwdx dudy dvdy dwdy lod reference layer, and the results r g b a.)";

const std::vector<Section> kSections = {
    {"Exit status",
     "0 all results are legal, 1 some are not, 2 wrong options, 3 a file cannot be read, 4 the "
     "report cannot be written."},
    {"Examples", R"(  shd-check --filter bilinear --wrap clamp texture.png lookups.csv
  shd-check --diagnose --wrap repeat texture.png lookups.csv
  shd-check --rules d3d11 --results picture.exr texture.npy lookups.npy)"},
    {"See also", "shd-render(1), shd-maketx(1)"}};

/// U or U,V.
Values wrap_values(shd_sampler_desc& sampler) {
  Values values = named(sampler.wrap_u, names_of(shd_wrap_name));
  values.wanted = "one or two of " + join(values.names, " and ");
  values.read = [&sampler](const std::string& text) {
    const std::vector<std::string> parts = split(text, ',');
    return parts.size() <= 2 && named(sampler.wrap_u, names_of(shd_wrap_name)).read(parts.front()) &&
           named(sampler.wrap_v, names_of(shd_wrap_name)).read(parts.back());
  };
  return values;
}

Values border_values(shd_sampler_desc& sampler) {
  const auto read = [&sampler](const std::string& text) {
    const auto numbers = read_numbers(text);
    if (!numbers || numbers->size() != 4) return false;
    std::copy(numbers->begin(), numbers->end(), sampler.border);
    return true;
  };
  return {"four numbers R,G,B,A", {}, "0,0,0,0", read};
}

Values level_values(std::vector<std::string>& levels) {
  const auto read = [&levels](const std::string& text) { return levels.push_back(text), !text.empty(); };
  return {"the name of a file", {}, "", read, true};
}

Values column_values(std::vector<std::string>& columns) {
  const auto read = [&columns](const std::string& text) { return columns = split(text, ','), true; };
  return {"", {}, "u,v,dudx,dvdx,dudy,dvdy,r,g,b,a", read};
}

Values report_values(std::string& out) {
  const auto read = [&out](const std::string& text) {
    return out = text, ends_with(text, ".csv") || ends_with(text, ".json");
  };
  return {"the name of a file that ends in .csv or .json", {}, "", read, true};
}

Group file_options(Options& out) {
  return {"Files",
          {{"--results", "FILE", file(out.results),
            "Results as a .npy array or an image of floats, row by row, in place of the columns r g b a."},
           {"--columns", "LIST", column_values(out.columns), "Names of the columns of a .npy array [rows][columns]."},
           {"--srgb", "", flag(out.srgb), "8-bit texels are sRGB."},
           {"--cube", "", flag(out.cube), "The six layers are the faces +X -X +Y -Y +Z -Z."},
           {"--level", "FILE", level_values(out.levels),
            "Mip level 1, then 2 and so on, in place of averages. Repeatable."},
           {"--no-mipmap", "", flag(out.mipmap, false), "Level 0 alone."},
           {"--report", "FILE", report_values(out.report),
            "Verdicts as a table of all lookups (.csv), or of the illegal ones with the diagnosis (.json)."},
           {"--list", "N", number(out.list, 0, 1e9), "Most illegal lookups to describe, the farthest first."}}};
}

Values name_values(std::vector<std::string>& names) {
  const auto read = [&names](const std::string& text) { return names = split(text, ','), true; };
  return {"", {}, "", read};
}

Group diagnosis_options(Options& out) {
  return {"Diagnosis",
          {{"--diagnose", "", flag(out.diagnose),
            "Judge the table under other hypotheses, such as another wrap or a shift of half a texel, and print those "
            "that make most lookups legal."},
           {"--assume", "NAMES", name_values(out.assumed),
            "Judge under hypotheses that --diagnose names, separated by commas."}}};
}

/// A number that the sampler or the bounds refuse if it is out of range.
template <class T>
Values any_number(T& out) {
  const auto read = [&out](const std::string& text) { return read_number(text, out); };
  return {std::is_integral_v<T> ? "a whole number" : "a number", {}, "", read, true};
}

Group sampler_options(Options& out) {
  shd_sampler_desc& sampler = out.sampler;
  Values compare = initially(named(sampler.compare, names_of(shd_compare_name)), "");
  compare.read = [&sampler, read = compare.read](const std::string& text) { return sampler.compares = 1, read(text); };
  return {"Sampler",
          {{"--filter", "NAME", named(sampler.filter, filters_with_bounds()), "Filter of the lookups."},
           {"--wrap", "U[,V]", wrap_values(sampler), "Wrap along u, and along v if it differs."},
           {"--border", "R,G,B,A", border_values(sampler), "Colour of the border."},
           {"--compare", "NAME", compare, "Compare reference NAME texel."},
           {"--bias", "X", any_number(sampler.lod_bias), "Added to the level of detail."},
           {"--lod-min", "X", any_number(sampler.lod_min), "Smallest level of detail."},
           {"--lod-max", "X", any_number(sampler.lod_max), "Largest level of detail."},
           {"--max-anisotropy", "X", any_number(sampler.max_anisotropy), "Largest ratio of anisotropic filters."}}};
}

/// A number that replaces that of --rules, wherever it stands on the command line.
template <class T>
Values bound_values(BoundChanges& changes, T shd_bounds_desc::*field) {
  T number{};
  Values values = any_number(number);
  values.read = [&changes, field](const std::string& text) {
    T value{};
    if (!read_number(text, value)) return false;
    changes.push_back([value, field](shd_bounds_desc& bounds) { bounds.*field = value; });
    return true;
  };
  return values;
}

Group bound_options(Options& out) {
  using Desc = shd_bounds_desc;
  BoundChanges& changes = out.bound_changes;
  return {
      "Bounds",
      {{"--rules", "NAME", named(out.rules, kRules),
        "The API, which decides the following numbers if they are absent."},
       {"--subtexel-bits", "N", bound_values(changes, &Desc::subtexel_bits), "Fraction bits of texel coordinates."},
       {"--level-bits", "N", bound_values(changes, &Desc::level_bits), "Fraction bits of the level of detail."},
       {"--weight-bits", "N", bound_values(changes, &Desc::weight_bits), "Bits of the weights of texels."},
       {"--result-bits", "N", bound_values(changes, &Desc::result_bits), "Bits of the results of unorm formats."},
       {"--coordinate-error", "X", bound_values(changes, &Desc::coordinate_error),
        "Error of a coordinate, relative to max(1, |u|)."},
       {"--derivative-error", "X", bound_values(changes, &Desc::derivative_error), "Relative error of derivatives."},
       {"--level-error", "X", bound_values(changes, &Desc::level_error), "Error of a level of detail before bias."},
       {"--relative-error", "X", bound_values(changes, &Desc::relative_error),
        "Error of a result relative to the largest texel."},
       {"--srgb-error", "X", bound_values(changes, &Desc::srgb_error), "Error of a decoded sRGB texel in codes."}}};
}

}  // namespace

shd_bounds_desc bounds_of(const Options& options, shd_rules rules) {
  shd_bounds_desc bounds = shd_bounds_desc_default();
  check(shd_bounds_desc_from_rules(rules, &bounds), "--rules");
  for (const auto& change : options.bound_changes) change(bounds);
  return bounds;
}

std::vector<Name<shd_filter>> filters_with_bounds() {
  return names_of(shd_filter_name, {SHD_FILTER_BICUBIC, SHD_FILTER_RIPMAP, SHD_FILTER_SUMMED_AREA, SHD_FILTER_EWA,
                                    SHD_FILTER_STOCHASTIC, SHD_FILTER_EXACT, SHD_FILTER_HERMITE});
}

bool read_options(int argc, const char* const* argv, Options& out) {
  const Program program = {"shd-check",
                           "judge the texture lookups of any implementation",
                           "[options] TEXTURE LOOKUPS",
                           kDescription,
                           {file_options(out), diagnosis_options(out), sampler_options(out), bound_options(out)},
                           kSections};
  std::vector<std::string> files;
  if (!parse(program, argc, argv, files)) return false;
  refuse_if(files.size() != 2, "two files are needed, TEXTURE and LOOKUPS");
  out.texture = files[0];
  out.lookups = files[1];
  return true;
}
