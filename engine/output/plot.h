#pragma once
// A line plot as SVG: histories of a run, energies, convergence.
#include <string>
#include <vector>

namespace talus {

struct Series {
  std::string name = {};               // for the legend; empty: not in it
  std::vector<double> x = {}, y = {};  // in the plot's units; a value that is not finite interrupts the line
  bool markers = false, dashed = false, line = true;
};

struct Plot {
  std::string title = {};
  std::string x_label = "t", x_unit = "s";  // "_" begins a subscript
  std::string y_label = {}, y_unit = {};
  std::vector<Series> series = {};
  bool log_x = false, log_y = false;  // values that are not positive are left out
  bool equal = false;                 // one scale for x and y: a section, not a curve
  int width = 800, height = 500;      // px; height: at most, where the scales are equal
};

std::string draw_plot(const Plot& plot);

}  // namespace talus
