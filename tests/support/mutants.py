#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants known bugs into a copy of the tree, one by one, and checks that a test fails for each.

usage: mutants.py [--work DIR] [NAME ...]      NAME: rows of MUTANTS; none = all

A row fails if its text is not found exactly once, if its test does not pass before the bug is planted, if the bug does
not compile, or if the test still passes with it. --work keeps the copy and its build in DIR for the next run.
"""
import argparse
import collections
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DSHD_SIMD=scalar", "-DSHD_WITH_IO=OFF", "-DSHD_WITH_OCIO=OFF",
           "-DSHD_WITH_TBB=OFF", "-DSHD_BUILD_EXAMPLES=OFF"]
BUILD = "build/mutants"

# Source file, text that occurs once in it, replacement, CTest test that must fail.
Mutant = collections.namedtuple("Mutant", "path text bug test")
MUTANTS = {
    "fixed_one": Mutant("src/texture/format/fixed-inl.h", "hn::Min(s, hn::Set(d, 0x1.fffcp-1f))", "s",
                        "unit.texture.fixed"),
    "fixed_part": Mutant("src/texture/lookup/fixed_lines.cpp", "2 * first + 1)", "2 * (first & 15) + 1)",
                         "unit.texture.fixed"),
    "fixed_inside": Mutant("src/texture/lookup/fixed_lines.cpp", "extent - (texel + texel)", "extent + texel",
                           "unit.texture.fixed"),
    "rows_repeated": Mutant("src/texture/filter/rows-inl.h", "    if (!blended_) repeat_first();\n", "",
                            "unit.texture.fixed"),
    "tile_waits_inside": Mutant("src/texture/store/tiles/load.cpp", "load.around || wait.impatient, &load",
                                "wait.impatient, &load", "unit.texture.tile_orders"),
    "tile_readers": Mutant("src/texture/store/tiles/slots.cpp",
                           "if (slot.readers.load(std::memory_order_seq_cst) != 0) {", "if (false) {",
                           "unit.texture.tile_orders"),
    "tile_wake": Mutant("src/texture/store/tiles/load.cpp", "load->count;\n    changed_.notify_all();", "load->count;",
                        "unit.texture.tile_orders"),
    "tile_slot_wait": Mutant("src/texture/store/tiles/load.cpp", "if (stuck_ == callbacks_ || ", "if (",
                             "unit.texture.tile_orders"),
    "tile_alone": Mutant("src/texture/store/tiles/load.cpp", "  wait->alone = true;\n  return false;",
                         "  throw core::Failure(result, core::last_error());", "unit.texture.tile_orders"),
    "tile_lease": Mutant("src/texture/store/tiles/resolve.cpp", "    call_.give_lease();\n", "", "unit.texture.tile_orders"),
    "tile_pins": Mutant("src/texture/store/tiles/slots.cpp", "[](TileSlot& pinned) { pinned.state",
                        "[](TileSlot& pinned) { pinned.pins = 0; pinned.state", "unit.texture.tile_orders"),
    "tile_release": Mutant("src/core/call.cpp", "if (!callback || object->birth >= callback->number) return false;",
                           "if (object) return false;", "api.tiles_callback"),
    "weighted_power": Mutant("src/film/unordered.cpp", "3000.0f * (near * near * near)", "3000.0f * (near * near)",
                             "api.render_blend"),
    "sorted_ties": Mutant("src/film/unordered.cpp", "return a.order < b.order;", "return a.order > b.order;",
                          "api.render_blend"),
    "early_not_equal": Mutant("src/frame/blended_pass.cpp",
                              "compare == SHD_COMPARE_NOT_EQUAL ? SHD_COMPARE_ALWAYS : compare", "compare",
                              "api.render_blend"),
    "cutoff_tie": Mutant("src/frame/blended_pass.cpp", "color->channel[3] < material.alpha_cutoff",
                         "color->channel[3] <= material.alpha_cutoff", "api.render_blend"),
    "snapped_rows": Mutant("src/light/shadow_fit.cpp", "std::floor(middle[1] / texel + 0.5) * texel", "middle[1]",
                           "api.shadow_casters"),
    "small_powers": Mutant("src/simd/math-inl.h", "hn::Ge(power, hn::Set(d, -96.0f))",
                           "hn::Ge(power, hn::Set(d, -126.0f))", "unit.simd.math"),
    "bare_mixed": Mutant("src/raster/fragments.cpp", "if (bare_samples) out->bare", "if (false) out->bare",
                         "api.render_targets"),
    "bare_width": Mutant("src/film/tile_planes.cpp", "std::min(end - begin, area.width - x)", "end - begin - 1",
                         "api.render_targets"),
    "usual_select": Mutant("src/simd/choices-inl.h", "Select(M mask, V value, V) {\n    usual = hn::And(usual, mask);",
                           "Select(M, V value, V) {", "unit.shade.lobe_edges"),
    "usual_floor": Mutant("src/simd/choices-inl.h", "usual = hn::And(usual, hn::Ge(x, floor));", "(void)floor;",
                          "unit.shade.lobe_edges"),
    "usual_half": Mutant("src/material/blinn_phong-inl.h", "one), hn::Neg(one));", "one), one);",
                         "unit.shade.lobe_edges"),
    "usual_terms": Mutant("src/shade/illuminate.cpp", "  FindTermsOfAny(block, light, out);\n", "",
                          "unit.shade.lobe_edges"),
    "normal_gain": Mutant("src/shade/illuminate.cpp", "out.weight[0] = reflector.gain", "out.weight[0] = out.falloff",
                          "unit.shade.slope_spread"),
    "copied_end": Mutant("src/film/copy_runs.cpp", "CopyVector(d, from, last, to);",
                         "CopyVector(d, from, last - (last > 0), to);", "unit.film.copy_runs"),
    "row_width": Mutant("src/raster/append_rows.cpp", "hn::And(pixels, in_row)", "pixels", "unit.raster.append_rows"),
    "row_next": Mutant("src/frame/fragment_batch.h", "runs[end++], done);", "runs[end], done);",
                       "api.render"),
    "span_end": Mutant("src/raster/spans-inl.h", "return std::min(end, i + static_cast<size_t>(other));", "return end;",
                       "unit.raster.interpolate"),
    "lit_bound": Mutant("src/raster/lit_rows-inl.h", "return sum < 0x1p120f;", "return sum == sum || true;",
                        "unit.raster.interpolate_range"),
    "lit_columns": Mutant("src/raster/lit_rows-inl.h", "u.dx, v.dx, u.dy, v.dy", "u.dx, u.dy, v.dx, v.dy",
                          "unit.raster.interpolate"),
    "only_diffuse": Mutant("src/shade/combine.cpp", "slot != SHD_SLOT_DIFFUSE && parameters",
                           "slot >= material::kSlotCount && parameters", "unit.shade.coefficients"),
    "same_blue": Mutant("src/film/tile_color.cpp", "(other[0] ^ first[0]) | (other[1] ^ first[1])",
                        "other[0] ^ first[0]", "api.render_samples"),
    "whole_nearest_depth": Mutant("src/raster/coverage.cpp", "passes(test, z.high, stored.low)",
                                  "passes(test, z.low, stored.low)", "unit.raster.coverage"),
    "stream_last_line": Mutant("src/film/stream_rows.cpp", "x + kLine <= width", "x + kLine < width + kLine",
                               "api.render_large"),
    "stream_rows_next": Mutant("src/film/stream_rows.cpp", "to.word += to.stride", "to.word += to.stride - 16",
                               "api.render_large"),
    "whole_keeps_range": Mutant("src/raster/coverage.cpp", "  tile.range = range;\n", "", "unit.raster.coverage"),
    "small_top_left": Mutant("src/raster/small_triangles-inl.h", "hn::And(hn::Eq(a, zero), hn::Gt(b, zero))",
                             "hn::Eq(a, zero)", "unit.raster.coverage"),
    "small_box": Mutant("src/raster/small_triangles-inl.h",
                        "row * 0x11111111u & 0xffffffffu >> (32 - kMaskColumns * rows)", "row * 0x11111111u",
                        "unit.raster.coverage"),
    "texture_left": Mutant("src/raster/texture_places.cpp", "static_cast<float>(pixels.left) + 0.5f",
                           "static_cast<float>(pixels.left) + 1.5f", "unit.raster.interpolate"),
    "texture_cell": Mutant("src/frame/texture_batch.cpp", "left + raster::kTile);", "left + raster::kTile - 1);",
                           "api.render_one_texture"),
    "plane_cell": Mutant("src/raster/interpolate.cpp", "const bool is_cell = (f.left | f.top) % kTile == 0;",
                         "const bool is_cell = true;", "unit.raster.interpolate"),
    "plane_sign": Mutant("src/raster/planes.cpp", "determinant < 0.0 ? -1.0 : 1.0", "1.0", "unit.raster.interpolate"),
    "plane_range": Mutant("src/raster/planes.cpp", "static_cast<float>(high - double{base})}", "HUGE_VALF}",
                          "unit.raster.interpolate"),
    "direct_alpha": Mutant("src/texture/format/consume_rows-inl.h", "0xff000000u", "0xfe000000u",
                           "api.render_one_texture"),
    "call_hulls": Mutant("src/abi/call_in_place.h", "other.before >= most + (size - 1)", "other.before >= most",
                         "api.lookup_small"),
    "call_channels": Mutant("src/abi/call_in_place.h", "apart(3, 0) && apart(3, 1) && ", "apart(3, 0) && ",
                            "api.lookup_small"),
    "call_strides": Mutant("src/abi/call_in_place.h", "(count != 1 || strides > PTRDIFF_MAX)", "strides > PTRDIFF_MAX",
                           "api.lookup_small"),
    "fast_border": Mutant("src/texture/lookup/fast.h", "if (has_border(texture, sampler)) return false;", "",
                          "unit.texture.support_cells"),
    "code_tie": Mutant("src/texture/format/consume_rows-inl.h", "256.5f + 0x1p-13f", "256.5f + 0x1p-9f",
                       "api.render_one_texture"),
    "row_split": Mutant("src/texture/filter/rows-inl.h",
                        "hn::And(hn::Eq(x.i1, x.i0 + one), hn::Eq(y.i1, y.i0 + one))", "hn::Eq(x.i1, x.i0 + one)",
                        "unit.texture.rows"),
    "row_level": Mutant("src/texture/filter/trilinear-inl.h", "static_cast<uint32_t>(lod.most) == out->fine", "true",
                        "unit.texture.rows"),
    "row_part": Mutant("src/texture/filter/rows-inl.h", "lod ? lod + begin : nullptr", "lod", "unit.texture.rows"),
    "row_colors": Mutant("src/texture/format/consume_rows-inl.h", "to.left - i, to.channel[c] + i",
                         "hn::Lanes(d), to.channel[c + 0 * i]", "unit.texture.rows"),
    "viewport_top": Mutant("src/geometry/vertex.cpp", "static_cast<float>(top + half_height)",
                           "static_cast<float>(half_height)", "api.vertex_program"),
    "cancel_result": Mutant("src/frame/frame.cpp", "    if (result_ == SHD_OK) return;\n",
                              "    if (core::enum_bits(result_) < 8) return;\n", "api.render_progress"),
    "hidden_blocks": Mutant("src/frame/stats.h", "  frame->hidden_sample_count += piece.hidden_sample_count;\n", "",
                            "api.render_supersampling"),
    "cookie_sampler": Mutant(
        "src/light/light.cpp",
        "  core::release(sampler_object, static_cast<uint32_t>(core::ObjectType::kSampler));\n", "", "api.lifecycle"),
    "repeated_point": Mutant("src/geometry/outline.cpp", " || (k > 1 && row[k] == row[1])", "",
                             "unit.geometry.outline"),
    "sums_of_layers": Mutant("src/texture/table/update.cpp", "texture->mip_sums_ready[layer]",
                             "texture->mip_sums_ready[0]", "unit.texture.update"),
    "slot_sampler": Mutant("src/abi/material.cpp", "(desc.texture || desc.sampler)", "desc.texture", "api.material"),
    "tangent_sign": Mutant("src/geometry/tessellate.cpp",
                           "      mesh->tw[i] = mesh->tw[i] < 0.0f ? -1.0f : 1.0f;\n", "", "api.tessellate"),
    "nan_picks": Mutant("src/texture/filter/stochastic.cpp", "FiniteOrZero(d, hn::LoadU(d, from.v + i))",
                        "hn::LoadU(d, from.v + i)", "api.lookup_bad_coordinates"),
    "endless_ellipse": Mutant("src/texture/domain/ellipses.cpp",
                              "one / hn::Max(roundness, hn::Set(d, 1.0f / sampler.max_anisotropy))",
                              "one / hn::Max(roundness, hn::Set(d, 1e-4f))", "api.lookup_bad_footprints"),
    "many_levels": Mutant("src/abi/texture_desc.cpp",
                          "texture::full_level_count(desc.width, desc.height, desc.depth) - 1", "63", "api.bad_sizes"),
    "any_displacement": Mutant(
        "src/abi/tessellate.cpp",
        "  SHD_TRY(read_handle(\"tessellation.displacement\", desc.displacement, core::ObjectType::kTexture, "
        "&out->texture));\n",
        "", "api.host_handles_more"),
    "slice_rows": Mutant("src/texture/filter/slices-inl.h",
                         " * UnitsAlong(d, level.down.whole, unit.shift_y)", " * level.down.whole",
                         "unit.texture.support_cells"),
    "tile_axes": Mutant("src/texture/store/tiles/kept-inl.h",
                        "hn::And(y, hn::Set(DI(), last_y_)), static_cast<int>(shape_.shift_x)",
                        "hn::And(y, hn::Set(DI(), last_y_)), static_cast<int>(shape_.shift_y)",
                        "unit.texture.support_cells"),
    "tile_row_edge": Mutant("src/texture/store/tiles/place_rows.cpp", "hn::Set(di, last_x_ - 1) - x",
                            "hn::Set(di, last_x_) - x", "api.store_lines"),
    "tile_row_apart": Mutant("src/texture/store/tiles/place_rows.cpp", "y = k < 2 ? top : bottom;",
                             "y = k % 2 ? top : bottom;", "api.store_lines"),
    "block_row_down": Mutant("src/texture/store/bc/place_rows.cpp", "quads->down = lower - upper;",
                             "quads->down = static_cast<int32_t>(cache_.pitch);", "api.store_lines"),
    "unit_slice": Mutant("src/texture/store/storage.cpp", "slice = slice_units(texture, level);",
                         "slice = slice_units(texture, 0);", "unit.texture.support_cells"),
    "folded_row": Mutant("src/texture/domain/folds/octahedral-inl.h", "hn::IfThenElse(beside_x, last - in_y, in_y)",
                         "hn::IfThenElse(beside_x, in_y, in_y)", "unit.texture.support_cells"),
    "slope_sign": Mutant("src/texture/format/gradient-inl.h",
                         "            MixSlopes(d, a.dv, b.dv, t, a.value, b.value, hn::Load(d, rate))};",
                         "            MixSlopes(d, a.dv, b.dv, t, b.value, a.value, hn::Load(d, rate))};",
                         "unit.texture.support_cells"),
    "decoded_layer": Mutant("src/texture/table/decoded.cpp", "level == 0 ? layer * base :", "level == 0 ? 0 * base :",
                            "unit.texture.support_cells"),
    "bounds_fold": Mutant("src/texture/oracle/bounds/fold.cpp", "      j = n - 1 - j;\n", "",
                          "unit.texture.support_cells"),
    "later_reference": Mutant("src/texture/format/compared-inl.h", "lookups.reference + lookups.done",
                              "lookups.reference", "unit.texture.support_cells"),
}


def copy_tree(work):
    """Copies the files of the working tree whose content differs, so that a kept build rebuilds little. Removes sources
    that the tree no longer has."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                            check=True, stdout=subprocess.PIPE).stdout.decode().split("\0")
    for name in filter(None, listed):
        source, copy = ROOT / name, work / name
        if not source.is_file() or (copy.is_file() and copy.read_bytes() == source.read_bytes()):
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, copy)
        copy.touch()
    for name in ("src", "tests"):
        for copy in (work / name).rglob("*"):
            if copy.is_file() and not (ROOT / copy.relative_to(work)).exists():
                copy.unlink()


