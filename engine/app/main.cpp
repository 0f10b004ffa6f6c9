// The `talus` command: finds the subcommand; without one, the arguments are of a scene to run.
#include <malloc.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>

#include "app/command.h"
#include "scene/version.h"
#include "script/reference.h"

namespace talus {
namespace {

constexpr Command commands[] = {
    {"run", "  talus scene.lua [-p name=value …] [-o dir] […]    runs a scene (talus run scene.lua as well)\n",
     run_command},
    {"check",
     "  talus check scene.lua [-p name=value …]       builds it, finds what is wrong, and says what a run would take\n",
     check_command},
    {"new", "  talus new [name] [slope|blast|disc|wall]      writes a commented scene to start from\n", new_command},
    {"plan", "  talus plan scene.lua [-p name=value …]        builds it and prints what a step would do\n",
     plan_command},
    {"parameters", "  talus parameters scene.lua                    what -p can set\n", parameters_command},
    {"sweep",
     "  talus sweep study.lua [-j N] [--resume] [--retry]    runs the variants of a talus.study, N at once (docs/sweeps.md)\n"
     "  talus sweep study.lua --list                  prints a command line for each run that is still to be made\n"
     "  talus sweep study.lua --collect               makes table and page of what is there\n"
     "  talus sweep study.lua --slurm [--no-wait]     the runs as a job array of Slurm\n",
     sweep_command},
    {"picture",
     "  talus picture folder [--field name] [--time t|all|last] …     draws a finished run's results (--help says how)\n",
     picture_command},
    {"view",
     "  talus view folder [-o file] [--fields a,b] [--every n]        writes one page that plays them in a browser\n",
     view_command},
};

constexpr const char* title = "talus: 2D discontinuous deformation analysis, scripted in Lua\n\n";
constexpr const char* options =
    R"(  talus --reference                             prints the scene reference (docs/scene_reference.md)
  talus --annotations                           prints what editors should know (lib/meta/talus.lua)
  talus --version
  talus --help

  -p name=value   sets a talus.param of the scene
  -o dir          writes results there instead of where the scene says
  --inputs file   lists there which files the scene was made of, with a hash of each
  --restart file  continues from a state that sim:save("file") or --checkpoint wrote; a folder: from the one in it
  --resume        continues from the checkpoint in the output folder, where there is one
  --checkpoint every=60s|1000steps [file=…]
                  writes the state now and then, and when a signal or a limit stops the run; to checkpoint.state in
                  the output folder where no file is given
  --limit [time=60s] [memory=2GB] [steps=1000]
                  stops the run there, with its results and exit status 3
  -i              stops before the first step for lines of Lua: sim:step(), sim.time, …; the end of input goes on
  --trust         the scene may use all of Lua, start programs, and write anywhere

Exit status: 0 done; 1 a check failed; 2 bad input; 3 the run had to stop, results up to there are kept;
130, 143 stopped by SIGINT, SIGTERM.
)";

int print_usage() {
  std::fputs(title, stdout);
  for (const Command& command : commands) std::fputs(command.usage, stdout);
  std::fputs(options, stdout);
  return exit_ok;
}

int execute(const Arguments& arguments) {
  const std::string first = arguments.empty() ? "" : arguments.front();
  if (first == "--help" || first == "-h") return print_usage();
  if (first == "--version") return std::printf("talus %s (%s)\n", version, commit), exit_ok;
  if (first == "--reference") return std::fputs(scene_reference().c_str(), stdout), exit_ok;
  if (first == "--annotations") return std::fputs(editor_annotations().c_str(), stdout), exit_ok;
  const auto* command = std::ranges::find(commands, first, [](const Command& c) { return std::string(c.name); });
  if (command == std::end(commands)) return run_command(arguments);
  return command->run({arguments.begin() + 1, arguments.end()});
}

}  // namespace
}  // namespace talus

int main(int argc, char** argv) {
#ifdef __GLIBC__
  // What a step gives back the next one takes: through the system it would come anew, page by page.
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // bytes, the most that glibc takes
#endif
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a write that fails, with a message
  try {
    return talus::execute({argv + 1, argv + argc});
  } catch (const talus::UsageError& problem) {
    std::fprintf(stderr, "talus: %s; see talus --help\n", problem.message.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talus: %s\n", error.what());
  }
  return talus::exit_bad_input;
}
