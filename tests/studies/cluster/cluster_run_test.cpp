// SPDX-License-Identifier: Apache-2.0
#include "studies/cluster/cluster_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "studies/cluster/program_call.h"

namespace hapticell::studies {
namespace {

namespace fs = std::filesystem;

// Submitting, following and merging are tested with a real Slurm: tests/cli/slurm_study_test.py.
class ClusterRun : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("cluster run's " + std::to_string(::getpid()));
    fs::create_directories(folder_);
    std::ofstream(folder_ / "s.hstudy") << "name = \"Welds of a door\"\ncell = \"a.hcell\"\n[[vary]]\nwhat = \"position\"\n"
                                           "[[ask]]\nwhat = \"reach\"\n";
  }
  void TearDown() override { fs::remove_all(folder_); }
  ClusterPlan plan() { return {.study = folder_ / "s.hstudy", .output = folder_ / "all.hresults", .chunks = 5}; }
  fs::path folder_;
};

TEST_F(ClusterRun, WritesTheScriptThatIsShown) {
  ClusterPlan wanted = plan();
  wanted.cpus = 3;
  wanted.time = "01:00:00";
  const auto job = slurmJobOf(wanted);
  ASSERT_TRUE(job) << job.error().message();
  EXPECT_EQ(job->name, "Welds-of-a-door");
  const auto script = writeSlurmScript(*job);
  ASSERT_TRUE(script) << script.error().message();
  std::ifstream file(job->script());
  std::stringstream written;
  written << file.rdbuf();
  EXPECT_EQ(written.str(), *script);
  EXPECT_NE(script->find("#SBATCH --cpus-per-task=3\n"), std::string::npos);
  EXPECT_NE(script->find("#SBATCH --time=01:00:00\n"), std::string::npos);
  EXPECT_NE(script->find("'\\''s "), std::string::npos) << "the folder's quote is quoted: " << *script;
  EXPECT_EQ(missingChunks(*job), (std::vector<std::size_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(chunkList(missingChunks(*job)), "1-5");
}

TEST_F(ClusterRun, RefusesWhatCannotBeSubmitted) {
  std::ofstream(folder_ / "all.hresults") << "there";
  EXPECT_FALSE(slurmJobOf(plan()));
  ClusterPlan broken = plan();
  broken.output = folder_ / "new.hresults";
  broken.partition = "a\nb";
  EXPECT_FALSE(slurmJobOf(broken));
  broken.partition = "";
  broken.study = folder_ / "none.hstudy";
  EXPECT_FALSE(slurmJobOf(broken));
}

TEST(ProgramCall, GivesAllThatWasSaidAndHowItEnded) {
  const auto answer = callProgram("sh", {"-c", "echo one; echo two >&2; exit 3"});
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_EQ(answer->status, 3);
  EXPECT_EQ(answer->output, "one\ntwo\n");
  const auto killed = callProgram("sh", {"-c", "kill -KILL $$"});
  ASSERT_TRUE(killed);
  EXPECT_EQ(killed->status, -1);
}

TEST(ProgramCall, NoShellReadsTheArguments) {
  const auto answer = callProgram("printf", {"%s", "$HOME; echo 'x' > /dev/null"});
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_EQ(answer->output, "$HOME; echo 'x' > /dev/null");
  const auto missing = callProgram("no-such-program-of-a-cluster", {});
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message().find("no-such-program-of-a-cluster"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::studies
