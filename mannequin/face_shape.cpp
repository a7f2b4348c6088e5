// SPDX-License-Identifier: Apache-2.0
#include "mannequin/face_shape.h"

#include <cmath>

#include "mannequin/hair_shape.h"
#include "mannequin/head_flesh.h"
#include "mannequin/rotations.h"

namespace hapticell::mannequin {

namespace {

constexpr double kEyeRadius = 0.0122;                              // m, of a man of 1.755 m.
constexpr double kIris = 0.50, kPupil = 0.20;                      // rad about the line of sight.
constexpr double kOverWhite = 1.010, kOverIris = 1.016;            // Of the eye's radius.
constexpr double kLid = 1.075, kLidEdge = 1.02;                    // Of the eye's radius.
constexpr double kUpperLid = 0.44, kLowerLid = -0.34;              // rad, in the middle.
constexpr double kCorner = 1.10;                                   // rad to the side where both lids meet.
constexpr double kLidFrom = -1.45, kLidTo = 1.45, kLidEnd = 1.35;  // rad
constexpr std::array<float, 3> kWhite{0.90f, 0.89f, 0.87f}, kIrisColor{0.33f, 0.24f, 0.17f},
    kBlack{0.05f, 0.05f, 0.06f}, kLips{0.70f, 0.47f, 0.42f};

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
  constexpr std::uint32_t kAround = 20, kRings = 6;
  geometry::TriangleMesh mesh;
  mesh.vertices.emplace_back(radius, 0.0, 0.0);
  for (std::uint32_t ring = 1; ring <= kRings; ++ring) {
    const double off = angle * ring / kRings;
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double turn = 2.0 * M_PI * i / kAround;
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

/// A rope along places on the face, sunk in by `sunk` m.
geometry::TriangleMesh rope(const HeadMeasures& m, const Flesh& head, const std::vector<glm::dvec3>& places,
                            double sunk) {
  Flesh flesh{{}, 0.003, -1e9, {}, {}};
  std::vector<dvec3> points;
  for (const auto& yzr : places) {
    dvec3 p = onFace(m, head, yzr.x, yzr.y);
    p.x -= sunk;
    points.push_back(p);
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    flesh.blobs.push_back(
        {points[i], points[i + 1], m.size() * places[i].z, m.size() * places[i + 1].z, {0.8, 1.0, 1.0}});
  return bodyMesh(flesh, 0.0016);
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
  FacePiece skin{kSkinColor, {}}, brows{kHairColor, {}}, lips{kLips, {}};
  const double thick = m.female ? 0.0024 : 0.0034;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double out = outwardSign(side);
    geometry::append(skin.mesh, lids(eyeCentre(figure, side), m.size() * kEyeRadius), Pose::identity());
    geometry::append(brows.mesh,
                     rope(m, head,
                          {{out * 0.0135, 0.0170, thick},
                           {out * 0.0270, 0.0205, thick},
                           {out * 0.0390, 0.0205, 0.8 * thick},
                           {out * 0.0480, 0.0160, 0.4 * thick}},
                          0.0010),
                     Pose::identity());
  }
  const std::vector<glm::dvec3> upper{{-0.0235, -0.0650, 0.0016},
                                      {-0.0090, -0.0615, 0.0036},
                                      {0.0, -0.0625, 0.0032},
                                      {0.0090, -0.0615, 0.0036},
                                      {0.0235, -0.0650, 0.0016}};
  const std::vector<glm::dvec3> lower{
      {-0.0225, -0.0660, 0.0016}, {-0.0080, -0.0710, 0.0044}, {0.0080, -0.0710, 0.0044}, {0.0225, -0.0660, 0.0016}};
  geometry::append(lips.mesh, rope(m, head, upper, 0.0013), Pose::identity());
  geometry::append(lips.mesh, rope(m, head, lower, 0.0018), Pose::identity());
  std::vector<FacePiece> pieces;
  pieces.push_back(std::move(skin));
  pieces.push_back(std::move(brows));
  pieces.push_back(std::move(lips));
  return pieces;
}

dmat3 eyeRotation(const Gaze& gaze) {
  return aboutZ(gaze.yaw) * aboutY(gaze.pitch);
}

}  // namespace hapticell::mannequin
