// SPDX-License-Identifier: Apache-2.0
// Scenes without number against brute force. HAPTICELL_SCENE_QUERIES: how many queries (100000 for the full run);
// HAPTICELL_SCENE_FIRST: the number of the first scene, to look at one again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "collision/queries/scene.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

int asked(const char* variable, int otherwise) {
  const char* value = std::getenv(variable);
  return value ? std::stoi(value) : otherwise;
}

/// A scene that is edited and moved about, and each pair of it for itself.
class BruteForce {
 public:
  explicit BruteForce(unsigned seed) : random_(seed) {
    shapes_ = {MeshCollider::build(test::boxMesh({0.2, 0.1, 0.1})), MeshCollider::build(test::sphereMesh(0.1, 6, 9)),
               MeshCollider::build(test::boxMesh({0.6, 0.03, 0.03})),
               MeshCollider::build(test::sheetMesh(0.3, 4, 0.05)), MeshCollider::build(test::boxMesh({0.5, 0.5, 0.5}))};
    crowd_ = 0.5 + 0.3 * (seed % 5);
    const std::size_t moved = 1 + seed % 4, standing = 3 + seed % 25;
    for (std::size_t i = 0; i < moved; ++i) moved_.push_back(newPart());
    for (std::size_t i = 0; i < standing; ++i) standing_.push_back(newPart());
    if (seed % 3 == 0) {
      scene_.addPairs(moved_, standing_, 3);
      if (seed % 2 == 0) scene_.addPairs(moved_, moved_, 4);
    } else {
      for (const PartIndex a : moved_) {
        for (const PartIndex b : standing_) scene_.addPair(a, b, b);
      }
      if (seed % 2 == 0) {
        for (std::size_t i = 1; i < moved_.size(); ++i) scene_.addPair(moved_[i - 1], moved_[i]);
      }
    }
  }

  /// Along a motion in small steps, to anywhere, or not at all; now and then something of the cell moves or is
  /// replaced.
  void step() {
    const auto kind = random_() % 8;
    for (const PartIndex part : moved_) {
      if (kind == 0) scene_.setPose(part, test::randomPose(random_, crowd_));
      if (kind > 1) scene_.setPose(part, near(scene_.pose(part), kind == 2 ? 0.05 : 0.003));
    }
    const PartIndex other = standing_[random_() % standing_.size()];
    if (random_() % 20 == 0) scene_.setPose(other, test::randomPose(random_, crowd_));
    if (random_() % 10 == 0) scene_.setPose(other, near(scene_.pose(other), 0.002));
    if (random_() % 200 == 0) replace();
    if (random_() % 100 == 0 && scene_.pairCount() > 0) {
      const auto pair = static_cast<PairIndex>(random_() % scene_.pairCount());
      scene_.setEnabled(pair, !scene_.isEnabled(pair));
    }
  }

