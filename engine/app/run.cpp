// talus run, talus plan, talus parameters: a scene from its command line.
#include <cmath>
#include <cstdio>

#include "app/command.h"
#include "app/settings.h"

namespace talus {
namespace {

std::pair<std::string, std::string> read_parameter(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw UsageError{"-p: expected name=value, got \"" + text + "\""};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

// Whether it was one of the options that every command on a scene takes.
bool read_scene_option(const Arguments& arguments, std::size_t& i, SessionOptions& options) {
  const std::string& argument = arguments[i];
  if (argument == "-p") {
    options.parameters.push_back(read_parameter(value_after(arguments, i)));
  } else if (argument == "-o") {
    options.output_dir = value_after(arguments, i);
  } else if (!argument.starts_with("-") && options.script.empty()) {
    options.script = argument;
  } else {
    return false;
  }
  return true;
}

SessionOptions named(const Arguments& arguments, const std::string& command) {
  SessionOptions options;
  options.command_line = command;
  for (const std::string& argument : arguments) options.command_line += " " + argument;
  return options;
}

[[noreturn]] void refuse(const std::string& option, const OptionSetting& setting, const std::string& expected) {
  throw UsageError{option + ": expected " + expected + ", got \"" + setting.text() + '"'};
}

// A whole number above 0, before "steps" where `word` is true.
bool read_steps(const std::string& text, bool word, long& steps) {
  double amount = 0;
  if (!read_amount(text, word ? Units{{"steps", 1}, {"step", 1}} : Units{{"", 1}}, amount) ||
      amount != std::floor(amount))
    return false;
  steps = long(amount);
  return true;
}

CheckpointOptions read_checkpoint(const Arguments& arguments, std::size_t& i) {
  CheckpointOptions options;
  for (const OptionSetting& setting : settings_after(arguments, i, {"every", "file"})) {
    if (setting.name == "file") {
      options.file = setting.value;
    } else if (!read_amount(setting.value, durations, options.seconds) &&
               !read_steps(setting.value, true, options.steps)) {
      refuse("--checkpoint", setting, "every=60s (ms, s, min or h) or every=1000steps");
    }
  }
  if (options.seconds == 0 && options.steps == 0) throw UsageError{"--checkpoint: expected every=… beside file=…"};
  return options;
}

Limits read_limits(const Arguments& arguments, std::size_t& i) {
  Limits limits;
  for (const OptionSetting& setting : settings_after(arguments, i, {"time", "memory", "steps"})) {
    double bytes = 0;
    const std::string text = "--limit " + setting.text();
    if (setting.name == "time") {
      if (!read_amount(setting.value, durations, limits.seconds))
        refuse("--limit", setting, "time=60s (ms, s, min or h)");
      limits.time_text = text;
    } else if (setting.name == "memory") {
      if (!read_amount(setting.value, sizes, bytes)) refuse("--limit", setting, "memory=500MB (kB, MB or GB)");
      limits.memory = std::size_t(bytes);
      limits.memory_text = text;
    } else {
      if (!read_steps(setting.value, false, limits.steps)) refuse("--limit", setting, "steps=1000");
      limits.steps_text = text;
    }
  }
  return limits;
}

}  // namespace

const std::string& value_after(const Arguments& arguments, std::size_t& i) {
  if (i + 1 == arguments.size()) throw UsageError{arguments[i] + ": expected a value after it"};
  return arguments[++i];
}

std::vector<std::string> comma_separated(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == ',')
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

SessionOptions read_scene_arguments(const Arguments& arguments, const std::string& command) {
  SessionOptions options = named(arguments, command);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (!read_scene_option(arguments, i, options)) throw UsageError{"unexpected argument \"" + arguments[i] + "\""};
  if (options.script.empty()) throw UsageError{"expected a scene"};
  return options;
}

int run_command(const Arguments& arguments) {
  SessionOptions options = named(arguments, "talus");
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--restart") {
      options.restart = value_after(arguments, i);
    } else if (arguments[i] == "--inputs") {
      options.inputs_file = value_after(arguments, i);
    } else if (arguments[i] == "--resume") {
      options.resume = true;
    } else if (arguments[i] == "-i") {
      options.interactive = true;
    } else if (arguments[i] == "--trust") {
      options.trust = true;
    } else if (arguments[i] == "--checkpoint") {
      options.checkpoint = read_checkpoint(arguments, i);
    } else if (arguments[i] == "--limit") {
      options.limits = read_limits(arguments, i);
    } else if (!read_scene_option(arguments, i, options)) {
      throw UsageError{"unexpected argument \"" + arguments[i] + "\""};
    }
  }
  if (options.script.empty()) throw UsageError{"expected a scene"};
  if (options.resume && !options.restart.empty()) throw UsageError{"expected --restart or --resume, got both"};
  return Session(std::move(options)).execute();
}

int check_command(const Arguments& arguments) {
  SessionOptions options = read_scene_arguments(arguments, "talus check");
  options.plan_only = options.estimate = true;
  return Session(std::move(options)).execute();
}

int plan_command(const Arguments& arguments) {
  for (const std::string& argument : arguments)
    if (argument == "--restart") throw UsageError{"plan: expected no --restart, nothing is run"};
  SessionOptions options = read_scene_arguments(arguments, "talus plan");
  options.plan_only = true;
  return Session(std::move(options)).execute();
}

int parameters_command(const Arguments& arguments) {
  SessionOptions options = read_scene_arguments(arguments, "talus parameters");
  options.parameters_only = true;
  Session session(std::move(options));
  const int status = session.execute();
  // The first two words of a line are read by `talus sweep` too.
  for (const DeclaredParameter& known : session.declared())
    std::printf("%s  %s  %s\n", known.name.c_str(), known.type == "string" ? "text" : known.type.c_str(),
                known.meaning.c_str());
  return status;
}

}  // namespace talus
