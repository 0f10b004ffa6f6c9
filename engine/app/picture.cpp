// talus picture: drawings of a finished run, from its folder.
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "app/command.h"
#include "output/files.h"
#include "output/picture_of_results.h"
#include "scene/error.h"

extern char** environ;

namespace talus {
namespace {

constexpr const char* help =
    R"(talus picture folder [options]     draws what is in a run's results folder; nothing is run again

  --field name      colours the blocks: s1, sxx, speed, ux, fragment, region, …, or one of the run's own arrays; or the
                    cracks or joints: gas_pressure, opening, utilisation, …; or none. Default s1
  --time t          the frame nearest to t seconds; several, separated by commas; all; last. Default last
  --range a:b       of the colours. Default: from the values, one range for all that are drawn
  --vectors name    arrows of velocity or displacement
  --scale n         displacements magnified
  --width n         px. Default 1200
  --no-cracks, --no-edges
  --history a,b     instead: columns of history.csv over time, of one unit
  --png             beside each .svg a .png, by rsvg-convert (Debian: librsvg2-bin)
  -o folder         where the pictures go. Default: the results folder
)";

struct PictureJob {
  std::string dir, out, times = "last", history;
  ResultPicture picture;
  bool png = false;
};

double number(const std::string& option, const std::string& text) {
  double value = NAN;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw UsageError{"picture: " + option + ": expected a number, got \"" + text + "\""};
  return value;
}

double positive(const std::string& option, const std::string& text) {
  const double value = number(option, text);
  if (!(value > 0)) throw UsageError{"picture: " + option + ": expected a number > 0, got " + text};
  return value;
}

Span range(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) throw UsageError{"picture: --range: expected a:b, got \"" + text + "\""};
  const Span span = {number("--range", text.substr(0, colon)), number("--range", text.substr(colon + 1))};
  if (!(span.low < span.high)) throw UsageError{"picture: --range: expected a:b with a < b, got \"" + text + "\""};
  return span;
}

PictureJob read_job(const Arguments& arguments) {
  PictureJob job;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string argument = arguments[i];
    if (argument == "--field")
      job.picture.field = value_after(arguments, i);
    else if (argument == "--time")
      job.times = value_after(arguments, i);
    else if (argument == "--range")
      job.picture.range = range(value_after(arguments, i));
    else if (argument == "--vectors")
      job.picture.vectors = value_after(arguments, i);
    else if (argument == "--scale")
      job.picture.scale = positive(argument, value_after(arguments, i));
    else if (argument == "--width")
      job.picture.width = int(std::clamp(positive(argument, value_after(arguments, i)), 400., 1e4));
    else if (argument == "--no-cracks")
      job.picture.cracks = false;
    else if (argument == "--no-edges")
      job.picture.edges = false;
    else if (argument == "--history")
      job.history = value_after(arguments, i);
    else if (argument == "--png")
      job.png = true;
    else if (argument == "-o")
      job.out = value_after(arguments, i);
    else if (!argument.starts_with("-") && job.dir.empty())
      job.dir = argument;
    else
      throw UsageError{"picture: unexpected argument \"" + argument + "\""};
  }
  if (job.dir.empty()) throw UsageError{"picture: expected a run's results folder"};
  if (job.out.empty()) job.out = job.dir;
  return job;
}

std::vector<std::size_t> frames_of(const ResultsFolder& run, const std::string& times) {
  std::vector<std::size_t> frames;
  if (times == "last") return {run.times().size() - 1};
  if (times == "all") {
    for (std::size_t k = 0; k < run.times().size(); ++k) frames.push_back(k);
    return frames;
  }
  for (const std::string& text : comma_separated(times)) frames.push_back(run.nearest(number("--time", text)));
  return frames;
}

void convert(const std::string& svg) {
  const std::string png = svg.substr(0, svg.size() - 4) + ".png";
  std::vector<std::string> words = {"rsvg-convert", "-o", png, svg};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  int status = 0;
  if (posix_spawnp(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0 ||
      waitpid(child, &status, 0) != child || status != 0)
    throw RunError("--png: rsvg-convert is missing or failed (Debian: librsvg2-bin); " + svg + " is written");
  std::printf("%s\n", png.c_str());
}

void write(const PictureJob& job, const std::string& name, const std::string& svg) {
  const std::string path = job.out + "/" + name;
  write_whole(path, svg);
  std::printf("%s\n", path.c_str());
  if (job.png) convert(path);
}

}  // namespace

int picture_command(const Arguments& arguments) {
  if (!arguments.empty() && (arguments.front() == "--help" || arguments.front() == "-h"))
    return std::fputs(help, stdout), exit_ok;
  PictureJob job = read_job(arguments);
  const ResultsFolder run(job.dir);
  make_directory(job.out);
  if (!job.history.empty()) {
    write(job, "history.svg", draw_history(run, comma_separated(job.history)));
    return exit_ok;
  }
  const std::vector<std::size_t> frames = frames_of(run, job.times);
  if (!job.picture.range && frames.size() > 1) job.picture.range = range_of(run, frames, job.picture);
  for (const std::size_t frame : frames)
    write(job, frame_name(job.picture.field, int(frame), ".svg"), draw_result(run, frame, job.picture));
  return exit_ok;
}

}  // namespace talus
