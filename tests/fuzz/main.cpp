// fuzz TARGET RUNS [SEED]: inputs made from the corpus (tests/fuzz/corpus/TARGET) by a fixed seed; RUNS may be 30s. A
// crash, a hang (20 s of CPU) or an exception that the target does not document leaves the input in fuzz_TARGET.input;
// `fuzz TARGET FILE` runs it again.
#include <sys/time.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "targets.h"

namespace talus::fuzz {
namespace {

std::string current, kept_in;

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

void keep(const char* why) {
  if (std::FILE* file = std::fopen(kept_in.c_str(), "wb")) {
    std::fwrite(current.data(), 1, current.size(), file);
    std::fclose(file);
  }
  std::fprintf(stdout, "FAIL  %s: input in %s\n", why, kept_in.c_str());
  std::fflush(stdout);
}

void on_signal(int number) {
  std::signal(number, SIG_DFL);
  keep(number == SIGPROF ? "hang" : "crash");
  std::raise(number);
}

std::string mutated(const std::string& base, const std::vector<std::string>& corpus, const Target& target,
                    Random& random) {
  std::string bytes = base;
  for (std::size_t round = 1 + random.below(4); round > 0; --round) {
    const std::size_t at = random.below(bytes.size() + 1),
                      length = random.below(std::min<std::size_t>(bytes.size() - at, 32) + 1);
    switch (random.below(8)) {
      case 0:
        if (at < bytes.size()) bytes[at] = char(random.next());
        break;
      case 1:
        if (at < bytes.size()) bytes[at] = char(bytes[at] ^ (1 << random.below(8)));
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:
        bytes.insert(at, target.words.empty() ? "\n" : target.words[random.below(target.words.size())]);
        break;
      case 6: {
        const std::string& other = corpus[random.below(corpus.size())];
        bytes = bytes.substr(0, at) + other.substr(random.below(other.size() + 1));
        break;
      }
      default:
        bytes.replace(at, length, std::to_string((random.unit() - 0.5) * (random.below(3) == 0 ? 1e300 : 20)));
        break;
    }
  }
  if (bytes.size() > 200000) bytes.resize(200000);
  return bytes;
}

bool run_one(const Target& target) {
  const itimerval limit = {.it_interval = {}, .it_value = {.tv_sec = 20, .tv_usec = 0}}, none = {};
  setitimer(ITIMER_PROF, &limit, nullptr);  // CPU time: a busy machine is no hang
  try {
    target.run(current);
  } catch (const std::exception& error) {
    keep(error.what());
    return false;
  }
  setitimer(ITIMER_PROF, &none, nullptr);
  return true;
}

int fuzz(const Target& target, const std::string& runs, std::uint64_t seed) {
  const std::filesystem::path folder = std::filesystem::path(TALUS_FUZZ_CORPUS) / target.name;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> corpus;
  for (const auto& file : files) corpus.push_back(content(file));
  if (corpus.empty()) corpus.emplace_back();
  const bool by_clock = runs.ends_with("s");
  const double amount = std::atof(runs.c_str());
  const std::time_t started = std::time(nullptr);
  Random random(seed);
  long done = 0;
  for (; by_clock ? double(std::time(nullptr) - started) < amount : double(done) < amount; ++done) {
    current = std::size_t(done) < corpus.size() ? corpus[std::size_t(done)]
                                                : mutated(corpus[random.below(corpus.size())], corpus, target, random);
    if (!run_one(target)) return 1;
  }
  std::printf("PASS  %s: %ld inputs from seed %llu\n", target.name, done, static_cast<unsigned long long>(seed));
  return 0;
}

}  // namespace
}  // namespace talus::fuzz

int main(int argc, char** argv) {
  using namespace talus::fuzz;
  for (const Target& target : targets()) {
    if (argc < 3 || std::string(argv[1]) != target.name) continue;
    kept_in = "fuzz_" + std::string(target.name) + ".input";
    for (const int number : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGPROF}) std::signal(number, on_signal);
    if (!std::filesystem::exists(argv[2]))
      return fuzz(target, argv[2], argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
    current = content(argv[2]);
    return run_one(target) ? 0 : 1;
  }
  std::fputs("fuzz TARGET RUNS|SECONDSs|FILE [SEED]; targets:", stderr);
  for (const Target& target : targets()) std::fprintf(stderr, " %s", target.name);
  std::fputs("\n", stderr);
  return 2;
}
