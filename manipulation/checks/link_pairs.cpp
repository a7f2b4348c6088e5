// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/link_pairs.h"

#include <algorithm>
#include <numbers>
#include <random>

#include "collision/queries/scene.h"

namespace hapticell::manipulation {

namespace {

using kinematics::RobotModel;

// m: below it is contact; an exact distance of touching parts is 0. Half, twice: the same.
constexpr double kContact = 1e-9;
// Of the samples, as MoveIt's setup assistant has it. Half: pairs that are often free are never checked; 1: a pair that
// always overlaps but for one sample makes every plan fail.
constexpr double kAlways = 0.95;

/// Links with a shape, placed in the root's frame.
class LinkScene {
 public:
  explicit LinkScene(const RobotModel& model) : model_(model) {
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      geometry::TriangleMesh whole;
      for (const kinematics::LinkShape& shape : model.links[i].collisions)
        if (shape.mesh) geometry::append(whole, *shape.mesh, shape.X_LS);
      if (whole.triangles.empty()) continue;
      parts_.push_back(scene_.addPart({1, static_cast<std::uint32_t>(i)}, collision::MeshCollider::build(whole)));
      links_.push_back(static_cast<int>(i));
    }
    for (std::size_t a = 0; a < parts_.size(); ++a)
      for (std::size_t b = a + 1; b < parts_.size(); ++b) scene_.addPair(parts_[a], parts_[b]);
  }

  const std::vector<int>& links() const { return links_; }

  /// Pairs of links that touch, smaller link first.
  const std::vector<std::pair<int, int>>& touching(const std::vector<double>& q) {
    kinematics::forwardKinematics(model_, q, X_BL_);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      scene_.setPose(parts_[i], X_BL_[static_cast<std::size_t>(links_[i])]);
    found_.clear();
    pairs_.clear();
    scene_.pairsWithin(kContact, found_);
    for (const collision::PairDistance& near : found_) {
      const auto a = static_cast<int>(scene_.key(scene_.moved(near.pair)).part);
      const auto b = static_cast<int>(scene_.key(scene_.environment(near.pair)).part);
      pairs_.emplace_back(std::min(a, b), std::max(a, b));
    }
    return pairs_;
  }

 private:
  const RobotModel& model_;
  collision::Scene scene_;
  std::vector<collision::PartIndex> parts_;
  std::vector<int> links_;
  std::vector<Pose> X_BL_;
  std::vector<collision::PairDistance> found_;
  std::vector<std::pair<int, int>> pairs_;
};

/// The nearest link above with a shape, or -1.
int shapedParent(const RobotModel& model, const std::vector<int>& shaped, int link) {
  for (int at = link;;) {
    const int joint = model.links[static_cast<std::size_t>(at)].parent_joint;
    if (joint < 0) return -1;
    at = model.joints[static_cast<std::size_t>(joint)].parent_link;
    if (std::find(shaped.begin(), shaped.end(), at) != shaped.end()) return at;
  }
}

std::vector<double> randomPositions(const RobotModel& model, std::mt19937_64& random) {
  std::vector<double> q;
  for (const int index : model.moving) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(index)];
    const bool is_open = joint.type == kinematics::JointType::kContinuous;
    const double low = is_open ? -std::numbers::pi : joint.lower, high = is_open ? std::numbers::pi : joint.upper;
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    q.push_back(low + share * (high - low));
  }
  return q;
}

}  // namespace

std::vector<LinkPairUse> linkPairUse(const RobotModel& model, const LinkPairOptions& options) {
  LinkScene scene(model);
  const std::vector<int>& links = scene.links();
  std::vector<LinkPairUse> use;
  std::vector<std::vector<std::size_t>> at(model.links.size(), std::vector<std::size_t>(model.links.size(), 0));
  for (std::size_t a = 0; a < links.size(); ++a) {
    for (std::size_t b = a + 1; b < links.size(); ++b) {
      const int first = links[a], second = links[b];
      at[static_cast<std::size_t>(first)][static_cast<std::size_t>(second)] = use.size();
      const bool adjacent =
          shapedParent(model, links, second) == first || shapedParent(model, links, first) == second;
      use.push_back({first, second, adjacent, false, 0});
    }
  }
  const auto useOf = [&](const std::pair<int, int>& pair) -> LinkPairUse& {
    return use[at[static_cast<std::size_t>(pair.first)][static_cast<std::size_t>(pair.second)]];
  };
  for (const auto& pair : scene.touching(kinematics::restPositions(model))) useOf(pair).at_rest = true;
  std::mt19937_64 random(options.seed);
  for (int i = 0; i < options.samples; ++i)
    for (const auto& pair : scene.touching(randomPositions(model, random))) ++useOf(pair).contacts;
  return use;
}

std::vector<kinematics::DisabledPair> pairsWithoutCheck(const RobotModel& model, const std::vector<LinkPairUse>& use,
                                                        int samples) {
  std::vector<kinematics::DisabledPair> pairs = model.disabled_pairs;
  for (const LinkPairUse& pair : use) {
    const bool is_known = std::ranges::any_of(model.disabled_pairs, [&](const kinematics::DisabledPair& known) {
      return std::minmax(known.first, known.second) == std::minmax(pair.first, pair.second);
    });
    std::string reason;
    if (pair.contacts == 0) reason = "Never";
    if (pair.contacts >= kAlways * samples) reason = "Always";
    if (pair.at_rest) reason = "Default";
    if (pair.adjacent) reason = "Adjacent";
    if (!is_known && !reason.empty()) pairs.push_back({pair.first, pair.second, reason});
  }
  return pairs;
}

}  // namespace hapticell::manipulation
