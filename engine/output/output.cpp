#include "output/output.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include "output/curves.h"
#include "output/files.h"
#include "output/history.h"
#include "output/paraview.h"
#include "output/picture_field.h"
#include "output/pvd.h"
#include "output/report.h"
#include "output/report_page.h"
#include "output/user_arrays.h"
#include "output/vtk_writer.h"
#include "step/clock.h"
#include "step/part_timer.h"

namespace talus {

struct RunOutput::Parts {
  std::string dir, command_line;
  std::vector<RunAccount::Restore> restores;
  double started = wall_seconds();
  // By the clock of files, which lags behind by some milliseconds.
  std::filesystem::file_time_type began =
      std::filesystem::file_time_type::clock::now() - std::chrono::milliseconds(100);
  std::optional<PvdSeries> blocks, joints, cracks;
  std::optional<HistoryTable> history;
  Curves curves;
  int frames = 0;
  long frame_step = -1, row_step = -1;  // step of the last frame and of the last row of the history
  double next = 0;                      // s, output time that is due next
  double residual = 0;                  // largest since the last row

  void add_row(Simulation& simulation, const std::vector<UserArray>& arrays);
  void write_frame(Simulation& simulation);
  void write_report(Simulation& simulation, const RunAccount& account);
  void visit_state(StateVisitor& visitor);
};

void RunOutput::Parts::add_row(Simulation& simulation, const std::vector<UserArray>& arrays) {
  if (row_step == simulation.totals.steps) return;
  history->add(simulation, residual, arrays);
  row_step = simulation.totals.steps;
  residual = 0;
}

void RunOutput::Parts::write_frame(Simulation& simulation) {
  if (frame_step == simulation.totals.steps) return;
  const Model& model = simulation.model;
  const Output& output = model.scene.output;
  const std::vector<UserArray> arrays = user_arrays(model);
  FieldContext context = {model, simulation.recovery()};
  std::vector<Vec3> smoothed;  // the dearest part of a frame: once for all that is written
  if (blocks && context.recovery) context.smoothed = &(smoothed = smoothed_stresses(context));
  if (blocks) {
    const std::string name = frame_name("blocks", frames, ".vtp");
    write_blocks_vtp(dir + "/" + name, context, arrays);
    blocks->add(model.time, name);
  }
  if (joints) {
    const std::string name = frame_name("joints", frames, ".vtp");
    write_joints_vtp(dir + "/" + name, model);
    joints->add(model.time, name);
  }
  if (cracks) {
    const std::string name = frame_name("cracks", frames, ".vtp");
    write_cracks_vtp(dir + "/" + name, model, simulation.gas());
    cracks->add(model.time, name);
  }
  if (output.picture) {
    const std::string svg = draw_picture(context, {.field = output.picture_field, .scale = output.picture_scale});
    write_whole(dir + "/" + frame_name("picture", frames, ".svg"), svg);
  }
  add_row(simulation, arrays);
  ++frames;
  frame_step = simulation.totals.steps;
  if (output.on_frame) output.on_frame();
}

void RunOutput::Parts::write_report(Simulation& simulation, const RunAccount& account) {
  const Model& model = simulation.model;
  std::string state;
  try {
    state = draw_picture({model, simulation.recovery()},
                         {.field = model.scene.output.picture_field, .scale = model.scene.output.picture_scale});
  } catch (const std::exception&) {  // the law of the script that ended the run fails here again: it has been said
  }
  write_whole(dir + "/report.html", report_page(simulation, account, report_pictures(dir, model, state, began)));
}

namespace {

// CPU seconds spent in a scope, booked as the run's part "output"; the recovery keeps its own account.
class Booked {
 public:
  explicit Booked(RunTotals& totals) : totals_(totals), started_(own_seconds()) {}
  ~Booked() { totals_.seconds("output") += own_seconds() - started_; }

