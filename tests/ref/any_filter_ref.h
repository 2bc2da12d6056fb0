// SPDX-License-Identifier: MIT
// Any filter on any texture in doubles: the oracles of all filters and domains behind one function. Not for discs and
// LAT_LONG.
#pragma once

#include <vector>

#include "ref/direction_exact_ref.h"
#include "ref/ellipsoid_ref.h"
#include "ref/exact_ref.h"
#include "ref/ripmap_ref.h"
#include "ref/summed_area_ref.h"
#include "ref/unit_filter_ref.h"

namespace ref {

/// The tables that filters need besides the levels: ripmaps, texels as doubles, and the channels of images.
class FilterTables {
 public:
  explicit FilterTables(const UnitImage& image) : image_(image) {
    const int layers = image.layers;
    for (int layer = 0; layer < layers && image.depth == 0; ++layer) {
      add_ripmap(layer);
      add_texels(image.at(layer, 0));
    }
  }

  /// The levels of a layer as floats: mip levels, and exact averages for sizes that no mip level has.
  const Ripmap& ripmap(int layer) const { return ripmaps_[static_cast<size_t>(layer)]; }

  SummedTexels summed(int layer) const {
    const Level& base = image_.at(layer, 0);
    return {&values_[static_cast<size_t>(layer * base.width * base.height * 4)], base.width, base.height, 4,
            &image_.sampler};
  }

  /// A channel of level 0 of all faces.
  shd::ref::DirectionTexels channel(int c) const {
    const Level& base = image_.at(0, 0);
    return {image_.projection, static_cast<int>(base.width), static_cast<int>(base.height), channels_[c].data()};
  }

 private:
  void add_ripmap(int layer) {
    const Level& base = image_.at(layer, 0);
    Ripmap ripmap = {};
    for (ripmap.rows = 0; base.height >> ripmap.rows > 0; ++ripmap.rows) {
      for (ripmap.columns = 0; base.width >> ripmap.columns > 0; ++ripmap.columns) {
        const int64_t width = base.width >> ripmap.columns, height = base.height >> ripmap.rows;
        const Level& mip = image_.at(layer, std::max(ripmap.columns, ripmap.rows));
        const Level& level = mip.width == width && mip.height == height ? mip : base;
        floats_.emplace_back();
        for (int64_t i = 0; i < 4 * width * height; ++i) {
          floats_.back().push_back(static_cast<float>(
              box(image_.format, level, width, height, i / 4 % width, i / 4 / width, static_cast<int>(i % 4))));
        }
        ripmap.levels[ripmap.rows][ripmap.columns] = {reinterpret_cast<const uint8_t*>(floats_.back().data()), width,
                                                      height};
      }
    }
    ripmaps_.push_back(ripmap);
  }

  void add_texels(const Level& base) {
    const auto size = static_cast<int64_t>(shd_format_size(image_.format));
    for (int64_t i = 0; i < 4 * base.width * base.height; ++i) {
      const int c = static_cast<int>(i % 4);
      values_.push_back(decode(image_.format, base.texels + i / 4 * size, c));
      channels_[c].push_back(static_cast<float>(values_.back()));
    }
  }

  const UnitImage& image_;
  std::vector<std::vector<float>> floats_;
  std::vector<Ripmap> ripmaps_;
  std::vector<double> values_;
  std::vector<float> channels_[4];
};

/// The filter of a sampler with SHD_PROFILE_EXACT, the bounding box of SUMMED_AREA, and a probe_slack of 0. STOCHASTIC
/// has the filter that it estimates.
class AnyFilter {
 public:
  /// Samples of a side of the footprint of EXACT.
  static constexpr int kSamples = 96;

  /// @param face_tie  face of texels of EWA that are as near to another face of the cube
  explicit AnyFilter(const UnitImage& image, int face_tie = 0) : image_(image), tables_(image_) {
    shd_sampler_desc& s = image_.sampler;
    if (s.filter == SHD_FILTER_STOCHASTIC) s.filter = s.stochastic_filter;
    unit_.subtexel_bits = unit_.level_bits = 40;
    unit_.rule = SHD_LEVEL_RULE_ELLIPSE;
    unit_.vulkan_places = false;
    unit_.face_tie = face_tie;
  }
  AnyFilter(const AnyFilter&) = delete;
  AnyFilter& operator=(const AnyFilter&) = delete;

  const UnitImage& image() const { return image_; }

  /// The value at a place, with the footprint that the lookup has at its own place.
  Value value(const UnitLookup& lookup, const UnitPoint& place) const {
    const Point at = point_of(lookup, place);
    switch (image_.sampler.filter) {
      case SHD_FILTER_BICUBIC:
      case SHD_FILTER_RIPMAP:
      case SHD_FILTER_SUMMED_AREA:
      case SHD_FILTER_EWA:
      case SHD_FILTER_EXACT:
        if (!image_.is_flat()) return on_directions(lookup, place, at);
        return image_.depth ? in_slices(lookup, place) : on_plane(lookup, place);
      default: return unit_filter(image_, unit_, lookup, at.p, at.layer, at.d);
    }
  }
  Value value(const UnitLookup& lookup) const { return value(lookup, {lookup.p[0], lookup.p[1], lookup.p[2]}); }

