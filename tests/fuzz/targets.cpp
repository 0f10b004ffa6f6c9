#include "targets.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "geometry/polygon.h"
#include "geometry/tessellation.h"
#include "script/session.h"

namespace talus::fuzz {
namespace {

// Outline and traces of the bytes, two a coordinate, on a grid so that much coincides; cut, and meshed three ways.
class Bytes {
 public:
  explicit Bytes(const std::string& bytes) : bytes_(bytes) {}
  int next() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0; }
  double coordinate() {
    const int high = next(), low = next();
    return low < 128 ? high / 16.0 : (high + (low - 191.5) * 1e-3) / 16.0;
  }
  Polyline line(int most) {
    Polyline points(size_t(2 + next() % most));
    for (Vec2& point : points) point = Vec2(coordinate(), coordinate());
    return points;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

void check_areas(const Tessellation& t, const TessellationInput& input) {
  double area = signed_area(input.outline), sum = 0;
  for (const Polyline& hole : input.holes) area -= signed_area(hole);
  for (const auto& cell : t.cells) {
    Polyline polygon;
    for (const int p : cell) polygon.push_back(t.points[size_t(p)]);
    sum += signed_area(polygon);
  }
  if (!(std::abs(sum - area) <= 1e-6 * area))
    throw std::logic_error("areas: " + std::to_string(sum) + " of " + std::to_string(area));
}

void run_geometry(const std::string& input) {
  Bytes bytes(input);
  TessellationInput region;
  region.outline = bytes.line(8);
  if (signed_area(region.outline) < 0) std::reverse(region.outline.begin(), region.outline.end());
  if (region.outline.size() < 3 || defect(region.outline)) region.outline = {{0, 0}, {16, 0}, {16, 16}, {0, 16}};
  for (int traces = bytes.next() % 6; traces > 0; --traces) region.traces.push_back(bytes.line(4));
  const double size = 1 + bytes.next() / 32.0;
  const auto size_at = [&](const Vec2&) { return size; };
  for (int way = 0; way < 3; ++way) {
    try {
      check_areas(way == 0   ? cut(region)
                  : way == 1 ? mesh(region, size_at, 5000)
                             : voronoi(region, size_at, 1, 5000),
                  region);
    } catch (const std::invalid_argument&) {
    } catch (const std::length_error&) {
    }
  }
}

// A whole scene, by the program's own way; what it prints is thrown away.
void run_scene_text(const std::string& text) {
  static const std::string folder =
      (std::filesystem::temp_directory_path() / ("talus_fuzz_scene_" + std::to_string(getpid()))).string();
  std::filesystem::create_directories(folder);
  const std::string path = folder + "/scene.lua";
  std::ofstream(path, std::ios::binary) << text;
  SessionOptions options;
  options.script = path;
  options.progress = false;
  options.limits.steps = 15;
  options.limits.steps_text = "--limit steps=15";
  const int status = Session(std::move(options)).execute();
  if (status != exit_ok && status != exit_bad_input && status != exit_run_stopped && status != exit_check_failed)
    throw std::logic_error("exit status " + std::to_string(status));
}

// What names talus is a scene; anything else draws one.
void run_scene(const std::string& input) {
  Fnv seed;
  seed.add(input);
  run_scene_text(input.find("talus") == std::string::npos ? random_scene(seed.value()) : input);
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> list = [] {
    std::vector<Target> all = readers();
    all.insert(all.end(), {{"geometry", run_geometry, {std::string(4, 0), std::string("\x80\x00\x80\x00", 4)}},
                           {"scene",
                            run_scene,
                            {"nan", "1/0", "-1", "{}", "nil", "function() end", "1e300", "\"x\"", "0", "true",
                             "talus.rect(0, 0, 1, 1)"}}});
    return all;
  }();
  return list;
}

}  // namespace talus::fuzz
