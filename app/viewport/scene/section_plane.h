// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_curve.h"

namespace hapticell::app {

/// A plane that cuts the picture open: what lies beyond it, where nhat_W . p > offset, is not drawn; closed parts get a
/// hatched cap. Only the picture is cut, not what collides. A value; no OpenGL.
struct SectionPlane {
  dvec3 nhat_W{0.0, -1.0, 0.0};  ///< Unit, towards what is cut away.
  double offset = 0.0;           ///< m

  bool operator==(const SectionPlane&) const = default;
};

/// The plane across the cell's axis that the eye looks along most, through the middle of `bounds_W`: what is nearer to
/// the eye is cut away.
SectionPlane sectionFacing(const Camera& camera, const geometry::Bounds& bounds_W);

/// The same place, the other axis (0: X, 1: Y, 2: Z): through the middle of `bounds_W`, cutting away the eye's side.
SectionPlane sectionAcross(int axis, const Camera& camera, const geometry::Bounds& bounds_W);

/// Cuts away the other side.
SectionPlane flipped(const SectionPlane& plane);

/// 0, 1 or 2: the axis the plane stands across.
int axisOf(const SectionPlane& plane);

/// What is drawn of it: its border over `bounds_W` and the handle that moves it, with the place in mm.
std::vector<SceneCurve> sectionCurves(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                                      const ViewSize& size);

/// A ray of sight that begins where it enters what is drawn: in the plane where the eye is on the side cut away.
Ray fromSection(const SectionPlane& plane, Ray ray);

/// Whether a pixel is on the handle.
bool onSectionHandle(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                     const ViewSize& size, const glm::dvec2& pixel);

/// The plane moved so that the handle follows the pointer from one pixel to another, kept within `bounds_W`. Where the
/// eye looks along the normal the pointer cannot say how far, and the plane stays.
SectionPlane draggedSection(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                            const ViewSize& size, const glm::dvec2& from, const glm::dvec2& to);

}  // namespace hapticell::app
