// SPDX-License-Identifier: MIT
// occlusion/<method>/<target>/triangles:100352/rays:64: occlusion at the 50658 vertices of a teapot with all cores:
// `embree` by the tracer of libshd_embree, with the time of its tree, `maps` by depth maps of 1024 x 1024 texels.
// occlusion/bake/<target>: the uv-space pass alone, an unlit atlas of 1024 x 1024 texels with 4 texels of dilation.
// Items are points or texels.
#include <vector>

#include "bench.h"

#ifdef SHD_BENCH_EMBREE
#include <shd/embree.h>
#endif

namespace shd::bench {
namespace {

constexpr uint32_t kAtlas = 1024;

struct Model {
  shd_context* context;
  shd_mesh* mesh = nullptr;
  shd_material* material = nullptr;
  shd_draw draw = shd_draw_default();
  shd_mesh_info info = shd_mesh_info_default();

  explicit Model(shd_simd simd) : context(make_context(simd, 0)) {
    shd_shape_desc shape = shd_shape_desc_default();
    shd_material_desc unlit = shd_material_desc_default();
    shape.kind = SHD_SHAPE_TEAPOT;
    shape.segments[0] = 40;
    check(shd_mesh_create_shape(context, &shape, SHD_MESH_NONE, &mesh));
    check(shd_mesh_get_info(mesh, &info));
    unlit.model = SHD_MODEL_UNLIT;
    check(shd_material_create(context, &unlit, &material));
    draw.mesh = mesh;
    draw.material = material;
  }
  ~Model() {
    shd_material_release(material);
    shd_mesh_release(mesh);
    shd_context_release(context);
  }
};

void compute(benchmark::State& state, shd_simd simd, bool traced) {
  Model model(simd);
  std::vector<float> value(model.info.vertex_count);
  const shd_f32_out out = {value.data(), 0};
  for (auto _ : state) {
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    desc.draws = &model.draw;
    desc.draw_count = 1;
#ifdef SHD_BENCH_EMBREE
    shd_embree* tree = nullptr;
    if (traced) {
      check(shd_embree_create(model.context, &model.draw, 1, &tree));
      check(shd_embree_get_tracer(tree, &desc.tracer));
    }
#endif
    check(shd_occlusion_compute_vertices(model.context, &desc, &model.draw, &out));
    benchmark::DoNotOptimize(value.data());
#ifdef SHD_BENCH_EMBREE
    shd_embree_release(tree);
#endif
  }
  (void)traced;
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations()) * model.info.vertex_count);
}

void bake(benchmark::State& state, shd_simd simd) {
  Model model(simd);
  shd_framebuffer_desc target = shd_framebuffer_desc_default();
  shd_render_desc frame = shd_render_desc_default();
  shd_bake_desc desc = shd_bake_desc_default();
  target.width = target.height = kAtlas;
  check(shd_framebuffer_create(model.context, &target, &frame.framebuffer));
  frame.draws = &model.draw;
  frame.draw_count = 1;
  desc.dilation = 4;
  for (auto _ : state) check(shd_bake(model.context, &frame, &desc));
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations()) * kAtlas * kAtlas);
  shd_framebuffer_release(frame.framebuffer);
}

}  // namespace

void register_occlusion() {
  for (const Target& target : targets()) {
    const std::string tail = "/" + target.name + "/triangles:100k/rays:64";
    const auto row = [](const std::string& name, auto body) {
      benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond)->UseRealTime();
    };
    const shd_simd simd = target.simd;
#ifdef SHD_BENCH_EMBREE
    row("occlusion/embree" + tail, [simd](benchmark::State& state) { compute(state, simd, true); });
#endif
    row("occlusion/maps" + tail, [simd](benchmark::State& state) { compute(state, simd, false); });
    row("occlusion/bake/" + target.name, [simd](benchmark::State& state) { bake(state, simd); });
  }
}

}  // namespace shd::bench
