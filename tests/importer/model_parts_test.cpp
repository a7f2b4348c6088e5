// SPDX-License-Identifier: Apache-2.0
// The readers of models, part by part, against the libraries' own writers and against geometry.
#include <archive.h>
#include <archive_entry.h>
#include <assimp/scene.h>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "geometry/shapes/bounds.h"
#include "geometry/shapes/shapes.h"
#include "importer/archive_closer.h"
#include "importer/assimp_reader.h"
#include "importer/collada_holes.h"
#include "importer/collada_text.h"
#include "importer/draco_mesh.h"
#include "importer/gltf_file.h"
#include "importer/gltf_reader.h"
#include "importer/model_package.h"
#include "importer/reading.h"
#include "importer/three_mf_reader.h"
#include "tests/importer/enclosed_volume.h"
#include "tests/importer/model_texts.h"
#include "tests/importer/parent_ends.h"
#include "tests/support/test_data.h"
#include "workcell/files/archive.h"

namespace hapticell::importer {
namespace {

namespace fs = std::filesystem;
using geometry::TriangleMesh;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using test::enclosedVolume;
using test::ParentEnds;
using test::TemporaryFolder;

TEST(ColladaHoles, ASquareWithASquareHoleHasTheAreaBetweenThem) {
  const std::vector<std::vector<dvec3>> loops = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                                                 {{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}};
  std::vector<dvec3> points = loops[0];
  points.insert(points.end(), loops[1].begin(), loops[1].end());
  const std::vector<int> cut = cutPolygon(loops);
  ASSERT_EQ(cut.size() % 3, 0u);
  double area = 0.0;
  for (std::size_t k = 0; k < cut.size(); k += 3) {
    const auto at = [&](std::size_t i) { return points.at(static_cast<std::size_t>(cut[k + i])); };
    const double twice = glm::cross(at(1) - at(0), at(2) - at(0)).z;
    EXPECT_GE(twice, 0.0) << "turned like the outline";
    area += 0.5 * twice;
    const dvec3 middle = (at(0) + at(1) + at(2)) / 3.0;
    EXPECT_FALSE(middle.x > 1 && middle.x < 3 && middle.y > 1 && middle.y < 3) << "in the hole";
  }
  EXPECT_NEAR(area, 12.0, 1e-9);
  EXPECT_TRUE(cutPolygon({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}).empty()) << "no area";
}

TEST(ColladaHoles, PolygonsBecomeTrianglesWithTheSameInputs) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(
      "<mesh><source id='p'><float_array id='a' count='24'>0 0 0 4 0 0 4 4 0 0 4 0 1 1 0 1 3 0 3 3 0 3 1 0</float_array>"
      "<technique_common><accessor source='#a' count='8' stride='3'><param name='X' type='float'/><param name='Y' "
      "type='float'/><param name='Z' type='float'/></accessor></technique_common></source><vertices id='v'><input "
      "semantic='POSITION' source='#p'/></vertices><polygons count='1' material='red'><input semantic='VERTEX' source='#v' "
      "offset='0'/><ph><p>0 1 2 3</p><h>4 5 6 7</h></ph></polygons></mesh>"));
  const pugi::xml_node mesh = document.child("mesh");
  EXPECT_EQ(cutPolygonsWithHoles(mesh, mesh.child("polygons")), 0);
  EXPECT_FALSE(mesh.child("polygons"));
  const pugi::xml_node triangles = mesh.child("triangles");
  ASSERT_TRUE(triangles);
  EXPECT_STREQ(triangles.attribute("material").value(), "red");
  EXPECT_EQ(triangles.attribute("count").as_int(), 8) << "n + 2 h - 2 of n corners and h holes";
}

