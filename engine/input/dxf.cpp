#include <algorithm>
#include <cmath>

#include "input/arc.h"
#include "input/drawing.h"
#include "input/text_rows.h"

namespace talus {
namespace {

// $INSUNITS of the DXF reference.
struct Unit {
  int code;
  const char* name;
  double metres;
};
constexpr Unit units[] = {{1, "inches", 0.0254},
                          {2, "feet", 0.3048},
                          {3, "miles", 1609.344},
                          {4, "mm", 1e-3},
                          {5, "cm", 1e-2},
                          {6, "m", 1},
                          {7, "km", 1e3},
                          {8, "microinches", 2.54e-8},
                          {9, "mils", 2.54e-5},
                          {10, "yards", 0.9144},
                          {13, "microns", 1e-6},
                          {14, "dm", 0.1},
                          {15, "dam", 10},
                          {16, "hm", 100},
                          {21, "US survey feet", 1200.0 / 3937}};

struct Group {
  int code = 0;
  std::string_view value;
  int line = 0;  // of the value
};

struct Entity {
  std::string_view type;
  int line = 0;
  std::vector<Group> groups;
};

class DxfReader {
 public:
  DxfReader(const std::string& text, const std::string& file, double chord) : rows_(text), file_(file), chord_(chord) {}
  Drawing read();

 private:
  Group next();
  void read_section(std::string_view name);
  void read_unit(const Group& group);
  void take(Entity entity);
  void take_polyline(const Entity& entity);
  void add(const Entity& entity, Polyline points, bool closed);
  void add_light_polyline(const Entity& entity);
  void add_arc(const Entity& entity, bool whole);
  double number(const Group& group) const;
  double value(const Entity& entity, int code, std::optional<double> otherwise = std::nullopt) const;
  std::string layer(const Entity& entity) const;
  // 1, -1 where it is seen from below (extrusion 0, 0, -1: x is mirrored), 0 where it lies in another plane.
  int side(const Entity& entity) const;
  // Of a layout, its frame or its title: not of the drawn ground.
  bool on_paper(const Entity& entity) const { return value(entity, 67, 0) == 1; }
  [[noreturn]] void refuse(int line, const std::string& expected, const std::string& given) const {
    throw FileError(file_, line, expected, given);
  }

