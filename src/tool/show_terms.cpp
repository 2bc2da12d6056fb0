// SPDX-License-Identifier: MIT
#include "command/failure.h"
#include "tool/show.h"

Picture show_terms(const Stage& stage, const Frame& frame) {
  const shd_model model = model_of(stage.options, stage.model);
  if (!has_terms(model)) {
    throw Failure(kExitUsage, std::string("--show terms: the terms of ") + shd_model_name(model) +
                                  " do not add up; see --model phong");
  }
  std::vector<Picture> panels;
  for (const Term term : {Term::kAmbient, Term::kDiffuse, Term::kSpecular, Term::kAll}) {
    Options options = stage.options;
    options.term = term;
    const Paint paint = make_paint(stage.context, options, stage.model, stage.uv);
    Frame one;
    one.camera = frame.camera;
    one.draws = make_draws(stage.context, options, stage.model, paint, frame.camera);
    render(stage, options, one, shd_progress{});
    panels.push_back(read_picture(stage.framebuffer.get()));
  }
  return join_pictures(panels);
}
