// SPDX-License-Identifier: MIT
// Readers of values, suggestions, and the command line of a small program.
#include <string>
#include <vector>

#include "command/pages.h"
#include "command/suggest.h"
#include "command/values.h"
#include "support/check.h"

namespace {

using namespace command;

enum class Color { kRed, kGreen, kBlue };
const Name<Color> kColors[] = {{"red", Color::kRed}, {"green", Color::kGreen}, {"blue", Color::kBlue}};

/// The variables of the program.
struct Settings {
  std::string output = "out", log;
  bool fast = false;
  float gain = 1;
  uint32_t width = 640, height = 480, count = 4;
  std::optional<double> limit;
  Color color = Color::kGreen;
  std::vector<std::string> files;

  Program program() {
    const auto note = [this](const std::string& text) { return log += text, true; };
    return {"small",
            "a test",
            "[options] [FILE]",
            "First paragraph.\n\n  a line -- kept\n\nLast.",
            {{"All",
              {{"-o,--output", "FILE", file(output), "Output."},
               {"--fast", "", flag(fast), "Fast."},
               {"--gain", "X", number(gain, -1, 1e6, " units"), "Gain."},
               {"--size", "WxH", size({width, height}, 1000), "Size."},
               {"--count", "N", number(count, 0, 9), "Count."},
               {"--limit", "X", number(limit, 0, 1), "Limit."},
               {"--color", "C", named(color, kColors), "Colour."},
               {"--first", "T", {"", {}, "", note}, "First."},
               {"--second", "T", {"", {}, "", note}, "Second."},
               {"--pair", "A B", {"two words", {}, "", note}, "Pair.", 2}}}},
            {{"Exit status", "0 or 2."}}};
  }

