#pragma once
// Lines read from a file of a survey or a drawing program. One message for what is wrong with it: file, line of
// the file, what was expected, what was given.
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/vec2.h"

namespace talus {

struct DrawnLine {
  std::string layer;  // DXF: its layer; CSV: the name of the trace
  Polyline points;    // units of the file; no point twice in a row
  bool closed = false;
  int line = 0;  // of the file, where it begins
};

struct Drawing {
  std::vector<DrawnLine> lines;
  std::map<std::string, long> skipped;  // DXF entities that are no lines, by kind
  double unit = 1;                      // m, of one unit of the file, as it says
  std::string unit_name;                // empty where the file says none
};

class FileError : public std::runtime_error {
 public:
  FileError(const std::string& file, int line, const std::string& expected, const std::string& given)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": expected " + expected + ", got " +
                           given) {}
};

// The text of a regular file; `shown` is how messages call it.
std::string read_text(const std::string& path, const std::string& shown);

// Columns by a header: trace, x, y with one point a row, rows of a trace following each other; or x1, y1, x2, y2
// with one straight trace a row, and trace for its name if given. Other columns are not read. Separated by commas,
// semicolons or tabs; lines that are empty or begin with # are skipped.
Drawing read_csv(const std::string& text, const std::string& file);

// ASCII DXF: LINE, LWPOLYLINE and POLYLINE with bulges, ARC, CIRCLE, in the plane z = const. Arcs become chords
// whose sagitta is at most `chord` of the radius. $INSUNITS tells the unit.
Drawing read_dxf(const std::string& text, const std::string& file, double chord);

}  // namespace talus
