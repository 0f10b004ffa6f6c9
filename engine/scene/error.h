#pragma once
#include <stdexcept>
#include <string>

namespace talus {

// Where in the user's script a thing was written: "examples/02.lua:12". Empty where no script is involved.
struct Place {
  std::string file;
  int line = 0;
  std::string text() const { return file.empty() ? "" : file + ":" + std::to_string(line); }
};

// Input the engine cannot work with. One message: place, field, what was expected, what was given.
class InputError : public std::runtime_error {
 public:
  InputError(const Place& place, const std::string& field, const std::string& expected, const std::string& given)
      : std::runtime_error((place.file.empty() ? "" : place.text() + ": ") + field + ": expected " + expected +
                           ", got " + given) {}
};

// The run cannot go on (no equilibrium, no convergence at the least time step, a law that fails on the way).
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace talus
