// SPDX-License-Identifier: Apache-2.0
// What the user asks of the engine: its commands, the stylus's buttons, what is taken and how it follows the hand.
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/system/assertion.h"
#include "manipulation/engine/manipulation_step.h"

namespace hapticell::manipulation {

namespace {

constexpr std::uint32_t kGrabButton = 1, kClutchButton = 2;
constexpr double kTipReach = 0.010;  ///< m of hand space within which the tip touches something.

template <typename... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <typename... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

/// The documents say the same of where the entity stands: where else it has come to meanwhile goes on being true.
bool standsInBoth(workcell::EntityId id, const PreparedScene& before, const PreparedScene& now) {
  const workcell::Entity *a = before.find(id), *b = now.find(id);
  return a && b && a->X_WE.p == b->X_WE.p && a->X_WE.q == b->X_WE.q && a->joints == b->joints;
}

}  // namespace

void ManipulationEngine::setScene(std::shared_ptr<const PreparedScene> scene) {
  Placements kept;
  if (held_) {
    kept[held_->id()] = held_->standing();
    for (auto& [id, at] : held_->carried()) kept[id] = std::move(at);
  }
  if (posed_ && standsInBoth(posed_->id(), *scene_, *scene)) kept.emplace(posed_->id(), posed_->standing());
  scene_ = std::move(scene);
  placements_ = std::move(kept);
  posed_.reset();  // Taken anew at the next step.
  if (wanted_pose_) poseJoints(command::PoseJoints(*wanted_pose_));
  if (scene_->find(chosen_) == nullptr) chosen_ = 0;
  if (held_) retake();
}

void ManipulationEngine::apply(const Command& command) {
  std::visit(Overloaded{[&](const command::SetDocument& c) {
                          const workcell::PairDefaults rule{configuration_.manipulation.safety_distance,
                                                            configuration_.manipulation.near_miss};
                          setScene(PreparedScene::prepare(c.entities, c.pairs, rule, scene_.get()));
                        },
                        [&](const command::SetGuides& c) {
                          guides_ = c.guides;
                          set_wanted_ = true;
                        },
                        [&](const command::ChooseEntity& c) {
                          chosen_ = c.entity;
                          on_contact_.reset();
                          force_class_.reset();
                        },
                        [&](const command::SetMovedBy& c) {
                          moved_by_ = c.moved_by;
                          retake();
                        },
                        [&](const command::SetAxes& c) {
                          axes_ = c.axes;
                          updateMapping();
                        },
                        [&](const command::SetScale& c) {
                          scale_ = c.scale;
                          updateMapping();
                        },
                        [&](const command::SetCamera& c) {
                          camera_ = c;
                          updateMapping();
                        },
                        [&](const command::SetOnContact& c) {
                          on_contact_ = c.on_contact;
                          retake();
                        },
                        [&](const command::SetForceClass& c) {
                          force_class_ = c.force_class;
                          retake();
                        },
                        [&](const command::SetForces& c) {
                          control_.forces_enabled = c.on;
                          link_.sendControl(control_);
                        },
                        [&](const command::SetFilter& c) {
                          mapping_.setFilter(c.translates, c.rotates);
                          mapping_.setAxisFilter(c.axes[0], c.axes[1], c.axes[2]);
                          mapping_.setTurnFilter(c.turns[0], c.turns[1], c.turns[2]);
                          anchorMapping();
                        },
                        [&](const command::SetClutch& c) { clutch_command_ = c.on; },
                        [&](const command::SetHandTarget& c) { link_.sendHandTarget(c.target); },
                        [&](const command::Grab& c) { grab(c.entity); }, [&](const command::Release&) { release(); },
                        [&](const command::PoseJoints& c) { poseJoints(c); },
                        [&](const command::StartRecording& c) { startRecording(c); },
                        [&](const command::MarkFrame&) { mark_wanted_ = true; },
                        [&](const command::StopRecording&) { stopRecording(); }},
             command);
}

double ManipulationEngine::scaleInForce() const {
  const config::Configuration::Scale& levels = configuration_.scale;
  switch (scale_.level) {
    case ScaleLevel::kRough:
      return levels.rough;
    case ScaleLevel::kMedium:
      return levels.medium;
    case ScaleLevel::kFine:
      return levels.fine;
    case ScaleLevel::kNumber:
      return scale_.number;
    case ScaleLevel::kScreen:
      break;
  }
  const std::optional<haptic::DeviceDescription> device = link_.device();
  const double width = device ? device->workspace_max.x - device->workspace_min.x : 0.16;
  return levels.screen * screenScale(camera_.visible_width, width);
}

void ManipulationEngine::updateMapping() {
  Pose X_WF;
  if (axes_.mode == AxesMode::kFrame && scene_) {
    if (const PreparedScene::FoundFrame frame = scene_->findFrame(axes_.frame); frame.entity != nullptr) {
      X_WF = placement(frame.entity->id).X_WE * frame.X_EF;
    } else {
      notice("There is no frame '" + axes_.frame + "' to move along; the cell's axes are used");
    }
  }
  const dquat q_WD = deviceAxes(axes_.mode, camera_.X_WCamera, X_WF);
  const double scale = scaleInForce();
  // Turning the view a little all the time must not make sets anew all the time.
  const bool same = std::abs(glm::dot(q_WD, mapping_.axes())) > 1.0 - 1e-12 && scale == mapping_.scale();
  mapping_.setAxes(q_WD);
  mapping_.setScale(scale);
  mapping_.setRotationScale(configuration_.scale.rotation);
  if (!same || !held_) anchorMapping();
}

void ManipulationEngine::anchorMapping() {
  set_wanted_ = true;
  if (held_) {
    mapping_.anchor(state_ ? state_->X_DP : Pose::identity(), held_->movedFrame());
  } else {
    mapping_.anchor(Pose::identity(), Pose::translation(camera_.p_WFocus));
  }
}

void ManipulationEngine::hold(workcell::EntityId entity) {
  const workcell::Entity* found = scene_ ? scene_->find(entity) : nullptr;
  if (found == nullptr) return;
  const HoldOptions options{moved_by_, on_contact_.value_or(found->on_contact),
                            force_class_.value_or(found->force_class), joints_move_};
  auto taken = HeldEntity::take(scene_, entity, placements_, options, configuration_);
  if (!taken) {
    notice(taken.error().message());
    return;
  }
  held_ = std::move(*taken);
  held_->searchWith(search_.get());
  hurried_joint_ = -1;
  for (const std::string& note : held_->notes()) {
    if (told_.insert(note).second) notice(note);
  }
  gaps_.assign(held_->pairs().size(), std::numeric_limits<double>::infinity());
}

void ManipulationEngine::retake() {
  if (!held_) return;
  const workcell::EntityId id = held_->id();
  placements_[id] = held_->standing();
  for (auto& [carried, at] : held_->carried()) placements_[carried] = std::move(at);
  held_.reset();
  contacts_.clear();
  passed_.clear();
  passed_ns_ = -1;
  near_.clear();
  built_ = {};
  hold(id);
  updateMapping();
  anchorMapping();
}

void ManipulationEngine::grab(workcell::EntityId wanted) {
  if (held_ || !scene_) return;
  workcell::EntityId entity = wanted != 0 ? wanted : chosen_;
  if (entity == 0) entity = entityAtTip();
  if (entity == 0) return;
  if (const std::string why = heldElsewhere(entity); !why.empty()) return notice(why);
  hold(entity);
  if (!held_) return;
  stopped_ = false;
  updateMapping();
  anchorMapping();
  results_.emplace_back(result::Grabbed{entity});
}

void ManipulationEngine::release() {
  if (!held_) return;
  placements_[held_->id()] = held_->standing();
  for (auto& [id, at] : held_->carried()) placements_[id] = std::move(at);
  const EntityConfiguration at = held_->standing();
  result::Moved moved{held_->id(), at.X_WE, at.joints};
  for (auto& [id, axis] : held_->axes()) moved.axes.push_back({id, axis.X_WE, axis.joints});
  results_.emplace_back(std::move(moved));
  held_.reset();
  built_ = {};
  contacts_.clear();
  passed_.clear();
  passed_ns_ = -1;
  near_.clear();
  stopped_ = joints_move_ = false;
  set_wanted_ = true;
}

workcell::EntityId ManipulationEngine::entityAtTip() const {
  if (!state_) return 0;
  geometry::TriangleMesh point;
  point.vertices = {dvec3(0.0)};
  point.triangles = {{0, 0, 0}};
  const auto tip = collision::MeshCollider::build(point);
  const Pose X_WTip = mapping_.toCell(state_->X_DS);
  double nearest = kTipReach * mapping_.scale();
  workcell::EntityId found = 0;
  for (const ScenePart& part : scene_->parts()) {
    const workcell::Entity& entity = *scene_->find(part.entity);
    if (entity.locked || !entity.visible) continue;
    const EntityConfiguration at = placement(part.entity);
    const Pose X_WP = PreparedScene::partPose(entity, at.X_WE, at.joints, part.link);
    const collision::DistanceResult result = collision::distance(tip, X_WTip, part.mesh.collider, X_WP, nearest);
    if (result.beyond_limit || result.distance >= nearest) continue;
    nearest = result.distance;
    found = part.entity;
  }
  return found;
}

void ManipulationEngine::watchButtons() {
  const std::uint32_t pressed = state_->buttons & ~last_buttons_;
  const std::uint32_t let_go = last_buttons_ & ~state_->buttons;
  last_buttons_ = state_->buttons;
  if ((pressed & kGrabButton) != 0) held_ ? release() : grab(0);
  if ((let_go & kGrabButton) != 0 && configuration_.manipulation.hold_to_move) release();
  const bool own = recorder_ && mark_by_button_, marks = own || marks_for_other_;
  if (marks && (pressed & kClutchButton) != 0) (own ? mark_wanted_ : mark_for_other_) = true;
  setClutched(clutch_command_ || (!marks && (state_->buttons & kClutchButton) != 0));
}

void ManipulationEngine::setClutched(bool clutched) {
  if (clutched == clutched_) return;
  clutched_ = clutched;
  set_wanted_ = true;
  contacts_.clear();
  passed_.clear();
  passed_ns_ = -1;
  if (!clutched && held_) anchorMapping();
}

}  // namespace hapticell::manipulation
