// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/system/text.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::manipulation {

/// The entities whose configuration differs from the document.
using Placements = std::map<workcell::EntityId, EntityConfiguration>;

/// An entity's configuration: from the placements, else from the document.
EntityConfiguration standingOf(const workcell::Entity& entity, const Placements& placements);

/// A part that moves with the held entity: its own, one of an attached entity, or one of an external axis.
struct MovedPart {
  const ScenePart* part = nullptr;
  workcell::EntityId owner = 0;  ///< The entity that it is a part of.
  int link = -1;                 ///< Of the model that the manipulator moves; -1: a solid moves as a whole.
  Pose X_LP;
};

/// Everything that moves with a held entity, and its structure: the entity, its external axes (in one kinematic model
/// with it), and all that is attached to any of these.
///
/// Immutable. "Of the model" refers to that one kinematic model: the joints of the axes come first, from the bottom,
/// the entity's own last. Any thread.
class HeldModel {
 public:
  /// Entities with their configurations.
  using Standing = std::vector<std::pair<workcell::EntityId, EntityConfiguration>>;

  /// `entity` belongs to the scene. `with_axes`: its external axes move along if possible; `notes` lists those that
  /// cannot.
  HeldModel(std::shared_ptr<const PreparedScene> scene, const workcell::Entity& entity, const Placements& placements,
            bool with_axes, std::vector<Text>& notes);

  const std::shared_ptr<const PreparedScene>& scene() const { return scene_; }
  workcell::EntityId id() const { return id_; }
  /// The entity to move; with external axes, all of them in one model, with its root and joints as it was taken.
  const workcell::Entity& form() const { return form_; }
  /// The configuration when it was taken.
  const EntityConfiguration& taken() const { return taken_; }
  /// The entities in the form: the external axes from the bottom, the entity last.
  std::vector<const workcell::Entity*> members() const;
  bool isMember(workcell::EntityId id) const;
  /// Whether it is a member or attached to one.
  bool isMoved(workcell::EntityId id) const;

  /// Everything that moves, in the order of Manipulator::partPoses().
  const std::vector<MovedPart>& parts() const { return parts_; }
  /// Shapes of the parts, for contacts; one per part.
  const std::vector<const collision::ConvexPieces*>& pieces() const { return pieces_; }
  const std::vector<const collision::SurfaceModel*>& surfaces() const { return surfaces_; }

  /// The entity's own configuration if the model is at `all`.
  EntityConfiguration standing(const EntityConfiguration& all) const;
  /// The external axes, the bottom one first.
  Standing axes(const EntityConfiguration& all) const;
  /// What moves with the entity: the axes, and what is attached to these or to it.
  Standing carried(const EntityConfiguration& all) const;

  /// Converts a joint index of the model to one of the entity; -1 for an external axis and for "no joint".
  int ownJoint(int joint) const;
  /// Its name; the joint exists (contract).
  const std::string& jointName(int joint) const;
  /// "robot/link_3", or "gripper" for a solid.
  std::string nameOf(const ScenePart& part) const;

 private:
  /// One of the entities in `form_`.
  struct Member {
    workcell::EntityId id = 0;
    int first_link = 0, first_joint = 0;
    std::size_t first_variable = 0;
  };
  /// An entity attached to a link of the model (-1: to a solid), directly or through others.
  struct Carried {
    workcell::EntityId id = 0;
    int link = -1;
    Pose X_LE;
    std::vector<double> joints;
  };
  void mountOnAxes(const Placements& placements, std::vector<Text>& notes);
  void gatherCarried(const Placements& placements);
  void gatherParts();

  std::shared_ptr<const PreparedScene> scene_;  // Shared with running searches.
  workcell::EntityId id_ = 0;
  workcell::Entity form_;
  EntityConfiguration taken_;
  std::vector<Member> members_;
  std::vector<Carried> carried_;
  std::vector<MovedPart> parts_;
  std::vector<const collision::ConvexPieces*> pieces_;
  std::vector<const collision::SurfaceModel*> surfaces_;
};

}  // namespace hapticell::manipulation
