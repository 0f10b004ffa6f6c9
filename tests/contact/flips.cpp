// The classical open-close iteration (Shi 1988): every contact has a state, all forces follow from it linearly,
// one full solve, then every contact whose state does not fit what came out is flipped. Springs of closed contacts
// may pull in the solve; friction of slipping ones is the force by the normal force of the iteration before.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "problem.h"

namespace talus::study {

namespace {

constexpr int usual = 6;  // iterations after which Shi's code takes the step again with a third of Δt

struct States {
  std::vector<ContactState> state;
  std::vector<double> way;     // of slipping: +1, -1
  std::vector<double> normal;  // N, of the last iteration
};

States of_last_step(const Desk& desk, const std::vector<double>& gap) {
  States s;
  for (size_t k = 0; k < desk.count(); ++k) {
    const Contact& contact = desk.contact(k);
    const bool closes = contact.state == ContactState::open && gap[k] <= 0;
    s.state.push_back(closes ? ContactState::stick : contact.state);
    s.way.push_back(contact.shear_force < 0 ? -1 : 1);
    s.normal.push_back(contact.normal_force);
  }
  return s;
}

Vector solved(Desk& desk, const States& s) {
  std::vector<double> kn(desk.count(), 0), ks(desk.count(), 0), normal(desk.count(), 0), shear(desk.count(), 0);
  for (size_t k = 0; k < desk.count(); ++k) {
    const ContactRows& row = desk.row(k);
    if (s.state[k] == ContactState::open) continue;
    kn[k] = row.kn;
    normal[k] = -row.kn * row.gap0;
    if (s.state[k] == ContactState::stick) ks[k] = row.ks;
    shear[k] = s.state[k] == ContactState::stick ? row.ks * row.slide0 : s.way[k] * Desk::limit(row, s.normal[k]);
  }
  Vector d = Vector::Zero(desk.problem.system.force.size());
  const Vector rhs = desk.out_of_balance(d, normal, shear);
  if (desk.factorise(kn, ks)) desk.solve(rhs, d);
  return d;
}

// How many have changed.
int flip(const Desk& desk, const std::vector<double>& gap, const std::vector<double>& slide, States& s) {
  int flipped = 0;
  for (size_t k = 0; k < desk.count(); ++k) {
    const ContactRows& row = desk.row(k);
    s.normal[k] = row.kn * std::max(0.0, -gap[k]);
    const double limit = Desk::limit(row, s.normal[k]), trial = row.ks * slide[k];
    ContactState next = ContactState::open;
    if (gap[k] < 0) {
      const bool opens_new = s.state[k] == ContactState::open;
      const bool back = s.state[k] == ContactState::slip && s.way[k] * trial < limit;
      const bool lets_go = s.state[k] == ContactState::stick && std::abs(trial) > limit;
      next = opens_new || back ? ContactState::stick : lets_go ? ContactState::slip : s.state[k];
      if (lets_go) s.way[k] = trial < 0 ? -1 : 1;
    }
    flipped += next != s.state[k];
    s.state[k] = next;
  }
  return flipped;
}

}  // namespace

void flips(Desk& desk) {
  std::vector<double> gap, slide;
  desk.places(Vector::Zero(desk.problem.system.force.size()), gap, slide);
  States s = of_last_step(desk, gap);
  char note[160] = "";
  bool settled = false;
  while (!desk.done() && !desk.spent()) {
    const Vector d = solved(desk, s);
    const double residual = desk.judge(d);
    desk.places(d, gap, slide);
    const int flipped = flip(desk, gap, slide, s);
    if ((flipped == 0 || desk.done()) && !settled) {
      settled = true;
      std::snprintf(note, sizeof note, "states settle after %d: residual %.1e, ΔE %.6e", desk.outcome.factorisations,
                    residual, desk.problem.energy(d) - desk.problem.energy());
      if (desk.outcome.factorisations <= usual) desk.outcome.accepted = residual;
    }
    if (desk.outcome.factorisations == usual && !settled)
      std::snprintf(note, sizeof note, "after %d: %d states flip, residual %.1e", usual, flipped, residual);
    desk.outcome.note = note;
  }
}

}  // namespace talus::study
