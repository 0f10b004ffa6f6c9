// Readers of files that others wrote. On their own, so that libFuzzer can be led through them (guided.cc).
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "input/drawing.h"
#include "input/gmsh.h"
#include "output/state_file.h"
#include "targets.h"

namespace talus::fuzz {
namespace {

void run_dxf(const std::string& input) {
  try {
    read_dxf(input, "x.dxf", 0.05);
  } catch (const FileError&) {
  }
}

void run_csv(const std::string& input) {
  try {
    read_csv(input, "x.csv");
  } catch (const FileError&) {
  }
}

// As it stands, and as the body of a file whose checksum fits.
void run_state(const std::string& input) {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("talus_fuzz_" + std::to_string(getpid()))).string();
  std::string whole = "talus saved state\n";
  append(whole, std::uint64_t(2));
  append(whole, std::string_view(input));
  Fnv sum;
  sum.add(whole);
  append(whole, sum.value());
  for (const std::string* bytes : {&input, static_cast<const std::string*>(&whole)}) {
    std::ofstream(path, std::ios::binary) << *bytes;
    try {
      read_state(path);
    } catch (const StateError&) {
    }
  }
  std::filesystem::remove(path);
}

void run_gmsh(const std::string& input) {
  try {
    const GmshMesh mesh = read_gmsh(input, "x.msh");
    for (const auto& [name, curve] : mesh.curves) straight_runs(mesh, curve.lines);
  } catch (const FileError&) {
  }
}

}  // namespace

std::vector<Target> readers() {
  return {
      {"dxf",
       run_dxf,
       {"\n0\nLINE\n", "\n0\nLWPOLYLINE\n", "\n0\nARC\n", "\n42\n1e308\n", "\n90\n99999999\n", "\n70\n1\n",
        "\n10\nnan\n", "\n0\nEOF\n", "\n0\nSECTION\n", "\n9\n$INSUNITS\n", "\r\n", "\n0\nVERTEX\n", "\n0\nSEQEND\n"}},
      {"csv", run_csv, {"x,y\n", "trace,x,y\n", "x1,y1,x2,y2\n", ";", "\t", "#", "nan", "1e999", "\"", "\r", "1,2\n"}},
      {"state", run_state, {std::string(8, '\xff'), std::string(8, 0), "talus saved state\n"}},
      {"gmsh",
       run_gmsh,
       {"$MeshFormat\n", "$EndNodes\n", "$Elements\n", "$Entities\n", "$PhysicalNames\n", "2.2 0 8\n", "4.1 0 8\n",
        "4.1 1 8\n", " 2 ", " 9 ", "-1", "18446744073709551616", "1e999", "nan", "\"", "\r\n"}}};
}

}  // namespace talus::fuzz
