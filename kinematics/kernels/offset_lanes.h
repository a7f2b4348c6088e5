// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/opw_lanes.h"

namespace hapticell::kinematics::kernels {
namespace {

/// What a branch of joints 1 to 3 makes of joint 6 at t: axes of frame 3 and how far axes 4 and 5 are from square.
struct OffsetPoint {
  Lanes c1, s1, sin2, cos2, sin3, cos3, s23, c23, f;
  Lanes margin;  ///< Negative where the wrist is out of reach and was put on its edge.
};

inline Lanes3 onCircle(const Circle& circle, const Lanes& c, const Lanes& s) {
  return {circle.middle[0] + c * circle.cosine[0] + s * circle.sine[0],
          circle.middle[1] + c * circle.cosine[1] + s * circle.sine[1],
          circle.middle[2] + c * circle.cosine[2] + s * circle.sine[2]};
}

/// Where the wrist is out of reach it is taken as just in reach, so that the ends of an arc are defined.
inline OffsetPoint offsetPoint(const OffsetArm& arm, const Lanes& t, const Lanes& side, const Lanes& elbow) {
  Lanes s, c;
  sineCosine(t, s, c);
  const Lanes3 w = onCircle(arm.wrist, c, s), axis5 = onCircle(arm.axis_5, c, s);
  const OpwArm& opw = arm.arm;
  const Lanes flat = maximum(w.x * w.x + w.y * w.y, 1e-300);
  const Lanes ahead = flat - opw.b * opw.b;
  const Lanes X = side * squareRoot(maximum(ahead, 0.0));
  OffsetPoint point;
  const Lanes flat_inverse = 1.0 / flat;
  point.c1 = (w.x * X + w.y * opw.b) * flat_inverse;
  point.s1 = (w.y * X - w.x * opw.b) * flat_inverse;
  const Lanes x = X - opw.a1;
  const Lanes r2 = maximum(x * x + w.z * w.z, 1e-300);
  const Lanes cosine = (r2 - (opw.c2 * opw.c2 + opw.k * opw.k)) * (0.5 / (opw.c2 * opw.k));
  const Lanes c3 = minimum(maximum(cosine, -1.0), 1.0);
  point.margin = minimum(ahead, Lanes(1.0) - absolute(cosine));
  const Lanes s3 = elbow * squareRoot((Lanes(1.0) - c3) * (Lanes(1.0) + c3));
  const Lanes A = c3 * opw.k + opw.c2, B = s3 * opw.k;
  const Lanes r2_inverse = 1.0 / r2;
  point.sin2 = (A * x - B * w.z) * r2_inverse;
  point.cos2 = (A * w.z + B * x) * r2_inverse;
  point.sin3 = s3 * opw.cos_psi - c3 * opw.sin_psi;
  point.cos3 = c3 * opw.cos_psi + s3 * opw.sin_psi;
  point.s23 = point.sin2 * point.cos3 + point.cos2 * point.sin3;
  point.c23 = point.cos2 * point.cos3 - point.sin2 * point.sin3;
  point.f = (point.c1 * axis5.x + point.s1 * axis5.y) * point.s23 + axis5.z * point.c23;
  return point;
}

/// A stretch of joint 6 where the wrist is in reach; u in [0, 1] runs along it so that a square root at its ends
/// becomes smooth.
struct Arc {
  double middle = 0.0, half = kLanePi;
  bool closed = true;  ///< The whole circle: no ends.
};

inline double alongArc(const Arc& arc, double u) {
  return arc.middle + arc.half * (arc.closed ? 2.0 * u - 1.0 : -__builtin_cos(kLanePi * u));
}

struct Bracket {
  double u0, f0, u1, f1;
  double middle, half, closed, side, elbow;
};

/// All of one search.
struct OffsetSearch {
  static constexpr int kMost = 64;
  const OffsetArm& arm;
  Bracket brackets[kMost];
  int count = 0;

