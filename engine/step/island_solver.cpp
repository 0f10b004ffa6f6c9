#include "step/island_solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace talus {

namespace {

// Solutions in a row, of which all but the first are looked for by the splitting without trying Newton's steps before
// it: a wall of 1600 bricks, 1 s from zero gaps, takes 5.8 s of CPU instead of 6.5 with 8 and 8 to 10 with 1.
constexpr int splits_in_a_row = 16;

}  // namespace

struct IslandSolver::Step {
  const Model& model;
  const System& system;
  const ContactTerms& contacts;
  const OpenCloseSettings& settings;
  double dt;
  const Vector& start;  // or empty
  int moving;           // blocks that are not held
};

void IslandSolver::find(const Model& model, const ContactTerms& contacts, bool together) {
  place_.resize(model.shapes.size());
  islands_.find(model, contacts, together);
  at_rest_.assign(size_t(islands_.count()), Rest::moves);
}

IslandResult IslandSolver::solve(const Model& model, const System& system, const ContactTerms& contacts,
                                 const OpenCloseSettings& settings, double dt, Vector& d) {
  IslandResult result;
  result.converged = true;
  Vector start;
  start.swap(d);
  if (reached_.size() != model.contacts.size()) reached_.assign(model.contacts.size(), {-1, 0});
  d.setZero(system.force.size());
  const int moving = int(model.shapes.size() - model.held_blocks.size());
  const Step step{model, system, contacts, settings, dt, start, moving};
  converged_.assign(size_t(islands_.count()), 1);
  missed_.clear();
  ++solve_;
  // One that fails cuts the step of all; in equilibrium it is held harder, and the others go on.
  const auto gives_up = [&](const IslandResult& so_far) {
    return !so_far.converged && !so_far.missed && (settings.motion || so_far.singular_block >= 0);
  };
  for (int island = 0; island < islands_.count() && !gives_up(result); ++island) {
    if (dt > 0) at_rest_[island] = judge_rest(step, island);
    if (at_rest_[island] != Rest::moves) {
      ++result.islands.at_rest;
    } else if (!settings.motion || settings.solver == ContactSolver::factor || !solve_single(step, island, result, d)) {
      solve_together(step, island, result, d);
    }
  }
  if (result.converged) watch(step, d, result);
  if (!result.missed) reached_.clear();
  if (result.converged) {
    std::erase_if(kept_, [this](const auto& entry) { return entry.second->solve != solve_; });
    std::erase_if(standing_, [this](const Standing& standing) { return standing.solve != solve_; });
  }
  return result;
}

IslandResult IslandSolver::rest_on(const System& system, Vector& d) const {
  IslandResult result;
  result.converged = true;
  result.islands.at_rest = islands_.count();
  d.setZero(system.force.size());
  return result;
}

OpenCloseResult IslandSolver::judge(const Model& model, const System& system, const ContactTerms& contacts,
                                    double enough) {
  OpenCloseResult worst;
  for (int island = 0; island < islands_.count(); ++island) {
    judged_.take(model, system, contacts, islands_.blocks(island), islands_.rows(island), place_);
    const OpenCloseResult own = open_close_.judge(judged_);
    if (own.residual <= enough) at_rest_[island] = Rest::rests;
    if (island == 0 || !(own.residual <= worst.residual)) worst = own;
  }
  return worst;
}

// Whether nothing moves by more in a step than places are rounded to, and all forces balance as they are. Nothing
// has to be solved then, and round-off is not chased from step to step.
Rest IslandSolver::judge_rest(const Step& step, int island) {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  Rest rest = Rest::rests;
  for (const int b : islands_.blocks(island)) {
    const BlockState& state = step.model.blocks[b];
    const double size = step.model.size_of(state.centroid);
    for (const double rate : state.velocity) {
      if (std::abs(rate) * step.dt > rounding * size) return Rest::moves;
      if (rate != 0) rest = Rest::settles;
    }
  }
  judged_.take(step.model, step.system, step.contacts, islands_.blocks(island), islands_.rows(island), place_);
  return open_close_.judge(judged_).residual <= step.settings.tolerance ? rest : Rest::moves;
}

// A block in flight. Its own matrix is well conditioned unless supports hold it, where its residual may not do.
bool IslandSolver::solve_single(const Step& step, int island, IslandResult& result, Vector& d) {
  if (!islands_.single(island)) return false;
  for (const int b : islands_.blocks(island)) {
    const BlockShape& shape = step.model.shapes[b];
    if (shape.dofs == 0) continue;
    const bool solved = with_size(shape.second_order(), [&](auto n) {
      MatrixOf<n> matrix = MatrixOf<n>::Identity();
      step.system.matrix.diagonal(b, matrix);
      ColumnOf<n> force = ColumnOf<n>::Zero();
      force.head(shape.dofs) = step.system.force.segment(shape.dof_begin, shape.dofs);
      const ColumnOf<n> own = matrix.llt().solve(force);
      const double out = (force - matrix * own).norm() - step.system.force_rounding[b];
      if (!(out <= step.settings.tolerance * step.system.force_scale[b])) return false;
      if (out > 0) result.residual = std::max(result.residual, out / step.system.force_scale[b]);
      d.segment(shape.dof_begin, shape.dofs) = own.head(shape.dofs);
      return true;
    });
    if (!solved) return false;
  }
  ++result.islands.single;
  return true;
}

