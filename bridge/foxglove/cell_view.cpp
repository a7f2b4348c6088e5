// SPDX-License-Identifier: Apache-2.0
#include "bridge/foxglove/cell_view.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>

#include "bridge/foxglove/scene_message.h"
#include "exchange/messages/ros_messages.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::bridge {

namespace {

using exchange::RosHeader;
using nlohmann::ordered_json;
using workcell::Entity;
using workcell::EntityId;

constexpr const char* kWorld = "world";
/// Frames that do not move are sent again after this time, for viewers that forget old ones. Half: twice the bytes at
/// rest; twice: still within the ten seconds that Foxglove's 3D panel keeps frames.
constexpr std::int64_t kAllAgainNs = 1'000'000'000;

ViewerTopic rosTopic(const char* name, const std::string& type) {
  return {name, "cdr", type, "ros2msg", exchange::rosDefinition(type)};
}

ViewerTopic jsonTopic(const char* name, const char* schema_name, std::string schema) {
  return {name, "json", schema_name, "jsonschema", std::move(schema)};
}

/// Joints as many as the model has: those that are missing are at the nearest position to 0.
std::vector<double> wholeJoints(const kinematics::RobotModel& model, std::vector<double> joints) {
  for (std::size_t k = joints.size(); k < model.dof(); ++k) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(model.moving[k])];
    joints.push_back(std::min(std::max(0.0, joint.lower), joint.upper));
  }
  return joints;
}

std::string nameOf(const Entity* entity, const std::string& part) {
  if (!entity) return {};
  return part.empty() ? entity->name : entity->name + "/" + part;
}

}  // namespace

std::int64_t nowForViewers() {
  // The date once, and from there on a clock that nobody sets: stamps never go back.
  using Clock = std::chrono::steady_clock;
  static const Clock::time_point begin = Clock::now();
  static const std::int64_t begin_ns = 1'000'000'000 * static_cast<std::int64_t>(std::time(nullptr));
  return begin_ns + std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - begin).count();
}

CellView::CellView(ViewerServer& server)
    : server_(server),
      scene_(server.addTopic(jsonTopic("/scene", "foxglove.SceneUpdate", sceneSchema()))),
      frames_(server.addTopic(rosTopic("/tf", "tf2_msgs/msg/TFMessage"))),
      joints_(server.addTopic(rosTopic("/joint_states", "sensor_msgs/msg/JointState"))),
      stylus_(server.addTopic(rosTopic("/stylus/pose", "geometry_msgs/msg/PoseStamped"))),
      wrench_(server.addTopic(rosTopic("/stylus/wrench", "geometry_msgs/msg/WrenchStamped"))),
      force_(server.addTopic(jsonTopic("/force", "hapticell.Force", forceSchema()))),
      contacts_(server.addTopic(jsonTopic("/contacts", "hapticell.Contacts", contactsSchema()))),
      points_(server.addTopic(jsonTopic("/contact_points", "foxglove.SceneUpdate", sceneSchema()))),
      log_(server.addTopic(jsonTopic("/log", "foxglove.Log", logSchema()))) {}

void CellView::showCell(const workcell::DocumentState& cell, std::int64_t stamp_ns) {
  std::unordered_map<EntityId, Shown> before = std::move(shown_);
  shown_.clear();
  order_.clear();
  for (const auto& entity : cell.entities) {
    const auto old = before.find(entity->id);
    const bool is_new = old == before.end() || !entity->visible;
    const bool looks_same = !is_new && old->second.entity->visible && old->second.entity->name == entity->name &&
                            old->second.entity->color == entity->color && old->second.entity->mesh() == entity->mesh() &&
                            old->second.entity->robot() == entity->robot();
    if (old != before.end() && !looks_same) hideShapes(*old->second.entity, stamp_ns);
    if (old != before.end()) before.erase(old);
    if (!entity->visible) continue;
    if (!looks_same) showShapes(*entity, stamp_ns);
    shown_[entity->id] = {entity, entity->X_WE, entity->joints(), true};
    order_.push_back(entity->id);
  }
  for (const auto& [id, gone] : before) hideShapes(*gone.entity, stamp_ns);
  all_sent_ns_ = 0;
}

void CellView::showShapes(const Entity& entity, std::int64_t stamp_ns) {
  if (entity.mesh()) {
    const SceneShape shape{entity.mesh().get(), {}, {entity.color[0], entity.color[1], entity.color[2]}};
    server_.keep(scene_, entity.name, stamp_ns, modelMessage(entity.name, entity.name, {&shape, 1}, stamp_ns));
  }
  if (!entity.robot()) return;
  for (const kinematics::Link& link : entity.robot()->links) {
    std::vector<SceneShape> shapes;
    for (const kinematics::LinkShape& visual : link.visuals)
      shapes.push_back({visual.mesh.get(), visual.X_LS, {visual.color[0], visual.color[1], visual.color[2]}});
    const std::string frame = entity.name + "/" + link.name;
    if (!shapes.empty()) server_.keep(scene_, frame, stamp_ns, modelMessage(frame, frame, shapes, stamp_ns));
  }
}

void CellView::hideShapes(const Entity& entity, std::int64_t stamp_ns) {
  const auto hide = [&](const std::string& id) { server_.keep(scene_, id, stamp_ns, deletionMessage(id, stamp_ns)); };
  if (entity.mesh()) hide(entity.name);
  if (!entity.robot()) return;
  for (const kinematics::Link& link : entity.robot()->links)
    if (!link.visuals.empty()) hide(entity.name + "/" + link.name);
}

