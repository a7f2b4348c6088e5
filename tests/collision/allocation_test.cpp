// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "collision/scene.h"
#include "tests/collision/meshes.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Replaced for the whole program, so that the tests below see every allocation.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace hapticell::collision {
namespace {

TEST(Allocation, warmQueriesDoNotAllocate) {
  std::mt19937 random(9);
  const auto ball = MeshCollider::build(test::sphereMesh(0.1)),
             box = MeshCollider::build(test::boxMesh({0.5, 0.5, 0.1}));
  ProximityQuery query(ball, box);
  Scene scene;
  const PartIndex moved = scene.addPart({1, 0}, ball), fixed = scene.addPart({2, 0}, box);
  scene.addPair(moved, fixed);
  std::vector<PairDistance> found;
  found.reserve(16);
  const auto once = [&] {
    const Pose X_WM = test::randomPose(random, 0.5), X_WNext = test::randomPose(random, 0.5);
    query.distance(X_WM, {});
    query.within(X_WM, {}, 0.01);
    query.collides(X_WM, {});
    advance(query, straightMotion(X_WM, X_WNext, *ball), standingStill({}), {0.001});
    scene.setPose(moved, X_WM);
    scene.nearest();
    found.clear();
    scene.pairsWithin(1.0, found);
    const MovedPart motion[] = {{moved, straightMotion(X_WM, X_WNext, *ball)}};
    scene.advance(motion, 0.001);
  };
  for (int i = 0; i < 100; ++i) once();  // The lists of near pairs get their memory when parts first come near.
  const long before = allocations;
  EXPECT_GT(before, 0) << "the counter counts";
  for (int i = 0; i < 200; ++i) once();
  EXPECT_EQ(allocations - before, 0);
}

}  // namespace
}  // namespace hapticell::collision
