#include "output/pvd.h"

#include "output/files.h"
#include "output/text.h"

namespace talus {

void PvdSeries::add(double time, const std::string& file) {
  frames_.emplace_back(time, file);
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const auto& [at, name] : frames_)
    xml += "<DataSet timestep=\"" + shortest(at) + "\" part=\"0\" file=\"" + escape_xml(name) + "\"/>\n";
  write_whole(dir_ + "/" + name_ + ".pvd", xml + "</Collection>\n</VTKFile>\n");
}

}  // namespace talus
