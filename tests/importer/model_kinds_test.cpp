// SPDX-License-Identifier: Apache-2.0
// glTF, Collada, 3MF and STEP as other programs write them; expected places and volumes by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include "geometry/shapes/mass_properties.h"
#include "tests/importer/model_texts.h"
#include "tests/support/test_data.h"
#include "workcell/files/archive.h"
#include "workcell/files/scene_export.h"
#include "workcell/import/entity_source.h"
#include "workcell/scenes/import_scene.h"
#include "workcell/scenes/scene_batch.h"
#include "workcell/text/content_rules.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;

class ModelKinds : public ::testing::Test {
 protected:
  ImportedScene read(const std::string& name, const std::string& content, const ImportOptions& options = {}) {
    const auto scene = readScene(folder_.write(name, content), options, nullptr);
    EXPECT_TRUE(scene) << scene.error().message();
    return scene ? *scene : ImportedScene{};
  }
  std::string refusal(const std::string& name, const std::string& content) {
    const auto scene = readScene(folder_.write(name, content), {}, nullptr);
    return scene ? std::string() : scene.error().message();
  }
  ImportedScene package(const std::string& model, const std::string& other = "", const std::string& name = "") {
    return packageOf(model, other, name).value_or(ImportedScene{});
  }
  /// A 3MF file of a root model, perhaps with a second part.
  Expected<ImportedScene> packageOf(const std::string& model, const std::string& other, const std::string& name) {
    const fs::path content = folder_.path() / "content";
    fs::remove_all(content);
    folder_.write(
        "content/_rels/.rels",
        "<Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'><Relationship "
        "Target='/3D/3dmodel.model' Id='r' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/>"
        "</Relationships>");
    folder_.write("content/3D/3dmodel.model", model);
    if (!other.empty()) folder_.write("content/" + name, other);
    const fs::path zip = folder_.path() / "part.zip", file = folder_.path() / "part.3mf";
    EXPECT_TRUE(writeArchive(content, zip));
    fs::rename(zip, file);
    auto scene = readScene(file, {}, nullptr);
    EXPECT_TRUE(scene) << scene.error().message();
    return scene;
  }
  static geometry::Bounds boundsOf(const ImportedScene& scene) {
    geometry::Bounds bounds;
    const std::vector<Pose> X_F = nodePoses(scene);
    for (std::size_t k = 0; k < X_F.size(); ++k) {
      const int mesh = scene.nodes[k].mesh;
      if (mesh < 0) continue;
      for (const dvec3& v : scene.meshes[static_cast<std::size_t>(mesh)].vertices) bounds.add(X_F[k] * v);
    }
    return bounds;
  }
  static std::vector<double> volumesOf(const ImportedScene& scene) {
    std::vector<double> volumes;
    for (const SceneNode& node : scene.nodes) {
      if (node.mesh < 0) continue;
      geometry::TriangleMesh mesh = scene.meshes[static_cast<std::size_t>(node.mesh)];
      volumes.push_back(geometry::massProperties(mesh).volume);
    }
    return volumes;
  }
  static void expectBounds(const ImportedScene& scene, const dvec3& least, const dvec3& greatest,
                           double within = 1e-6) {
    const geometry::Bounds bounds = boundsOf(scene);
    EXPECT_LT(glm::distance(bounds.min, least), within) << bounds.min.x << " " << bounds.min.y << " " << bounds.min.z;
    EXPECT_LT(glm::distance(bounds.max, greatest), within)
        << bounds.max.x << " " << bounds.max.y << " " << bounds.max.z;
  }
  static bool hasNode(const ImportedScene& scene, const std::string& name) {
    return std::any_of(scene.nodes.begin(), scene.nodes.end(), [&](const SceneNode& n) { return n.name == name; });
  }

  test::TemporaryFolder folder_;
};

std::string gltfOf(const std::string& nodes, const std::string& accessors, const std::string& views,
                   const std::string& data, const std::string& primitive, const std::string& more = "",
                   std::string uri = "") {
  if (uri.empty()) uri = "data:application/octet-stream;base64," + test::base64(data);
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":)" + nodes + R"(,"meshes":[{"primitives":[)" +
         primitive + R"(]}],"accessors":)" + accessors + R"(,"bufferViews":)" + views +
         R"(,"buffers":[{"byteLength":)" + std::to_string(data.size()) + R"(,"uri":")" + uri + R"("}])" + more + "}";
}

