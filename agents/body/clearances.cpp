// SPDX-License-Identifier: Apache-2.0
#include "agents/body/clearances.h"

#include <algorithm>
#include <cmath>

#include "collision/queries/motion_bound.h"
#include "collision/queries/scene.h"
#include "manipulation/holding/held_pairs.h"
#include "manipulation/manipulators/manipulator_kinds.h"

namespace hapticell::agents {

using manipulation::EntityConfiguration;

namespace {

/// m: nearer than this at the start counts as touching, as in JointCheck. Half: rounding decides; twice: a pair 2 um
/// apart is not checked.
constexpr double kStartTouching = 1e-6;
/// Share of a distance that a step may use up. Half: steps near obstacles are half as long; 1: a contact is reached.
constexpr double kUsedShare = 0.9;

struct CheckedPair {
  std::uint32_t part = 0, other = 0;  ///< `other`: an obstacle, or another moved part.
  bool own = false;
  bool left_out = false;
  std::string moved, met;
};

Expected<std::unique_ptr<manipulation::Manipulator>> manipulatorOf(const manipulation::HeldModel& model,
                                                                   const config::Configuration& configuration) {
  std::vector<manipulation::Taking::Part> parts;
  for (const manipulation::MovedPart& part : model.parts()) parts.push_back({part.link, part.X_LP});
  const manipulation::Taking taking{
      model.form(),  model.taken(), manipulation::resolved({}, model.form()), *model.scene(),
      configuration, parts};
  return manipulation::makeManipulator(taking, manipulation::manipulatorKinds());
}

}  // namespace

struct Clearances::Plan {
  explicit Plan(manipulation::HeldModel held) : model(std::move(held)) {}

  manipulation::HeldModel model;
  std::vector<CheckedPair> pairs;
  std::vector<Obstacle> obstacles;
  struct Ball {
    dvec3 p_LB{0.0};  ///< In the link.
    double radius = 0.0;
  };
  std::vector<Ball> balls;  ///< About each part.
  std::vector<NearPair> touching;  ///< At the start.
  Text note;

  int linkOf(std::size_t part) const { return std::max(0, model.parts()[part].link); }
  const kinematics::RobotModel* robot() const { return model.form().robot().get(); }
};

struct Clearances::State {
  collision::Scene scene;
  EntityConfiguration at;
  double within = 0.0;
  std::vector<NearPair> near;
  std::vector<collision::PairDistance> found;  // Scratch.
  std::vector<Pose> X_EL;                      ///< At `at`.
};

namespace {

/// Poses of the links in the entity; one identity for a solid.
void linkPoses(const kinematics::RobotModel* robot, const std::vector<double>& joints, std::vector<Pose>& X_EL) {
  if (robot == nullptr) {
    X_EL.assign(1, Pose::identity());
  } else {
    kinematics::forwardKinematics(*robot, joints, X_EL);
  }
}

/// The links from this one to the root, itself first.
std::vector<int> chainOf(const kinematics::RobotModel& robot, int link) {
  std::vector<int> chain{link};
  while (robot.links[static_cast<std::size_t>(link)].parent_joint >= 0) {
    link = robot.joints[static_cast<std::size_t>(robot.links[static_cast<std::size_t>(link)].parent_joint)].parent_link;
    chain.push_back(link);
  }
  return chain;
}

/// Bounds of the ways of parts between two configurations, joints moving straight.
class StepBounds {
 public:
  StepBounds(const kinematics::RobotModel* robot, const std::vector<Pose>& X_EL, const EntityConfiguration& from,
             const EntityConfiguration& to)
      : robot_(robot), X_EL_(X_EL), from_(from), to_(to) {}

