#pragma once
// What a run depends on: the engine, its parameters, and the files that its scene was made of, those of the Lua library
// among them. A finished run of which all this is as it was need not be made again.
#include <map>
#include <string>

#include "scene/study.h"
#include "sweep/outcome.h"

namespace talus {

class Keys {
 public:
  explicit Keys(const Study& study);
  std::uint64_t of(std::size_t run) const;  // engine, scene's name and parameters
  // Whether the outcome is of this run as it would be made now. Files are looked at once.
  bool same(std::size_t run, const Outcome& outcome);
  // What --inputs has written.
  std::vector<InputFile> read_inputs(const std::string& list) const;

 private:
  const Study& study_;
  std::string scene_folder_, library_;
  std::string common_;
  std::map<std::string, std::uint64_t> hashes_;
};

}  // namespace talus
