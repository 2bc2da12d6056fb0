// SPDX-License-Identifier: MIT
#include "options.h"

#include <algorithm>
#include <cstdio>

#include "command/values.h"

namespace farm {
namespace {

using namespace command;

Values sample_values(uint32_t& out) {
  const auto read = [&out](const std::string& text) { return number(out, 1, 16).read(text) && (out & (out - 1)) == 0; };
  return {"1, 2, 4, 8 or 16", {}, std::to_string(out), read};
}

Values orbit_values(Options& out) {
  const auto read = [&out](const std::string& text) {
    const std::vector<std::string> angles = split(text, ',');
    return angles.size() == 2 && number(out.azimuth, -360, 360).read(angles[0]) &&
           number(out.elevation, -5, 85).read(angles[1]);
  };
  return {"AZIMUTH,ELEVATION in degrees, -360..360 and -5..85", {}, "35,30", read};
}

Group picture_options(Options& out) {
  return {"Picture",
          {{"-o,--output", "FILE", file(out.output), "The picture, which ends with .exr."},
           {"--size", "WxH", size({out.width, out.height}, 65536), "Pixels of a picture."},
           {"--samples", "N", sample_values(out.samples), "Samples of a pixel."},
           {"--supersampling", "N", number(out.supersampling, 1, 16),
            "Average N x N pixels. Size times N is at most 65536."},
           {"--frames", "N", number(out.frames, 1, 9999), "Frames of one turn around the scene."},
           {"--frame", "N", initially(number(out.frame, 0, 9998), "all"), "Only this frame, for arrays of jobs."},
           {"--model", "FILE", initially(file(out.model), "a scene made in code"), "A model with its textures."},
           {"--copies", "N", number(out.copies, 1, 32), "The model stands in N x N places."},
           {"--orbit", "A,E", orbit_values(out), "Azimuth and elevation of the camera."}}};
}

Group job_options(Options& out) {
  return {
      "Job",
      {{"--window", "N", number(out.window, 16, 4096), "Edge length of windows and of tiles of the file."},
       {"--threads", "N", number(out.threads, 1, 1024), "Threads of each rank."},
       {"--single", "ROWS", initially(number(out.single, 1, 16384), ""),
        "One process without MPI, in bands of up to ROWS rows."},
       {"--through-root", "", flag(out.through_root),
        "Send windows to rank 0, which alone writes. Without it each rank writes its windows."},
       {"--no-reserve", "", flag(out.reserve, false), "Do not allocate the space of a file when it is begun."},
       {"--timeout", "SECONDS", number(out.timeout, 1, 86400, " seconds"), "End the job when a rank does not answer."},
       {"--fresh", "", flag(out.fresh), "Remove earlier work instead of resuming it."},
       {"--times", "FILE", file(out.times), "Write seconds of each window as CSV."}}};
}

void check_together(const Options& o) {
  refuse_if(o.frame >= int64_t{o.frames}, "--frame: " + std::to_string(o.frame) + " is not in 0.." +
                                              std::to_string(o.frames - 1) + ", the range of --frames");
  refuse_if(uint64_t{std::max(o.width, o.height)} * o.supersampling > 65536,
            "--supersampling: " + std::to_string(o.supersampling) + " times --size is above 65536");
  const bool is_exr = o.output.size() > 4 && o.output.substr(o.output.size() - 4) == ".exr";
  refuse_if(!is_exr, "-o: " + o.output + " does not end with .exr");
  refuse_if(o.single && o.single % o.window && o.single < o.height,
            "--single: " + std::to_string(o.single) + " is no multiple of --window, " + std::to_string(o.window));
  refuse_if(o.single && o.width > 16384, "--single: pictures are at most 16384 pixels wide");
}

}  // namespace

bool read_options(int argc, char** argv, Options* options) {
  const Program program = {"shd-farm",
                           "render a picture on the ranks of an MPI job",
                           "[options]",
                           "Renders one picture, or frames of a turn around a scene, under mpirun.",
                           {picture_options(*options), job_options(*options)},
                           {}};
  std::vector<std::string> rest;
  if (!parse(program, argc, argv, rest)) return false;
  if (!rest.empty()) throw Failure(kExitUsage, "\"" + rest[0] + "\" is not an option");
  check_together(*options);
  return true;
}

std::string frame_path(const Options& options, uint32_t frame) {
  if (options.frames == 1) return options.output;
  char digits[16];
  std::snprintf(digits, sizeof digits, ".%04u.exr", frame);
  return options.output.substr(0, options.output.size() - 4) + digits;
}

}  // namespace farm
