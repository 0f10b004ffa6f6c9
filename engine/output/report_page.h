#pragma once
// report.html: a run on one page that needs nothing else.
#include <filesystem>
#include <string>
#include <vector>

#include "output/report.h"

namespace talus {

struct ReportPicture {
  std::string caption, svg;
};

std::string report_page(const Simulation& simulation, const RunAccount& account,
                        const std::vector<ReportPicture>& pictures);

// What the report shows: `state`, the picture of the last state, where there is one; plots that the run wrote into its
// folder, its own and those of the script; and of probes, where history.csv has enough rows, their columns over time.
// `began`: the run's start.
std::vector<ReportPicture> report_pictures(const std::string& dir, const Model& model, const std::string& state,
                                           std::filesystem::file_time_type began);

}  // namespace talus
