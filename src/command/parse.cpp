// SPDX-License-Identifier: MIT
#include <cstdio>

#include <CLI/CLI.hpp>

#include <shd/base.h>

#include "command/pages.h"
#include "command/program.h"
#include "command/suggest.h"
#include "command/values.h"

namespace command {
namespace {

/// A page to print. The rest of the line has no effect.
struct Page {
  std::string (*text)(const Program& program);
};

std::string version_text(const Program& program) {
  return program.name + " " + std::to_string(SHD_VERSION_MAJOR) + "." + std::to_string(SHD_VERSION_MINOR) + "." +
         std::to_string(SHD_VERSION_PATCH) + "\n";
}

/// A switch that ends the parser.
Option page_option(const std::string& names, std::string (*page)(const Program& program), const std::string& text) {
  Option option{names, "", {}, text};
  option.values.read = [page](const std::string&) -> bool { throw Page{page}; };
  return option;
}

void read(const Option& option, const std::string& value) {
  const std::string name = split(option.names, ',').back();
  const Values& values = option.values;
  if (option.value.empty() && value != "true") throw Failure(kExitUsage, name + " takes no value");
  if (values.read(value)) return;
  refuse(name, value, values.wanted, values.names);
}

/// An option whose values are read in the order of the command line. The last one of several counts.
void add(CLI::App& app, const Option& option) {
  const auto callback = [&option](const CLI::results_t& results) {
    return read(option, option.words > 1 ? CLI::detail::join(results, "\n") : results.front()), true;
  };
  CLI::Option* const added = app.add_option(option.names, callback);
  added->trigger_on_parse();
  if (option.value.empty()) added->expected(0);
  if (option.words > 1) added->expected(option.words);
}

/// The name at the front of an error of CLI11 is that of the option.
[[noreturn]] void refuse_missing(const Program& program, const std::string& error) {
  const std::string given = error.substr(0, error.find(':'));
  for (const Group& group : program.groups) {
    for (const Option& option : group.options) {
      const std::string name = split(option.names, ',').back();
      if (name != given) continue;
      const std::string& wanted = option.values.wanted;
      throw Failure(kExitUsage, name + " needs a value" + (wanted.empty() ? "" : ": " + wanted));
    }
  }
  throw Failure(kExitUsage, error);
}

/// Takes what is no option and no value. "--" ends the options.
void take_rest(const Program& program, const std::vector<std::string>& rest, std::vector<std::string>& files) {
  bool only_files = false;
  for (const std::string& word : rest) {
    if (!only_files && word == "--") {
      only_files = true;
    } else if (!only_files && word.size() > 1 && word[0] == '-') {
      std::vector<std::string> names;
      for (const Group& group : program.groups) {
        for (const Option& option : group.options) names.push_back(split(option.names, ',').back());
      }
      const std::string name = word.substr(0, word.find('='));
      throw Failure(kExitUsage, name + " is not an option" + suggestion(name, names));
    } else if (word.empty()) {
      throw Failure(kExitUsage, "the name of a file is empty");
    } else {
      files.push_back(word);
    }
  }
}

}  // namespace

bool parse(const Program& declared, int argc, const char* const* argv, std::vector<std::string>& files) {
  Program program = declared;
  program.groups.push_back({"Help",
                            {page_option("-h,--help", help_text, "Print this text."),
                             page_option("--version", version_text, "Print the version.")}});
  const Option hidden[] = {page_option("--man", manual_page, ""), page_option("--completion", bash_completion, "")};
  try {
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    for (const Group& group : program.groups) {
      for (const Option& option : group.options) add(app, option);
    }
    for (const Option& option : hidden) add(app, option);
    app.parse(argc, argv);
    take_rest(program, app.remaining(), files);
    return true;
  } catch (const Page& page) {
    const bool is_written = std::fputs(page.text(program).c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
    if (!is_written) throw Failure(kExitFailed, "standard output cannot be written");
    return false;
  } catch (const CLI::ArgumentMismatch& error) {
    refuse_missing(program, error.what());
  } catch (const CLI::ParseError& error) {
    throw Failure(kExitUsage, error.what());
  }
}

}  // namespace command
