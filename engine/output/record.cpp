#include "output/record.h"

#include <algorithm>

namespace talus {

namespace {

constexpr size_t most_samples = 256;  // one every 3 px of the picture

}  // namespace

void Record::add(long step, double time, const Row& row) {
  const std::vector<double> values = row();
  times_.push_back(time);
  values_.insert(values_.end(), values.begin(), values.end());
  step_ = step;
}

void Record::after_step(long step, double time, const Row& row) {
  if (step % stride_ != 0 || step_ == step) return;
  add(step, time, row);
  if (times_.size() < most_samples) return;
  const size_t width = values_.size() / times_.size();
  for (size_t k = 0; 2 * k < times_.size(); ++k) {
    times_[k] = times_[2 * k];
    std::copy_n(values_.begin() + long(2 * k * width), width, values_.begin() + long(k * width));
  }
  times_.resize((times_.size() + 1) / 2);
  values_.resize(times_.size() * width);
  stride_ *= 2;
}

void Record::last(long step, double time, const Row& row) {
  if (step_ != step) add(step, time, row);
}

std::vector<double> Record::column(size_t k) const {
  std::vector<double> values;
  if (times_.empty()) return values;
  const size_t width = values_.size() / times_.size();
  for (size_t i = 0; i < times_.size(); ++i) values.push_back(values_[i * width + k]);
  return values;
}

void Record::visit_state(StateVisitor& visitor) {
  visitor.growing("times", times_);
  visitor.growing("values", values_);
  visitor("stride", stride_);
  visitor("step", step_);
}

}  // namespace talus
