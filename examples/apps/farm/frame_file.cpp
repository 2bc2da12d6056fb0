// SPDX-License-Identifier: MIT
#include "frame_file.h"

#include <fcntl.h>

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace farm {
namespace {

constexpr char kMagic[] = "shd-farm-1 ";
constexpr double kJournalPeriod = 1.0;  // [s] between flushes of the journal

std::string read_all(const File& file) {
  std::string text;
  char buffer[65536];
  for (size_t have; (have = read_at(file, text.size(), buffer, sizeof buffer)) > 0;) text.append(buffer, have);
  return text;
}

std::string journal_head(const FrameFile& file, const std::string& identity) {
  return kMagic + identity + " " + std::to_string(window_count(file.layout)) + "\n";
}

/// "<window> <sum> <checksum of both>\n", of constant length.
std::string journal_line(uint32_t window, uint64_t sum) {
  char text[64];
  const int length = std::snprintf(text, sizeof text, "%08x %016" PRIx64, window, sum);
  const uint64_t check = checksum(text, static_cast<size_t>(length));
  std::snprintf(text + length, sizeof text - static_cast<size_t>(length), " %016" PRIx64 "\n", check);
  return text;
}

/// Takes the good lines; damaged and torn ones are left out, so that their windows are rendered again.
void read_lines(const std::string& text, size_t at, FrameFile* file) {
  uint32_t damaged = 0;
  while (at < text.size()) {
    const size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end == std::string::npos ? end : end + 1 - at);
    unsigned window = 0;
    uint64_t sum = 0;
    const bool good = std::sscanf(line.c_str(), "%8x %16" SCNx64, &window, &sum) == 2 &&
                      line == journal_line(window, sum) && window < file->sums.size();
    if (good) {
      file->kept_count += !file->journaled[window];
      file->journaled[window] = 1;
      file->sums[window] = sum;
    }
    damaged += !good;
    at += line.size();
  }
  if (damaged) {
    std::fprintf(stderr, "shd-farm: %s: %u damaged lines, their windows are rendered again\n",
                 journal_path(file->path).c_str(), damaged);
  }
}

void read_journal(const std::string& identity, FrameFile* file) {
  const std::string path = journal_path(file->path), head = journal_head(*file, identity);
  if (!file_exists(path)) return;
  const std::string text = read_all(File(path, O_RDONLY));
  if (text.compare(0, head.size(), head) == 0) return read_lines(text, head.size(), file);
  const std::string magic = kMagic;
  if (text.compare(0, magic.size(), magic) == 0 && text.find('\n') == head.size() - 1) {
    throw Failure(path + ": begun with another scene or other options; --fresh removes it");
  }
  std::fprintf(stderr, "shd-farm: %s: its first line is damaged, all windows are rendered again\n", path.c_str());
}

/// Replaces the journal by its good lines: a new file, flushed and renamed.
void rewrite_journal(const std::string& identity, FrameFile* file) {
  const std::string path = journal_path(file->path);
  file->journal = File(path + ".new", O_RDWR | O_CREAT | O_TRUNC);
  std::string text = journal_head(*file, identity);
  for (uint32_t i = 0; i < file->sums.size(); ++i) {
    if (file->journaled[i]) text += journal_line(i, file->sums[i]);
  }
  write_at(file->journal, 0, text.data(), text.size());
  sync_data(file->journal);
  rename_file(file->journal.path, path);
  file->journal.path = path;
  sync_folder(path);
}

/// Whether a finished file is there. Throws Failure if it is another picture.
bool is_complete(const Options& options, const FrameFile& file) {
  if (!file_exists(file.path) || options.fresh) return false;
  const std::vector<char> head = file_head(file.layout);
  std::vector<char> have(head.size());
  const size_t size = read_at(File(file.path, O_RDONLY), 0, have.data(), have.size());
  if (size == head.size() && have == head && size_of(file.path) == file_size(file.layout)) return true;
  throw Failure(file.path + ": a picture of another scene or other options; --fresh replaces it");
}

}  // namespace

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string make_identity(const Options& options, uint64_t scene_sum, uint32_t frame) {
  char text[160];
  const int length =
      std::snprintf(text, sizeof text, "%016" PRIx64 " %ux%u %u %u %u %u/%u %a %a", scene_sum, options.width,
                    options.height, options.window, options.samples, options.supersampling, frame, options.frames,
                    static_cast<double>(options.azimuth), static_cast<double>(options.elevation));
  std::snprintf(text, sizeof text, "%016" PRIx64, checksum(text, static_cast<size_t>(length)));
  return text;
}

std::string part_path(const std::string& path) {
  return path + ".part";
}

std::string journal_path(const std::string& path) {
  return path + ".journal";
}

FrameFile open_frame(const Options& options, uint64_t scene_sum, uint32_t frame) {
  const std::string identity = make_identity(options, scene_sum, frame);
  FrameFile file;
  file.frame = frame;
  file.path = frame_path(options, frame);
  file.layout = make_layout(options.width, options.height, options.window, identity);
  const size_t windows = window_count(file.layout);
  file.sums.resize(windows), file.journaled.resize(windows), file.done.resize(windows);
  if ((file.complete = is_complete(options, file))) {
    remove_file(journal_path(file.path));  // left by a job that was killed after the rename
    return file;
  }
  file.part = File(part_path(file.path), O_RDWR | O_CREAT);
  lock(file.part);
  if (options.fresh) remove_file(journal_path(file.path));
  read_journal(identity, &file);
  if (options.reserve) reserve(file.part, file_size(file.layout));
  const std::vector<char> head = file_head(file.layout);
  write_at(file.part, 0, head.data(), head.size());
  rewrite_journal(identity, &file);
  return file;
}

void record_window(FrameFile* file, uint32_t window, uint64_t sum, bool unchanged) {
  if (file->done[window]) throw Failure("window " + std::to_string(window) + " was finished twice");
  file->sums[window] = sum;
  file->done[window] = 1;
  file->done_count += 1;
  if (!unchanged) append(file->journal, journal_line(window, sum));
  if (seconds_since(file->last_sync) < kJournalPeriod) return;
  sync_data(file->journal);
  file->last_sync = Clock::now();
}

void finish_frame(FrameFile* file) {
  sync_data(file->part);
  rename_file(part_path(file->path), file->path);
  sync_folder(file->path);
  remove_file(journal_path(file->path));
}

uint64_t picture_sum(const FrameFile& file) {
  return checksum(file.sums.data(), file.sums.size() * sizeof(uint64_t));
}

}  // namespace farm
