#include "output/result_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/error.h"
#include "script/nearest.h"

namespace talus {

namespace {

struct Derived {
  const char *name, *array;
  int component;  // -1: the vector's length
};
constexpr std::array derived = {Derived{"ux", "displacement", 0}, Derived{"uy", "displacement", 1},
                                Derived{"u", "displacement", -1}, Derived{"speed", "velocity", -1},
                                Derived{"exx", "strain", 0},      Derived{"eyy", "strain", 1},
                                Derived{"gxy", "strain", 2}};

double length(const ResultArray& array, std::size_t item) {
  return array.components == 1 ? array.at(item) : std::hypot(array.at(item, 0), array.at(item, 1));
}

// "strain" is no vector: its components are fields of their own.
bool drawable(const ResultArray& array) {
  return array.name != "strain";
}

void add_names(std::vector<std::string>& names, const ResultFrame& frame) {
  for (const ResultArray& array : frame.cells)
    if (drawable(array)) names.push_back(array.name);
  for (const Derived& one : derived)
    if (frame.cell(one.array)) names.emplace_back(one.name);
}

[[noreturn]] void refuse(const ResultsFolder& run, std::size_t frame, const ResultFrame& blocks,
                         const std::string& name) {
  std::vector<std::string> known = {"none"};
  add_names(known, blocks);
  for (const char* series : {"cracks", "joints"})
    if (const auto lines = run.lines(series, frame)) add_names(known, *lines);
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  throw InputError({}, "--field", "a field of the run's results", "\"" + name + "\"" + suggestion(name, known));
}

// Rounding alone: a frame in which all stresses are this far below the largest of any kind shows none.
double noise_of(const ResultFrame& blocks, const Field* field) {
  double largest = 0;
  if (!field || field->unit != "Pa") return 0;
  for (const char* stress : {"sxx", "syy", "sxy"})
    if (const ResultArray* array = blocks.cell(stress))
      for (const double value : array->values) largest = std::max(largest, std::abs(value));
  return 1e-9 * largest;
}

void describe(PictureField& out, const Field* field, const std::string& name) {
  const bool known = field && !field->symbol.empty();
  out.symbol = known ? field->symbol : name;
  out.subscripts = known;
  out.unit = field ? field->unit : "";
  out.meaning = field ? field->meaning : name;
  out.whole = field && field->whole;
}

bool says_something_of_held(const std::string& name, const Field* field) {
  return !field || field->whole || name == "order";
}

// The values of the blocks; those of held blocks mostly say nothing.
PictureField of_blocks(const ResultFrame& blocks, const std::string& name, std::vector<double> values) {
  const Field* field = find_field(block_fields(), name);
  PictureField out;
  describe(out, field, name);
  out.noise = noise_of(blocks, field);
  out.categories = name == "fragment" || name == "region" || name == "material";
  out.values = std::move(values);
  const ResultArray* fixed = blocks.cell("fixed");
  for (std::size_t b = 0; b < out.values.size(); ++b) {
    out.grey.push_back(fixed && fixed->at(b) != 0 && !says_something_of_held(name, field));
    if (!out.grey.back()) out.coloured.push_back(out.values[b]);
  }
  if (out.coloured.empty()) out.coloured = {0};
  return out;
}

// "… from 0" are numbers of the engine; in files, as in Lua, blocks and fragments are counted from 1 where `id` is.
std::string counted(const PictureField& field, const ResultFrame& blocks, const std::string& name) {
  std::vector<double> different = field.values;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  const auto names = blocks.names.find(name + "_names");
  std::string text = std::to_string(different.size()) + " " + name + (different.size() == 1 ? "" : "s");
  if (names != blocks.names.end() && names->second.size() <= 8)
    for (std::size_t k = 0; k < names->second.size(); ++k) text += (k == 0 ? ": " : ", ") + names->second[k];
  return text + ", a colour each";
}

}  // namespace

std::optional<std::vector<double>> values_of(const ResultFrame& frame, const std::string& name) {
  std::vector<double> values(frame.size());
  if (const ResultArray* array = frame.cell(name); array && drawable(*array)) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = length(*array, i);
    return values;
  }
  for (const Derived& one : derived) {
    const ResultArray* array = one.name == name ? frame.cell(one.array) : nullptr;
    if (!array) continue;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = one.component < 0 ? length(*array, i) : array->at(i, one.component);
    return values;
  }
  return std::nullopt;
}

ResultField result_field(const ResultsFolder& run, std::size_t frame, const ResultFrame& blocks,
                         const std::string& name) {
  ResultField out;
  if (name == "none") {
    out.picture.of_lines = out.picture.categories = true;  // pale blocks, no bar
    out.picture.coloured = {0};
    return out;
  }
  if (auto values = values_of(blocks, name)) {
    out.picture = of_blocks(blocks, name, std::move(*values));
    if (out.picture.categories) out.picture.meaning = counted(out.picture, blocks, name);
    return out;
  }
  for (const char* series : {"cracks", "joints"}) {
    const auto lines = run.lines(series, frame);
    auto values = lines ? values_of(*lines, name) : std::nullopt;
    if (!values) continue;
    describe(out.picture, find_field(joint_fields(), name), name);
    if (name == "gas") out.picture.meaning = "part of each crack that the gas has entered";
    if (name == "gas_pressure")
      out.picture.meaning = "pressure of the gas in each crack", out.picture.unit = "Pa", out.picture.symbol = "P";
    out.picture.of_lines = true;
    out.picture.values = out.picture.coloured = std::move(*values);
    if (out.picture.coloured.empty()) out.picture.coloured = {0};
    out.lines = series;
    return out;
  }
  refuse(run, frame, blocks, name);
}

std::string array_of(const std::string& field) {
  for (const Derived& one : derived)
    if (field == one.name) return one.array;
  return field;
}

}  // namespace talus
