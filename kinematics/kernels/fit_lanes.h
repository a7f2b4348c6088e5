// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/kernels.h"
#include "kinematics/kernels/lane_math.h"

namespace hapticell::kinematics::kernels {
namespace {

// One descent on one arm. Rows of matrices are eight wide, two groups of lanes; the right-hand side of a system stands
// in column 7, so the arm has seven joints at most.
constexpr int kWide = 8;
// m and rad; a fifth of the 1e-9 promised, so that rounding between does not lose it. Half: at singular poses more
// iterations; twice: still met, with less to spare.
constexpr double kFitTolerance = 2e-10;
// rad or m: beyond it the linear model says nothing, sine 0.7 is 8 % off. Half: more iterations from distant seeds;
// twice: steps that the damping must refuse.
constexpr double kLargestFitStep = 0.7;
// Of the matrix's largest entry: a redundant or singular arm has one without inverse; a thousand roundings of a double.
// Half: the pivots near rounding; twice: no loss of speed that the 2e-10 shows.
constexpr double kLeastFitDamping = 1e-13;

inline double size(double a) {
  return a < 0.0 ? -a : a;
}
inline double larger(double a, double b) {
  return a > b ? a : b;
}
inline double smaller(double a, double b) {
  return a < b ? a : b;
}
inline double dot3(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline void cross3(const double* a, const double* b, double* c) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/// Where an arm stands: axes and origins, the tip's columns and place.
struct OneArm {
  double axis[kWide][3], origin[kWide][3];
  double columns[3][3], p[3];
};

inline void walkOne(const TrueArm& arm, const double* q, OneArm& state) {
  double sine[kWide], cosine[kWide];
  for (int i = 0; i < arm.joints; i += 4) {
    Lanes s, c;
    sineCosine(load(q + i), s, c);
    store(sine + i, s);
    store(cosine + i, c);
  }
  double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1}, p[3] = {0, 0, 0};
  const auto step = [&](const double* M, const double* v) {
    double nx[3], ny[3], nz[3];
    for (int k = 0; k < 3; ++k) {
      p[k] += x[k] * v[0] + y[k] * v[1] + z[k] * v[2];
      nx[k] = x[k] * M[0] + y[k] * M[3] + z[k] * M[6];
      ny[k] = x[k] * M[1] + y[k] * M[4] + z[k] * M[7];
      nz[k] = x[k] * M[2] + y[k] * M[5] + z[k] * M[8];
    }
    for (int k = 0; k < 3; ++k) {
      x[k] = nx[k];
      y[k] = ny[k];
      z[k] = nz[k];
    }
  };
  for (int i = 0; i < arm.joints; ++i) {
    step(arm.R[i], arm.p[i]);
    for (int k = 0; k < 3; ++k) {
      state.axis[i][k] = z[k];
      state.origin[i][k] = p[k];
    }
    if (arm.slides[i]) {
      for (int k = 0; k < 3; ++k) p[k] += q[i] * z[k];
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const double turned = cosine[i] * x[k] + sine[i] * y[k];
      y[k] = cosine[i] * y[k] - sine[i] * x[k];
      x[k] = turned;
    }
  }
  step(arm.R_tip, arm.p_tip);
  for (int k = 0; k < 3; ++k) {
    state.columns[0][k] = x[k];
    state.columns[1][k] = y[k];
    state.columns[2][k] = z[k];
    state.p[k] = p[k];
  }
}

/// The rotation vector of Q = sum of wanted column times column, near half a turn from its symmetric part.
inline void logarithm(const double wanted[3][3], const double columns[3][3], double* out) {
  double Q[3][3] = {};
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) Q[i][j] += wanted[c][i] * columns[c][j];
    }
  }
  const double sine[3] = {0.5 * (Q[2][1] - Q[1][2]), 0.5 * (Q[0][2] - Q[2][0]), 0.5 * (Q[1][0] - Q[0][1])};
  const double cosine = 0.5 * (Q[0][0] + Q[1][1] + Q[2][2] - 1.0);
  const double length = __builtin_sqrt(dot3(sine, sine));
  const double angle = arcTangent(Lanes(length), Lanes(cosine))[0];
  if (cosine > -0.9) {
    const double factor = length < 1e-12 ? 1.0 : angle / length;
    for (int i = 0; i < 3; ++i) out[i] = factor * sine[i];
    return;
  }
  int most = 0;
  for (int i = 1; i < 3; ++i) most = Q[i][i] > Q[most][most] ? i : most;
  double v[3];
  for (int i = 0; i < 3; ++i) v[i] = 0.5 * (Q[i][most] + Q[most][i]) - (i == most ? cosine : 0.0);
  const double norm = __builtin_sqrt(dot3(v, v)) * (dot3(v, sine) < 0.0 ? -1.0 : 1.0);
  for (int i = 0; i < 3; ++i) out[i] = angle * v[i] / norm;
}

