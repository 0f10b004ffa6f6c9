#pragma once
// Everything a run writes: <dir>/blocks.pvd and joints.pvd with a .vtp each per output time, history.csv,
// picture_<n>.svg, energy.svg, run.json, report.html. Files are written whole under a temporary name and renamed, so a
// reader never sees half of one.
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "model/fields.h"
#include "output/report.h"
#include "step/simulation.h"

namespace talus {

// Creates the directory. Throws InputError when it cannot be written.
class RunOutput {
 public:
  // `resumed`: results that lie there are continued, not removed.
  RunOutput(Simulation& simulation, const std::string& command_line, bool resumed = false);
  ~RunOutput();

  void after_step(Simulation& simulation);  // writes what is due at model.time; also called before the first step
  void frame(Simulation& simulation);       // one output time now (sim:output())
  // How far the results have come; part of a saved state (the registry, model/registry.h).
  void visit_state(StateVisitor& visitor);
  static std::uint64_t layout();  // which tables that writes
  // A state was restored from `from`: results of later steps leave history.csv and the series, which then tell one
  // course from the start to now.
  void rewind(const Simulation& simulation, const std::string& from);
  // Last frame, run.json with `outcome` ("finished", "stopped", or the error's text), checks and results.
  void finish(Simulation& simulation, const std::string& outcome, const std::vector<CheckLine>& checks,
              const std::vector<ResultLine>& results = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// One picture of the blocks coloured by a field of block_fields(), with a colour bar, as an SVG file.
struct PictureOptions {
  std::string field = "s1";
  double scale = 0;  // displacement magnification; 0: 1
  int width = 1200;  // px
  bool edges = true;
};
std::string draw_picture(const FieldContext& context, const PictureOptions& options);

// A line of progress on a terminal (rewritten in place), plain lines every few seconds otherwise.
class Progress {
 public:
  explicit Progress(bool terminal);
  void after_step(const Simulation& simulation);
  void done(const Simulation& simulation, bool ended);  // as it was asked to, or by something else

 private:
  bool terminal_;
  double started_, last_ = 0;
  // wall s since it started, and s of the scene, as the first step ended
  double first_ = std::numeric_limits<double>::quiet_NaN(), first_time_ = 0;
};

// Writes `content` to `path` under a temporary name, then renames. Throws RunError naming path and reason.
void write_whole(const std::string& path, const std::string& content);

}  // namespace talus