  struct Exact {
    PartIndex a, b;
    double distance;
  };
  /// Of every enabled pair.
  std::vector<Exact> all() {
    std::vector<Exact> exact;
    std::vector<PartIndex> parts = moved_;
    parts.insert(parts.end(), standing_.begin(), standing_.end());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const PartIndex a = parts[i], b = parts[k];
        const auto pair = scene_.pairOf(a, b);
        if (!pair || !scene_.isEnabled(*pair)) continue;
        exact.push_back(
            {a, b,
             collision::distance(scene_.sharedCollider(a), scene_.pose(a), scene_.sharedCollider(b), scene_.pose(b))
                 .distance});
      }
    }
    std::sort(exact.begin(), exact.end(), [](const Exact& a, const Exact& b) { return a.distance < b.distance; });
    return exact;
  }

  void checkAnswers() {
    // What is asked first must not depend on what the others have found: in turn.
    const auto first = random_() % 3;
    std::optional<PairDistance> nearest, nearest_within;
    std::vector<PairDistance> within;
    bool collides = false;
    const double margin = 0.02 + 0.2 * static_cast<double>(random_() % 3);
    for (unsigned k = 0; k < 3; ++k) {
      if ((first + k) % 3 == 0) collides = scene_.collides();
      if ((first + k) % 3 == 1) nearest = scene_.nearest(), nearest_within = scene_.nearest(margin);
      if ((first + k) % 3 == 2) scene_.pairsWithin(margin, within);
    }
    const std::vector<Exact> exact = all();
    const double least = exact.empty() ? 1e9 : exact.front().distance;
    EXPECT_EQ(collides, least == 0.0);
    ASSERT_EQ(nearest.has_value(), !exact.empty());
    if (nearest) {
      EXPECT_NEAR(nearest->result.distance, least, 1e-9);
    }
    ASSERT_EQ(nearest_within.has_value(), least < margin);
    if (nearest_within) {
      EXPECT_NEAR(nearest_within->result.distance, least, 1e-9);
    }
    const auto expected = static_cast<std::size_t>(
        std::count_if(exact.begin(), exact.end(), [&](const Exact& one) { return one.distance < margin; }));
    ASSERT_EQ(within.size(), expected);
    for (std::size_t i = 0; i < within.size(); ++i) {
      EXPECT_NEAR(within[i].result.distance, exact[i].distance, 1e-9);
      EXPECT_TRUE(scene_.isEnabled(within[i].pair));
    }
  }

  /// The pairs stay apart on the way, and where it is stopped one of them is at its clearance.
  void checkMotion() {
    std::vector<MovedPart> motion;
    const Pose X_by = test::randomPose(random_, 0.4);
    for (const PartIndex part : moved_) {
      const Pose X_WEnd{scene_.pose(part).p + X_by.p, near(scene_.pose(part), 0.3).q};
      motion.push_back({part, straightMotion(scene_.pose(part), X_WEnd, scene_.collider(part))});
    }
    const std::vector<Exact> begin = all();
    constexpr double kClearance = 0.002;
    const SceneStop stop = scene_.advance(motion, kClearance);
    EXPECT_EQ(stop.began_colliding, !begin.empty() && begin.front().distance == 0.0);
    if (stop.began_colliding) return;
    const double kept = begin.empty() ? 0.0 : std::min(begin.front().distance, kClearance);
    for (int k = 0; k <= 8; ++k) {
      for (const MovedPart& part : motion) scene_.setPose(part.part, part.motion.at(stop.s * k / 8.0));
      const std::vector<Exact> now = all();
      if (!now.empty()) {
        EXPECT_GE(now.front().distance, k == 8 ? kept - 1e-9 : 0.5 * kept - 1e-9);
      }
    }
    if (!stop.stopped || stop.s == 0.0) return;
    for (const MovedPart& part : motion) scene_.setPose(part.part, part.motion.at(std::min(1.0, stop.s + 1e-4)));
    EXPECT_LT(scene_.distance(stop.pair).distance, kClearance + 1e-9) << "and no earlier than it must";
  }

 private:
  Pose near(const Pose& X, double step) {
    const Pose by = test::randomPose(random_, step);
    return {X.p + by.p, glm::normalize(quaternionFromRotationVector(by.p * 3.0) * X.q)};
  }
  PartIndex newPart() {
    return scene_.addPart({++made_, 0}, shapes_[random_() % shapes_.size()], test::randomPose(random_, crowd_));
  }
  void replace() {
    const std::size_t k = random_() % standing_.size();
    scene_.removePart(standing_[k]);
    standing_[k] = newPart();
    for (const PartIndex a : moved_) scene_.addPair(a, standing_[k]);
  }

  std::mt19937 random_;
  std::vector<std::shared_ptr<const MeshCollider>> shapes_;
  Scene scene_;
  std::vector<PartIndex> moved_, standing_;
  double crowd_ = 1.0;
  std::uint64_t made_ = 0;
};

TEST(SceneBruteForce, SaysWhatEachPairSaysForItself) {
  constexpr int kEach = 60;
  const int first = asked("HAPTICELL_SCENE_FIRST", 0);
  const int scenes = std::max(1, asked("HAPTICELL_SCENE_QUERIES", 3000) / kEach);
  for (int scene = first; scene < first + scenes; ++scene) {
    BruteForce cell(static_cast<unsigned>(scene));
    for (int i = 0; i < kEach && !testing::Test::HasFailure(); ++i) {
      cell.step();
      cell.checkAnswers();
      if (i % 10 == 9) cell.checkMotion();
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << "scene " << scene;
  }
}

}  // namespace
}  // namespace hapticell::collision
