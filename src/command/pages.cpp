// SPDX-License-Identifier: MIT
#include "command/pages.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <shd/base.h>

namespace command {
namespace {

constexpr size_t kColumns = 100, kIndent = 24;

std::string replace(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Words of a paragraph in lines. The first line begins behind `column`, the others at `indent`.
std::string wrap(const std::string& text, size_t indent, size_t column) {
  std::istringstream words(text);
  std::string lines, word;
  size_t at = column;
  while (words >> word) {
    if (at > indent && at + 1 + word.size() > kColumns) {
      lines += "\n" + std::string(indent, ' ');
      at = indent;
    }
    const bool first = at == indent;
    lines += (first ? "" : " ") + word;
    at += word.size() + !first;
  }
  return lines + "\n";
}

/// Calls `paragraph` or `lines` for each part of a section.
template <class Paragraph, class Lines>
void visit_parts(const std::string& text, Paragraph paragraph, Lines lines) {
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find("\n\n", at), text.size());
    const std::string part = text.substr(at, end - at);
    if (part[0] == ' ') {
      lines(part + "\n");
    } else {
      paragraph(part);
    }
    at = end + 2;
  }
}

std::string help_section(const std::string& text) {
  std::string all;
  const auto gap = [&] { return all.empty() ? "" : "\n"; };
  visit_parts(
      text, [&](const std::string& part) { all += gap() + wrap(part, 0, 0); },
      [&](const std::string& part) { all += gap() + part; });
  return all;
}

std::string help_option(const Option& option) {
  std::string line = "  " + replace(option.names, ",", ", ") + (option.value.empty() ? "" : " " + option.value);
  const bool fits = line.size() + 2 <= kIndent;
  line += fits ? std::string(kIndent - line.size(), ' ') : "\n" + std::string(kIndent, ' ');
  return line + wrap(describe(option), kIndent, kIndent);
}

/// Text for man(7): words that begin with a dash are bold, and no line is taken for a request.
std::string roff(const std::string& text) {
  std::istringstream words(text);
  std::string all, word;
  while (words >> word) {
    const bool is_option =
        word.size() > 1 && word[0] == '-' && (word[1] == '-' || std::islower(static_cast<unsigned char>(word[1])));
    const size_t dashes = word[0] == '-' ? word.find_last_not_of(".,;:)") + 1 : 0;
    const std::string name = replace(word.substr(0, dashes), "-", "\\-");
    const std::string rest = replace(word.substr(dashes), "\\", "\\e");
    all += (all.empty() ? "" : " ") + (is_option ? "\\fB" + name + "\\fP" : name) + rest;
  }
  return (all[0] == '.' || all[0] == '\'' ? "\\&" : "") + all + "\n";
}

std::string roff_section(const std::string& text) {
  std::string all;
  const auto lines = [&](const std::string& part) {
    all += ".PP\n.nf\n" + replace(replace(part, "\\", "\\e"), "-", "\\-") + ".fi\n";
  };
  visit_parts(
      text, [&](const std::string& part) { all += (all.empty() ? "" : ".PP\n") + roff(part); }, lines);
  return all;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::string describe(const Option& option) {
  const Values& values = option.values;
  std::string all = option.text;
  if (!values.wanted.empty() && !values.is_obvious) {
    all += " " + upper(values.wanted.substr(0, 1)) + values.wanted.substr(1) + ".";
  }
  return all + (values.initial.empty() ? "" : " Default " + values.initial + ".");
}

std::string help_text(const Program& program) {
  std::string all = "Usage: " + program.name + " " + program.arguments + "\n\n" + help_section(program.description);
  for (const Group& group : program.groups) {
    all += "\n" + group.title + "\n";
    for (const Option& option : group.options) all += help_option(option);
  }
  for (const Section& section : program.sections) all += "\n" + section.title + "\n" + help_section(section.text);
  return all;
}

std::string manual_page(const Program& program) {
  std::string all = ".\\\" SPDX-License-Identifier: MIT\n.TH " + upper(program.name) + " 1 \"\" \"shd " +
                    std::to_string(SHD_VERSION_MAJOR) + "." + std::to_string(SHD_VERSION_MINOR) +
                    "\" \"User Commands\"\n.SH NAME\n" + replace(program.name, "-", "\\-") + " \\- " + program.summary +
                    "\n.SH SYNOPSIS\n.B " + replace(program.name, "-", "\\-") + "\n" +
                    replace(program.arguments, "-", "\\-") + "\n" + ".SH DESCRIPTION\n" +
                    roff_section(program.description) + ".SH OPTIONS\n";
  for (const Group& group : program.groups) {
    all += ".SS " + group.title + "\n";
    for (const Option& option : group.options) {
      const std::string names = replace(replace(option.names, ",", "\\fP, \\fB"), "-", "\\-");
      all += ".TP\n\\fB" + names + "\\fP" + (option.value.empty() ? "" : " \\fI" + option.value + "\\fP") + "\n" +
             roff(describe(option));
    }
  }
  for (const Section& section : program.sections)
    all += ".SH " + upper(section.title) + "\n" + roff_section(section.text);
  return all;
}

std::string bash_completion(const Program& program) {
  std::string function = "_" + replace(program.name, "-", "_"), options, cases;
  for (const Group& group : program.groups) {
    for (const Option& option : group.options) {
      options += (options.empty() ? "" : " ") + replace(option.names, ",", " ");
      if (option.values.names.empty()) continue;
      std::string words;
      for (const std::string& name : option.values.names) words += (words.empty() ? "" : " ") + name;
      cases += "    " + replace(option.names, ",", " | ") + ") words=\"" + words + "\" ;;\n";
    }
  }
  return "# bash completion of " + program.name + "\n" + function + "() {\n  local words=\"\"\n" +
         "  case ${COMP_WORDS[COMP_CWORD - 1]} in\n" + cases +
         "    *) [[ ${COMP_WORDS[COMP_CWORD]} != -* ]] || words=\"" + options +
         "\" ;;\n  esac\n  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"${COMP_WORDS[COMP_CWORD]}\")\n}\n" +
         "complete -o default -F " + function + " " + program.name + "\n";
}

}  // namespace command