def run(command, work):
    # ccache finds the objects of unchanged files again, although the directory differs from run to run.
    environment = dict(os.environ, CCACHE_BASEDIR=str(work), CCACHE_NOHASHDIR="1")
    done = subprocess.run(command, cwd=work, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode and command[0] == "cmake":
        print(done.stdout[-4000:])
    return done


def configure(work):
    command = ["cmake", "-S", ".", "-B", BUILD, "-G", "Ninja"] + OPTIONS
    if shutil.which("ccache"):
        command += ["-DCMAKE_C_COMPILER_LAUNCHER=ccache", "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
    return run(command, work).returncode == 0


def build(work, test):
    return run(["cmake", "--build", BUILD, "--target", "test_" + test.replace(".", "_")], work).returncode == 0


def passes(work, test):
    return run(["ctest", "--test-dir", BUILD, "--no-tests=error", "-R", "^" + test.replace(".", "\\.") + "$"],
               work).returncode == 0


def failure_of(work, mutant, passing):
    """Why a row is wrong, or an empty string. `passing` holds the tests that passed without a bug."""
    path = work / mutant.path
    original = path.read_text() if path.is_file() else ""
    if original.count(mutant.text) != 1:
        return f"{mutant.path} has the text {original.count(mutant.text)} times, not once"
    if mutant.test not in passing:
        if not build(work, mutant.test) or not passes(work, mutant.test):
            return f"{mutant.test} does not pass without the bug"
        passing.add(mutant.test)
    path.write_text(original.replace(mutant.text, mutant.bug))
    try:
        if not build(work, mutant.test):
            return "the bug does not compile"
        return f"{mutant.test} passes" if passes(work, mutant.test) else ""
    finally:
        path.write_text(original)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args()
    unknown = [name for name in options.names if name not in MUTANTS]
    if unknown:
        parser.error(f"no such bug: {', '.join(unknown)}; known: {', '.join(MUTANTS)}")
    work = (options.work or pathlib.Path(tempfile.mkdtemp(prefix="shd_mutants_"))).resolve()
    if (work / ".git").exists():
        parser.error(f"{work} is a checkout, not a copy")
    failures, passing = 0, set()
    try:
        copy_tree(work)
        if not configure(work):
            return 1
        for name in options.names or MUTANTS:
            failure = failure_of(work, MUTANTS[name], passing)
            print(f"{name}: {failure or 'found by ' + MUTANTS[name].test}", flush=True)
            failures += bool(failure)
    finally:
        if not options.work:
            shutil.rmtree(work)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
