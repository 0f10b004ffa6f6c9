#pragma once
// The ledger's columns: one registry for the history, Lua, run.json, the picture and the reference page.
#include <span>
#include <string>
#include <vector>

#include "step/ledger.h"

namespace talus {

struct Plan;

struct EnergyTerm {
  enum Kind { stored, put_in, lost, sum, rest };
  std::string name;    // in Lua: sim.energy.<name>
  std::string column;  // in history.csv and run.json
  std::string label;   // in the picture
  Kind kind;
  double Energies::*value;
  std::string meaning;
  bool (*present)(const Plan& plan);  // whether the scene can have it
};

std::span<const EnergyTerm> energy_terms();
std::vector<const EnergyTerm*> energy_terms(const Plan& plan);  // those the scene can have
// And those that it has come to have, as its script has changed something.
std::vector<const EnergyTerm*> energy_terms(const Plan& plan, const Energies& energies);

}  // namespace talus
