// The `talus` command: reads its arguments and hands over to a Session.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "scene/version.h"
#include "script/reference.h"
#include "script/session.h"

namespace {

constexpr const char* usage =
    R"(talus: 2D discontinuous deformation analysis, scripted in Lua

  talus scene.lua [-p name=value …] [-o dir] [--restart file]    runs a scene
  talus plan scene.lua [-p name=value …]        builds it and prints what a step would do
  talus --reference                             prints the scene reference (docs/scene_reference.md)
  talus --version
  talus --help

  -p name=value   sets a talus.param of the scene
  -o dir          writes results there instead of where the scene says
  --restart file  continues from a state that sim:save("file") wrote

Exit status: 0 done; 1 a check failed; 2 bad input; 3 the run had to stop, results up to there are kept;
130, 143 stopped by SIGINT, SIGTERM.
)";

struct Usage {
  std::string message;
};

std::pair<std::string, std::string> read_parameter(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw Usage{"-p: expected name=value, got \"" + text + "\""};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::string command_line(const std::vector<std::string>& arguments) {
  std::string line = "talus";
  for (const std::string& argument : arguments) line += " " + argument;
  return line;
}

talus::SessionOptions read_arguments(const std::vector<std::string>& arguments) {
  talus::SessionOptions options;
  options.command_line = command_line(arguments);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "-p" || argument == "-o" || argument == "--restart") {
      if (i + 1 == arguments.size()) throw Usage{argument + ": expected a value after it"};
      const std::string& value = arguments[++i];
      if (argument == "-o") {
        options.output_dir = value;
      } else if (argument == "--restart") {
        options.restart = value;
      } else {
        options.parameters.push_back(read_parameter(value));
      }
    } else if (argument.starts_with("-") || !options.script.empty()) {
      throw Usage{"unexpected argument \"" + argument + "\""};
    } else if (argument == "plan" && !options.plan_only) {
      options.plan_only = true;
    } else {
      options.script = argument;
    }
  }
  if (options.script.empty()) throw Usage{"expected a scene"};
  if (options.plan_only && !options.restart.empty()) throw Usage{"plan: expected no --restart, nothing is run"};
  return options;
}

int run(const std::vector<std::string>& arguments) {
  const std::string first = arguments.empty() ? "" : arguments.front();
  if (first == "--help" || first == "-h") return std::fputs(usage, stdout), 0;
  if (first == "--version") return std::printf("talus %s (%s)\n", talus::version, talus::commit), 0;
  if (first == "--reference") return std::fputs(talus::scene_reference().c_str(), stdout), 0;
  return talus::Session(read_arguments(arguments)).execute();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const Usage& problem) {
    std::fprintf(stderr, "talus: %s; see talus --help\n", problem.message.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talus: %s\n", error.what());
  }
  return talus::exit_bad_input;
}
