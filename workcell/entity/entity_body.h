// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "kinematics/model/robot_model.h"
#include "mannequin/body/figure.h"

namespace hapticell::workcell {

struct MechanismDefinition;

/// The shape checked for contact instead of the drawn mesh of a solid: fewer triangles, or its hull.
struct CollisionProxy {
  enum class Kind { kNone, kCoarse, kConvex };
  Kind kind = Kind::kNone;
  double tolerance = 0.0;  ///< Metres asked for; kCoarse.
  double deviation = 0.0;  ///< Metres measured: no point of either surface is farther from the other.
  std::shared_ptr<const geometry::TriangleMesh> mesh;
};

/// A named tool of a robot: its centre point in a link.
struct ToolFrame {
  std::string name;
  std::string tip_link;
  Pose X_LT;
};

/// A thing with a shape that does not change.
struct Solid {
  std::shared_ptr<const geometry::TriangleMesh> mesh;  ///< Null where the entity is not loaded.
  CollisionProxy proxy = {};
};

/// What has links and joints: what robots, mechanisms and mannequins share.
struct Jointed {
  std::shared_ptr<const kinematics::RobotModel> model;
  std::vector<double> joints = {};                      ///< Position of each variable of the model, rad or m.
  std::string tip_link = {};                            ///< The link that carries the tool centre point.
  Pose X_LT = {};                                       ///< The tool centre point in the tip link.
  std::vector<ToolFrame> tools = {};                    ///< Those to choose from; names unique.
  std::string tool = {};                                ///< Name of the chosen one of `tools`; empty: none of them.
  std::vector<kinematics::NamedPose> named_poses = {};  ///< The user's; see named_poses.h.
};

struct Robot : Jointed {};

/// Made from its parts and joints (see workcell/entity/mechanism.h); it poses, draws and checks like a robot.
struct Mechanism : Jointed {
  std::shared_ptr<const MechanismDefinition> definition;  ///< What `model` was made from.
};

/// Holds others: moving, hiding, locking or removing it does the same to everything below it.
struct Assembly {};

/// A person. It has a model too (mannequin/shape/figure_model.h).
struct Mannequin : Jointed {
  std::shared_ptr<const mannequin::Figure> figure;
};

/// A named place with axes: it has no shape, is never in contact and weighs nothing. Attached to an entity or a link it
/// moves with that, and entities attached to the frame move with it.
struct CellFrame {};

/// What an entity is. A new kind is one struct, one more here and one in EntityKind: what treats each kind then does
/// not compile until it treats the new one.
using EntityBody = std::variant<Solid, Robot, Mechanism, Assembly, Mannequin, CellFrame>;

/// The alternatives of EntityBody, in their order.
enum class EntityKind { kSolid, kRobot, kMechanism, kAssembly, kMannequin, kFrame };

}  // namespace hapticell::workcell
