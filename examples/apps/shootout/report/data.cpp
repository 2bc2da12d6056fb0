// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "json.h"
#include "report.h"

namespace shootout {
namespace {

void write_errors(const char* name, const Errors& e, Json* json) {
  json->key(name).begin_array();
  for (const double value : {e.psnr, e.ssim, e.mean, e.max, e.flip}) json->value(value, 5);
  json->end_array();
}

void write_rows(const Measurements& m, Json* json) {
  json->key("rows").begin_array();
  for (const Row& row : m.rows) {
    json->begin_object();
    json->member("w", static_cast<double>(row.workload)).member("t", static_cast<double>(row.texture));
    json->member("s", static_cast<double>(row.setting)).member("hash", row.hash);
    write_errors("samples", row.samples, json);
    write_errors("exact", row.exact, json);
    if (row.spectrum) {
      json->member("aliasing", row.spectrum->aliasing, 4).member("blur", row.spectrum->blur, 4);
    }
    json->end_object();
  }
  json->end_array();
}

void write_costs(const Measurements& m, const Costs& costs, Json* json) {
  json->key("costs").begin_array();
  for (const CostRow& row : costs.lookups) {
    json->begin_object();
    json->member("w", static_cast<double>(row.workload)).member("s", static_cast<double>(row.setting));
    json->member("texels", row.texels, 5).member("most_texels", row.most_texels, 5).member("bytes", row.bytes, 5);
    json->member("whole_ns", row.whole_ns, 4).member("cached_ns", row.cached_ns, 4);
    json->end_object();
  }
  json->end_array();
  json->key("tables").begin_array();
  for (const TableRow& row : costs.tables) {
    json->begin_object();
    json->member("s", static_cast<double>(row.setting)).member("build_ms", row.build_ms, 4);
    json->member("bytes", static_cast<double>(row.bytes), 10).end_object();
  }
  json->end_array();
  json->key("fronts").begin_array();
  for (const FrontRow& row : fronts(m, costs)) {
    json->begin_object();
    json->member("w", static_cast<double>(row.workload)).member("t", static_cast<double>(row.texture));
    json->member("peer", name_of(row.peer)).member("budget", row.budget);
    json->member("own", static_cast<double>(row.own)).member("other", static_cast<double>(row.other));
    json->member("lead", row.lead, 4).member("default_lead", row.default_lead, 4);
    json->member("on", row.lead >= -kTie ? 1.0 : 0.0);
    json->member("default_on", row.default_lead >= -kTie ? 1.0 : 0.0).end_object();
  }
  json->end_array();
}

void write_curves(const Measurements& m, uint32_t edge, Json* json) {
  json->key("motions").begin_array();
  for (const MotionRow& row : m.motions) {
    json->begin_object();
    json->member("w", static_cast<double>(row.workload)).member("t", static_cast<double>(row.texture));
    json->member("s", static_cast<double>(row.setting));
    json->member("psnr", row.motion.psnr, 5).member("flicker", row.motion.flicker, 4).end_object();
  }
  json->end_array();
  json->key("rosette").begin_array();
  for (const RosetteRow& row : m.rosette) {
    json->begin_object().member("s", static_cast<double>(row.setting)).key("errors").begin_array();
    for (const double value : row.errors) json->value(value, 3);
    json->end_array().end_object();
  }
  json->end_array();
  json->key("level_curve").begin_object().key("lod").begin_array();
  for (uint32_t x = 0; x < edge; ++x) json->value(level_curve_lod(x, edge), 4);
  json->end_array().key("settings").begin_array();
  for (const LevelRow& row : m.levels) {
    json->begin_object().member("s", static_cast<double>(row.setting)).key("contrast").begin_array();
    for (const double value : row.contrast) json->value(value, 4);
    json->end_array().end_object();
  }
  json->end_array().end_object();
}

template <class Items>
void write_names(const char* key, const Items& items, Json* json) {
  json->key(key).begin_array();
  for (const auto& item : items)
    json->begin_object().member("name", item.name).member("title", item.title).end_object();
  json->end_array();
}

void write_machine(const Options& options, const Machine& machine, Json* json) {
  json->key("machine").begin_object();
  json->member("cpu", machine.cpu).member("cores", static_cast<double>(machine.cores));
  json->member("compiler", machine.compiler).member("commit", machine.commit).member("date", machine.date).end_object();
  json->key("options").begin_object();
  json->member("edge", static_cast<double>(options.edge));
  json->member("texture_edge", static_cast<double>(options.texture_edge));
  json->member("samples", static_cast<double>(options.samples));
  json->member("movie_edge", static_cast<double>(options.movie_edge));
  json->member("movie_samples", static_cast<double>(options.movie_samples));
  json->member("quick", options.quick ? 1.0 : 0.0).end_object();
  for (const char* key : {"peers", "missing"}) {
    json->key(key).begin_array();
    for (const std::string& text : key[0] == 'p' ? peer_descriptions() : missing_peers()) json->value(text);
    json->end_array();
  }
}

}  // namespace

Machine this_machine() {
  Machine machine;
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    machine.cpu = line.substr(line.find(':') + 2);
    break;
  }
  if (machine.cpu.empty()) machine.cpu = "unknown processor";
  machine.cores = std::thread::hardware_concurrency();
  machine.compiler = SHOOTOUT_COMPILER;
  machine.commit = SHOOTOUT_COMMIT;
  const std::time_t seconds = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&seconds));
  machine.date = text;
  return machine;
}

