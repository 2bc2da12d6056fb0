// SPDX-License-Identifier: MIT
/// shd-render: pictures of a 3D model.
#include <algorithm>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <vector>

#include <unistd.h>

#include "command/program.h"
#include "tool/compare.h"
#include "tool/cryptomatte.h"
#include "tool/output.h"
#include "tool/progress.h"
#include "tool/show.h"
#include "tool/tables.h"
#include "tool/zoom.h"

namespace {

Context make_context(const Options& options) {
  shd_context_desc desc = shd_context_desc_default();
  desc.worker_count = options.threads;
  desc.simd = options.simd;
  Context context;
  check(shd_context_create(&desc, context.out()), "context");
  return context;
}

void output(const Color& color, const Options& options, const shd_framebuffer* framebuffer, const std::string& name,
            const FileExtras& extras) {
  if (options.hash) {
    std::printf("%016" PRIx64 "\n", picture_hash(framebuffer));
    flush_stream();
  }
  if (!name.empty()) save_picture(color, framebuffer, options, name, extras);
}

/// The pictures of all settings side by side.
Picture compose(std::vector<Stage>& stages, uint32_t picture, uint32_t pictures, Progress& progress) {
  std::vector<Picture> parts;
  for (Stage& stage : stages) {
    const auto count = static_cast<uint32_t>(stages.size()), part = static_cast<uint32_t>(parts.size());
    const Frame frame = make_frame(stage, picture, pictures);
    parts.push_back(show_frame(stage, frame, progress.of_picture(count * picture + part)));
    if (stage.options.zoom.size > 0) parts.back() = zoom_picture(stage, frame, parts.back());
  }
  if (stages[0].options.difference) parts.push_back(difference_of(parts[0], parts[1]));
  return join_pictures(parts);
}

/// Saves a picture that the program has made.
void output(shd_context* context, const Color& color, const Options& options, const Picture& picture,
            const std::string& name) {
  output(color, options, write_picture(context, picture).get(), name, FileExtras());
}

void run(const std::vector<Options>& settings) {
  const Options& options = settings[0];
  const Context context = make_context(options);
  check_output(context.get(), options);
  const Color color = open_color(context.get(), options);
  if (shows_texture(options)) {
    output(context.get(), color, options, show_table(context.get(), options), picture_name(options, 0, 1));
    return;
  }
  std::vector<Stage> stages;
  for (const Options& setting : settings) {
    stages.push_back(open_stage(context.get(), setting, stages.empty()));
  }
  const uint32_t pictures = std::max({options.turntable, options.frames, static_cast<uint32_t>(options.shots.size())});
  const auto frames = pictures * static_cast<uint32_t>(stages.size());
  Progress progress(options.progress || isatty(STDERR_FILENO), frames);
  for (uint32_t i = 0; i < pictures; ++i) {
    const std::string name = picture_name(options, i, pictures);
    if (stages.size() > 1 || is_composed(options)) {
      output(context.get(), color, options, compose(stages, i, pictures, progress), name);
      continue;
    }
    Stage& stage = stages[0];
    const Frame frame = make_frame(stage, i, pictures);
    if (options.table) {
      output(context.get(), color, options, show_shadow_map(stage, frame), name);
      continue;
    }
    render(stage, options, frame, progress.of_picture(i));
    const shd_view& view = frame.camera.view;
    Mattes mattes;
    if (!name.empty()) mattes = make_mattes(context.get(), options, stage.model, view, frame.draws);
    output(color, options, stage.framebuffer.get(), name, mattes.extras(view));
  }
  progress.finish();
}

}  // namespace

int main(int argc, char** argv) {
  return command::run("shd-render", [&]() -> int {
    std::vector<Options> settings;
    if (!read_options(argc, argv, settings)) return kExitOk;
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of the output
    std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large is an error of write()
    run(settings);
    return kExitOk;
  });
}
