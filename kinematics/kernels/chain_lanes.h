// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/kernels.h"
#include "kinematics/kernels/lane_math.h"

namespace hapticell::kinematics::kernels {
namespace {

struct Rotation {
  Lanes3 x, y, z;  ///< Columns.
};

inline Lanes3 along(const Rotation& R, const double* v) {
  return {R.x.x * v[0] + R.y.x * v[1] + R.z.x * v[2], R.x.y * v[0] + R.y.y * v[1] + R.z.y * v[2],
          R.x.z * v[0] + R.y.z * v[1] + R.z.z * v[2]};
}

/// R times a constant matrix, row by row.
inline Rotation times(const Rotation& R, const double* M) {
  const double c0[3] = {M[0], M[3], M[6]}, c1[3] = {M[1], M[4], M[7]}, c2[3] = {M[2], M[5], M[8]};
  return {along(R, c0), along(R, c1), along(R, c2)};
}

struct FourArms {
  Lanes3 axis[kMaxJoints], origin[kMaxJoints];
  Rotation R;
  Lanes3 p;
};

inline Lanes3 constantVector(const double* v) {
  return {v[0], v[1], v[2]};
}

/// Four joint positions walked through the true arm at once.
inline void walk(const TrueArm& arm, const Lanes* q, FourArms& state) {
  Rotation R{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  Lanes3 p{0.0, 0.0, 0.0};
  for (int i = 0; i < arm.joints; ++i) {
    p = p + along(R, arm.p[i]);
    R = times(R, arm.R[i]);
    state.axis[i] = R.z;
    state.origin[i] = p;
    if (arm.slides[i]) {
      p = p + q[i] * R.z;
      continue;
    }
    Lanes s, c;
    sineCosine(q[i], s, c);
    const Lanes3 x = c * R.x + s * R.y;
    R.y = c * R.y - s * R.x;
    R.x = x;
  }
  state.p = p + along(R, arm.p_tip);
  state.R = times(R, arm.R_tip);
}

/// Position and rotation still missing, the latter as axis times sine; the larger of the two lengths (1 beyond 60 deg).
inline Lanes missing(const FourArms& state, const double* R, const double* p, Lanes3& e_p, Lanes3& e_r) {
  const Lanes3 x{R[0], R[3], R[6]}, y{R[1], R[4], R[7]}, z{R[2], R[5], R[8]};
  e_p = constantVector(p) - state.p;
  e_r = Lanes(0.5) * (cross(state.R.x, x) + cross(state.R.y, y) + cross(state.R.z, z));
  const Lanes trace = dot(state.R.x, x) + dot(state.R.y, y) + dot(state.R.z, z);
  const Lanes rotation = squareRoot(dot(e_r, e_r));
  const Lanes far = select(trace < Lanes(2.0), Lanes(1.0), Lanes(0.0));
  return maximum(squareRoot(dot(e_p, e_p)), maximum(rotation, far));
}

/// Solves (Jt J + least) dq = Jt e for all lanes, J's linear rows divided by the arm's size, by LDLt without pivots.
inline void newtonStep(const TrueArm& arm, const FourArms& state, const Lanes3& e_p, const Lanes3& e_r, Lanes* dq) {
  const Lanes scale = arm.scale;
  const int n = arm.joints;
  Lanes3 linear[kMaxJoints], angular[kMaxJoints];
  Lanes H[kMaxJoints][kMaxJoints], g[kMaxJoints];
  const Lanes3 target = scale * e_p;
  for (int i = 0; i < n; ++i) {
    linear[i] = scale * (arm.slides[i] ? state.axis[i] : cross(state.axis[i], state.p - state.origin[i]));
    angular[i] = arm.slides[i] ? Lanes3{0.0, 0.0, 0.0} : state.axis[i];
    g[i] = dot(linear[i], target) + dot(angular[i], e_r);
    for (int j = 0; j <= i; ++j) H[i][j] = dot(linear[i], linear[j]) + dot(angular[i], angular[j]);
    H[i][i] = H[i][i] + 1e-14;
  }
  Lanes d_inverse[kMaxJoints];
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < j; ++k) {
      const Lanes factor = H[j][k];  // L times D, from the column before
      const Lanes l = factor * d_inverse[k];
      H[j][j] -= l * factor;
      for (int i = j + 1; i < n; ++i) H[i][j] -= H[i][k] * l;
      g[j] -= l * g[k];
    }
    d_inverse[j] = Lanes(1.0) / maximum(H[j][j], 1e-15);
  }
  for (int j = n - 1; j >= 0; --j) {
    Lanes sum = g[j];
    for (int i = j + 1; i < n; ++i) sum -= H[i][j] * dq[i];
    dq[j] = sum * d_inverse[j];
  }
}

inline void polish(const TrueArm& arm, const double* R, const double* p, int group, int iterations,
                   Solutions& solutions, double* errors) {
  // rad or m, the least longest step, only so that the division below is one; ten roundings of a double. Half, twice:
  // none.
  constexpr double kDone = 2e-15;
  // rad or m a step: within it slopes change by less than 5 % (cosine of 0.3), so that a step does not overshoot. Half:
  // more steps for a calibrated arm; twice: a branch may end on its neighbour.
  constexpr double kLongest = 0.3;
  Lanes q[kMaxJoints], best[kMaxJoints];
  for (int i = 0; i < arm.joints; ++i) best[i] = q[i] = load(solutions.q[i] + 4 * group);
  FourArms state;
  Lanes3 e_p, e_r;
  walk(arm, q, state);
  Lanes least = missing(state, R, p, e_p, e_r);
  const unsigned wanted = solutions.valid >> (4 * group) & 0xfu;
  const Lanes enough = 2e-13;
  for (int round = 0; round < iterations; ++round) {
    if ((bitsOf(least > enough) & wanted) == 0) break;
    Lanes dq[kMaxJoints];
    newtonStep(arm, state, e_p, e_r, dq);
    Lanes longest = kDone;
    for (int i = 0; i < arm.joints; ++i) longest = maximum(longest, absolute(dq[i]));
    const Lanes share = minimum(Lanes(kLongest) / longest, 1.0);
    for (int i = 0; i < arm.joints; ++i) q[i] += share * dq[i];
    walk(arm, q, state);
    const Lanes error = missing(state, R, p, e_p, e_r);
    const Mask better = error < least;
    least = select(better, error, least);
    for (int i = 0; i < arm.joints; ++i) best[i] = select(better, q[i], best[i]);
  }
  for (int i = 0; i < arm.joints; ++i) store(solutions.q[i] + 4 * group, best[i]);
  store(errors, least);
}

inline void axes(const TrueArm& arm, const Solutions& solutions, int group, FourAxes& result) {
  Lanes q[kMaxJoints] = {};
  for (int i = 0; i < arm.joints; ++i) q[i] = load(solutions.q[i] + 4 * group);
  FourArms state;
  walk(arm, q, state);
  const auto put = [](const Lanes3& from, double(&to)[3][4]) {
    store(to[0], from.x);
    store(to[1], from.y);
    store(to[2], from.z);
  };
  for (int i = 0; i < arm.joints; ++i) {
    put(state.axis[i], result.axis[i]);
    put(state.origin[i], result.origin[i]);
  }
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