  TextRows rows_;
  const std::string& file_;
  double chord_;
  std::size_t points_ = 0;
  bool in_polyline_ = false;
  Entity polyline_;  // POLYLINE, and the groups of its VERTEXes after it
  std::vector<BulgedPoint> vertices_;
  Drawing drawing_;
};

Group DxfReader::next() {
  const auto code = rows_.next();
  const int line = rows_.line();
  const auto value = rows_.next();
  if (!code || !value) refuse(rows_.line(), "pairs of group code and value up to 0, EOF", "the end of the file");
  const auto number = finite_number(*code);
  if (!number || *number != std::floor(*number) || std::abs(*number) > 1071)
    refuse(line, "a group code (an integer)", quoted(*code));
  return {static_cast<int>(*number), *value, line + 1};
}

double DxfReader::number(const Group& group) const {
  if (const auto value = finite_number(group.value)) return *value;
  refuse(group.line, "a finite number after group code " + std::to_string(group.code), quoted(group.value));
}

double DxfReader::value(const Entity& entity, int code, std::optional<double> otherwise) const {
  for (const Group& group : entity.groups)
    if (group.code == code) return number(group);
  if (otherwise) return *otherwise;
  refuse(entity.line, std::string(entity.type) + " with group code " + std::to_string(code), "none");
}

std::string DxfReader::layer(const Entity& entity) const {
  for (const Group& group : entity.groups)
    if (group.code == 8) return std::string(group.value);
  return "0";
}

int DxfReader::side(const Entity& entity) const {
  const double x = value(entity, 210, 0), y = value(entity, 220, 0), z = value(entity, 230, 1);
  constexpr double upright = 1e-9;  // of a unit vector
  if (std::abs(x) > upright || std::abs(y) > upright) return 0;
  return z > 0 ? 1 : -1;
}

void DxfReader::read_unit(const Group& group) {
  const double code = number(group);
  const auto unit = std::find_if(std::begin(units), std::end(units), [code](const Unit& u) { return u.code == code; });
  if (code == 0) return;
  if (unit == std::end(units)) refuse(group.line, "$INSUNITS of a length up to hectometres", quoted(group.value));
  drawing_.unit = unit->metres;
  drawing_.unit_name = unit->name;
}

void DxfReader::add(const Entity& entity, Polyline points, bool closed) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (closed || (points.size() > 3 && points.front() == points.back())) {
    if (points.size() > 1 && points.front() == points.back()) points.pop_back();
    closed = points.size() > 2;
  }
  if (points.size() < 2)
    refuse(entity.line, std::string(entity.type) + " of two or more different points", "one point");
  if ((points_ += points.size()) > most_points) refuse(entity.line, "at most 1000000 points", "more");
  drawing_.lines.push_back({layer(entity), std::move(points), closed, entity.line});
}

void DxfReader::add_light_polyline(const Entity& entity) {
  std::vector<BulgedPoint> vertices;
  for (const Group& group : entity.groups) {
    if (group.code == 10) vertices.push_back({{number(group), 0}, 0});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().at.y() = number(group);
    if (group.code == 42) vertices.back().bulge = number(group);
  }
  const bool closed = (static_cast<long>(value(entity, 70, 0)) & 1) != 0;
  add(entity, with_arcs(vertices, closed, side(entity), chord_), closed);
}

void DxfReader::add_arc(const Entity& entity, bool whole) {
  const Vec2 centre(value(entity, 10), value(entity, 20));
  const double radius = value(entity, 40);
  if (!(radius > 0)) refuse(entity.line, std::string(entity.type) + " with a radius > 0", std::to_string(radius));
  const double from = whole ? 0 : value(entity, 50), to = whole ? 360 : value(entity, 51);
  add(entity, arc(centre, radius, from * M_PI / 180, to * M_PI / 180, side(entity), chord_), whole);
}

// POLYLINE comes with VERTEX entities up to SEQEND.
void DxfReader::take_polyline(const Entity& entity) {
  if (entity.type == "VERTEX") {
    constexpr long of_frame = 16;  // a control point of a spline, not of its curve
    if ((static_cast<long>(value(entity, 70, 0)) & of_frame) != 0) return;
    vertices_.push_back({{value(entity, 10), value(entity, 20)}, value(entity, 42, 0)});
    return;
  }
  if (entity.type != "SEQEND") refuse(entity.line, "VERTEX or SEQEND after POLYLINE", quoted(entity.type));
  in_polyline_ = false;
  if (on_paper(polyline_)) {
    ++drawing_.skipped["POLYLINE in paper space"];
    return;
  }
  const long flags = static_cast<long>(value(polyline_, 70, 0));
  if ((flags & (16 | 64)) != 0 || side(polyline_) == 0) {
    ++drawing_.skipped[side(polyline_) == 0 ? "POLYLINE in another plane" : "POLYLINE mesh"];
    return;
  }
  const bool closed = (flags & 1) != 0;
  add(polyline_, with_arcs(vertices_, closed, side(polyline_), chord_), closed);
}

void DxfReader::take(Entity entity) {
  if (in_polyline_) return take_polyline(entity);
  if (on_paper(entity) && entity.type != "POLYLINE") {
    ++drawing_.skipped[std::string(entity.type.substr(0, 40)) + " in paper space"];
    return;
  }
  if (entity.type == "LINE")
    return add(entity, {{value(entity, 10), value(entity, 20)}, {value(entity, 11), value(entity, 21)}}, false);
  const bool known = entity.type == "LWPOLYLINE" || entity.type == "ARC" || entity.type == "CIRCLE";
  if (known && side(entity) == 0) {
    ++drawing_.skipped[std::string(entity.type) + " in another plane"];
  } else if (entity.type == "LWPOLYLINE") {
    add_light_polyline(entity);
  } else if (known) {
    add_arc(entity, entity.type == "CIRCLE");
  } else if (entity.type == "POLYLINE") {
    in_polyline_ = true;
    vertices_.clear();
    polyline_ = std::move(entity);
  } else {
    ++drawing_.skipped[std::string(entity.type.substr(0, 40))];
  }
}

void DxfReader::read_section(std::string_view name) {
  Entity entity;
  bool unit_follows = false;
  for (;;) {
    const Group group = next();
    if (group.code == 0 && name == "ENTITIES" && !entity.type.empty()) take(std::move(entity));
    if (group.code == 0 && group.value == "ENDSEC") break;
    if (group.code == 0 && group.value == "EOF") refuse(group.line, "ENDSEC", "EOF");
    if (group.code == 0) entity = {group.value, group.line, {}};
    if (group.code != 0 && name == "ENTITIES") entity.groups.push_back(group);
    if (unit_follows && group.code == 70) read_unit(group);
    if (name == "HEADER") unit_follows = group.code == 9 && group.value == "$INSUNITS";
  }
  if (in_polyline_) refuse(rows_.line(), "SEQEND after POLYLINE", "ENDSEC");
}

Drawing DxfReader::read() {
  bool drawn = false;
  for (Group group = next(); group.value != "EOF" || group.code != 0; group = next()) {
    if (group.code == 999) continue;  // comment
    if (group.code != 0 || group.value != "SECTION") refuse(group.line, "0, SECTION or 0, EOF", quoted(group.value));
    const Group name = next();
    if (name.code != 2) refuse(name.line, "the name of a section", quoted(name.value));
    drawn = drawn || name.value == "ENTITIES";
    read_section(name.value);
  }
  if (!drawn) refuse(rows_.line(), "a section ENTITIES", "none");
  return std::move(drawing_);
}

}  // namespace

Drawing read_dxf(const std::string& text, const std::string& file, double chord) {
  if (text.starts_with("AutoCAD Binary DXF"))
    throw FileError(file, 0, "an ASCII DXF", "a binary DXF: save it as ASCII");
  if (text.starts_with("AC10")) throw FileError(file, 0, "an ASCII DXF", "a DWG: save it as DXF");
  if (text.find('\0') != std::string::npos) throw FileError(file, 0, "an ASCII DXF", "a binary file");
  if (trimmed(text).empty()) throw FileError(file, 0, "an ASCII DXF", "an empty file");
  return DxfReader(text, file, chord).read();
}

}  // namespace talus
