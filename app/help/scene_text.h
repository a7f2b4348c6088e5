// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/viewport/scene/scene_model.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

/// The scene in sentences, for people who cannot see it and for reports: how many entities are in the cell, what is
/// selected and where, what is held, what touches or nearly does, which limit pushes back. Most urgent line first.
QString sceneText(const workcell::DocumentState& state, const std::vector<workcell::EntityId>& selected,
                  const SceneModel& scene);

}  // namespace hapticell::app
