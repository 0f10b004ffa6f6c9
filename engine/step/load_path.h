#pragma once
// The way of the loads and supports of a static run: in time, and where they jump straight from what they were to what
// they become, which no part of the time resolves.
#include <optional>
#include <string>
#include <utility>

#include "model/model.h"

namespace talus {

class LoadPath {  // a part of a load step
 public:
  using Interval = std::pair<double, double>;  // s

  // From where the model's loads are: to the time `to` at most, or to the end of the jump that they are in. `unloaded`:
  // what is there from the start comes with it, and where it is cut, by a jump before it.
  LoadPath(Model& model, double to, bool unloaded = false);

  // Put the model where this part ends, with the loads of begins_at() still those that it begins with, or with those
  // that it ends with.
  void begin() const;
  void end() const;
  double begins_at() const { return jumps_ ? until_ : from_; }  // s

  bool jumps() const { return jumps_; }
  bool meets_jump() const;                                                             // on its way in time
  double from() const { return from_; }                                                // s
  double reached() const { return jumps_ ? from_ + go_ * (until_ - from_) : until_; }  // s
  double length() const { return jumps_ ? go_ - come_ : until_ - from_; }              // s, or part of a jump
  double whole() const { return jumps_ ? 1 : model_.scene.time.t_end; }  // likewise, of the run or the jump
  bool complete(double to) const { return until_ == to && go_ == 1; }
  bool from_nothing() const { return unloaded_ || from_ == LoadWay::nothing; }
  bool ends_jump() const { return jumps_ && go_ == 1; }
  double least() const { return least_part * whole(); }  // likewise, of a part
  bool is_shortest() const { return length() <= least() * (1 + 1e-9) && !meets_jump(); }

  void stop_at(double length);  // ends there, if it does not before
  double off_rate = 0;          // J/m that its last attempt left over its length

  // Takes `part` of the way, but least() at least; to where loads begin to jump, if they do on it; first all of what is
  // there from the start.
  void cut(double part);

 private:
  static constexpr double least_part = 1e-6;  // of t_end, or of a jump of loads

  std::optional<Interval> next_jump() const;

  Model& model_;
  bool unloaded_, jumps_;
  double from_, until_;   // s
  double come_, go_ = 1;  // parts of the jump
};

std::string load_text(const Model& model);  // where on it the loads are: "t = 0.5 s", and how far into a jump

}  // namespace talus
