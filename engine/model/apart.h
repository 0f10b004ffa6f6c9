#pragma once
#include <memory>
#include <utility>

namespace talus {

// A value that few of many have, kept elsewhere, so that the others lie close together. Copying copies it.
template <class T>
class Apart {
 public:
  Apart() = default;
  Apart(const Apart& other) : value_(other.value_ ? std::make_unique<T>(*other.value_) : nullptr) {}
  Apart(Apart&&) noexcept = default;
  Apart& operator=(const Apart& other) {
    if (value_ && other.value_)
      *value_ = *other.value_;
    else if (value_ || other.value_)
      *this = Apart(other);
    return *this;
  }
  Apart& operator=(Apart&&) noexcept = default;
  ~Apart() = default;

  explicit operator bool() const { return value_ != nullptr; }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }
  T& make() {
    if (!value_) value_ = std::make_unique<T>();
    return *value_;
  }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace talus
