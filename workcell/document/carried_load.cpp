// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/carried_load.h"

#include <cmath>

#include "geometry/shapes/mass_properties.h"

namespace hapticell::workcell {
namespace {

/// A share of a mass and where it is.
struct Lump {
  double weight = 0.0;
  dvec3 moment{0.0};
  void add(double more, const dvec3& p) {
    weight += more;
    moment += more * p;
  }
  dvec3 centre() const { return weight > 0.0 ? moment / weight : dvec3(0.0); }
};

std::vector<Pose> linkPoses(const Entity& robot) {
  std::vector<Pose> X_BL;
  const bool posed = robot.joints().size() == robot.robot()->dof();
  kinematics::forwardKinematics(*robot.robot(), posed ? robot.joints() : kinematics::restPositions(*robot.robot()),
                                X_BL);
  return X_BL;
}

/// In the own frame of the entity; links count by volume, open ones by that of their bounds.
dvec3 centreOf(const Entity& entity) {
  if (entity.mesh()) return geometry::massProperties(*entity.mesh()).p_MC;
  Lump lump;
  if (!entity.robot()) return {};
  const std::vector<Pose> X_BL = linkPoses(entity);
  for (std::size_t k = 0; k < X_BL.size(); ++k) {
    for (const kinematics::LinkShape& shape : entity.robot()->links[k].visuals) {
      const geometry::MassProperties solid = geometry::massProperties(*shape.mesh);
      const dvec3 size = shape.mesh->bounds().max - shape.mesh->bounds().min;
      lump.add(solid.closed ? std::abs(solid.volume) : size.x * size.y * size.z, X_BL[k] * shape.X_LS * solid.p_MC);
    }
  }
  return lump.centre();
}

class LoadCollector {
 public:
  LoadCollector(const DocumentState& state, CarriedLoad& load) : state_(state), load_(load) {}

  /// All that hangs on `carrier`, which stands at X_LE.
  void addFrom(const Entity& carrier, const Pose& X_LE) {
    const std::vector<Pose> X_EK = carrier.robot() ? linkPoses(carrier) : std::vector<Pose>{};
    for (const auto& entity : state_.entities) {
      if (entity->attachment.to != carrier.name) continue;
      const int link = carrier.robot() ? carrier.robot()->findLink(entity->attachment.link) : -1;
      const Pose X_LK = link < 0 ? X_LE : X_LE * X_EK[static_cast<std::size_t>(link)];
      add(entity, X_LK * entity->attachment.X_LE);
    }
  }

  void add(const std::shared_ptr<const Entity>& part, const Pose& X_LE) {
    if (part->kind() != EntityKind::kFrame) load_.parts.push_back(part);  // It weighs nothing; what hangs on it does.
    if (part->mesh() || part->robot()) {
      if (part->contact.mass == Entity{}.contact.mass) load_.starting.push_back(part->name);
      lump_.add(part->contact.mass, X_LE * centreOf(*part));
    }
    addFrom(*part, X_LE);
  }

  void finish() {
    load_.mass = lump_.weight;
    load_.p_LC = lump_.centre();
  }

 private:
  const DocumentState& state_;
  CarriedLoad& load_;
  Lump lump_;
};

}  // namespace

CarriedLoad carriedLoad(const DocumentState& state, const Entity& robot) {
  CarriedLoad load;
  if (!robot.robot()) return load;
  const kinematics::RobotModel& model = *robot.robot();
  const int said = model.findLink(robot.jointed().tip_link);
  const int tip = said >= 0 ? said : model.defaultTip();
  if (tip < 0) return load;
  load.link = model.links[static_cast<std::size_t>(tip)].name;
  const std::vector<int> bodies = kinematics::rigidBodies(model);
  const std::vector<Pose> X_BK = linkPoses(robot);
  const Pose X_LB = X_BK[static_cast<std::size_t>(tip)].inverse();
  LoadCollector collector(state, load);
  for (const auto& entity : state.entities) {
    if (entity->attachment.to != robot.name) continue;
    const int link = model.findLink(entity->attachment.link);
    if (link >= 0 && bodies[static_cast<std::size_t>(link)] == bodies[static_cast<std::size_t>(tip)]) {
      collector.add(entity, X_LB * X_BK[static_cast<std::size_t>(link)] * entity->attachment.X_LE);
    } else if (entity->kind() != EntityKind::kFrame) {
      load.other.push_back(entity);
    }
  }
  collector.finish();
  return load;
}

LoadVerdict verdictOn(const CarriedLoad& load, double payload) {
  if (load.parts.empty()) return LoadVerdict::kNothing;
  if (payload <= 0.0) return LoadVerdict::kOpen;
  const double known = load.mass - static_cast<double>(load.starting.size()) * Entity{}.contact.mass;
  if (known > payload + 1e-9) return LoadVerdict::kTooHeavy;
  if (!load.starting.empty()) return LoadVerdict::kOpen;
  return LoadVerdict::kAllowed;
}

}  // namespace hapticell::workcell
