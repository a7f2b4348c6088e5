// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/tools/picked_feature.h"

#include <QCoreApplication>
#include <cmath>

#include "app/viewport/scene/strip_text.h"

namespace hapticell::app {
namespace {

using collision::SurfaceType;

/// The shortest turn that brings W's z onto `axis`: x and y stay near W's own.
dquat turnedOnto(const dvec3& axis) {
  const dvec3 z(0.0, 0.0, 1.0);
  const double c = glm::dot(z, axis);
  if (c < -1.0 + 1e-12) return {0.0, 1.0, 0.0, 0.0};
  const dvec3 v = glm::cross(z, axis);
  return glm::normalize(dquat(1.0 + c, v.x, v.y, v.z));
}

dvec3 footOnAxis(const dvec3& p, const dvec3& origin, const dvec3& axis) {
  return origin + glm::dot(p - origin, axis) * axis;
}

struct FeatureText {
  Q_DECLARE_TR_FUNCTIONS(FeatureText)
};

std::string withRadius(const QString& name, double radius) {
  return name.toStdString() + ", R " + millimetres(radius);
}

std::string faceText(const collision::SurfaceShape& shape) {
  switch (shape.type) {
    case SurfaceType::kPlane:
      return FeatureText::tr("Plane").toStdString();
    case SurfaceType::kCylinder:
      return withRadius(shape.side < 0.0 ? FeatureText::tr("Bore") : FeatureText::tr("Cylinder"), shape.radius);
    case SurfaceType::kCone:
      return FeatureText::tr("Cone").toStdString();
    case SurfaceType::kSphere:
      return withRadius(FeatureText::tr("Sphere"), shape.radius);
    case SurfaceType::kTorus:
      return withRadius(FeatureText::tr("Ring"), shape.major_radius);
    case SurfaceType::kFreeForm:
      break;
  }
  return FeatureText::tr("Face").toStdString();
}

double lengthOf(const std::vector<dvec3>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
  return length;
}

}  // namespace

Pose featureFrame_W(const PickedFeature& feature) {
  if (feature.kind == FeatureKind::kVertex) return Pose::translation(feature.p_WQ);
  if (feature.kind == FeatureKind::kEdge) {
    if (feature.edge == EdgeShape::kCurve) return Pose::translation(feature.p_WQ);
    const bool circle = feature.edge == EdgeShape::kCircle;
    return {circle ? feature.center_W : feature.p_WQ, turnedOnto(feature.axis_W)};
  }
  const collision::SurfaceShape& shape = feature.surface_W;
  switch (shape.type) {
    case SurfaceType::kPlane:
      return {feature.p_WQ, turnedOnto(feature.nhat_W)};
    case SurfaceType::kCylinder:
    case SurfaceType::kCone:
      return {footOnAxis(feature.p_WQ, shape.p_M, shape.axis_M), turnedOnto(shape.axis_M)};
    case SurfaceType::kTorus:
      return {shape.p_M, turnedOnto(shape.axis_M)};
    case SurfaceType::kSphere:
      return Pose::translation(shape.p_M);
    case SurfaceType::kFreeForm:
      break;
  }
  return {feature.p_WQ, turnedOnto(feature.nhat_W)};
}

std::string featureText(const PickedFeature& feature) {
  if (feature.kind == FeatureKind::kVertex) return FeatureText::tr("Corner").toStdString();
  if (feature.kind == FeatureKind::kFace) return faceText(feature.surface_W);
  if (feature.edge == EdgeShape::kCircle) return withRadius(FeatureText::tr("Circle"), feature.radius);
  const double length = feature.outline_W.empty() ? 0.0 : lengthOf(feature.outline_W.front());
  return (feature.edge == EdgeShape::kLine ? FeatureText::tr("Edge, ") : FeatureText::tr("Curved edge, "))
             .toStdString() +
         millimetres(length);
}

}  // namespace hapticell::app
