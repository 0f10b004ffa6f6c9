#include <dlfcn.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "equations/block_matrix.h"
#include "equations/linear_solver.h"

namespace talus {
namespace {

using Dense = Eigen::MatrixXd;

// A random symmetric positive definite matrix on a random graph of blocks, in both forms.
struct RandomSystem {
  std::vector<int> sizes, begin;
  std::vector<std::pair<int, int>> pairs;
  BlockMatrix matrix;
  Dense dense;
  std::mt19937 random;

  RandomSystem(int blocks, unsigned seed) : random(seed) {
    std::uniform_int_distribution<int> size(0, 2), any(0, blocks - 1);
    int unknowns = 0;
    for (int b = 0; b < blocks; ++b) {
      sizes.push_back(3 * size(random));
      begin.push_back(unknowns);
      unknowns += sizes.back();
    }
    for (int k = 0; k < 3 * blocks; ++k) pairs.push_back({any(random), any(random)});
    EXPECT_TRUE(matrix.set_pattern(sizes, pairs));
    dense = Dense::Zero(unknowns, unknowns);
    fill();
  }

  // BᵀB of each pair and something on the diagonal.
  void fill() {
    dense.setZero();
    for (std::size_t b = 0; b < sizes.size(); ++b) {
      const Dense m = 0.1 * Dense::Identity(sizes[b], sizes[b]);
      matrix.begin(int(b), m);
      dense.block(begin[b], begin[b], sizes[b], sizes[b]) = m;
    }
    for (const auto& [a, b] : pairs) {
      if (a == b || !sizes[a] || !sizes[b]) continue;
      const Dense left = matrix_of(2, sizes[a]), right = matrix_of(2, sizes[b]);
      add(a, a, left.transpose() * left);
      add(b, b, right.transpose() * right);
      add(a, b, left.transpose() * right);
    }
  }
  // m belongs to (a, b) in this order, whichever is the row of the slot.
  void add(int a, int b, const Dense& m) {
    const BlockMatrix::Slot slot = matrix.slot(a, b);
    matrix.add(slot, slot.row != a, m);
    dense.block(begin[a], begin[b], sizes[a], sizes[b]) += m;
    if (a != b) dense.block(begin[b], begin[a], sizes[b], sizes[a]) += m.transpose();
  }
  Dense matrix_of(int rows, int columns) {
    std::normal_distribution<double> normal;
    return Dense::NullaryExpr(rows, columns, [&] { return normal(random); });
  }
  Vector vector() { return matrix_of(int(dense.rows()), 1); }
};

Vector product(const BlockMatrix& matrix, const Vector& x) {
  Vector y = Vector::Zero(x.size());
  matrix.multiply(x, y);
  return y;
}

// Σ of the blocks' parts.
double form(const BlockMatrix& matrix, const Vector& x, const Vector& y) {
  const auto of = [&](int block) {
    const int first = matrix.block_begin()[std::size_t(block)], size = matrix.sizes()[std::size_t(block)];
    return std::pair<Vector, Vector>(x.segment(first, size), y.segment(first, size));
  };
  double sum = 0;
  for (int b = 0; b < matrix.block_count(); ++b)
    if (matrix.slot(b, b).row >= 0) sum += matrix.form(b, of(b), of);
  return sum;
}

TEST(BlockMatrix, MultipliesLikeTheDenseOne) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    RandomSystem s(40, seed);
    const Vector x = s.vector(), expected = s.dense * x;
    EXPECT_EQ(s.matrix.dimension(), s.dense.rows());
    EXPECT_LT((product(s.matrix, x) - expected).norm(), 1e-13 * s.dense.norm() * x.norm());
  }
}

TEST(BlockMatrix, FormIsTheDenseOne) {
  RandomSystem s(40, 6);
  const Vector x = s.vector(), y = s.vector();
  EXPECT_NEAR(form(s.matrix, x, y), x.dot(s.dense * y), 1e-13 * s.dense.norm() * x.norm() * y.norm());
}

