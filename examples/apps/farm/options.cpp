// SPDX-License-Identifier: MIT
#include "options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>

namespace farm {
namespace {

constexpr char kUsage[] =
    "Usage: mpirun -n RANKS shd-farm [option...]\n"
    "  --size WxH         pixels of a picture, 1..65536 each; default 1024x1024\n"
    "  --window N         edge length of windows and of tiles of the file, 16..4096; default 256\n"
    "  --samples N        samples of a pixel: 1, 2, 4, 8 or 16; default 4\n"
    "  --supersampling N  average N x N pixels, 1..16; size times N is at most 65536; default 1\n"
    "  --frames N         frames of one turn around the scene, 1..9999; default 1\n"
    "  --frame N          only this frame, 0..frames - 1, for arrays of jobs\n"
    "  --model FILE       a model with its textures; default a scene made in code\n"
    "  --copies N         the model stands in N x N places, 1..32; default 3\n"
    "  --orbit A,E        azimuth and elevation of the camera in degrees; default 35,30\n"
    "  --threads N        threads of each rank, 1..1024; default 1\n"
    "  --single ROWS      one process without MPI, bands of up to ROWS rows; 1..16384\n"
    "  --through-root     send windows to rank 0, which alone writes; default: each rank writes its windows\n"
    "  --no-reserve       do not allocate the space of a file when it is begun\n"
    "  --timeout SECONDS  end the job when a rank does not answer, 1..86400; default 60\n"
    "  --fresh            remove earlier work instead of resuming it\n"
    "  --times FILE       write seconds of each window as CSV\n"
    "  -o FILE            picture, ends with .exr; default farm.exr\n";

double number(const std::string& option, const std::string& text, double low, double high) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(value >= low && value <= high)) {
    char range[80];
    std::snprintf(range, sizeof range, " is not in %g..%g", low, high);
    throw std::invalid_argument(option + ": " + text + range);
  }
  return value;
}

uint32_t whole(const std::string& option, const std::string& text, uint32_t low, uint32_t high) {
  const double value = number(option, text, low, high);
  if (value != std::floor(value)) throw std::invalid_argument(option + ": " + text + " is not a whole number");
  return static_cast<uint32_t>(value);
}

/// "A<separator>B" in two parts.
std::pair<std::string, std::string> halves(const std::string& option, const std::string& text, char separator) {
  const size_t at = text.find(separator);
  if (at == std::string::npos) throw std::invalid_argument(option + ": " + text + " has no '" + separator + "'");
  return {text.substr(0, at), text.substr(at + 1)};
}

using Setter = std::function<void(const std::string&)>;

std::map<std::string, Setter> setters(Options* o) {
  const auto count = [](const char* name, uint32_t low, uint32_t high, uint32_t* to) {
    return [=](const std::string& text) { *to = whole(name, text, low, high); };
  };
  const auto string = [](std::string* to) { return [=](const std::string& text) { *to = text; }; };
  return {{"--size",
           [=](const std::string& text) {
             const auto [w, h] = halves("--size", text, 'x');
             o->width = whole("--size", w, 1, 65536), o->height = whole("--size", h, 1, 65536);
           }},
          {"--orbit",
           [=](const std::string& text) {
             const auto [a, e] = halves("--orbit", text, ',');
             o->azimuth = static_cast<float>(number("--orbit", a, -360, 360));
             o->elevation = static_cast<float>(number("--orbit", e, -5, 85));
           }},
          {"--window", count("--window", 16, 4096, &o->window)},
          {"--samples", count("--samples", 1, 16, &o->samples)},
          {"--supersampling", count("--supersampling", 1, 16, &o->supersampling)},
          {"--frames", count("--frames", 1, 9999, &o->frames)},
          {"--frame", [=](const std::string& text) { o->frame = whole("--frame", text, 0, 9998); }},
          {"--threads", count("--threads", 1, 1024, &o->threads)},
          {"--copies", count("--copies", 1, 32, &o->copies)},
          {"--single", count("--single", 1, 16384, &o->single)},
          {"--timeout", [=](const std::string& text) { o->timeout = number("--timeout", text, 1, 86400); }},
          {"--model", string(&o->model)},
          {"--times", string(&o->times)},
          {"-o", string(&o->output)}};
}

void check_together(const Options& o) {
  if (o.frame >= int64_t{o.frames}) {
    throw std::invalid_argument("--frame: " + std::to_string(o.frame) + " is not in 0.." +
                                std::to_string(o.frames - 1) + ", the range of --frames");
  }
  if (o.samples & (o.samples - 1)) {
    throw std::invalid_argument("--samples: " + std::to_string(o.samples) + " is not 1, 2, 4, 8 or 16");
  }
  if (uint64_t{std::max(o.width, o.height)} * o.supersampling > 65536) {
    throw std::invalid_argument("--supersampling: " + std::to_string(o.supersampling) + " times --size is above 65536");
  }
  if (o.output.size() < 5 || o.output.substr(o.output.size() - 4) != ".exr") {
    throw std::invalid_argument("-o: " + o.output + " does not end with .exr");
  }
  if (o.single && o.width > 16384) throw std::invalid_argument("--single: pictures are at most 16384 pixels wide");
}

}  // namespace

bool read_options(int argc, char** argv, Options* options) {
  const std::map<std::string, bool*> flags = {{"--through-root", &options->through_root}, {"--fresh", &options->fresh}};
  const auto values = setters(options);
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--help") {
      std::fputs(kUsage, stdout);
      return false;
    }
    if (name == "--no-reserve") {
      options->reserve = false;
    } else if (const auto flag = flags.find(name); flag != flags.end()) {
      *flag->second = true;
    } else if (const auto value = values.find(name); value == values.end()) {
      throw std::invalid_argument(name + ": no such option; --help lists them");
    } else if (++i == argc) {
      throw std::invalid_argument(name + ": its value is missing");
    } else {
      value->second(argv[i]);
    }
  }
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
