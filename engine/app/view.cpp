// talus view: a finished run as a page.
#include <charconv>
#include <cstdio>

#include "app/command.h"
#include "output/output.h"
#include "output/view_page.h"

namespace talus {
namespace {

constexpr const char* view_help =
    R"(talus view folder [options]     writes one page with all that is in a run's results folder: open it in any
                                browser; it needs no network and no other file

  --fields a,b      which arrays of blocks and joints. Default: all but strain and s1_direction
  --every n         one frame of n, and the last. Default 1
  -o file           Default: folder/view.html
)";

int whole_number(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1)
    throw UsageError{"view: --every: expected a whole number from 1, got \"" + text + "\""};
  return value;
}

}  // namespace

int view_command(const Arguments& arguments) {
  std::string dir, file;
  ViewOptions options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string argument = arguments[i];
    if (argument == "--help" || argument == "-h") return std::fputs(view_help, stdout), exit_ok;
    if (argument == "--fields")
      options.fields = comma_separated(value_after(arguments, i));
    else if (argument == "--every")
      options.every = whole_number(value_after(arguments, i));
    else if (argument == "-o")
      file = value_after(arguments, i);
    else if (!argument.starts_with("-") && dir.empty())
      dir = argument;
    else
      throw UsageError{"view: unexpected argument \"" + argument + "\""};
  }
  if (dir.empty()) throw UsageError{"view: expected a run's results folder"};
  const ResultsFolder run(dir);
  if (file.empty()) file = run.dir() + "/view.html";
  const std::string page = view_page(run, options);
  write_whole(file, page);
  std::printf("%s  %.1f MB\n", file.c_str(), double(page.size()) / 1e6);
  return exit_ok;
}

}  // namespace talus
