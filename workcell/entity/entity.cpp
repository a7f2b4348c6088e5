// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/entity.h"

#include <type_traits>
#include <utility>

#include "geometry/system/assertion.h"

namespace hapticell::workcell {

namespace {

template <EntityKind kKind>
using BodyOf = std::variant_alternative_t<static_cast<std::size_t>(kKind), EntityBody>;

static_assert(std::is_same_v<BodyOf<EntityKind::kSolid>, Solid>);
static_assert(std::is_same_v<BodyOf<EntityKind::kRobot>, Robot>);
static_assert(std::is_same_v<BodyOf<EntityKind::kMechanism>, Mechanism>);
static_assert(std::is_same_v<BodyOf<EntityKind::kAssembly>, Assembly>);
static_assert(std::is_same_v<BodyOf<EntityKind::kMannequin>, Mannequin>);
static_assert(std::is_same_v<BodyOf<EntityKind::kFrame>, CellFrame>);
static_assert(std::variant_size_v<EntityBody> == static_cast<std::size_t>(EntityKind::kFrame) + 1);

/// Null where the body has no joints.
template <typename Body>
auto jointedOf(Body& body) {
  using Result = std::conditional_t<std::is_const_v<Body>, const Jointed*, Jointed*>;
  return std::visit(
      [](auto& one) -> Result {
        if constexpr (std::is_base_of_v<Jointed, std::remove_cvref_t<decltype(one)>>) return &one;
        return nullptr;
      },
      body);
}

}  // namespace

const std::shared_ptr<const geometry::TriangleMesh>& Entity::mesh() const {
  static const std::shared_ptr<const geometry::TriangleMesh> none;
  const Solid* solid = std::get_if<Solid>(&body);
  return solid ? solid->mesh : none;
}

const CollisionProxy& Entity::proxy() const {
  static const CollisionProxy none;
  const Solid* solid = std::get_if<Solid>(&body);
  return solid ? solid->proxy : none;
}

const Jointed& Entity::jointed() const {
  static const Jointed none;
  const Jointed* own = jointedOf(body);
  return own ? *own : none;
}

const std::shared_ptr<const MechanismDefinition>& Entity::mechanism() const {
  static const std::shared_ptr<const MechanismDefinition> none;
  const Mechanism* own = std::get_if<Mechanism>(&body);
  return own ? own->definition : none;
}

const std::shared_ptr<const mannequin::Figure>& Entity::figure() const {
  static const std::shared_ptr<const mannequin::Figure> none;
  const Mannequin* own = std::get_if<Mannequin>(&body);
  return own ? own->figure : none;
}

Solid& Entity::editSolid() {
  Solid* solid = std::get_if<Solid>(&body);
  HAPTICELL_DEMAND(solid != nullptr);
  return *solid;
}

Jointed& Entity::editJointed() {
  Jointed* own = jointedOf(body);
  HAPTICELL_DEMAND(own != nullptr);
  return *own;
}

void Entity::setJoints(std::vector<double> joints) {
  Jointed* own = jointedOf(body);
  if (own) own->joints = std::move(joints);
}

const char* wordOf(EntityKind kind) {
  switch (kind) {
    case EntityKind::kSolid:
      return "solid";
    case EntityKind::kRobot:
      return "robot";
    case EntityKind::kAssembly:
      return "assembly";
    case EntityKind::kMannequin:
      return "mannequin";
    case EntityKind::kFrame:
      return "frame";
    case EntityKind::kMechanism:
      break;
  }
  return "mechanism";
}

bool hasShape(EntityKind kind) {
  switch (kind) {
    case EntityKind::kSolid:
    case EntityKind::kRobot:
    case EntityKind::kMechanism:
    case EntityKind::kMannequin:
      return true;
    case EntityKind::kAssembly:
    case EntityKind::kFrame:
      break;
  }
  return false;
}

bool isMachine(const Entity& entity) {
  switch (entity.kind()) {
    case EntityKind::kRobot:
    case EntityKind::kMechanism:
      return entity.robot() != nullptr;
    case EntityKind::kSolid:
    case EntityKind::kAssembly:
    case EntityKind::kMannequin:
    case EntityKind::kFrame:
      break;
  }
  return false;
}

}  // namespace hapticell::workcell
