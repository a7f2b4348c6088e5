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

#include "geometry/shapes/triangle_mesh.h"
#include "kinematics/model/robot_model.h"
#include "mannequin/body/figure.h"
#include "workcell/entity/import_options.h"
#include "workcell/entity/scripted_motion.h"

namespace hapticell::workcell {

struct MechanismDefinition;

/// Never reused within one document; 0 means none.
using EntityId = std::uint64_t;

/// An assembly holds others: it has neither mesh nor robot, and moving, hiding, locking or removing it does the same to
/// everything below it. A frame is a named place with axes: it has no shape, is never in contact and weighs nothing;
/// attached to an entity or a link it moves with that, and entities attached to the frame move with it.
enum class EntityKind { kSolid, kRobot, kMechanism, kAssembly, kMannequin, kFrame };

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

/// The shape checked for contact instead of the drawn mesh of a solid: fewer triangles, or its hull.
struct CollisionProxy {
  enum class Kind { kNone, kCoarse, kConvex };
  Kind kind = Kind::kNone;
  double tolerance = 0.0;  ///< Metres asked for; kCoarse.
  double deviation = 0.0;  ///< Metres measured: no point of either surface is farther from the other.
  std::shared_ptr<const geometry::TriangleMesh> mesh;
};

/// A named frame F on an entity, to move it by or to take axes from (frame:NAME). Frames of the cell are entities of
/// their own (EntityKind::kFrame).
struct Frame {
  std::string name;
  Pose X_EF;
};

/// A named tool of a robot: its centre point in a link.
struct ToolFrame {
  std::string name;
  std::string tip_link;
  Pose X_LT;
};

/// What an entity is attached to: a gripped part on a robot's link, a robot on a slide. It then moves with that link.
struct Attachment {
  std::string to;    ///< Name of the carrying entity; empty: not attached.
  std::string link;  ///< Of the carrier; empty for a solid.
  Pose X_LE;         ///< Placement in that link (or in the solid).
};

/// One thing in the workcell: a solid, a robot, a frame or a mechanism (see workcell/entity/mechanism.h). A value;
/// meshes and models are shared and immutable. A mechanism has a `robot` too, made from its parts and joints: it poses,
/// draws and checks like one.
struct Entity {
  EntityId id = 0;
  std::string name;
  EntityKind kind = EntityKind::kSolid;
  Pose X_WE;  ///< Placement: a solid's own origin, a robot's root link.
  /// Name of the assembly or solid that it is below, or of a mere folder where no entity is called so; empty at the
  /// top.
  std::string parent;
  std::array<float, 3> color{0.72f, 0.74f, 0.76f};
  bool visible = true;
  bool locked = false;  ///< Cannot be grabbed or moved.
  bool checked = true;  ///< Takes part in collision checks.
  SourceFile source;
  /// The entity as its document has it, where its file could not be read: it is shown nowhere and saved as it was.
  std::shared_ptr<const std::string> unloaded;
  std::shared_ptr<const geometry::TriangleMesh> mesh;    ///< Solids.
  CollisionProxy proxy;                                  ///< Solids.
  std::shared_ptr<const kinematics::RobotModel> robot;   ///< Robots.
  std::shared_ptr<const mannequin::Figure> figure;       ///< Mannequins; they have a `robot` too (figure_model.h).
  std::vector<double> joints;                            ///< Robots: position of each variable.
  std::string tip_link;                                  ///< Robots: the link that carries the tool centre point.
  Pose X_LT;                                             ///< Robots: the tool centre point in the tip link.
  std::vector<ToolFrame> tools;                          ///< Robots: those to choose from; names unique.
  std::string tool;                                      ///< Name of the chosen one of `tools`; empty: none of them.
  std::vector<kinematics::NamedPose> named_poses;        ///< Robots: the user's; see named_poses.h.
  std::shared_ptr<const MechanismDefinition> mechanism;  ///< Mechanisms: what `robot` was made from.
  Attachment attachment;
  OnContact on_contact = OnContact::kSlide;
  ForceClass force_class = ForceClass::kContact;
  std::string material = "steel";        ///< Key of the configuration's material table.
  double mass = 1.0;                     ///< kg, for the class kDynamics.
  std::vector<Frame> frames;             ///< Names unique within the entity.
  std::optional<ScriptedMotion> motion;  ///< Its scripted motion during a session; none: it does not move.
};

/// The mesh that a solid is checked by: its proxy's where it has one, else its own.
inline const std::shared_ptr<const geometry::TriangleMesh>& checkedMesh(const Entity& entity) {
  return entity.proxy.mesh ? entity.proxy.mesh : entity.mesh;
}

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