TEST(ColladaText, ReadsUnitAndAxisAndLeavesOutCameras) {
  const TemporaryFolder folder;
  test::ColladaParts parts;
  parts.asset = "<asset><unit name='inch' meter='0.0254'/><up_axis>X_UP</up_axis></asset>";
  parts.libraries = "<library_cameras><camera id='c'/></library_cameras>";
  const auto read = readColladaText(folder.write("a.dae", test::colladaOf(parts)));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_DOUBLE_EQ(read->metres_per_unit, 0.0254);
  EXPECT_TRUE(read->unit_is_stated);
  EXPECT_EQ(read->up, workcell::UpAxis::kX);
  EXPECT_THAT(read->text, Not(HasSubstr("camera")));
  const auto broken = readColladaText(folder.write("b.dae", "<COLLADA>\n<asset>\n</COLLADA>"));
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message(), HasSubstr("line 3"));
}

/// The box as libdraco packs it; beside its corners each vertex has the double of them as numbers without a meaning.
std::string packedBox(const TriangleMesh& box, std::uint32_t& positions, std::uint32_t& doubles) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(box.triangles.size()));
  const int first = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int second = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 3, draco::DT_FLOAT32);
  for (std::size_t k = 0; k < box.triangles.size(); ++k) {
    for (const auto& [attribute, scale] : {std::pair(first, 1.0), std::pair(second, 2.0)}) {
      std::array<std::array<float, 3>, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 p = scale * box.vertices[box.triangles[k][i]];
        corners[i] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
      }
      builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(static_cast<std::uint32_t>(k)), corners[0].data(),
                                        corners[1].data(), corners[2].data());
    }
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  positions = mesh->attribute(first)->unique_id();
  doubles = mesh->attribute(second)->unique_id();
  draco::Encoder encoder;
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

double volumeOf(const UnpackedMesh& unpacked) {
  TriangleMesh mesh;
  for (std::size_t k = 0; k + 2 < unpacked.positions.size(); k += 3)
    mesh.vertices.emplace_back(unpacked.positions[k], unpacked.positions[k + 1], unpacked.positions[k + 2]);
  for (std::size_t k = 0; k + 2 < unpacked.triangles.size(); k += 3)
    mesh.triangles.push_back({unpacked.triangles[k], unpacked.triangles[k + 1], unpacked.triangles[k + 2]});
  return enclosedVolume(mesh);
}

TEST(DracoMesh, UnpacksWhatTheLibraryPacked) {
  std::uint32_t positions = 0, doubles = 0;
  const std::string bytes = packedBox(geometry::makeBox({1.0, 2.0, 3.0}), positions, doubles);
  const auto unpacked = unpackDraco(bytes, positions);
  ASSERT_TRUE(unpacked) << unpacked.error().message();
  EXPECT_EQ(unpacked->triangles.size(), 36u);
  EXPECT_NEAR(volumeOf(*unpacked), 6.0, 1e-6);
  const auto other = unpackDraco(bytes, doubles);
  ASSERT_TRUE(other) << other.error().message();
  EXPECT_NEAR(volumeOf(*other), 48.0, 1e-6) << "the attribute that is asked for";
  const auto unknown = unpackDraco(bytes, positions + doubles + 7);
  ASSERT_TRUE(unknown) << unknown.error().message();
  EXPECT_NEAR(volumeOf(*unknown), 6.0, 1e-6) << "else the one that the library calls positions";
  EXPECT_FALSE(unpackDraco(std::string_view(bytes).substr(0, bytes.size() / 2), positions));
  EXPECT_FALSE(unpackDraco("no draco", positions));
}

