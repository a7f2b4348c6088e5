// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/viewport/overlay/overlay_labels.h"
#include "app/viewport/scene/scene_curve.h"
#include "mannequin/ergonomics/advice/driving_parts.h"

namespace hapticell::app {

class LiveScores;
class MannequinContext;

/// What the ergonomics draw over the scene: labels with the angles at the joints that drive a method's score, these
/// angles drawn at the joints, and the mannequin's strip. GUI thread.
struct SceneMarks {
  std::vector<OverlayLabel> labels;
  std::vector<SceneCurve> curves;
  std::vector<StripCell> strip;
};

/// Empty while nothing is scored.
SceneMarks sceneMarks(const LiveScores& scores, const MannequinContext& context, ergonomics::PostureMethod method);

}  // namespace hapticell::app
