// The format: Gmsh reference manual, "MSH file format" (version 4.1) and "MSH file format version 2 (Legacy)".
#include "input/gmsh.h"

#include <algorithm>
#include <charconv>
#include <unordered_map>

#include "input/drawing.h"
#include "input/text_rows.h"

namespace talus {
namespace {

struct ElementKind {
  int nodes, corners;
  bool curved;
};

class GmshReader {
 public:
  GmshReader(const std::string& text, const std::string& file) : rows_(text), file_(file) {}
  GmshMesh read();

 private:
  using Words = std::vector<std::string_view>;

  [[noreturn]] void refuse(const std::string& expected, const std::string& given) const {
    throw FileError(file_, rows_.line(), expected, given);
  }
  std::string_view row(const std::string& what);
  Words words(const std::string& what, std::size_t least);
  long whole(std::string_view word, const char* what) const;
  long count(std::string_view word, const char* what) const;
  double number(std::string_view word) const;
  void read_format();
  void read_names();
  void read_entities();
  void read_nodes();
  void read_elements();
  void add_node(std::string_view tag, const Words& place, std::size_t first);
  ElementKind kind_of(long type) const;
  void add_element(long type, long group, const Words& nodes, std::size_t first);
  int point(std::string_view word) const;
  std::string name_of(int dimension, long group) const;
  void end_section(const std::string& name);
  void skip_section(const std::string& name);