TEST(GltfFile, GivesTheNumbersBehindItsAccessors) {
  const TemporaryFolder folder;
  auto file = GltfFile::open(folder.write("box.gltf", test::gltfBox("")));
  ASSERT_TRUE(file) << file.error().message();
  const auto floats = file->floats(0, 3);
  ASSERT_TRUE(floats) << floats.error().message();
  EXPECT_EQ(*floats, test::boxFloats(1, 2, 3));
  const auto indices = file->indices(1);
  ASSERT_TRUE(indices);
  ASSERT_EQ(indices->size(), 36u);
  EXPECT_EQ((*indices)[1], 2u);
  EXPECT_EQ(file->view(1)->size(), 72u);
  EXPECT_FALSE(file->floats(9, 3)) << "no such accessor";
  EXPECT_FALSE(file->floats(0, 2)) << "another type";
  EXPECT_FALSE(file->view(9));
  const nlohmann::json object = {{"n", 4}, {"below", -1}, {"word", "w"}, {"list", {1, 2}}};
  EXPECT_EQ(gltfNumber(object, "n", 9), 4u);
  EXPECT_EQ(gltfNumber(object, "below", 9), 9u);
  EXPECT_EQ(gltfNumber(object, "none", 9), 9u);
  EXPECT_EQ(gltfText(object, "word"), "w");
  EXPECT_EQ(gltfText(object, "n"), "");
  EXPECT_EQ(gltfMember(object, "list").size(), 2u);
  EXPECT_TRUE(gltfMember(object, "word").empty());
  EXPECT_TRUE(gltfElement(gltfMember(object, "list"), 5).empty());
}

TEST(GltfFile, ComputesNormalizedAndSparseNumbers) {
  // Section 3.6.2.2: a signed byte c stands for max(c / 127, -1). Section 3.6.2.3: three zeros, of which one is set.
  const std::string bytes = test::bytesOf(std::vector<std::int8_t>{127, -127, -128, 0}) +
                            test::bytesOf(std::vector<std::uint16_t>{1}) + test::bytesOf(std::vector<float>{0.5f});
  const TemporaryFolder folder;
  auto file = GltfFile::open(folder.write(
      "a.gltf", R"({"accessors":[{"bufferView":0,"componentType":5120,"normalized":true,"count":4,"type":"SCALAR"},)"
                R"({"componentType":5126,"count":3,"type":"SCALAR","sparse":{"count":1,"indices":{"bufferView":1,)"
                R"("componentType":5123},"values":{"bufferView":2}}}],"bufferViews":[{"buffer":0,"byteLength":4},)"
                R"({"buffer":0,"byteOffset":4,"byteLength":2},{"buffer":0,"byteOffset":6,"byteLength":4}],"buffers":[)"
                R"({"byteLength":10,"uri":"data:;base64,)" +
                    test::base64(bytes) + R"("}]})"));
  ASSERT_TRUE(file) << file.error().message();
  const auto normalized = file->floats(0, 1);
  ASSERT_TRUE(normalized) << normalized.error().message();
  EXPECT_THAT(*normalized, ElementsAre(1.0f, -1.0f, -1.0f, 0.0f));
  const auto sparse = file->floats(1, 1);
  ASSERT_TRUE(sparse) << sparse.error().message();
  EXPECT_THAT(*sparse, ElementsAre(0.0f, 0.5f, 0.0f));
}

/// Of a mesh as assimp keeps it.
double volumeOf(const aiMesh& source) {
  TriangleMesh mesh;
  for (unsigned k = 0; k < source.mNumVertices; ++k)
    mesh.vertices.emplace_back(source.mVertices[k].x, source.mVertices[k].y, source.mVertices[k].z);
  for (unsigned k = 0; k < source.mNumFaces; ++k) {
    const unsigned* const corner = source.mFaces[k].mIndices;
    mesh.triangles.push_back({corner[0], corner[1], corner[2]});
  }
  return enclosedVolume(mesh);
}

TEST(GltfReader, MakesTheScene) {
  const TemporaryFolder folder;
  const auto read = readGltf(folder.write("box.gltf", test::gltfBox("")));
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->scene->mNumMeshes, 1u);
  EXPECT_EQ(read->scene->mMeshes[0]->mNumVertices, 8u);
  EXPECT_EQ(read->scene->mMeshes[0]->mNumFaces, 12u);
  EXPECT_NEAR(volumeOf(*read->scene->mMeshes[0]), 6.0, 1e-6);
  const auto refused = readGltf(folder.write("x.gltf", test::gltfBox(R"(,"extensionsRequired":["EXT_unknown"])")));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("EXT_unknown"));
}