class Fit {
 public:
  Fit(const TrueArm& arm, const FitTask& task)
      : arm_(arm), task_(task), n_(arm.joints), weight_(task.lever * task.lever) {
    for (int c = 0; c < 3; ++c) {
      for (int i = 0; i < 3; ++i) wanted_[c][i] = task.R[3 * i + c];
    }
  }

  void run(FitAnswer& answer) {
    for (int i = 0; i < kWide; ++i)
      x_[i] = i < n_ ? smaller(larger(task_.start[i], task_.lower[i]), task_.upper[i]) : 0.0;
    walkOne(arm_, x_, state_);
    cost_ = residual(state_, e_p_, e_r_);
    lambda_ = 1e-3 * cost_;
    int slow = 0, iterations = 0;
    bool fresh = true;
    while (!solved() && iterations < task_.max_iterations) {
      if (fresh) {
        linearise();
        if (!fixBlocked()) break;
        if (curved_) addCurvature();
      }
      ++iterations;
      // A redundant or singular arm has a matrix without inverse; this much damping costs no speed of convergence.
      lambda_ = larger(lambda_, kLeastFitDamping * largest_);
      const double(*H)[kWide] = curved_ ? hessian_ : normal_;
      if (!solveStep(H)) {
        H = normal_;
        if (!solveStep(H)) {
          lambda_ *= 16.0;
          fresh = false;
          continue;
        }
      }
      double longest = 0.0;
      for (int i = 0; i < n_; ++i) longest = larger(longest, size(step_[i]));
      if (longest < 1e-14) break;
      if (longest > kLargestFitStep) {
        for (int i = 0; i < n_; ++i) step_[i] *= kLargestFitStep / longest;
      }
      const double before = cost_;
      fresh = tryStep(gain(H));
      if (!fresh && longest < 1e-10) break;
      if (fresh) slow = cost_ > 0.6 * before ? slow + 1 : 0;
      if (task_.give_up_when_slow && slow >= 4) break;
    }
    finish(answer, iterations);
  }

 private:
  const TrueArm& arm_;
  const FitTask& task_;
  const int n_;
  const double weight_;
  double wanted_[3][3];
  double x_[kWide], step_[kWide] = {}, gradient_[kWide] = {};
  bool fixed_[kWide] = {};
  OneArm state_;
  double e_p_[3], e_r_[3], cost_ = 0.0;
  double linear_[kWide][3];
  alignas(32) double normal_[kWide][kWide];
  alignas(32) double hessian_[kWide][kWide];
  double largest_ = 0.0, lambda_ = 0.0, growth_ = 4.0;
  bool curved_ = false;

  double residual(const OneArm& state, double* e_p, double* e_r) const {
    for (int i = 0; i < 3; ++i) e_p[i] = task_.p[i] - state.p[i];
    logarithm(wanted_, state.columns, e_r);
    return 0.5 * (dot3(e_p, e_p) + weight_ * dot3(e_r, e_r));
  }
  bool solved() const {
    return dot3(e_p_, e_p_) < kFitTolerance * kFitTolerance && dot3(e_r_, e_r_) < kFitTolerance * kFitTolerance;
  }

