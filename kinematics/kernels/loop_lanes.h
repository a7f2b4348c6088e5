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

struct Vector3 {
  double x, y, z;
};
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 weighed(double a, const Vector3& A, double b, const Vector3& B, double c, const Vector3& C) {
  return {a * A.x + b * B.x + c * C.x, a * A.y + b * B.y + c * C.y, a * A.z + b * B.z + c * C.z};
}

/// One Newton step as a linear system: row i is [direction, moment] with the right-hand side `missing`.
struct StepSystem {
  alignas(32) double columns[7][8];

  Vector3 direction(int leg) const { return {columns[0][leg], columns[1][leg], columns[2][leg]}; }
  Vector3 moment(int leg) const { return {columns[3][leg], columns[4][leg], columns[5][leg]}; }
  double missing(int leg) const { return columns[6][leg]; }
};

/// By blocks: the directions of legs 1, 3 and 5 are eliminated by their cross products, the moments of the others are
/// what is left. False where those three directions are nearly in a plane, or what is left nearly singular.
inline bool solveByBlocks(const StepSystem& m, double* step, double* determinant) {
  // Volume of three unit directions of legs below which rounding is amplified over a hundredfold, and the full system
  // is solved instead. Half: two hundredfold; twice: more poses take the slower way.
  constexpr double kFlat = 1e-2;
  const Vector3 a0 = m.direction(0), a1 = m.direction(2), a2 = m.direction(4);
  const Vector3 i0 = cross(a1, a2), i1 = cross(a2, a0), i2 = cross(a0, a1);  // Columns of the inverse times `det`.
  const double det = dot(a0, i0);
  if (!(__builtin_fabs(det) > kFlat)) return false;
  const double inverse = 1.0 / det;
  const Vector3 c0 = m.moment(0), c1 = m.moment(2), c2 = m.moment(4);
  const double e0 = m.missing(0), e1 = m.missing(2), e2 = m.missing(4);
  Vector3 rows[3];
  double right[3];
  double size = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int leg = 2 * k + 1;
    const Vector3 u = m.direction(leg), c = m.moment(leg);
    const double f0 = dot(u, i0) * inverse, f1 = dot(u, i1) * inverse, f2 = dot(u, i2) * inverse;
    const Vector3 known = weighed(f0, c0, f1, c1, f2, c2);
    rows[k] = {c.x - known.x, c.y - known.y, c.z - known.z};
    right[k] = m.missing(leg) - (f0 * e0 + f1 * e1 + f2 * e2);
    size += dot(rows[k], rows[k]);
  }
  const Vector3 j0 = cross(rows[1], rows[2]), j1 = cross(rows[2], rows[0]), j2 = cross(rows[0], rows[1]);
  const double rest = dot(rows[0], j0);
  if (!(rest * rest > 1e-8 * size * size * size)) return false;
  const double turn = 1.0 / rest;
  const Vector3 w = weighed(right[0] * turn, j0, right[1] * turn, j1, right[2] * turn, j2);
  const Vector3 v =
      weighed((e0 - dot(c0, w)) * inverse, i0, (e1 - dot(c1, w)) * inverse, i1, (e2 - dot(c2, w)) * inverse, i2);
  const double result[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
  __builtin_memcpy(step, result, sizeof result);
  *determinant = -det * rest;  // Taking legs 1, 3, 5 first is an odd permutation.
  return true;
}

/// The general way, with row pivots.
inline void solveByPivots(const StepSystem& m, double* step, double* determinant) {
  double rows[6][7];
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 7; ++j) rows[i][j] = m.columns[j][i];
  }
  double product = 1.0;
  for (int k = 0; k < 6; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 6; ++i) {
      if (__builtin_fabs(rows[i][k]) > __builtin_fabs(rows[pivot][k])) pivot = i;
    }
    if (pivot != k) {
      for (int j = k; j < 7; ++j) {
        const double other = rows[pivot][j];
        rows[pivot][j] = rows[k][j];
        rows[k][j] = other;
      }
      product = -product;
    }
    product *= rows[k][k];
    if (!(__builtin_fabs(rows[k][k]) > 1e-14)) {
      *determinant = 0.0;
      return;
    }
    const double inverse = 1.0 / rows[k][k];
    for (int i = k + 1; i < 6; ++i) {
      const double factor = rows[i][k] * inverse;
      for (int j = k + 1; j < 7; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  for (int k = 5; k >= 0; --k) {
    double sum = rows[k][6];
    for (int j = k + 1; j < 6; ++j) sum -= rows[k][j] * step[j];
    step[k] = sum / rows[k][k];
  }
  *determinant = product;
}

double hexapodStep(const HexapodHinges& hinges, const double* R, const double* p, const double* wanted, double* step,
                   double* determinant) {
  StepSystem m;
  Lanes most = 0.0;
  for (int group = 0; group < 2; ++group) {
    const Legs legs = legsOf(hinges, R, p, group);
    const Lanes inverse = Lanes(1.0) / legs.length;
    const Lanes3 u = inverse * legs.leg, c = cross(legs.arm, u);
    const Lanes missing = load(wanted + 4 * group) - legs.length;
    const Lanes* parts[] = {&u.x, &u.y, &u.z, &c.x, &c.y, &c.z, &missing};
    for (int j = 0; j < 7; ++j) store(m.columns[j] + 4 * group, *parts[j]);
    most = maximum(most, absolute(missing));
  }
  if (!solveByBlocks(m, step, determinant)) solveByPivots(m, step, determinant);
  double error = most[0];
  for (int k = 1; k < 4; ++k) error = most[k] > error ? most[k] : error;
  return error;
}

constexpr LoopTable loopTableNamed(const char* name) {
  return {name, deltaInverse, deltaAngles, legLengths, hexapodStep};
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
