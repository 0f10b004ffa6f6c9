#include <algorithm>
#include <array>
#include <cctype>
#include <unordered_set>

#include "input/drawing.h"
#include "input/text_rows.h"

namespace talus {
namespace {

constexpr const char* columns_text = "a header with the columns trace,x,y or x1,y1,x2,y2";

class CsvReader {
 public:
  CsvReader(const std::string& text, const std::string& file) : rows_(text), file_(file) {}
  Drawing read();

 private:
  using Cells = std::vector<std::string_view>;

  [[noreturn]] void refuse(const std::string& expected, const std::string& given) const {
    throw FileError(file_, rows_.line(), expected, given);
  }
  std::optional<std::string_view> next_row();
  Cells split(std::string_view row) const;
  void read_header(std::string_view row);
  int column(const Cells& header, const char* name) const;
  double number(const Cells& cells, int column, const char* name) const;
  void add_point(const std::string& trace, const Vec2& point);
  void end_trace() const;

  TextRows rows_;
  const std::string& file_;
  char separator_ = ',';
  std::size_t width_ = 0;
  int trace_ = -1;
  std::array<int, 4> place_{-1, -1, -1, -1};  // columns of x, y or of x1, y1, x2, y2
  bool segments_ = false;
  std::size_t points_ = 0;
  std::unordered_set<std::string> names_;
  Drawing drawing_;
};

std::optional<std::string_view> CsvReader::next_row() {
  while (auto row = rows_.next()) {
    if (rows_.line() == 1 && row->starts_with("\xef\xbb\xbf")) row->remove_prefix(3);  // the mark of UTF-8
    if (row->find('\0') != std::string_view::npos) refuse("text", "a binary file");
    if (!row->empty() && !row->starts_with('#')) return row;
  }
  return std::nullopt;
}

CsvReader::Cells CsvReader::split(std::string_view row) const {
  Cells cells;
  for (std::size_t from = 0;;) {
    const std::size_t to = row.find(separator_, from);
    std::string_view cell = trimmed(row.substr(from, to - from));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    cells.push_back(cell);
    if (to == std::string_view::npos) return cells;
    from = to + 1;
  }
}

int CsvReader::column(const Cells& header, const char* name) const {
  const auto same = [name](std::string_view cell) {
    return std::equal(cell.begin(), cell.end(), name, name + std::char_traits<char>::length(name),
                      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
  };
  const auto found = std::find_if(header.begin(), header.end(), same);
  if (found == header.end()) return -1;
  if (std::find_if(found + 1, header.end(), same) != header.end()) refuse(std::string("one column ") + name, "two");
  return static_cast<int>(found - header.begin());
}

void CsvReader::read_header(std::string_view row) {
  for (char separator : {',', ';', '\t'}) {
    separator_ = separator;
    const Cells header = split(row);
    width_ = header.size();
    trace_ = column(header, "trace");
    place_ = {column(header, "x1"), column(header, "y1"), column(header, "x2"), column(header, "y2")};
    segments_ = std::all_of(place_.begin(), place_.end(), [](int c) { return c >= 0; });
    if (segments_) return;
    place_ = {column(header, "x"), column(header, "y"), -1, -1};
    if (trace_ >= 0 && place_[0] >= 0 && place_[1] >= 0) return;
  }
  refuse(columns_text, quoted(row));
}

double CsvReader::number(const Cells& cells, int column, const char* name) const {
  const std::string_view cell = cells[static_cast<std::size_t>(column)];
  if (const auto value = finite_number(cell)) return *value;
  refuse(std::string("a finite number for ") + name + ", with a decimal point", quoted(cell));
}

void CsvReader::end_trace() const {
  if (!drawing_.lines.empty() && drawing_.lines.back().points.size() < 2)
    throw FileError(file_, drawing_.lines.back().line,
                    "two or more different points of trace " + quoted(drawing_.lines.back().layer), "one");
}

void CsvReader::add_point(const std::string& trace, const Vec2& point) {
  if (++points_ > most_points) refuse("at most 1000000 points", "more");
  if (drawing_.lines.empty() || drawing_.lines.back().layer != trace) {
    end_trace();
    if (!names_.insert(trace).second)
      refuse("the rows of a trace to follow each other", "trace " + quoted(trace) + " again");
    drawing_.lines.push_back({trace, {}, false, rows_.line()});
  }
  Polyline& line = drawing_.lines.back().points;
  if (line.empty() || line.back() != point) line.push_back(point);
}

Drawing CsvReader::read() {
  const auto header = next_row();
  if (!header) refuse(columns_text, "an empty file");
  read_header(*header);
  while (const auto row = next_row()) {
    const Cells cells = split(*row);
    if (cells.size() != width_)
      refuse(std::to_string(width_) + " columns as in the header, and decimal points, not commas",
             std::to_string(cells.size()));
    const std::string name(trace_ < 0 ? "" : cells[static_cast<std::size_t>(trace_)]);
    if (!segments_) {
      add_point(name, {number(cells, place_[0], "x"), number(cells, place_[1], "y")});
      continue;
    }
    const Vec2 a(number(cells, place_[0], "x1"), number(cells, place_[1], "y1"));
    const Vec2 b(number(cells, place_[2], "x2"), number(cells, place_[3], "y2"));
    if (a == b) refuse("two different points", "the same twice");
    if ((points_ += 2) > most_points) refuse("at most 1000000 points", "more");
    drawing_.lines.push_back({name, {a, b}, false, rows_.line()});
  }
  if (!segments_) end_trace();
  if (drawing_.lines.empty()) refuse("rows with points below the header", "none");
  return std::move(drawing_);
}

}  // namespace

Drawing read_csv(const std::string& text, const std::string& file) {
  return CsvReader(text, file).read();
}

}  // namespace talus