constexpr const char* kPrimitive = R"({"attributes":{"POSITION":0},"indices":1})";

TEST_F(ModelKinds, QuantizedGltfIsMetres) {
  // Unsigned 16 bits, normalized, times 3; signed 16 bits times 0.01.
  std::vector<std::uint16_t> normalized;
  std::vector<std::int16_t> whole;
  for (const float f : test::boxFloats(1, 2, 3)) {
    normalized.push_back(static_cast<std::uint16_t>(std::lround(f / 3.0f * 65535.0f)));
    whole.push_back(static_cast<std::int16_t>(f * 100.0f));
  }
  const auto accessors = [](int kind, const char* more) {
    return R"([{"bufferView":0,"componentType":)" + std::to_string(kind) + R"(,"count":8,"type":"VEC3")" + more +
           R"(},{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}])";
  };
  const std::string views = R"([{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":72}])";
  const std::string required =
      R"(,"extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":["KHR_mesh_quantization"])";
  const auto shares =
      read("n.gltf", gltfOf(R"([{"mesh":0,"scale":[3,3,3]}])", accessors(5123, R"(,"normalized":true)"), views,
                            test::bytesOf(normalized) + test::boxIndices(), kPrimitive, required));
  expectBounds(shares, {0, -3, 0}, {1, 0, 2}, 1e-4);
  EXPECT_NEAR(volumesOf(shares).at(0), 6.0, 1e-3);
  const auto hundredths = read("i.gltf", gltfOf(R"([{"mesh":0,"scale":[0.01,0.01,0.01]}])", accessors(5122, ""), views,
                                                test::bytesOf(whole) + test::boxIndices(), kPrimitive, required));
  expectBounds(hundredths, {0, -3, 0}, {1, 0, 2}, 1e-6);
}

TEST_F(ModelKinds, InstancesOfGltfAreAllThere) {
  const std::vector<float> places = {0, 0, 0, 5, 0, 0, 0, 0, 7};
  const std::string data = test::bytesOf(test::boxFloats(1, 2, 3)) + test::boxIndices() + test::bytesOf(places);
  const auto scene = read(
      "a.gltf",
      gltfOf(R"([{"name":"bolt","mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":2}}}}])",
             R"([{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},{"bufferView":1,"componentType":5123,)"
             R"("count":36,"type":"SCALAR"},{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"}])",
             R"([{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72},)"
             R"({"buffer":0,"byteOffset":168,"byteLength":36}])",
             data, kPrimitive, R"(,"extensionsRequired":["EXT_mesh_gpu_instancing"])"));
  const std::vector<double> volumes = volumesOf(scene);
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), 18.0, 1e-5);
  expectBounds(scene, {0, -10, 0}, {6, 0, 2});
  EXPECT_TRUE(hasNode(scene, "bolt 2"));
}

TEST_F(ModelKinds, SparseAndStripedGltf) {
  // All zeros but for what the sparse part sets; a strip of four corners is two triangles.
  const std::vector<float> values = {1, 0, 0, 0, 1, 0, 1, 1, 0};
  const std::vector<std::uint16_t> places = {1, 2, 3};
  const std::string data = test::bytesOf(values) + test::bytesOf(places) + std::string(2, '\0');
  const auto scene =
      read("s.gltf",
           gltfOf(R"([{"mesh":0}])",
                  R"([{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":3,"indices":{"bufferView":1,)"
                  R"("componentType":5123},"values":{"bufferView":0}}}])",
                  R"([{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}])", data,
                  R"({"attributes":{"POSITION":0},"mode":5})"));
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 2u);
  expectBounds(scene, {0, 0, 0}, {1, 0, 1});
}

/// A box of 1 x 2 x 3 m, packed by libdraco with 14 bits a coordinate.
TEST_F(ModelKinds, DracoMeshesAreUnpacked) {
  const std::string packed =
      "RFJBQ08CAgEBAAAACAwACwAAA2+rFAEBEAH/AAABAAkDAAACAQEBAA8DASABECsBEAQAjBSEBABWVQAAVFVTVQAAAAEAAAAA/"
      "z8AAAAAAAAAAAAAAAAA"
      "AAAAQEAO";
  const auto text = [&](const std::string& data) {
    return R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"],"scenes":[{"nodes":[0]}],)"
           R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"extensions":)"
           R"({"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0}}}}]}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":93}],"buffers":[{"byteLength":93,)"
           R"("uri":"data:application/octet-stream;base64,)" +
           data + R"("}]})";
  };
  const auto scene = read("a.gltf", text(packed));
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 12u);
  EXPECT_NEAR(volumesOf(scene).at(0), 6.0, 1e-2);
  expectBounds(scene, {0, -3, 0}, {1, 0, 2}, 1e-3);
  EXPECT_THAT(refusal("b.gltf", text(std::string(124, 'A'))), HasSubstr("KHR_draco"));
}