 private:
  double own_seconds() const {
    double seconds = cpu_seconds();
    for (const RunTotals::Part& part : totals_.parts)
      if (part.name == "stress recovery") seconds -= part.seconds;
    return seconds;
  }
  RunTotals& totals_;
  double started_;
};

}  // namespace

RunOutput::RunOutput(Simulation& simulation, const std::string& command_line, bool resumed) {
  const Scene& scene = simulation.model.scene;
  if (scene.output.dir.empty()) return;
  if (scene.output.picture) check_picture_field(scene, scene.output.picture_field);
  prepare_directory(scene.output, resumed);
  parts_ = std::make_unique<Parts>();
  parts_->dir = scene.output.dir;
  parts_->command_line = command_line;
  parts_->curves.begin(simulation);
  parts_->history.emplace(parts_->dir + "/history.csv", simulation.model, simulation.plan, resumed);
  if (!scene.output.vtk) return;
  write_whole(parts_->dir + "/paraview.py", paraview_state(scene.output));
  parts_->blocks.emplace(parts_->dir, "blocks");
  if (simulation.plan.bonds || simulation.plan.contacts) parts_->joints.emplace(parts_->dir, "joints");
  if (simulation.plan.fracture || simulation.plan.gas) parts_->cracks.emplace(parts_->dir, "cracks");
  if (!resumed) return;
  for (std::optional<PvdSeries>* series : {&parts_->blocks, &parts_->joints, &parts_->cracks})
    if (*series) (*series)->read_back();
}

void RunOutput::Parts::visit_state(StateVisitor& visitor) {
  visitor("frames", frames);
  visitor("frame_step", frame_step);
  visitor("row_step", row_step);
  visitor("next", next);
  visitor("residual", residual);
  visitor("curves", curves);
}

void RunOutput::visit_state(StateVisitor& visitor) {
  Parts none;
  (parts_ ? *parts_ : none).visit_state(visitor);
}

std::uint64_t RunOutput::layout() {
  Parts none;
  LayoutHasher hasher;
  none.visit_state(hasher);
  return hasher.value();
}

namespace {

// A step that ends at 0.3 may find itself at 0.29999999999999999: s, part of the interval that is as good as its end.
double slack(double every) {
  return 1e-9 * every;
}
double next_output(double every, double time) {
  return every > 0 ? every * (std::floor((time + slack(every)) / every) + 1) : 0;
}

}  // namespace

void RunOutput::rewind(const Simulation& simulation, const std::string& from) {
  if (!parts_) return;
  parts_->history->rewind(parts_->row_step);
  for (std::optional<PvdSeries>* series : {&parts_->blocks, &parts_->joints, &parts_->cracks})
    if (*series) (*series)->rewind(parts_->frames);
  // a state may have been saved with another interval
  parts_->next = next_output(simulation.model.scene.output.every, simulation.model.time);
  parts_->restores.push_back({from, simulation.totals.steps, simulation.model.time});
}

RunOutput::~RunOutput() = default;

void RunOutput::after_step(Simulation& simulation) {
  if (!parts_) return;
  const Booked booked(simulation.totals);
  const Scene& scene = simulation.model.scene;
  const double every = scene.output.every, time = simulation.model.time;
  const bool first = parts_->frame_step < 0;
  if (!first) parts_->residual = std::max(parts_->residual, simulation.last.residual);
  if (scene.output.picture) parts_->curves.after_step(simulation);
  if (first || (every > 0 && time >= parts_->next - slack(every))) {
    // First, because the script may save the state when the frame is written.
    parts_->next = next_output(every, time);
    parts_->write_frame(simulation);
  } else if (scene.time.mode == Mode::static_) {
    parts_->add_row(simulation, user_arrays(simulation.model));
  }
}

void RunOutput::frame(Simulation& simulation) {
  if (!parts_) return;
  const Booked booked(simulation.totals);
  parts_->write_frame(simulation);
}

void RunOutput::finish(Simulation& simulation, const std::string& outcome, const std::vector<CheckLine>& checks,
                       const std::vector<ResultLine>& results) {
  if (!parts_) return;
  {
    const Booked booked(simulation.totals);
    parts_->write_frame(simulation);
    if (simulation.model.scene.output.picture) parts_->curves.write(simulation, parts_->dir);
  }
  std::vector<ErrorNorm> errors;
  if (const Recovery* recovery = simulation.model.scene.output.error ? simulation.recovery() : nullptr)
    errors = error_of_regions(simulation.model, *recovery);
  const RunAccount account = {.command_line = parts_->command_line,
                              .outcome = outcome,
                              .wall_seconds = wall_seconds() - parts_->started,
                              .cpu_seconds = cpu_seconds(),
                              .checks = checks,
                              .restores = parts_->restores,
                              .results = results,
                              .errors = errors};
  write_whole(parts_->dir + "/run.json", run_report(simulation, account));
  parts_->write_report(simulation, account);
}

}  // namespace talus
