// SPDX-License-Identifier: Apache-2.0
// What a document's state is read with, each part by itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/workcell/document/every_command.h"
#include "workcell/document/perform_command.h"
#include "workcell/format/document_format.h"
#include "workcell/format/entity_format.h"
#include "workcell/format/known_shapes.h"
#include "workcell/format/name_levels.h"
#include "workcell/format/pair_format.h"
#include "workcell/format/pending_attachments.h"
#include "workcell/format/state_reader.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

DocumentState stateOf(const std::vector<std::string>& names) {
  DocumentState state;
  for (const std::string& name : names) {
    auto entity = std::make_shared<Entity>(test::makeSolid(name, 0.5));
    entity->id = state.entities.size() + 1;
    state.entities.push_back(std::move(entity));
  }
  return state;
}

Attachment hangingOn(const std::string& carrier, const dvec3& p = dvec3(0.0)) {
  Attachment attachment;
  attachment.to = carrier;
  attachment.X_LE = Pose::translation(p);
  return attachment;
}

PendingAttachments::Index indexOf(const DocumentState& state) {
  PendingAttachments::Index index;
  for (std::size_t k = 0; k < state.entities.size(); ++k) index.emplace(state.entities[k]->name, k);
  return index;
}

TEST(NameLevels, FindsCirclesAndWhatIsTooDeep) {
  EXPECT_TRUE(levelsOf({}, 1).in_circle.empty());
  const Levels plain = levelsOf({{"a", "b"}, {"b", "c"}, {"d", "c"}}, 2);
  EXPECT_TRUE(plain.in_circle.empty());
  EXPECT_EQ(plain.too_deep, "");
  EXPECT_EQ(levelsOf({{"a", "b"}, {"b", "c"}, {"c", "d"}}, 2).too_deep, "a");
  const Levels circles = levelsOf({{"a", "b"}, {"b", "a"}, {"c", "c"}, {"d", "a"}}, 9);
  EXPECT_THAT(circles.in_circle, SizeIs(2)) << "one name of each circle";
  EXPECT_TRUE(circles.in_circle.contains("c"));
}

TEST(PairFormat, WhatIsWrittenIsReadAgain) {
  PairSet set;
  set.name = "gripper";
  set.enabled = false;
  set.first = {"a"};
  set.second = {"b", "c"};
  set.safety_distance = 0.002;
  set.on_contact = OnContact::kSlide;
  set.contact_color = {0.25f, 0.5f, 1.0f};
  std::optional<Error> error;
  Diagnostics notes;
  const Json json = jsonFromPairSet(set);
  EXPECT_EQ(jsonFromPairSet(pairSetFromJson(json, 0, error, notes)), json);
  PairRule rule;
  rule.first = "a";
  rule.second = "b";
  rule.second_part = "link_4";
  rule.checked = false;
  rule.on_contact = OnContact::kPass;
  const Json of_rule = jsonFromPairRule(rule);
  EXPECT_EQ(jsonFromPairRule(pairRuleFromJson(of_rule, 0, error, notes)), of_rule);
  EXPECT_FALSE(error.has_value());
  EXPECT_THAT(notes.warnings, IsEmpty());

  pairSetFromJson(Json::parse(R"({"name": "s", "on_contact": "jump"})"), 2, error, notes);
  ASSERT_TRUE(error.has_value());
  EXPECT_THAT(error->message(), HasSubstr("pair set 3"));
}

TEST(KnownShapes, AreThoseOfTheSameTextOrTheSameSource) {
  DocumentState state = stateOf({"box"});
  const Entity& box = *state.entities.front();
  const KnownShapes known(&state, "/cell");
  Json json = jsonFromEntity(box, "/cell");
  EXPECT_EQ(known.same(json), &box);
  json["visible"] = false;
  EXPECT_EQ(known.same(json), nullptr);
  const auto fresh = known.withSameShape(json);
  ASSERT_TRUE(fresh.has_value());
  EXPECT_EQ(fresh->mesh(), box.mesh());
  EXPECT_EQ(fresh->name, "") << "the rest is in the text";
  json["source"]["path"] = "another.stl";
  EXPECT_FALSE(known.withSameShape(json).has_value());
  EXPECT_FALSE(KnownShapes(nullptr, "/cell").withSameShape(json).has_value());
}

