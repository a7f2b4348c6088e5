// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/contact_markers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bridge/ros2/ros_conversion.h"
#include "collision/queries/freeing_shift.h"
#include "collision/queries/scene.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/scene/scene_service.h"

namespace hapticell::bridge {

namespace {

constexpr std::int32_t kTypeArrow = 0, kTypeSphere = 2, kActionAdd = 0, kActionDelete = 2;
/// m: how far apart the parts of a listed contact may be. Ten times the safety distance of the defaults. Half: contacts
/// of pairs with a large distance are lost; twice: more pairs are measured.
constexpr double kLook = 0.010;
/// s: viewers remove a marker that is not sent again. Half: a hiccup of the network makes it blink; twice: it stays a
/// second after a publisher that was killed.
constexpr double kLifetime = 0.5;

/// One contact at one moment.
struct Contact {
  std::string name;
  dvec3 p_W{0.0}, nhat_W{0.0, 0.0, 1.0};
  double depth = 0.0;  ///< m
  double force = 0.0;  ///< N along the normal.
};

/// The rotation that turns the x axis to a unit vector.
geometry_msgs_msg_dds__Quaternion_ alongX(const dvec3& n) {
  if (n.x < -1.0 + 1e-12) return {0.0, 0.0, 1.0, 0.0};
  const double w = 1.0 + n.x, length = std::sqrt(w * w + n.y * n.y + n.z * n.z);
  return {0.0, -n.z / length, n.y / length, w / length};
}

}  // namespace

/// Finds the contacts by exact distances.
class ContactMarkers::Contacts {
 public:
  Contacts(std::unique_ptr<manipulation::HeldEntity> held, const manipulation::MotionReplay& replay)
      : held_(std::move(held)), replay_(replay) {
    const manipulation::FreeMotion& motion = held_->motion();
    const auto moved = static_cast<std::uint32_t>(motion.parts().size());
    for (const auto& collider : motion.parts()) scene_.addPart({1, 0}, collider);
    for (const auto& obstacle : motion.obstacles()) scene_.addPart({2, 0}, obstacle.collider, obstacle.X_WO);
    for (const manipulation::MotionPair& pair : motion.pairs()) {
      const bool is_own = pair.other_part >= 0;
      const auto other = is_own ? static_cast<std::uint32_t>(pair.other_part) : moved + pair.obstacle;
      const auto index = scene_.addPair(pair.part, other);
      names_[index] = {held_->nameOf(*held_->movedParts()[pair.part].part),
                       held_->nameOf(is_own ? *held_->movedParts()[other].part : *held_->obstacleParts()[pair.obstacle])};
    }
    X_WP_.resize(moved);
    for (const collision::PairDistance& near : nearAt(replay_.motion()[0].t))
      if (near.result.colliding) at_start_.insert(near.pair);
  }

  /// Those at `t`; of several between the same names the deepest, else the nearest.
  std::vector<Contact> at(double t) {
    std::map<std::string, Contact> found;
    const dvec3 force = forceAt(t);
    for (const collision::PairDistance& near : nearAt(t)) {
      const auto& [first, second] = names_.at(near.pair);
      const bool enters = near.result.colliding && !at_start_.contains(near.pair);
      if (!enters && !isListed(first, second, t)) continue;
      Contact contact{first + " / " + second, 0.5 * (near.result.p_WA + near.result.p_WB), near.result.nhat_BA_W};
      if (near.result.colliding) measureDepth(near.pair, contact);
      contact.force = std::max(0.0, dot(force, contact.nhat_W));
      const auto [known, is_new] = found.try_emplace(contact.name, contact);
      if (!is_new && contact.depth > known->second.depth) known->second = contact;
    }
    std::vector<Contact> contacts;
    for (auto& [name, contact] : found) contacts.push_back(std::move(contact));
    return contacts;
  }

 private:
  std::vector<collision::PairDistance> nearAt(double t) {
    held_->manipulator().partPoses(replay_.at(t), X_WP_);
    for (std::uint32_t part = 0; part < X_WP_.size(); ++part) scene_.setPose(part, X_WP_[part]);
    std::vector<collision::PairDistance> near;
    scene_.pairsWithin(kLook, near);
    return near;
  }

  bool isListed(const std::string& first, const std::string& second, double t) const {
    return std::ranges::any_of(replay_.motion().touches, [&](const trajectory::Trajectory::Touch& touch) {
      return touch.t_in <= t && t < touch.t_out && touch.first == first && touch.second == second;
    });
  }

