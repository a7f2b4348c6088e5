// SPDX-License-Identifier: Apache-2.0
// The importer's side of its process, and what it says when a library fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <numbers>

#include "geometry/system/packed_text.h"
#include "geometry/system/sanitizers.h"
#include "importer/assimp_fault.h"
#include "importer/damaged_file.h"
#include "importer/library_fault.h"
#include "importer/parent_link.h"
#include "importer/resource_limits.h"
#include "importer/sdf_resolver.h"
#include "tests/importer/model_texts.h"
#include "tests/importer/parent_ends.h"
#include "tests/support/test_data.h"

namespace hapticell::importer {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using test::ParentEnds;
using test::TemporaryFolder;

TEST(DamagedFile, SaysThatItIsToBeExportedAgain) {
  const Error error = damagedFile(Text("byte 3"), Text("a letter"), Text("a number"));
  EXPECT_EQ(english(error.place), "byte 3");
  EXPECT_THAT(error.message(), HasSubstr("a letter"));
  EXPECT_THAT(error.message(), HasSubstr("a number"));
  EXPECT_THAT(error.message(), HasSubstr("Export it again."));
}

TEST(LibraryFault, SaysWhatALibrarysOwnWordMeans) {
  EXPECT_THAT(libraryFault("std::bad_alloc").message(), HasSubstr("a count that is too large"));
  EXPECT_THAT(libraryFault("stoi").message(), HasSubstr("instead of a number"));
  EXPECT_THAT(libraryFault("Standard_NullObject").message(), HasSubstr("not in the file"));
  EXPECT_THAT(libraryFault("gp_VectorWithNullMagnitude").message(), HasSubstr("length zero"));
  EXPECT_THAT(libraryFault("Frobnicator failed").message(), HasSubstr("(Frobnicator failed)"));
  EXPECT_THAT(libraryFault("std::strange").message(), Not(HasSubstr("strange")));
  EXPECT_THAT(libraryFault("").message(), HasSubstr("inconsistent content"));
}

TEST(AssimpFault, SaysWhereAndWhatIsMissing) {
  const TemporaryFolder folder;
  const std::string head = "glTF" + test::bytesOf(std::vector<std::uint32_t>{2, 100, 60, 0x4E4F534A});
  const fs::path cut = folder.write("cut.glb", head);
  const auto fault = binaryGltfFault(cut, head);
  ASSERT_TRUE(fault);
  EXPECT_THAT(fault->message(), HasSubstr("ends after 20 bytes"));
  EXPECT_THAT(fault->message(), HasSubstr("100 bytes"));
  EXPECT_EQ(assimpFault(cut, head, "anything").message(), fault->message());
  const std::string whole = head + std::string(80, ' ');
  EXPECT_FALSE(binaryGltfFault(folder.write("whole.glb", whole), whole));
  const std::string third = "glTF" + test::bytesOf(std::vector<std::uint32_t>{3, 20, 0, 0});
  EXPECT_THAT(binaryGltfFault(folder.write("third.glb", third), third)->message(), HasSubstr("version 3"));
  const fs::path fbx = folder.path() / "a.fbx";
  EXPECT_EQ(english(assimpFault(fbx, "", "FBX-Tokenize (offset 0x1f) unexpected token").place), "byte 31");
  EXPECT_THAT(assimpFault(fbx, "", "No suitable reader found").message(), HasSubstr("not of this format"));
}

TEST(ParentLink, ItsLinesAreThoseOfTheProtocol) {
  ParentEnds ends;
  ParentLink parent;
  parent.setRange(0.5, 1.0);
  parent.progress(0.0, "reading");
  parent.progress(0.001, "reading");  // Too little to tell.
  parent.progress(1.0, "reading");
  parent.beginPart(7);
  const Error fault = damagedFile(Text("line %1", 3), "b", "c");
  parent.error(fault);
  parent.done();
  const std::string lines = ends.lines();
  EXPECT_THAT(lines, HasSubstr("progress 0.500 "));
  EXPECT_THAT(lines, HasSubstr("progress 1.000 "));
  EXPECT_THAT(lines, HasSubstr("\npart 7\nerror "));
  EXPECT_TRUE(lines.ends_with("\ndone\n"));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 5);
  const std::string flat = ParentLink::flatParts(fault);
  EXPECT_EQ(flat.find('\n'), std::string::npos);
  EXPECT_THAT(lines, HasSubstr("error " + flat + "\n"));
  const auto arrived = unpackedError(flat);  // As the parent reads it.
  ASSERT_TRUE(arrived);
  EXPECT_EQ(arrived->message(), fault.message());
}