TEST(PendingAttachments, ACarrierMayComeLaterAndHoldsWhatHangsOnIt) {
  DocumentState state = stateOf({"finger", "hand", "arm"});
  auto arm = std::make_shared<Entity>(*state.entities[2]);
  arm->X_WE = Pose::translation({0.0, 0.0, 1.0});
  state.entities[2] = arm;
  PendingAttachments pending;
  pending.add(0, hangingOn("hand", {0.1, 0.0, 0.0}), true);
  pending.add(1, hangingOn("arm", {0.0, 0.2, 0.0}), true);
  Diagnostics notes;
  ASSERT_TRUE(pending.attachAll(state, indexOf(state), notes).has_value());
  EXPECT_LT(glm::length(state.entities[0]->X_WE.p - dvec3(0.1, 0.2, 1.0)), 1e-12);
  EXPECT_THAT(notes.warnings, SizeIs(2)) << "both were written at another place";

  DocumentState other = stateOf({"part", "table"});
  PendingAttachments unplaced;
  unplaced.add(0, hangingOn("table"), false);
  Diagnostics quiet;
  ASSERT_TRUE(unplaced.attachAll(other, indexOf(other), quiet).has_value());
  EXPECT_THAT(quiet.warnings, IsEmpty());
  EXPECT_EQ(other.entities[0]->attachment.to, "table");
}

TEST(PendingAttachments, RefusesCirclesStrangersAndLongChains) {
  const auto problem = [](std::size_t count, const std::vector<std::pair<std::size_t, std::string>>& hangs) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < count; ++k) names.push_back("e" + std::to_string(k));
    DocumentState state = stateOf(names);
    PendingAttachments pending;
    for (const auto& [index, to] : hangs) pending.add(index, hangingOn(to), false);
    Diagnostics notes;
    const auto attached = pending.attachAll(state, indexOf(state), notes);
    return attached ? std::string() : attached.error().message();
  };
  EXPECT_EQ(problem(2, {{0, "e1"}}), "");
  EXPECT_THAT(problem(2, {{0, "e1"}, {1, "e0"}}), HasSubstr("attached to itself"));
  EXPECT_THAT(problem(1, {{0, "nobody"}}), HasSubstr("does not exist"));
  std::vector<std::pair<std::size_t, std::string>> chain;
  for (std::size_t k = 0; k < 250; ++k) chain.emplace_back(k, "e" + std::to_string(k + 1));
  EXPECT_THAT(problem(251, chain), HasSubstr("chain"));
}

TEST(StateReader, ReadsWhatTheStateWrites) {
  DocumentState state = stateOf({"box"});
  auto box = std::make_shared<Entity>(*state.entities.front());
  box->locked = true;
  state.entities.front() = box;
  state.view = SavedView{{1.0, 2.0, 3.0}, {0.0, 0.0, 0.5}};
  PairSet set;
  set.name = "all";
  set.first = {"box", "nobody"};
  state.pair_sets.push_back(set);
  const Json json = jsonFromState(state, "/cell");
  Diagnostics notes;
  LoadOptions options;
  options.known = &state;
  const std::filesystem::path folder("/cell");
  const auto read = StateReader(folder, notes, options).read(json);
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(jsonFromState(*read, folder), json);
  ASSERT_THAT(notes.warnings, SizeIs(1));
  EXPECT_THAT(english(notes.warnings.front()), HasSubstr("'nobody'"));

  Json newer = json;
  newer["version"] = kDocumentVersion + 1;
  const auto refused = StateReader(folder, notes, options).read(newer);
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message(), HasSubstr("newer HaptiCell"));
}

}  // namespace
}  // namespace hapticell::workcell
