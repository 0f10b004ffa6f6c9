#pragma once
// A load step of a static run, or a part of one: forces grow linearly over it, from nothing before the first.
// Friction's work too is that of the whole step: what slides to and fro while equilibrium is looked for has not done so
// in the rock.
#include <optional>
#include <vector>

#include "step/changed_constants.h"
#include "step/ledger.h"

namespace talus {

class LoadStepBooking {
 public:
  // `before`: constants that the script has changed since the last one, as they were.
  LoadStepBooking(const Model& model, const Supports& supports, double time, bool unloaded, const Constants& before);
  void book(Model& model, const Supports& supports, Ledger& ledger) const;

 private:
  struct Force {
    Vec2 force, place;  // N/m, m
  };
  static std::vector<Force> forces(const Model& model, double time);
  static std::vector<Vec2> weights(const Model& model);
  void book_friction(const Model& model, bool driven, Ledger& ledger) const;
  static void book_climbs(Model& model, Ledger& ledger);

  bool unloaded_;
  std::vector<Force> forces_;
  std::vector<Vec2> weights_, centroids_;  // N/m and m, per block
  std::vector<Vec2> reactions_, moved_;    // N/m and m, per fixity
  std::optional<ConstantsBooking> change_;
};

}  // namespace talus