TEST_F(ModelKinds, BuffersWithBlanksAndUmlautsInTheirNames) {
  const std::string data = test::bytesOf(test::boxFloats(1, 2, 3)) + test::boxIndices();
  folder_.write("my data.bin", data);
  folder_.write("geh\xC3\xA4use.bin", data);
  for (const char* uri : {"my%20data.bin", "geh%C3%A4use.bin", "my data.bin"}) {
    const auto scene =
        read("a.gltf", gltfOf(R"([{"mesh":0}])",
                              R"([{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
                              R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}])",
                              R"([{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}])", data,
                              kPrimitive, "", uri));
    EXPECT_NEAR(volumesOf(scene).at(0), 6.0, 1e-6) << uri;
  }
  EXPECT_THAT(refusal("b.gltf", gltfOf("[{}]", "[]", "[]", data, kPrimitive, "", "none.bin")), HasSubstr("none.bin"));
}

TEST_F(ModelKinds, CamerasAndLightsOfOneNamePlayNoPart) {
  const auto gltf = read("a.gltf", test::gltfBox(R"(,"cameras":[{"type":"perspective","name":"c","perspective":)"
                                                 R"({"yfov":1,"znear":0.1}},{"type":"perspective","name":"c",)"
                                                 R"("perspective":{"yfov":1,"znear":0.1}}])"));
  EXPECT_NEAR(volumesOf(gltf).at(0), 6.0, 1e-6);
  test::ColladaParts parts;
  const std::string camera =
      "<optics><technique_common><perspective><yfov>1</yfov><znear>1</znear><zfar>9</zfar>"
      "</perspective></technique_common></optics>";
  parts.libraries = "<library_cameras><camera id='c1' name='c'>" + camera + "</camera><camera id='c2' name='c'>" +
                    camera + "</camera></library_cameras>";
  parts.nodes +=
      "<node id='k1' name='Camera'><instance_camera url='#c1'/></node><node id='k2' name='Camera'>"
      "<instance_camera url='#c2'/></node>";
  EXPECT_NEAR(volumesOf(read("a.dae", test::colladaOf(parts))).at(0), 6.0, 1e-6);
}

TEST_F(ModelKinds, ColladaGivesNamesBeforeIds) {
  test::ColladaParts parts;
  parts.nodes =
      "<node id='ID3' name='Conveyor belt'><node id='ID4' name='Motor'><instance_geometry url='#g'/></node>"
      "<node id='only_id'><instance_geometry url='#g'/></node></node>";
  const auto scene = read("a.dae", test::colladaOf(parts));
  for (const char* name : {"Conveyor belt", "Motor", "only_id"}) EXPECT_TRUE(hasNode(scene, name)) << name;
  EXPECT_FALSE(hasNode(scene, "ID3"));
}

TEST_F(ModelKinds, ColladaInOtherWordsThanAssimpTakes) {
  test::ColladaParts parts;
  parts.effect_color = "\n 1 0 0 1 ";
  EXPECT_NEAR(volumesOf(read("color.dae", test::colladaOf(parts))).at(0), 6.0, 1e-6);
  parts = {};
  parts.nodes = "<node id='n' name='box'><instance_geometry url='#g'/><instance_geometry url='#g'/></node>";
  EXPECT_EQ(volumesOf(read("twice.dae", test::colladaOf(parts))).size(), 2u);
  // A square of 4 x 4 with a hole of 2 x 2: 12 m2.
  parts = {};
  parts.geometries =
      "<geometry id='h' name='plate'><mesh><source id='hp'><float_array id='ha' count='24'>0 0 0 4 0 0 4 4 0 0 4 0 1 1 "
      "0 "
      "3 1 0 3 3 0 1 3 0</float_array><technique_common><accessor source='#ha' count='8' stride='3'><param name='X' "
      "type='float'/><param name='Y' type='float'/><param name='Z' "
      "type='float'/></accessor></technique_common></source>"
      "<vertices id='hv'><input semantic='POSITION' source='#hp'/></vertices><polygons count='1'><input "
      "semantic='VERTEX' "
      "source='#hv' offset='0'/><ph><p>0 1 2 3</p><h>4 5 6 7</h></ph></polygons></mesh></geometry>";
  parts.nodes = "<node id='n' name='plate'><instance_geometry url='#h'/></node>";
  const auto plate = read("hole.dae", test::colladaOf(parts));
  ASSERT_EQ(plate.meshes.size(), 1u);
  double area = 0.0;
  for (const auto& t : plate.meshes[0].triangles) {
    const auto& v = plate.meshes[0].vertices;
    area += 0.5 * glm::length(glm::cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]));
  }
  EXPECT_NEAR(area, 12.0, 1e-5);
}

