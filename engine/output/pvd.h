#pragma once
// A ParaView collection: which file shows which time. Rewritten whole at each frame, so that a running series
// can be opened.
#include <string>
#include <utility>
#include <vector>

namespace talus {

// Times and files of a collection that Talus wrote; none where there is no such file.
std::vector<std::pair<double, std::string>> read_pvd(const std::string& path);

class PvdSeries {
 public:
  PvdSeries(std::string dir, std::string name) : dir_(std::move(dir)), name_(std::move(name)) {}
  // Takes up <dir>/<file>, which must be there already, and rewrites <dir>/<name>.pvd.
  void add(double time, const std::string& file);
  // Continues the series that lies there.
  void read_back();
  // Leaves out frames from number `frames` on; their files stay until new ones take their places.
  void rewind(int frames);

 private:
  void write() const;
  std::string dir_, name_;
  std::vector<std::pair<double, std::string>> frames_;
};

}  // namespace talus
