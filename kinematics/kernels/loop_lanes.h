// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/lane_math.h"
#include "kinematics/kernels/loop_kernels.h"

namespace hapticell::kinematics::kernels {
namespace {

/// x cos(theta) + h sin(theta) = e in the plane of each arm, (x, h) from the motor axis to the platform's joint.
unsigned deltaInverse(const DeltaArms& arms, const double* p, double* outer, double* inner) {
  const Lanes along = p[0] * load(arms.cosine) + p[1] * load(arms.sine);
  const double shift = arms.platform - arms.base, h = arms.down * p[2];
  const double squares =
      p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + arms.upper * arms.upper - arms.lower * arms.lower + shift * shift;
  const Lanes x = along + shift;
  const Lanes e = (Lanes(squares) + 2.0 * shift * along) * (0.5 / arms.upper);
  const Lanes under = x * x + Lanes(h * h) - e * e;
  const Lanes w = squareRoot(under);
  store(outer, arcTangent(h * e - x * w, x * e + h * w));
  store(inner, arcTangent(h * e + x * w, x * e - h * w));
  const unsigned reached = bitsOf(under >= Lanes(0.0));
  if (reached == 15u) return reached;
  const Lanes none = select(under >= Lanes(0.0), Lanes(0.0), Lanes(__builtin_nan("")));
  store(outer, load(outer) + none);
  store(inner, load(inner) + none);
  return reached;
}

void deltaAngles(const double* theta, double* sine, double* cosine) {
  Lanes s, c;
  sineCosine(Lanes(theta[0], theta[1], theta[2], theta[2]), s, c);
  store(sine, s);
  store(cosine, c);
}

struct Legs {
  Lanes3 arm, leg;
  Lanes length;
};

inline Legs legsOf(const HexapodHinges& hinges, const double* R, const double* p, int group) {
  const Lanes3 c{load(hinges.top[0] + 4 * group), load(hinges.top[1] + 4 * group), load(hinges.top[2] + 4 * group)};
  const Lanes3 base{load(hinges.base[0] + 4 * group), load(hinges.base[1] + 4 * group),
                    load(hinges.base[2] + 4 * group)};
  Legs legs;
  legs.arm = {R[0] * c.x + R[1] * c.y + R[2] * c.z, R[3] * c.x + R[4] * c.y + R[5] * c.z,
              R[6] * c.x + R[7] * c.y + R[8] * c.z};
  legs.leg = legs.arm + Lanes3{p[0], p[1], p[2]} - base;
  legs.length = squareRoot(dot(legs.leg, legs.leg));
  return legs;
}

void legLengths(const HexapodHinges& hinges, const double* R, const double* p, double* lengths) {
  for (int group = 0; group < 2; ++group) store(lengths + 4 * group, legsOf(hinges, R, p, group).length);
}

/// Rows of J as columns of `m` (m[j][i]: coefficient j of leg i), so that legs stay in lanes; then the elimination
/// works row by row on m transposed, eight numbers a row: six coefficients, the right-hand side, padding.
double hexapodStep(const HexapodHinges& hinges, const double* R, const double* p, const double* wanted, double* step,
                   double* determinant) {
  alignas(32) double columns[7][8];
  alignas(32) double rows[6][8];
  double error = 0.0;
  for (int group = 0; group < 2; ++group) {
    const Legs legs = legsOf(hinges, R, p, group);
    const Lanes inverse = Lanes(1.0) / legs.length;
    const Lanes3 u = inverse * legs.leg, c = cross(legs.arm, u);
    const Lanes missing = load(wanted + 4 * group) - legs.length;
    const Lanes* parts[] = {&u.x, &u.y, &u.z, &c.x, &c.y, &c.z, &missing};
    for (int j = 0; j < 7; ++j) store(columns[j] + 4 * group, *parts[j]);
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 7; ++j) rows[i][j] = columns[j][i];
    rows[i][7] = 0.0;
    const double missing = rows[i][6] < 0.0 ? -rows[i][6] : rows[i][6];
    error = missing > error ? missing : error;
  }
  int order[6] = {0, 1, 2, 3, 4, 5};
  double product = 1.0;
  for (int k = 0; k < 6; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 6; ++i) {
      if (__builtin_fabs(rows[order[i]][k]) > __builtin_fabs(rows[order[pivot]][k])) pivot = i;
    }
    if (pivot != k) {
      const int other = order[pivot];
      order[pivot] = order[k];
      order[k] = other;
      product = -product;
    }
    const double* row = rows[order[k]];
    product *= row[k];
    if (!(__builtin_fabs(row[k]) > 1e-14)) {
      *determinant = 0.0;
      return error;
    }
    const double inverse = 1.0 / row[k];
    const Lanes low = load(row), high = load(row + 4);
    for (int i = k + 1; i < 6; ++i) {
      double* other = rows[order[i]];
      const double factor = other[k] * inverse;
      if (k < 3) store(other, load(other) - factor * low);
      store(other + 4, load(other + 4) - factor * high);
    }
  }
  for (int k = 5; k >= 0; --k) {
    const double* row = rows[order[k]];
    double sum = row[6];
    for (int j = k + 1; j < 6; ++j) sum -= row[j] * step[j];
    step[k] = sum / row[k];
  }
  *determinant = product;
  return error;
}

constexpr LoopTable loopTableNamed(const char* name) {
  return {name, deltaInverse, deltaAngles, legLengths, hexapodStep};
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