  /// Force on the hand in the world, N; 0 without its channels.
  dvec3 forceAt(double t) const {
    const trajectory::Trajectory& motion = replay_.motion();
    const auto x = motion.findChannel("force_x"), y = motion.findChannel("force_y"), z = motion.findChannel("force_z");
    if (!x || !y || !z) return dvec3(0.0);
    const auto frames = motion.frames();
    const auto after =
        std::upper_bound(frames.begin(), frames.end(), t, [](double time, const auto& frame) { return time < frame.t; });
    const auto values = motion.channels(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - frames.begin() - 1)));
    return {values[*x], values[*y], values[*z]};
  }

  /// The shortest way out that is found gives depth and normal.
  void measureDepth(collision::PairIndex pair, Contact& contact) {
    const auto a = scene_.moved(pair), b = scene_.environment(pair);
    collision::ProximityQuery query(scene_.sharedCollider(a), scene_.sharedCollider(b));
    const collision::FreeingShift shift = collision::freeingShift(query, scene_.pose(a), scene_.pose(b));
    if (!shift.found) return;
    contact.depth = shift.depth;
    contact.nhat_W = shift.direction_W;
  }

  std::unique_ptr<manipulation::HeldEntity> held_;
  const manipulation::MotionReplay replay_;
  collision::Scene scene_;
  std::map<collision::PairIndex, std::pair<std::string, std::string>> names_;
  std::vector<Pose> X_WP_;
  std::set<collision::PairIndex> at_start_;  ///< Pairs that intersect in the first frame.
};

Expected<std::unique_ptr<ContactMarkers>> ContactMarkers::create(const workcell::Document& cell,
                                                                 const std::string& entity,
                                                                 const manipulation::MotionReplay& replay,
                                                                 double rate_hz) {
  const auto scene = manipulation::SceneService().prepare(manipulation::sourceOf(cell, {}));
  auto moved_by = manipulation::parseMovedBy(replay.motion().moved);
  HAPTICELL_TRY(moved_by);
  manipulation::HoldOptions hold;
  hold.moved_by = std::move(*moved_by);
  const workcell::Entity* const held_entity = scene->find(entity);
  if (held_entity == nullptr) return makeError({.found = Text("no entity is named '%1'", entity)});
  auto held = manipulation::HeldEntity::take(scene, held_entity->id, {}, hold, {});
  HAPTICELL_TRY(held);
  return std::unique_ptr<ContactMarkers>(
      new ContactMarkers(std::make_unique<Contacts>(std::move(*held), replay), rate_hz));
}

ContactMarkers::ContactMarkers(std::unique_ptr<Contacts> contacts, double rate_hz)
    : contacts_(std::move(contacts)), lifetime_(std::max(kLifetime, 2.0 / rate_hz)) {}

ContactMarkers::~ContactMarkers() = default;

const visualization_msgs_msg_dds__MarkerArray_* ContactMarkers::update(std::int64_t stamp_ns, double t) {
  markers_.clear();
  names_.clear();
  std::vector<std::string> now;
  for (const Contact& contact : contacts_->at(t)) {
    now.push_back(contact.name);
    add(stamp_ns, contact.name, kArrow, kActionAdd);
    markers_.back().pose = {{contact.p_W.x, contact.p_W.y, contact.p_W.z}, alongX(contact.nhat_W)};
    markers_.back().scale = {kShortest + kLengthPerN * contact.force, 0.3 * kShortest, 0.6 * kShortest};
    add(stamp_ns, contact.name, kBall, kActionAdd);
    markers_.back().type = kTypeSphere;
    markers_.back().pose = {{contact.p_W.x, contact.p_W.y, contact.p_W.z}, {0.0, 0.0, 0.0, 1.0}};
    const double width = kShortest + 2.0 * contact.depth;
    markers_.back().scale = {width, width, width};
  }
  for (const std::string& name : shown_) {
    if (std::ranges::find(now, name) != now.end()) continue;
    for (const std::int32_t id : {kArrow, kBall}) add(stamp_ns, name, id, kActionDelete);
  }
  shown_ = std::move(now);
  return message();
}

const visualization_msgs_msg_dds__MarkerArray_* ContactMarkers::clear(std::int64_t stamp_ns) {
  markers_.clear();
  names_.clear();
  for (const std::string& name : shown_)
    for (const std::int32_t id : {kArrow, kBall}) add(stamp_ns, name, id, kActionDelete);
  shown_.clear();
  return message();
}

void ContactMarkers::add(std::int64_t stamp_ns, const std::string& name, std::int32_t id, std::int32_t action) {
  static const std::string kFrame = "world";
  visualization_msgs_msg_dds__Marker_& marker = markers_.emplace_back();
  marker = {};
  marker.header = rosHeader(stamp_ns, kFrame);
  marker.ns = names_.emplace_back(name).data();
  marker.id = id;
  marker.type = kTypeArrow;
  marker.action = action;
  marker.pose.orientation.w = 1.0;
  marker.color = {0.9F, 0.2F, 0.1F, 1.0F};
  const auto nanoseconds = std::llround(1e9 * lifetime_);
  marker.lifetime = {static_cast<std::int32_t>(nanoseconds / 1'000'000'000),
                     static_cast<std::uint32_t>(nanoseconds % 1'000'000'000)};
}

const visualization_msgs_msg_dds__MarkerArray_* ContactMarkers::message() {
  if (markers_.empty()) return nullptr;
  message_.markers._buffer = markers_.data();
  message_.markers._length = message_.markers._maximum = static_cast<std::uint32_t>(markers_.size());
  return &message_;
}

}  // namespace hapticell::bridge