void CellView::update(const manipulation::SceneSnapshot& now, std::int64_t stamp_ns) {
  place(now);
  const bool is_all = stamp_ns - all_sent_ns_ >= kAllAgainNs || stamp_ns < all_sent_ns_;
  if (is_all) {
    for (auto& [id, shown] : shown_) shown.has_changed = true;
    all_sent_ns_ = stamp_ns;
  }
  sendFrames(stamp_ns);
  sendJoints(stamp_ns);
  if (now.stylus.connected) sendStylus(now.stylus, stamp_ns);
  sendContacts(now, stamp_ns);
  sendWords(now, stamp_ns);
  for (auto& [id, shown] : shown_) shown.has_changed = false;
}

void CellView::place(const manipulation::SceneSnapshot& now) {
  std::unordered_map<EntityId, const manipulation::EntityState*> moved;
  for (const manipulation::EntityState& state : now.entities) moved[state.id] = &state;
  for (auto& [id, shown] : shown_) {
    // What a snapshot does not name is as the document has it.
    const auto state = moved.find(id);
    const Pose& X_WE = state == moved.end() ? shown.entity->X_WE : state->second->X_WE;
    const bool has_joints = state != moved.end() && !state->second->joints.empty();
    const std::vector<double>& joints = has_joints ? state->second->joints : shown.entity->joints();
    if (X_WE.p == shown.X_WE.p && X_WE.q == shown.X_WE.q && joints == shown.joints) continue;
    shown.X_WE = X_WE;
    shown.joints = joints;
    shown.has_changed = true;
  }
}

void CellView::sendFrames(std::int64_t stamp_ns) {
  exchange::RosTransforms message;
  const RosHeader header{stamp_ns, kWorld};
  std::vector<Pose> X_BL;
  bool is_whole = true;
  for (const EntityId id : order_) {
    const Shown& shown = shown_.at(id);
    is_whole = is_whole && shown.has_changed;
    if (!shown.has_changed) continue;
    message.transforms.push_back({header, shown.entity->name, shown.X_WE});
    if (!shown.entity->robot()) continue;
    const kinematics::RobotModel& model = *shown.entity->robot();
    kinematics::forwardKinematics(model, wholeJoints(model, shown.joints), X_BL);
    const RosHeader base{stamp_ns, shown.entity->name};
    for (std::size_t k = 0; k < model.links.size(); ++k)
      message.transforms.push_back({base, shown.entity->name + "/" + model.links[k].name, X_BL[k]});
  }
  if (message.transforms.empty()) return;
  // A whole set is kept, so that a viewer who comes finds everything placed at once.
  if (is_whole) {
    server_.keep(frames_, "all", stamp_ns, toCdr(message));
  } else {
    server_.publish(frames_, stamp_ns, toCdr(message));
  }
}

void CellView::sendJoints(std::int64_t stamp_ns) {
  exchange::RosJointState message;
  message.header = {stamp_ns, kWorld};
  for (const EntityId id : order_) {
    const Shown& shown = shown_.at(id);
    if (!shown.entity->robot() || !shown.has_changed) continue;
    const kinematics::RobotModel& model = *shown.entity->robot();
    const std::vector<double> joints = wholeJoints(model, shown.joints);
    for (std::size_t k = 0; k < model.moving.size(); ++k) {
      message.name.push_back(shown.entity->name + "/" + model.joints[static_cast<std::size_t>(model.moving[k])].name);
      message.position.push_back(joints[k]);
    }
  }
  if (!message.name.empty()) server_.publish(joints_, stamp_ns, toCdr(message));
}

void CellView::sendStylus(const manipulation::StylusState& stylus, std::int64_t stamp_ns) {
  const RosHeader header{stamp_ns, kWorld};
  server_.publish(stylus_, stamp_ns, toCdr(exchange::RosPoseStamped{header, stylus.X_WStylus}));
  server_.publish(wrench_, stamp_ns, toCdr(exchange::RosWrenchStamped{header, stylus.force_W, dvec3(0.0)}));
}

void CellView::sendContacts(const manipulation::SceneSnapshot& now, std::int64_t stamp_ns) {
  ordered_json pairs = ordered_json::array();
  std::vector<ScenePoint> points;
  int touching = 0;
  for (const manipulation::PairState& pair : now.pairs) {
    const auto moved = shown_.find(pair.moved), other = shown_.find(pair.other);
    if (moved == shown_.end() || other == shown_.end()) continue;
    if (!pair.contact && !pair.near_miss) continue;
    touching += pair.contact ? 1 : 0;
    pairs.push_back({{"first", nameOf(moved->second.entity.get(), pair.moved_part)},
                     {"second", nameOf(other->second.entity.get(), pair.other_part)},
                     {"distance", pair.distance},
                     {"contact", pair.contact}});
    points.push_back({pair.p_WA, pair.p_WB, pair.contact});
  }
  server_.publish(force_, stamp_ns, ordered_json{{"newtons", now.stylus.force_n}, {"contacts", touching}}.dump());
  server_.publish(contacts_, stamp_ns, ordered_json{{"pairs", std::move(pairs)}}.dump());
  server_.publish(points_, stamp_ns, pointsMessage(kWorld, points, stamp_ns));
}

void CellView::sendWords(const manipulation::SceneSnapshot& now, std::int64_t stamp_ns) {
  std::string words;
  for (const Text& sentence : now.status) words += (words.empty() ? "" : ". ") + english(sentence);
  if (words == last_words_) return;
  last_words_ = words;
  if (!words.empty()) server_.publish(log_, stamp_ns, logMessage(words, stamp_ns));
}

}  // namespace hapticell::bridge
