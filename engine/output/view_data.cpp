#include "output/view_data.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "output/result_fields.h"
#include "scene/error.h"
#include "script/nearest.h"

namespace talus {

namespace {

constexpr std::array left_out = {"id", "block_a", "block_b", "kind", "strain", "s1_direction"};
// the others are of joints.pvd as well, or constant
constexpr std::array of_cracks = {"mode", "failed_at", "gas", "gas_pressure"};

class Collector {
 public:
  Collector(const ResultsFolder& run, const std::vector<std::string>& fields) : run_(run) {
    for (const std::string& field : fields) fields_.push_back(array_of(field));
  }
  ViewData collect(const std::vector<std::size_t>& frames);

 private:
  bool wanted(const std::string& name) const {
    if (!fields_.empty()) return name == "fixed" || std::find(fields_.begin(), fields_.end(), name) != fields_.end();
    return std::find(left_out.begin(), left_out.end(), name) == left_out.end();
  }
  ViewArray& array(const std::string& name, const std::string& of, int components, bool whole);
  void take(const ResultArray& from, const std::string& of, std::size_t count);
  void begin(const ResultFrame& blocks);
  void add_blocks(const ResultFrame& blocks);
  void find_joints(const ResultFrame& blocks, const ResultFrame& lines);
  void add_joints(const ResultFrame& lines);
  void add_cracks(const ResultFrame& cracks);
  void check_fields() const;

  const ResultsFolder& run_;
  std::vector<std::string> fields_;
  std::vector<std::string> known_;
  ViewData data_;
};

ViewArray& Collector::array(const std::string& name, const std::string& of, int components, bool whole) {
  for (ViewArray& each : data_.arrays)
    if (each.name == name && each.of == of) return each;
  data_.arrays.push_back({name, of, components, whole, {}});
  return data_.arrays.back();
}

void Collector::take(const ResultArray& from, const std::string& of, std::size_t count) {
  const int components = from.components == 1 ? 1 : 2;
  ViewArray& to = array(from.name, of, components, from.whole);
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < components; ++k) to.values.push_back(static_cast<float>(from.at(i, k)));
}

void Collector::begin(const ResultFrame& blocks) {
  const ResultArray* moved = blocks.of_point("displacement");
  if (!moved) throw RunError(run_.dir() + ": expected displacements of the blocks' corners, got none");
  std::vector<Vec2> start;
  Vec2 low = Vec2::Constant(INFINITY), high = -low;
  for (std::size_t v = 0; v < blocks.points.size(); ++v) {
    start.push_back(blocks.points[v] - Vec2(moved->at(v, 0), moved->at(v, 1)));
    low = low.cwiseMin(start.back());
    high = high.cwiseMax(start.back());
  }
  data_.centre = (low + high) / 2;
  data_.begin = blocks.begin;
  data_.names = blocks.names;
  for (const Vec2& p : start)
    for (const int k : {0, 1}) data_.start.push_back(static_cast<float>(p[k] - data_.centre[k]));
}

void Collector::add_blocks(const ResultFrame& blocks) {
  if (blocks.begin != data_.begin) throw RunError(run_.dir() + ": the frames are not of one run: their blocks differ");
  take(*blocks.of_point("displacement"), "corners", blocks.points.size());
  for (const ResultArray& each : blocks.cells) {
    if (each.name != "id") known_.push_back(each.name);
    if (wanted(each.name)) take(each, "blocks", blocks.size());
  }
}

// The edge of the block that the point lies on, and where.
std::pair<int, float> on_edge(const ResultFrame& blocks, int block, const Vec2& p) {
  std::pair<int, float> out = {0, 0};
  double least = INFINITY;
  const int begin = blocks.begin[block], end = blocks.begin[block + 1];
  for (int v = begin; v < end; ++v) {
    const Vec2 from = blocks.points[v], span = blocks.points[v + 1 < end ? v + 1 : begin] - from;
    const double along = std::clamp((p - from).dot(span) / span.squaredNorm(), 0.0, 1.0);
    const double far = (from + along * span - p).norm();
    if (far < least) least = far, out = {v, static_cast<float>(along)};
  }
  return out;
}

void Collector::find_joints(const ResultFrame& blocks, const ResultFrame& lines) {
  const ResultArray *kind = lines.cell("kind"), *a = lines.cell("block_a"), *b = lines.cell("block_b");
  if (!kind || !a || !b) return;
  for (std::size_t j = 0; j < lines.size() && kind->at(j) == 0; ++j) {  // contacts come after the joints
    const int sides[] = {int(a->at(j)) - 1, int(b->at(j)) - 1};
    for (const int side : sides) {
      if (side < 0 || std::size_t(side) >= blocks.size())
        throw RunError(run_.dir() + ": a joint is of a block that there is not");
      data_.joint_blocks.push_back(side);
    }
    for (const int k : {0, 1})
      for (const int side : sides) {
        const auto [edge, along] = on_edge(blocks, side, lines.points[std::size_t(lines.begin[j] + k)]);
        data_.edge.push_back(edge);
        data_.along.push_back(along);
      }
  }
}

void Collector::add_joints(const ResultFrame& lines) {
  if (lines.size() < data_.joints())
    throw RunError(run_.dir() + ": the frames are not of one run: their joints differ");
  for (const ResultArray& each : lines.cells) {
    if (std::find(left_out.begin(), left_out.end(), each.name) == left_out.end()) known_.push_back(each.name);
    if (wanted(each.name)) take(each, "joints", data_.joints());
  }
}

// Cracks are joints: their arrays become arrays of all joints. `mode`: 0 intact, 1 tension, 2 shear, 3 a real joint.
void Collector::add_cracks(const ResultFrame& cracks) {
  const ResultArray* id = cracks.cell("id");
  for (const char* name : of_cracks) {
    const ResultArray* from = cracks.cell(name);
    if (!from || !id) continue;
    known_.push_back(name);
    const bool is_mode = from->name == "mode";
    if (!is_mode && from->name != "gas" && !wanted(name)) continue;  // those two are drawn whatever the colours show
    ViewArray& to = array(name, "joints", 1, from->whole);
    const std::size_t first = to.values.size();
    to.values.resize(first + data_.joints(), 0);
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      const auto joint = static_cast<std::size_t>(id->at(i)) - 1;
      if (joint < data_.joints())
        to.values[first + joint] = static_cast<float>(is_mode && from->at(i) == 0 ? 3 : from->at(i));
    }
  }
}

