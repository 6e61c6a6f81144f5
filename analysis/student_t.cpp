#include "analysis/student_t.hpp"

namespace softwall::analysis {

double student_t_975(double degrees) {
  constexpr double kZ = 1.959963984540054;  // the same quantile of the normal distribution
  constexpr double kZ2 = kZ * kZ;
  const double n = degrees;
  const double g1 = kZ * (kZ2 + 1.0) / 4.0;
  const double g2 = kZ * ((5.0 * kZ2 + 16.0) * kZ2 + 3.0) / 96.0;
  const double g3 = kZ * (((3.0 * kZ2 + 19.0) * kZ2 + 17.0) * kZ2 - 15.0) / 384.0;
  const double g4 = kZ * ((((79.0 * kZ2 + 776.0) * kZ2 + 1482.0) * kZ2 - 1920.0) * kZ2 - 945.0) / 92160.0;
  return kZ + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n;
}

}  // namespace softwall::analysis
