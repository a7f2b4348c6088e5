// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/face_shape.h"

#include <cmath>
#include <numbers>

#include "mannequin/body/rotations.h"
#include "mannequin/shape/hair_shape.h"
#include "mannequin/shape/head_flesh.h"

namespace hapticell::mannequin {

namespace {

// m, of a man of 1.755 m. What follows is drawn only, our choice: half or twice changes how a face looks.
constexpr double kEyeRadius = 0.0122;
constexpr double kIris = 0.50, kPupil = 0.20;                      // rad about the line of sight.
constexpr double kOverWhite = 1.010, kOverIris = 1.016;            // Of the eye's radius.
constexpr double kLid = 1.085, kLidEdge = 1.02;                    // Of the eye's radius.
constexpr double kUpperLid = 0.24, kLowerLid = -0.23;              // rad, in the middle.
constexpr double kCorner = 1.10;                                   // rad to the side where both lids meet.
constexpr double kLidFrom = -1.45, kLidTo = 1.45, kLidEnd = 1.35;  // rad
constexpr std::array<float, 3> kWhite{0.90f, 0.89f, 0.87f}, kIrisColor{0.33f, 0.24f, 0.17f},
    kBlack{0.05f, 0.05f, 0.06f}, kLips{0.66f, 0.46f, 0.41f};

dvec3 onSphere(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

/// A sheet over a grid of `columns` x `rows` cells; its front is where columns turn to the left of rows.
template <typename Place>
geometry::TriangleMesh sheet(std::uint32_t columns, std::uint32_t rows, const Place& place) {
  geometry::TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) mesh.vertices.push_back(place(double(i) / columns, double(j) / rows));
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

/// A cap of a sphere about +x.
geometry::TriangleMesh cap(double radius, double angle) {
  // Triangles of eyes, drawn only. Half: corners are seen; twice: twice the triangles.
  constexpr std::uint32_t kAround = 20, kRings = 6;
  geometry::TriangleMesh mesh;
  mesh.vertices.emplace_back(radius, 0.0, 0.0);
  for (std::uint32_t ring = 1; ring <= kRings; ++ring) {
    const double off = angle * ring / kRings;
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kAround;
      mesh.vertices.push_back(radius *
                              dvec3(std::cos(off), std::sin(off) * std::cos(turn), std::sin(off) * std::sin(turn)));
    }
  }
  const auto at = [](std::uint32_t ring, std::uint32_t i) { return 1 + (ring - 1) * kAround + i % kAround; };
  for (std::uint32_t i = 0; i < kAround; ++i) {
    mesh.triangles.push_back({0, at(1, i), at(1, i + 1)});
    for (std::uint32_t ring = 1; ring < kRings; ++ring) {
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  return mesh;
}

/// Both lids of an eye: a shell about it, open between them like an almond.
geometry::TriangleMesh lids(const dvec3& centre, double radius) {
  geometry::TriangleMesh mesh;
  for (const bool upper : {true, false}) {
    const double open = upper ? kUpperLid : kLowerLid, end = upper ? kLidEnd : -kLidEnd;
    const auto place = [&](double across, double up) {
      const double azimuth = kLidFrom + (kLidTo - kLidFrom) * across;
      const double share = azimuth / kCorner, edge = open * std::max(0.0, 1.0 - share * share);
      // The edge is as near to the eye as it may be, so that no gap is seen from the side.
      const double away = upper ? up : 1.0 - up;  // Rows go upwards in both.
      const double r = radius * (kLid - (kLid - kLidEdge) * std::pow(1.0 - away, 6.0));
      return centre + r * onSphere(azimuth, edge + (end - edge) * away);
    };
    geometry::append(mesh, sheet(20, 8, place), Pose::identity());
  }
  return mesh;
}

/// The head's surface ahead of a place (y, z in HeadMeasures' coordinates), head frame.
dvec3 onFace(const HeadMeasures& m, const Flesh& head, double y, double z) {
  dvec3 p = m.at(0.14, y, z);
  for (int i = 0; i < 80; ++i) {
    const double d = head.distance(p);
    if (d < 1e-4) break;
    p.x -= 0.8 * d;
  }
  return p;
}

/// A strip that lies on the face between two lines across it, over y from `from` to `to`, as thick as `thick(across,
/// up)` says (both 0 .. 1), m; it ends under the skin.
template <typename Lower, typename Upper, typename Thick>
geometry::TriangleMesh strip(const HeadMeasures& m, const Flesh& head, double from, double to, const Lower& lower,
                             const Upper& upper, const Thick& thick) {
  // Of lips and brows, drawn only. Half: corners are seen; twice: twice the triangles.
  constexpr std::uint32_t kColumns = 28, kRows = 8;
  return sheet(kColumns, kRows, [&](double across, double up) {
    const double y = from + across * (to - from), low = lower(y);
    dvec3 p = onFace(m, head, y, low + up * (upper(y) - low));
    p.x += m.size() * thick(across, up);
    return p;
  });
}

/// Both lips: the upper one with its bow, the lower one fuller; they meet in a fold.
geometry::TriangleMesh lips(const HeadMeasures& m, const Flesh& head) {
  constexpr double kHalf = 0.0245, kMouth = -0.0665, kUnder = -0.0006;  // m
  const double full = m.female ? 1.2 : 1.0;
  const auto inside = [](double y) { return std::max(0.0, 1.0 - y * y / (kHalf * kHalf)); };
  const auto fold = [&](double y) { return kMouth - 0.0008 * (1.0 - inside(y)); };
  const auto bow = [&](double y) {
    return fold(y) + full * (0.0066 * std::pow(inside(y), 0.8) - 0.0015 * std::exp(-y * y / (0.0042 * 0.0042)));
  };
  const auto bottom = [&](double y) { return fold(y) - full * 0.0090 * std::pow(inside(y), 0.85); };
  const auto bulge = [&](double most) {
    return [=](double across, double up) {
      const double ends = 1.0 - std::pow(std::abs(2.0 * across - 1.0), 3.0);
      return kUnder + full * most * ends * std::sqrt(std::sin(std::numbers::pi * up));
    };
  };
  geometry::TriangleMesh mesh = strip(m, head, -kHalf, kHalf, fold, bow, bulge(0.0030));
  geometry::append(mesh, strip(m, head, -kHalf, kHalf, bottom, fold, bulge(0.0036)), Pose::identity());
  return mesh;
}

/// A brow, thinner outwards.
geometry::TriangleMesh brow(const HeadMeasures& m, const Flesh& head, double out) {
  const double wide = m.female ? 0.0040 : 0.0058;  // m
  const auto along = [](double y) { return std::clamp((std::abs(y) - 0.0130) / 0.0365, 0.0, 1.0); };
  const auto middle = [&](double y) {
    const double s = along(y);
    return 0.0162 + 0.0175 * s - 0.0195 * s * s;
  };
  const auto half = [&](double y) {
    const double s = along(y);
    return 0.5 * wide * std::min(1.0, 8.0 * s + 0.35) * (1.0 - 0.85 * s * s);
  };
  const auto hairs = [](double, double up) { return -0.0004 + 0.0014 * std::sqrt(std::sin(std::numbers::pi * up)); };
  const double inner = out * 0.0130, outer = out * 0.0495;
  return strip(
      m, head, std::min(inner, outer), std::max(inner, outer), [&](double y) { return middle(y) - half(y); },
      [&](double y) { return middle(y) + half(y); }, hairs);
}

}  // namespace

dvec3 eyeCentre(const Figure& figure, Side side) {
  return HeadMeasures(figure).at(0.0768, outwardSign(side) * 0.0320, 0.0);
}

std::vector<FacePiece> eyePieces(const Figure& figure) {
  const double radius = HeadMeasures(figure).size() * kEyeRadius;
  return {{kWhite, cap(radius, 2.0)},
          {kIrisColor, cap(kOverWhite * radius, kIris)},
          {kBlack, cap(kOverIris * radius, kPupil)}};
}

std::vector<FacePiece> facePieces(const Figure& figure) {
  const HeadMeasures m(figure);
  const Flesh head = headFlesh(figure);
  FacePiece skin{kSkinColor, {}}, brows{kHairColor, {}}, mouth{kLips, {}};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    geometry::append(skin.mesh, lids(eyeCentre(figure, side), m.size() * kEyeRadius), Pose::identity());
    geometry::append(brows.mesh, brow(m, head, outwardSign(side)), Pose::identity());
  }
  mouth.mesh = lips(m, head);
  std::vector<FacePiece> pieces;
  pieces.push_back(std::move(skin));
  pieces.push_back(std::move(brows));
  pieces.push_back(std::move(mouth));
  return pieces;
}

dmat3 eyeRotation(const Gaze& gaze) {
  return aboutZ(gaze.yaw) * aboutY(gaze.pitch);
}

}  // namespace hapticell::mannequin