  /// m, of any point of a ball on `link`, seen from the link `until` above it (-1: from the entity's root frame).
  double within(int link, const dvec3& p_LB, double radius, int until) const {
    double way = 0.0;
    if (robot_ == nullptr) return way;
    const dvec3 center = X_EL_[static_cast<std::size_t>(link)] * p_LB;
    for (int at = link; at != until;) {
      const int number = robot_->links[static_cast<std::size_t>(at)].parent_joint;
      if (number < 0) break;
      const kinematics::Joint& joint = robot_->joints[static_cast<std::size_t>(number)];
      const double step = std::abs(kinematics::jointPosition(*robot_, to_.joints, joint) -
                                   kinematics::jointPosition(*robot_, from_.joints, joint));
      if (joint.type == kinematics::JointType::kPrismatic) {
        way += step;
      } else if (step > 0.0) {
        const dvec3 axis = X_EL_[static_cast<std::size_t>(joint.child_link)].p;
        way += step * (glm::length(center - axis) + radius + way);
      }
      at = joint.parent_link;
    }
    return way;
  }

  /// m, in the world.
  double inWorld(int link, const dvec3& p_LB, double radius) const {
    const double own = within(link, p_LB, radius, -1);
    const dvec3 center = X_EL_[static_cast<std::size_t>(link)] * p_LB;
    return own + collision::pathBound(from_.X_WE, to_.X_WE, center, radius + own);
  }

  /// m that the two may come nearer: both ways seen from the link that carries both.
  double between(int link, const dvec3& p_LB, double radius, int other, const dvec3& p_OB, double other_radius) const {
    const std::vector<int> one = chainOf(*robot_, link), two = chainOf(*robot_, other);
    int shared = -1;
    for (const int at : one) {
      if (std::find(two.begin(), two.end(), at) == two.end()) continue;
      shared = at;
      break;
    }
    return within(link, p_LB, radius, shared) + within(other, p_OB, other_radius, shared);
  }

