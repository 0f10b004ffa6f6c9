// The calibration kernel: products of 6 × 6 matrices, 2·10⁷ of them, as block assembly does, one thread. Its CPU time
// says how fast the machine was on which a table of times was made.
#include <chrono>
#include <cstdio>
#include <ctime>

int main() {
  static double a[64][36], b[64][36], c[64][36];
  for (int m = 0; m < 64; ++m)
    for (int k = 0; k < 36; ++k) a[m][k] = 1e-3 * (k + m), b[m][k] = 1e-3 * (36 - k);
  const std::clock_t start = std::clock();
  for (int n = 0; n < 20000000; ++n) {
    double *x = a[n & 63], *y = b[(n * 7) & 63], *z = c[(n * 13) & 63];
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        double sum = 0;
        for (int k = 0; k < 6; ++k) sum += x[6 * i + k] * y[6 * k + j];
        z[6 * i + j] = 0.5 * z[6 * i + j] + sum;
      }
  }
  double check = 0;
  for (const auto& m : c) check += m[7];
  std::printf("%.3f %g\n", double(std::clock() - start) / CLOCKS_PER_SEC, check);
}
