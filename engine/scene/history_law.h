#pragma once
#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace talus {

// A number that may change with time t (s): a constant, a table of (t, value) with straight lines between
// and held ends, or a function, which may throw InputError or RunError; and what is left of what it was before it was
// changed.
class History {
 public:
  History(double constant = 0) : constant_(constant) {}
  explicit History(std::vector<std::pair<double, double>> table) : table_(std::move(table)) {}
  explicit History(std::function<double(double)> function) : function_(std::move(function)) {}

  bool given() const { return function_ || !table_.empty() || constant_ != 0 || left_ != 0; }

  // From `value` at the time `since` it comes to what it says at `until`, in a straight line beside how that goes on.
  void come_from(double value, double since, double until) {
    left_ = value - says(since);
    since_ = since;
    until_ = until;
  }

  double at(double t) const {
    return left_ != 0 && t < until_ ? says(t) + left_ * std::min(1.0, (until_ - t) / (until_ - since_)) : says(t);
  }

  double says(double t) const {
    if (function_) return function_(t);
    if (table_.empty()) return constant_;
    auto next =
        std::upper_bound(table_.begin(), table_.end(), t, [](double a, const auto& row) { return a < row.first; });
    if (next == table_.begin()) return table_.front().second;
    if (next == table_.end()) return table_.back().second;
    auto last = next - 1;
    return last->second + (next->second - last->second) * (t - last->first) / (next->first - last->first);
  }

  double just_before(double t) const {  // where it jumps at t, what it jumps from; of constants and tables
    const auto next =
        std::lower_bound(table_.begin(), table_.end(), t, [](const auto& row, double a) { return row.first < a; });
    return next != table_.end() && next->first == t ? next->second : at(t);
  }
  // s, the first time after t at which a table bends or jumps, or infinity.
  double next_bend(double t) const {
    const auto next =
        std::upper_bound(table_.begin(), table_.end(), t, [](double a, const auto& row) { return a < row.first; });
    return next == table_.end() ? std::numeric_limits<double>::infinity() : next->first;
  }

  bool constant() const { return !function_ && table_.empty() && left_ == 0; }
  bool is_function() const { return bool(function_); }

  // ∫ from `begin` to `end`, not before it: exact for constants and tables; Gauss's rule with 16 points for functions,
  // for no more than a step, as points that slide over jumps and waves would shake what is moved by them.
  double integral(double begin, double end) const {
    if (function_) {
      constexpr int parts = 8;
      double sum = 0;
      for (int i = 0; i < parts; ++i)
        for (double g : {0.21132486540518712, 0.78867513459481288}) sum += at(begin + (end - begin) * (i + g) / parts);
      return sum * (end - begin) / (2 * parts);
    }
    double sum = 0, from = begin;
    for (const auto& row : table_) {
      if (row.first <= from || row.first >= end) continue;
      sum += (row.first - from) * (at(from) + row.second) / 2;
      from = row.first;
    }
    return sum + (end - from) * (at(from) + just_before(end)) / 2;
  }

  template <class Visitor>  // of the registry, model/registry.h
  void visit_state(Visitor& visitor) {
    visitor("constant", constant_);
    visitor.growing("table", table_);
    visitor.law(function_);
    visitor("left", left_);
    visitor("since", since_);
    visitor("until", until_);
  }

 private:
  double constant_ = 0;
  double left_ = 0, since_ = 0, until_ = 0;  // of what it was, s, s
  std::vector<std::pair<double, double>> table_;
  std::function<double(double)> function_;
};

}  // namespace talus