// What sleeps: its unknowns are numbered, and nothing of them is kept or read.
TEST(BlockMatrix, BlocksWithoutEntries) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix3d m = Eigen::Vector3d(4, 5, 6).asDiagonal();
  BlockMatrix matrix;
  EXPECT_TRUE(matrix.set_pattern({3, 3, 3, 3}, {{1, 3}}, {1, 3}));
  for (const int b : {1, 3}) matrix.add(matrix.slot(b, b), false, m);
  matrix.add(matrix.slot(1, 3), false, Eigen::Matrix3d::Ones().eval());
  Vector x(12), y = Vector::Zero(12);
  x << none, none, none, 1, 2, 3, none, none, none, 1, 0, 0;
  matrix.multiply(x, y);
  Vector expected(12);
  expected << 0, 0, 0, 5, 11, 19, 0, 0, 0, 10, 6, 6;
  EXPECT_EQ(y, expected);
  EXPECT_EQ(form(matrix, x, x), 5 + 22 + 57 + 10);
  BlockMatrix part;
  part.take_part(matrix, {1, 3}, {-1, 0, -1, 1});
  EXPECT_EQ(part.values, matrix.values);
  EXPECT_FALSE(matrix.set_pattern({3, 3, 3, 3}, {{3, 1}}, {1, 3}));
  EXPECT_TRUE(matrix.set_pattern({3, 3, 3, 3}, {{3, 1}}, {0, 1, 3}));
}

TEST(BlockMatrix, OuterProductsAreAddedInAnyOrderOfBlocks) {
  RandomSystem s(20, 3);
  int done = 0;
  for (const auto& [column, row] : s.matrix.pairs()) {
    const Vector u = s.matrix_of(s.sizes[row], 1), v = s.matrix_of(s.sizes[column], 1);
    s.matrix.add_outer(s.matrix.slot(column, row), 2.5, u.data(), v.data());
    s.dense.block(s.begin[row], s.begin[column], u.size(), v.size()) += 2.5 * u * v.transpose();
    s.dense.block(s.begin[column], s.begin[row], v.size(), u.size()) += 2.5 * v * u.transpose();
    s.matrix.add_outer(s.matrix.slot(row, row), 0.5, u.data(), u.data());
    s.dense.block(s.begin[row], s.begin[row], u.size(), u.size()) += 0.5 * u * u.transpose();
    ++done;
  }
  ASSERT_GT(done, 5);
  const Vector x = s.vector();
  EXPECT_LT((product(s.matrix, x) - s.dense * x).norm(), 1e-13 * s.dense.norm() * x.norm());
}

TEST(BlockMatrix, PatternIsKeptWhileItIsTheSame) {
  RandomSystem s(20, 4);
  auto shuffled = s.pairs;
  std::shuffle(shuffled.begin(), shuffled.end(), s.random);
  for (auto& [a, b] : shuffled) std::swap(a, b);
  shuffled.push_back(shuffled.front());
  shuffled.push_back({7, 7});
  EXPECT_FALSE(s.matrix.set_pattern(s.sizes, shuffled));
  const Vector x = s.vector();
  EXPECT_LT((product(s.matrix, x) - s.dense * x).norm(),
            1e-13 * s.dense.norm() * x.norm());  // values are kept too
  shuffled.clear();
  EXPECT_TRUE(s.matrix.set_pattern(s.sizes, shuffled));
  auto larger = s.sizes;
  larger.push_back(6);
  EXPECT_TRUE(s.matrix.set_pattern(larger, {}));
}

TEST(BlockMatrix, PairsThatWereNotGivenHaveNoSlot) {
  BlockMatrix matrix;
  matrix.set_pattern({3, 6, 0, 6}, {{3, 0}, {2, 1}});
  EXPECT_EQ(matrix.slot(0, 3).column, 3);
  EXPECT_EQ(matrix.slot(3, 0).column, 3);
  EXPECT_EQ(matrix.slot(0, 1).row, -1);
  EXPECT_EQ(matrix.slot(1, 2).row, -1);  // a held block has no unknowns
  const int blocks[] = {0, 0, 0, 1, 1, 1, 1, 1, 1, 3, 3, 3, 3, 3, 3};
  for (int u = 0; u < 15; ++u) EXPECT_EQ(matrix.block_of_unknown(u), blocks[u]) << u;
}

