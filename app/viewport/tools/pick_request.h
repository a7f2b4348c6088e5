// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <functional>
#include <optional>

#include "app/viewport/tools/picked_feature.h"

namespace hapticell::app {

/// Asks the user to pick a face, an edge or a corner in the scene, for a dialog.
///
///     host.viewport().startPick({{.faces = true, .edges = true, .vertices = false}, tr("Pick the axis of the hinge"),
///                                [this](const std::optional<PickedFeature>& feature) { if (feature) take(*feature);
///                                }});
///
/// Until then, the pointer shows what a click would pick; the middle button and the wheel still move the camera. Calls
/// `done` once: with the feature of the click, or empty if the user presses Escape or the right button, or if another
/// pick is started. `done` may start the next pick.
struct PickRequest {
  FeatureFilter filter;
  QString prompt;  ///< One line over the scene: what to pick.
  std::function<void(const std::optional<PickedFeature>&)> done;
};

}  // namespace hapticell::app
