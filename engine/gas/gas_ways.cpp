// Gas goes on into cracks, meets that of other chambers, and leaves.
#include <algorithm>

#include "gas/gas.h"
#include "gas/orifice.h"

namespace talus {

namespace {

bool pressing(const Chamber& chamber) {
  return chamber.state != Chamber::State::merged && chamber.pressure > 0;
}

}  // namespace

void Gas::spread(int c) {
  Chamber& chamber = chambers_[c];
  const double part = vent_part(chamber, model_.time);
  if (part == 0) {
    chamber.pressure = 0;
    return;
  }
  find_reach(c);
  const double volume = gas_volume(model_, model_.blocks, 0, paths_, chamber.walls, reach_[c]);
  chamber.joined += volume - chamber.volume;
  chamber.volume = volume;
  chamber.pressure = part * law_pressure(chamber, volume, model_.time);
}

// Whether the gas of two chambers has met in a joint, each coming from its own end.
bool Gas::meet(int a, int b) const {
  for (const ReachedJoint& mine : reach_[a].joints)
    for (const ReachedJoint& other : reach_[b].joints)
      if (mine.joint == other.joint && std::max(mine.from, other.from) <= std::min(mine.to, other.to)) return true;
  return false;
}

void Gas::merge() {
  for (int c = 0; c < int(chambers_.size()); ++c) {
    if (!pressing(chambers_[c])) continue;
    std::vector<int> met;
    for (const int wall : reach_[c].walls) met.push_back(chamber_of(wall));
    for (int other = 0; other < int(chambers_.size()); ++other)
      if (other != c && pressing(chambers_[other]) && meet(c, other)) met.push_back(other);
    // Those that have blown out last: a taking over finds anew what the gas has reached, and with it whether that is a
    // free surface.
    std::stable_partition(met.begin(), met.end(),
                          [&](int other) { return chambers_[other].state != Chamber::State::vented; });
    for (const int other : met) {
      if (other == c || chambers_[other].state == Chamber::State::merged) continue;
      if (goes_before(other, c)) {
        take_over(other, c);
        break;  // whom it meets in its turn, or in the next step
      }
      take_over(c, other);
    }
  }
}

// Of two chambers that press, that of the charge that went off first takes over the other, and its ways of venting and
// of going on hold for all.
bool Gas::goes_before(int a, int b) const {
  if (!pressing(chambers_[a]) || !pressing(chambers_[b])) return false;
  const auto first = [&](int c) { return std::pair(model_.scene.charges[chambers_[c].charges[0]].delay, c); };
  return first(a) < first(b);
}

// What an orifice has let out is missing in the gas itself. Else one that has blown out at once is open to the free
// surface for the other too, and of one that vents by a law what has left is taken from its gas: the law begins again
// with both. No gas comes with a hole that waits.
void Gas::take_over(int c, int other) {
  Chamber &own = chambers_[c], &met = chambers_[other];
  const bool orifice = model_.scene.charges[own.charges[0]].orifice.has_value(),
             open = met.state == Chamber::State::vented;
  if (open && !orifice && !pressing(met)) {
    reach_[c].surface = true;
    reach_[c].outlet = reach_[other].outlet;
    return;
  }
  if (open && !pressing(met))
    for (const int charge : met.charges) left_[charge] = 0;
  else if (!met.charges.empty())
    settle_venting(met);
  const bool vents = open || own.state == Chamber::State::vented;
  if (vents && !orifice && !met.charges.empty()) {
    settle_venting(own);
    own.vented_at = model_.time;
  } else if (open) {
    own.vented_at = own.state == Chamber::State::vented ? std::min(own.vented_at, met.vented_at) : met.vented_at;
  }
  if (vents) own.state = Chamber::State::vented;
  own.walls.insert(own.walls.end(), met.walls.begin(), met.walls.end());
  own.fronts.insert(own.fronts.end(), met.fronts.begin(), met.fronts.end());
  own.charges.insert(own.charges.end(), met.charges.begin(), met.charges.end());
  own.joined += met.joined;
  own.work += met.work;
  if (pressing(met)) own.volume += met.volume;
  met.state = Chamber::State::merged;
  met.pressure = 0;
  spread(c);
  if (vents && orifice) own.opening = opening_of(c);
  events_.push_back({GasEventKind::merging, c, other, model_.time, own.volume, own.pressure});
}

// A column of length L and density ρ that only its inertia holds: x'' = P/(ρL), until x = L. P is that of the step.
void Gas::push_stemming(int c, double dt) {
  for (const int charge : chambers_[c].charges) {
    const auto& stemming = model_.scene.charges[charge].stemming;
    if (!stemming || stemming_out(charge)) continue;
    StemmingMotion& motion = stemming_[charge];
    const double faster = dt * guess_[c].pressure / (stemming->density * stemming->length);
    motion.way += dt * (motion.speed + faster / 2);
    motion.speed += faster;
  }
}

bool Gas::stemming_out(int charge) const {
  const auto& stemming = model_.scene.charges[charge].stemming;
  return stemming && stemming_[charge].way >= stemming->length;
}

bool Gas::stemming_out(const Chamber& chamber) const {
  return std::any_of(chamber.charges.begin(), chamber.charges.end(), [&](int charge) { return stemming_out(charge); });
}

// m: of the cracks, and of the collars, whose area serves the length of the charge.
double Gas::opening_of(int c) const {
  const Orifice& orifice = *model_.scene.charges[chambers_[c].charges[0]].orifice;
  double sum = opening(orifice, model_, reach_[c]);
  if (orifice.opening) return sum;
  for (const int charge : chambers_[c].charges)
    if (stemming_out(charge)) sum += first_volume_[charge] / model_.scene.charges[charge].stemming->charge_length;
  return sum;
}

Vec2 Gas::outlet_of(int c) const {
  if (!reach_[c].surface || reach_[c].outlet < 0) return model_.hole_walls[c].centre;
  Vec2 sum = Vec2::Zero();
  const auto& corners = paths_.corners(reach_[c].outlet);
  for (const GasPaths::Corner& corner : corners) sum += model_.vertex[corner.vertex];
  return sum / double(corners.size());
}

void Gas::vent() {
  for (size_t c = 0; c < chambers_.size(); ++c) {
    Chamber& chamber = chambers_[c];
    if (chamber.state != Chamber::State::pressing || !(reach_[c].surface || stemming_out(chamber))) continue;
    chamber.state = Chamber::State::vented;
    chamber.vented_at = model_.time;
    events_.push_back({GasEventKind::venting, int(c), -1, model_.time, chamber.volume, chamber.pressure,
                       !reach_[c].surface, outlet_of(int(c))});
    chamber.pressure *= vent_part(chamber, model_.time);
    if (model_.scene.charges[chamber.charges[0]].orifice) chamber.opening = opening_of(int(c));
  }
}

// Through an orifice, over the step that ends now: at the volume it leads to, and the mean of the openings at its
// ends.
void Gas::leak(int c, double dt) {
  Chamber& chamber = chambers_[c];
  const auto& charges = model_.scene.charges;
  const auto& orifice = charges[chamber.charges[0]].orifice;
  if (chamber.state != Chamber::State::vented || !orifice || chamber.pressure == 0) return;
  double mass = 0;
  for (const int charge : chamber.charges)
    mass += room(charge) * (charges[charge].orifice ? charges[charge].orifice : orifice)->density;
  const double before = chamber.opening;
  chamber.opening = opening_of(c);
  const double part = blow_down(
      *orifice, (before + chamber.opening) / 2, mass, chamber.volume,
      [&](double x) { return law_pressure(chamber, chamber.volume / x, model_.time); }, dt);
  for (const int charge : chamber.charges) left_[charge] *= part;
  chamber.pressure = part == 0 ? 0 : law_pressure(chamber, chamber.volume, model_.time);
}

}  // namespace talus
