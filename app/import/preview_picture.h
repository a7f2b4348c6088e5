// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <vector>

#include "workcell/entity/entity.h"

namespace hapticell::app {

/// The box in the world of all vertices of the solids.
geometry::Bounds exactBounds_W(const std::vector<workcell::Entity>& entities);

/// The solids of an import, seen from above front right, matte, on a transparent ground: a depth buffer filled triangle
/// by triangle, twice as fine and made smooth. It needs no graphics card, so a worker thread can paint it while the
/// window answers. An empty image where nothing can be seen.
QImage previewPicture(const std::vector<workcell::Entity>& entities, QSize size);

/// Pixels of such a picture that a metre across the view takes, for a box of that size (m).
double previewPixelsPerMetre(const dvec3& size, QSize picture);

}  // namespace hapticell::app
