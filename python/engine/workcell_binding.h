// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "manipulation/scene/scene_service.h"
#include "workcell/document/document.h"

namespace hapticell::python {

/// What Python sees as hapticell.Workcell.
struct Workcell {
  workcell::Document document;
  std::unique_ptr<manipulation::SceneService> scenes = std::make_unique<manipulation::SceneService>();

  /// Raises Error, listing those that there are.
  const workcell::Entity& entity(const std::string& name) const;
  /// Executes a command; raises its error.
  void execute(const workcell::Command& command);
  /// The cell prepared for queries, with the meshes that are known; without the interpreter's lock, Ctrl+C cancels.
  std::shared_ptr<const manipulation::PreparedScene> prepared() const;
};

}  // namespace hapticell::python