  TextRows rows_;
  const std::string& file_;
  bool old_ = false;                                   // version 2
  std::map<std::pair<int, long>, std::string> names_;  // of physical groups, by dimension and tag
  // version 4: of curves and surfaces, the first of theirs
  std::map<std::pair<int, long>, long> group_of_;
  std::unordered_map<long, int> index_;
  double z_ = 0;
  GmshMesh mesh_;
};

std::string_view GmshReader::row(const std::string& what) {
  while (const auto row = rows_.next())
    if (!row->empty()) return *row;
  refuse(what, "the end of the file");
}

GmshReader::Words GmshReader::words(const std::string& what, std::size_t least) {
  const std::string_view text = row(what);
  Words out;
  for (std::size_t from = 0; (from = text.find_first_not_of(" \t", from)) != std::string_view::npos;) {
    const std::size_t to = std::min(text.find_first_of(" \t", from), text.size());
    out.push_back(text.substr(from, to - from));
    from = to;
  }
  if (out.size() < least) refuse(what, quoted(text));
  return out;
}

long GmshReader::whole(std::string_view word, const char* what) const {
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) refuse(what, quoted(word));
  return value;
}

long GmshReader::count(std::string_view word, const char* what) const {
  const long value = whole(word, what);
  if (value < 0 || value > 10 * long(most_points)) refuse(what, quoted(word));
  return value;
}

double GmshReader::number(std::string_view word) const {
  if (const auto value = finite_number(word)) return *value;
  refuse("a finite number for a coordinate", quoted(word));
}

void GmshReader::read_format() {
  const Words format = words("the version, 0 for ASCII and the size of a number, as in \"4.1 0 8\"", 3);
  old_ = format[0].starts_with("2");
  if (!old_ && format[0] != "4.1")
    refuse("version 2.2 or 4.1",
           "version " + std::string(format[0]) + ": save it with gmsh -format msh22 or -format msh41");
  if (format[1] != "0") refuse("an ASCII mesh", "a binary one: save it without -bin, with Mesh.Binary = 0");
  end_section("MeshFormat");
}

void GmshReader::read_names() {
  const long names = count(words("how many physical names follow", 1)[0], "a count of physical names");
  for (long k = 0; k < names; ++k) {
    const std::string_view text = row("dimension, tag and \"name\"");
    const std::size_t open = text.find('"'), close = text.rfind('"');
    if (open == std::string_view::npos || close <= open) refuse("dimension, tag and \"name\"", quoted(text));
    const std::string_view numbers = trimmed(text.substr(0, open));
    const std::size_t space = numbers.find_first_of(" \t");
    if (space == std::string_view::npos) refuse("dimension, tag and \"name\"", quoted(text));
    names_[{int(whole(numbers.substr(0, space), "a dimension")), whole(trimmed(numbers.substr(space)), "a tag")}] =
        text.substr(open + 1, close - open - 1);
  }
  end_section("PhysicalNames");
}

// Which physical group each curve and surface belongs to.
void GmshReader::read_entities() {
  const Words counts = words("how many points, curves, surfaces and volumes follow", 4);
  for (int dimension = 0; dimension < 4; ++dimension) {
    const std::size_t before = dimension == 0 ? 4 : 7;  // tag and place, or tag and box
    const long entities = count(counts[dimension], "a count of entities");
    for (long k = 0; k < entities; ++k) {
      const Words entity = words("tag, place and physical tags of an entity", before + 1);
      const long groups = count(entity[before], "a count of physical tags");
      if (groups == 0) continue;
      if (entity.size() <= before + 1) refuse(std::to_string(groups) + " physical tags", "none");
      group_of_[{dimension, whole(entity[0], "a tag")}] = std::abs(whole(entity[before + 1], "a physical tag"));
    }
  }
  end_section("Entities");
}

void GmshReader::add_node(std::string_view tag, const Words& place, std::size_t first) {
  const double z = number(place[first + 2]);
  if (mesh_.points.empty()) z_ = z;
  if (z != z_)
    refuse("a mesh in a plane z = const", "nodes at z = " + std::to_string(z_) + " and z = " + std::to_string(z));
  if (mesh_.points.size() >= most_points) refuse("at most 1000000 nodes", "more");
  if (!index_.emplace(whole(tag, "a node's tag"), int(mesh_.points.size())).second)
    refuse("each node once", "node " + std::string(tag) + " again");
  mesh_.points.push_back({number(place[first]), number(place[first + 1])});
}

void GmshReader::read_nodes() {
  const Words head = words("how many nodes follow", old_ ? 1 : 4);
  const long blocks = count(head[0], "a count of nodes");
  for (long block = 0; block < blocks; ++block) {
    if (old_) {
      const Words node = words("a node's tag, x, y and z", 4);
      add_node(node[0], node, 1);
      continue;
    }
    const long nodes = count(words("dimension, tag, 0 and count of a block of nodes", 4)[3], "a count of nodes");
    std::vector<std::string> tags;
    for (long k = 0; k < nodes; ++k) tags.emplace_back(words("a node's tag", 1)[0]);
    for (const std::string& tag : tags) add_node(tag, words("x, y and z of a node", 3), 0);
  }
  end_section("Nodes");
}

ElementKind GmshReader::kind_of(long type) const {
  switch (type) {
    case 1:
      return {2, 2, false};
    case 2:
      return {3, 3, false};
    case 3:
      return {4, 4, false};
    case 8:
      return {3, 2, true};
    case 9:
      return {6, 3, true};
    case 10:
      return {9, 4, true};
    case 15:
      return {1, 1, false};
    case 16:
      return {8, 4, true};
    default:
      refuse("points, lines, triangles and quadrangles",
             "an element of type " + std::to_string(type) +
                 (type >= 4 && type <= 7 ? " (a solid: mesh in two dimensions, gmsh -2)" : ""));
  }
}

int GmshReader::point(std::string_view word) const {
  const auto found = index_.find(whole(word, "a node's tag"));
  if (found == index_.end())
    refuse("a node of the section $Nodes, which comes before $Elements", "node " + std::string(word));
  return found->second;
}

std::string GmshReader::name_of(int dimension, long group) const {
  if (group == 0) return "";
  const auto found = names_.find({dimension, group});
  return found == names_.end() ? "group " + std::to_string(group) : found->second;
}

void GmshReader::add_element(long type, long group, const Words& nodes, std::size_t first) {
  const ElementKind kind = kind_of(type);
  if (nodes.size() < first + std::size_t(kind.nodes))
    refuse(std::to_string(kind.nodes) + " nodes of an element of type " + std::to_string(type),
           std::to_string(nodes.size() - first));
  std::vector<int> cell;
  for (int k = 0; k < kind.corners; ++k) cell.push_back(point(nodes[first + std::size_t(k)]));
  mesh_.curved += kind.curved && kind.corners > 2;
  if (kind.corners == 2 && group != 0) mesh_.curves[name_of(1, group)].lines.push_back({cell[0], cell[1]});
  if (kind.corners < 3) return;
  double twice = 0;
  const Vec2& first_corner = mesh_.points[cell[0]];  // differences keep their digits far from the origin
  for (std::size_t k = 1; k + 1 < cell.size(); ++k)
    twice += cross(mesh_.points[cell[k]] - first_corner, mesh_.points[cell[k + 1]] - first_corner);
  if (twice == 0) refuse("an element with an area", "one without");
  if (twice < 0) std::reverse(cell.begin(), cell.end());
  mesh_.surfaces[name_of(2, group)].cells.push_back(std::move(cell));
}

void GmshReader::read_elements() {
  const Words head = words("how many elements follow", old_ ? 1 : 4);
  const long blocks = count(head[0], "a count of elements");
  for (long block = 0; block < blocks; ++block) {
    if (old_) {
      const Words element = words("an element's tag, type, count of tags, tags and nodes", 4);
      const long tags = count(element[2], "a count of tags");
      if (element.size() < std::size_t(3 + tags))
        refuse(std::to_string(tags) + " tags", std::to_string(element.size() - 3));
      add_element(whole(element[1], "a type"), tags > 0 ? whole(element[3], "a physical tag") : 0, element,
                  std::size_t(3 + tags));
      continue;
    }
    const Words entity = words("dimension, tag, type and count of a block of elements", 4);
    const auto group = group_of_.find({int(whole(entity[0], "a dimension")), whole(entity[1], "a tag")});
    const long type = whole(entity[2], "a type"), elements = count(entity[3], "a count of elements");
    for (long k = 0; k < elements; ++k)
      add_element(type, group == group_of_.end() ? 0 : group->second, words("an element's tag and nodes", 2), 1);
  }
  end_section("Elements");
}

void GmshReader::end_section(const std::string& name) {
  const std::string_view end = row("$End" + name);
  if (end != "$End" + name) refuse("$End" + name, quoted(end));
}

void GmshReader::skip_section(const std::string& name) {
  while (row("$End" + name) != "$End" + name) {
  }
}

GmshMesh GmshReader::read() {
  bool first = true;
  while (const auto text = rows_.next()) {
    if (text->find('\0') != std::string_view::npos)
      refuse("an ASCII mesh", "a binary file: save it without -bin, with Mesh.Binary = 0");
    if (text->empty()) continue;
    if (first && *text != "$MeshFormat") refuse("a .msh file of Gmsh, which begins with $MeshFormat", quoted(*text));
    first = false;
    if (!text->starts_with('$')) refuse("the name of a section, as $Nodes", quoted(*text));
    const std::string name(text->substr(1));
    if (name == "MeshFormat")
      read_format();
    else if (name == "PhysicalNames")
      read_names();
    else if (name == "Entities" && !old_)
      read_entities();
    else if (name == "Nodes")
      read_nodes();
    else if (name == "Elements")
      read_elements();
    else
      skip_section(name);
  }
  if (first) refuse("a .msh file of Gmsh, which begins with $MeshFormat", "an empty file");
  if (mesh_.surfaces.empty())
    refuse("triangles or quadrangles",
           "none: mesh in two dimensions (gmsh -2); with physical groups only those are saved");
  return std::move(mesh_);
}

}  // namespace

GmshMesh read_gmsh(const std::string& text, const std::string& file) {
  return GmshReader(text, file).read();
}

std::vector<std::array<Vec2, 2>> straight_runs(const GmshMesh& mesh, const std::vector<std::array<int, 2>>& lines) {
  constexpr double straight_sine = 1e-9;
  std::vector<std::array<Vec2, 2>> runs;
  std::vector<std::array<int, 2>> ends;  // of the runs
  for (const std::array<int, 2>& line : lines) {
    const Vec2 p = mesh.points[line[0]], q = mesh.points[line[1]];
    bool joined = false;
    for (std::size_t r = runs.size(); r-- > 0 && !joined;) {
      const Vec2 along = runs[r][1] - runs[r][0];
      if (std::abs(cross(along, q - p)) > straight_sine * along.norm() * (q - p).norm() || along.dot(q - p) < 0)
        continue;
      if (ends[r][1] == line[0])
        runs[r][1] = q, ends[r][1] = line[1], joined = true;
      else if (ends[r][0] == line[1])
        runs[r][0] = p, ends[r][0] = line[0], joined = true;
    }
    if (joined) continue;
    runs.push_back({p, q});
    ends.push_back(line);
  }
  return runs;
}

}  // namespace talus
