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

/// What joint 6 at t makes of the shoulder; the same for both elbows.
struct ShoulderPoint {
  Lanes c1, s1, x, z, r2_inverse, c3, s3_size, ahead, up;  ///< `ahead` and `up`: axis 5 in the arm's plane.
  Lanes margin;
};

/// Where the wrist is out of reach it is taken as just in reach, so that the ends of an arc are defined.
inline ShoulderPoint shoulderPoint(const OffsetArm& arm, const Lanes& t, const Lanes& side) {
  Lanes s, c;
  sineCosine(t, s, c);
  const Lanes3 w = onCircle(arm.wrist, c, s), axis5 = onCircle(arm.axis_5, c, s);
  const OpwArm& opw = arm.arm;
  const Lanes flat = maximum(w.x * w.x + w.y * w.y, 1e-300);
  const Lanes ahead = flat - opw.b * opw.b;
  const Lanes X = side * squareRoot(maximum(ahead, 0.0));
  ShoulderPoint point;
  const Lanes flat_inverse = 1.0 / flat;
  point.c1 = (w.x * X + w.y * opw.b) * flat_inverse;
  point.s1 = (w.y * X - w.x * opw.b) * flat_inverse;
  point.x = X - opw.a1;
  point.z = w.z;
  const Lanes r2 = maximum(point.x * point.x + w.z * w.z, 1e-300);
  point.r2_inverse = 1.0 / r2;
  const Lanes cosine = (r2 - (opw.c2 * opw.c2 + opw.k * opw.k)) * (0.5 / (opw.c2 * opw.k));
  point.c3 = minimum(maximum(cosine, -1.0), 1.0);
  point.s3_size = squareRoot((Lanes(1.0) - point.c3) * (Lanes(1.0) + point.c3));
  point.margin = minimum(ahead, Lanes(1.0) - absolute(cosine));
  point.ahead = point.c1 * axis5.x + point.s1 * axis5.y;
  point.up = axis5.z;
  return point;
}

inline OffsetPoint offsetPoint(const OffsetArm& arm, const ShoulderPoint& at, const Lanes& elbow) {
  const OpwArm& opw = arm.arm;
  OffsetPoint point;
  point.c1 = at.c1;
  point.s1 = at.s1;
  point.margin = at.margin;
  const Lanes s3 = elbow * at.s3_size;
  const Lanes A = at.c3 * opw.k + opw.c2, B = s3 * opw.k;
  point.sin2 = (A * at.x - B * at.z) * at.r2_inverse;
  point.cos2 = (A * at.z + B * at.x) * at.r2_inverse;
  point.sin3 = s3 * opw.cos_psi - at.c3 * opw.sin_psi;
  point.cos3 = at.c3 * opw.cos_psi + s3 * opw.sin_psi;
  point.s23 = point.sin2 * point.cos3 + point.cos2 * point.sin3;
  point.c23 = point.cos2 * point.cos3 - point.sin2 * point.sin3;
  point.f = at.ahead * point.s23 + at.up * point.c23;
  return point;
}

inline OffsetPoint offsetPoint(const OffsetArm& arm, const Lanes& t, const Lanes& side, const Lanes& elbow) {
  return offsetPoint(arm, shoulderPoint(arm, t, side), elbow);
}

/// A stretch of joint 6 where the wrist is in reach; u in [0, 1] runs along it so that a square root at its ends
/// becomes smooth.
struct Arc {
  double middle = 0.0, half = kLanePi;
  bool closed = true;  ///< The whole circle: no ends.
};

inline Lanes alongArc(const Arc& arc, const Lanes& u) {
  if (arc.closed) return arc.middle + arc.half * (2.0 * u - Lanes(1.0));
  Lanes s, c;
  sineCosine(kLanePi * u, s, c);
  return arc.middle - arc.half * c;
}

struct Bracket {
  double u0, f0, u1, f1;
  double middle, half, closed, side, elbow;
};

/// One of the four branches of joints 1 to 3 on one arc.
struct Branch {
  Arc arc;
  double side = 1.0, elbow = 1.0;
};

/// Places along an arc with what a branch makes of them; room for some more than `count`, as lanes write by fours.
struct ArcSamples {
  /// kGrid and two ends, rounded up to whole lanes with a group to spare.
  static constexpr int kRoom = 104;
  double u[kRoom], f[kRoom], c1[kRoom], s1[kRoom];
  int count = 0;

  void take(int to, const ArcSamples& from, int i) {
    f[to] = from.f[i];
    c1[to] = from.c1[i];
    s1[to] = from.s1[i];
    u[to] = from.u[i];
  }
  /// u[i] .. u[i + 3] and what stands there.
  void put(int i, const Lanes& at_u, const OffsetPoint& point) {
    store(u + i, at_u);
    store(f + i, point.f);
    store(c1 + i, point.c1);
    store(s1 + i, point.s1);
  }
};

