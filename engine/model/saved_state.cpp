#include "model/saved_state.h"

#include <bit>

#include "model/registry.h"

namespace talus {

std::string hex(std::uint64_t value) {
  std::string text(16, '0');
  for (int i = 15; i >= 0; --i, value >>= 4) text[std::size_t(i)] = "0123456789abcdef"[value & 15];
  return text;
}

void append(std::string& bytes, std::uint64_t value) {
  char eight[8];
  for (int i = 0; i < 8; ++i, value >>= 8) eight[i] = static_cast<char>(value & 255);
  bytes.append(eight, sizeof eight);
}

void append(std::string& bytes, double value) {
  append(bytes, std::bit_cast<std::uint64_t>(value));
}

void append(std::string& bytes, std::string_view text) {
  append(bytes, std::uint64_t(text.size()));
  bytes += text;
}

std::uint64_t ByteReader::whole() {
  if (left_.size() < 8) throw StateError("is cut short");
  std::uint64_t value = 0;
  for (int i = 7; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(left_[std::size_t(i)]);
  left_.remove_prefix(8);
  return value;
}

double ByteReader::number() {
  return std::bit_cast<double>(whole());
}

std::string ByteReader::text() {
  const std::uint64_t size = whole();
  if (size > left_.size()) throw StateError("is cut short");
  const std::string text(left_.substr(0, size));
  left_.remove_prefix(size);
  return text;
}

void StateReader::take_law(std::function<double(double)>& function) {
  const bool was_there = bytes_.whole() != 0;
  if (was_there && !function) throw StateError("has a load or support by a function that this scene does not give");
  if (!was_there) function = nullptr;
}

void StateReader::resize(std::size_t& count) {
  const std::uint64_t saved = bytes_.whole();
  if (saved > bytes_.left()) throw StateError("is cut short");  // before memory is asked for
  count = saved;
}

void StateReader::check_length(std::size_t count) {
  if (bytes_.whole() != count) throw StateError("has tables of other lengths than this scene");
}

std::uint64_t StateHasher::value() const {
  Fnv hash;
  hash.add(bytes);
  return hash.value();
}

Fingerprint fingerprint(Model& model) {
  StateHasher geometry(StateVisitor::Part::constant), values;
  visit_state(model, geometry);
  visit_values(model.scene, values);
  StateHasher charges;
  visit_charges(model.scene, charges);
  return {.blocks = std::int64_t(model.shapes.size()),
          .joints = std::int64_t(model.joints.size()),
          .vertices = std::int64_t(model.reference_vertex.size()),
          .geometry = geometry.value(),
          .values = values.value(),
          .charges = charges.value()};
}

void check_same_scene(const Fingerprint& saved, const Fingerprint& present) {
  const auto sizes = [](const Fingerprint& of) {
    return std::to_string(of.blocks) + " blocks, " + std::to_string(of.joints) + " bonds and " +
           std::to_string(of.vertices) + " corners";
  };
  if (sizes(saved) != sizes(present))
    throw StateError("was saved from a scene of " + sizes(saved) + "; this one has " + sizes(present));
  if (saved.geometry != present.geometry)
    throw StateError("was saved from a scene whose blocks, supports or gravity were others than this one's");
  if (saved.values != present.values)
    throw StateError(
        "was saved from a scene whose materials, joints, supports or loads were given other values; give them as "
        "then, and change them after the restore");
  if (saved.charges != present.charges)
    throw StateError(
        "was saved from a scene whose charges were others than this one's: their names, holes, delays, and all that is given by "
        "numbers must be as then");
}

}  // namespace talus
