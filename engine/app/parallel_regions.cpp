// CHOLMOD's parallel regions, in the thread that comes to them. It asks for them on every supernode, whatever its size.
// GCC's runtime makes and frees a team for each and enters the kernel, also where LinearSolver has allowed it one
// thread: two fifths of a factor of 2300 blocks. The program's definition comes before that of the runtime; a host that
// has the engine as a library keeps its own.
extern "C" __attribute__((visibility("default"))) void GOMP_parallel(void (*region)(void*), void* data,
                                                                     unsigned /*threads*/, unsigned /*flags*/) {
  region(data);
}