TEST(AssimpReader, SaysWhichWayIsUpAndKeepsTheBox) {
  const TemporaryFolder folder;
  ParentEnds ends;
  ParentLink parent;
  Reading reading;
  reading.file = folder.write("box.gltf", test::gltfBox(""));
  const auto scene = readWithAssimp(reading, parent);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->format, "gltf");
  EXPECT_EQ(scene->up_axis, workcell::UpAxis::kY);
  ASSERT_EQ(scene->meshes.size(), 1u);
  EXPECT_NEAR(enclosedVolume(scene->meshes[0]), 6.0, 1e-6);
  reading.metres_per_unit = 0.5;  // Half the file's metre.
  const auto halved = readWithAssimp(reading, parent);
  ASSERT_TRUE(halved) << halved.error().message();
  EXPECT_NEAR(enclosedVolume(halved->meshes.at(0)), 6.0 / 8.0, 1e-6);
  reading.file = folder.write("bad.fbx", "rubbish");
  EXPECT_FALSE(readWithAssimp(reading, parent));
}

TEST(AssimpReader, AppliesScalesAndMirroringsToTheMeshes) {
  const TemporaryFolder folder;
  ParentEnds ends;
  ParentLink parent;
  test::ColladaParts parts;
  parts.asset = "<asset><unit name='inch' meter='0.0254'/><up_axis>Z_UP</up_axis></asset>";
  parts.nodes = "<node id='n' name='box'><translate>10 0 0</translate><scale>-2 1 1</scale><instance_geometry url='#g'/></node>";
  Reading reading;
  reading.file = folder.write("box.dae", test::colladaOf(parts));
  const auto scene = readWithAssimp(reading, parent);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->up_axis, workcell::UpAxis::kZ);
  EXPECT_DOUBLE_EQ(scene->metres_per_unit, 0.0254);
  ASSERT_EQ(scene->meshes.size(), 1u);
  EXPECT_NEAR(enclosedVolume(scene->meshes[0]), 2.0 * 6.0 * 0.0254 * 0.0254 * 0.0254, 1e-9) << "outside out again";
  const auto with_mesh =
      std::find_if(scene->nodes.begin(), scene->nodes.end(), [](const workcell::SceneNode& node) { return node.mesh == 0; });
  ASSERT_NE(with_mesh, scene->nodes.end());
  const Pose X_FN = workcell::nodePoses(*scene)[static_cast<std::size_t>(with_mesh - scene->nodes.begin())];
  geometry::Bounds bounds;
  for (const dvec3& vertex : scene->meshes[0].vertices) bounds.add(X_FN * vertex);
  EXPECT_LT(glm::distance(bounds.min, 0.0254 * dvec3(8, 0, 0)), 1e-6) << "from 10 units on 2 back";
  EXPECT_LT(glm::distance(bounds.max, 0.0254 * dvec3(10, 2, 3)), 1e-6);
}

/// What a 3MF file holds: two builds of a tetrahedron with edges of 10 along the axes, in inches.
fs::path threeMf(const TemporaryFolder& folder) {
  folder.write("content/_rels/.rels",
               R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
               R"(<Relationship Target="/3D/3dmodel.model" Id="rel0" )"
               R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)");
  folder.write("content/notes.txt", "for people");
  folder.write(
      "content/3D/3dmodel.model",
      R"(<?xml version="1.0"?><model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">)"
      R"(<resources><object id="1" type="model" name="wedge"><mesh><vertices><vertex x="0" y="0" z="0"/>)"
      R"(<vertex x="10" y="0" z="0"/><vertex x="0" y="10" z="0"/><vertex x="0" y="0" z="10"/></vertices><triangles>)"
      R"(<triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/>)"
      R"(<triangle v1="1" v2="2" v3="3"/></triangles></mesh></object></resources><build><item objectid="1"/>)"
      R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 1 5 6 7"/></build></model>)");
  const fs::path zip = folder.path() / "part.zip", file = folder.path() / "part.3mf";
  EXPECT_TRUE(workcell::writeArchive(folder.path() / "content", zip));
  fs::rename(zip, file);
  return file;
}

