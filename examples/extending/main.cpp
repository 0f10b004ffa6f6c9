// Runs a scene on an elastic bed from (0, 0) to (4, 0). Run: bed scene.lua
#include <cstdio>
#include <memory>

#include "bed.h"
#include "script/session.h"
#include "step/step_parts.h"

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("bed scene.lua\n", stderr), 2;
  talus::SessionOptions options;
  options.script = argv[1];
  options.library = TALUS_LIBRARY;  // find_package(Talus) says where
  options.progress = false;
  options.on_run = [](talus::Run& run) {  // each simulation that the scene makes, before its first step
    const talus::Model& model = run.simulation.model;
    run.simulation.step_parts().terms.push_back(
        std::make_shared<Bed>(model, talus::Vec2(0, 0), talus::Vec2(4, 0), talus::Vec2(1e7, 1e7)));
  };
  return talus::Session(std::move(options)).execute();
}
