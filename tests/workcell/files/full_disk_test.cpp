// SPDX-License-Identifier: Apache-2.0
// A disk that is full in the middle of writing (here: a limit on the size of files, which fails the same write): what
// stood there before still stands, nothing half-written is left, and one sentence says why.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "workcell/files/archive.h"
#include "workcell/files/autosave.h"
#include "workcell/files/scene_export.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;

/// While it lives no file of this process grows beyond `bytes`.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    before_ = ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &limit_);
    rlimit small = limit_;
    small.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    ::signal(SIGXFSZ, before_);
  }

 private:
  rlimit limit_{};
  void (*before_)(int) = nullptr;
};

class FullDiskTest : public ::testing::Test {
 protected:
  FullDiskTest() {
    EntityLoader loader(folder_.path());
    Diagnostics diagnostics;
    for (int i = 0; i < 20; ++i) {
      auto box = loader.load("box:1,1,1", 1.0, diagnostics);
      box->name = document_.uniqueName("box");
      EXPECT_TRUE(document_.execute(AddEntity{std::move(*box)}));
    }
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }
  template <typename T>
  static void expectSentence(const Expected<T>& done, const fs::path& file) {
    ASSERT_FALSE(done) << file << " was written to a full disk";
    EXPECT_THAT(done.error().message(), ::testing::HasSubstr(file.stem().string()));
    EXPECT_EQ(done.error().message().find('\n'), std::string::npos) << done.error().message();
  }
  test::TemporaryFolder folder_;
  Document document_;
};

TEST_F(FullDiskTest, SavingLeavesTheOldFileAndStaysDirty) {
  const fs::path file = folder_.path() / "cell.hcell";
  ASSERT_TRUE(saveDocument(document_, file));
  const std::string before = *readFileContent(file);
  ASSERT_TRUE(document_.execute(RenameEntity{document_.state().entities[0]->id, "moved"}));
  {
    const FullDisk full(300);
    expectSentence(saveDocument(document_, file), file);
  }
  EXPECT_EQ(*readFileContent(file), before);
  EXPECT_EQ(files(), 1u) << "nothing half-written is left";
  EXPECT_TRUE(document_.isDirty());
  EXPECT_TRUE(saveDocument(document_, file)) << "there is room again";
}

TEST_F(FullDiskTest, AutosavingTellsAndLeavesTheOlderCopy) {
  const fs::path file = folder_.path() / "cell.hcell";
  ASSERT_TRUE(saveDocument(document_, file));
  ASSERT_TRUE(document_.execute(RenameEntity{document_.state().entities[0]->id, "moved"}));
  ASSERT_TRUE(autosave(document_.state(), file, folder_.path()));
  const std::string copy = *readFileContent(copyIn(folder_.path()));
  ASSERT_TRUE(document_.execute(RenameEntity{document_.state().entities[0]->id, "moved again"}));
  {
    const FullDisk full(300);
    expectSentence(autosave(document_.state(), file, folder_.path()), copyIn(folder_.path()));
  }
  EXPECT_EQ(*readFileContent(copyIn(folder_.path())), copy);
}

TEST_F(FullDiskTest, ExportsAndArchivesLeaveWhatStoodThere) {
  Diagnostics diagnostics;
  for (const char* name : {"out.stl", "out.obj", "out.glb", "out.step"}) {
    const fs::path file = folder_.write(name, "old");
    const std::size_t before = files();
    {
      const FullDisk full(300);
      expectSentence(exportState(document_.state(), file, {}, diagnostics), file);
    }
    EXPECT_EQ(*readFileContent(file), "old") << name;
    EXPECT_EQ(files(), before) << name;
  }
  folder_.write("content/a.txt", std::string(5000, 'a') + "bcdefg");
  std::string noise;
  for (int i = 0; i < 4000; ++i) noise += static_cast<char>(i * i % 251);
  folder_.write("content/b.bin", noise);
  const fs::path archive = folder_.write("pack.zip", "old");
  {
    const FullDisk full(300);
    expectSentence(writeArchive(folder_.path() / "content", archive), archive);
  }
  EXPECT_EQ(*readFileContent(archive), "old");
}

}  // namespace
}  // namespace hapticell::workcell
