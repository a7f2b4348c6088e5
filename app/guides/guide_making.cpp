// SPDX-License-Identifier: Apache-2.0
#include "app/guides/guide_making.h"

#include <QObject>
#include <cmath>

#include "app/style/units.h"

namespace hapticell::app {
namespace {

using collision::SurfaceType;
using workcell::GuideKind;

bool needsAxis(GuideKind kind) {
  return kind == GuideKind::kLine || kind == GuideKind::kHinge || kind == GuideKind::kSlider ||
         kind == GuideKind::kScrew || kind == GuideKind::kCircle;
}

bool isRound(const PickedFeature& feature) {
  const SurfaceType type = feature.surface_W.type;
  if (feature.kind == FeatureKind::kEdge) return feature.edge == EdgeShape::kCircle;
  return feature.kind == FeatureKind::kFace &&
         (type == SurfaceType::kCylinder || type == SurfaceType::kCone || type == SurfaceType::kTorus);
}

bool isFlat(const PickedFeature& feature) {
  return feature.kind == FeatureKind::kFace && feature.surface_W.type == SurfaceType::kPlane;
}

bool hasDirection(const PickedFeature& feature) {
  return isRound(feature) || isFlat(feature) ||
         (feature.kind == FeatureKind::kEdge && feature.edge == EdgeShape::kLine);
}

/// Radius of what is round; 0 if it is not round.
double radiusOf(const PickedFeature& feature) {
  if (feature.kind == FeatureKind::kEdge) return feature.edge == EdgeShape::kCircle ? feature.radius : 0.0;
  if (feature.surface_W.type == SurfaceType::kTorus) return feature.surface_W.major_radius;
  return feature.surface_W.type == SurfaceType::kCylinder ? feature.surface_W.radius : 0.0;
}

}  // namespace

const std::vector<GuideKind>& guideKinds() {
  static const std::vector<GuideKind> kinds{
      GuideKind::kPoint,  GuideKind::kLine,  GuideKind::kPlane, GuideKind::kCircle,  GuideKind::kHinge,
      GuideKind::kSlider, GuideKind::kScrew, GuideKind::kTube,  GuideKind::kSurface, GuideKind::kLock};
  return kinds;
}

std::string guideKindName(GuideKind kind) {
  static const char* const names[]{QT_TRANSLATE_NOOP("Guides", "Point"),   QT_TRANSLATE_NOOP("Guides", "Line"),
                                   QT_TRANSLATE_NOOP("Guides", "Plane"),   QT_TRANSLATE_NOOP("Guides", "Circle"),
                                   QT_TRANSLATE_NOOP("Guides", "Hinge"),   QT_TRANSLATE_NOOP("Guides", "Slider"),
                                   QT_TRANSLATE_NOOP("Guides", "Screw"),   QT_TRANSLATE_NOOP("Guides", "Tube"),
                                   QT_TRANSLATE_NOOP("Guides", "Surface"), QT_TRANSLATE_NOOP("Guides", "Lock")};
  return names[static_cast<std::size_t>(kind)];
}

FeatureFilter guideFilter(GuideKind kind) {
  if (kind == GuideKind::kPoint || kind == GuideKind::kLock) return {true, true, true};
  if (kind == GuideKind::kSurface) return {true, false, false};
  if (kind == GuideKind::kTube) return {false, true, false};
  return {true, true, false};
}

QString guidePrompt(GuideKind kind) {
  switch (kind) {
    case GuideKind::kPoint:
      return QObject::tr("Pick the point: a corner, an edge or a face");
    case GuideKind::kPlane:
      return QObject::tr("Pick the plane: a flat face or a round edge");
    case GuideKind::kCircle:
      return QObject::tr("Pick the circle: a round edge or a round face");
    case GuideKind::kTube:
      return QObject::tr("Pick the path: an edge");
    case GuideKind::kSurface:
      return QObject::tr("Pick the surface to follow");
    case GuideKind::kLock:
      return QObject::tr("Pick the axes: a face, an edge or a corner");
    default:
      return QObject::tr("Pick the axis: a round face, an edge, or a flat face for its normal");
  }
}

bool takeGeometry(const PickedFeature& feature, const std::string& surface_name, workcell::Guide& guide) {
  const double radius = radiusOf(feature);
  if (needsAxis(guide.kind) && !hasDirection(feature)) return false;
  if (guide.kind == GuideKind::kCircle && radius <= 0.0) return false;
  if (guide.kind == GuideKind::kPlane && !isFlat(feature) && !isRound(feature)) return false;
  if (guide.kind == GuideKind::kTube) {
    if (feature.kind != FeatureKind::kEdge || feature.outline_W.empty()) return false;
    const std::vector<dvec3> path = thinnedPath(feature.outline_W.front());
    if (path.size() < 2) return false;
    guide.path = path;
  }
  if (guide.kind == GuideKind::kSurface) {
    if (feature.kind != FeatureKind::kFace || surface_name.empty()) return false;
    guide.surface = surface_name;
  }
  guide.X_WG = featureFrame_W(feature);
  if (guide.kind == GuideKind::kPoint && !(feature.kind == FeatureKind::kEdge && isRound(feature)))
    guide.X_WG.p = feature.p_WQ;
  if (guide.kind == GuideKind::kCircle) guide.radius = radius;
  return true;
}

QString geometryText(const workcell::Guide& guide) {
  const dvec3 p = 1000.0 * guide.X_WG.p;
  const QString at = numberText(p.x, 1) + ", " + numberText(p.y, 1) + ", " + numberText(p.z, 1);
  switch (guide.kind) {
    case GuideKind::kSurface:
      return guide.surface.empty() ? QObject::tr("not picked")
                                   : QObject::tr("Surface of %1").arg(QString::fromStdString(guide.surface));
    case GuideKind::kTube:
      return guide.path.size() < 2 ? QObject::tr("no path") : QObject::tr("Path of %1 points").arg(guide.path.size());
    case GuideKind::kPoint:
      return QObject::tr("Point %1").arg(at);
    case GuideKind::kPlane:
      return QObject::tr("Plane at %1").arg(at);
    case GuideKind::kCircle:
      return QObject::tr("Circle at %1").arg(at);
    case GuideKind::kLock:
      return QObject::tr("Axes at %1").arg(at);
    default:
      return QObject::tr("Axis at %1").arg(at);
  }
}

std::vector<dvec3> thinnedPath(const std::vector<dvec3>& points, std::size_t most) {
  // m: nearer points of a path are one; what is felt is no finer. Half, twice: no effect on drawn paths.
  constexpr double kApart = 1e-4;
  std::vector<dvec3> path;
  for (const dvec3& p : points)
    if (path.empty() || glm::distance(path.back(), p) >= kApart) path.push_back(p);
  if (path.size() < 2) return {};
  if (path.size() <= most) return path;
  std::vector<dvec3> thinned;
  for (std::size_t i = 0; i < most; ++i) thinned.push_back(path[i * (path.size() - 1) / (most - 1)]);
  return thinned;
}

bool canBeGuided(const workcell::Entity& entity) {
  return workcell::hasShape(entity.kind());
}

}  // namespace hapticell::app
