// SPDX-License-Identifier: Apache-2.0
// The pairs of links that need no check, of `ros2 package`: how long a random position takes, and the same positions by
// FCL, pair by pair, in the same process. Both must count the same contacts, but for links that lie in another one
// without crossing its surface: FCL compares surfaces only. Prints rows of docs/dev/performance.md.
//
// usage: link_pairs_bench ROBOT... (a file, or library:NAME; default library:ur5e)
#include <algorithm>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "bench/fcl_peer.h"
#include "bench/thread_clock.h"
#include "manipulation/checks/link_pairs.h"
#include "workcell/import/entity_source.h"

namespace hapticell::bench {
namespace {

/// Positions that both count; FCL takes minutes for the 100,000 of `ros2 package`.
constexpr int kCounted = 2000;

geometry::TriangleMesh meshOf(const kinematics::Link& link) {
  geometry::TriangleMesh whole;
  for (const kinematics::LinkShape& shape : link.collisions)
    if (shape.mesh) geometry::append(whole, *shape.mesh, shape.X_LS);
  return whole;
}

/// As `linkPairUse()` draws them.
std::vector<double> randomPositions(const kinematics::RobotModel& model, std::mt19937_64& random) {
  std::vector<double> q;
  for (const int index : model.moving) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(index)];
    const bool is_open = joint.type == kinematics::JointType::kContinuous;
    const double low = is_open ? -std::numbers::pi : joint.lower, high = is_open ? std::numbers::pi : joint.upper;
    q.push_back(low + static_cast<double>(random() >> 11) * 0x1p-53 * (high - low));
  }
  return q;
}

/// Contacts of each pair at the same positions, by FCL.
std::vector<int> contactsByFcl(const kinematics::RobotModel& model,
                               const std::vector<manipulation::LinkPairUse>& pairs, double& milliseconds) {
  std::vector<std::unique_ptr<FclPeer>> peers;
  for (const auto& pair : pairs) {
    peers.push_back(std::make_unique<FclPeer>(meshOf(model.links[static_cast<std::size_t>(pair.second)]),
                                              meshOf(model.links[static_cast<std::size_t>(pair.first)])));
  }
  std::vector<int> contacts(pairs.size(), 0);
  std::mt19937_64 random(1);
  std::vector<Pose> X_BL;
  const double begin = threadMilliseconds();
  for (int i = 0; i < kCounted; ++i) {
    kinematics::forwardKinematics(model, randomPositions(model, random), X_BL);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Pose X = X_BL[static_cast<std::size_t>(pairs[k].first)].inverse() *
                     X_BL[static_cast<std::size_t>(pairs[k].second)];
      contacts[k] += peers[k]->collides(X) ? 1 : 0;
    }
  }
  milliseconds = threadMilliseconds() - begin;
  return contacts;
}

/// False if FCL counts a contact more.
bool measure(const std::string& what) {
  workcell::EntityLoader loader("/");
  Diagnostics notes;
  const auto entity = loader.load(what, 0.0, notes);
  if (!entity || !entity->robot()) {
    std::fprintf(stderr, "%s: not a robot\n", what.c_str());
    return false;
  }
  const kinematics::RobotModel& model = *entity->robot();
  const double first = threadMilliseconds();
  const auto nothing = manipulation::linkPairUse(model, {.samples = 0});
  const double prepared = threadMilliseconds();
  const auto ours = manipulation::linkPairUse(model, {.samples = kCounted, .seed = 1});
  const double ours_ms = threadMilliseconds() - prepared - (prepared - first);
  double fcl_ms = 0.0;
  const std::vector<int> theirs = contactsByFcl(model, ours, fcl_ms);
  int contacts = 0, more = 0, fewer = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    contacts += ours[k].contacts;
    more += std::max(0, ours[k].contacts - theirs[k]);
    fewer += std::max(0, theirs[k] - ours[k].contacts);
  }
  std::printf("| %s | %zu | %d | %.1f | %.1f | %.1f | %d, %d |\n", what.c_str(), ours.size(), contacts,
              1e3 * ours_ms / kCounted, 1e3 * fcl_ms / kCounted, fcl_ms / ours_ms, more, fewer);
  return fewer == 0 && nothing.size() == ours.size();
}

}  // namespace
}  // namespace hapticell::bench

int main(int count, char** words) {
  std::vector<std::string> robots(words + 1, words + count);
  if (robots.empty()) robots = {"library:ur5e"};
  std::printf("| robot | pairs | contacts in %d positions | us a position | FCL, us | times | contacts more, fewer than FCL |\n"
              "| --- | --- | --- | --- | --- | --- | --- |\n",
              hapticell::bench::kCounted);
  bool same = true;
  for (const std::string& robot : robots) same = hapticell::bench::measure(robot) && same;
  return same ? 0 : 1;
}
