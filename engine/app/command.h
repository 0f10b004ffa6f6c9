#pragma once
// The subcommands of `talus`: one file each, listed in main.cpp. Arguments come without the command's own name.
#include <string>
#include <vector>

#include "script/session.h"

namespace talus {

using Arguments = std::vector<std::string>;

// Arguments that make no sense: main prints it and exits with exit_bad_input.
struct UsageError {
  std::string message;
};

struct Command {
  const char* name;
  const char* usage;                       // its lines of `talus --help`
  int (*run)(const Arguments& arguments);  // the exit status
};

int run_command(const Arguments& arguments);
int plan_command(const Arguments& arguments);
int parameters_command(const Arguments& arguments);
int sweep_command(const Arguments& arguments);
int check_command(const Arguments& arguments);
int new_command(const Arguments& arguments);
int picture_command(const Arguments& arguments);
int view_command(const Arguments& arguments);

// What every command on a scene takes: the scene, -p name=value, -o dir. The command line is that of the program.
SessionOptions read_scene_arguments(const Arguments& arguments, const std::string& command);

// The value after option i, which is moved on to it. UsageError where there is none.
const std::string& value_after(const Arguments& arguments, std::size_t& i);

// "a,b" -> a and b.
std::vector<std::string> comma_separated(const std::string& text);

}  // namespace talus
