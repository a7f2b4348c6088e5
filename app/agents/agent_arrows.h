// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <string>
#include <vector>

#include "agents/runner/agent_session.h"
#include "app/style/theme.h"
#include "app/viewport/scene/scene_curve.h"

namespace hapticell::app {

/// The role whose colour an agent has, in its row and in the scene; each agent has its own.
SceneCurve::Role roleOfAgent(const std::string& kind);
QColor colorOfAgent(const std::string& kind, const Theme& theme);

/// The arrows of the wishes (0.5 s of the motion that is wished), the goal, and the way that is followed.
std::vector<SceneCurve> agentCurves(const agents::AgentSession::State& state, const dvec3& p_WG,
                                    const dvec3& eyeward_W);

}  // namespace hapticell::app
