#include "output/view_page.h"

#include <algorithm>
#include <cmath>

#include "model/fields.h"
#include "output/colour_map.h"
#include "output/json.h"
#include "output/text.h"
#include "output/view_data.h"
#include "output/view_pack.h"
#include "output/view_parts.h"

namespace talus {

namespace {

struct Meaning {
  std::string symbol, unit, meaning;
};

Meaning meaning_of(const ViewArray& array) {
  if (array.name == "gas") return {"gas", "", "part of each crack that the gas has entered"};
  if (array.name == "gas_pressure") return {"P", "Pa", "pressure of the gas in each crack"};
  if (array.name == "mode" && array.of == "joints")
    return {"", "", "0 intact, failed in 1 tension, 2 shear, 3 a real joint"};
  if (array.name == "state" && array.of == "joints") return {"", "", "0 intact, 1 failed"};
  const Field* field = find_field(array.of == "joints" ? joint_fields() : block_fields(), array.name);
  if (!field) return {"", "", array.name};
  std::string meaning = field->meaning;
  if (const auto from_zero = meaning.find(", from 0"); from_zero != std::string::npos) meaning.erase(from_zero, 8);
  return {field->symbol, field->unit, meaning};
}

// Adds packed numbers, each a <script> of its own that the page reads when it needs it.
class Pages {
 public:
  int add(const std::string& packed) {
    scripts_ += "<script type=\"text/plain\" id=\"a" + std::to_string(count_) + "\">" + packed + "</script>\n";
    return count_++;
  }
  const std::string& scripts() const { return scripts_; }

 private:
  std::string scripts_;
  int count_ = 0;
};

// Of an array that never changes one frame is kept.
bool constant(const ViewArray& array, std::size_t frames) {
  const std::size_t size = array.values.size() / frames;
  for (std::size_t i = size; i < array.values.size(); ++i)
    if (array.values[i] != array.values[i - size]) return false;
  return true;
}

void add_array(Json& json, Pages& pages, ViewArray& array, std::size_t frames) {
  const bool same = constant(array, frames);
  if (same) array.values.resize(array.values.size() / frames);
  const int bytes = 3;
  std::string packed;
  if (array.whole) {
    packed = packed_whole(std::vector<int>(array.values.begin(), array.values.end()));
  } else {
    packed = packed_floats(array.values, bytes);
  }
  const Meaning about = meaning_of(array);
  json.object().text("name", array.name).text("of", array.of).whole("components", array.components);
  json.text("symbol", about.symbol).text("unit", about.unit).text("meaning", about.meaning).truth("whole", array.whole);
  json.truth("constant", same).whole("bytes", array.whole ? 4 : bytes).whole("data", pages.add(packed)).end();
}

void add_names(Json& json, const ViewData& data) {
  json.object("names");
  for (const auto& [key, names] : data.names) {
    json.array(key);
    for (const std::string& name : names) json.text(name);
    json.end();
  }
  json.end();
}

void add_history(Json& json, Pages& pages, const ResultsFolder& run) {
  const std::vector<HistoryColumn> columns = run.history();
  json.object("history").array("columns");
  std::vector<float> values;
  for (const HistoryColumn& column : columns) {
    json.object().text("name", column.name).text("unit", column.unit).end();
    for (const double value : column.values) values.push_back(static_cast<float>(value));
  }
  json.end().whole("rows", columns.empty() ? 0 : static_cast<long>(columns.front().values.size()));
  json.whole("data", pages.add(packed_floats(values, 4))).end();
}

void add_colours(Json& json) {
  constexpr int levels = 64;
  json.object("colours");
  for (const auto& [name, map] : {std::pair{"sequential", ColourMap::sequential},
                                  {"diverging", ColourMap::diverging},
                                  {"categories", ColourMap::categories}}) {
    json.array(name);
    for (int k = 0; k < levels; ++k) json.text(colour(map, (k + 0.5) / levels));
    json.end();
  }
  json.end();
}

std::vector<std::size_t> chosen(std::size_t count, int every) {
  std::vector<std::size_t> frames;
  for (std::size_t k = 0; k < count; k += static_cast<std::size_t>(every)) frames.push_back(k);
  if (frames.back() + 1 != count) frames.push_back(count - 1);
  return frames;
}

// "</script>" in a name must not end the script that the names are in.
std::string in_script(std::string json) {
  for (std::size_t at = 0; (at = json.find("</", at)) != std::string::npos; at += 3) json.replace(at, 2, "<\\/");
  return json;
}

std::string filled(std::string page, const std::string& mark, const std::string& content) {
  for (std::size_t at = 0; (at = page.find(mark, at)) != std::string::npos; at += content.size())
    page.replace(at, mark.size(), content);
  return page;
}

}  // namespace

std::string view_page(const ResultsFolder& run, const ViewOptions& options) {
  ViewData data = view_data(run, chosen(run.times().size(), options.every), options.fields);
  Pages pages;
  Json json;
  json.object().text("title", run.title()).whole("blocks", static_cast<long>(data.begin.size()) - 1);
  json.whole("corners", data.begin.back()).whole("joints", static_cast<long>(data.joints()));
  json.number("centre_x", data.centre.x()).number("centre_y", data.centre.y()).array("times");
  for (const double time : data.times) json.number("", time);
  json.end()
      .whole("begin", pages.add(packed_whole(data.begin)))
      .whole("start", pages.add(packed_floats(data.start, 4)));
  json.whole("joint_blocks", pages.add(packed_whole(data.joint_blocks)))
      .whole("edge", pages.add(packed_whole(data.edge)));
  json.whole("along", pages.add(packed_floats(data.along, 4))).array("arrays");
  for (ViewArray& array : data.arrays) add_array(json, pages, array, data.times.size());
  json.end();
  add_names(json, data);
  add_history(json, pages, run);
  add_colours(json);
  json.end();
  std::string page = filled(view_parts::page, "@title@", escape_xml(run.title()));
  page = filled(std::move(page), "@style@", view_parts::style);
  const std::string script = "<script type=\"application/json\" id=\"meta\">" + in_script(json.file()) + "</script>\n";
  return filled(std::move(page), "@data@", script + pages.scripts() + "<script>" + view_parts::script + "</script>");
}

}  // namespace talus