TEST(ParentLink, TellsItsProgressAtMostAHundredTimes) {
  ParentEnds ends;
  ParentLink parent;
  for (int k = 0; k <= 100'000; ++k) parent.progress(1e-5 * k, "reading");
  const std::string lines = ends.lines();
  const auto count = std::count(lines.begin(), lines.end(), '\n');
  EXPECT_GE(count, 95);
  EXPECT_LE(count, 101) << "the beginning and each hundredth";
}

TEST(ParentLink, AnEarlierSceneIsReplaced) {
  ParentEnds ends;
  ParentLink parent;
  EXPECT_EQ(parent.readScene(), "");
  const std::string bytes("a longer\0scene", 14);
  ASSERT_TRUE(parent.writeScene(bytes));
  EXPECT_EQ(parent.readScene(), bytes);
  ASSERT_TRUE(parent.writeScene("short"));
  EXPECT_EQ(parent.readScene(), "short");
}

TEST(ResourceLimits, AreSetForThisProcessAlone) {
  rlimit before{};
  ::getrlimit(RLIMIT_CPU, &before);
  constexpr std::uint64_t kSpace = std::uint64_t{8} << 30;
  const pid_t child = ::fork();
  if (child == 0) {
    limitResources(kSpace, 30);
    rlimit core{}, time{};
    ::getrlimit(RLIMIT_CORE, &core);
    ::getrlimit(RLIMIT_CPU, &time);
    int ends_with_parent = 0;
    ::prctl(PR_GET_PDEATHSIG, &ends_with_parent);
    int fault = 0;
    if (core.rlim_cur != 0) fault |= 1;
    if (time.rlim_cur > 60) fault |= 2;
    if (ends_with_parent != SIGKILL) fault |= 4;
#if !HAPTICELL_SANITIZED
    const auto mapped = [](std::uint64_t bytes) {
      return ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) != MAP_FAILED;
    };
    if (mapped(kSpace)) fault |= 8;
    if (!mapped(kSpace / 8)) fault |= 16;
#endif
    ::_exit(fault);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 0) << "1 core, 2 time, 4 parent, 8 and 16 address space";
  rlimit after{};
  ::getrlimit(RLIMIT_CPU, &after);
  EXPECT_EQ(after.rlim_cur, before.rlim_cur);
}

TEST(SdfResolver, GivesPosesInTheModelsFrame) {
  const auto content = resolveSdf(
      "<sdf version='1.9'><model name='m'><link name='a'><pose>1 0 0 0 0 1.5707963267948966</pose><visual name='v'><pose>"
      "0 0 3 0 0 0</pose><geometry><cylinder><radius>0.2</radius><length>0.7</length></cylinder></geometry></visual></link>"
      "<link name='b'><pose relative_to='a'>0 2 0 0 0 0</pose></link><joint name='j' type='revolute'><parent>a</parent>"
      "<child>b</child><axis><xyz>1 0 0</xyz><limit><lower>-1</lower><upper>2</upper></limit></axis></joint></model></sdf>");
  ASSERT_TRUE(content) << content.error().message();
  EXPECT_FALSE(content->has_world);
  EXPECT_TRUE(content->complaints.empty());
  ASSERT_EQ(content->models.size(), 1u);
  const workcell::SdfModel& model = content->models[0];
  EXPECT_EQ(model.name, "m");
  ASSERT_EQ(model.links.size(), 2u);
  // By hand: b is 2 m along y of a, which is turned by a quarter about z: along -x of the model.
  const Pose& X_MB = model.links[1].X_ML.X;
  EXPECT_LT(glm::distance(X_MB.p, dvec3(-1, 0, 0)), 1e-12);
  EXPECT_LT(glm::distance(X_MB.q * dvec3(1, 0, 0), dvec3(0, 1, 0)), 1e-12);
  ASSERT_EQ(model.links[0].visuals.size(), 1u);
  const workcell::SdfShape& visual = model.links[0].visuals[0];
  EXPECT_EQ(visual.kind, workcell::SdfShape::Kind::kCylinder);
  EXPECT_LT(glm::distance(visual.size, dvec3(0.2, 0.7, 0)), 1e-12);
  EXPECT_LT(glm::distance(visual.X_LS.X.p, dvec3(0, 0, 3)), 1e-12) << "in its link's frame";
  ASSERT_EQ(model.joints.size(), 1u);
  const workcell::SdfJoint& joint = model.joints[0];
  EXPECT_EQ(joint.type, workcell::SdfJoint::Type::kRevolute);
  EXPECT_EQ(joint.parent + " " + joint.child, "a b");
  EXPECT_LT(glm::distance(joint.X_MJ.X.p, X_MB.p), 1e-12) << "a joint stands at its child";
  ASSERT_TRUE(joint.axes.at(0));
  EXPECT_LT(glm::distance(joint.axes[0]->xyz_M, dvec3(0, 1, 0)), 1e-12) << "x of the child";
  EXPECT_EQ(joint.axes[0]->lower, -1.0);
  EXPECT_EQ(joint.axes[0]->upper, 2.0);
}

TEST(SdfResolver, SaysWhatTheLibraryComplainsOf) {
  const auto rubbish = resolveSdf("<no sdf");
  ASSERT_TRUE(rubbish) << rubbish.error().message();
  EXPECT_TRUE(rubbish->models.empty());
  EXPECT_FALSE(rubbish->first_complaint.empty());
  const auto dangling = resolveSdf(
      "<sdf version='1.9'><model name='m'><link name='a'><pose relative_to='nowhere'>0 0 0 0 0 0</pose></link></model></sdf>");
  ASSERT_TRUE(dangling) << dangling.error().message();
  ASSERT_FALSE(dangling->complaints.empty());
  EXPECT_THAT(dangling->complaints[0], HasSubstr("nowhere"));
}

}  // namespace
}  // namespace hapticell::importer
