// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/part_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace hapticell::collision {
namespace {

using geometry::Bounds;

Bounds boxAt(const dvec3& p, const dvec3& half) {
  return {p - half, p + half};
}

/// Parts that come, go and move, beside a list of their boxes.
class PartTreeTest : public testing::Test {
 protected:
  dvec3 anywhere(double reach) {
    std::uniform_real_distribution<double> unit(-reach, reach);
    return {unit(random_), unit(random_), unit(random_)};
  }
  void place(std::uint32_t part, const Bounds& box) {
    tree_.place(part, box);
    boxes_[part] = box;
  }
  void remove(std::uint32_t part) {
    tree_.remove(part);
    boxes_.erase(part);
  }
  /// All that come so near, and how many the tree names.
  void expectFound(const Bounds& box, double margin) {
    std::multiset<std::uint32_t> found;
    tree_.visitNear(box, margin, [&](std::uint32_t part) { found.insert(part); });
    for (const auto& [part, other] : boxes_) {
      const dvec3 gap = glm::max(box.min - other.max, other.min - box.max);
      const double largest = std::max({gap.x, gap.y, gap.z});
      if (largest <= margin) {
        EXPECT_EQ(found.count(part), 1u) << part;
      }
      // The tree's boxes are larger by a share of their size only.
      if (largest > margin + 0.2 * other.radius() + 1e-6) {
        EXPECT_EQ(found.count(part), 0u) << part;
      }
    }
    for (const std::uint32_t part : found) EXPECT_EQ(boxes_.count(part), 1u) << "it is not there";
  }

  std::mt19937 random_{5};
  PartTree tree_;
  std::map<std::uint32_t, Bounds> boxes_;
};

TEST_F(PartTreeTest, FindsWhatIsNearWhilePartsComeGoAndMove) {
  for (int step = 0; step < 6000; ++step) {
    const auto part = static_cast<std::uint32_t>(random_() % 400);
    const bool there = boxes_.count(part) != 0;
    if (there && random_() % 4 == 0) {
      remove(part);
    } else if (there && random_() % 2 == 0) {
      const Bounds& box = boxes_[part];
      const dvec3 by = anywhere(0.01);
      place(part, {box.min + by, box.max + by});
    } else {
      place(part, boxAt(anywhere(5.0), glm::abs(anywhere(0.3)) + 1e-3));
    }
    EXPECT_EQ(tree_.size(), boxes_.size());
    EXPECT_EQ(tree_.contains(part), boxes_.count(part) != 0);
    if (step % 10 == 0) expectFound(boxAt(anywhere(5.0), glm::abs(anywhere(0.5))), step % 20 == 0 ? 0.0 : 0.2);
  }
  while (!boxes_.empty()) remove(boxes_.begin()->first);
  EXPECT_EQ(tree_.size(), 0u);
  EXPECT_TRUE(tree_.bounds().isEmpty());
  expectFound(boxAt({0, 0, 0}, dvec3(100.0)), 0.0);
}

TEST_F(PartTreeTest, ItsBoundsHoldEverything) {
  for (std::uint32_t part = 0; part < 100; ++part) place(part, boxAt(anywhere(3.0), dvec3(0.1)));
  const Bounds all = tree_.bounds();
  for (const auto& [part, box] : boxes_) {
    EXPECT_TRUE(glm::all(glm::lessThanEqual(all.min, box.min)) && glm::all(glm::greaterThanEqual(all.max, box.max)));
  }
  EXPECT_LT(all.radius(), 7.0);
}

TEST_F(PartTreeTest, PartsInOnePlaceAndFarFromTheOriginAreFound) {
  for (std::uint32_t part = 0; part < 60; ++part) place(part, boxAt({1e5, -2e5, 3e4}, dvec3(0.01)));
  expectFound(boxAt({1e5, -2e5, 3e4}, dvec3(0.001)), 0.0);
  for (std::uint32_t part = 0; part < 60; part += 2) remove(part);
  expectFound(boxAt({1e5, -2e5, 3e4}, dvec3(0.001)), 0.0);
}

TEST_F(PartTreeTest, AllInstructionSetsNameTheSameBoxes) {
  PartBoxes boxes{};
  for (int round = 0; round < 200; ++round) {
    QueryBounds query{};
    const dvec3 at = anywhere(1.0);
    for (int k = 0; k < 3; ++k) {
      query.min[k] = static_cast<float>(at[k]) - 0.5F;
      query.max[k] = static_cast<float>(at[k]) + 0.5F;
      for (int lane = 0; lane < kPartLanes; ++lane) {
        boxes.min[k][lane] = static_cast<float>(anywhere(1.5).x);
        boxes.max[k][lane] = boxes.min[k][lane] + 0.4F;
      }
    }
    std::uint32_t expected = 0;
    for (int lane = 0; lane < kPartLanes; ++lane) {
      bool near = true;
      for (int k = 0; k < 3; ++k) {
        near = near && boxes.min[k][lane] <= query.max[k] && boxes.max[k][lane] >= query.min[k];
      }
      expected |= (near ? 1u : 0u) << lane;
    }
    for (const char* name : {"portable", "avx2", "avx512"}) {
      const ProximityKernels* kernels = proximityKernels(name);
      if (kernels != nullptr) {
        EXPECT_EQ(kernels->nearBoxes(boxes, query), expected) << name;
      }
    }
  }
}

}  // namespace
}  // namespace hapticell::collision
