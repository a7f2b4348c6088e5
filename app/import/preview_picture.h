// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <vector>

#include "workcell/entity/entity.h"

namespace hapticell::app {

/// The bounds in the world of all vertices of the solids.
geometry::Bounds exactBounds_W(const std::vector<workcell::Entity>& entities);

/// The solids of an import, seen from above, front right, matte, on a transparent background. Uses a depth buffer
/// filled triangle by triangle at twice the resolution, then smoothed. Needs no graphics card, so that a worker thread
/// can paint it while the window stays responsive. Returns an empty image if nothing is visible.
QImage previewPicture(const std::vector<workcell::Entity>& entities, QSize size);

/// Pixels per metre across the view in such a picture, for a box of that size (m).
double previewPixelsPerMetre(const dvec3& size, QSize picture);

}  // namespace hapticell::app
