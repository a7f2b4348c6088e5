// SPDX-License-Identifier: Apache-2.0
#include "bridge/foxglove/scene_message.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/foxglove/cell_view.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::bridge {
namespace {

using nlohmann::json;

/// Decodes by the table's definition (RFC 4648), not by what encoded it.
std::string decoded(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<unsigned>(letters.find(letter));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255u);
  }
  return bytes;
}

/// Every member of `value` must be in the schema, with its type, and the other way round.
void expectFits(const json& value, const json& schema, const std::string& place) {
  const std::string type = schema.at("type");
  if (type == "object") {
    ASSERT_TRUE(value.is_object()) << place;
    for (const auto& [name, member] : value.items()) {
      ASSERT_TRUE(schema.at("properties").contains(name)) << place << "." << name;
      expectFits(member, schema["properties"][name], place + "." + name);
    }
    for (const auto& [name, member] : schema.at("properties").items()) EXPECT_TRUE(value.contains(name)) << place << "." << name;
  } else if (type == "array") {
    ASSERT_TRUE(value.is_array()) << place;
    for (const auto& item : value) expectFits(item, schema.at("items"), place + "[]");
  } else {
    EXPECT_TRUE((type == "number" && value.is_number()) || (type == "integer" && value.is_number_integer()) ||
                (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()))
        << place << " is no " << type;
  }
}

TEST(SceneMessage, AModelHasTheShapesPlaced) {
  const geometry::TriangleMesh box = geometry::makeBox({0.2, 0.3, 0.4});
  const std::vector<SceneShape> shapes = {{&box, Pose{{1.0, 2.0, 3.0}}, {1.0f, 0.0f, 0.0f}}, {&box, {}, {0.0f, 1.0f, 0.0f}}};
  const json message = json::parse(modelMessage("arm", "arm/link", shapes, 5'000'000'007));
  expectFits(message, json::parse(sceneSchema()), "message");
  const json& entity = message["entities"][0];
  EXPECT_EQ(entity["timestamp"], (json{{"sec", 5}, {"nsec", 7}}));
  EXPECT_EQ(entity["frame_id"], "arm/link");
  EXPECT_TRUE(entity["frame_locked"]);
  const std::string glb = decoded(entity["models"][0]["data"]);
  ASSERT_GT(glb.size(), 20u);
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  std::uint32_t length = 0, text_length = 0;
  std::memcpy(&length, glb.data() + 8, 4);
  std::memcpy(&text_length, glb.data() + 12, 4);
  EXPECT_EQ(length, glb.size());
  const json gltf = json::parse(glb.substr(20, text_length));
  EXPECT_EQ(gltf["nodes"].size(), 2u);
  // Viewers turn glTF's y up: (x, y, z) of ours is (x, z, -y) there.
  const std::vector<double> turned = gltf["nodes"][0]["translation"];
  EXPECT_NEAR(turned.at(0), 1.0, 1e-12);
  EXPECT_NEAR(turned.at(1), 3.0, 1e-12);
  EXPECT_NEAR(turned.at(2), -2.0, 1e-12);
}

TEST(SceneMessage, PointsAndDeletionsFitTheSchema) {
  const json schema = json::parse(sceneSchema());
  const std::vector<ScenePoint> points = {{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.01}, false}, {{1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, true}};
  const json drawn = json::parse(pointsMessage("world", points, 1));
  expectFits(drawn, schema, "points");
  EXPECT_EQ(drawn["entities"][0]["lines"][0]["points"].size(), 4u);
  EXPECT_EQ(drawn["entities"][0]["lines"][0]["colors"].size(), 4u);
  EXPECT_EQ(drawn["entities"][0]["spheres"].size(), 1u);
  const json none = json::parse(pointsMessage("world", {}, 1));
  expectFits(none, schema, "no points");
  EXPECT_TRUE(none["entities"][0]["lines"].empty());
  const json gone = json::parse(deletionMessage("arm", 1));
  expectFits(gone, schema, "deletion");
  EXPECT_EQ(gone["deletions"][0]["id"], "arm");
  expectFits(json::parse(logMessage("It touches.", 1)), json::parse(logSchema()), "log");
}

TEST(SceneMessage, NamesThatAreNoUtf8AreSentAllTheSame) {
  const json message = json::parse(deletionMessage("bad \xff name", 1), nullptr, false);
  EXPECT_FALSE(message.is_discarded());
}

TEST(CellView, ItsStampsAreThisCentury) {
  constexpr std::int64_t kYear2026 = 1'767'225'600'000'000'000;
  EXPECT_GT(nowForViewers(), kYear2026);
}

}  // namespace
}  // namespace hapticell::bridge
