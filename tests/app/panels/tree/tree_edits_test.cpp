// SPDX-License-Identifier: Apache-2.0
// The tree of a cell and what it does with entities, without a display.
#include "app/panels/tree/tree_edits.h"

#include <gtest/gtest.h>

#include <QMimeData>
#include <memory>

#include "app/panels/tree/workcell_tree_model.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::app {
namespace {

using workcell::Entity;
using workcell::EntityKind;

/// An assembly "rig" of "arm" and the assembly "foot" of "pad", and a "box" beside it.
class TreeEdits : public ::testing::Test {
 protected:
  TreeEdits() {
    std::vector<Entity> entities{make("rig", "", false), make("arm", "rig", true), make("foot", "rig", false),
                                 make("pad", "foot", true), make("box", "", true)};
    EXPECT_TRUE(document_.addImported(std::move(entities)));
  }
  static Entity make(const char* name, const char* parent, bool solid) {
    Entity entity;
    entity.name = name;
    entity.parent = parent;
    entity.body = workcell::Assembly{};
    if (solid)
      entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({0.1, 0.1, 0.1}))};
    return entity;
  }
  const Entity& get(const char* name) { return *document_.document().findByName(name); }
  QString shown() {
    QString names;
    for (const auto& entity : document_.document().state().entities)
      if (entity->visible && entity->mesh()) names += QString::fromStdString(entity->name) + ' ';
    return names;
  }
  std::size_t steps() const { return document_.document().undoTexts().size(); }

  DocumentModel document_;
};

TEST_F(TreeEdits, TheTreeHasTheDepthOfTheAssembly) {
  const WorkcellTreeModel tree(document_);
  const QModelIndex cell = tree.index(0, 0, {});
  EXPECT_EQ(tree.rowCount(cell), 2);
  const QModelIndex pad = tree.indexOf(get("pad").id);
  EXPECT_EQ(pad.parent().data().toString(), "foot");
  EXPECT_EQ(pad.parent().parent().data().toString(), "rig");
  EXPECT_EQ(pad.parent().parent().parent(), cell);
  EXPECT_EQ(tree.entitiesOf(tree.indexOf(get("rig").id)).size(), 4u);
}

TEST_F(TreeEdits, WhatIsAttachedIsShownUnderWhatItIsAttachedTo) {
  const WorkcellTreeModel tree(document_);
  ASSERT_TRUE(document_.execute(workcell::Attach{get("arm").id, get("box").id, ""}));
  const QModelIndex arm = tree.indexOf(get("arm").id);
  EXPECT_EQ(arm.parent(), tree.indexOf(get("box").id));
  EXPECT_EQ(arm.data(Qt::ToolTipRole).toString(), "Attached to box");
  EXPECT_EQ(tree.entitiesOf(arm.parent()), Entities{get("box").id}) << "hiding the box leaves what hangs on it";
  EXPECT_EQ(tree.entitiesOf(tree.indexOf(get("rig").id)).size(), 4u);
  EXPECT_EQ(tree.entitiesOf(tree.index(0, 0, {})).size(), 5u);
  document_.undo();
  EXPECT_EQ(tree.indexOf(get("arm").id).parent(), tree.indexOf(get("rig").id));
}

TEST_F(TreeEdits, DroppingARowPutsItBelowAndKeepsItsPlace) {
  WorkcellTreeModel tree(document_);
  const Pose before = get("box").X_WE;
  const std::unique_ptr<QMimeData> data(tree.mimeData({tree.indexOf(get("box").id)}));
  tree.dropMimeData(data.get(), Qt::MoveAction, -1, -1, tree.indexOf(get("foot").id));
  EXPECT_EQ(get("box").parent, "foot");
  EXPECT_EQ(get("box").X_WE.p, before.p);
  const std::unique_ptr<QMimeData> rig(tree.mimeData({tree.indexOf(get("rig").id)}));
  tree.dropMimeData(rig.get(), Qt::MoveAction, -1, -1, tree.indexOf(get("pad").id));
  EXPECT_EQ(get("rig").parent, "") << "nothing goes below itself";
  document_.undo();
  EXPECT_EQ(get("box").parent, "");
}

TEST_F(TreeEdits, IsolateShowsOneFamilyAndShowAllBringsTheRestBack) {
  ASSERT_TRUE(isolateEntities(document_, {get("foot").id}));
  EXPECT_EQ(shown(), "pad ");
  EXPECT_TRUE(get("rig").visible) << "what it stands below has its eye open";
  EXPECT_EQ(steps(), 2u);
  ASSERT_TRUE(showAll(document_));
  EXPECT_EQ(shown(), "arm pad box ");
  EXPECT_FALSE(showAll(document_)) << "nothing to do is no step";
  document_.undo();
  document_.undo();
  EXPECT_EQ(shown(), "arm pad box ");
}

TEST_F(TreeEdits, FlagsGoDownTheTreeInOneStep) {
  ASSERT_TRUE(showEntities(document_, {get("rig").id, get("arm").id}, false));
  EXPECT_EQ(shown(), "box ");
  ASSERT_TRUE(lockEntities(document_, {get("rig").id}, true));
  EXPECT_TRUE(get("pad").locked);
  ASSERT_TRUE(checkEntities(document_, {get("rig").id}, false));
  EXPECT_FALSE(get("arm").checked);
  ASSERT_TRUE(colorEntities(document_, {get("rig").id}, {0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(get("pad").color, (std::array<float, 3>{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(steps(), 5u);
  for (int k = 0; k < 4; ++k) document_.undo();
  EXPECT_EQ(shown(), "arm pad box ");
  EXPECT_FALSE(get("pad").locked);
}

TEST_F(TreeEdits, ACopyStandsBesideWithNamesOfItsOwn) {
  const Entities copies = duplicateEntities(document_, {get("rig").id});
  ASSERT_EQ(copies.size(), 4u);
  EXPECT_EQ(document_.document().find(copies.front())->name, "rig 2");
  EXPECT_EQ(get("pad 2").parent, "foot 2");
  EXPECT_EQ(get("pad 2").mesh(), get("pad").mesh()) << "meshes are shared";
  EXPECT_GT(get("pad 2").X_WE.p.x, get("pad").X_WE.p.x + 0.1);
  EXPECT_EQ(steps(), 2u);
  document_.undo();
  EXPECT_EQ(document_.document().state().entities.size(), 5u);
}

TEST_F(TreeEdits, RemovingTakesAllBelowAndALockedPartPreventsIt) {
  ASSERT_TRUE(lockEntities(document_, {get("pad").id}, true));
  EXPECT_FALSE(removeEntities(document_, {get("box").id, get("rig").id}));
  EXPECT_EQ(document_.document().state().entities.size(), 5u) << "all or nothing";
  ASSERT_TRUE(lockEntities(document_, {get("pad").id}, false));
  ASSERT_TRUE(removeEntities(document_, {get("rig").id, get("pad").id}));
  EXPECT_EQ(document_.document().state().entities.size(), 1u);
  document_.undo();
  EXPECT_EQ(document_.document().state().entities.size(), 5u);
}

}  // namespace
}  // namespace hapticell::app
