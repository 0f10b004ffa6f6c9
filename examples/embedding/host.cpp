// A program of one's own that runs a scene, watches its steps, and reads what came of it.
// Run: host scene.lua [name=value …]
#include <cstdio>
#include <string>

#include "script/session.h"

int main(int argc, char** argv) {
  if (argc < 2) return std::fputs("host scene.lua [name=value …]\n", stderr), 2;
  talus::SessionOptions options;
  options.script = argv[1];
  options.library = TALUS_LIBRARY;  // find_package(Talus) says where
  options.progress = false;
  for (int i = 2; i < argc; ++i) {
    const std::string text = argv[i];
    options.parameters.emplace_back(text.substr(0, text.find('=')), text.substr(text.find('=') + 1));
  }
  long steps = 0;
  double strain = 0;                       // J per metre
  options.on_run = [&](talus::Run& run) {  // each simulation that the scene makes
    run.simulation.on_step.emplace_back([&](talus::Simulation& simulation) {
      ++steps;
      strain = simulation.energies().strain;
    });
  };
  const int status = talus::Session(std::move(options)).execute();
  std::printf("host: %ld calls, strain energy %.6g J/m, exit status %d\n", steps, strain, status);
  return status;
}
