// What sweeps begin with: blocks in their own axes, patches of those that hang together, and the contacts on them in
// order.
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <tuple>

#include "model/sort_large.h"
#include "step/contact_sweeps.h"

namespace talus {

namespace {

template <int n>
ColumnOf<n> padded(const Row& row, int size) {
  ColumnOf<n> column = ColumnOf<n>::Zero();
  for (int k = 0; k < size; ++k) column[k] = row[size_t(k)];
  return column;
}

template <int n>
MatrixOf<n> inverse_of_lower(const MatrixOf<n>& lower) {
  MatrixOf<n> inverse = MatrixOf<n>::Zero();
  for (int column = 0; column < n; ++column)
    for (int row = column; row < n; ++row) {
      double left = row == column ? 1 : 0;
      for (int k = column; k < row; ++k) left -= lower(row, k) * inverse(k, column);
      inverse(row, column) = left / lower(row, row);
    }
  return inverse;
}

}  // namespace

template <int size>
void SweepsOf<size>::start(const ContactProblem& problem) {
  problem_ = &problem;
  const System& system = problem.system;
  factor_ = problem.contacts.factor();
  contacts_.clear();
  rows_.clear();
  moved_.clear();
  moved_block_.clear();
  blocks_.clear();
  lower_.clear();
  to_own_.clear();
  patches_.clear();
  std::vector<int> place(problem.blocks.size(), -1);
  for (size_t b = 0; b < place.size(); ++b)
    if (problem.dofs[b] > 0) {
      place[b] = int(blocks_.size());
      blocks_.push_back(int(b));
      Matrix own = Matrix::Identity();
      system.matrix.diagonal(int(b), own);
      const Eigen::LLT<Matrix> factored(own);
      lower_.push_back(factored.info() == Eigen::Success ? Matrix(factored.matrixL()) : Matrix(Matrix::Identity()));
      to_own_.push_back(inverse_of_lower<size>(lower_.back()));
    }
  const size_t count = blocks_.size();
  force_.assign(count + 1, Lanes<size>{});
  motion_.assign(count + 1, Lanes<size>{});
  for (size_t l = 0; l < count; ++l) {
    Column force = Column::Zero();
    force.head(problem.dofs[blocks_[l]]) =
        system.force.segment(problem.dof_begin[blocks_[l]], problem.dofs[blocks_[l]]);
    force_[l] = Lanes<size>::of(to_own_[l] * force);
  }
  find_patches(find_ties(place));
  const auto& rows = problem.contacts.rows();
  contacts_.reserve(rows.size());
  rows_.reserve(rows.size());
  for (size_t k = 0; k < rows.size(); ++k)
    if (rows[k].near && (place[rows[k].i] >= 0 || place[rows[k].j] >= 0)) add_link(rows[k], int(k), place);
  put_in_order();
  pack();
}

// Of each block, by what is stiff between it and others.
template <int size>
std::vector<std::vector<typename SweepsOf<size>::Tie>> SweepsOf<size>::find_ties(const std::vector<int>& place) const {
  const BlockMatrix& matrix = problem_->system.matrix;
  std::vector<std::vector<Tie>> ties(blocks_.size());
  Matrix coupling = Matrix::Zero();
  for (const auto& [column, row] : matrix.pairs()) {
    if (row == column || place[row] < 0 || place[column] < 0) continue;
    coupling.setZero();
    matrix.part(row, column, coupling);
    if (coupling.isZero(0)) continue;  // they only touch
    const int a = place[row], b = place[column];
    ties[a].push_back({b, coupling * to_own_[b].transpose()});
    ties[b].push_back({a, coupling.transpose() * to_own_[a].transpose()});
  }
  return ties;
}

// Blocks that hang together, a few at a time, breadth first.
template <int size>
void SweepsOf<size>::find_patches(std::vector<std::vector<Tie>> ties) {
  tied_.clear();
  const int count = int(blocks_.size());
  patch_of_.assign(size_t(count) + 1, -1);
  rank_.assign(size_t(count) + 1, 0);
  for (int first = 0; first < count; ++first) {
    if (patch_of_[first] >= 0) continue;
    const int own = int(patches_.size());
    Patch& patch = patches_.emplace_back();
    patch.blocks = {first};
    patch_of_[first] = own;
    for (size_t k = 0; k < patch.blocks.size(); ++k)
      for (const Tie& tie : ties[patch.blocks[k]]) {
        if (patch_of_[tie.other] >= 0 || patch.blocks.size() >= most_in_patch) continue;
        patch_of_[tie.other] = own;
        patch.blocks.push_back(tie.other);
      }
    const Eigen::Index members = Eigen::Index(patch.blocks.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(members * size, members * size);
    for (Eigen::Index k = 0; k < members; ++k) rank_[patch.blocks[k]] = int(k);
    Matrix part;
    for (Eigen::Index k = 0; k < members; ++k) {
      const int block = patch.blocks[k];
      part.setIdentity();
      problem_->system.matrix.diagonal(blocks_[block], part);
      matrix.template block<size, size>(k * size, k * size) = to_own_[block] * part * to_own_[block].transpose();
      for (const Tie& tie : ties[block])
        if (patch_of_[tie.other] == own)
          matrix.template block<size, size>(k * size, rank_[tie.other] * size) = to_own_[block] * tie.k;
      std::erase_if(ties[block], [&](const Tie& tie) { return patch_of_[tie.other] == own; });
      if (!ties[block].empty()) tied_.push_back({block, own, std::move(ties[block])});
    }
    patch.unit = members == 1 && !lower_[first].isIdentity(0);
    patch.inverse = patch.unit ? std::move(matrix) : Eigen::MatrixXd(matrix.inverse());
    for (Eigen::Index k = 0; k < members; ++k)
      for (int dof = problem_->dofs[blocks_[patch.blocks[k]]]; dof < size; ++dof)
        patch.inverse.col(k * size + dof).setZero();
  }
}

template <int size>
bool SweepsOf<size>::bonded() const {
  size_t patches = 0;
  for (size_t t = 0; t < tied_.size(); ++t) patches += t == 0 || tied_[t].patch != tied_[t - 1].patch;
  return 2 * patches > patches_.size();
}

template <int size>
void SweepsOf<size>::add_link(const ContactRows& row, int contact, const std::vector<int>& place) {
  const int held = int(blocks_.size());
  Link& link = contacts_.emplace_back();
  link.i = place[row.i] >= 0 ? place[row.i] : held;
  link.j = place[row.j] >= 0 ? place[row.j] : held;
  link.rows = int(rows_.size());
  SweptRows<size>& rows = rows_.emplace_back();
  const auto in_own_axes = [&](const Row& of, int block, int dofs) {
    return block == held ? Lanes<size>{} : Lanes<size>::of(to_own_[block] * padded<size>(of, dofs));
  };
  rows = {in_own_axes(row.normal_i, link.i, row.size_i), in_own_axes(row.normal_j, link.j, row.size_j),
          in_own_axes(row.shear_i, link.i, row.size_i), in_own_axes(row.shear_j, link.j, row.size_j)};
  link.moved_begin = int(moved_.size());
  const auto unit = [&](int block) { return block == held || patches_[patch_of_[block]].unit; };
  const SweptRows<size> moved = unit(link.i) && unit(link.j) ? rows : add_moved(link);
  link.moved_end = int(moved_.size());
  link.nn = factor_ * along(rows.ni, moved.ni, rows.nj, moved.nj);
  link.ns = factor_ * along(rows.ni, moved.si, rows.nj, moved.sj);
  link.ss = factor_ * along(rows.si, moved.si, rows.sj, moved.sj);
  link.law = SweptLaw(link.nn + 1 / row.kn, link.ns, link.ss + 1 / row.ks, row.friction, row.cohesion);
  link.contact = contact;
}

// What a contact on bonded blocks moves: all of their patches. Of the motions those of its own two blocks.
template <int size>
SweptRows<size> SweepsOf<size>::add_moved(const Link& link) {
  const int held = int(blocks_.size());
  SweptRows<size> rows = rows_[link.rows];
  struct Moved {
    int block;
    Lanes<size> n, s;
  };
  std::vector<Moved> all;
  for (const auto& [block, normal, shear] : {std::tuple{link.i, &rows.ni, &rows.si}, {link.j, &rows.nj, &rows.sj}}) {
    if (block == held) continue;
    const Patch& patch = patches_[patch_of_[block]];
    for (const int other : patch.blocks) {
      const auto inverse = patch.inverse.template block<size, size>(rank_[other] * size, rank_[block] * size);
      auto own = std::find_if(all.begin(), all.end(), [&](const Moved& moved) { return moved.block == other; });
      if (own == all.end()) own = all.insert(own, {other, {}, {}});
      own->n.column() += inverse * normal->column();
      own->s.column() += inverse * shear->column();
    }
  }
  SweptRows<size> of_own{};
  for (const Moved& moved : all) {
    SweptMotion<size>& motion = moved_.emplace_back();
    std::copy(std::begin(moved.n.v), std::end(moved.n.v), motion.n);
    std::copy(std::begin(moved.s.v), std::end(moved.s.v), motion.s);
    moved_block_.push_back(moved.block);
    if (moved.block == link.i) of_own.ni = moved.n, of_own.si = moved.s;
    if (moved.block == link.j) of_own.nj = moved.n, of_own.sj = moved.s;
  }
  return of_own;
}

// From one end of the island to the other: on its way a sweep takes along what it has found, where in any other order
// it goes from neighbour to neighbour a sweep each time.
template <int size>
void SweepsOf<size>::put_in_order() {
  if (contacts_.empty()) return;
  const auto place = [&](const Link& link) -> const Vec2& {
    return problem_->model->vertex[problem_->before(size_t(link.contact)).global_vertex];
  };
  Vec2 low = place(contacts_[0]), high = low;
  for (const Link& link : contacts_) {
    low = low.cwiseMin(place(link));
    high = high.cwiseMax(place(link));
  }
  Eigen::Index longer = 0;
  (high - low).maxCoeff(&longer);
  sort_large(contacts_, [&](const Link& link) { return place(link)[longer]; });
}

// Rows and what is moved in the order in which sweeps come by.
template <int size>
void SweepsOf<size>::pack() {
  std::vector<SweptRows<size>> rows;
  std::vector<SweptMotion<size>> moved;
  std::vector<int> moved_block;
  rows.reserve(rows_.size() + 1);
  moved.reserve(moved_.size());
  moved_block.reserve(moved_.size());
  for (Link& link : contacts_) {
    rows.push_back(rows_[link.rows]);
    link.rows = int(rows.size()) - 1;
    const int begin = link.moved_begin, end = link.moved_end;
    link.moved_begin = int(moved.size());
    moved.insert(moved.end(), moved_.begin() + begin, moved_.begin() + end);
    moved_block.insert(moved_block.end(), moved_block_.begin() + begin, moved_block_.begin() + end);
    link.moved_end = int(moved.size());
  }
  rows.push_back({});
  rows_ = std::move(rows);
  moved_ = std::move(moved);
  moved_block_ = std::move(moved_block);
}

template void SweepsOf<first_order_dofs>::start(const ContactProblem&);
template void SweepsOf<second_order_dofs>::start(const ContactProblem&);
template bool SweepsOf<first_order_dofs>::bonded() const;
template bool SweepsOf<second_order_dofs>::bonded() const;

void ContactSweeps::start(const ContactProblem& problem) {
  second_order_ = std::find(problem.dofs.begin(), problem.dofs.end(), second_order_dofs) != problem.dofs.end();
  if (second_order_)
    second_.start(problem);
  else
    first_.start(problem);
}

}  // namespace talus