  /// Whether a value is one of the texels that TRILINEAR blends.
  bool is_tap(const UnitLookup& lookup, const Value& got, double tolerance) const {
    const Point at = point_of(lookup, {lookup.p[0], lookup.p[1], lookup.p[2]});
    const double lod = unit_lod(image_, unit_, unit_shape(image_, unit_, at.d).lambda);
    for (int k = 0; k < 16; ++k) {
      const Texels texels = {image_, unit_, at.layer, std::min(static_cast<int>(lod) + k / 8, image_.level_count - 1)};
      int64_t index[3] = {};
      for (int a = 0; a < image_.axes(); ++a) {
        const double x = texels.coordinate(at.p[static_cast<size_t>(a)], a) - 0.5;
        index[a] = static_cast<int64_t>(floor(x)) + (k >> a & 1);
      }
      const Value texel = texels.texel(index[0], index[1], index[2]);
      bool is_equal = true;
      for (size_t c = 0; c < 4; ++c) is_equal = is_equal && fabs(texel[c] - got[c]) <= tolerance;
      if (is_equal) return true;
    }
    return false;
  }

  /// A texel of a level of the ripmap: (level, level) is the mip level.
  double texel(int layer, int level_u, int level_v, int64_t x, int64_t y, int64_t z, int c) const {
    if (level_u == level_v && image_.sampler.filter != SHD_FILTER_RIPMAP)
      return Texels{image_, unit_, layer, level_u}.stored(layer, x, y, z)[static_cast<size_t>(c)];
    const Level& level = tables_.ripmap(layer).levels[level_v][level_u];
    return decode(SHD_FORMAT_RGBA32F, level.texels + (y * level.width + x) * 16, c);
  }

 private:
  /// A point of a layer or face, and the derivatives there.
  struct Point {
    UnitPoint p;
    int layer;
    UnitSteps d;
  };

  Point point_of(const UnitLookup& lookup, const UnitPoint& place) const {
    const shd_sampler_desc& s = image_.sampler;
    const double *const x = lookup.dx, *const y = lookup.dy;
    if (image_.is_flat()) {
      return {{reduce(s.wrap_u, place[0]), reduce(s.wrap_v, place[1]), reduce(s.wrap_w, place[2])},
              lookup.layer,
              {{x[0], x[1], x[2]}, {y[0], y[1], y[2]}}};
    }
    const long double n[3] = {lookup.p[0], lookup.p[1], lookup.p[2]}, to[3] = {place[0], place[1], place[2]};
    const ref_place at = ref_project(image_.projection, to);
    const auto step = [&](const double* d) {
      const long double change[3] = {d[0], d[1], d[2]};
      const ref_change of = ref_step(image_.projection, n, change);
      return UnitPoint{static_cast<double>(of.du), static_cast<double>(of.dv), 0};
    };
    return {{static_cast<double>(at.u), static_cast<double>(at.v), 0}, static_cast<int>(at.face), {step(x), step(y)}};
  }

  Image plane(int layer) const { return {image_.format, &image_.at(layer, 0), image_.level_count, &image_.sampler}; }

  /// The footprint in texels of the base.
  Ellipse ellipse_of(const UnitSteps& d) const {
    const auto w = static_cast<double>(image_.at(0, 0).width), h = static_cast<double>(image_.at(0, 0).height);
    return ellipse(Jacobian{d.x[0] * w, d.x[1] * h, d.y[0] * w, d.y[1] * h});
  }

  Value on_plane(const UnitLookup& lookup, const UnitPoint& place) const {
    const shd_sampler_desc& s = image_.sampler;
    const Image flat = plane(lookup.layer);
    const auto w = static_cast<double>(flat.levels[0].width), h = static_cast<double>(flat.levels[0].height);
    const Jacobian j = {lookup.dx[0], lookup.dx[1], lookup.dy[0], lookup.dy[1]};
    const double u = place[0], v = place[1];
    double out[4];
    if (s.filter == SHD_FILTER_EWA) {
      const Ellipse e = ellipse_of({{j.ux, j.vx, 0}, {j.uy, j.vy, 0}});
      ewa(flat, e, static_cast<int>(ewa_lod(flat, e)), u, v, 0, 0, out);
      return {out[0], out[1], out[2], out[3]};
    }
    if (s.filter == SHD_FILTER_SUMMED_AREA) {
      const BoxesAverage boxes = boxes_average(tables_.summed(lookup.layer), u, v, box_sides(j, s, w, h), 1);
      return {boxes.value[0], boxes.value[1], boxes.value[2], boxes.value[3]};
    }
    const double lambda_u = axis_lambda(j.ux, j.uy, w), lambda_v = axis_lambda(j.vx, j.vy, h);
    for (int c = 0; c < 4; ++c) {
      out[c] = s.filter == SHD_FILTER_BICUBIC ? bicubic(flat, u, v, c)
               : s.filter == SHD_FILTER_EXACT
                   ? parallelogram_average(flat, u, v, j, kSamples, c)
                   : ripmap(SHD_FORMAT_RGBA32F, tables_.ripmap(lookup.layer), s, u, v, lambda_u, lambda_v, c);
    }
    return {out[0], out[1], out[2], out[3]};
  }

