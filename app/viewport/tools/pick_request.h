// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <functional>
#include <optional>

#include "app/viewport/tools/picked_feature.h"

namespace hapticell::app {

/// A dialog asks the user to pick a face, an edge or a corner in the scene.
///
///     host.viewport().startPick({{.faces = true, .edges = true, .vertices = false}, tr("Pick the axis of the hinge"),
///                                [this](const std::optional<PickedFeature>& feature) { if (feature) take(*feature);
///                                }});
///
/// Until it is answered the pointer shows what a click would take; the middle button and the wheel still move the
/// camera. `done` is called once: with the feature of the click, or with nothing when the user presses Escape or the
/// right button, or another pick is started. It may start the next pick.
struct PickRequest {
  FeatureFilter filter;
  QString prompt;  ///< One line, shown over the scene: what is wanted.
  std::function<void(const std::optional<PickedFeature>&)> done;
};

}  // namespace hapticell::app
