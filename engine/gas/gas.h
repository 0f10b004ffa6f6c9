#pragma once
// Explosion gas: chambers that grow from their holes into the cracks, press on what they have reached, and go off,
// merge and vent.
//
// A chamber holds the gas of one charge, or of several whose chambers have met. It enters a step as the potential -∫P
// dV: the pressure of the step is the work of the law over the volume swept, divided by that volume, and volume and
// pressure are found together (a fixed point in one number a chamber, whose slope is kept from step to step), so that
// the rock gets what the law gives. Volume that joins when the gas enters further cracks is filled without work.
#include <algorithm>
#include <cstdint>
#include <string>

#include "gas/reach.h"
#include "model/state_visitor.h"

namespace talus {

struct Chamber {
  std::vector<int> walls;    // hole walls of the model
  std::vector<int> charges;  // whose gas it holds
  enum class State : std::uint8_t { waiting, pressing, vented, merged } state = State::waiting;
  double volume = 0;     // m3 per metre, of what it has reached
  double pressure = 0;   // Pa, by the law, now
  double began = 0;      // s
  double vented_at = 0;  // s
  // m, of walls: way of the gas from the centre of the hole, since it is there; it is at the wall until that is more
  std::vector<double> fronts;
  double gain = 0;  // m3/(Pa s2), how much more volume a step gives for a higher pressure, over its length squared
  // m3/s2, how much more than the blocks' free flight it gave at no pressure (mostly less), over the step's length
  // squared
  double yield = 0;
  double joined = 0;   // m3, filled without work so far
  double work = 0;     // J/m, of the law along the volume swept
  double opening = 0;  // m, of what it vents through, now

  double front() const { return *std::max_element(fronts.begin(), fronts.end()); }
};
void visit_state(Chamber& chamber, StateVisitor& visitor);

enum class GasEventKind { detonation, venting, merging };
struct GasEvent {
  GasEventKind kind;
  int wall = 0, other = -1;  // of the charge that went off, else of the chamber
  // s; m3, Pa of the chamber, before it vents and after it has met the other
  double time = 0, volume = 0, pressure = 0;
  bool collar = false;     // it vents because its stemming is out
  Vec2 at = Vec2::Zero();  // m, where it vents: the free surface, or the middle of its hole
};

// Of a charge: how far its stemming has moved (m) and how fast it is (m/s).
struct StemmingMotion {
  double way = 0, speed = 0;
};
void visit_state(StemmingMotion& motion, StateVisitor& visitor);

class Gas {
 public:
  explicit Gas(Model& model);

  // s, of the next charge to go off, infinite where there is none: no step may pass it.
  double next_detonation() const;
  // Charges that are due, or will be in less than `soon` (s), go off, and the faces that gas presses on in this step
  // are laid. Once before the attempts at it, and before what sleeps is woken.
  void detonate(double soon);
  // s: in longer steps a wall that gas presses on does not follow it.
  double longest_step() const;
  // First guesses of the pressures for an attempt at a step of `dt`.
  void begin_step(double dt);
  // After a solve that leads to `moved`: whether the pressures it was made with are those of the volumes it leads to.
  // If not, they are better now.
  bool agrees(const std::vector<BlockState>& moved);
  // Whether they were sought for too long: a shorter step is called for.
  bool gives_up() const { return gives_up_; }
  // The step is accepted: volumes and pressures, then the front goes on, chambers meet and vent.
  void end_step(double dt);

  const std::vector<Chamber>& chambers() const { return chambers_; }
  const Reach& reach(int chamber) const { return reach_[chamber]; }
  const std::vector<GasEvent>& events() const { return events_; }  // of the last step
  double first_volume(int charge) const { return first_volume_[charge]; }
  double left(int charge) const { return left_[charge]; }
  double stemming_way(int charge) const { return stemming_.empty() ? 0 : stemming_[charge].way; }
  int chamber_of(int wall) const;  // that holds the gas of this hole now
  double front(int wall) const;    // m, from its centre
  void visit_state(StateVisitor& visitor);
  void restored();

 private:
  bool presses(const Chamber& chamber) const;
  double wave_speed(int wall) const;
  void go_off(const std::vector<int>& walls);
  void go_off(int wall);
  void set_apart(int wall);
  void settle_venting(Chamber& chamber);
  void lay_faces();
  GasMoment moment(const Chamber& chamber, double since) const;
  double room(int charge) const;  // m3, in which its law begins, for what is left of it
  double law_pressure(const Chamber& chamber, double volume, double time) const;
  double mixture_pressure(const Chamber& chamber, double volume, double time) const;
  double mean_pressure(const Chamber& chamber, double volume) const;  // over the way from the present volume
  double law_work(const Chamber& chamber, double from, double to, double time) const;
  void check_fall(const Chamber& chamber, double before, const GasMoment& now) const;
  void advance_fronts(Chamber& chamber, double volume, double pressure, double dt);
  void find_reach(int chamber);
  void spread(int chamber);
  bool meet(int a, int b) const;
  void merge();
  bool goes_before(int chamber, int other) const;
  void take_over(int chamber, int other);
  void push_stemming(int chamber, double dt);
  bool stemming_out(int charge) const;
  bool stemming_out(const Chamber& chamber) const;
  double opening_of(int chamber) const;
  Vec2 outlet_of(int chamber) const;
  void vent();
  double vent_part(const Chamber& chamber, double time) const;
  void leak(int chamber, double dt);

  Model& model_;
  GasPaths paths_;
  std::vector<Chamber> chambers_;
  std::vector<double> first_volume_;      // m3, of each charge's hole when it went off
  std::vector<double> left_;              // part of each charge's gas that has not left
  std::vector<StemmingMotion> stemming_;  // of each charge; empty where no charge has one
  std::vector<Reach> reach_;
  struct Guess {
    double free = 0;                  // m3, where the blocks fly by themselves
    double pressure = 0, volume = 0;  // the last solve
    // m3, by the faces under gas: the rest of what the volume grows by is filled without work
    double swept = 0;
    int solves = 0;
    double slope = 0, offset = 0;  // volume = offset + slope · pressure
  };
  std::vector<Guess> guess_;
  double dt_ = 0;
  bool gives_up_ = false;
  std::vector<GasEvent> events_;
  bool events_told_ = true;  // of the last step; not yet where it came to nothing after charges had gone off
};

}  // namespace talus
