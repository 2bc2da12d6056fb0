// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "command/failure.h"

namespace command {

/// The values of an option, and the variable that they set.
struct Values {
  std::string wanted;              // continues "is not ": "a number 0..1"; empty = any text
  std::vector<std::string> names;  // all values, or all parts of a list; empty = values without names
  std::string initial;             // value if the option is absent; empty = none that a text could name
  std::function<bool(const std::string& text)> read;  // sets the variable; returns false for a text that is not wanted
  bool is_obvious = false;  // the pages leave `wanted` out, because the name of the value is enough
};

struct Option {
  std::string names;  // "-o,--output"
  std::string value;  // name of its value, "FILE"; empty = a switch, for which `read` gets "true"
  Values values;
  std::string text;  // whole sentences. The pages add `wanted` and `initial`.
  int words = 1;     // words of its value: "FROM TO" has two, which `read` gets with a line end between them
};

struct Group {
  std::string title;
  std::vector<Option> options;
};

/// A part of the pages: paragraphs with an empty line between them. Lines that begin with a space stay lines.
struct Section {
  std::string title, text;
};

/// All that is declared of a program.
struct Program {
  std::string name, summary;
  std::string arguments;  // behind the name: "[options] [MODEL]"
  std::string description;
  std::vector<Group> groups;
  std::vector<Section> sections;  // behind the options
};

/// Reads the command line, sets the variables of the options in its order, and returns the other arguments in `files`.
/// Returns false if the line asked for a page, such as --help, which is printed. Throws Failure (kExitUsage).
bool parse(const Program& program, int argc, const char* const* argv, std::vector<std::string>& files);

/// Returns the exit code of a program: of `body`, or of the exception that ends it, whose text is printed as one line.
/// `other` is the code of exceptions that are no Failure.
int run(const char* name, const std::function<int()>& body, ExitCode other = kExitFailed);

}  // namespace command
