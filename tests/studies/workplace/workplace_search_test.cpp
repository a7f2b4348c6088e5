// SPDX-License-Identifier: Apache-2.0
#include "studies/workplace/workplace_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "manipulation/scene/scene_service.h"
#include "studies/runner/study.h"
#include "studies/workplace/workplace_check.h"
#include "tests/manipulation/manipulators/worker.h"
#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"

namespace hapticell::studies {
namespace {

using manipulation::test::box;
using manipulation::test::worker;

/// What the search answered before it was a study (its own loops, its own contact check): commit 87e19a01.
struct KeptSearch {
  const char* cell;
  std::vector<const char*> station;
  double rise, away_from, away_step;  ///< m; one height, three distances.
  bool may_sit;
  struct Place {
    std::array<int, 4> rula;
    const char* why;
  };
  std::vector<Place> places;  ///< By stance, then distance.
};

const std::vector<KeptSearch>& keptSearches() {
  static const std::vector<KeptSearch> kept{
      {"config/workcells/workbench.hcell",
       {"bench top", "housing", "cover"},
       -0.3,
       -0.2,
       0.2,
       true,
       {{{3, 0, 0, 0}, "P50F would touch bench top"},
        {{3, 3, 4, 4}, ""},
        {{4, 5, 5, 5}, ""},
        {{0, 0, 0, 0}, "P5F would touch bench top"},
        {{3, 0, 0, 0}, "P50F would touch bench top"},
        {{3, 3, 2, 3}, ""}}},
      {"config/studies/assembly-table.hcell",
       {"table"},
       0.0,
       -0.1,
       0.1,
       false,
       {{{3, 3, 3, 4}, ""}, {{3, 3, 2, 3}, ""}, {{3, 3, 3, 3}, ""}}},
      {"config/access/gearbox.hcell",
       {"bench"},
       -0.2,
       -0.1,
       0.1,
       true,
       {{{3, 3, 0, 0}, "P50M would touch bench"},
        {{3, 3, 3, 3}, ""},
        {{3, 3, 3, 3}, ""},
        {{0, 0, 0, 0}, "P5F would touch bench"},
        {{0, 0, 0, 0}, "P5F is 0 mm short"},
        {{0, 0, 0, 0}, "P5F is 0 mm short"}}}};
  return kept;
}

WorkplaceQuestion questionOf(const KeptSearch& kept, const workcell::Document& document) {
  WorkplaceQuestion question;
  question.entities = document.snapshotEntities();
  for (const workcell::Entity& entity : question.entities)
    if (entity.figure()) question.mannequin = entity.id;
  for (const char* name : kept.station) question.station.push_back(document.findByName(name)->id);
  question.rise_from = question.rise_to = kept.rise;
  question.away_from = kept.away_from;
  question.away_to = kept.away_from + 2.0 * kept.away_step;
  question.away_step = kept.away_step;
  question.may_sit = kept.may_sit;
  return question;
}

TEST(WorkplaceSearch, AnswersAsBeforeItWasAStudy) {
  // Equal without tolerance: the scores are whole numbers and the words are the same.
  const std::atomic<bool> cancel{false};
  // The first cell takes as long as the others together: three of its places are tried in the next test.
  for (const KeptSearch& kept : std::span(keptSearches()).subspan(1)) {
    Diagnostics notes;
    const auto document = workcell::loadDocument(test::sourceFile(kept.cell), notes);
    ASSERT_TRUE(document) << document.error().message();
    manipulation::SceneService scenes;
    const WorkplaceQuestion question = questionOf(kept, *document);
    const auto map = searchWorkplace(question, scenes, {}, cancel);
    ASSERT_TRUE(map) << map.error().message();
    ASSERT_EQ(map->cells.size(), kept.places.size()) << kept.cell;
    for (std::size_t i = 0; i < kept.places.size(); ++i) {
      EXPECT_EQ(map->cells[i].rula, kept.places[i].rula) << kept.cell << " " << i;
      EXPECT_EQ(map->cells[i].why, kept.places[i].why) << kept.cell << " " << i;
    }
    if (map->best < 0) continue;
    const WorkplaceCell& best = map->cells[static_cast<std::size_t>(map->best)];
    EXPECT_TRUE(workplacePromises(question, best, movedCell(question, best), scenes).areKept()) << kept.cell;
  }
}

TEST(WorkplaceSearch, ItsStudyIsReadFromAFileAndGivesTheSameScores) {
  const KeptSearch& kept = keptSearches().front();
  Diagnostics notes;
  const auto cell = test::sourceFile(kept.cell);
  const auto document = workcell::loadDocument(cell, notes);
  ASSERT_TRUE(document);
  const auto text = workplaceStudy(questionOf(kept, *document), cell.string());
  ASSERT_TRUE(text) << text.error().message();
  const test::TemporaryFolder folder;
  const auto study = Study::load(folder.write("place.hstudy", *text), "test");
  ASSERT_TRUE(study) << study.error().message();
  ASSERT_EQ((*study)->space().count(), kept.places.size());
  EXPECT_EQ((*study)->space().values(5)[0], Value(std::string("seated")));
  const auto named = [&](const ResultRow& row, const std::string& name) {
    for (std::size_t i = 0; i < row.answers.size(); ++i)
      if ((*study)->head().answers[i].name == name) return row.answers[i];
    ADD_FAILURE() << name;
    return Answer();
  };
  for (const std::size_t number : {std::size_t{1}, std::size_t{5}}) {  // Standing, seated.
    const ResultRow row = (*study)->evaluate(static_cast<std::int64_t>(number), (*study)->space().values(number));
    EXPECT_TRUE(row.feasible) << row.note;
    const auto& rula = kept.places[number].rula;
    EXPECT_EQ(named(row, "posture.rula"), Answer(double(*std::max_element(rula.begin(), rula.end()))));
    EXPECT_EQ(named(row, "posture.rula_male_95"), Answer(double(rula[3])));
    EXPECT_EQ(named(row, "posture.reached_female_5"), Answer(std::int64_t{1}));
  }
  const ResultRow touching = (*study)->evaluate(0, (*study)->space().values(0));
  EXPECT_FALSE(touching.feasible);
  EXPECT_EQ(named(touching, "posture.touched_female_50"), Answer(std::string("bench top")));
  const auto sits = (*study)->cellOf((*study)->space().values(5));
  ASSERT_TRUE(sits);
  EXPECT_NE(sits->findByName("operator")->joints(), document->findByName("operator")->joints()) << "opened, it sits";
}

TEST(WorkplaceSearch, StancesAndBodiesThatCannotBeAreRefused) {
  const test::TemporaryFolder folder;
  const std::string cell = "cell = \"" + test::sourceFile("config/studies/assembly-table.hcell").string() + "\"\n",
                    ask = "[[ask]]\nwhat = \"posture\"\nentity = \"worker\"\nframe = \"table\"\n",
                    vary = "[[vary]]\nwhat = \"stance\"\n";
  const auto refused = [&](const std::string& text) {
    const auto study = Study::load(cell + text, folder.path() / "s.hstudy", "test");
    return study ? std::string() : study.error().message();
  };
  EXPECT_NE(refused(vary + "entity = \"worker\"\nvalues = [\"flying\"]\n" + ask).find("flying"), std::string::npos);
  EXPECT_NE(refused(vary + "entity = \"table\"\nvalues = [\"seated\"]\n" + ask).find("mannequin"), std::string::npos);
  const std::string good = vary + "entity = \"worker\"\nvalues = [\"seated\"]\n" + ask;
  EXPECT_NE(refused(good + "each_body = true\n").find("each body"), std::string::npos);
  EXPECT_NE(refused(good + "bodies = [\"male:50\"]\npostures = true\n").find("postures"), std::string::npos);
}

TEST(WorkplaceSearch, MovesTheChosenPartsWithWhatIsAttachedAndNothingElse) {
  WorkplaceQuestion question;
  workcell::Entity vise = box(9, "vise", {0.1, 0.1, 0.1}, {0.8, 0.0, 0.66}),
                   jaw = box(10, "jaw", {0.02, 0.1, 0.02}, {});
  vise.attachment.to = "table";
  jaw.attachment.to = "vise";
  question.entities = {jaw, worker("both_hands_forward"), vise, box(8, "table", {0.5, 0.8, 0.04}, {0.80, 0.0, 0.60}),
                       box(11, "shelf", {0.5, 0.1, 0.04}, {1.20, 0.0, 0.60})};
  question.mannequin = 7;
  question.station = {8};
  EXPECT_EQ(movedWith(question), (std::vector<workcell::EntityId>{10, 9, 8}));
  question.station = {9};
  EXPECT_EQ(movedWith(question), (std::vector<workcell::EntityId>{10, 9}));
  question.entities.back().parent = "jaw";
  EXPECT_EQ(movedWith(question), (std::vector<workcell::EntityId>{10, 9, 11})) << "and what is below it in the tree";
  question.station = {7};
  manipulation::SceneService scenes;
  const std::atomic<bool> cancel{false};
  EXPECT_FALSE(searchWorkplace(question, scenes, {}, cancel)) << "the mannequin does not move itself";
}

/// A worker at a table, which may stand at four places: two heights, two distances.
WorkplaceQuestion fourPlaces() {
  WorkplaceQuestion question;
  question.entities = {worker("both_hands_forward"), box(8, "table", {0.5, 0.8, 0.04}, {0.80, 0.0, 0.60})};
  question.mannequin = 7;
  question.station = {8};
  question.rise_from = question.away_from = -0.1;
  question.rise_to = question.away_to = 0.1;
  question.rise_step = question.away_step = 0.2;
  return question;
}

/// The search of fourPlaces() takes seconds: two tests look at the same answer. `told`: how often it told of its progress.
struct FourPlaces {
  manipulation::SceneService scenes;
  std::atomic<int> told{0};
  Expected<WorkplaceMap> map;
  FourPlaces() : map(searched()) {}
  Expected<WorkplaceMap> searched() {
    const std::atomic<bool> cancel{false};
    return searchWorkplace(
        fourPlaces(), scenes, [this](double) { ++told; }, cancel);
  }
  static FourPlaces& once() {
    static FourPlaces all;
    return all;
  }
};

TEST(WorkplaceSearch, FindsAPlaceRefusesNonsenseAndCanBeCancelled) {
  WorkplaceQuestion question = fourPlaces();
  manipulation::SceneService& scenes = FourPlaces::once().scenes;
  std::atomic<bool> cancel{false};
  const auto& map = FourPlaces::once().map;
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_EQ(map->cells.size(), 4u);
  EXPECT_EQ(FourPlaces::once().told, 4);
  EXPECT_TRUE(map->is_complete);
  ASSERT_GE(map->best, 0);
  const WorkplaceCell& best = map->cells[static_cast<std::size_t>(map->best)];
  for (const WorkplaceCell& cell : map->cells) {
    if (cell.worst > 0) {
      EXPECT_LE(best.worst, cell.worst);
    } else {
      EXPECT_FALSE(cell.why.empty());
    }
  }
  const auto again = searchWorkplace(question, scenes, {}, cancel);
  EXPECT_EQ(again->best, map->best) << "whatever thread took which cell";
  cancel = true;
  EXPECT_FALSE(searchWorkplace(question, scenes, {}, cancel)->is_complete);
  cancel = false;
  question.station = {99};
  EXPECT_FALSE(searchWorkplace(question, scenes, {}, cancel));
  question.station = {8};
  question.rise_step = 0.0;
  EXPECT_FALSE(searchWorkplace(question, scenes, {}, cancel));
}

TEST(WorkplaceSearch, WhatItPromisesIsMeasuredOnThePostures) {
  const WorkplaceQuestion question = fourPlaces();
  manipulation::SceneService& scenes = FourPlaces::once().scenes;
  const auto& map = FourPlaces::once().map;
  ASSERT_TRUE(map && map->best >= 0);
  for (const WorkplaceCell& cell : map->cells) {
    EXPECT_EQ(cell.postures.size(), cell.worst > 0 ? 4u : 0u);
    if (cell.worst == 0) continue;
    const Promises kept = workplacePromises(question, cell, movedCell(question, cell), scenes);
    EXPECT_TRUE(kept.areKept()) << kept.missed("").message();
    EXPECT_EQ(kept.list.size(), 16u);
  }
  const WorkplaceCell& best = map->cells[static_cast<std::size_t>(map->best)];
  const auto worstOf = [&](const WorkplaceCell& place, const std::vector<workcell::Entity>& after) {
    const Promises promises = workplacePromises(question, place, after, scenes);
    return promises.areKept() ? std::string() : promises.worst()->name + ' ' + english(promises.worst()->place);
  };
  const auto after = movedCell(question, best);
  WorkplaceCell place = best;
  place.rula[2] -= 1;
  EXPECT_EQ(worstOf(place, after), "rula_P50M P50M");
  place = best, place.rise += 0.01;
  EXPECT_NE(worstOf(place, after).find("hands_"), std::string::npos);
  place = best, place.postures[3].X_WR.p.x -= 0.01;
  EXPECT_EQ(worstOf(place, after), "hands_P95M P95M");
  place = best, place.postures.pop_back();
  EXPECT_EQ(worstOf(place, after), "bodies ");
  auto blocked = after;  // A post where the trunk is.
  blocked.push_back(box(12, "post", {0.1, 0.1, 2.0}, {best.postures[0].X_WR.p.x, best.postures[0].X_WR.p.y, 1.0}));
  EXPECT_NE(worstOf(best, blocked).find(" in post"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::studies
