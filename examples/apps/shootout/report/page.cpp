// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "report.h"

namespace shootout {
namespace {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw std::runtime_error(path + " cannot be read");
  return text.str();
}

/// Replaces the mark <!-- name --> by text; fails if the page does not have it.
void inline_text(const std::string& name, const std::string& text, std::string* page) {
  const std::string mark = "<!-- " + name + " -->";
  const size_t at = page->find(mark);
  if (at == std::string::npos) throw std::runtime_error("page.html has no mark " + mark);
  page->replace(at, mark.size(), text);
}

}  // namespace

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + " cannot be written");
}

void write_report(const Options& options, const Measurements& m, const Costs& costs, const Verdicts& verdicts) {
  const std::string data = json_of(options, this_machine(), m, costs);
  std::string page = read_file(options.web + "/page.html"), scripts;
  for (const char* name :
       {"base.js", "plots.js", "table.js", "compare.js", "taps.js", "curves.js", "verdicts.js", "main.js"}) {
    scripts += read_file(options.web + "/" + name);
  }
  inline_text("style", "<style>\n" + read_file(options.web + "/style.css") + "</style>", &page);
  const auto element = [](const char* id, const std::string& json) {
    return std::string("<script type=\"application/json\" id=\"") + id + "\">" + json + "</script>";
  };
  inline_text("data", element("data", data), &page);
  inline_text("pictures", element("pictures", pictures_json(options, m)), &page);
  inline_text("taps", element("taps-data", taps_json(options, m)), &page);
  inline_text("verdicts", element("verdicts-data", json_of(verdicts)), &page);
  inline_text("scripts", "<script>\n" + scripts + "</script>", &page);
  std::filesystem::create_directories(options.out);
  write_file(options.out + "/shootout.html", page);
  write_file(options.out + "/shootout.json", data + "\n");
  write_file(options.out + "/shootout.csv", csv_of(m, costs));
  write_file(options.out + "/verdicts.json", json_of(verdicts) + "\n");
}

}  // namespace shootout
