// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::workcell {

// An SDF file as libsdformat understands it: every name, pose and limit, as plain values. The importer's process makes
// it (importer/sdf_resolver.h), so that no other program loads the library. Numbers may be infinite or not numbers;
// who uses them checks them.

/// A pose that the file defines by its frames, or why the library cannot tell it.
struct SdfPose {
  Pose X;             ///< As resolved; with a fault, as written, in whatever frame.
  std::string fault;  ///< The library's own words; empty: resolved.
};

/// A visual or collision shape.
struct SdfShape {
  enum class Kind : std::uint8_t { kNone, kMesh, kBox, kCylinder, kSphere, kCapsule, kEllipsoid };

  std::string name;
  SdfPose X_LS;  ///< In the link's frame.
  Kind kind = Kind::kNone;
  /// m: edges of a box, radii of an ellipsoid; radius and length of a cylinder or capsule; radius of a sphere. Of a
  /// mesh, its scale.
  dvec3 size{0.0};
  std::string uri;      ///< Of a mesh: a number of SdfSource::meshFiles(), as text.
  std::string submesh;  ///< Empty: the whole mesh.
  bool center_submesh = false;
  std::optional<std::array<float, 3>> diffuse, ambient;  ///< As far as the file says them.
};

struct SdfLink {
  std::string name;
  SdfPose X_ML;  ///< In the model's frame.
  std::vector<SdfShape> visuals, collisions;
};

/// A joint that follows another: position = multiplier (position of the other - reference) + offset.
struct SdfMimic {
  std::string joint;
  bool second_axis = false;  ///< Of the other joint.
  double multiplier = 1.0, offset = 0.0, reference = 0.0;
};

struct SdfJointAxis {
  dvec3 xyz_M{0.0};   ///< In the model's frame; of any length, 0 where the file says 0.
  std::string fault;  ///< As in SdfPose.
  double lower = 0.0, upper = 0.0, velocity = 0.0;
  std::optional<SdfMimic> mimic;
};

struct SdfJoint {
  enum class Type : std::uint8_t {
    kInvalid,
    kFixed,
    kContinuous,
    kRevolute,
    kPrismatic,
    kUniversal,
    kRevolute2,
    kBall,
    kScrew,
    kGearbox
  };

  std::string name;
  Type type = Type::kInvalid;
  std::string parent, child;              ///< Links, "world" too.
  std::string parent_fault, child_fault;  ///< As in SdfPose.
  SdfPose X_MJ;                           ///< In the model's frame.
  std::vector<std::optional<SdfJointAxis>> axes;  ///< Two places.
  double pitch = 0.0;                             ///< m a turn, of a screw.
};

struct SdfModel {
  std::string name;
  SdfPose X_P;  ///< In the world, or in the frame of the model around it as the library places it by itself.
  SdfPose X_M;  ///< In the frame of the model around it, for models within one.
  std::vector<SdfLink> links;
  std::vector<SdfJoint> joints;
  std::vector<SdfModel> models;
};

struct SdfContent {
  bool has_world = false;
  std::vector<SdfModel> models;         ///< At the top, or in the first world.
  std::vector<std::string> complaints;  ///< The library's own words, a line each, those that only follow left out.
  std::string first_complaint;          ///< As the library orders them, whatever it is; empty: none.
};

}  // namespace hapticell::workcell
