#include "sweep/scene_parameters.h"

#include <filesystem>
#include <map>
#include <sstream>

#include "scene/error.h"
#include "script/nearest.h"
#include "sweep/process.h"

namespace talus {

namespace {

struct Declared {
  std::map<std::string, std::string> types;  // name -> number, text, boolean
  std::string problem;                       // why the script did not come to its first simulation
};

// The scene up to its first simulation, with the values of the first run.
Declared ask(const Study& study) {
  std::vector<std::string> words = {program_path(), "parameters", study.scene};
  for (const Setting& setting : study.runs.front().settings) {
    words.push_back("-p");
    words.push_back(setting.name + "=" + setting.text);
  }
  const Captured captured = capture(words);
  Declared declared;
  std::istringstream lines(captured.text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("talus: ")) {
      declared.problem = line.substr(7);
      continue;
    }
    std::istringstream parts(line);
    std::string name, type;
    if (parts >> name >> type) declared.types[name] = type;
  }
  if (captured.exit_status != 0 && declared.problem.empty())
    declared.problem = "it ended with exit status " + std::to_string(captured.exit_status);
  return declared;
}

bool fits(const Setting& setting, const std::string& type) {
  return type == "text" || setting.type == type;
}

std::string in_words(const std::string& type) {
  return type == "boolean" ? "true or false" : "a " + type;
}

}  // namespace

void check_parameters(const Study& study) {
  if (!std::filesystem::is_regular_file(study.scene))
    throw InputError(study.place, "study.scene", "a scene's file, from the study's folder on",
                     study.scene + ", which is not there");
  const Declared declared = ask(study);
  if (declared.types.empty() && !declared.problem.empty())
    throw InputError(study.place, "study.scene", "a scene that comes to its first simulation", declared.problem);
  std::vector<std::string> names;
  for (const auto& [name, type] : declared.types) names.push_back(name);
  for (const std::string& name : study.parameters)
    if (!declared.types.contains(name))
      throw InputError(study.place, "study", "parameters of " + study.scene,
                       '"' + name + '"' + suggestion(name, names) +
                           (declared.problem.empty() ? "" : " (the scene ends early: " + declared.problem + ")"));
  for (const StudyRun& run : study.runs)
    for (const Setting& setting : run.settings)
      if (const std::string& type = declared.types.at(setting.name); !fits(setting, type))
        throw InputError(study.place, "study: " + setting.name,
                         in_words(type) + ", as its default in " + study.scene + " is",
                         setting.type == "string" ? '"' + setting.text + '"' : setting.text);
}

}  // namespace talus
