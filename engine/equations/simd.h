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

}  // namespace talus