  void add(const Arc& arc, double side, double elbow, double u0, double f0, double u1, double f1) {
    if (count < kMost) {
      brackets[count++] = {u0, f0, u1, f1, arc.middle, arc.half, arc.closed ? 1.0 : 0.0, side, elbow};
    }
  }

  /// Looks at one interval with the second differences at its ends: is there a sign change, or may two more roots hide?
  void look(const Arc& arc, double side, double elbow, const double* u, const double* f, double bend, int depth) {
    const double a = f[0] < 0.0 ? -f[0] : f[0], b = f[1] < 0.0 ? -f[1] : f[1];
    const bool change = (f[0] < 0.0) != (f[1] < 0.0);
    const bool suspicious = change ? bend > 0.5 * (a + b) : (a < b ? a : b) < 2.0 * bend;
    if (!suspicious || depth == 0) {
      if (change) add(arc, side, elbow, u[0], f[0], u[1], f[1]);
      return;
    }
    double inner[8], value[8];  // 0 .. 5, two spare for the lanes
    for (int i = 0; i < 6; ++i) inner[i] = u[0] + (u[1] - u[0]) * (0.2 * i);
    inner[5] = u[1];
    const Lanes t(alongArc(arc, inner[1]), alongArc(arc, inner[2]), alongArc(arc, inner[3]), alongArc(arc, inner[4]));
    value[0] = f[0];
    store(value + 1, offsetPoint(arm, t, side, elbow).f);
    value[5] = f[1];
    lookAtAll(arc, side, elbow, inner, value, 6, false, depth - 1);
  }