/// All of one search.
struct OffsetSearch {
  /// Intervals with a root: four times the 16 solutions possible, for rounding beside double roots. More are dropped;
  /// half: still twice what an arm has; twice: memory only.
  static constexpr int kMost = 64;
  const OffsetArm& arm;
  Bracket brackets[kMost];
  int count = 0;

  void add(const Branch& branch, double u0, double f0, double u1, double f1) {
    const Arc& arc = branch.arc;
    if (count < kMost) {
      brackets[count++] = {u0, f0, u1, f1, arc.middle, arc.half, arc.closed ? 1.0 : 0.0, branch.side, branch.elbow};
    }
  }

  /// Looks at one interval with the second differences at its ends: is there a sign change, or may two more roots hide?
  /// They may too where the wrist passes axis 1 so near that joint 1 turns much within the interval.
  void look(const Branch& branch, const ArcSamples& at, int i, double bend, int depth) {
    const double f0 = at.f[i], f1 = at.f[i + 1], a = f0 < 0.0 ? -f0 : f0, b = f1 < 0.0 ? -f1 : f1;
    const bool change = (f0 < 0.0) != (f1 < 0.0);
    const bool swings = at.c1[i] * at.c1[i + 1] + at.s1[i] * at.s1[i + 1] < 0.8;
    const double nearer = a < b ? a : b;
    const bool suspicious = change ? bend > 0.35 * (a + b) : nearer < 3.0 * bend;
    if (depth == 0 || !(suspicious || swings)) {
      if (change) add(branch, at.u[i], f0, at.u[i + 1], f1);
      return;
    }
    ArcSamples inner;
    inner.count = 6;
    inner.take(0, at, i);
    const Lanes u = at.u[i] + (at.u[i + 1] - at.u[i]) * Lanes(0.2, 0.4, 0.6, 0.8);
    inner.put(1, u, offsetPoint(arm, alongArc(branch.arc, u), branch.side, branch.elbow));
    inner.take(5, at, i + 1);
    lookAtAll(branch, inner, false, depth - 1);
  }

  void lookAtAll(const Branch& branch, const ArcSamples& at, bool closed, int depth) {
    const int last_point = at.count - 1;
    const auto bendAt = [&](int i) {
      if (!closed && (i == 0 || i == last_point)) return 0.0;
      const int before = i > 0 ? i - 1 : last_point - 1, after = i < last_point ? i + 1 : 1;
      const double bend = at.f[before] - 2.0 * at.f[i] + at.f[after];
      return bend < 0.0 ? -bend : bend;
    };
    double last = bendAt(0);
    for (int i = 0; i < last_point; ++i) {
      const double next = bendAt(i + 1);
      look(branch, at, i, last > next ? last : next, depth);
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
  Lanes u = u0, size = maximum(absolute(f0), absolute(f1));
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Lanes width = u1 - u0, drop = f1 - f0;
    Lanes next = u1 - f1 * width / select(absolute(drop) > Lanes(1e-300), drop, Lanes(1.0));
    // Where three steps brought little the fourth halves, so that a flat end cannot hold it up.
    if (iteration % 4 == 3) {
      const Lanes now = absolute(f1);
      next = select(now > 0.1 * size, 0.5 * (u0 + u1), next);
      size = now;
    }
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
  // Places where the ends of reach are looked for, 3.75 degrees apart; chosen by trial. Half: arcs narrower than 7.5
  // degrees are missed; twice: twice the time of that arm's search.
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

/// Both elbows' branches on one arc; `points` is a multiple of four.
inline void sampleArc(const OffsetArm& arm, const Arc& arc, double side, int points, OffsetSearch& search) {
  ArcSamples at[2];
  const double step = 1.0 / points;
  for (int i = 0; i <= points; i += 4) {
    const Lanes u = minimum(step * Lanes(i, i + 1, i + 2, i + 3), 1.0);
    const ShoulderPoint point = shoulderPoint(arm, alongArc(arc, u), side);
    at[0].put(i, u, offsetPoint(arm, point, 1.0));
    at[1].put(i, u, offsetPoint(arm, point, -1.0));
  }
  for (int elbow = 0; elbow < 2; ++elbow) {
    at[elbow].count = points + 1;
    if (arc.closed) at[elbow].take(points, at[elbow], 0);
    at[elbow].u[points] = 1.0;
    search.lookAtAll({arc, side, elbow == 0 ? 1.0 : -1.0}, at[elbow], arc.closed, 6);
  }
}

inline void offsetWrist(const OffsetArm& arm, Solutions& solutions) {
  OffsetSearch search{arm, {}, 0};
  const bool plain = (arm.arm.a1 < 1e-9 && arm.arm.a1 > -1e-9) && (arm.arm.b < 1e-9 && arm.arm.b > -1e-9);
  Arc arcs[4];
  int count = plain ? arcsWithoutOffsets(arm, arcs) : 0;
  constexpr double kBoth[] = {1.0, -1.0};
  for (const double side : kBoth) {
    if (!plain) count = arcsBySampling(arm, side, arcs);
    for (int i = 0; i < count; ++i) sampleArc(arm, arcs[i], side, count > 1 ? 40 : 64, search);
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
