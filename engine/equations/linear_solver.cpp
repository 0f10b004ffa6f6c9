#include "equations/linear_solver.h"

#include <cholmod.h>
#include <dlfcn.h>
#include <omp.h>

#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "equations/supernodal_solve.h"

namespace talus {

namespace {

// What is used of CHOLMOD, which is loaded with the first solver: it and its BLAS take 5 ms, a third of what the
// program would take to start, and reading or checking a scene needs neither.
struct CholmodLibrary {
  void* handle;
  decltype(&cholmod_start) start;
  decltype(&cholmod_finish) finish;
  decltype(&cholmod_free_factor) free_factor;
  decltype(&cholmod_amd) amd;
  decltype(&cholmod_analyze_p) analyze_p;
  decltype(&cholmod_factorize) factorize;

  CholmodLibrary() {
    // OpenBLAS takes processors that are newer than itself for ones of 2004, at a quarter of their speed: told what to
    // use where nobody else has.
    const char* const core = __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") ? "SkylakeX"
                             : __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")        ? "Haswell"
                                                                                                      : nullptr;
    const Told core_type("OPENBLAS_CORETYPE", core);
    // the others would be started, and wait for work for some 0.1 s of CPU
    const Told threads("OPENBLAS_NUM_THREADS", "1");
    handle = dlopen(name().c_str(), RTLD_NOW | RTLD_LOCAL);
    find("cholmod_start", start);
    find("cholmod_finish", finish);
    find("cholmod_free_factor", free_factor);
    find("cholmod_amd", amd);
    find("cholmod_analyze_p", analyze_p);
    find("cholmod_factorize", factorize);
  }

 private:
  // A variable of the environment that OpenBLAS reads when it is loaded, unless the user has set it.
  class Told {
   public:
    Told(const char* variable, const char* value) : variable_(value && !getenv(variable) ? variable : nullptr) {
      if (variable_) setenv(variable_, value, 0);
    }
    ~Told() {
      if (variable_) unsetenv(variable_);
    }
    Told(const Told&) = delete;
    Told& operator=(const Told&) = delete;

   private:
    const char* variable_;
  };

  // The one whose header this file was compiled with: its structures are those of that version only.
  static std::string name() { return "libcholmod.so." + std::to_string(CHOLMOD_MAIN_VERSION); }

  template <class Function>
  void find(const char* function, Function& found) const {
    void* const place = handle ? dlsym(handle, function) : nullptr;
    if (!place) throw std::runtime_error(name() + " of SuiteSparse cannot be loaded: " + dlerror());
    found = reinterpret_cast<Function>(place);
  }
};

const CholmodLibrary& cholmod() {
  static const CholmodLibrary library;
  return library;
}

// CHOLMOD opens OpenMP teams that ignore OMP_NUM_THREADS; on two busy cores they cost 2–5 times what they save.
class OneThread {
 public:
  OneThread() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~OneThread() { omp_set_max_active_levels(levels_); }

 private:
  int levels_;
};

}  // namespace

struct LinearSolver::Cholmod {
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  bool good = false;
  SupernodalSolve exact;
  CoarseSolve coarse;
  enum class Coarse { untried, serves, fails } coarse_state = Coarse::untried;

