#pragma once
// TALUS_WIDE before a function: compiled for processors of several generations, of which the loader takes the one that
// is there. For the few loops that take most of a run, as the program is built for any x86-64.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define TALUS_WIDE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else  // The sanitizer's own code would run before it is set up, as the loader chooses.
#define TALUS_WIDE
#endif
// Code that is part of each of these versions.
#define TALUS_WITHIN __attribute__((always_inline)) inline

namespace talus {

// Of numbers, lane by lane: as wide as the processor has them, or in parts.
using Eight = double __attribute__((vector_size(64), aligned(64), may_alias));
using Four = double __attribute__((vector_size(32), aligned(32)));
using EightFloats = float __attribute__((vector_size(32), aligned(32), may_alias));

// Eight that may lie anywhere, and half of them.
template <class Scalar>
struct Register;
template <>
struct Register<float> {
  using Whole = float __attribute__((vector_size(32), aligned(4), may_alias));
  using Half = float __attribute__((vector_size(16)));
};
template <>
struct Register<double> {
  using Whole = double __attribute__((vector_size(64), aligned(8), may_alias));
  using Half = double __attribute__((vector_size(32)));
};

// The sum of each of four.
template <class Scalar>
TALUS_WITHIN void sum_up(const typename Register<Scalar>::Whole* parts, typename Register<Scalar>::Half& sums) {
  using Half = Register<Scalar>::Half;
  Half half[4];
  for (int m = 0; m < 4; ++m)
    half[m] = __builtin_shufflevector(parts[m], parts[m], 0, 1, 2, 3) +
              __builtin_shufflevector(parts[m], parts[m], 4, 5, 6, 7);
  const Half first =
      __builtin_shufflevector(half[0], half[1], 0, 4, 2, 6) + __builtin_shufflevector(half[0], half[1], 1, 5, 3, 7);
  const Half second =
      __builtin_shufflevector(half[2], half[3], 0, 4, 2, 6) + __builtin_shufflevector(half[2], half[3], 1, 5, 3, 7);
  sums = __builtin_shufflevector(first, second, 0, 1, 4, 5) + __builtin_shufflevector(first, second, 2, 3, 6, 7);
}

}  // namespace talus
