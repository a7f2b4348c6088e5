// SPDX-License-Identifier: Apache-2.0
#include "studies/store/result_store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "studies/store/result_merge.h"
#include "studies/store/result_ranking.h"

namespace hapticell::studies {
namespace {

namespace fs = std::filesystem;

class ResultStoreTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("result_store_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static ResultHead head() {
    ResultHead head{"Name", "cell = 'x'", "/a/s.hstudy", "d1", "1.0 abc", 3, 100, 100, 1, {}, {}};
    head.values = {{"x", Column::Kind::kNumber, "m"}, {"who", Column::Kind::kText, ""}};
    head.answers = {{"q.a", Column::Kind::kNumber, "s"}, {"q.n", Column::Kind::kWhole, ""},
                    {"q.t", Column::Kind::kText, ""}};
    return head;
  }

  static ResultRow row(std::int64_t number) {
    std::mt19937_64 random(static_cast<unsigned>(number));
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    ResultRow row;
    row.number = number;
    row.values = {value(random) / 3.0, std::string("it's \"a\"; ü")};
    row.answers = {value(random), std::int64_t{-7} + number, Answer()};
    row.feasible = number % 2 == 0;
    row.violation = row.feasible ? 0.0 : 0.1;
    row.objective = value(random);
    row.note = number % 3 == 0 ? "" : "why";
    return row;
  }

  ResultStore filled(const std::string& name, std::int64_t begin, std::int64_t end) {
    auto store = ResultStore::create(folder_ / name, head());
    EXPECT_TRUE(store) << store.error().message();
    std::vector<ResultRow> rows;
    std::vector<std::int64_t> units;
    for (std::int64_t i = begin; i < end; ++i) {
      rows.push_back(row(i));
      units.push_back(i);
    }
    EXPECT_TRUE(store->add(rows, units));
    return std::move(*store);
  }

  fs::path folder_;
};

TEST_F(ResultStoreTest, RowsComeBackBitForBit) {
  { const ResultStore store = filled("a.hresults", 0, 50); }
  const auto store = ResultStore::open(folder_ / "a.hresults", false);
  ASSERT_TRUE(store) << store.error().message();
  EXPECT_EQ(store->head().study, "cell = 'x'");
  EXPECT_EQ(store->head().answers.at(1).kind, Column::Kind::kWhole);
  std::int64_t next = 0;
  ASSERT_TRUE(store->forEachRow([&](const ResultRow& found) {
    EXPECT_EQ(found, row(next++));
    return Expected<void>();
  }));
  EXPECT_EQ(next, 50);
  EXPECT_EQ(store->completeUnits()->size(), 50U);
  EXPECT_EQ(**store->row(17), row(17));
  EXPECT_FALSE(store->row(50)->has_value());
}

TEST_F(ResultStoreTest, OnlyTheSameStudyAndVersionContinue) {
  { const ResultStore store = filled("a.hresults", 0, 5); }
  EXPECT_TRUE(ResultStore::openOrCreate(folder_ / "a.hresults", head()));
  ResultHead other = head();
  other.digest = "d2";
  const auto changed = ResultStore::openOrCreate(folder_ / "a.hresults", other);
  ASSERT_FALSE(changed);
  EXPECT_NE(changed.error().message().find("another study"), std::string::npos);
  other = head();
  other.version = "1.1 def";
  const auto newer = ResultStore::openOrCreate(folder_ / "a.hresults", other);
  ASSERT_FALSE(newer);
  EXPECT_NE(newer.error().message().find("version 1.0 abc"), std::string::npos);
}

TEST_F(ResultStoreTest, RefusesOtherFiles) {
  std::ofstream(folder_ / "text") << "no database, but long enough to be read as one, if it were one at all ... ......";
  EXPECT_FALSE(ResultStore::open(folder_ / "text", false));
  EXPECT_FALSE(ResultStore::open(folder_ / "missing", false));
  EXPECT_FALSE(ResultStore::open(folder_, false));
  EXPECT_FALSE(ResultStore::create(folder_ / "text", head()));
}

TEST_F(ResultStoreTest, MergingFindsDoublesGapsAndStrangers) {
  { const ResultStore a = filled("a", 0, 50), b = filled("b", 50, 100), c = filled("c", 49, 60); }
  const auto merged = mergeResults({folder_ / "b", folder_ / "a"}, folder_ / "all", false);
  ASSERT_TRUE(merged) << merged.error().message();
  EXPECT_EQ(merged->rows, 100);
  const ResultStore whole = filled("whole", 0, 100);
  EXPECT_EQ(*csvOf(*ResultStore::open(folder_ / "all", false)), *csvOf(whole));
  const auto twice = mergeResults({folder_ / "a", folder_ / "b", folder_ / "a"}, folder_ / "twice", true);
  ASSERT_FALSE(twice);
  EXPECT_NE(twice.error().message().find("also in"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "twice"));
  EXPECT_FALSE(mergeResults({folder_ / "a", folder_ / "c"}, folder_ / "overlap", true));
  EXPECT_FALSE(mergeResults({folder_ / "a"}, folder_ / "gap", false));
  const auto partial = mergeResults({folder_ / "a"}, folder_ / "gap", true);
  ASSERT_TRUE(partial);
  EXPECT_EQ(partial->missing_units, 50);
}

TEST_F(ResultStoreTest, TheBestComeFirst) {
  const ResultStore store = filled("a", 0, 100);
  const auto best = bestRows(store, 60);
  ASSERT_TRUE(best);
  ASSERT_EQ(best->size(), 60U);
  for (std::size_t i = 1; i < 50; ++i) {
    EXPECT_TRUE((*best)[i].feasible);
    EXPECT_LE(std::get<double>((*best)[i - 1].objective), std::get<double>((*best)[i].objective));
  }
  EXPECT_FALSE((*best)[50].feasible);
}

TEST_F(ResultStoreTest, TheFrontIsThatOfAPlainSearch) {
  const ResultStore store = filled("a", 0, 100);
  StudyDocument document;
  document.objectives = {{"q.a", false, 1.0}, {"q.n", true, 1.0}};
  const auto front = paretoRows(store, document);
  ASSERT_TRUE(front) << front.error().message();
  std::vector<std::int64_t> expected, found;
  for (std::int64_t i = 0; i < 100; i += 2) {
    bool beaten = false;
    for (std::int64_t k = 0; k < 100; k += 2) {
      const double ai = std::get<double>(row(i).answers[0]), ak = std::get<double>(row(k).answers[0]);
      beaten = beaten || (k != i && ak <= ai && k >= i);
    }
    if (!beaten) expected.push_back(i);
  }
  for (const ResultRow& one : *front) found.push_back(one.number);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace hapticell::studies