TEST_F(ModelKinds, TheHeadOfColladaIsReadAsXml) {
  ImportOptions millimetres;
  millimetres.metres_per_unit = 1e-3;
  std::vector<fs::path> files;
  for (const std::string& asset :
       {std::string("<asset><unit meter = '0.001' name='millimeter'/><up_axis> Z_UP\n</up_axis></asset>"),
        std::string("<asset><contributor><comments>") + std::string(80000, 'x') +
            "</comments></contributor><unit meter=\"0.001\"/><up_axis>Z_UP</up_axis></asset>",
        std::string("<asset><!-- <unit meter=\"1\"/><up_axis>X_UP</up_axis> --><unit meter='0.001'/><up_axis>Z_UP"
                    "</up_axis></asset>")}) {
    test::ColladaParts parts;
    parts.asset = asset;
    files.push_back(folder_.write(std::to_string(files.size()) + ".dae", test::colladaOf(parts)));
  }
  for (const ImportOptions& options : {ImportOptions{}, millimetres}) {
    SceneBatch scenes(options);
    scenes.readAhead(files);  // One start of the importer.
    for (const fs::path& file : files) {
      const auto scene = scenes.scene(file);
      ASSERT_TRUE(scene) << scene.error().message();
      EXPECT_TRUE(scene->unit_is_stated);
      EXPECT_EQ(scene->up_axis, UpAxis::kZ);
      expectBounds(*scene, {0, 0, 0}, {0.001, 0.002, 0.003}, 1e-9);
    }
  }
}

constexpr const char* kCore = "xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'";
constexpr const char* kProduction =
    "xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06' requiredextensions='p'";

std::string object(int id, const std::string& more, double size) {
  std::string text = "<object id='" + std::to_string(id) + "' " + more + "><mesh><vertices>";
  const std::vector<float> p = test::boxFloats(1, 2, 3);
  for (std::size_t k = 0; k < p.size(); k += 3) {
    const auto number = [&](std::size_t i) { return std::to_string(static_cast<double>(p[k + i]) * size); };
    text += "<vertex x='" + number(0) + "' y='" + number(1) + "' z='" + number(2) + "'/>";
  }
  text += "</vertices><triangles>";
  const std::string indices = test::boxIndices();
  for (std::size_t k = 0; k + 6 <= indices.size(); k += 6) {
    const auto corner = [&](std::size_t i) { return std::to_string(static_cast<int>(indices[k + 2 * i])); };
    text += "<triangle v1='" + corner(0) + "' v2='" + corner(1) + "' v3='" + corner(2) + "'/>";
  }
  return text + "</triangles></mesh></object>";
}

std::string model(const std::string& head, const std::string& resources, const std::string& build) {
  return "<?xml version='1.0'?><model " + head + " " + kCore + "><resources>" + resources + "</resources><build>" +
         build + "</build></model>";
}

TEST_F(ModelKinds, PartsOfOtherModelsInA3mf) {
  const std::string component =
      "<object id='8' name='assembly'><components><component p:path='/3D/Objects/o.model' "
      "objectid='1'/></components></object>";
  const std::string moved = "<item objectid='8' transform='1 0 0 0 1 0 0 0 1 128 128 0'/>";
  const auto one =
      package(model(kProduction, component, moved), model("", object(1, "", 1.0), ""), "3D/Objects/o.model");
  expectBounds(one, {0.128, 0.128, 0}, {0.129, 0.130, 0.003}, 1e-7);
  // The same number in both parts: each is its own.
  const auto clash =
      package(model(kProduction, object(1, "name='block'", 1.0) + component, "<item objectid='1'/>" + moved),
              model("", object(1, "", 10.0), ""), "3D/Objects/o.model");
  std::vector<double> volumes = volumesOf(clash);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0], 6e-9, 1e-13);
  EXPECT_NEAR(volumes[1], 6000e-9, 1e-9);
  EXPECT_TRUE(hasNode(clash, "block"));
  EXPECT_TRUE(hasNode(clash, "assembly"));
}

