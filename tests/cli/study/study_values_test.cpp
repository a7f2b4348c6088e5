// SPDX-License-Identifier: Apache-2.0
// What the study commands read and print.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/study/chunk_option.h"
#include "cli/study/study_commands.h"
#include "cli/study/study_progress.h"
#include "cli/study/study_report.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

TEST(StudyCommands, TakeTheirWords) {
  test::expectRefusals({addStudyCommand},
                       {{{"study"}, "subcommand is required"},
                        {{"study", "run", "a.hstudy"}, "--output is required"},
                        {{"study", "run", "a.hstudy", "-o", "a.hresults", "--chunk", "1/2"}, ""},
                        {{"study", "run", "a.hstudy", "-o", "a.hresults", "--jobs", "0"}, "--jobs"},
                        {{"study", "best", "a.hresults", "--count", "0"}, "--count"},
                        {{"study", "submit", "a.hstudy", "-o", "a.hresults", "--retries", "101"}, "--retries"}});
  EXPECT_THAT(test::OneCommand({addStudyCommand}).below("study"),
              IsSupersetOf({"run", "show", "best", "export", "open", "merge", "submit"}));
  test::OneCommand study({addStudyCommand});
  EXPECT_THAT(study.error({"study", "submit", "a.hstudy", "-o", "a.hresults"}), HasSubstr("--slurm"));
}

TEST(ChunkOption, IsAPartOfEqualOnes) {
  const auto all = parseChunk("");
  ASSERT_TRUE(all);
  EXPECT_EQ(all->chunk, 1U);
  EXPECT_EQ(all->chunks, 1U);
  const auto third = parseChunk("3/16");
  ASSERT_TRUE(third);
  EXPECT_EQ(third->chunk, 3U);
  EXPECT_EQ(third->chunks, 16U);
  EXPECT_TRUE(parseChunk("16/16"));
  for (const char* bad : {"0/4", "5/4", "3", "3/", "/4", "3/4x", "-1/4", "1/0", " 1/4", "1/1000001", "1/99999999999999999999"}) {
    const auto refused = parseChunk(bad);
    ASSERT_FALSE(refused) << bad;
    EXPECT_THAT(refused.error().message(), HasSubstr("--chunk"));
  }
}

TEST(StudyProgress, DurationsAreRoundedBeforeTheyAreSplit) {
  EXPECT_EQ(durationWords(0.0), "0 s");
  EXPECT_EQ(durationWords(59.4), "59 s");
  EXPECT_EQ(durationWords(59.6), "1 min 00 s");
  EXPECT_EQ(durationWords(3599.6), "1 h 00 min");
  EXPECT_EQ(durationWords(3900.0), "1 h 05 min");
  EXPECT_EQ(durationWords(100.0 * 3600.0), "100 h 00 min");
}

TEST(StudyProgress, WritesALineATenth) {
  ::testing::internal::CaptureStderr();
  {
    StudyProgress progress;
    for (std::size_t done = 0; done <= 200; ++done) progress.show({done, 200, 0.5 * static_cast<double>(done)});
  }
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 10) << said;
  EXPECT_THAT(said, HasSubstr("100 of 200, 2 a second, 50 s left\n"));
  EXPECT_THAT(said, HasSubstr("200 of 200, 2 a second, 0 s left\n"));
}

TEST(StudyReport, SummarisesWhatTheStoreHolds) {
  using studies::Column;
  const test::TemporaryFolder folder;
  studies::ResultHead head{"Name", "text", "/a/s.hstudy", "d", "1.0", 3, 4, 4, 1, {}, {}};
  head.values = {{"x", Column::Kind::kNumber, "m"}};
  head.answers = {{"q.a", Column::Kind::kNumber, "s"}, {"q.n", Column::Kind::kWhole, ""}, {"q.t", Column::Kind::kText, ""}};
  auto store = studies::ResultStore::create(folder.path() / "a.hresults", head);
  ASSERT_TRUE(store) << store.error().message();
  std::vector<studies::ResultRow> rows(3);
  const double values[] = {4.0, -1.5, 2.0};
  for (std::size_t i = 0; i < 3; ++i) {
    rows[i].number = static_cast<std::int64_t>(i);
    rows[i].values = {0.25 * static_cast<double>(i)};
    rows[i].answers = {values[i], static_cast<std::int64_t>(i) - 7, std::string("word")};
    rows[i].feasible = i != 1;
    rows[i].objective = values[i];
  }
  rows[1].answers[1] = studies::Answer();
  rows[1].note = "no answer";
  ASSERT_TRUE(store->add(rows, {0, 1, 2}));
  const auto summary = summaryJson(*store);
  ASSERT_TRUE(summary);
  EXPECT_EQ((*summary)["rows"], 3);
  EXPECT_EQ((*summary)["feasible"], 2);
  EXPECT_EQ((*summary)["with_notes"], 1);
  EXPECT_EQ((*summary)["complete"], false) << "three of four units";
  const ordered_json& number = (*summary)["results"][0];
  EXPECT_EQ(number, (ordered_json{{"name", "q.a"}, {"unit", "s"}, {"least", -1.5}, {"mean", 1.5}, {"greatest", 4.0}, {"missing", 0}}));
  EXPECT_EQ((*summary)["results"][1]["missing"], 1);
  EXPECT_EQ((*summary)["results"][1]["mean"], -6.0) << "of -7 and -5";
  EXPECT_FALSE((*summary)["results"][2].contains("mean")) << "words have none";
  const ordered_json list = rowsJson(head, rows);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0]["values"]["x"], 0.0);
  EXPECT_EQ(list[0]["results"]["q.t"], "word");
  EXPECT_FALSE(list[0].contains("note"));
  EXPECT_TRUE(list[1]["results"]["q.n"].is_null());
  EXPECT_EQ(rowJson(head, rows[1])["note"], "no answer");
  EXPECT_THAT(studyVersion(), HasSubstr("."));
}

}  // namespace
}  // namespace hapticell::cli
