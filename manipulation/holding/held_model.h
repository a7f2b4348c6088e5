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

/// Where every entity stands that does not stand as in the document.
using Placements = std::map<workcell::EntityId, EntityConfiguration>;

/// Where an entity stands: as placed, else as in the document.
EntityConfiguration standingOf(const workcell::Entity& entity, const Placements& placements);

/// A part that moves with the held entity: its own, one of what hangs on it, or one of an external axis.
struct MovedPart {
  const ScenePart* part = nullptr;
  workcell::EntityId owner = 0;  ///< The entity that it is a part of.
  int link = -1;                 ///< Of the model that the manipulator moves; -1: a solid moves as a whole.
  Pose X_LP;
};

/// What moves with a held entity, and how it hangs together: the entity, the external axes that it stands on (in one
/// kinematic model with it), and all that hangs on any of these.
///
/// Does not change. "Of the model" means of that one kinematic model: the joints of the axes come first, from the
/// bottom, the entity's own last. Any thread.
class HeldModel {
 public:
  /// Entities with how they stand.
  using Standing = std::vector<std::pair<workcell::EntityId, EntityConfiguration>>;

  /// `entity` is one of the scene's. `with_axes`: what it stands on goes along where it can; what cannot is told by
  /// `notes`.
  HeldModel(std::shared_ptr<const PreparedScene> scene, const workcell::Entity& entity, const Placements& placements,
            bool with_axes, std::vector<Text>& notes);

  const std::shared_ptr<const PreparedScene>& scene() const { return scene_; }
  workcell::EntityId id() const { return id_; }
  /// What is moved: the entity; with external axes all of them in one model.
  const workcell::Entity& form() const { return form_; }
  /// How all of it stood when it was taken.
  const EntityConfiguration& taken() const { return taken_; }
  /// The entities that the form is made of: the external axes from the bottom, the entity last.
  std::vector<const workcell::Entity*> members() const;
  bool isMember(workcell::EntityId id) const;
  /// A member, or what hangs on one.
  bool isMoved(workcell::EntityId id) const;

  /// Everything that moves, in the order of Manipulator::partPoses().
  const std::vector<MovedPart>& parts() const { return parts_; }
  /// Shapes of the parts, for contacts: one each.
  const std::vector<const collision::ConvexPieces*>& pieces() const { return pieces_; }
  const std::vector<const collision::SurfaceModel*>& surfaces() const { return surfaces_; }

  /// Where the entity itself stands when all of it stands so.
  EntityConfiguration standing(const EntityConfiguration& all) const;
  /// The external axes, the one at the bottom first.
  Standing axes(const EntityConfiguration& all) const;
  /// What goes with the entity: the axes, and what hangs on these or on it.
  Standing carried(const EntityConfiguration& all) const;

  /// A joint of the model among the entity's own; -1 for an external axis and none.
  int ownJoint(int joint) const;
  /// Its name; the joint exists (contract).
  const std::string& jointName(int joint) const;
  /// "robot/link_3", or "gripper" for a solid.
  std::string nameOf(const ScenePart& part) const;

 private:
  /// One of the entities that `form_` is made of.
  struct Member {
    workcell::EntityId id = 0;
    int first_link = 0, first_joint = 0;
    std::size_t first_variable = 0;
  };
  /// An entity that hangs on a link of the model (-1: on a solid), directly or by others.
  struct Carried {
    workcell::EntityId id = 0;
    int link = -1;
    Pose X_LE;
    std::vector<double> joints;
  };
  void standOnAxes(const Placements& placements, std::vector<Text>& notes);
  void gatherCarried(const Placements& placements);
  void gatherParts();

  std::shared_ptr<const PreparedScene> scene_;  // Shared: searches under way keep it too.
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
