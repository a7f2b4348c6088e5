// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mannequin/body/figure.h"
#include "mannequin/shape/section_tube.h"

namespace hapticell::mannequin {

// Cross-sections of a standing body from published breadths, depths and girths (girths.h); profiles between measured
// sections are our own choice. Both the surface for contact (fleshOf()) and the drawn one (SkinShape) follow them. k:
// of the stature, 1 at 1.755 m.

/// Along z from the floor, u to the right, v ahead; from the crotch to the nape.
std::vector<TubeSection> trunkSections(const Figure& figure);
/// Down a hanging arm from the shoulder joint, u forward; `out` gives the outward direction of v (1 or -1).
std::vector<TubeSection> armSections(const Figure& figure, double out);
/// Down a leg from the hip joint, u to the left, v forward; `out`: the outward direction of u.
std::vector<TubeSection> legSections(const Figure& figure, double out);
/// Trousers, wider than the leg from the knee down.
std::vector<TubeSection> trouserSections(const Figure& figure);
/// From within the chest to within the skull, u to the right, v ahead; `length`: from the base of the neck to the
/// skull.
std::vector<TubeSection> neckSections(const Figure& figure, double length);

}  // namespace hapticell::mannequin
