// SPDX-License-Identifier: Apache-2.0
#include "bridge/foxglove/scene_message.h"

#include <nlohmann/json.hpp>

#include "workcell/scenes/gltf_writer.h"
#include "workcell/text/base64.h"

namespace hapticell::bridge {

namespace {

using nlohmann::ordered_json;

ordered_json timeOf(std::int64_t stamp_ns) {
  return {{"sec", stamp_ns / 1'000'000'000}, {"nsec", stamp_ns % 1'000'000'000}};
}

ordered_json vectorOf(const dvec3& v) {
  return {{"x", v.x}, {"y", v.y}, {"z", v.z}};
}

ordered_json poseOf(const Pose& pose) {
  return {{"position", vectorOf(pose.p)},
          {"orientation", {{"x", pose.q.x}, {"y", pose.q.y}, {"z", pose.q.z}, {"w", pose.q.w}}}};
}

ordered_json colorOf(double r, double g, double b) {
  return {{"r", r}, {"g", g}, {"b", b}, {"a", 1.0}};
}

std::string glbOf(std::span<const SceneShape> shapes) {
  workcell::ImportedScene scene;
  for (const SceneShape& shape : shapes) {
    workcell::SceneNode node;
    node.name = "part " + std::to_string(scene.nodes.size() + 1);
    node.X_PN = shape.X_FS;
    node.mesh = static_cast<int>(scene.meshes.size());
    node.color = shape.color;
    scene.nodes.push_back(std::move(node));
    scene.meshes.push_back(*shape.mesh);
  }
  return workcell::gltfBytes(scene, true);
}

ordered_json entityOf(const std::string& id, const std::string& frame, std::int64_t stamp_ns) {
  return {{"timestamp", timeOf(stamp_ns)}, {"frame_id", frame}, {"id", id},
          {"lifetime", timeOf(0)},         {"frame_locked", true}, {"metadata", ordered_json::array()}};
}

std::string updateOf(ordered_json entity) {
  for (const char* list : {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"})
    if (!entity.contains(list)) entity[list] = ordered_json::array();
  return ordered_json{{"deletions", ordered_json::array()}, {"entities", ordered_json::array({std::move(entity)})}}.dump(
      -1, ' ', false, ordered_json::error_handler_t::replace);
}

// Pieces of JSON schemas.

ordered_json object(ordered_json properties) {
  return {{"type", "object"}, {"properties", std::move(properties)}};
}

ordered_json listOf(ordered_json items) {
  return {{"type", "array"}, {"items", std::move(items)}};
}

const ordered_json kNumber = {{"type", "number"}}, kText = {{"type", "string"}}, kTruth = {{"type", "boolean"}};

ordered_json wholeNumber() {
  return {{"type", "integer"}};
}

ordered_json timeSchema() {
  return object({{"sec", wholeNumber()}, {"nsec", wholeNumber()}});
}

ordered_json vectorSchema() {
  return object({{"x", kNumber}, {"y", kNumber}, {"z", kNumber}});
}

ordered_json poseSchema() {
  return object({{"position", vectorSchema()},
                 {"orientation", object({{"x", kNumber}, {"y", kNumber}, {"z", kNumber}, {"w", kNumber}})}});
}

ordered_json colorSchema() {
  return object({{"r", kNumber}, {"g", kNumber}, {"b", kNumber}, {"a", kNumber}});
}

ordered_json modelSchema() {
  return object({{"pose", poseSchema()}, {"scale", vectorSchema()}, {"color", colorSchema()}, {"override_color", kTruth},
                 {"url", kText}, {"media_type", kText},
                 {"data", {{"type", "string"}, {"contentEncoding", "base64"}}}});
}

ordered_json lineSchema() {
  return object({{"type", wholeNumber()}, {"pose", poseSchema()}, {"thickness", kNumber}, {"scale_invariant", kTruth},
                 {"points", listOf(vectorSchema())}, {"color", colorSchema()}, {"colors", listOf(colorSchema())},
                 {"indices", listOf(wholeNumber())}});
}

ordered_json sphereSchema() {
  return object({{"pose", poseSchema()}, {"size", vectorSchema()}, {"color", colorSchema()}});
}

std::string titled(const char* title, ordered_json schema) {
  schema["title"] = title;
  return schema.dump();
}

}  // namespace

std::string modelMessage(const std::string& id, const std::string& frame, std::span<const SceneShape> shapes,
                         std::int64_t stamp_ns) {
  ordered_json entity = entityOf(id, frame, stamp_ns);
  entity["models"] = ordered_json::array({{{"pose", poseOf({})},
                                           {"scale", vectorOf(dvec3(1.0))},
                                           {"color", colorOf(1.0, 1.0, 1.0)},
                                           {"override_color", false},
                                           {"url", ""},
                                           {"media_type", "model/gltf-binary"},
                                           {"data", workcell::base64(glbOf(shapes))}}});
  return updateOf(std::move(entity));
}

std::string deletionMessage(const std::string& id, std::int64_t stamp_ns) {
  constexpr int kMatchingId = 0;
  return ordered_json{{"deletions", ordered_json::array({{{"timestamp", timeOf(stamp_ns)}, {"type", kMatchingId}, {"id", id}}})},
                      {"entities", ordered_json::array()}}
      .dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string pointsMessage(const std::string& frame, std::span<const ScenePoint> points, std::int64_t stamp_ns) {
  constexpr int kLineList = 2;
  // Metres: seen beside a robot. Half: hardly seen; twice: hides small parts.
  constexpr double kBall = 0.008;
  ordered_json entity = entityOf("contacts", frame, stamp_ns);
  ordered_json ends = ordered_json::array(), colors = ordered_json::array(), balls = ordered_json::array();
  for (const ScenePoint& point : points) {
    const ordered_json color = point.contact ? colorOf(0.9, 0.1, 0.1) : colorOf(0.95, 0.6, 0.1);
    for (const dvec3& end : {point.p_WA, point.p_WB}) {
      ends.push_back(vectorOf(end));
      colors.push_back(color);
    }
    if (point.contact)
      balls.push_back({{"pose", poseOf(Pose{0.5 * (point.p_WA + point.p_WB)})}, {"size", vectorOf(dvec3(kBall))}, {"color", color}});
  }
  entity["spheres"] = std::move(balls);
  if (!ends.empty())
    entity["lines"] = ordered_json::array({{{"type", kLineList}, {"pose", poseOf({})}, {"thickness", 2.0}, {"scale_invariant", true},
                                            {"points", std::move(ends)}, {"color", colorOf(1.0, 1.0, 1.0)},
                                            {"colors", std::move(colors)}, {"indices", ordered_json::array()}}});
  return updateOf(std::move(entity));
}

std::string logMessage(const std::string& words, std::int64_t stamp_ns) {
  constexpr int kInfo = 2;
  return ordered_json{{"timestamp", timeOf(stamp_ns)}, {"level", kInfo}, {"message", words}, {"name", "HaptiCell"}, {"file", ""}, {"line", 0}}
      .dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string sceneSchema() {
  const ordered_json any = listOf(object(ordered_json::object()));
  ordered_json entity{{"timestamp", timeSchema()}, {"frame_id", kText}, {"id", kText}, {"lifetime", timeSchema()},
                      {"frame_locked", kTruth}, {"metadata", listOf(object({{"key", kText}, {"value", kText}}))},
                      {"arrows", any}, {"cubes", any}, {"spheres", listOf(sphereSchema())}, {"cylinders", any},
                      {"lines", listOf(lineSchema())}, {"triangles", any}, {"texts", any}, {"models", listOf(modelSchema())}};
  return titled("foxglove.SceneUpdate",
                object({{"deletions", listOf(object({{"timestamp", timeSchema()}, {"type", wholeNumber()}, {"id", kText}}))},
                        {"entities", listOf(object(std::move(entity)))}}));
}

std::string logSchema() {
  return titled("foxglove.Log", object({{"timestamp", timeSchema()}, {"level", wholeNumber()}, {"message", kText},
                                        {"name", kText}, {"file", kText}, {"line", wholeNumber()}}));
}

std::string forceSchema() {
  return titled("hapticell.Force", object({{"newtons", kNumber}, {"contacts", wholeNumber()}}));
}

std::string contactsSchema() {
  return titled("hapticell.Contacts",
                object({{"pairs", listOf(object({{"first", kText}, {"second", kText}, {"distance", kNumber}, {"contact", kTruth}}))}}));
}

}  // namespace hapticell::bridge