  void lookAtAll(const Arc& arc, double side, double elbow, const double* u, const double* f, int points, bool closed,
                 int depth) {
    const auto bendAt = [&](int i) {
      const int before = i > 0 ? i - 1 : (closed ? points - 2 : 1),
                after = i < points - 1 ? i + 1 : (closed ? 1 : points - 2);
      if (!closed && (i == 0 || i == points - 1)) return 0.0;
      const double bend = f[before] - 2.0 * f[i] + f[after];
      return bend < 0.0 ? -bend : bend;
    };
    double last = bendAt(0);
    for (int i = 0; i + 1 < points; ++i) {
      const double next = bendAt(i + 1);
      look(arc, side, elbow, u + i, f + i, last > next ? last : next, depth);
      last = next;
    }
  }
};

/// Anderson and Bjoerck's method (1973) on four brackets at once; u where f vanishes.
inline Lanes bracketRoots(const OffsetArm& arm, const Bracket* brackets, int count, Lanes& t, OffsetPoint& point) {
  double fields[9][4];
  for (int k = 0; k < 4; ++k) {
    const Bracket& b = brackets[k < count ? k : count - 1];
    const double values[9] = {b.u0, b.f0, b.u1, b.f1, b.middle, b.half, b.closed, b.side, b.elbow};
    for (int i = 0; i < 9; ++i) fields[i][k] = values[i];
  }
  Lanes u0 = load(fields[0]), f0 = load(fields[1]), u1 = load(fields[2]), f1 = load(fields[3]);
  const Lanes middle = load(fields[4]), half = load(fields[5]), side = load(fields[7]), elbow = load(fields[8]);
  const Mask closed = load(fields[6]) > Lanes(0.5);
  Lanes u = u0;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Lanes width = u1 - u0, drop = f1 - f0;
    Lanes next = u1 - f1 * width / select(absolute(drop) > Lanes(1e-300), drop, Lanes(1.0));
    // Every fourth step halves, so that a flat end cannot hold it up.
    if (iteration % 4 == 3) next = 0.5 * (u0 + u1);
    const Lanes moved = absolute(next - u);
    u = next;
    Lanes s, c;
    sineCosine(kLanePi * u, s, c);
    t = middle + half * select(closed, 2.0 * u - Lanes(1.0), -c);
    point = offsetPoint(arm, t, side, elbow);
    const Lanes f = point.f;
    const Mask crossed = (f * f1) <= Lanes(0.0);
    const Lanes ratio = Lanes(1.0) - f / select(absolute(f1) > Lanes(1e-300), f1, Lanes(1.0));
    const Lanes weight = select(ratio > Lanes(0.0), ratio, Lanes(0.5));
    u0 = select(crossed, u1, u0);
    f0 = select(crossed, f1, f0 * weight);
    u1 = u;
    f1 = f;
    const Mask done = (absolute(f) < Lanes(3e-16)) | (absolute(u1 - u0) < Lanes(1e-16)) | (moved < Lanes(1e-17));
    if (bitsOf(done) == 0xfu) break;
  }
  return u;
}

inline int arcsWithoutOffsets(const OffsetArm& arm, Arc arcs[2]) {
  const Circle& w = arm.wrist;
  double constant = 0.0, cosine = 0.0, sine = 0.0;
  for (int i = 0; i < 3; ++i) {
    constant += w.middle[i] * w.middle[i] + w.cosine[i] * w.cosine[i];
    cosine += 2.0 * w.middle[i] * w.cosine[i];
    sine += 2.0 * w.middle[i] * w.sine[i];
  }
  const double amplitude = __builtin_sqrt(cosine * cosine + sine * sine), phase = __builtin_atan2(sine, cosine);
  const double near = arm.arm.c2 - arm.arm.k, far = arm.arm.c2 + arm.arm.k;
  const double lowest = near * near - constant, highest = far * far - constant;
  if (lowest > amplitude || highest < -amplitude) return 0;
  const bool cut_far = highest<amplitude, cut_near = lowest> - amplitude;
  if (!cut_far && !cut_near) {
    arcs[0] = {phase, kLanePi, true};
    return 1;
  }
  const double begin = cut_far ? __builtin_acos(highest / amplitude) : 0.0;
  const double end = cut_near ? __builtin_acos(lowest / amplitude) : kLanePi;
  if (!cut_far) {
    arcs[0] = {phase, end, false};
    return 1;
  }
  if (!cut_near) {
    arcs[0] = {phase + kLanePi, kLanePi - begin, false};
    return 1;
  }
  arcs[0] = {phase + 0.5 * (begin + end), 0.5 * (end - begin), false};
  arcs[1] = {phase - 0.5 * (begin + end), 0.5 * (end - begin), false};
  return 2;
}

/// 1 - cos^2 of the elbow, negative out of reach.
inline double inReach(const OffsetArm& arm, double t, double side) {
  const double c = __builtin_cos(t), s = __builtin_sin(t);
  double w[3];
  for (int i = 0; i < 3; ++i) w[i] = arm.wrist.middle[i] + c * arm.wrist.cosine[i] + s * arm.wrist.sine[i];
  const double ahead = w[0] * w[0] + w[1] * w[1] - arm.arm.b * arm.arm.b;
  if (ahead < 0.0) return ahead;
  const double x = side * __builtin_sqrt(ahead) - arm.arm.a1;
  const double c3 =
      (x * x + w[2] * w[2] - arm.arm.c2 * arm.arm.c2 - arm.arm.k * arm.arm.k) / (2.0 * arm.arm.c2 * arm.arm.k);
  return (1.0 - c3) * (1.0 + c3);
}

/// With a shoulder or arm offset the reach is no plain cosine: its ends are bracketed on a grid.
inline int arcsBySampling(const OffsetArm& arm, double side, Arc arcs[4]) {
  constexpr int kGrid = 96;
  double ends[8];
  int changes = 0;
  const double first = inReach(arm, 0.0, side);
  double before = first;
  for (int i = 1; i <= kGrid && changes < 8; ++i) {
    double a = 2.0 * kLanePi * (i - 1) / kGrid, b = 2.0 * kLanePi * i / kGrid;
    const double now = i == kGrid ? first : inReach(arm, b, side);
    if ((now < 0.0) != (before < 0.0)) {
      for (int k = 0; k < 48; ++k) {
        const double middle = 0.5 * (a + b);
        ((inReach(arm, middle, side) < 0.0) == (before < 0.0) ? a : b) = middle;
      }
      ends[changes++] = before < 0.0 ? b : a;
    }
    before = now;
  }
  if (changes == 0) {
    arcs[0] = {0.0, kLanePi, true};
    return first < 0.0 ? 0 : 1;
  }
  int count = 0;
  for (int i = first < 0.0 ? 0 : 1; count < changes / 2; i += 2, ++count) {
    const double begin = ends[i];
    const double end = i + 1 < changes ? ends[i + 1] : ends[0] + 2.0 * kLanePi;
    arcs[count] = {0.5 * (begin + end), 0.5 * (end - begin), false};
  }
  return count;
}

inline void sampleArc(const OffsetArm& arm, const Arc& arc, int points, double side, double elbow,
                      OffsetSearch& search) {
  double u[80], t[80], f[80];
  for (int i = 0; i <= points; ++i) {
    u[i] = static_cast<double>(i) / points;
    t[i] = alongArc(arc, u[i]);
  }
  for (int i = points + 1; i < points + 4; ++i) t[i] = t[points];
  for (int i = 0; i <= points; i += 4) store(f + i, offsetPoint(arm, load(t + i), side, elbow).f);
  if (arc.closed) f[points] = f[0];
  search.lookAtAll(arc, side, elbow, u, f, points + 1, arc.closed, 6);
}

inline void offsetWrist(const OffsetArm& arm, Solutions& solutions) {
  OffsetSearch search{arm, {}, 0};
  const bool plain = (arm.arm.a1 < 1e-9 && arm.arm.a1 > -1e-9) && (arm.arm.b < 1e-9 && arm.arm.b > -1e-9);
  Arc arcs[4];
  int count = plain ? arcsWithoutOffsets(arm, arcs) : 0;
  constexpr double kBoth[] = {1.0, -1.0};
  for (const double side : kBoth) {
    if (!plain) count = arcsBySampling(arm, side, arcs);
    for (int i = 0; i < count; ++i) {
      for (const double elbow : kBoth) sampleArc(arm, arcs[i], count > 1 ? 40 : 64, side, elbow, search);
    }
  }
  solutions.valid = 0;
  int slot = 0;
  for (int first = 0; first < search.count && slot < kMaxSolutions; first += 4) {
    const int lanes = search.count - first < 4 ? search.count - first : 4;
    Lanes t;
    OffsetPoint point;
    bracketRoots(arm, search.brackets + first, lanes, t, point);
    Lanes s, c;
    sineCosine(t, s, c);
    const Lanes3 x5 = onCircle(arm.across_5, c, s), y5 = onCircle(arm.axis_5, c, s), z5 = onCircle(arm.along_5, c, s);
    const Lanes3 x3{point.c1 * point.c23, point.s1 * point.c23, -point.s23};
    const Lanes3 z3{point.c1 * point.s23, point.s1 * point.s23, point.c23};
    const Lanes q[6] = {
        arcTangent(point.s1, point.c1),        arcTangent(point.sin2, point.cos2),
        arcTangent(point.sin3, point.cos3),    arcTangent(-dot(y5, x3), point.c1 * y5.y - point.s1 * y5.x),
        arcTangent(-dot(x5, z3), dot(z5, z3)), t};
    for (int lane = 0; lane < lanes && slot < kMaxSolutions; ++lane) {
      if (!(point.f[lane] < 1e-9 && point.f[lane] > -1e-9 && point.margin[lane] > -1e-11)) continue;
      for (int joint = 0; joint < 6; ++joint) {
        solutions.q[joint][slot] = (q[joint][lane] - arm.arm.map.offset[joint]) * arm.arm.map.sign[joint];
      }
      solutions.valid |= 1u << slot++;
    }
  }
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