TEST_F(ModelKinds, TheUnitOfA3mfHoweverItIsWritten) {
  const std::string build = "<item objectid='1'/>";
  for (const std::string& text :
       {model("unit='inch'", object(1, "", 1.0), build), model("unit = \"inch\"", object(1, "", 1.0), build),
        model(std::string("xml:lang='en' ") + kProduction + " unit='inch'", object(1, "", 1.0), build),
        "<!-- <model unit='meter'> -->" + model("unit='inch'", object(1, "", 1.0), build).substr(21),
        "<!--" + std::string(9000, ' ') + "-->" + model("unit='inch'", object(1, "", 1.0), build).substr(21)}) {
    const auto scene = package(text, model("", object(5, "", 1.0), ""), "3D/Objects/zz.model");
    EXPECT_DOUBLE_EQ(scene.metres_per_unit, 0.0254);
    expectBounds(scene, {0, 0, 0}, {0.0254, 0.0508, 0.0762}, 1e-7);
  }
}

TEST_F(ModelKinds, ColorsAndRequiredExtensionsOfA3mf) {
  const std::string materials =
      "<basematerials id='5'><base name='a' displaycolor='#00FF00'/><base name='b' "
      "displaycolor='#FF0000FF'/></basematerials>";
  const auto red = package(model("", materials + object(1, "pid='5' pindex='1'", 1.0), "<item objectid='1'/>"));
  for (const SceneNode& node : red.nodes) {
    if (node.mesh < 0) continue;
    EXPECT_EQ(node.color, (std::array<float, 3>{1.0f, 0.0f, 0.0f}));
  }
  const fs::path content = folder_.path() / "content";
  folder_.write(
      "content/3D/3dmodel.model",
      model("xmlns:b='http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02' requiredextensions='b'",
            object(1, "", 1.0), "<item objectid='1'/>"));
  ASSERT_TRUE(writeArchive(content, folder_.path() / "lattice.zip"));
  fs::rename(folder_.path() / "lattice.zip", folder_.path() / "lattice.3mf");
  const auto refused = readScene(folder_.path() / "lattice.3mf", {}, nullptr);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("beamlattice"));
}

TEST_F(ModelKinds, EveryElementOfA3mfIsTreatedAsListed) {
  std::string inside, in_mesh;
  std::vector<std::string> reported;
  for (const FormatRules& format : contentRules()) {
    if (format.format != "3MF") continue;
    for (const ContentRule& rule : format.rules) {
      const std::string element = "<x:" + std::string(rule.element) + "/>";
      if (rule.treatment == Treatment::kReported) reported.emplace_back(rule.element);
      if (rule.treatment == Treatment::kReported || rule.treatment == Treatment::kNoted)
        (rule.element == "beamlattice" || rule.element == "trianglesets" ? in_mesh : inside) += element;
    }
  }
  ASSERT_GE(reported.size(), 5u);
  std::string box = object(1, "name='box'", 1.0);
  box.insert(box.find("</mesh>"), in_mesh);
  box.insert(box.find("</object>"), inside);
  const auto scene = package(model("xmlns:x='http://schemas.example/all'", box, "<item objectid='1'/>"));
  EXPECT_EQ(scene.warnings.size(), reported.size());
  for (const std::string& element : reported) {
    const bool told = std::any_of(scene.warnings.begin(), scene.warnings.end(), [&](const Text& warning) {
      return english(warning).find(element) != std::string::npos && english(warning).find("'box'") != std::string::npos;
    });
    EXPECT_TRUE(told) << element;
  }
}