// Round-off times the condition number, which stays below 1e4 here.
TEST(LinearSolver, SolvesRandomSystems) {
  for (int blocks : {1, 2, 7, 60}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      RandomSystem s(blocks, seed);
      if (s.dense.rows() == 0) continue;
      LinearSolver solver;
      solver.analyse(s.matrix);
      ASSERT_EQ(solver.factor(s.matrix), -1);
      const Vector b = s.vector(), expected = s.dense.llt().solve(b);
      Vector x;
      solver.solve(b, x);
      EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm()) << blocks << " blocks, seed " << seed;
    }
  }
}

TEST(LinearSolver, TheOrderServesNewValues) {
  RandomSystem s(60, 9);
  LinearSolver solver;
  solver.analyse(s.matrix);
  Vector x;
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(solver.factor(s.matrix), -1);
    const Vector b = s.vector(), expected = s.dense.llt().solve(b);
    solver.solve(b, x);
    EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm());
    s.fill();
  }
  EXPECT_EQ(solver.factorisations, 3);
}

// Single precision: 6e-8 of each number, times the condition number. The size of the numbers is nothing to it.
TEST(LinearSolver, SolvesCoarselyAfterTheFirst) {
  for (int blocks : {1, 7, 60, 300})
    for (const double unit : {1e-9, 1.0, 1e12}) {
      RandomSystem s(blocks, 3);
      if (s.dense.rows() == 0) continue;
      for (double& value : s.matrix.values) value *= unit;
      LinearSolver solver;
      solver.analyse(s.matrix);
      ASSERT_EQ(solver.factor(s.matrix), -1);
      Vector x;
      double off = 0;
      for (int k = 0; k < 4; ++k) {
        const Vector b = s.vector(), expected = s.dense.llt().solve(b) / unit;
        solver.solve_coarsely(b, x);
        if (k == 0) {
          EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm());
        }
        off = std::max(off, (x - expected).norm() / expected.norm());
      }
      EXPECT_LT(off, 1e-4) << blocks << " blocks, times " << unit;
      EXPECT_GT(off, 1e-10) << "not in single precision";
      solver.solve_coarsely(Vector::Zero(s.dense.rows()), x);
      EXPECT_EQ(x, Vector::Zero(s.dense.rows()));
    }
}

// By the part of the factor that leads from a few unknowns to the root: the same to the bit, whatever was solved
// before.
TEST(LinearSolver, SolvesCoarselyForAFewUnknowns) {
  for (int blocks : {1, 7, 60, 300}) {
    RandomSystem s(blocks, 3);
    const int size = int(s.dense.rows());
    if (size == 0) continue;
    LinearSolver solver;
    solver.analyse(s.matrix);
    ASSERT_EQ(solver.factor(s.matrix), -1);
    Vector whole, part;
    solver.solve_coarsely(s.vector(), whole);
    for (int step : {1, 5, 50, 1000}) {
      std::vector<int> unknowns;
      Vector b = Vector::Zero(size);
      const Vector values = s.vector();
      for (int k = size / 3; k < size; k += step) {
        unknowns.push_back(k);
        b[k] = values[k];
      }
      solver.solve_coarsely(s.vector(), whole);
      solver.solve_coarsely(b, whole);
      solver.solve_coarsely(b, part, solver.part(unknowns));
      for (const int k : unknowns) EXPECT_EQ(part[k], whole[k]) << "unknown " << k << " of " << size;
      solver.solve_coarsely(Vector::Zero(size), part, solver.part(unknowns));
      for (const int k : unknowns) EXPECT_EQ(part[k], 0);
    }
  }
}

