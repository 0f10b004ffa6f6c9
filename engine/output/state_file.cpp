#include "output/state_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "output/files.h"
#include "scene/version.h"

namespace talus {

namespace {

constexpr std::string_view magic = "talus saved state\n";
// 2: the generator of random numbers too; 3: checksum by eights; 4: charges of the scene; 5: where blocks are weighed;
// 6: gas fronts by their holes; 8: what was unexplained before the script changed something; 9: bonds judged where an
// attempt led; 10: steps in motion and load steps apart; 11: how held blocks get faster; 12: the largest strain; 13:
// loads within a jump; 14: what contacts climb; 15: what they were pressed by as a load step began; 16: what a script
// has changed since; 17: what contacts slid by in the last step; 18: no block is weighed apart; 19: what smooth
// contacts climbed in a load step; 20: second-order blocks whose edges bend; 21: joints on several sides;
// 22: islands whose contacts keep their states; 23: gradients of the initial stress
constexpr std::uint64_t format = 23;

// FNV-1a by eight bytes at a time, an eighth of the time: each step is a bijection, so that no single change goes
// unseen.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 14695981039346656037u;
  ByteReader eights(bytes.substr(0, bytes.size() / 8 * 8));
  while (!eights.done()) sum = (sum ^ eights.whole()) * 1099511628211u;
  Fnv rest;
  rest.add(bytes.substr(bytes.size() / 8 * 8));
  return sum ^ rest.value();
}

std::string content(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  if (!file || !(bytes << file.rdbuf()))
    throw StateError(std::string("cannot be read (") + (errno != 0 ? std::strerror(errno) : "it is empty") + ")");
  return bytes.str();
}

}  // namespace

std::string own_version() {
  return std::string(version) + " (" + commit + ")";
}

void write_state(const std::string& path, const SavedRun& saved) {
  std::string body;
  body.reserve(saved.engine.size() + saved.output.size() + saved.script.size() + 1024);
  append(body, std::string_view(saved.talus));
  append(body, saved.layout);
  append(body, std::uint64_t(saved.simulation));
  append(body, std::uint64_t(saved.step));
  append(body, saved.time);
  for (const std::int64_t count : {saved.scene.blocks, saved.scene.joints, saved.scene.vertices})
    append(body, std::uint64_t(count));
  append(body, saved.scene.geometry);
  append(body, saved.scene.values);
  append(body, saved.scene.charges);
  for (const std::string* part : {&saved.engine, &saved.output, &saved.script}) append(body, std::string_view(*part));
  std::string bytes;
  bytes.reserve(body.size() + 64);
  bytes += magic;
  append(bytes, format);
  append(bytes, std::string_view(body));
  append(bytes, checksum(bytes));
  write_durably(path, bytes);
}

bool is_state_file(const std::string& path) {
  std::string head(magic.size(), 0);
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), std::streamsize(head.size()));
  return file && head == magic;
}

SavedRun read_state(const std::string& path) {
  const std::string bytes = content(path);
  if (!bytes.starts_with(magic)) throw StateError("is no saved state of Talus");
  ByteReader outer(std::string_view(bytes).substr(magic.size()));
  if (const std::uint64_t given = outer.whole(); given != format)
    throw StateError("is of format " + std::to_string(given) + "; this Talus reads format " + std::to_string(format));
  const std::string body = outer.text();
  const std::uint64_t sum = outer.whole();
  if (!outer.done() || sum != checksum(std::string_view(bytes).substr(0, bytes.size() - 8)))
    throw StateError("is damaged: its checksum does not fit");
  SavedRun saved;
  ByteReader reader(body);
  saved.talus = reader.text();
  saved.layout = reader.whole();
  saved.simulation = int(reader.whole());
  saved.step = long(reader.whole());
  saved.time = reader.number();
  for (std::int64_t* count : {&saved.scene.blocks, &saved.scene.joints, &saved.scene.vertices})
    *count = std::int64_t(reader.whole());
  saved.scene.geometry = reader.whole();
  saved.scene.values = reader.whole();
  saved.scene.charges = reader.whole();
  for (std::string* part : {&saved.engine, &saved.output, &saved.script}) *part = reader.text();
  return saved;
}

}  // namespace talus