  Cholmod() {
    cholmod().start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    // Where its BLAS is OpenBLAS: that one's own threads do not heed OpenMP's settings.
    void* const set_threads = dlsym(cholmod().handle, "openblas_set_num_threads");
    if (set_threads) reinterpret_cast<void (*)(int)>(set_threads)(1);
  }
  ~Cholmod() {
    cholmod().free_factor(&factor, &common);
    cholmod().finish(&common);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  // CHOLMOD reads these arrays and does not write them; its interface has no const.
  static cholmod_sparse view(const BlockMatrix& matrix) {
    cholmod_sparse a;
    std::memset(&a, 0, sizeof a);
    a.nrow = a.ncol = size_t(matrix.dimension());
    a.nzmax = matrix.row_index().size();
    a.p = const_cast<int*>(matrix.column_begin().data());
    a.i = const_cast<int*>(matrix.row_index().data());
    a.x = const_cast<double*>(matrix.values.data());
    a.stype = 1;
    a.itype = CHOLMOD_INT;
    a.xtype = CHOLMOD_REAL;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = 1;
    a.packed = 1;
    return a;
  }

  SupernodalFactor supernodes() const {
    const auto ints = [](const void* from, size_t count) { return std::span(static_cast<const int*>(from), count); };
    const cholmod_factor& l = *factor;
    return {ints(l.Perm, l.n),        ints(l.super, l.nsuper + 1), ints(l.pi, l.nsuper + 1),
            ints(l.px, l.nsuper + 1), ints(l.s, l.ssize),          std::span(static_cast<const double*>(l.x), l.xsize)};
  }

  // Approximate minimum degree of the graph of blocks, spread out to unknowns: 3–4 times cheaper than on the
  // unknowns themselves, and no worse a fill.
  std::vector<int> order(const BlockMatrix& matrix) {
    const int blocks = matrix.block_count();
    cholmod_sparse graph;
    std::memset(&graph, 0, sizeof graph);
    std::vector<int> begin(blocks + 1, 0), rows;
    rows.reserve(matrix.pairs().size());
    for (const auto& [column, row] : matrix.pairs()) {
      ++begin[column + 1];
      rows.push_back(row);
    }
    for (int b = 0; b < blocks; ++b) begin[b + 1] += begin[b];
    graph.nrow = graph.ncol = size_t(blocks);
    graph.nzmax = rows.size();
    graph.p = begin.data();
    graph.i = rows.data();
    graph.stype = 1;
    graph.itype = CHOLMOD_INT;
    graph.xtype = CHOLMOD_PATTERN;
    graph.dtype = CHOLMOD_DOUBLE;
    graph.sorted = graph.packed = 1;
    std::vector<int> block_order(blocks);
    cholmod().amd(&graph, nullptr, 0, block_order.data(), &common);
    std::vector<int> unknowns;
    unknowns.reserve(size_t(matrix.dimension()));
    for (int b : block_order)
      for (int k = 0; k < matrix.sizes()[b]; ++k) unknowns.push_back(matrix.block_begin()[b] + k);
    return unknowns;
  }
};

LinearSolver::LinearSolver() : cholmod_(std::make_unique<Cholmod>()) {}
LinearSolver::~LinearSolver() = default;

void LinearSolver::analyse(const BlockMatrix& matrix) {
  if (matrix.dimension() == 0) return;  // all blocks are held: CHOLMOD refuses an empty matrix
  OneThread one;
  cholmod_common* common = &cholmod_->common;
  cholmod().free_factor(&cholmod_->factor, common);
  std::vector<int> order = cholmod_->order(matrix);
  common->nmethods = 1;
  common->method[0].ordering = CHOLMOD_GIVEN;
  common->postorder = 1;
  cholmod_sparse a = Cholmod::view(matrix);
  cholmod_->factor = cholmod().analyze_p(&a, order.data(), nullptr, 0, common);
  if (!cholmod_->factor) throw std::bad_alloc();
  cholmod_->good = false;
}

int LinearSolver::factor(const BlockMatrix& matrix) {
  if (matrix.dimension() == 0) return -1;
  OneThread one;
  ++factorisations;
  cholmod_sparse a = Cholmod::view(matrix);
  cholmod().factorize(&a, cholmod_->factor, &cholmod_->common);
  if (cholmod_->common.status < 0) throw std::bad_alloc();
  cholmod_->good = cholmod_->common.status == CHOLMOD_OK;
  cholmod_->coarse_state = Cholmod::Coarse::untried;
  if (cholmod_->good) {
    cholmod_->exact.take(cholmod_->supernodes());
    return -1;
  }
  const int column = static_cast<int*>(cholmod_->factor->Perm)[cholmod_->factor->minor];
  return matrix.block_of_unknown(column);
}

void LinearSolver::solve(const Vector& b, Vector& x) {
  if (b.size() == 0) return;
  if (!cholmod_->good) throw std::logic_error("solve without a factor");
  cholmod_->exact.solve(b, x);
}

void LinearSolver::solve_coarsely(const Vector& b, Vector& x) {
  constexpr double allowed = 1e-4;  // of x
  auto& state = cholmod_->coarse_state;
  if (state == Cholmod::Coarse::serves) return cholmod_->coarse.solve(b, x);
  solve(b, x);
  if (b.isZero(0) || state == Cholmod::Coarse::fails) return;
  Vector coarse;
  state = Cholmod::Coarse::fails;
  if (!cholmod_->coarse.take(cholmod_->supernodes())) return;
  cholmod_->coarse.solve(b, coarse);
  if ((coarse - x).norm() <= allowed * x.norm()) state = Cholmod::Coarse::serves;
}

void LinearSolver::solve_coarsely(const Vector& b, Vector& x, const FactorPart& part) {
  if (cholmod_->coarse_state != Cholmod::Coarse::serves) return solve_coarsely(b, x);
  cholmod_->coarse.solve(b, x, part);
}

FactorPart LinearSolver::part(std::span<const int> unknowns) const {
  if (!cholmod_->good) throw std::logic_error("part without a factor");
  return part_of(cholmod_->supernodes(), unknowns);
}

Compliance LinearSolver::compliance() const {
  if (!cholmod_->good) throw std::logic_error("compliance without a factor");
  return Compliance(cholmod_->supernodes());
}

}  // namespace talus
