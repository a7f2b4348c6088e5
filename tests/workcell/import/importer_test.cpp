// SPDX-License-Identifier: Apache-2.0
#include "workcell/import/importer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <cstdlib>
#include <set>

#include "tests/support/test_data.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;
using State = ImportStatus::State;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Waits until jobs ended, as a window would be woken.
class Ended {
 public:
  std::function<void(ImportId)> listener() {
    return [this](ImportId id) {
      const std::lock_guard lock(mutex_);
      ids_.insert(id);
      wake_.notify_all();
    };
  }
  void waitFor(ImportId id) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [&] { return ids_.contains(id); });
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  std::set<ImportId> ids_;
};

TEST(Importer, QueuesSeveralAndHandsEachResultOutOnce) {
  test::TemporaryFolder folder;
  folder.write("a.obj", kTriangle);
  folder.write("b.obj", "rubbish");
  Ended ended;
  Importer importer(ended.listener());
  const ImportId good = importer.start({"a.obj", folder.path(), {}});
  const ImportId bad = importer.start({"b.obj", folder.path(), {}});
  const ImportId none = importer.start({"c.obj", folder.path(), {}});
  for (ImportId id : {good, bad, none}) ended.waitFor(id);
  EXPECT_EQ(importer.status(good).state, State::kDone);
  EXPECT_EQ(importer.status(bad).state, State::kFailed);
  const auto result = importer.take(good);
  ASSERT_TRUE(result && *result);
  ASSERT_EQ((*result)->entities.size(), 1u);
  EXPECT_EQ((*result)->entities[0].name, "a");
  EXPECT_EQ((*result)->report.format, "obj");
  EXPECT_EQ((*result)->report.triangles, 1u);
  EXPECT_FALSE((*result)->report.unit_is_stated);
  EXPECT_FALSE(importer.take(good));
  EXPECT_EQ(importer.status(good).state, State::kUnknown);
  EXPECT_THAT(importer.take(none)->error().message(), HasSubstr("c.obj"));
}

TEST(Importer, CancelsWhatRunsAndWhatWaits) {
  test::TemporaryFolder folder;
  const auto program = folder.write("importer.sh", "#!/bin/sh\nexec sleep 100\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  ::setenv("HAPTICELL_IMPORTER", program.c_str(), 1);
  folder.write("a.step", "ISO-10303-21;");
  Importer importer;
  const ImportId running = importer.start({"a.step", folder.path(), {}});
  const ImportId waiting = importer.start({"a.step", folder.path(), {}});
  while (importer.status(running).state == State::kQueued) std::this_thread::yield();
  EXPECT_EQ(importer.status(waiting).state, State::kQueued);
  for (ImportId id : {running, waiting}) {
    importer.cancel(id);
    EXPECT_EQ(importer.status(id).state, State::kCancelled);
    const auto result = importer.take(id);
    ASSERT_TRUE(result && !*result);
    EXPECT_THAT(result->error().message(), HasSubstr("cancelled"));
  }
  ::unsetenv("HAPTICELL_IMPORTER");
}

TEST(Importer, EndsWithWorkLeft) {
  test::TemporaryFolder folder;
  folder.write("a.obj", kTriangle);
  Importer importer;
  for (int k = 0; k < 20; ++k) importer.start({"a.obj", folder.path(), {}});
}

}  // namespace
}  // namespace hapticell::workcell
