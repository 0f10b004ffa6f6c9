#include "output/svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "output/text.h"

namespace talus {

namespace {

constexpr std::string_view font = "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif";

std::string_view anchor(Align align) {
  return align == Align::start ? "" : align == Align::middle ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
}

// `text` with its subscripts as <tspan>s.
std::string marked_up(std::string_view text, double size) {
  std::string out;
  while (true) {
    const auto mark = text.find('_');
    out += escape_xml(text.substr(0, mark));
    if (mark == std::string_view::npos) return out;
    text.remove_prefix(mark + 1);
    const auto end = std::min(text.find_first_of(" /"), text.size());
    const std::string drop = px(size * 0.25);
    out += "<tspan dy=\"" + drop + "\" font-size=\"" + px(size * 0.75) + "\">" + escape_xml(text.substr(0, end)) +
           "</tspan>";
    text.remove_prefix(end);
    if (text.empty()) return out;
    // Back up to the line. A space at the edge of a <tspan> is swallowed: moved over instead.
    const bool space = text[0] == ' ';
    if (space) text.remove_prefix(1);
    out += "<tspan dy=\"-" + drop + "\"" + (space ? " dx=\"" + px(size * 0.3) + "\"" : "") + ">" +
           escape_xml(text.substr(0, 1)) + "</tspan>";
    text.remove_prefix(std::min<std::size_t>(1, text.size()));
  }
}

std::string point(const Vec2& p) {
  return px(p.x()) + "," + px(p.y());
}

}  // namespace

std::string px(double value) {
  std::string text = fixed(value, 1);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

void Svg::text(const Vec2& at, std::string_view text, const TextStyle& style) {
  body_ += "<text x=\"" + px(at.x()) + "\" y=\"" + px(at.y()) + "\" font-size=\"" + px(style.size) + "\"";
  body_ += anchor(style.align);
  if (style.bold) body_ += " font-weight=\"bold\"";
  if (style.upright) body_ += " transform=\"rotate(-90 " + px(at.x()) + " " + px(at.y()) + ")\"";
  if (style.colour != TextStyle{}.colour) body_ += " fill=\"" + std::string(style.colour) + "\"";
  body_ += ">" + (style.subscripts ? marked_up(text, style.size) : escape_xml(text)) + "</text>\n";
}

void Svg::line(const Vec2& from, const Vec2& to, std::string_view attributes) {
  body_ += "<path d=\"M" + point(from) + "L" + point(to) + "\" " + std::string(attributes) + "/>\n";
}

void Svg::polyline(std::span<const Vec2> points, bool closed, std::string_view attributes) {
  body_ += "<path d=\"";
  for (std::size_t i = 0; i < points.size(); ++i) body_ += (i == 0 ? "M" : " ") + point(points[i]);
  body_ += std::string(closed ? "z" : "") + "\" " + std::string(attributes) + "/>\n";
}

void Svg::rectangle(const Vec2& corner, const Vec2& size, std::string_view attributes) {
  body_ += "<rect x=\"" + px(corner.x()) + "\" y=\"" + px(corner.y()) + "\" width=\"" + px(size.x()) + "\" height=\"" +
           px(size.y()) + "\" " + std::string(attributes) + "/>\n";
}

void Svg::circle(const Vec2& centre, double radius, std::string_view attributes) {
  body_ += "<circle cx=\"" + px(centre.x()) + "\" cy=\"" + px(centre.y()) + "\" r=\"" + px(radius) + "\" " +
           std::string(attributes) + "/>\n";
}

std::string Svg::file(double width, double height) const {
  const std::string w = px(std::ceil(width)), h = px(std::ceil(height));
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " +
         h + "\" font-family=\"" + std::string(font) + "\" fill=\"" + std::string(TextStyle{}.colour) +
         "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + body_ + "</svg>\n";
}

void Path::append(long value, bool separate) {
  std::array<char, 24> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  if (separate && value >= 0) data_ += ' ';
  data_.append(buffer.data(), end);
}

void Path::add(std::span<const Vec2> points, bool closed) {
  long x = 0, y = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const long to_x = std::lround(points[i].x() * 10), to_y = std::lround(points[i].y() * 10);
    if (i == 0) data_ += 'M';
    if (i == 1) data_ += 'l';
    append(to_x - x, i > 1);
    append(to_y - y, true);
    x = to_x;
    y = to_y;
  }
  if (closed) data_ += 'z';
}

}  // namespace talus
