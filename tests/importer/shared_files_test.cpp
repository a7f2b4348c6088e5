// SPDX-License-Identifier: Apache-2.0
// Every file of the shared data by name: triangles, size, parts and colours as the data's own SOURCE.md states them
// (taken with other programs), and every mesh of the workcells and robots against a count made here, without our
// readers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/support/test_data.h"
#include "workcell/import/entity_source.h"
#include "workcell/meshes/mesh_reader.h"
#include "workcell/scenes/scene_batch.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;

struct Stated {
  const char* file;
  std::size_t triangles;  ///< Each use counted.
  dvec3 size_mm;
  std::size_t parts = 1, colors = 1;
};

// Sizes to the digits that SOURCE.md gives; where it gives none, those of the file itself. OCCT cuts curved faces a
// little differently on each processor: 1 %.
constexpr Stated kStated[] = {
    {"step/as1-oc-214.stp", 7512, {200, 150, 84}, 18, 5},
    {"step/NIST_MBE_PMI_2.stp", 109868, {860, 680, 400}},
    {"step/linkrods.step", 6736, {5.0, 1.5, 2.0}},
    {"step/odri_transmission_pulley_at3_t10_motor.step", 1216, {9.139, 6.7, 8.819}},
    {"stl/odri_transmission_pulley_at3_t30_output.stl", 19054, {29.0, 28.995, 16.4}},
    {"stl/odri_hip_aa_module_shell_base.stl", 77286, {161.993, 37.0, 12.0}},
    {"obj/industreal_gear_base.obj", 4992, {150, 75, 25}},
    {"obj/industreal_gear_small.obj", 20532, {21.995, 21.995, 20}},
    {"obj/industreal_gear_medium.obj", 35212, {41.915, 41.915, 20}},
    {"obj/factory_round_peg_8mm_tight.obj", 1152, {7.995, 7.995, 50}},
    {"obj/factory_round_hole_8mm_subdiv_3x.obj", 900, {25, 25, 8.992}},
    {"obj/factory_rectangular_peg_8mm_loose_subdiv_3x.obj", 1792, {7.964, 6.910, 50}},
    {"obj/factory_rectangular_hole_8mm_subdiv_3x.obj", 1040, {25, 25, 8.992}},
    {"workcell_snp/meshes/part_scan.ply", 7052, {458.7, 470.0, 139.9}},
    {"workcell_snp/meshes/visual/end_effector.stl", 66214, {342.05, 360.53, 209.5}},
};

class SharedFile : public ::testing::TestWithParam<Stated> {};

TEST_P(SharedFile, IsWhatItsSourceStates) {
  const Stated& stated = GetParam();
  HAPTICELL_SHARED_DATA_OR_SKIP(file, std::string("cad/") + stated.file);
  Diagnostics notes;
  ImportOptions options;
  options.weld = false;
  if (std::string_view(stated.file).starts_with("stl/")) options.metres_per_unit = 1e-3;
  const auto tree = EntityLoader(fs::current_path()).loadTree(file.string(), options, notes);
  ASSERT_TRUE(tree) << tree.error().message();
  geometry::Bounds bounds;
  std::size_t triangles = 0, parts = 0;
  std::set<std::array<float, 3>> colors;
  for (const auto& entity : tree->entities) {
    if (!entity.mesh()) continue;
    ++parts;
    triangles += entity.mesh()->triangles.size();
    colors.insert(entity.color);
    for (const dvec3& p : entity.mesh()->vertices) bounds.add(entity.X_WE * p);
  }
  const bool cut = holdsScene(file);
  EXPECT_NEAR(static_cast<double>(triangles), static_cast<double>(stated.triangles),
              cut ? 0.01 * static_cast<double>(stated.triangles) : 0.0);
  EXPECT_EQ(parts, stated.parts);
  EXPECT_EQ(colors.size(), stated.colors);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(bounds.size()[i] * 1e3, stated.size_mm[i], 6e-4 * stated.size_mm.x + 0.03);
}

std::string stem(const ::testing::TestParamInfo<Stated>& tested) {
  std::string name = fs::path(tested.param.file).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Cad, SharedFile, ::testing::ValuesIn(kStated), stem);

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream content;
  content << stream.rdbuf();
  return content.str();
}

std::size_t stlTriangles(const std::string& content) {
  std::uint32_t count = 0;
  if (content.size() >= 84) std::memcpy(&count, content.data() + 80, 4);
  if (content.size() == 84 + 50 * std::size_t{count}) return count;
  std::size_t facets = 0;
  for (std::size_t at = content.find("facet normal"); at != std::string::npos;
       at = content.find("facet normal", at + 1))
    ++facets;
  return facets;
}

/// Every face of these files is a triangle.
std::size_t plyTriangles(const std::string& content) {
  const std::size_t at = content.find("element face ");
  return at == std::string::npos ? 0 : std::stoul(content.substr(at + 13));
}

/// Of all geometries, each once: the counts of <triangles>, and the corners of <polylist> less two a face.
std::size_t colladaTriangles(const std::string& content) {
  std::size_t sum = 0;
  for (std::size_t at = content.find("<triangles"); at != std::string::npos; at = content.find("<triangles", at + 1)) {
    const std::size_t count = content.find("count=\"", at);
    if (count < content.find('>', at)) sum += std::stoul(content.substr(count + 7));
  }
  for (std::size_t at = content.find("<vcount>"); at != std::string::npos; at = content.find("<vcount>", at + 1)) {
    std::istringstream counts(content.substr(at + 8, content.find('<', at + 8) - at - 8));
    for (std::size_t n = 0; counts >> n;) sum += n - 2;
  }
  return sum;
}

std::size_t counted(const fs::path& file) {
  const std::string content = contentOf(file);
  if (file.extension() == ".stl" || file.extension() == ".STL") return stlTriangles(content);
  if (file.extension() == ".ply") return plyTriangles(content);
  return colladaTriangles(content);
}

class SharedFolder : public ::testing::TestWithParam<const char*> {};

TEST_P(SharedFolder, EveryMeshHasTheTrianglesThatItsFileCounts) {
  HAPTICELL_SHARED_DATA_OR_SKIP(folder, std::string(GetParam()));
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".dae" || ending == ".stl" || ending == ".STL" || ending == ".ply") files.push_back(entry.path());
  }
  EXPECT_FALSE(files.empty());
  SceneBatch scenes{ImportOptions()};  // One start of the importer for all that need it.
  scenes.readAhead(files);
  for (const fs::path& file : files) {
    std::size_t triangles = 0;
    if (counted(file) == 0) {  // Denso's J4.dae: a node and no geometry.
      EXPECT_FALSE(scenes.scene(file)) << file;
      continue;
    }
    if (file.extension() == ".dae") {
      const auto read = scenes.scene(file);
      ASSERT_TRUE(read) << read.error().message();
      for (const auto& mesh : read->meshes) triangles += mesh.triangles.size();
    } else {
      Diagnostics notes;
      const auto read = readMesh(file, {.weld = false}, notes);
      ASSERT_TRUE(read) << read.error().message();
      triangles = read->triangles.size();
    }
    EXPECT_EQ(triangles, counted(file)) << file;
  }
}
INSTANTIATE_TEST_SUITE_P(All, SharedFolder,
                         ::testing::Values("cad/workcell_ariac", "cad/workcell_snp", "robots/kuka_kr120r2500pro",
                                           "robots/abb_irb4600_60_205", "robots/fanuc_lrmate200id", "robots/ur5e",
                                           "robots/franka_fer", "robots/denso_hsr065_scara"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

}  // namespace
}  // namespace hapticell::workcell
