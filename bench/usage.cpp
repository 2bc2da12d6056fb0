// SPDX-License-Identifier: MIT
#include "usage.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <string_view>

namespace shd::bench {
namespace {

struct Line {
  const char *name, *text;
};

/// The first parts of the names of rows. tests/check_usage.py compares them with the rows and with README.md.
constexpr Line kGroups[] = {
    {"texture", "lookups: filters x formats, a floor and random places, 2D, 3D and directions"},
    {"call", "calls of few lookups"},
    {"worst", "the dearest kind of footprint by the median one"},
    {"quality", "PSNR of filters against supersampling; no speed"},
    {"default", "PSNR of rules of the level of detail; no speed"},
    {"frame", "whole frames: spheres, surfaces, lights, models, samples, blending"},
    {"scaling", "speed-up by workers"},
    {"shadow", "lookups in shadow maps, and rendering the maps"},
    {"solid", "solid textures: noise, marble, wood"},
    {"polyhedron", "coordinates on polyhedra, and values interpolated by them"},
    {"volume", "rays through 3D textures"},
    {"occlusion", "ambient occlusion at vertices and in textures"},
    {"environment", "making an environment"},
    {"mesh", "making and tessellating meshes"},
    {"create", "making a texture"},
    {"mipmap", "making a texture with mip levels"},
    {"update", "replacing a part of a texture with mip levels"},
#ifdef SHD_BENCH_OIIO
    {"load", "PNG files by libshd_io, in the process and by its worker"},
    {"tiles", "frames from tiled files that are not in memory"},
#endif
#ifdef SHD_BENCH_COLOR
    {"display", "framebuffers to display pixels by libshd_color"},
    {"present", "frames and their display in one call"},
#endif
};

constexpr Line kVariables[] = {
    {"SHD_BENCH_WRITE=FOLDER", "writes the pictures of rows with a peer as PPM"},
    {"SHD_BENCH_PHOTOGRAPHS=FOLDER", "adds photographs to default/"},
    {"SHD_BENCH_FLICKER=1", "adds flicker over 60 frames to default/"},
    {"SHD_BENCH_DETAIL=1", "adds the figures of each picture to default/"},
};

constexpr char kHead[] =
    "shd-bench: speed of libshd, beside other libraries on the same work\n"
    "\n"
    "  shd-bench --list                                  names of all rows\n"
    "  shd-bench --benchmark_filter='^texture/trilinear/rgba8/.*/floor/edge:2048'\n"
    "  shd-bench --benchmark_filter='^frame/quad/' --benchmark_out=quad.json\n"
    "  shd-bench --benchmark_filter='^call/ewa/' --benchmark_repetitions=9 --benchmark_report_aggregates_only=true\n"
    "\n"
    "A row is GROUP/WHAT/.../WHO[/WHERE][/SIZE:N]. WHO is a SIMD target of shd or a peer. Rows of shd print their "
    "ratio\n"
    "to a peer that ran before them in the same process, so a filter for ratios matches both.\n"
    "\n"
    "Groups (bench/README.md describes each row):\n";

constexpr char kOptions[] =
    "\n"
    "Options of Google Benchmark. --benchmark_min_time is in seconds: 0.5 until version 1.7, 0.5s from 1.8 on.\n";

void print_lines(const Line* begin, const Line* end, int width) {
  for (const Line* line = begin; line != end; ++line) std::printf("  %-*s  %s\n", width, line->name, line->text);
}

void print_help() {
  std::fputs(kHead, stdout);
  print_lines(std::begin(kGroups), std::end(kGroups), 12);
  std::printf("\nEnvironment:\n");
  print_lines(std::begin(kVariables), std::end(kVariables), 28);
  print_missing_peers();
  std::fputs(kOptions, stdout);
  std::fflush(stdout);
}

}  // namespace

void print_missing_peers() {
  const auto missing = [](const char* peer, const char* package) {
    std::printf("\nNot in this build: %s (Debian: %s)\n", peer, package);
  };
#ifndef SHD_BENCH_OSMESA
  missing("llvmpipe", "libosmesa6-dev");
#endif
#ifndef SHD_BENCH_OIIO
  missing("OpenImageIO", "libopenimageio-dev");
#endif
#ifndef SHD_BENCH_OCIO
  missing("OpenColorIO", "libopencolorio-dev");
#endif
  static_cast<void>(missing);
}

void read_usage(int argc, char** argv) {
  static char help[] = "--help", list[] = "--benchmark_list_tests=true";
  bool wants_help = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "-h") argv[i] = help;
    if (argument == "--list") argv[i] = list;
    wants_help = wants_help || argument == "-h" || argument == "--help";
  }
  if (wants_help) print_help();
}

int status_of(size_t matched) {
  if (matched > 0) return 0;
  std::fprintf(stderr,
               "shd-bench: --benchmark_filter=%s matches no row; --list prints their names, --help the groups\n",
               benchmark::GetBenchmarkFilter().c_str());
  return 1;
}

}  // namespace shd::bench
