#pragma once
// The state of a run as bytes, its hash, and what tells one scene from another; all from the registry.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "model/model.h"
#include "model/state_visitor.h"

namespace talus {

// A saved state that cannot be used. The text is the reason, as in "got "x.state", which " + reason.
class StateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// FNV-1a, 64 bits (Fowler, Noll & Vo).
class Fnv {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};
std::string hex(std::uint64_t value);  // 16 digits

// Little-endian bytes, whatever the machine.
void append(std::string& bytes, std::uint64_t value);
void append(std::string& bytes, double value);
void append(std::string& bytes, std::string_view text);  // its length first

// Takes apart what append put together; throws StateError when there is less than asked for.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}
  std::uint64_t whole();
  double number();
  std::string text();
  bool done() const { return left_.empty(); }
  std::size_t left() const { return left_.size(); }

 private:
  std::string_view left_;
};

// The state as bytes: appended to a string.
class StateWriter : public StateVisitor {
 public:
  explicit StateWriter(Part part = Part::state) : StateVisitor(part) {}
  std::string bytes;

 protected:
  void take(double& value) override { append(bytes, value); }
  void take(std::int64_t& value) override { append(bytes, static_cast<std::uint64_t>(value)); }
  void take(std::string& value) override { append(bytes, std::string_view(value)); }
  void take_law(std::function<double(double)>& function) override { append(bytes, std::uint64_t(bool(function))); }
  void resize(std::size_t& count) override { append(bytes, std::uint64_t(count)); }
  void check_length(std::size_t count) override { append(bytes, std::uint64_t(count)); }
};

// Puts bytes back where StateWriter took them. Throws StateError when they do not fit, with the state half
// changed.
class StateReader : public StateVisitor {
 public:
  explicit StateReader(std::string_view bytes) : bytes_(bytes) {}
  explicit StateReader(std::string&& bytes) = delete;  // they are read later
  bool done() const { return bytes_.done(); }

 protected:
  void take(double& value) override { value = bytes_.number(); }
  void take(std::int64_t& value) override { value = static_cast<std::int64_t>(bytes_.whole()); }
  void take(std::string& value) override { value = bytes_.text(); }
  void take_law(std::function<double(double)>& function) override;
  void resize(std::size_t& count) override;
  void check_length(std::size_t count) override;

 private:
  ByteReader bytes_;
};

// Hash of the same bytes, with -0 taken for 0: two states that no step can tell apart.
class StateHasher : public StateWriter {
 public:
  using StateWriter::StateWriter;
  std::uint64_t value() const;

 protected:
  void take(double& value) override { append(bytes, value == 0 ? 0.0 : value); }
};

// Hash of names and types of what is registered: bytes can be read back only where it is the same.
class LayoutHasher : public StateVisitor {
 public:
  std::uint64_t value() const { return hash_.value(); }

 protected:
  void enter(const char* name) override { hash_.add(std::string(name) + ";"); }
  void take(double&) override { hash_.add("number;"); }
  void take(std::int64_t&) override { hash_.add("whole;"); }
  void take(std::string&) override { hash_.add("text;"); }
  void take_law(std::function<double(double)>&) override { hash_.add("law;"); }
  void resize(std::size_t&) override { hash_.add("list;"); }
  void check_length(std::size_t) override { hash_.add("table;"); }
  bool wants_types_only() const override { return true; }

 private:
  Fnv hash_;
};

// What a scene is, as built.
struct Fingerprint {
  std::int64_t blocks = 0, joints = 0, vertices = 0;
  std::uint64_t geometry = 0;  // constants of the model
  std::uint64_t values = 0;    // materials, joints, supports and loads as the script gave them
  std::uint64_t charges = 0;   // all of them that is no function
};
Fingerprint fingerprint(Model& model);
// Throws StateError naming what differs.
void check_same_scene(const Fingerprint& saved, const Fingerprint& present);

}  // namespace talus
