// SPDX-License-Identifier: Apache-2.0
#include "agents/body/moved_body.h"

namespace hapticell::agents {

namespace {

Error refusal(const workcell::Entity& entity, Text found, Text expected) {
  return {.place = Text("entity '%1'", entity.name), .found = std::move(found), .expected = std::move(expected)};
}

}  // namespace

Expected<std::unique_ptr<MovedBody>> MovedBody::create(const workcell::Entity& entity, const std::string& moved_by) {
  const auto wrong_way = [&](Text expected) {
    return makeError(refusal(entity, Text("moved_by = \"%1\"", moved_by), std::move(expected)));
  };
  if (entity.locked) return makeError(refusal(entity, Text("it is locked"), Text("an entity that can be moved")));
  if (entity.figure()) {
    if (moved_by == "left_hand") return makeMovedFigure(entity, mannequin::Side::kLeft);
    if (moved_by.empty() || moved_by == "right_hand") return makeMovedFigure(entity, mannequin::Side::kRight);
    return wrong_way(Text("left_hand or right_hand"));
  }
  if (entity.robot()) {
    if (!moved_by.empty() && moved_by != "tcp") return wrong_way(std::string("tcp"));
    return makeMovedRobot(entity);
  }
  if (!entity.mesh()) return makeError(refusal(entity, Text("it has no shape"), Text("a solid, a robot or a mannequin")));
  if (!moved_by.empty() && moved_by != "geometric_center") return wrong_way(std::string("geometric_center"));
  return makeMovedSolid(entity);
}

}  // namespace hapticell::agents
