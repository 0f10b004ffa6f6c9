#pragma once
// Settings with a unit, after --checkpoint and --limit: every=60s, memory=500MB, steps=1000.
#include <string>
#include <utility>
#include <vector>

#include "app/command.h"

namespace talus {

struct OptionSetting {
  std::string name, value;
  std::string text() const { return name + "=" + value; }
};

// The words name=value, name=value,… that follow option i, which is moved on to the last of them. Each name is one of
// `known`, none is given twice, and there is at least one; else UsageError.
std::vector<OptionSetting> settings_after(const Arguments& arguments, std::size_t& i,
                                          const std::vector<std::string>& known);

// A number above 0 with one of these units behind it. False where the text is none.
using Units = std::vector<std::pair<std::string, double>>;
inline const Units durations = {{"ms", 1e-3}, {"s", 1}, {"min", 60}, {"h", 3600}};
inline const Units sizes = {{"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}};
bool read_amount(const std::string& text, const Units& units, double& amount);

}  // namespace talus
