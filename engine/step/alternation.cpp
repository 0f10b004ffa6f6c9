#include "step/alternation.h"

#include <algorithm>
#include <array>
#include <vector>

namespace talus {

namespace {

constexpr int begins_after = 20;  // solves: before, states only settle
constexpr int seldom = 4;         // a state that changes less than once in so many solves does not alternate
constexpr std::size_t most_named = 3;

const char* word(ContactState state) {
  constexpr std::array words = {"open", "pressed", "sliding"};
  return words[std::size_t(state)];
}

}  // namespace

void Alternation::note(const Model& model) {
  if (++solves_ < begins_after) return;
  for (const Contact& contact : model.contacts) {
    const auto [at, first] = seen_.try_emplace(contact.key());
    Seen& seen = at->second;
    if (first) {
      const ContactState state = contact.state;
      seen = {.last = state, .before = state, .i = contact.i, .j = contact.j, .joint = contact.joint >= 0};
    }
    if (contact.state == seen.last) continue;
    seen.before = seen.last;
    seen.last = contact.state;
    ++seen.changes;
  }
}

std::string Alternation::text(const Model& model) const {
  const int watched = solves_ - begins_after;
  std::vector<std::pair<std::int64_t, const Seen*>> most;
  for (const auto& [key, seen] : seen_)
    if (seen.changes * seldom > watched && seen.changes > 1) most.emplace_back(key, &seen);
  std::sort(most.begin(), most.end(), [](const auto& a, const auto& b) {
    return a.second->changes != b.second->changes ? a.second->changes > b.second->changes : a.first < b.first;
  });
  std::string text;
  for (std::size_t k = 0; k < std::min(most.size(), most_named); ++k) {
    const Seen& seen = *most[k].second;
    text += (k == 0 ? "" : "; ") + std::string(seen.joint ? "the joint between " : "the contact between ") +
            block_name(model, seen.i) + " and " + block_name(model, seen.j) + " changes between " + word(seen.before) +
            " and " + word(seen.last) + ", " + std::to_string(seen.changes) + " times in " + std::to_string(watched) +
            " solves";
  }
  return text;
}

}  // namespace talus