void Collector::check_fields() const {
  for (const std::string& name : fields_)
    if (std::find(known_.begin(), known_.end(), name) == known_.end())
      throw InputError({}, "--fields", "arrays of the run's results", "\"" + name + "\"" + suggestion(name, known_));
}

ViewData Collector::collect(const std::vector<std::size_t>& frames) {
  for (const std::size_t frame : frames) {
    const bool first = data_.times.empty();
    const ResultFrame blocks = run_.blocks(frame);
    const auto lines = run_.lines("joints", frame);
    if (first) begin(blocks);
    if (run_.has("joints") && !lines) break;  // a run that was killed between the two
    if (first && lines) find_joints(blocks, *lines);
    const auto cracks = run_.lines("cracks", frame);
    if (run_.has("cracks") && !cracks) break;
    add_blocks(blocks);
    if (lines && data_.joints() > 0) add_joints(*lines);
    if (cracks && data_.joints() > 0) add_cracks(*cracks);
    data_.times.push_back(run_.times()[frame].first);
    if (first)
      std::sort(known_.begin(), known_.end()), known_.erase(std::unique(known_.begin(), known_.end()), known_.end()),
          check_fields();
  }
  if (data_.times.empty()) throw RunError(run_.dir() + ": expected a frame or more, got none that is whole");
  return std::move(data_);
}

}  // namespace

ViewData view_data(const ResultsFolder& run, const std::vector<std::size_t>& frames,
                   const std::vector<std::string>& fields) {
  return Collector(run, fields).collect(frames);
}

}  // namespace talus
