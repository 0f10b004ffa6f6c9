#pragma once
// What goes through the state of a run, table by table. Each owner of state lists its members once, in a function
// visit_state; the snapshot, the hash, the saved file and the fingerprint are visitors of that one list.
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace talus {

class StateVisitor {
 public:
  // state: what steps, or a script between them, change. constant: what is settled when the model is built.
  enum class Part { state, constant };
  explicit StateVisitor(Part part = Part::state) : part_(part) {}
  virtual ~StateVisitor() = default;

  // A member of the state: a number, a text, a struct with a list of its own, or a table of these whose length is
  // settled when the model is built.
  template <class T>
  void operator()(const char* name, T& value) {
    enter(name);
    visit(value);
  }
  // A table whose length is state too.
  template <class T>
  void growing(const char* name, std::vector<T>& list) {
    enter(name);
    std::size_t count = list.size();
    if (wanted()) {
      resize(count);
      if (count != list.size()) list.resize(count);
    }
    elements(list);
  }
  template <class T>
  void constant(const char* name, T& value) {
    if (part_ == Part::state) return;
    const bool outside = std::exchange(inside_constant_, true);
    (*this)(name, value);
    inside_constant_ = outside;
  }
  // A history's function. Only that there is one can be written down.
  void law(std::function<double(double)>& function) {
    if (wanted()) take_law(function);
  }

 protected:
  virtual void enter(const char* /*name*/) {}
  virtual void take(double& value) = 0;
  virtual void take(std::int64_t& value) = 0;
  virtual void take(std::string& value) = 0;
  virtual void take_law(std::function<double(double)>& function) = 0;
  virtual void resize(std::size_t& count) = 0;             // of a growing table
  virtual void check_length(std::size_t count) = 0;        // of a table whose length is settled
  virtual bool wants_types_only() const { return false; }  // then an element stands for its table

 private:
  bool wanted() const { return part_ == Part::state || inside_constant_; }

  template <class T>
  void visit(T& value) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::string>) {
      if (wanted()) take(value);
    } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
      auto whole = static_cast<std::int64_t>(value);
      if (wanted()) take(whole);
      value = static_cast<T>(whole);
    } else if constexpr (std::is_base_of_v<Eigen::DenseBase<T>, T>) {
      for (Eigen::Index i = 0; i < value.size(); ++i) visit(value.data()[i]);
    } else {
      visit_parts(value);
    }
  }
  template <class T, std::size_t n>
  void visit_parts(std::array<T, n>& list) {
    for (T& element : list) visit(element);
  }
  template <class A, class B>
  void visit_parts(std::pair<A, B>& pair) {
    visit(pair.first);
    visit(pair.second);
  }
  template <class T>
  void visit_parts(std::vector<T>& list) {
    if (wanted()) check_length(list.size());
    elements(list);
  }
  template <class T>
  void visit_parts(T& owner) {
    if constexpr (requires { owner.visit_state(*this); })
      owner.visit_state(*this);
    else
      visit_state(owner, *this);
  }
  template <class T>
  void elements(std::vector<T>& list) {
    if (wants_types_only()) {
      T one{};
      visit(one);
    } else {
      for (T& element : list) visit(element);
    }
  }

  Part part_;
  bool inside_constant_ = false;
};

}  // namespace talus
