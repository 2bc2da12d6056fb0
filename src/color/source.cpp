// SPDX-License-Identifier: MIT
#include "color/source.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

#include "color/default_config.h"
#include "extension/error.h"

namespace shd::color {
namespace {

namespace fs = std::filesystem;
using extension::refuse;

constexpr size_t kMaxBytes = size_t{64} << 20;

std::string read_file(const char* field, const char* path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) refuse(SHD_ERROR_NOT_FOUND, "%s: no file \"%.256s\"", field, path);
  // Other kinds of files could block forever or be endless.
  if (!fs::is_regular_file(status)) refuse(SHD_ERROR_IO, "%s: \"%.256s\" is not a regular file", field, path);
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path, "rb"));
  if (!file) refuse(SHD_ERROR_IO, "%s: cannot open \"%.256s\"", field, path);
  std::string text;
  char block[16384];
  while (const size_t got = std::fread(block, 1, sizeof block, file.get())) {
    if (text.size() + got > kMaxBytes) {
      refuse(SHD_ERROR_LIMIT, "%s: \"%.256s\" is above %zu bytes", field, path, kMaxBytes);
    }
    text.append(block, got);
  }
  if (std::ferror(file.get())) refuse(SHD_ERROR_IO, "%s: cannot read \"%.256s\"", field, path);
  return text;
}

Source from_file(const char* field, const char* path) {
  if (!*path) refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: empty", field);
  std::string text = read_file(field, path);
  std::error_code error;
  const std::string directory = fs::absolute(path, error).parent_path().string();
  return {field, std::move(text), directory};
}

}  // namespace

Source read_source(const shd_color_desc& desc) {
  if (desc.config_path && desc.config_text) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "color.config_text: set, but config_path is set too");
  }
  if (desc.config_text) return {"color.config_text", desc.config_text, {}};
  if (desc.config_path) return from_file("color.config_path", desc.config_path);
  const char* environment = std::getenv("OCIO");
  if (environment && *environment) return from_file("color.config_path from $OCIO", environment);
  return {"built-in config", kDefaultConfig, {}};
}

}  // namespace shd::color
