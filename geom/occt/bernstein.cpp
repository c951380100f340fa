// SPDX-License-Identifier: BSD-3-Clause
// From the Bernstein basis to powers about the middle of the span.
#include "geom/occt/bernstein.h"

namespace octet {

BernsteinMatrix bernstein_to_power(int degree) {
  BernsteinMatrix matrix{};
  double choose = 1.0;
  for (int i = 0; i <= degree; ++i) {
    std::array<double, kMaxSpanDegree + 2> poly{};
    poly[0] = choose;
    for (int factor = 0; factor < degree; ++factor) {
      const double slope = factor < i ? 1.0 : -1.0;
      for (int k = factor + 1; k >= 1; --k) poly[k] = 0.5 * poly[k] + slope * poly[k - 1];
      poly[0] *= 0.5;
    }
    for (int k = 0; k <= degree; ++k) matrix[k][i] = poly[k];
    choose = choose * (degree - i) / (i + 1);
  }
  return matrix;
}

}  // namespace octet
