#pragma once
#include <algorithm>
#include <utility>
#include <vector>

namespace talus {

// By what `key` gives of each, those of one key as they were: values too large to be moved about in sorting.
template <class T, class Key>
void sort_large(std::vector<T>& values, Key&& key) {
  std::vector<std::pair<decltype(key(values[0])), int>> order;
  order.reserve(values.size());
  for (const T& value : values) order.emplace_back(key(value), int(order.size()));
  std::sort(order.begin(), order.end());
  std::vector<T> sorted;
  sorted.reserve(values.size());
  for (const auto& [at, k] : order) sorted.push_back(values[size_t(k)]);
  values = std::move(sorted);
}

}  // namespace talus
