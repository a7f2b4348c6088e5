// SPDX-License-Identifier: Apache-2.0
// 3MF files: their unit, and archives that are made to do harm.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "workcell/files/archive.h"
#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kTypes =
    R"(<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">)"
    R"(<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>)"
    R"(<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)";
constexpr const char* kRelations =
    R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
    R"(<Relationship Target="/3D/3dmodel.model" Id="rel0" )"
    R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";

/// A tetrahedron with edges of 10 along the axes.
std::string modelText(const std::string& unit) {
  return R"(<?xml version="1.0"?><model )" + unit +
         R"( xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model">)"
         R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="10" y="0" z="0"/><vertex x="0" y="10" z="0"/>)"
         R"(<vertex x="0" y="0" z="10"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>)"
         R"(<triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/>)"
         R"(</triangles></mesh></object></resources><build><item objectid="1"/></build></model>)";
}

class ModelPackageFile : public ::testing::Test {
 protected:
  Expected<ImportedScene> read(const std::string& model) {
    const fs::path content = folder_.path() / "content";
    folder_.write("content/[Content_Types].xml", kTypes);
    folder_.write("content/_rels/.rels", kRelations);
    folder_.write("content/3D/3dmodel.model", model);
    const fs::path zip = folder_.path() / "part.zip", file = folder_.path() / "part.3mf";
    const auto written = writeArchive(content, zip);
    EXPECT_TRUE(written);
    fs::rename(zip, file);
    return readScene(file, {}, nullptr);
  }
  test::TemporaryFolder folder_;
};

TEST_F(ModelPackageFile, IsReadInItsUnit) {
  for (const auto& [unit, metres] : {std::pair{"", 1e-3}, std::pair{R"(unit="millimeter")", 1e-3},
                                     std::pair{R"(unit="inch")", 0.0254}, std::pair{R"(unit="meter")", 1.0}}) {
    const auto scene = read(modelText(unit));
    ASSERT_TRUE(scene) << scene.error().message();
    EXPECT_DOUBLE_EQ(scene->metres_per_unit, metres) << unit;
    ASSERT_EQ(scene->meshes.size(), 1u);
    EXPECT_NEAR(scene->meshes[0].bounds().max.z, 10.0 * metres, 1e-6 * metres) << unit;
  }
}

TEST_F(ModelPackageFile, ABombIsNotUnpacked) {
  const auto scene = read("<model>" + std::string(std::size_t{100} << 20, ' ') + "</model>");
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("part.3mf"));
  EXPECT_THAT(scene.error().message(), HasSubstr("the unpacked size exceeds the limit"));
}

}  // namespace
}  // namespace hapticell::workcell
