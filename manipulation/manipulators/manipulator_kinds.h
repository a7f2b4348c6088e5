// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/manipulators/moved_by.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::manipulation {

/// An entity that a hand is about to take, and what the hand wants of it.
struct Taking {
  const workcell::Entity& entity;     ///< With external axes: all of them as one model.
  const EntityConfiguration& stands;  ///< How it stands now.
  MovedBy moved_by;                   ///< by::Default and by::Whole are resolved already; see resolved().
  const PreparedScene& scene;
  const config::Configuration& configuration;
  /// What moves with it, in the order of Manipulator::partPoses: a link of the entity (-1: the entity itself) and the
  /// part's pose in it.
  struct Part {
    int link = -1;
    Pose X_LP;
  };
  std::span<const Part> parts;
  bool joints_move = false;  ///< Something else moves the entity's joints meanwhile.
};

/// One way in which an entity follows the hand.
struct ManipulatorKind {
  const char* name;                                               ///< For messages and tests.
  bool (*suits)(const Taking&);                                   ///< Whether this is how that entity is moved by that.
  Expected<std::unique_ptr<Manipulator>> (*make)(const Taking&);  ///< An error says what does not go, and what would.
};

/// All of them, in the order in which they are asked: the first that suits makes the manipulator. A new kind of entity
/// is one class, a Manipulator, and one line of this list; docs/dev/architecture.md has an example.
std::span<const ManipulatorKind> manipulatorKinds();

/// `moved_by` with what is meant by default for that entity. Only what is to be refused stays by::Default: locks of
/// what is no mannequin.
MovedBy resolved(const MovedBy& moved_by, const workcell::Entity& entity);

/// The first of `kinds` that suits makes it. An error where none does.
Expected<std::unique_ptr<Manipulator>> makeManipulator(const Taking& taking, std::span<const ManipulatorKind> kinds);

/// "entity 'X': it is locked; expected an entity that may be moved".
Error takingRefused(const workcell::Entity& entity, std::string found, std::string expected);

}  // namespace hapticell::manipulation
