#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "equations/linear_solver.h"
#include "step/contact_pivots.h"

namespace talus {
namespace {

// A chain of blocks with a few couplings across it, so that its elimination tree has branches.
BlockMatrix coupled_blocks(const std::vector<int>& sizes, const std::vector<std::pair<int, int>>& pairs,
                           std::mt19937& random) {
  std::uniform_real_distribution<double> value(-1, 1);
  BlockMatrix matrix;
  matrix.set_pattern(sizes, pairs);
  const auto part = [&](int rows, int columns) {
    Eigen::MatrixXd m(rows, columns);
    for (Eigen::Index k = 0; k < m.size(); ++k) m(k) = value(random);
    return m;
  };
  for (int b = 0; b < int(sizes.size()); ++b) matrix.begin(b, 30 * Eigen::MatrixXd::Identity(sizes[b], sizes[b]));
  for (const auto& [a, b] : pairs)
    matrix.add(matrix.slot(a, b), false, part(sizes[std::min(a, b)], sizes[std::max(a, b)]));
  return matrix;
}

TEST(Compliance, IsWhatSolvesGive) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1, 1);
  const std::vector<int> sizes = {6, 6, 0, 3, 6, 6, 6, 12, 6, 6};
  const std::vector<std::pair<int, int>> pairs = {{0, 1}, {1, 3}, {3, 4}, {0, 5}, {5, 6},
                                                  {6, 7}, {8, 4}, {9, 8}, {9, 7}, {0, 8}};
  const BlockMatrix matrix = coupled_blocks(sizes, pairs, random);
  LinearSolver solver;
  solver.analyse(matrix);
  ASSERT_EQ(solver.factor(matrix), -1);
  std::vector<SparseColumn> columns;
  for (const auto& [a, b] : pairs) {
    SparseColumn column;
    for (const int block : {a, b})
      for (int k = 0; k < sizes[block]; ++k) {
        column.unknowns.push_back(matrix.block_begin()[block] + k);
        column.values.push_back(value(random));
      }
    columns.push_back(column);
  }
  Compliance compliance = solver.compliance();
  for (size_t first = 0; first < columns.size(); first += 4)  // what joins later finds the same
    compliance.add({columns.begin() + long(first), columns.begin() + long(std::min(first + 4, columns.size()))});
  const Eigen::MatrixXd& w = compliance.matrix();
  ASSERT_EQ(w.rows(), Eigen::Index(columns.size()));
  for (Eigen::Index a = 0; a < w.rows(); ++a) {
    Vector force = Vector::Zero(matrix.dimension()), x;
    for (size_t k = 0; k < columns[a].unknowns.size(); ++k) force[columns[a].unknowns[k]] += columns[a].values[k];
    solver.solve(force, x);
    for (Eigen::Index b = 0; b < w.cols(); ++b) {
      double moved = 0;
      for (size_t k = 0; k < columns[b].unknowns.size(); ++k) moved += columns[b].values[k] * x[columns[b].unknowns[k]];
      EXPECT_NEAR(w(b, a), moved, 1e-13);
    }
  }
}

// How far the forces are from the law, of the largest of them.
double off_the_law(const std::vector<PivotContact>& contacts, const Eigen::MatrixXd& w) {
  Vector forces(w.rows());
  for (Eigen::Index a = 0; 2 * a < w.rows(); ++a) forces.segment<2>(2 * a) << contacts[a].normal, -contacts[a].shear;
  const Vector moved = w * forces;
  double off = 0;
  for (Eigen::Index a = 0; 2 * a < w.rows(); ++a) {
    const PivotContact& c = contacts[a];
    const double normal = c.kn * std::max(0.0, -(c.gap0 + moved[2 * a])), limit = c.friction * normal + c.cohesion;
    const double shear = std::clamp(c.ks * (c.slide0 + moved[2 * a + 1]), -limit, limit);
    off = std::max({off, std::abs(c.normal - normal), std::abs(c.shear - shear)});
  }
  return off / forces.lpNorm<Eigen::Infinity>();
}

// Contacts a hundred times stiffer than what they are on, friction up to 63°, states guessed at random.
TEST(ContactPivots, MeetTheLawWhateverTheyBeginWith) {
  std::mt19937 random(3);
  std::normal_distribution<double> value(0, 1);
  std::uniform_real_distribution<double> part(0, 1);
  for (int problem = 0; problem < 400; ++problem) {
    const Eigen::Index count = 1 + problem % 24;
    Eigen::MatrixXd a(2 * count + 3, 2 * count);
    for (Eigen::Index k = 0; k < a.size(); ++k) a(k) = value(random);
    const Eigen::MatrixXd w = 1e-9 * a.transpose() * a;
    std::vector<PivotContact> contacts;
    for (Eigen::Index k = 0; k < count; ++k)
      contacts.push_back({1e-3 * value(random) - 5e-4, 1e-3 * value(random), 1e11, 4e10, 2 * part(random),
                          k % 3 == 0 ? 1e4 : 0.0, part(random) < 0.5, part(random) < 0.5, 0, value(random)});
    ASSERT_TRUE(pivot_contacts(contacts, w)) << problem;
    EXPECT_LT(off_the_law(contacts, w), 1e-7) << problem;
  }
}

// A block of weight P pushed by Q along its floor: it sticks to Q = P tan φ and slides beyond.
TEST(ContactPivots, StickAndSlide) {
  const double weight = 1000, friction = 0.5, soft = 1e-8;  // N, m/N
  const Eigen::MatrixXd w = soft * Eigen::MatrixXd::Identity(2, 2);
  for (const double push : {400.0, 600.0}) {
    std::vector<PivotContact> contact = {{-soft * weight, soft * push, 1e12, 1e12, friction, 0, false, false, 0, -1}};
    ASSERT_TRUE(pivot_contacts(contact, w));
    EXPECT_NEAR(contact[0].normal, weight, 0.2);
    EXPECT_NEAR(contact[0].shear, std::min(push, friction * contact[0].normal), 0.1);
    EXPECT_EQ(contact[0].stuck, push < 500);
  }
}

}  // namespace
}  // namespace talus
