// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::bridge {

/// A mesh S placed in the frame F that it is shown in.
struct SceneShape {
  const geometry::TriangleMesh* mesh = nullptr;
  Pose X_FS;
  std::array<float, 3> color{0.7f, 0.7f, 0.7f};  ///< sRGB, 0 to 1.
};

/// The nearest points of two parts.
struct ScenePoint {
  dvec3 p_WA{0.0}, p_WB{0.0};
  bool contact = false;
};

// Messages of Foxglove's schemas, as JSON. `stamp_ns`: nanoseconds since 1970.

/// foxglove.SceneUpdate: an entity that follows the frame `frame`, with its shapes as one glTF model.
std::string modelMessage(const std::string& id, const std::string& frame, std::span<const SceneShape> shapes,
                         std::int64_t stamp_ns);
/// foxglove.SceneUpdate: removes that entity.
std::string deletionMessage(const std::string& id, std::int64_t stamp_ns);
/// foxglove.SceneUpdate: a line between the points of each pair, and a ball where they touch. Replaces those before.
std::string pointsMessage(const std::string& frame, std::span<const ScenePoint> points, std::int64_t stamp_ns);
/// foxglove.Log with a sentence for people.
std::string logMessage(const std::string& words, std::int64_t stamp_ns);

/// JSON schemas of these messages, with the fields that are sent, and those of /force and /contacts.
std::string sceneSchema();
std::string logSchema();
std::string forceSchema();
std::string contactsSchema();

}  // namespace hapticell::bridge
