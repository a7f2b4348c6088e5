// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/lanes.h"

namespace hapticell::kinematics::kernels {
namespace {

constexpr double kLanePi = 3.14159265358979323846;

/// atan2 of four pairs, worst error 5e-16 of the value; atan2(0, 0) is 0 or pi.
///
/// Reduction to |t| <= tan(pi / 8), then t + t z P(z) with z = t^2 and a minimax P of degree 10.
inline Lanes arcTangent(const Lanes& y, const Lanes& x) {
  constexpr double kTanEighth = 0.41421356237309503;
  constexpr double kP[] = {-0.3333333333333333016,   0.19999999999995520674,  -0.14285714284666542061,
                           0.11111111015256292406,   -0.090909045781210852,   0.076921831907606508698,
                           -0.066645114464602189763, 0.058581489047951238051, -0.050854496960392583287,
                           0.039231657085083680729,  -0.019176885636589044655};
  const Lanes ax = absolute(x), ay = absolute(y);
  const Lanes small = minimum(ax, ay), large = maximum(ax, ay);
  const Mask beyond = small > large * kTanEighth;
  const Lanes above = select(beyond, small - large, small);
  const Lanes below = maximum(select(beyond, small + large, large), 1e-300);
  const Lanes t = above / below;
  const Lanes z = t * t;
  Lanes polynomial = kP[10];
  for (int i = 9; i >= 0; --i) polynomial = polynomial * z + kP[i];
  Lanes angle = t + t * z * polynomial;
  angle += select(beyond, Lanes(0.25 * kLanePi), Lanes(0.0));
  angle = select(ay > ax, Lanes(0.5 * kLanePi) - angle, angle);
  angle = select(x < Lanes(0.0), Lanes(kLanePi) - angle, angle);
  return withSignOf(angle, y);
}

/// Sines and cosines of four angles, |angle| < 1e5 rad; error 2e-16. Reduction by pi / 2 in three parts (Cody and
/// Waite 1980), polynomials of the Cephes library.
inline void sineCosine(const Lanes& angle, Lanes& sine, Lanes& cosine) {
  // As in nearestWhole() of lanes.h.
  constexpr double kMagic = 6755399441055744.0;
  const Lanes shifted = angle * (2.0 / kLanePi) + Lanes(kMagic);
  const Lanes k = shifted - Lanes(kMagic);
  Lanes r = angle - k * 1.57079625129699707031;
  r = r - k * 7.54978941586159635335e-8;
  r = r - k * 5.39030285815811905290e-15;
  const Lanes z = r * r;
  Lanes s = 1.58962301576546568060e-10;
  constexpr double kSine[] = {-2.50507477628578072866e-8, 2.75573136213857245213e-6, -1.98412698295895385996e-4,
                              8.33333333332211858878e-3, -1.66666666666666307295e-1};
  for (const double coefficient : kSine) s = s * z + coefficient;
  s = r + r * z * s;
  Lanes c = -1.13585365213876817300e-11;
  constexpr double kCosine[] = {2.08757008419747316778e-9, -2.75573141792967388112e-7, 2.48015872888517045348e-5,
                                -1.38888888888730564116e-3, 4.16666666666665929218e-2};
  for (const double coefficient : kCosine) c = c * z + coefficient;
  c = Lanes(1.0) - 0.5 * z + z * z * c;
  const Lanes half = 0.5 * k;
  const Mask odd = absolute(half - nearestWhole(half)) > Lanes(0.25);
  const Lanes sine_size = select(odd, c, s), cosine_size = select(odd, s, c);
  for (int i = 0; i < kHalves; ++i) {  // the quadrant stands in the last bits of the shifted number
    const HalfMask quadrant = HalfMask(shifted.half[i]);
    sine.half[i] = Half(HalfMask(sine_size.half[i]) ^ ((quadrant << 62) & signBits()));
    cosine.half[i] = Half(HalfMask(cosine_size.half[i]) ^ (((quadrant + 1) << 62) & signBits()));
  }
}

/// Three coordinates of four vectors.
struct Lanes3 {
  Lanes x, y, z;
};
inline Lanes dot(const Lanes3& a, const Lanes3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Lanes3 operator*(const Lanes& s, const Lanes3& a) {
  return {s * a.x, s * a.y, s * a.z};
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