  void linearise() {
    alignas(32) double J[6][kWide] = {};
    double e[6];
    for (int i = 0; i < n_; ++i) {
      const double lever[3] = {state_.p[0] - state_.origin[i][0], state_.p[1] - state_.origin[i][1],
                               state_.p[2] - state_.origin[i][2]};
      if (arm_.slides[i]) {
        for (int k = 0; k < 3; ++k) linear_[i][k] = state_.axis[i][k];
      } else {
        cross3(state_.axis[i], lever, linear_[i]);
      }
      for (int k = 0; k < 3; ++k) {
        J[k][i] = linear_[i][k];
        J[k + 3][i] = arm_.slides[i] ? 0.0 : task_.lever * state_.axis[i][k];
      }
    }
    for (int k = 0; k < 3; ++k) {
      e[k] = e_p_[k];
      e[k + 3] = task_.lever * e_r_[k];
    }
    Lanes low[6], high[6], g_low = 0.0, g_high = 0.0;
    for (int k = 0; k < 6; ++k) {
      low[k] = load(J[k]);
      high[k] = load(J[k] + 4);
      g_low += e[k] * low[k];
      g_high += e[k] * high[k];
    }
    store(gradient_, g_low);
    store(gradient_ + 4, g_high);
    largest_ = 0.0;
    for (int i = 0; i < n_; ++i) {
      Lanes row_low = J[0][i] * low[0], row_high = J[0][i] * high[0];
      for (int k = 1; k < 6; ++k) {
        row_low += J[k][i] * low[k];
        row_high += J[k][i] * high[k];
      }
      store(normal_[i], row_low);
      store(normal_[i] + 4, row_high);
      largest_ = larger(largest_, normal_[i][i]);
    }
  }

  // The residual's own second derivatives: position through z_j x J_i (j nearer to the base), orientation through the
  // derivative of the logarithm on SO(3).
  void addCurvature() {
    const double angle = __builtin_sqrt(dot3(e_r_, e_r_));
    const double a = angle < 1e-4 ? 1.0 - angle * angle / 12.0 : 0.5 * angle / __builtin_tan(0.5 * angle);
    const double along = angle < 1e-12 ? 0.0 : 1.0 / angle;
    double part[kWide];
    for (int i = 0; i < n_; ++i) part[i] = along * dot3(e_r_, state_.axis[i]);
    __builtin_memcpy(hessian_, normal_, sizeof hessian_);
    for (int j = 0; j < n_; ++j) {
      if (arm_.slides[j]) continue;  // moves the axes behind it, turns none
      const double* z_j = state_.axis[j];
      double pull[3], twist[3];
      cross3(e_p_, z_j, pull);
      cross3(e_r_, z_j, twist);
      for (int i = j; i < n_; ++i) {
        const double* z_i = state_.axis[i];
        double value = -dot3(pull, linear_[i]);
        if (!arm_.slides[i]) {
          value += weight_ * ((1.0 - a) * (part[i] * part[j] - dot3(z_i, z_j)) - 0.5 * dot3(twist, z_i));
        }
        hessian_[i][j] += value;
        if (i != j) hessian_[j][i] += value;
      }
    }
  }

  // Solves (H + lambda) step = gradient inside the box; false when the free part is not positive definite.
  bool solveStep(const double (*H)[kWide]) {
    bool bound[kWide];
    for (int i = 0; i < n_; ++i) {
      bound[i] = fixed_[i];
      step_[i] = 0.0;
    }
    for (int round = 0; round <= n_; ++round) {
      alignas(32) double A[kWide][kWide];
      bool any = false;
      for (int i = 0; i < n_; ++i) {
        store(A[i], load(H[i]));
        store(A[i] + 4, load(H[i] + 4));
        A[i][i] += lambda_;
        A[i][7] = gradient_[i];
        any = any || bound[i];
      }
      if (any) hold(bound, A);
      if (!eliminate(A)) return false;
      bool crossed = false;
      for (int i = 0; i < n_; ++i) {
        if (bound[i]) continue;
        const double up = task_.upper[i] - x_[i], down = task_.lower[i] - x_[i], wanted = A[i][7];
        step_[i] = smaller(larger(wanted, down), up);
        if (wanted > up || wanted < down) bound[i] = crossed = true;
      }
      if (!crossed) return true;
    }
    return true;
  }

