// SPDX-License-Identifier: MIT
#include "io/maketx/jobs.h"

#include <filesystem>
#include <map>

#include "command/failure.h"
#include "core/failure.h"
#include "io/file/printable.h"
#include "io/file/udim.h"

namespace {

constexpr const char* kMark = "<UDIM>";

bool is_set(const std::string& name) {
  return name.find(kMark) != std::string::npos;
}

std::vector<std::string> files_of(const std::string& input) {
  try {
    return shd::io::find_files(input).paths;
  } catch (const shd::core::Failure& failure) {
    throw Failure(kExitInput, failure.what());
  }
}

/// The output of a file of a set: OUTPUT with its number, or the name in a folder.
std::string output_of(const Options& options, const std::string& input, const std::string& file) {
  if (is_folder(options.output)) {
    const std::string name = std::filesystem::path(file).filename().replace_extension(".tx").string();
    return (std::filesystem::path(options.output) / name).string();
  }
  if (!is_set(input)) return options.output;
  std::string output = options.output;
  return output.replace(output.find(kMark), std::string(kMark).size(), file.substr(input.find(kMark), 4));
}

}  // namespace

bool is_folder(const std::string& output) {
  std::error_code error;
  return output.back() == '/' || std::filesystem::is_directory(output, error);
}

std::vector<Options> make_jobs(const Options& options) {
  const bool folder = is_folder(options.output);
  std::error_code error;
  if (folder && !std::filesystem::is_directory(options.output, error)) {
    throw Failure(kExitOutput, "-o: there is no folder \"" + shd::io::printable(options.output) + "\"");
  }
  refuse_if(!folder && options.inputs.size() > 1,
            std::to_string(options.inputs.size()) + " inputs: -o must be a folder, which ends in /");
  std::vector<Options> jobs;
  std::map<std::string, std::string> inputs;  // by output
  for (const std::string& input : options.inputs) {
    refuse_if(!folder && is_set(input) != is_set(options.output), "-o: INPUT and OUTPUT have <UDIM>, or neither");
    for (const std::string& file : files_of(input)) {
      jobs.push_back(options);
      jobs.back().input = file;
      jobs.back().output = output_of(options, input, file);
      const auto [known, is_new] = inputs.insert({jobs.back().output, file});
      refuse_if(!is_new, "\"" + shd::io::printable(known->second) + "\" and \"" + shd::io::printable(file) +
                             "\" would be one file: \"" + shd::io::printable(known->first) + "\"");
    }
  }
  return jobs;
}