/// A STEP file of one box, called `name` in whatever bytes.
std::string stepOf(const std::string& name) {
  test::TemporaryFolder folder;
  ImportedScene scene;
  SceneNode node;
  node.name = "NAME_OF_BOX";
  node.mesh = 0;
  scene.nodes.push_back(node);
  scene.meshes.emplace_back();
  const std::vector<float> p = test::boxFloats(0.01f, 0.02f, 0.03f);
  for (std::size_t k = 0; k < p.size(); k += 3) scene.meshes[0].vertices.emplace_back(p[k], p[k + 1], p[k + 2]);
  const std::string indices = test::boxIndices();
  for (std::size_t k = 0; k + 6 <= indices.size(); k += 6) {
    const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(indices[k + 2 * i]); };
    scene.meshes[0].triangles.push_back({corner(0), corner(1), corner(2)});
  }
  Diagnostics notes;
  const fs::path file = folder.path() / "box.step";
  EXPECT_TRUE(exportScene(scene, file, {}, notes));
  std::string text = readFileContent(file).value_or("");
  for (std::size_t at = text.find(node.name); at != std::string::npos; at = text.find(node.name, at + 1)) {
    text.replace(at, node.name.size(), name);
  }
  return text;
}

TEST_F(ModelKinds, RawBytesInStepNamesAreGuessedAndTold) {
  struct Written {
    const char *bytes, *name, *told;
  };
  std::vector<Written> all;
  std::vector<fs::path> files;
  for (const Written& w :
       {Written{"Geh\xE4use", "Geh\xC3\xA4use", "Latin-1"},
        Written{"Gr\xF6\xDF"
                "e",
                "Gr\xC3\xB6\xC3\x9F"
                "e",
                "Latin-1"},
        Written{"\xCD\xE2\xBF\xC7", "\xE5\xA4\x96\xE5\xA3\xB3", "GB 18030"},
        Written{"\x95\x94\x95\x69", "\xE9\x83\xA8\xE5\x93\x81", "Shift-JIS"},
        Written{"\xE2\x9E\x91\xCC\x95\x94\x95\x69", "\xE7\xAD\x90\xE4\xBD\x93\xE9\x83\xA8\xE5\x93\x81", "Shift-JIS"},
        Written{"Geh\xC3\xA4use", "Geh\xC3\xA4use", ""}}) {
    all.push_back(w);
    files.push_back(folder_.write(std::to_string(all.size()) + ".step", stepOf(w.bytes)));
  }
  SceneBatch scenes{ImportOptions()};
  scenes.readAhead(files);  // One start of the importer.
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Written& w = all[k];
    const auto read_ahead = scenes.scene(files[k]);
    ASSERT_TRUE(read_ahead) << read_ahead.error().message();
    const ImportedScene& scene = *read_ahead;
    const bool told = std::any_of(scene.warnings.begin(), scene.warnings.end(), [&](const Text& warning) {
      return *w.told != '\0' && english(warning).find(w.told) != std::string::npos;
    });
    EXPECT_EQ(told, *w.told != '\0') << w.name;
    EXPECT_TRUE(hasNode(scene, w.name)) << w.name;
  }
}

TEST_F(ModelKinds, WhatAStepFileHoldsBesideItsShapesIsTreatedAsListed) {
  const auto with = [](const std::string& entities, const std::string& name = "box") {
    std::string text = stepOf(name);
    return text.insert(text.rfind("ENDSEC;"), entities);
  };
  const auto plain = read("a.step", stepOf("box"));
  EXPECT_TRUE(plain.warnings.empty());
  // Manufacturing information, layers and properties are passed over.
  const auto silent = read("a.step", with("#90001=PRESENTATION_LAYER_ASSIGNMENT('l','',(#1));\n"
                                          "#90002=DESCRIPTIVE_REPRESENTATION_ITEM('material','steel');\n"
                                          "#90003=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.),#1);\n"));
  EXPECT_TRUE(silent.warnings.empty()) << english(silent.warnings.front());
  const auto told =
      read("a.step", with("#90004=TESSELLATED_SOLID('',(#1),$);\n#90005=KINEMATIC_JOINT('',#1,#1);\n", "Geh\xE4use"));
  for (const char* words : {"Latin-1", "tessellated", "joints"}) {
    const bool is_told = std::any_of(told.warnings.begin(), told.warnings.end(), [&](const Text& warning) {
      return english(warning).find(words) != std::string::npos;
    });
    EXPECT_TRUE(is_told) << words;
  }
  EXPECT_EQ(told.warnings.size(), 3u);
  expectBounds(told, {0, 0, 0}, {0.01, 0.02, 0.03}, 1e-7);
}

