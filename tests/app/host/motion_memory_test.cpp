// SPDX-License-Identifier: Apache-2.0
#include "app/host/motion_memory.h"

#include <gtest/gtest.h>

#include "app/host/document_model.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::app {
namespace {

/// A cell of boxes that are moved a tenth of a second at a time.
class MovingCell {
 public:
  MovingCell() : memory_(model_, [this] { return places(); }) {}
  workcell::EntityId add(const std::string& name, const Pose& X_WE = {}) {
    workcell::Entity box;
    box.name = name;
    box.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1)))};
    box.X_WE = X_WE;
    EXPECT_TRUE(model_.execute(workcell::AddEntity{box}));
    memory_.look(0.1);
    return model_.document().findByName(name)->id;
  }
  void place(workcell::EntityId id, double x, double seconds = 0.1) {
    Pose X_WE;
    X_WE.p.x = x;
    EXPECT_TRUE(model_.execute(workcell::SetPlacement{id, X_WE}));
    memory_.look(seconds);
  }
  double x(workcell::EntityId id) const { return model_.document().find(id)->X_WE.p.x; }
  DocumentModel& model() { return model_; }
  MotionMemory& memory() { return memory_; }

 private:
  MotionMemory::Places places() const {
    MotionMemory::Places all;
    for (const auto& entity : model_.document().state().entities) all[entity->id] = {entity->X_WE, entity->joints()};
    return all;
  }
  DocumentModel model_;
  MotionMemory memory_;
};

TEST(MotionMemory, GoesBackTenSecondsOfMotionAndAgainFromThere) {
  MovingCell cell;
  const auto box = cell.add("box");
  for (int i = 1; i <= 250; ++i) cell.place(box, 0.001 * i);  // 25 s
  EXPECT_TRUE(cell.memory().goBack(10.0));
  EXPECT_NEAR(cell.x(box), 0.150, 0.0011);
  EXPECT_TRUE(cell.memory().goBack(10.0));
  EXPECT_NEAR(cell.x(box), 0.050, 0.0021);
  EXPECT_TRUE(cell.memory().goBack(10.0)) << "as early as is known";
  EXPECT_NEAR(cell.x(box), 0.0, 1e-12);
  EXPECT_FALSE(cell.memory().goBack(10.0));
}

TEST(MotionMemory, IsOneStepOfUndo) {
  MovingCell cell;
  const auto first = cell.add("first"), second = cell.add("second");
  cell.place(first, 0.3);
  cell.place(second, 0.4);
  const QString text = "Go back 10 s";
  EXPECT_TRUE(cell.memory().goBack(10.0));
  EXPECT_EQ(cell.x(first), 0.0);
  EXPECT_EQ(cell.x(second), 0.0);
  EXPECT_EQ(QString::fromStdString(cell.model().document().undoText()), text);
  cell.model().undo();
  EXPECT_EQ(cell.x(first), 0.3);
  EXPECT_EQ(cell.x(second), 0.4);
}

TEST(MotionMemory, TimeInWhichNothingMovesDoesNotCount) {
  MovingCell cell;
  const auto box = cell.add("box");
  for (int i = 1; i <= 60; ++i) cell.place(box, 0.001 * i);  // 6 s
  for (int i = 0; i < 1000; ++i) cell.memory().look(0.1);
  cell.place(box, 1.0, 3600.0);  // After an hour.
  for (int i = 1; i <= 60; ++i) cell.place(box, 1.0 + 0.001 * i);
  EXPECT_TRUE(cell.memory().goBack(10.0));
  EXPECT_NEAR(cell.x(box), 0.022, 0.0021);
}

TEST(MotionMemory, KeepsAMinute) {
  MovingCell cell;
  const auto box = cell.add("box");
  for (int i = 1; i <= 900; ++i) cell.place(box, 0.001 * i);  // 90 s
  EXPECT_TRUE(cell.memory().goBack(1000.0));
  EXPECT_NEAR(cell.x(box), 0.300, 0.0021);
}

TEST(MotionMemory, WhatIsLockedOrGoneStays) {
  MovingCell cell;
  const auto kept = cell.add("kept"), gone = cell.add("gone"), free = cell.add("free");
  for (const auto id : {kept, gone, free}) cell.place(id, 0.5);
  workcell::SetProperties lock;
  lock.id = kept;
  lock.locked = true;
  EXPECT_TRUE(cell.model().execute(lock));
  EXPECT_TRUE(cell.model().execute(workcell::RemoveEntity{gone}));
  EXPECT_TRUE(cell.memory().goBack(10.0));
  EXPECT_EQ(cell.x(kept), 0.5);
  EXPECT_EQ(cell.x(free), 0.0);
}

TEST(MotionMemory, WhatHangsOnAnotherComesBackToItsOwnPlace) {
  MovingCell cell;
  Pose aside;
  aside.p.x = 0.2;
  const auto child = cell.add("child", aside), parent = cell.add("parent");  // The child is the earlier one.
  EXPECT_TRUE(cell.model().execute(workcell::Attach{child, parent, {}}));
  cell.memory().look(0.1);
  cell.place(parent, 0.7);
  EXPECT_NEAR(cell.x(child), 0.9, 1e-12);
  EXPECT_TRUE(cell.memory().goBack(10.0));
  EXPECT_NEAR(cell.x(parent), 0.0, 1e-12);
  EXPECT_NEAR(cell.x(child), 0.2, 1e-12);
}

TEST(MotionMemory, ForgetsAtAnotherDocument) {
  MovingCell cell;
  const auto box = cell.add("box");
  cell.place(box, 0.3);
  cell.memory().forget();
  EXPECT_FALSE(cell.memory().goBack(10.0));
  EXPECT_EQ(cell.x(box), 0.3);
}

}  // namespace
}  // namespace hapticell::app
