#include "output/pvd.h"

#include <charconv>
#include <fstream>

#include "output/files.h"
#include "output/text.h"

namespace talus {

void PvdSeries::add(double time, const std::string& file) {
  frames_.emplace_back(time, file);
  write();
}

std::vector<std::pair<double, std::string>> read_pvd(const std::string& path) {
  std::vector<std::pair<double, std::string>> frames;
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    const auto value_of = [&](const std::string& attribute) {
      const std::size_t begin = line.find(attribute + "=\"");
      if (begin == std::string::npos) return std::string();
      const std::size_t from = begin + attribute.size() + 2;
      return line.substr(from, line.find('"', from) - from);
    };
    const std::string time = value_of("timestep"), name = value_of("file");
    double at = 0;
    if (std::from_chars(time.data(), time.data() + time.size(), at).ec == std::errc() && frame_number(name) >= 0)
      frames.emplace_back(at, name);
  }
  return frames;
}

void PvdSeries::read_back() {
  frames_ = read_pvd(dir_ + "/" + name_ + ".pvd");
}

void PvdSeries::rewind(int frames) {
  if (std::erase_if(frames_, [&](const auto& frame) { return frame_number(frame.second) >= frames; }) > 0) write();
}

void PvdSeries::write() const {
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const auto& [at, name] : frames_)
    xml += "<DataSet timestep=\"" + shortest(at) + "\" part=\"0\" file=\"" + escape_xml(name) + "\"/>\n";
  write_whole(dir_ + "/" + name_ + ".pvd", xml + "</Collection>\n</VTKFile>\n");
}

}  // namespace talus