TEST_F(ModelKinds, AProductWhoseNameSaysNothingIsCalledAsItsFile) {
  for (const char* product : {"Document", "unnamed", "UNNAMED", "Unnamed1", "the product name", "-", "Untitled 2"}) {
    const auto scene = read("bracket.step", stepOf(product));
    EXPECT_TRUE(hasNode(scene, "bracket")) << product;
    EXPECT_FALSE(hasNode(scene, product)) << product;
    ASSERT_EQ(scene.warnings.size(), 1u) << product;
    EXPECT_THAT(english(scene.warnings.front()), HasSubstr("'bracket', is assumed")) << product;
  }
  for (const char* product : {"", "NONE", "Open CASCADE STEP translator 7.6 1"})
    EXPECT_TRUE(hasNode(read("bracket.step", stepOf(product)), "bracket")) << product;
  for (const char* product : {"Documentation tray", "4711", "Default bracket"})
    EXPECT_TRUE(hasNode(read("bracket.step", stepOf(product)), product)) << product;
  // One that the user called so keeps its name in our own files.
  auto own = read("own.step", stepOf("box"));
  own.nodes.at(0).name = "Document";
  Diagnostics notes;
  ASSERT_TRUE(exportScene(own, folder_.path() / "bracket.step", {}, notes));
  const auto again = readScene(folder_.path() / "bracket.step", {}, nullptr);
  ASSERT_TRUE(again);
  EXPECT_TRUE(hasNode(*again, "Document"));
  EXPECT_TRUE(again->warnings.empty());
}

TEST_F(ModelKinds, ADocumentFindsAPartBelowATopWhoseNameSaidNothing) {
  auto scene = read("box.step", stepOf("a"));
  SceneNode other = scene.nodes.at(0), top;
  top.name = "NAME_OF_TOP";
  other.name = "b";
  other.X_PN = Pose::translation({0.1, 0.0, 0.0});
  scene.nodes = {top, scene.nodes.at(0), other};
  scene.nodes[1].parent = scene.nodes[2].parent = 0;
  Diagnostics notes;
  ASSERT_TRUE(exportScene(scene, folder_.path() / "two.step", {}, notes));
  std::string text = readFileContent(folder_.path() / "two.step").value_or("");
  for (std::size_t at = text.find(top.name); at != std::string::npos; at = text.find(top.name, at + 1))
    text.replace(at, top.name.size(), "Document");
  const fs::path file = folder_.write("tray.step", text);
  SourceFile source;
  source.path = file.string();
  EntityLoader loader(folder_.path());
  for (const char* part : {"tray/b", "Document/b"}) {  // As it is now, and as release 0.2 wrote it.
    source.part = part;
    const auto found = loader.loadSource(source, notes);
    ASSERT_TRUE(found) << part << ": " << found.error().message();
    EXPECT_EQ(found->source.part, "tray/b");
  }
  source.part = "Bracket/b";
  EXPECT_FALSE(loader.loadSource(source, notes)) << "another name is another part";
}

TEST_F(ModelKinds, StepBehindAMarkACommentOrPacked) {
  const std::string step = stepOf("box");
  for (const std::string& text : {"\xEF\xBB\xBF" + step, "/*" + std::string(5000, '*') + " made by */\n" + step}) {
    expectBounds(read("a.step", text), {0, 0, 0}, {0.01, 0.02, 0.03}, 1e-7);
  }
  folder_.write("packed/a.stp", step);
  ASSERT_TRUE(writeArchive(folder_.path() / "packed", folder_.path() / "a.zip"));
  fs::rename(folder_.path() / "a.zip", folder_.path() / "a.stpz");
  const auto packed = readScene(folder_.path() / "a.stpz", {}, nullptr);
  ASSERT_TRUE(packed) << packed.error().message();
  expectBounds(*packed, {0, 0, 0}, {0.01, 0.02, 0.03}, 1e-7);
  EXPECT_THAT(refusal("b.stpz", "nothing of the kind"), HasSubstr("b.stpz"));
  EXPECT_THAT(refusal("t.step",
                      "ISO-10303-21;HEADER;ENDSEC;DATA;#1=TESSELLATED_SOLID('',(#2),$);ENDSEC;"
                      "END-ISO-10303-21;"),
              HasSubstr("tessellated"));
}

}  // namespace
}  // namespace hapticell::workcell
