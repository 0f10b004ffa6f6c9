#pragma once
// How far the stress of the blocks is from what it would be in a mesh without end: estimated by the smoothed stress,
// which is nearer to it (Zienkiewicz & Zhu 1987, 1992). docs/theory.md, § 8, has how near on closed forms.
#include <vector>

#include "equations/recovery.h"

namespace talus {

// Squares of energy norms, J/m: ∫ s·D⁻¹s dA.
struct ErrorNorm {
  double error = 0;         // of smoothed less raw stress
  double energy = 0;        // of the stress that has come since the start, D ε
  double relative() const;  // ‖error‖ / √(‖energy‖² + ‖error‖²); 0 where nothing is strained
  ErrorNorm& operator+=(const ErrorNorm& other);
};

// Of a block that does not deform, or that too few others hang on to smooth its stress: no error.
ErrorNorm error_of_block(const Model& model, const Recovery& recovery, int block);
// Pa: √(E error / area), in simple tension the root mean square of the error of its stress.
double stress_error(const Model& model, const Recovery& recovery, int block);
std::vector<ErrorNorm> error_of_regions(const Model& model, const Recovery& recovery);  // one fit a block

// Pa: root mean square over a joint's points of |σ_b n - σ_a n|, the traction that the stresses of its blocks disagree
// by. 0 beside a block that does not deform, which has no stress of its own.
double traction_jump(const Model& model, const Joint& joint);

}  // namespace talus
