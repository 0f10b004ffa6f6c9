#pragma once
// Coulomb's law at a contact that sweeps come to, all others held: one contact by itself, or four at once.
#include <algorithm>
#include <array>
#include <cmath>

#include "equations/simd.h"

namespace talus {

struct ContactForces {  // N
  double n, t;
};

// Of one contact whose two blocks give way to it alone.
struct SweptLaw {
  double friction, cohesion;  // tan φ; N
  double nn, ns, ss;          // m/N: gap and slide under unit forces, the contact's own compliance with them
  // reciprocals; of sliding either way, nought where it would wedge itself without bound
  double by_det, by_ss, by_steep[2];

  SweptLaw() = default;
  SweptLaw(double nn, double ns, double ss, double friction, double cohesion);
  // The forces at which gap = gap0 + nn n - ns t and slide = slide0 + ns n - ss t meet the law: pressed and sticking
  // mean gap = 0 and slide = 0. Cohesion holds at n = 0 too (ContactTerms::linearise).
  ContactForces meet(double gap0, double slide0) const {
    const double n = (slide0 * ns - gap0 * ss) * by_det, t = (nn * slide0 - ns * gap0) * by_det;
    return n > 0 && std::abs(t) <= friction * n + cohesion ? ContactForces{n, t} : slide_or_open(gap0, slide0, {n, t});
  }
  // `forces` cut to what the contact can carry.
  ContactForces carried(ContactForces forces) const {
    const double n = std::max(0.0, forces.n), most = limit(n);
    return {n, std::clamp(forces.t, -most, most)};
  }
  // 0 open, 1 sticks, 2 and 3 slips either way.
  char state(ContactForces forces) const {
    if (!(forces.n > 0)) return 0;
    if (std::abs(forces.t) < (1 - 1e-12) * limit(forces.n)) return 1;
    return forces.t > 0 ? 2 : 3;
  }

 private:
  double limit(double n) const { return (n > 0 ? friction * n : 0) + cohesion; }
  ContactForces slide_or_open(double gap0, double slide0, ContactForces stuck) const;
};

// Of four contacts, for a processor's registers: its arithmetic is done at once, without a jump that could be guessed
// wrong.
struct FourLaws {
  Four friction, cohesion, nn, ns, ss, by_det, by_ss, by_steep, by_steep_back;

  // Of contacts that stay open at gaps above nought.
  static FourLaws open();
  void put(size_t at, const SweptLaw& law);
  // As SweptLaw::meet: sticking, sliding towards where sticking would ask too much, and open are all worked out. n is
  // not a number where none of them fits, which is rare.
  TALUS_WITHIN void meet(const Four& gap0, const Four& slide0, Four& n, Four& t) const {
    const Four stuck_n = (slide0 * ns - gap0 * ss) * by_det, stuck_t = (nn * slide0 - ns * gap0) * by_det;
    const auto back = stuck_t <= 0;
    const Four zero = {}, one = zero + 1, unknown = zero + __builtin_nan("");
    const Four way = back ? -one : one;
    const Four pressed = (way * ns * cohesion - gap0) * (back ? by_steep_back : by_steep),
               limit = friction * pressed + cohesion;
    const auto slides = (pressed > 0) & (way * (slide0 + ns * pressed) - ss * limit >= 0);
    const Four asked = slide0 * by_ss, below = asked > cohesion ? cohesion : asked,
               alone = below < -cohesion ? -cohesion : below;
    const auto opens = (stuck_n <= 0) & (gap0 - ns * alone >= 0);
    const auto sticks = (stuck_n > 0) & (way * stuck_t <= friction * stuck_n + cohesion);
    n = sticks ? stuck_n : opens ? zero : slides ? pressed : unknown;
    t = sticks ? stuck_t : opens ? alone : way * limit;
  }
};

}  // namespace talus
