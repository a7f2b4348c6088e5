// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/tools/picked_feature.h"
#include "workcell/entity/guide.h"

namespace hapticell::app {

/// All kinds in the order of the editor.
const std::vector<workcell::GuideKind>& guideKinds();
/// "Hinge".
std::string guideKindName(workcell::GuideKind kind);

/// What may be picked for a kind: axes come from round faces and edges, planes from flat faces, points from anything.
FeatureFilter guideFilter(workcell::GuideKind kind);
/// What to pick for it, as a prompt: "Pick a round face or an edge: the axis".
QString guidePrompt(workcell::GuideKind kind);

/// Puts the geometry of `feature` into the guide: origin and axes, a circle's or tube's radius, a tube's path along an
/// edge, the name of the entity whose surface is followed (`surface_name`). False, and nothing changed, where the
/// feature cannot be that of the guide's kind.
bool takeGeometry(const PickedFeature& feature, const std::string& surface_name, workcell::Guide& guide);

/// What the geometry of the guide is, in one line: "Axis at 512.0, 0.0, 300.0", millimetres.
QString geometryText(const workcell::Guide& guide);

/// A tube's path from points that were recorded: at most `most` of them, the first and the last kept, neighbours closer
/// than 0.1 mm dropped. Fewer than two remain empty.
std::vector<dvec3> thinnedPath(const std::vector<dvec3>& points, std::size_t most = 200);

/// False for what has no shape of its own: it is not led.
bool canBeGuided(const workcell::Entity& entity);

}  // namespace hapticell::app
