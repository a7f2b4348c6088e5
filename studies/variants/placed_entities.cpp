// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/placed_entities.h"

#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::studies {

namespace {

Expected<void> lock(workcell::Document& document, workcell::EntityId id, bool locked) {
  workcell::SetProperties properties;
  properties.id = id;
  properties.locked = locked;
  HAPTICELL_TRY(document.execute(properties));
  return {};
}

}  // namespace

Expected<void> place(workcell::Document& document, workcell::EntityId id, const Pose& X_WE) {
  const bool locked = document.find(id)->locked;
  if (locked) {
    HAPTICELL_TRY(lock(document, id, false));
  }
  HAPTICELL_TRY(document.execute(workcell::SetPlacement{id, X_WE}));
  return locked ? lock(document, id, true) : Expected<void>();
}

Expected<void> replaceBody(workcell::Document& document, workcell::EntityId id, const workcell::Entity& fresh) {
  const workcell::Entity before = *document.find(id);
  const auto posture = mannequin::toPosture(*before.figure(), {before.X_WE, before.joints()});
  const auto standing = ergonomics::standingAt(*before.figure(), posture, *fresh.figure());
  const auto stands = mannequin::toModel(*fresh.figure(), standing);
  HAPTICELL_TRY(document.execute(workcell::ReplaceShape{id, fresh}));
  HAPTICELL_TRY(document.execute(workcell::SetConfiguration{id, stands.X_WE, stands.joints}));
  return {};
}

}  // namespace hapticell::studies