// Where single precision has no digit left, and where its range ends, all solves are exact.
TEST(LinearSolver, SolvesNotCoarselyWhatThatSpoils) {
  RandomSystem random(2, 1);
  // with stiffnesses of 1 to spread along its columns
  const Dense u = random.matrix_of(12, 12).householderQr().householderQ();
  const Vector solution = random.matrix_of(12, 1);
  for (const auto& [spread, unit] : {std::pair{1e12, 1.0}, {1.0, 1e40}, {1.0, 1e-40}}) {
    const Vector stiffness = Vector::LinSpaced(12, 0, std::log(spread)).array().exp() * unit;
    const Dense all = u * stiffness.asDiagonal() * u.transpose();
    const Vector b = all * solution;  // mostly of what is stiff: its rounding goes into what is soft
    BlockMatrix matrix;
    matrix.set_pattern({6, 6}, {{0, 1}});
    for (int block : {0, 1}) matrix.add(matrix.slot(block, block), false, all.block(6 * block, 6 * block, 6, 6));
    matrix.add(matrix.slot(1, 0), false, all.block(0, 6, 6, 6));
    LinearSolver solver;
    solver.analyse(matrix);
    ASSERT_EQ(solver.factor(matrix), -1);
    Vector exact, x;
    solver.solve(b, exact);
    for (int k = 0; k < 3; ++k) {
      solver.solve_coarsely(b, x);
      EXPECT_EQ(x, exact) << "spread " << spread << ", times " << unit;
    }
  }
}

// Whatever comes before it in the order has a factor; its own pivots have none.
TEST(LinearSolver, NamesTheBlockThatIsNotHeld) {
  for (int block = 0; block < 30; ++block) {
    RandomSystem s(30, 2);
    if (s.sizes[block] == 0) continue;
    LinearSolver solver;
    solver.analyse(s.matrix);
    const Dense push = 1e3 * Dense::Identity(s.sizes[block], s.sizes[block]);
    s.add(block, block, -push);
    EXPECT_EQ(solver.factor(s.matrix), block);
    const Vector b = s.vector();
    Vector x;
    EXPECT_THROW(solver.solve(b, x), std::logic_error);
    s.add(block, block, 2 * push);
    ASSERT_EQ(solver.factor(s.matrix), -1);  // a bad factor leaves no trace
    solver.solve(b, x);
    EXPECT_LT((s.dense * x - b).norm(), 1e-10 * b.norm());
  }
}

// Nothing at all holds it: pivots of exactly nought.
TEST(LinearSolver, NamesABlockWithoutStiffness) {
  BlockMatrix matrix;
  matrix.set_pattern({0, 6, 3, 6}, {{1, 2}, {0, 3}});
  for (int b : {1, 3}) matrix.add(matrix.slot(b, b), false, Dense::Identity(6, 6));
  LinearSolver solver;
  solver.analyse(matrix);
  EXPECT_EQ(solver.factor(matrix), 2);
}

// A scene whose blocks are all held.
TEST(LinearSolver, NothingToSolve) {
  BlockMatrix matrix;
  matrix.set_pattern({0, 0}, {{0, 1}});
  EXPECT_EQ(matrix.dimension(), 0);
  LinearSolver solver;
  solver.analyse(matrix);
  EXPECT_EQ(solver.factor(matrix), -1);
  Vector x;
  solver.solve(Vector(0), x);
  EXPECT_EQ(x.size(), 0);
}

// What CHOLMOD, which is loaded later, finds under the name that compilers give parallel regions.
TEST(LinearSolver, ParallelRegionsRunOnceInTheThreadThatComesToThem) {
  using Region = void (*)(void*);
  const auto run = reinterpret_cast<void (*)(Region, void*, unsigned, unsigned)>(dlsym(RTLD_DEFAULT, "GOMP_parallel"));
  ASSERT_NE(run, nullptr);
  std::vector<std::thread::id> threads;
  run([](void* list) { static_cast<std::vector<std::thread::id>*>(list)->push_back(std::this_thread::get_id()); },
      &threads, 4, 0);
  EXPECT_EQ(threads, std::vector{std::this_thread::get_id()});
}

}  // namespace
}  // namespace talus
