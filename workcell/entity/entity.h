// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "workcell/entity/entity_body.h"
#include "workcell/entity/import_options.h"
#include "workcell/entity/scripted_motion.h"

namespace hapticell::workcell {

/// Never reused within one document; 0 means none.
using EntityId = std::uint64_t;

/// What happens to a moved entity that meets an obstacle.
enum class OnContact { kStop, kSlide, kPass };

/// How contacts feel: the same everywhere; after stiffness and material; with mass and inertia besides.
enum class ForceClass { kConstant, kContact, kDynamics };

/// Where an entity came from, and how its numbers were read.
struct SourceFile {
  /// A file (absolute while in memory, written relative to the document) or a built-in shape or robot as
  /// loadEntity() understands it: "library:NAME", "box:X,Y,Z", "cylinder:R,H", "sphere:R", "frame:".
  std::string path;
  double scale = 1.0;  ///< Metres per unit of the file; 0 before it was loaded: as the file says, else 1.
  /// The part of a file that holds a tree (partPaths()); empty: all of it as one.
  std::string part = {};
  std::optional<UpAxis> up_axis = {};  ///< Where another one than the file's was chosen.
  Tessellation tessellation = {};      ///< STEP and IGES.
  bool oriented = false;               ///< Triangles were turned to face outwards (orient()).
  double simplified = 0.0;             ///< Metres that triangles may leave the file's surface by; 0: all are kept.
  std::map<std::string, std::string> arguments = {};  ///< Of a xacro: NAME:=VALUE where not its defaults.
};

/// A named frame F on an entity, to move it by or to take axes from (frame:NAME). Frames of the cell are entities of
/// their own (CellFrame).
struct Frame {
  std::string name;
  Pose X_EF;
};

/// What an entity is attached to: a gripped part on a robot's link, a robot on a slide. It then moves with that link.
struct Attachment {
  std::string to;    ///< Name of the carrying entity; empty: not attached.
  std::string link;  ///< Of the carrier; empty for a solid.
  Pose X_LE;         ///< Placement in that link (or in the solid).
};

/// What contacts of an entity do and how they feel.
struct EntityContact {
  OnContact on_contact = OnContact::kSlide;
  ForceClass force_class = ForceClass::kContact;
  std::string material = "steel";  ///< Key of the configuration's material table.
  double mass = 1.0;               ///< kg, for the class kDynamics.
};

/// One thing in the workcell; what it is says its `body`. A value; meshes and models are shared and immutable.
struct Entity {
  EntityId id = 0;
  std::string name;
  Pose X_WE;  ///< Placement: a solid's own origin, a robot's root link.
  /// Name of the assembly or solid that it is below, or of a mere folder where no entity is called so; empty at the
  /// top.
  std::string parent;
  std::array<float, 3> color{0.72f, 0.74f, 0.76f};
  bool visible = true;
  bool locked = false;  ///< Cannot be grabbed or moved.
  bool checked = true;  ///< Takes part in collision checks.
  SourceFile source;
  /// The entity as its document has it, where its file could not be read: it is shown nowhere and saved as it was. Its
  /// body is then a Solid without a mesh, or an Assembly.
  std::shared_ptr<const std::string> unloaded;
  EntityBody body;
  Attachment attachment;
  EntityContact contact;
  std::vector<Frame> frames;             ///< Names unique within the entity.
  std::optional<ScriptedMotion> motion;  ///< Its scripted motion during a session; none: it does not move.

  /// Which of EntityBody's it is.
  EntityKind kind() const { return static_cast<EntityKind>(body.index()); }

  // Of the body. The references hold as long as the body is not assigned.

  /// Null unless it is a solid with its shape.
  const std::shared_ptr<const geometry::TriangleMesh>& mesh() const;
  /// Of kind kNone unless it is a solid.
  const CollisionProxy& proxy() const;
  /// An empty one unless it is a robot, a mechanism or a mannequin.
  const Jointed& jointed() const;
  /// jointed().model.
  const std::shared_ptr<const kinematics::RobotModel>& robot() const { return jointed().model; }
  /// jointed().joints.
  const std::vector<double>& joints() const { return jointed().joints; }
  /// Null unless it is a mechanism.
  const std::shared_ptr<const MechanismDefinition>& mechanism() const;
  /// Null unless it is a mannequin.
  const std::shared_ptr<const mannequin::Figure>& figure() const;

  /// To change it. Of another entity than a solid: a broken contract.
  Solid& editSolid();
  /// To change it. Of another entity than a robot, a mechanism or a mannequin: a broken contract.
  Jointed& editJointed();
  /// Sets editJointed().joints; does nothing for another entity than a robot, a mechanism or a mannequin.
  void setJoints(std::vector<double> joints);
};

/// The mesh that a solid is checked by: its proxy's where it has one, else its own. Null unless it is a solid.
inline const std::shared_ptr<const geometry::TriangleMesh>& checkedMesh(const Entity& entity) {
  return entity.proxy().mesh ? entity.proxy().mesh : entity.mesh();
}

/// "solid", "robot", "mechanism", "assembly", "mannequin", "frame".
const char* wordOf(EntityKind kind);

/// Does it have a shape of its own? Assemblies and frames have none.
bool hasShape(EntityKind kind);

/// Is it a robot or a mechanism, and has it its model? A mannequin's joints are moved by its own rules.
bool isMachine(const Entity& entity);

/// A pair set as users know it: what of the first column is checked against what of the second.
struct PairSet {
  std::string name;
  bool enabled = true;
  std::vector<std::string> first = {};  ///< Entity names; empty means everything.
  std::vector<std::string> second = {};
  double safety_distance = 0.001;            ///< Metres; felt as the boundary (the paper's safety zone).
  double near_miss = 0.010;                  ///< Metres; shown and heard, not felt.
  std::optional<OnContact> on_contact = {};  ///< Goes over the entity's own choice.
  /// How its contacts and near misses are drawn, sRGB 0 .. 1; empty: as the theme has it.
  std::optional<std::array<float, 3>> contact_color = {}, near_miss_color = {};
  bool operator==(const PairSet&) const = default;
};

/// What the user chose for one pair of entities, or of their links: it goes over all pair sets. Either way round.
struct PairRule {
  std::string first = {}, first_part = {};  ///< Entity and link by name; an empty link means all of the entity.
  std::string second = {}, second_part = {};
  bool checked = true;                       ///< False: left out (it touches at rest, or is not of interest).
  std::optional<OnContact> on_contact = {};  ///< Empty: as the sets have it.
  bool operator==(const PairRule&) const = default;
};

/// What is checked against what: sets, and rules for single pairs. Of a document: DocumentState::pairPolicy().
struct PairPolicy {
  PairPolicy() = default;
  /// Both, always: sets without their rules would check what the user has left out.
  explicit PairPolicy(std::vector<PairSet> pair_sets, std::vector<PairRule> pair_rules)
      : sets(std::move(pair_sets)), rules(std::move(pair_rules)) {}
  std::vector<PairSet> sets;
  std::vector<PairRule> rules;
  bool operator==(const PairPolicy&) const = default;
};

}  // namespace hapticell::workcell
