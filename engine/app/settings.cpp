#include "app/settings.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "script/nearest.h"

namespace talus {
namespace {

bool is_setting(const std::string& word) {
  const std::size_t letters = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
  return letters != 0 && letters != std::string::npos && word[letters] == '=';
}

}  // namespace

std::vector<OptionSetting> settings_after(const Arguments& arguments, std::size_t& i,
                                          const std::vector<std::string>& known) {
  const std::string option = arguments[i];
  std::vector<OptionSetting> settings;
  for (; i + 1 < arguments.size() && is_setting(arguments[i + 1]); ++i) {
    std::istringstream words(arguments[i + 1]);
    for (std::string word; std::getline(words, word, ',');) {
      const std::size_t equals = std::min(word.find('='), word.size());
      const OptionSetting setting = {word.substr(0, equals), word.substr(std::min(equals + 1, word.size()))};
      if (std::ranges::find(known, setting.name) == known.end())
        throw UsageError{option + ": there is no \"" + setting.name + "\"" + suggestion(setting.name, known)};
      if (std::ranges::find(settings, setting.name, &OptionSetting::name) != settings.end())
        throw UsageError{option + ": expected " + setting.name + " once, got it twice"};
      settings.push_back(setting);
    }
  }
  if (settings.empty()) {
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name + "=…";
    throw UsageError{option + ": expected " + names + " after it"};
  }
  return settings;
}

bool read_amount(const std::string& text, const Units& units, double& amount) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !(number > 0) || number > 1e15) return false;
  const std::string unit(end, text.data() + text.size());
  const auto found = std::ranges::find(units, unit, &Units::value_type::first);
  if (found == units.end()) return false;
  amount = number * found->second;
  return true;
}

}  // namespace talus
