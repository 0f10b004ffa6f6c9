// libFuzzer's way into the readers: it keeps inputs that reach code no other has. scripts/fuzz --guided compiles it with
// clang; TALUS_FUZZ_TARGET names the reader.
#include <cstdio>
#include <cstdlib>

#include "model/state_visitor.h"
#include "targets.h"

namespace talus {  // what a state has of a model is written elsewhere, and not read here
class Model;
struct Scene;
void visit_state(Model&, StateVisitor&) {}
void visit_values(Scene&, StateVisitor&) {}
}  // namespace talus

namespace {
const talus::fuzz::Target* chosen = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  static const std::vector<talus::fuzz::Target> readers = talus::fuzz::readers();
  const char* name = std::getenv("TALUS_FUZZ_TARGET");
  for (const auto& reader : readers)
    if (name && std::string(name) == reader.name) chosen = &reader;
  if (chosen) return 0;
  std::fprintf(stderr, "TALUS_FUZZ_TARGET: expected dxf, csv, state or gmsh, got %s\n", name ? name : "nothing");
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