  // What is held moves to the right-hand side.
  void hold(const bool* bound, double (*A)[kWide]) const {
    for (int i = 0; i < n_; ++i) {
      if (!bound[i]) continue;
      for (int j = 0; j < n_; ++j) {
        if (!bound[j]) A[j][7] -= A[j][i] * step_[i];
      }
    }
    for (int i = 0; i < n_; ++i) {
      if (!bound[i]) continue;
      for (int j = 0; j < n_; ++j) A[i][j] = A[j][i] = 0.0;
      A[i][i] = 1.0;
      A[i][7] = step_[i];
    }
  }

  bool eliminate(double (*A)[kWide]) const {
    double inverse[kWide];
    for (int k = 0; k < n_; ++k) {
      if (!(A[k][k] > 0.0)) return false;
      inverse[k] = 1.0 / A[k][k];
      const Lanes low = load(A[k]), high = load(A[k] + 4);
      for (int i = k + 1; i < n_; ++i) {
        const double factor = A[i][k] * inverse[k];
        store(A[i], load(A[i]) - factor * low);
        store(A[i] + 4, load(A[i] + 4) - factor * high);
      }
    }
    for (int k = n_ - 1; k >= 0; --k) {
      double sum = A[k][7];
      for (int j = k + 1; j < n_; ++j) sum -= A[k][j] * A[j][7];
      A[k][7] = sum * inverse[k];
    }
    return true;
  }

  double gain(const double (*H)[kWide]) const {
    double sum = 0.0;
    for (int i = 0; i < n_; ++i) {
      double row = 0.0;
      for (int j = 0; j < n_; ++j) row += H[i][j] * step_[j];
      sum += step_[i] * (gradient_[i] - 0.5 * row);
    }
    return sum;
  }

  // Fixes variables that are on a bound and pushed outwards; false if no variable is left that could improve.
  bool fixBlocked() {
    double steepest = 0.0;
    for (int i = 0; i < n_; ++i) {
      const double slope = gradient_[i];
      fixed_[i] = (x_[i] <= task_.lower[i] && slope < 0.0) || (x_[i] >= task_.upper[i] && slope > 0.0);
      if (!fixed_[i]) steepest = larger(steepest, size(slope));
    }
    return steepest > 1e-13 * larger(1.0, 3.0 / arm_.scale) * __builtin_sqrt(2.0 * cost_);
  }

  bool tryStep(double predicted) {
    double moved[kWide] = {};
    for (int i = 0; i < n_; ++i) moved[i] = smaller(larger(x_[i] + step_[i], task_.lower[i]), task_.upper[i]);
    OneArm state;
    walkOne(arm_, moved, state);
    double e_p[3], e_r[3];
    const double cost = residual(state, e_p, e_r);
    if (!(cost < cost_) || !(predicted > 0.0)) {
      lambda_ = larger(lambda_, 1e-9 * largest_) * growth_;
      growth_ *= 2.0;
      return false;
    }
    const double ratio = (cost_ - cost) / predicted, off = 2.0 * ratio - 1.0;
    curved_ = task_.second_order && cost > 0.2 * cost_;
    lambda_ *= larger(0.125, 1.0 - off * off * off);
    if (ratio > 0.9) lambda_ = smaller(lambda_, 1e-3 * cost);
    growth_ = 4.0;
    for (int i = 0; i < kWide; ++i) x_[i] = moved[i];
    state_ = state;
    for (int i = 0; i < 3; ++i) {
      e_p_[i] = e_p[i];
      e_r_[i] = e_r[i];
    }
    cost_ = cost;
    return true;
  }

  void finish(FitAnswer& answer, int iterations) const {
    for (int i = 0; i < n_; ++i) answer.x[i] = x_[i];
    answer.position_error = __builtin_sqrt(dot3(e_p_, e_p_));
    answer.orientation_error = __builtin_sqrt(dot3(e_r_, e_r_));
    answer.held = false;
    for (int i = 0; i < n_; ++i) answer.held = answer.held || fixed_[i];
    answer.iterations = iterations;
  }
};

inline void fit(const TrueArm& arm, const FitTask& task, FitAnswer& answer) {
  Fit(arm, task).run(answer);
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