// Of an island that was not split, or of which other blocks touch now: none.
IslandSolver::Standing IslandSolver::standing_of(int first, const ContactProblem& problem) const {
  std::int64_t touching = std::int64_t(problem.blocks.size());
  for (const auto& [column, row] : problem.system.matrix.pairs())  // FNV-1a
    for (const int block : {column, row})
      touching = std::int64_t((std::uint64_t(touching) ^ std::uint64_t(block)) * 0x100000001b3U);
  for (const Standing& standing : standing_)
    if (standing.first == first && standing.touching == touching) return standing;
  return {.first = first, .touching = touching};
}

void IslandSolver::solve_together(const Step& step, int island, IslandResult& result, Vector& d) {
  auto& kept = kept_[islands_.first(island)];
  if (!kept) kept = std::make_unique<Kept>();
  kept->solve = solve_;
  ContactProblem& problem = kept->problem;
  problem.take(step.model, step.system, step.contacts, islands_.blocks(island), islands_.rows(island), place_);
  problem.take_matrix(step.system, place_);
  const auto& rows = problem.contacts.rows();
  Vector own_d;
  std::vector<ContactForces> reached;
  if (step.start.size() > 0) {
    for (const ContactRows& row : rows) reached.push_back(reached_[size_t(row.contact)]);
    own_d.resize(problem.system.force.size());
    for (size_t l = 0; l < problem.blocks.size(); ++l)
      own_d.segment(problem.dof_begin[l], problem.dofs[l]) =
          step.start.segment(step.model.shapes[problem.blocks[l]].dof_begin, problem.dofs[l]);
  }
  const long before = problem.solver.factorisations;
  OpenCloseSettings settings = step.settings;
  Standing standing = standing_of(islands_.first(island), problem);
  settings.split = standing.splits % splits_in_a_row > 0;
  settings.steady = standing.steady;
  OpenCloseResult own = open_close_.solve(problem, settings, own_d, reached);
  std::erase_if(standing_, [&](const Standing& old) { return old.first == standing.first; });
  if (own.split || own.steady) {
    standing.splits = own.split ? standing.splits + 1 : 0;
    standing.steady = own.steady;
    standing.solve = solve_;
    standing_.push_back(standing);
  }
  if (!own_d.allFinite()) own.converged = false;
  for (size_t l = 0; l < problem.blocks.size(); ++l)
    d.segment(step.model.shapes[problem.blocks[l]].dof_begin, problem.dofs[l]) =
        own_d.segment(problem.dof_begin[l], problem.dofs[l]);
  result.solves += own.iterations;
  result.sweeps += own.sweeps;
  result.splittings += own.splittings;
  result.pivots += own.pivots;
  result.factorisations += problem.solver.factorisations - before;
  const double part = double(problem.blocks.size()) / double(std::max(1, step.moving));
  result.total_effort += (own.effort() - own.in_vain) * part;
  if (own.split && standing.splits == 1) result.split_anew += part;
  ++(own.iterations == 0 ? result.islands.by_sweeps : result.islands.with_factor);
  result.iterations = std::max(result.iterations, own.iterations);
  if (!own.converged || !(own.residual <= result.residual)) {
    result.residual = own.residual;
    result.worst_block = own.worst_block;
  }
  if (own.converged) return;
  converged_[island] = 0;
  result.converged = false;
  result.missed = own.missed;
  result.singular_block = own.singular_block;
  if (!own.missed) return;
  missed_.insert(missed_.end(), problem.blocks.begin(), problem.blocks.end());
  for (size_t k = 0; k < rows.size(); ++k) reached_[size_t(rows[k].contact)] = open_close_.forces(k);
}

// Contacts that no island was solved with: they tie two of them, or press on a block taken for single.
void IslandSolver::watch(const Step& step, const Vector& d, IslandResult& result) {
  const auto pressed = [&](int k) {
    const ContactRows& row = step.contacts.rows()[k];
    if (row.near || step.contacts.gap(row, d) >= 0) return;
    result.missed = true;
    result.converged = false;
    for (const int b : {row.i, row.j}) missed_.push_back(b);
  };
  for (const int k : islands_.rows_between()) pressed(k);
  for (int island = 0; island < islands_.count(); ++island)
    if (islands_.single(island) && at_rest_[island] == Rest::moves)
      for (const int k : islands_.rows(island)) pressed(k);
}

void IslandSolver::store(Model& model, const ContactTerms& contacts, const Vector& d, bool motion) const {
  const auto left = [this](int block) { return islands_.of(block) < 0 || rest(block) == Rest::rests; };
  for (const ContactRows& row : contacts.rows()) {
    Contact& contact = model.contacts[row.contact];
    contact.deeper = 0;
    if (left(row.i) && left(row.j)) continue;
    OpenClose::store(contacts, row, d, contact);
    if (motion) contact.end_sliding();
  }
}

}  // namespace talus
