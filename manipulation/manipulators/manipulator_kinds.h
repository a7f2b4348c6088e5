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

/// An entity to take, and how it is to be moved.
struct Taking {
  const workcell::Entity& entity;     ///< With external axes: all of them as one model.
  const EntityConfiguration& stands;  ///< Its present configuration.
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
  bool (*suits)(const Taking&);                                   ///< Whether this kind moves that entity in that way.
  Expected<std::unique_ptr<Manipulator>> (*make)(const Taking&);  ///< An error says what is impossible, and what is
                                                                  ///< possible.
};

/// All kinds, in order: the first one that suits makes the manipulator. A new kind of entity is one class, a
/// Manipulator, and one line of this list; docs/dev/architecture.md has an example.
std::span<const ManipulatorKind> manipulatorKinds();

/// `moved_by`, with by::Default replaced by the entity's default. by::Default stays only if it must be refused: locks
/// for an entity that is not a mannequin.
MovedBy resolved(const MovedBy& moved_by, const workcell::Entity& entity);

/// The first of `kinds` that suits makes it. Error: no kind suits.
Expected<std::unique_ptr<Manipulator>> makeManipulator(const Taking& taking, std::span<const ManipulatorKind> kinds);

/// "entity 'X': it is locked; expected an entity that can be moved".
Error takingRefused(const workcell::Entity& entity, Text found, Text expected);

}  // namespace hapticell::manipulation
