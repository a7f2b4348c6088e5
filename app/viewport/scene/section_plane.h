// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_curve.h"

namespace hapticell::app {

/// A plane that cuts the picture open: what is beyond it, where nhat_W . p > offset, is not drawn; closed parts get a
/// hatched cap. Only the picture is cut, not the collision shapes. A value; no OpenGL.
struct SectionPlane {
  dvec3 nhat_W{0.0, -1.0, 0.0};  ///< Unit, towards the side that is cut away.
  double offset = 0.0;           ///< m

  bool operator==(const SectionPlane&) const = default;
};

/// The plane perpendicular to the cell's axis nearest to the viewing direction, through the middle of `bounds_W`: the
/// eye's side is cut away.
SectionPlane sectionFacing(const Camera& camera, const geometry::Bounds& bounds_W);

/// The plane perpendicular to an axis (0: X, 1: Y, 2: Z), through the middle of `bounds_W`: cuts away the eye's side.
SectionPlane sectionAcross(int axis, const Camera& camera, const geometry::Bounds& bounds_W);

/// The plane that cuts away the other side.
SectionPlane flipped(const SectionPlane& plane);

/// 0, 1 or 2: the axis that the plane is perpendicular to.
int axisOf(const SectionPlane& plane);

/// The curves that show it: its border over `bounds_W` and the handle that moves it, with the position in mm.
std::vector<SceneCurve> sectionCurves(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                                      const ViewSize& size);

/// A ray of sight from where it enters what is drawn: from the plane if the eye is on the side that is cut away.
Ray fromSection(const SectionPlane& plane, Ray ray);

/// Whether a pixel is on the handle.
bool onSectionHandle(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                     const ViewSize& size, const glm::dvec2& pixel);

/// The plane moved so that the handle follows the pointer from one pixel to another, limited to `bounds_W`. If the eye
/// looks along the normal, the pointer does not define a distance and the plane stays.
SectionPlane draggedSection(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                            const ViewSize& size, const glm::dvec2& from, const glm::dvec2& to);

}  // namespace hapticell::app