  /// Returns the text of the failure, or "".
  std::string read(std::vector<const char*> words) {
    words.insert(words.begin(), "small");
    try {
      parse(program(), static_cast<int>(words.size()), words.data(), files);
    } catch (const Failure& failure) {
      return failure.code == kExitUsage ? failure.what() : "another code";
    }
    return "";
  }
};

void test_values(void**) {
  Settings s;
  const char* const words[] = {"--gain=-0.5", "a",        "-oresult", "--size",  "8x9",    "--count",
                               "+7",          "--limit",  ".25",      "--color", "blue",   "--fast",
                               "--fast",      "--second", "2",        "--first", "1",      "--second",
                               "3",           "--count",  "5",        "--",      "--fast", "-"};
  assert_string_equal(s.read({std::begin(words), std::end(words)}).c_str(), "");
  assert_true(s.gain == -0.5f && s.width == 8 && s.height == 9 && s.count == 5 && s.limit == 0.25 && s.fast);
  assert_true(s.color == Color::kBlue && s.output == "result");
  assert_string_equal(s.log.c_str(), "213");  // in the order of the line
  assert_true(s.files == (std::vector<std::string>{"a", "--fast", "-"}));
  Settings two;
  assert_string_equal(two.read({"--pair", "x y", "z", "file", "--count", "3"}).c_str(), "");
  assert_string_equal(two.log.c_str(), "x y\nz");
  assert_true(two.files == std::vector<std::string>{"file"} && two.count == 3);
}

void test_refusals(void**) {
  const struct {
    std::vector<const char*> words;
    const char* text;
  } cases[] = {
      {{"--gain", "1e7"}, "--gain: \"1e7\" is not a number -1..1e6 units"},
      {{"--gain", "nan"}, "--gain: \"nan\" is not a number -1..1e6 units"},
      {{"--gain", "1 "}, "--gain: \"1 \" is not a number -1..1e6 units"},
      {{"--gain", "+-1"}, "--gain: \"+-1\" is not a number -1..1e6 units"},
      {{"--gain", ""}, "--gain: \"\" is not a number -1..1e6 units"},
      {{"--count", "1.0"}, "--count: \"1.0\" is not a whole number 0..9"},
      {{"--count", "-1"}, "--count: \"-1\" is not a whole number 0..9"},
      {{"--count", "99999999999"}, "--count: \"99999999999\" is not a whole number 0..9"},
      {{"--limit", "2"}, "--limit: \"2\" is not a number 0..1"},
      {{"--size", "8"}, "--size: \"8\" is not WIDTHxHEIGHT, each 1..1000"},
      {{"--size", "8x0"}, "--size: \"8x0\" is not WIDTHxHEIGHT, each 1..1000"},
      {{"--size", "8x9x"}, "--size: \"8x9x\" is not WIDTHxHEIGHT, each 1..1000"},
      {{"--color", "gren"}, "--color: \"gren\" is not one of red, green or blue: did you mean green?"},
      {{"--color", "Violet"}, "--color: \"Violet\" is not one of red, green or blue"},
      {{"-o", ""}, "--output: \"\" is not the name of a file"},
      {{"--count"}, "--count needs a value: a whole number 0..9"},
      {{"--first"}, "--first needs a value"},
      {{"-o"}, "--output needs a value: the name of a file"},
      {{"--pair"}, "--pair needs a value: two words"},
      {{"--pair", "x"}, "--pair needs a value: two words"},
      {{"a", "--pair", "x", "--fast"}, "--pair needs a value: two words"},
      {{"--fast=1"}, "--fast takes no value"},
      {{"--cuont", "3"}, "--cuont is not an option: did you mean --count?"},
      {{"-count=3"}, "-count is not an option: did you mean --count?"},
      {{"--col", "red"}, "--col is not an option: did you mean --color?"},
      {{"--elephant"}, "--elephant is not an option"},
      {{"a", ""}, "the name of a file is empty"},
  };
  for (const auto& c : cases) assert_string_equal(Settings().read(c.words).c_str(), c.text);
}

void test_suggestions(void**) {
  const std::vector<std::string> names = {"--nearest", "--bilinear", "--bilinear-mip", "--size"};
  assert_string_equal(suggestion("--nearets", names).c_str(), ": did you mean --nearest?");
  assert_string_equal(suggestion("-bilinera", names).c_str(), ": did you mean --bilinear?");
  assert_string_equal(suggestion("bilinear-mp", names).c_str(), ": did you mean --bilinear-mip?");
  assert_string_equal(suggestion("siz", names).c_str(), ": did you mean --size?");
  for (const char* word : {"", "-", "x", "sister", "--anisotropic"}) {
    assert_string_equal(suggestion(word, names).c_str(), "");
  }
}

void test_texts(void**) {
  const struct {
    double number;
    const char* text;
  } cases[] = {{0, "0"},
               {-0.5, "-0.5"},
               {16384, "16384"},
               {16777216, "16777216"},
               {1e6, "1e6"},
               {1e-6, "1e-6"},
               {1048576.0, "1048576"},
               {0.0625, "0.0625"},
               {static_cast<double>(0.8f), "0.8"}};
  for (const auto& c : cases) assert_string_equal(digits(c.number).c_str(), c.text);
  assert_string_equal(join({}).c_str(), "");
  assert_string_equal(join({"a"}).c_str(), "a");
  assert_string_equal(join({"a", "b"}).c_str(), "a or b");
  assert_string_equal(join({"a", "b", "c"}, " and ").c_str(), "a, b and c");
  assert_true(split("", ',') == std::vector<std::string>{""} && split("a,,b", ',').size() == 3);
  assert_true(ends_with("a.png", ".png") && ends_with("-.png", ".png"));
  assert_false(ends_with(".png", ".png") || ends_with("png", ".png") || ends_with("a.PNG", ".png"));
  assert_true(!read_numbers("1,") && !read_numbers("") && read_numbers("1x2", 'x')->size() == 2);
}

void test_pages(void**) {
  Settings s;
  const Program program = s.program();
  const std::string help = help_text(program), page = manual_page(program), script = bash_completion(program);
  for (const char* part : {"Usage: small [options] [FILE]\n", "First paragraph.\n\n  a line -- kept\n\nLast.\n",
                           "  -o, --output FILE     Output. Default out.\n",
                           "  --color C             Colour. One of red, green or blue. Default green.\n",
                           "  --limit X             Limit. A number 0..1.\n",
                           "  --size WxH            Size. WIDTHxHEIGHT, "
                           "each 1..1000. Default 640x480.\n",
                           "Exit status\n0 or 2.\n"}) {
    assert_non_null(strstr(help.c_str(), part));
  }
  for (const char* part : {".TH SMALL 1", "small \\- a test\n", ".nf\n  a line \\-\\- kept\n.fi\n",
                           "\\fB\\-o\\fP, \\fB\\-\\-output\\fP \\fIFILE\\fP\n", ".SH EXIT STATUS\n"}) {
    assert_non_null(strstr(page.c_str(), part));
  }
  assert_non_null(strstr(script.c_str(), "--color) words=\"red green blue\" ;;\n"));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(test_values), cmocka_unit_test(test_refusals),
                              cmocka_unit_test(test_suggestions), cmocka_unit_test(test_texts),
                              cmocka_unit_test(test_pages)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