 private:
  const kinematics::RobotModel* robot_;
  const std::vector<Pose>& X_EL_;
  const EntityConfiguration &from_, &to_;
};

std::vector<CheckedPair> pairsOf(const manipulation::HeldModel& model, const manipulation::HeldPairs& held) {
  std::vector<CheckedPair> pairs;
  for (std::size_t i = 0; i < held.size(); ++i) {
    const manipulation::MotionPair& motion = held.motionPairs()[i];
    CheckedPair pair;
    pair.part = motion.part;
    pair.own = motion.other_part >= 0;
    pair.other = pair.own ? static_cast<std::uint32_t>(motion.other_part) : motion.obstacle;
    pair.moved = held[i].moved_part.empty() ? model.form().name : held[i].moved_part;
    const workcell::Entity* other = model.scene()->find(held[i].other);
    pair.met = pair.own || other == nullptr ? held[i].other_part : other->name;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace

Clearances::Clearances(std::shared_ptr<const Plan> plan, std::unique_ptr<State> state)
    : plan_(std::move(plan)), state_(std::move(state)) {}
Clearances::Clearances(Clearances&&) noexcept = default;
Clearances& Clearances::operator=(Clearances&&) noexcept = default;
Clearances::~Clearances() = default;

Expected<Clearances> Clearances::create(std::shared_ptr<const manipulation::PreparedScene> scene,
                                        workcell::EntityId id, const EntityConfiguration& start,
                                        const config::Configuration& configuration) {
  const workcell::Entity* entity = scene->find(id);
  if (entity == nullptr)
    return makeError({.found = "the entity does not exist", .expected = "one that exists in the document"});
  std::vector<Text> notes;
  const workcell::Entity form = *entity;
  auto plan = std::make_shared<Plan>(manipulation::HeldModel(std::move(scene), form, {}, false, notes));
  const auto manipulator = manipulatorOf(plan->model, configuration);
  HAPTICELL_TRY(manipulator);
  const manipulation::HeldPairs held(plan->model, **manipulator, {}, {}, configuration);
  plan->pairs = pairsOf(plan->model, held);
  for (std::size_t i = 0; i < held.obstacles().size(); ++i) {
    const manipulation::ScenePart& part = *held.obstacleParts()[i];
    plan->obstacles.push_back({part.mesh.collider, held.obstacles()[i].X_W, part.entity});
  }
  for (const manipulation::MovedPart& part : plan->model.parts()) {
    const geometry::Bounds box = part.part->mesh.collider->bounds();
    const double radius = box.isEmpty() ? 0.0 : 0.5 * glm::length(box.max - box.min);
    plan->balls.push_back({part.X_LP * (box.isEmpty() ? dvec3(0.0) : box.center()), radius});
  }
  Clearances made = Clearances(plan, nullptr).fresh();
  std::string names;
  for (const NearPair& pair : made.look(start, kStartTouching)) {
    plan->pairs[pair.index].left_out = true;
    plan->touching.push_back(pair);
    names += (names.empty() ? "" : ", ") + plan->pairs[pair.index].moved + " / " + plan->pairs[pair.index].met;
  }
  if (!names.empty()) plan->note = Text("not checked, because they touch at rest: %1", names);
  return made.fresh();
}

Clearances Clearances::fresh() const {
  auto state = std::make_unique<State>();
  const std::vector<manipulation::MovedPart>& moved = plan_->model.parts();
  for (const auto& part : moved) state->scene.addPart({part.part->entity, 0}, part.part->mesh.collider);
  for (const Obstacle& obstacle : plan_->obstacles) state->scene.addPart({0, 0}, obstacle.collider, obstacle.X_WO);
  const auto first = static_cast<std::uint32_t>(moved.size());
  for (std::size_t i = 0; i < plan_->pairs.size(); ++i) {
    const CheckedPair& pair = plan_->pairs[i];
    const collision::PairIndex index =
        state->scene.addPair(pair.part, pair.own ? pair.other : first + pair.other, static_cast<std::uint32_t>(i));
    if (pair.left_out) state->scene.setEnabled(index, false);
  }
  return {plan_, std::move(state)};
}

const std::vector<NearPair>& Clearances::look(const EntityConfiguration& at, double within) {
  State& state = *state_;
  state.at = at;
  state.within = within;
  linkPoses(plan_->robot(), at.joints, state.X_EL);
  const std::vector<manipulation::MovedPart>& moved = plan_->model.parts();
  for (std::uint32_t i = 0; i < moved.size(); ++i) {
    state.scene.setPose(i, at.X_WE * state.X_EL[static_cast<std::size_t>(plan_->linkOf(i))] * moved[i].X_LP);
  }
  state.found.clear();
  state.scene.pairsWithin(within, state.found);
  state.near.clear();
  for (const collision::PairDistance& one : state.found) {
    const std::size_t index = state.scene.tag(one.pair);
    const CheckedPair& pair = plan_->pairs[index];
    state.near.push_back({index, plan_->linkOf(pair.part), pair.own ? plan_->linkOf(pair.other) : -1,
                          one.result.distance, one.result.p_WA, one.result.p_WB, one.result.nhat_BA_W});
  }
  return state.near;
}

const std::vector<NearPair>& Clearances::near() const {
  return state_->near;
}

double Clearances::safeShare(const EntityConfiguration& to) const {
  const StepBounds bounds(plan_->robot(), state_->X_EL, state_->at, to);
  double share = 1.0, widest = 0.0;
  std::vector<double> ways;
  for (std::size_t part = 0; part < plan_->balls.size(); ++part) {
    ways.push_back(bounds.inWorld(plan_->linkOf(part), plan_->balls[part].p_LB, plan_->balls[part].radius));
    widest = std::max(widest, ways.back());
  }
  const auto cut = [&share](double way, double distance) {
    if (way > kUsedShare * distance) share = std::min(share, kUsedShare * distance / way);
  };
  // What is not listed is at least so far away; two own parts may both move.
  cut(2.0 * widest, state_->within);
  for (const NearPair& near : state_->near) {
    const CheckedPair& pair = plan_->pairs[near.index];
    if (!pair.own) {
      cut(ways[pair.part], near.distance);
      continue;
    }
    const Plan::Ball &one = plan_->balls[pair.part], &two = plan_->balls[pair.other];
    cut(bounds.between(near.link, one.p_LB, one.radius, near.other_link, two.p_LB, two.radius), near.distance);
  }
  return share;
}

Text Clearances::wordsOf(const NearPair& pair) const {
  return Text("%1 and %2", plan_->pairs[pair.index].moved, plan_->pairs[pair.index].met);
}

const std::vector<NearPair>& Clearances::touchingAtStart() const {
  return plan_->touching;
}

const Text& Clearances::note() const {
  return plan_->note;
}

std::span<const Clearances::Obstacle> Clearances::obstacles() const {
  return plan_->obstacles;
}

}  // namespace hapticell::agents
