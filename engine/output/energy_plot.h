#pragma once
// energy.svg: the ledger over time.
#include <string>
#include <vector>

#include "output/record.h"
#include "step/simulation.h"

namespace talus {

std::vector<double> energy_row(const Simulation& simulation);  // of what the plan lets the scene have
std::string draw_energies(const Record& record, const Plan& plan);

}  // namespace talus
