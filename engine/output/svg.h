#pragma once
// An SVG file under construction. Coordinates in px, y down, written with one decimal.
#include <span>
#include <string>
#include <string_view>

#include "geometry/vec2.h"

namespace talus {

enum class Align { start, middle, end };

struct TextStyle {
  double size = 13;
  Align align = Align::start;
  bool bold = false;
  bool upright = false;     // read from below, turned by 90°
  bool subscripts = false;  // "_" begins one that lasts to the next space or "/"
  std::string_view colour = "#222";
};

class Svg {
 public:
  void text(const Vec2& at, std::string_view text, const TextStyle& style = {});
  void line(const Vec2& from, const Vec2& to, std::string_view attributes);
  void polyline(std::span<const Vec2> points, bool closed, std::string_view attributes);
  void rectangle(const Vec2& corner, const Vec2& size, std::string_view attributes);
  void circle(const Vec2& centre, double radius, std::string_view attributes);
  void raw(std::string_view xml) { body_ += xml; }

  std::string file(double width, double height) const;

 private:
  std::string body_;
};

// Outlines as one path, in tenths of a px and relative, so that it stays short: for <g transform="scale(.1)">.
class Path {
 public:
  void add(std::span<const Vec2> points, bool closed);
  const std::string& data() const { return data_; }

 private:
  void append(long value, bool separate);
  std::string data_;
};

std::string px(double value);  // "12.5", "12"

}  // namespace talus
