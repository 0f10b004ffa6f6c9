#pragma once
// Contacts at the configuration of linearisation: what each feels of the unknowns, and the law between gap,
// sliding and force. The law is a spring pressed by max(0, -(gap + offset)), and a shear spring whose force
// returns to the Coulomb cone |t| <= N tan φ + c·length (return mapping; the elastic part is kept as `stretch`).
#include <cmath>
#include <span>

#include "equations/system.h"

namespace talus {

// m, that a gap may be off as the difference of two places: these are as large as the scene, or as far from its middle
// as they are.
double rounding_of_gap(const Model& model, const Contact& contact);

// By how much what slides `way`, m, rises for each m of it towards the height of the face that it has come on to, where
// nothing holds it back.
double full_climb(const Model& model, const Contact& contact, double way);

struct ContactScalars {
  int i, j;  // blocks
  int dof_i, dof_j, size_i, size_j;
  double gap0, slide0;  // gap and stretch at d = 0, velocities carried to where contacts are judged
  double rounding;      // m, of gap0; none where that is no difference of places, see Contact::lies
  // m/s, by which sliding has become faster as the step began: as held blocks have, or, in the first, all that there is
  double faster;
  double kn, ks;              // N/m
  double climb;               // by how much less the gap is for each m of sliding, see climb()
  double friction, cohesion;  // tan φ; N
  int contact;                // index into Model::contacts
  bool near;                  // may press in this step; the others are not solved for, only watched
};

struct ContactRows : ContactScalars {
  // Change of gap and of sliding under unit unknowns: six of each block, twelve where one of the two is of second
  // order.
  Row normal_i, normal_j, shear_i, shear_j;

  ContactRows() {}  // NOLINT(modernize-use-equals-default): = default would set all to nought
  ContactRows(const ContactRows& other) { *this = other; }  // NOLINT(cppcoreguidelines-pro-type-member-init)
  ContactRows& operator=(const ContactRows& other) {
    ContactScalars::operator=(other);
    const bool second = other.second_order();
    const auto copy = [second](const Row& from, Row& to) {
      std::copy_n(from.begin(), first_order_dofs, to.begin());
      if (second) std::copy(from.begin() + first_order_dofs, from.end(), to.begin() + first_order_dofs);
    };
    copy(other.normal_i, normal_i);
    copy(other.normal_j, normal_j);
    copy(other.shear_i, shear_i);
    copy(other.shear_j, shear_j);
    return *this;
  }
  bool second_order() const { return size_i == second_order_dofs || size_j == second_order_dofs; }

  double along(const Row& i, const Row& j, const Vector& d) const {
    double sum = 0;
    for (int k = 0; k < size_i; ++k) sum += i[k] * d[dof_i + k];
    for (int k = 0; k < size_j; ++k) sum += j[k] * d[dof_j + k];
    return sum;
  }
  void add(const Row& i, const Row& j, double force, Vector& f) const {
    for (int k = 0; k < size_i; ++k) f[dof_i + k] += force * i[k];
    for (int k = 0; k < size_j; ++k) f[dof_j + k] += force * j[k];
  }
};

// N, of a contact's shear force under this normal force.
inline double friction_limit(const ContactScalars& row, double normal) {
  return (normal > 0 ? (std::isinf(row.friction) ? row.friction : row.friction * normal) : 0) + row.cohesion;
}

class ContactTerms {
 public:
  static constexpr double least_pressed = 1e-6;  // of cohesion: less is no load but what the solution leaves
  // Of what is awake. `stick`: no joint that touches slides, open or not (the settled start). Near is what the
  // velocities bring to within `nearness` times what a contact's neighbours may push it in the step, taken as half of
  // its own relative motion and near_part of the smaller block's √area. Per block, the larger counts; empty: 1.
  // Cohesion counts where the normal force is more than `pressed` of it.
  void linearise(const Model& model, Poses& poses, const Scheme& scheme, bool stick, std::span<const double> nearness,
                 double pressed = least_pressed);
  // Becomes the listed rows of `whole`, between the blocks that `place` numbers, whose unknowns begin at `dof_begin`.
  void take_part(const ContactTerms& whole, std::span<const int> rows, const std::vector<int>& place,
                 const std::vector<int>& dof_begin);
  void find_slots(const BlockMatrix& matrix);
  // matrix += contact_d Σ kn n nᵀ over `closed` and ks s sᵀ over `stuck`; with numbers for these, so many times.
  template <typename Number>
  void add_stiffness(BlockMatrix& matrix, const std::vector<Number>& closed, const std::vector<Number>& stuck) const;

  const std::vector<ContactRows>& rows() const { return rows_; }
  double factor() const { return factor_; }
  // m, at the solution d
  double gap(const ContactRows& row, const Vector& d) const {
    return row.gap0 + factor_ * row.along(row.normal_i, row.normal_j, d);
  }
  double slide(const ContactRows& row, const Vector& d) const {
    return row.slide0 + factor_ * row.along(row.shear_i, row.shear_j, d);
  }

 private:
  template <int n>
  static void set_rows(const Model& model, const Contact& contact, const Poses& poses, const Vec2& at,
                       const EdgeFoot& on, ContactRows& row);

  std::vector<ContactRows> rows_;
  struct Slots {
    BlockMatrix::Slot ii, jj, ij;
  };
  std::vector<Slots> slots_;
  double factor_ = 0;
};

}  // namespace talus