TEST(ModelPackage, KeepsTheModelsAsTheyStandInTheArchive) {
  const TemporaryFolder folder;
  const fs::path file = threeMf(folder);
  const auto package = unpackModel(file);
  ASSERT_TRUE(package) << package.error().message();
  EXPECT_EQ(package->parts.count("/notes.txt"), 0u);
  const std::unique_ptr<archive, ArchiveCloser> in(archive_read_new());
  archive_read_support_format_zip(in.get());
  ASSERT_EQ(archive_read_open_filename(in.get(), file.c_str(), 4096), ARCHIVE_OK);
  std::size_t seen = 0;
  for (archive_entry* entry = nullptr; archive_read_next_header(in.get(), &entry) == ARCHIVE_OK;) {
    const auto part = package->parts.find("/" + std::string(archive_entry_pathname(entry)));
    if (part == package->parts.end()) continue;
    std::string content(part->second.size() + 1, '\0');
    ASSERT_EQ(archive_read_data(in.get(), content.data(), content.size()), static_cast<la_ssize_t>(part->second.size()));
    content.pop_back();
    EXPECT_EQ(content, part->second);
    ++seen;
  }
  EXPECT_EQ(seen, package->parts.size());
  EXPECT_EQ(seen, 2u) << "the model and the relations";
  EXPECT_FALSE(unpackModel(folder.write("no.3mf", "no archive")));
}

TEST(ModelPackage, RefusesWhatLeadsOutOfTheArchive) {
  const TemporaryFolder folder;
  const auto zipWith = [&](const std::string& name, unsigned kind) {
    const fs::path file = folder.path() / "out.3mf";
    archive* const out = archive_write_new();
    archive_write_set_format_zip(out);
    archive_write_open_filename(out, file.c_str());
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_filetype(entry, kind);
    archive_entry_set_perm(entry, 0644);
    if (kind == AE_IFLNK) archive_entry_set_symlink(entry, "/etc/hostname");
    archive_entry_set_size(entry, kind == AE_IFLNK ? 0 : 2);
    archive_write_header(out, entry);
    if (kind == AE_IFREG) archive_write_data(out, "ab", 2);
    archive_entry_free(entry);
    archive_write_free(out);
    return file;
  };
  const auto inside = unpackModel(zipWith("3D/a.model", AE_IFREG));
  ASSERT_TRUE(inside) << inside.error().message();
  EXPECT_EQ(inside->parts.at("/3D/a.model"), "ab");
  for (const auto& refused : {unpackModel(zipWith("../a.model", AE_IFREG)), unpackModel(zipWith("/a.model", AE_IFREG)),
                              unpackModel(zipWith("3D/../../a.model", AE_IFREG)), unpackModel(zipWith("a.model", AE_IFLNK))}) {
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message(), HasSubstr("leads out of the archive"));
  }
}

TEST(ThreeMfReader, ReadsTheBuildInItsUnit) {
  const TemporaryFolder folder;
  const auto read = readThreeMf(threeMf(folder));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_DOUBLE_EQ(read->metres_per_unit, 0.0254);
  ASSERT_TRUE(read->model.scene);
  const aiScene& scene = *read->model.scene;
  ASSERT_EQ(scene.mNumMeshes, 1u) << "one mesh, built twice";
  EXPECT_EQ(scene.mMeshes[0]->mNumFaces, 4u);
  EXPECT_NEAR(volumeOf(*scene.mMeshes[0]), 1000.0 / 6.0, 1e-3) << "in its own unit";
  ASSERT_EQ(scene.mRootNode->mNumChildren, 2u);
  const aiMatrix4x4& placed = scene.mRootNode->mChildren[1]->mTransformation;
  EXPECT_THAT((std::array{placed.a4, placed.b4, placed.c4}), ElementsAre(5.0f, 6.0f, 7.0f));
}

}  // namespace
}  // namespace hapticell::importer
