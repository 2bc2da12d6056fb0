// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <new>

#include "command/program.h"

namespace command {

int run(const char* name, const std::function<int()>& body, ExitCode other) {
  try {
    return body();
  } catch (const Failure& failure) {
    const std::string hint = failure.code == kExitUsage ? std::string(" (") + name + " --help)" : "";
    std::fprintf(stderr, "%s: %s%s\n", name, failure.what(), hint.c_str());
    return failure.code;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: out of memory\n", name);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
  }
  return other;
}

}  // namespace command
