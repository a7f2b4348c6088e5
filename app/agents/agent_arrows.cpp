// SPDX-License-Identifier: Apache-2.0
#include "app/agents/agent_arrows.h"

#include <algorithm>

#include "app/agents/agent_setup.h"

namespace hapticell::app {

namespace {

using Role = SceneCurve::Role;
using Style = SceneCurve::Style;

/// s of the wished motion that an arrow shows. Half: small wishes are not seen; twice: arrows leave the picture.
constexpr double kShownSeconds = 0.8;
/// m: shorter arrows are not drawn, longer ones are cut. Half, twice of the first: trembling is seen, or not.
constexpr double kShortest = 0.004, kLongest = 0.6;
/// Of the arrow, its head; m at most.
constexpr double kHeadShare = 0.3, kHead = 0.03;

}  // namespace

Role roleOfAgent(const std::string& kind) {
  if (kind == "goal") return Role::kGuide;
  if (kind == "obstacles") return Role::kContact;
  if (kind == "limits") return Role::kLimit;
  if (kind == "balance") return Role::kAxisZ;
  if (kind == "comfort") return Role::kAxisY;
  if (kind == "sight") return Role::kMeasure;
  if (kind == "reach") return Role::kNearMiss;
  return Role::kSelection;
}

QColor colorOfAgent(const std::string& kind, const Theme& theme) {
  switch (roleOfAgent(kind)) {
    case Role::kGuide:
      return theme.scene.guide;
    case Role::kContact:
      return theme.contact;
    case Role::kLimit:
      return theme.limit;
    case Role::kAxisZ:
      return theme.scene.axis_z;
    case Role::kAxisY:
      return theme.scene.axis_y;
    case Role::kMeasure:
      return theme.scene.force;
    case Role::kNearMiss:
      return theme.near_miss;
    default:
      return theme.selection;
  }
}

std::vector<SceneCurve> agentCurves(const agents::AgentSession::State& state, const dvec3& p_WG,
                                    const dvec3& eyeward_W) {
  std::vector<SceneCurve> curves;
  curves.push_back({{p_WG}, Role::kGuide, Style::kSolid, 2.0, {}});
  if (!state.way_W.empty()) {
    std::vector<dvec3> way = state.way_W;
    curves.push_back({std::move(way), Role::kGuide, Style::kDashed, 2.0, {}});
  }
  for (const agents::ShownWish& wish : state.wishes) {
    dvec3 arrow = kShownSeconds * wish.arrow_W;
    const double length = glm::length(arrow);
    if (!wish.enabled || length < kShortest) continue;
    arrow *= std::min(1.0, kLongest / length);
    const dvec3 tip = wish.p_W + arrow, along = glm::normalize(arrow);
    dvec3 side = glm::cross(along, eyeward_W);
    side = glm::length(side) > 1e-6 ? glm::normalize(side) : dvec3(0.0);
    const double head = std::min(kHead, kHeadShare * glm::length(arrow));
    curves.push_back({{tip - head * (along + 0.5 * side), tip, tip - head * (along - 0.5 * side)},
                      roleOfAgent(wish.name), Style::kSolid, 2.5, {}});
    curves.push_back({{wish.p_W, tip}, roleOfAgent(wish.name), Style::kSolid, 2.5,
                      agentName(wish.name).toStdString()});
  }
  return curves;
}

}  // namespace hapticell::app
