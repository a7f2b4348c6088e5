// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"
#include "manipulation/manipulators/manipulator.h"
#include "mannequin/posture/posture_solver.h"
#include "workcell/entity/entity.h"

namespace hapticell::agents {

/// What one variable does: a turn about an axis, or a slide along it, in the world.
struct Screw {
  dvec3 axis_W{0.0};  ///< Unit.
  dvec3 p_WO{0.0};    ///< A point of the axis; unused for a slide.
  bool slides = false;

  /// Velocity of the point p_WQ for a unit of the variable.
  dvec3 at(const dvec3& p_WQ) const { return slides ? axis_W : glm::cross(axis_W, p_WQ - p_WO); }
  dvec3 turn() const { return slides ? dvec3(0.0) : axis_W; }
};

/// How far a variable may still move, rad or m; infinite without a limit.
struct Room {
  double down = std::numeric_limits<double>::infinity();
  double up = std::numeric_limits<double>::infinity();
};

/// What agents know of a mannequin besides.
struct FigureView {
  const mannequin::Figure& figure;
  const mannequin::Posture& posture;
  const mannequin::FigurePose& pose;
  mannequin::Side side;  ///< Of the moved hand.
  std::array<int, mannequin::kSegmentCount> link_of{};  ///< The model's link of each segment.
};

/// The variables of a mannequin, by their kind.
enum class BodyRegion { kPelvisPlace, kPelvisTurn, kSpine, kArms, kNeck };
BodyRegion regionOf(std::size_t figure_variable);
inline constexpr std::size_t kFirstNeckVariable = 33;

/// The moved entity at one configuration, as agents see it: variables that they may move, and where that leads.
///
/// A value of one configuration: moved() makes another one. Robots have their joints as variables, solids six (three
/// slides, three turns), mannequins 42: root 6, spine 9, arms 18, neck 9; their legs follow, so that the feet stay.
class MovedBody {
 public:
  virtual ~MovedBody() = default;

  /// `moved_by` as in AgentTask. Errors: an entity that agents cannot move (locked, closed loops, no joints), an unknown
  /// way.
  static Expected<std::unique_ptr<MovedBody>> create(const workcell::Entity& entity, const std::string& moved_by);

  virtual const manipulation::EntityConfiguration& configuration() const = 0;
  /// The moved frame M: the tool centre point, the grip of the hand, the middle of a solid.
  virtual const Pose& handle() const = 0;
  /// The link that carries it; 0 for a solid.
  virtual int handleLink() const = 0;

  /// One a variable.
  virtual std::span<const Screw> screws() const = 0;
  /// Whether a variable moves a link.
  virtual bool carries(std::size_t variable, int link) const = 0;
  /// Whether a link stays where it is whatever the variables do: a robot's base, a standing figure's feet.
  virtual bool isFixed(int link) const = 0;
  virtual Room room(std::size_t variable) const = 0;
  /// Greatest speed, rad/s or m/s; 0: not moved by agents.
  virtual double speed(std::size_t variable) const = 0;
  /// How readily it follows the moved frame, 0 to 1: a neck not at all, a trunk less than an arm.
  virtual double readiness(std::size_t variable) const = 0;
  virtual std::string nameOf(std::size_t variable) const = 0;

  /// The body after a small step (one number a variable), within its limits; mannequins with their feet where they
  /// are. Null: a foot would leave its place.
  virtual std::unique_ptr<MovedBody> moved(std::span<const double> step) const = 0;
  /// The same body elsewhere, for starts that differ. The joints are those of the entity's model.
  virtual std::unique_ptr<MovedBody> placed(const manipulation::EntityConfiguration& at) const = 0;

  /// Null unless it is a mannequin.
  virtual const FigureView* figure() const { return nullptr; }

  std::size_t size() const { return screws().size(); }
};

/// The two kinds with joints; see MovedBody::create().
Expected<std::unique_ptr<MovedBody>> makeMovedRobot(const workcell::Entity& entity);
Expected<std::unique_ptr<MovedBody>> makeMovedFigure(const workcell::Entity& entity, mannequin::Side side);
std::unique_ptr<MovedBody> makeMovedSolid(const workcell::Entity& entity);

}  // namespace hapticell::agents
