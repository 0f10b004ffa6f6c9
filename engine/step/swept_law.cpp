#include "step/swept_law.h"

namespace talus {

SweptLaw::SweptLaw(double normal, double mixed, double shear, double tan_phi, double held)
    : friction(tan_phi),
      cohesion(held),
      nn(normal),
      ns(mixed),
      ss(shear),
      by_det(1 / (nn * ss - ns * ns)),
      by_ss(1 / ss) {
  for (const int way : {0, 1}) {
    const double steep = nn - (way == 0 ? 1 : -1) * ns * friction;
    by_steep[way] = steep > 0 ? 1 / steep : 0;
  }
}

// `stuck`: what sticking would ask for, which is too much.
ContactForces SweptLaw::slide_or_open(double gap0, double slide0, ContactForces stuck) const {
  const double alone = std::clamp(slide0 * by_ss, -cohesion, cohesion);
  const bool open = gap0 - ns * alone >= 0;
  if (open && stuck.n <= 0) return {0, alone};
  // Sliding towards where sticking would ask too much, else the other way.
  for (const bool back : {stuck.t <= 0, stuck.t > 0}) {
    const double way = back ? -1 : 1;
    const double pressed = (way * ns * cohesion - gap0) * by_steep[back];
    if (pressed <= 0) continue;
    const double limit = friction * pressed + cohesion;
    if (way * (slide0 + ns * pressed) - ss * limit >= 0) return {pressed, way * limit};
  }
  if (open) return {0, alone};
  // Nothing fits to the last digit, at the border of two cases: the nearest of sticking.
  return carried(stuck);
}

FourLaws FourLaws::open() {
  const Four one = {1, 1, 1, 1};
  FourLaws laws{};
  laws.nn = laws.ss = laws.by_det = laws.by_ss = one;
  return laws;
}

void FourLaws::put(size_t at, const SweptLaw& law) {
  friction[at] = law.friction;
  cohesion[at] = law.cohesion;
  nn[at] = law.nn;
  ns[at] = law.ns;
  ss[at] = law.ss;
  by_det[at] = law.by_det;
  by_ss[at] = law.by_ss;
  by_steep[at] = law.by_steep[0];
  by_steep_back[at] = law.by_steep[1];
}

}  // namespace talus
