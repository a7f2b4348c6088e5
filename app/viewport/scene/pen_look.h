// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/stylus_mesh.h"

namespace hapticell::app {

/// Length of a drawn pen, pixels at 100 %: a fifth of the view's height, so that it hides little in a small view.
inline double penPixels(const ViewSize& view) {
  return std::clamp(0.2 * view.height, 70.0, 150.0);
}

/// Colour of a pen's body, sRGB. The second one's differs from the first one's and from its band's, also for users with
/// protan or deutan vision.
std::array<float, 3> penColor(bool second, bool dark_theme);

/// The second stylus: like makeStylusMesh(), but with two bands, so that it differs without colours too.
StylusMesh makeSecondStylusMesh();

}  // namespace hapticell::app
