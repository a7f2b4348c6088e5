// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::access {

/// A set of units, by their numbers.
using UnitSet = std::uint64_t;
/// Units that an answer may move; the issue asks for 30. Half: as many; twice: the sets need two words.
inline constexpr std::size_t kMostMovable = 64;

/// What leaves as one: a solid with everything that is attached to it. Robots and what is locked stand as one unit each.
struct RemovalUnit {
  workcell::EntityId entity = 0;
  std::string name;
  /// A rigid part of it where it stands.
  struct Part {
    const manipulation::ScenePart* part = nullptr;
    Pose X_WP;
    std::shared_ptr<const collision::MeshCollider> thin;  ///< Thinner by the tolerance; movable units only.
    geometry::Bounds bounds_W;
  };
  std::vector<Part> parts;
  geometry::Bounds bounds_W;
};

/// A cell as what can be taken out of it: units, and the box that a unit has to leave. Immutable; any thread.
///
/// Persons (mannequins and what they carry) do not stand in the way. Every other pair counts unless a rule of the
/// cell leaves it out; pair sets do not matter here.
class RemovalScene {
 public:
  /// `part` is the solid that is to be taken out. `within`: the assembly (or folder, or solid) whose box has to be left
  /// and whose unlocked solids may go first; empty: the topmost one that holds the part, or, for a part in none, all
  /// solids of the cell. Parts that overlap by up to `tolerance` (m) count as touching. Errors: no such part, not a
  /// solid with a shape, locked, no such assembly, a part that is not below it.
  static Expected<RemovalScene> make(std::shared_ptr<const manipulation::PreparedScene> scene, const std::string& part,
                                     const std::string& within, double tolerance);

  const manipulation::PreparedScene& scene() const { return *scene_; }
  const std::shared_ptr<const manipulation::PreparedScene>& sharedScene() const { return scene_; }
  /// Those that may be moved come first, the part that is asked for as number 0.
  const std::vector<RemovalUnit>& units() const { return units_; }
  std::size_t movableCount() const { return movable_; }
  const geometry::Bounds& box_W() const { return box_W_; }
  double tolerance() const { return tolerance_; }
  /// What was left out, a sentence each.
  const std::vector<Text>& notes() const { return notes_; }

  /// Whether any rule leaves out these two.
  bool areChecked(const RemovalUnit::Part& a, const RemovalUnit::Part& b) const;
  /// How far (m) unit `unit` has to go along the unit direction to be out of the box.
  double wayOut(std::size_t unit, const dvec3& direction_W) const;

 private:
  RemovalScene() = default;
  Expected<void> choose(const workcell::Entity& part, const std::string& within);
  void addUnits(const workcell::Entity& part);
  void thin(double tolerance);

  std::shared_ptr<const manipulation::PreparedScene> scene_;
  std::vector<workcell::EntityId> assembly_;  ///< Entities of the assembly.
  std::vector<RemovalUnit> units_;
  std::size_t movable_ = 0;
  geometry::Bounds box_W_;
  double tolerance_ = 0.0;
  std::vector<Text> notes_;
};

}  // namespace hapticell::access