std::string json_of(const Options& options, const Machine& machine, const Measurements& m, const Costs& costs) {
  Json json;
  json.begin_object();
  write_machine(options, machine, &json);
  write_names("workloads", m.workloads, &json);
  write_names("movies", m.movies, &json);
  write_names("textures", m.textures, &json);
  json.key("settings").begin_array();
  for (const Setting& setting : m.settings) {
    json.begin_object().member("name", setting.name).member("title", setting.title);
    json.member("who", name_of(setting.who)).member("estimated", setting.estimated ? 1.0 : 0.0).end_object();
  }
  json.end_array();
  write_rows(m, &json);
  write_costs(m, costs, &json);
  write_curves(m, options.edge, &json);
  json.end_object();
  return json.text();
}

std::string csv_of(const Measurements& m, const Costs& costs) {
  std::ostringstream csv;
  csv << "workload,texture,setting,by,psnr_db,ssim,mean,max,flip,exact_psnr_db,exact_ssim,exact_mean,exact_max,"
         "exact_flip,aliasing,blur,texels,most_texels,bytes,whole_ns,cached_ns,hash\n";
  const auto number = [&](double value) {
    csv << ',';
    if (std::isfinite(value)) csv << value;
  };
  std::vector<const CostRow*> cost_of(m.workloads.size() * m.settings.size());
  for (const CostRow& row : costs.lookups) cost_of[row.workload * m.settings.size() + row.setting] = &row;
  for (const Row& row : m.rows) {
    const Setting& setting = m.settings[row.setting];
    const CostRow& cost = *cost_of[row.workload * m.settings.size() + row.setting];
    csv << m.workloads[row.workload].name << ',' << m.textures[row.texture].name << ',' << setting.name << ','
        << name_of(setting.who);
    for (const Errors& e : {row.samples, row.exact}) {
      for (const double value : {e.psnr, e.ssim, e.mean, e.max, e.flip}) number(value);
    }
    number(row.spectrum ? row.spectrum->aliasing : NAN);
    number(row.spectrum ? row.spectrum->blur : NAN);
    for (const double value : {cost.texels, cost.most_texels, cost.bytes, cost.whole_ns, cost.cached_ns}) number(value);
    csv << ',' << row.hash << '\n';
  }
  return csv.str();
}

}  // namespace shootout
