#include "step/islands.h"

#include <algorithm>
#include <numeric>

#include "model/disjoint_sets.h"

namespace talus {

// pairs: (list, item), in the order the items shall have.
void Islands::Lists::fill(int count, const std::vector<std::pair<int, int>>& pairs) {
  begin.assign(size_t(count) + 1, 0);
  for (const auto& [list, item] : pairs) ++begin[list + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  items.resize(pairs.size());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (const auto& [list, item] : pairs) items[next[list]++] = item;
}

void Islands::find(const Model& model, const ContactTerms& contacts, bool together) {
  if (together) return take_all(model, contacts);
  const int count = join(model, contacts);
  single_.assign(size_t(count), 1);
  std::vector<std::pair<int, int>> members, rows;
  for (const int b : model.awake_blocks())
    if (of_[b] >= 0) members.push_back({of_[b], b});
  for (const Joint& joint : model.joints)
    if (ties(joint))
      for (const int b : {joint.a, joint.b})
        if (of_[b] >= 0) single_[of_[b]] = 0;
  for (int k = 0; k < int(contacts.rows().size()); ++k) {
    const ContactRows& row = contacts.rows()[k];
    const int i = of_[row.i], j = of_[row.j], island = i < 0 || j < 0 || i == j ? std::max(i, j) : count;
    rows.push_back({island, k});
    if (i < 0) members.push_back({island, row.i});
    if (j < 0) members.push_back({island, row.j});
    if (row.near) single_[island] = 0;
  }
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  blocks_.fill(count, members);
  rows_.fill(count + 1, rows);
}

// Numbers the islands in the order of their first blocks; how many there are.
int Islands::join(const Model& model, const ContactTerms& contacts) {
  DisjointSets sets(model.shapes.size());
  const auto tie = [&](int a, int b) {
    if (model.shapes[a].dofs > 0 && model.shapes[b].dofs > 0) sets.join(a, b);
  };
  for (const Joint& joint : model.joints)
    if (ties(joint) && !model.sleeps(joint.a)) tie(joint.a, joint.b);
  for (const ContactRows& row : contacts.rows())
    if (row.near) tie(row.i, row.j);
  of_.assign(model.shapes.size(), 0);  // to be numbered, but for what is held or sleeps
  for (const int b : model.held_blocks) of_[b] = -1;
  int count = 0;
  for (int b = 0; b < int(of_.size()); ++b)
    if (model.sleeps(b))
      of_[b] = -1;
    else if (of_[b] == 0)
      of_[b] = sets.root(b) == b ? count++ : of_[sets.root(b)];
  return count;
}

void Islands::take_all(const Model& model, const ContactTerms& contacts) {
  of_.assign(model.shapes.size(), -1);
  const int count = model.awake_blocks().empty() ? 0 : 1;
  single_.assign(size_t(count), 0);
  std::vector<std::pair<int, int>> members, rows;
  for (const int b : model.awake_blocks()) {
    members.push_back({0, b});
    if (model.shapes[b].dofs > 0) of_[b] = 0;
  }
  for (int k = 0; k < int(contacts.rows().size()); ++k) rows.push_back({0, k});
  blocks_.fill(count, members);
  rows_.fill(count + 1, rows);
}

}  // namespace talus
