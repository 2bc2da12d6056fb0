// SPDX-License-Identifier: MIT
#include "color/source.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "color/default_config.h"
#include "core/regular_file.h"
#include "extension/error.h"

namespace shd::color {
namespace {

namespace fs = std::filesystem;
using extension::refuse;

constexpr size_t kMaxBytes = size_t{64} << 20;

std::string read_file(const char* field, const char* path) {
  const core::RegularFile opened = core::open_regular(path);
  const bool missing = opened.error == ENOENT || opened.error == ENOTDIR;
  if (missing) refuse(SHD_ERROR_NOT_FOUND, "%s: no file \"%.256s\"", field, path);
  if (opened.other_kind) refuse(SHD_ERROR_IO, "%s: \"%.256s\" is not a regular file", field, path);
  if (opened.error) refuse(SHD_ERROR_IO, "%s: cannot open \"%.256s\": %s", field, path, std::strerror(opened.error));
  if (opened.size > kMaxBytes) {
    refuse(SHD_ERROR_LIMIT, "%s: \"%.256s\" is above %zu bytes", field, path, kMaxBytes);
  }
  std::string text(static_cast<size_t>(opened.size), 0);
  int error = 0;
  text.resize(core::read_at(opened.file.fd, 0, text.size(), text.data(), &error));
  if (error) refuse(SHD_ERROR_IO, "%s: cannot read \"%.256s\": %s", field, path, std::strerror(error));
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