  Value in_slices(const UnitLookup& lookup, const UnitPoint& place) const {
    std::vector<SolidLevel> levels;
    for (int l = 0; l < image_.level_count; ++l) {
      const Level& level = image_.at(0, l);
      levels.push_back({level.texels, level.width, level.height, std::max<int64_t>(image_.depth >> l, 1)});
    }
    const Solid solid = {image_.format, levels.data(), image_.level_count, &image_.sampler};
    const Place p = {place[0], place[1], place[2]};
    const Place x = {lookup.dx[0], lookup.dx[1], lookup.dx[2]}, y = {lookup.dy[0], lookup.dy[1], lookup.dy[2]};
    double out[4];
    if (image_.sampler.filter == SHD_FILTER_EWA) {
      const auto w = static_cast<double>(levels[0].width), h = static_cast<double>(levels[0].height);
      const auto d = static_cast<double>(levels[0].depth);
      const Spread spread = spread_of({x.u * w, x.v * h, x.w * d}, {y.u * w, y.v * h, y.w * d});
      ewa(solid, spread, static_cast<int>(ewa_lod(solid, spread)), p, {0, 0, 0}, out);
      return {out[0], out[1], out[2], out[3]};
    }
    for (int c = 0; c < 4; ++c) {
      out[c] = image_.sampler.filter == SHD_FILTER_BICUBIC ? tricubic(solid, p, c)
                                                           : parallelogram_average(solid, p, x, y, kSamples, c);
    }
    return {out[0], out[1], out[2], out[3]};
  }

  Value on_directions(const UnitLookup& lookup, const UnitPoint& place, const Point& at) const {
    if (image_.sampler.filter == SHD_FILTER_EWA) return ellipse_on_directions(at);
    const long double n[3] = {lookup.p[0], lookup.p[1], lookup.p[2]}, to[3] = {place[0], place[1], place[2]};
    const long double x[3] = {lookup.dx[0], lookup.dx[1], lookup.dx[2]};
    const long double y[3] = {lookup.dy[0], lookup.dy[1], lookup.dy[2]};
    Value out;
    for (int c = 0; c < 4; ++c) {
      const shd::ref::DirectionTexels texels = tables_.channel(c);
      out[static_cast<size_t>(c)] =
          image_.sampler.filter == SHD_FILTER_BICUBIC
              ? shd::ref::bicubic(texels, image_.sampler.cubic, to)
              : shd::ref::direction_average(texels, shd::ref::direction_footprint(image_.projection, n, x, y),
                                            kSamples);
    }
    return out;
  }

  /// EWA: a texel beyond an edge is the one that contains the direction of its centre.
  Value ellipse_on_directions(const Point& at) const {
    const Image flat = plane(at.layer);
    const Ellipse e = ellipse_of(at.d);
    const int level = static_cast<int>(ewa_lod(flat, e));
    const auto w = static_cast<double>(flat.levels[level].width), h = static_cast<double>(flat.levels[level].height);
    const double share = ewa_bilinear_share(flat, e);
    const auto texel_at = [&](int64_t x, int64_t y, int c) {
      UnitPoint centre = {(static_cast<double>(x) + 0.5) / w, (static_cast<double>(y) + 0.5) / h, 0};
      int face = at.layer;
      if (image_.projection == SHD_PROJECTION_CUBE) {
        long double n[3];
        ref_unproject(SHD_PROJECTION_CUBE, centre[0], centre[1], static_cast<uint32_t>(face), n);
        const ref_place on = ref_on_face(n, unit_face(unit_, n));
        centre = {static_cast<double>(on.u), static_cast<double>(on.v), 0}, face = static_cast<int>(on.face);
      } else {
        move_inside(image_, &centre, &face);
      }
      return unit_nearest(image_, unit_, face, level, centre)[static_cast<size_t>(c)];
    };
    double average[4] = {0, 0, 0, 0};
    if (share < 1)
      ellipse_average(ewa_axes(flat, e, level), e, at.p[0] * w - 0.5, at.p[1] * h - 0.5, texel_at, average);
    Value out = unit_linear(image_, unit_, at.layer, level, at.p);
    for (size_t c = 0; c < 4; ++c) out[c] = mix(average[c], out[c], share);
    return out;
  }

  UnitImage image_;
  FilterTables tables_;
  Unit unit_;
};

}  // namespace ref
