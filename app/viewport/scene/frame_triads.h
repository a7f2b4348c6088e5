// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_curve.h"
#include "app/viewport/scene/scene_model.h"

namespace hapticell::app {

/// Three axes of `length` metres at X_WF, and a dot with the name at the origin. `width` in pixels at 100 %.
std::vector<SceneCurve> triadCurves(const Pose& X_WF, double length, const std::string& name, bool selected,
                                    double width);

/// Drawn length of a frame's axes, metres: 0.1, but limited so that they are neither tiny nor fill the picture.
double triadLength(const dvec3& p_WF, const Camera& camera, const ViewSize& view);

/// All visible frames of the cell at their present poses; selected ones and the one under the pointer are bolder.
std::vector<SceneCurve> frameTriads(const SceneModel& scene, const Camera& camera, const ViewSize& view);

/// The nearest visible frame with its triad within 7 pixels of a pixel; 0: none.
workcell::EntityId frameAt(const SceneModel& scene, const Camera& camera, const ViewSize& view,
                           const glm::dvec2& pixel);

/// The frames with their origin in a box from corner to corner, in pixels.
std::vector<workcell::EntityId> framesIn(const SceneModel& scene, const Camera& camera, const ViewSize& view,
                                         const glm::dvec2& least, const glm::dvec2& most);

}  // namespace hapticell::app
