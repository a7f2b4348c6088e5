// SPDX-License-Identifier: Apache-2.0
#include "importer/sdf_resolver.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <new>
#include <numbers>
#include <sdf/sdf.hh>
#include <utility>

namespace hapticell::importer {

namespace {

using workcell::SdfContent;
using workcell::SdfJoint;
using workcell::SdfJointAxis;
using workcell::SdfLink;
using workcell::SdfMimic;
using workcell::SdfModel;
using workcell::SdfPose;
using workcell::SdfShape;

dvec3 toVector(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}

Pose toPose(const ignition::math::Pose3d& X) {
  return {toVector(X.Pos()), glm::normalize(dquat(X.Rot().W(), X.Rot().X(), X.Rot().Y(), X.Rot().Z()))};
}

/// The library's own words in one line of at most 400 bytes; empty where it has none.
std::string firstOf(const sdf::Errors& errors) {
  if (errors.empty()) return {};
  std::string text = errors.front().Message();
  std::replace(text.begin(), text.end(), '\n', ' ');
  text = text.substr(0, 400);
  return text.empty() ? "an error without a message" : text;
}

/// What follows from another complaint, and is said in terms of the library's inside.
bool isConsequence(const sdf::Error& error) {
  return error.Code() == sdf::ErrorCode::FRAME_ATTACHED_TO_GRAPH_ERROR ||
         error.Code() == sdf::ErrorCode::POSE_RELATIVE_TO_GRAPH_ERROR ||
         error.Message().find("Failed to load a world") != std::string::npos;
}

/// Each once.
std::vector<std::string> complaintsOf(const sdf::Errors& errors) {
  std::vector<std::string> told;
  for (const sdf::Error& error : errors) {
    const std::string words = firstOf({error});
    if (isConsequence(error) || std::find(told.begin(), told.end(), words) != told.end()) continue;
    told.push_back(words);
  }
  if (told.empty() && !errors.empty()) told.push_back(firstOf(errors));
  return told;
}

SdfPose poseOf(const sdf::SemanticPose& pose, const std::string& to) {
  ignition::math::Pose3d X;
  SdfPose result;
  result.fault = firstOf(pose.Resolve(X, to));
  result.X = toPose(result.fault.empty() ? X : pose.RawPose());
  return result;
}

void setGeometry(const sdf::Geometry& geometry, SdfShape& shape) {
  if (const auto* mesh = geometry.MeshShape()) {
    shape.kind = SdfShape::Kind::kMesh;
    shape.size = toVector(mesh->Scale());
    shape.uri = mesh->Uri();
    shape.submesh = mesh->Submesh();
    shape.center_submesh = mesh->CenterSubmesh();
  } else if (const auto* box = geometry.BoxShape()) {
    shape.kind = SdfShape::Kind::kBox;
    shape.size = toVector(box->Size());
  } else if (const auto* cylinder = geometry.CylinderShape()) {
    shape.kind = SdfShape::Kind::kCylinder;
    shape.size = {cylinder->Radius(), cylinder->Length(), 0.0};
  } else if (const auto* sphere = geometry.SphereShape()) {
    shape.kind = SdfShape::Kind::kSphere;
    shape.size = {sphere->Radius(), 0.0, 0.0};
  } else if (const auto* capsule = geometry.CapsuleShape()) {
    shape.kind = SdfShape::Kind::kCapsule;
    shape.size = {capsule->Radius(), capsule->Length(), 0.0};
  } else if (const auto* ellipsoid = geometry.EllipsoidShape()) {
    shape.kind = SdfShape::Kind::kEllipsoid;
    shape.size = toVector(ellipsoid->Radii());
  }
}

template <typename Shape>
SdfShape shapeOf(const Shape& source, const sdf::Link& link) {
  SdfShape shape;
  shape.name = source.Name();
  shape.X_LS = poseOf(source.SemanticPose(), link.Name());
  if (source.Geom()) setGeometry(*source.Geom(), shape);
  return shape;
}

std::array<float, 3> toColor(const ignition::math::Color& c) {
  return {c.R(), c.G(), c.B()};
}

SdfShape visualOf(const sdf::Visual& source, const sdf::Link& link) {
  SdfShape shape = shapeOf(source, link);
  const sdf::Material* const material = source.Material();
  const sdf::ElementPtr element = material ? material->Element() : nullptr;
  if (!element) return shape;
  if (element->HasElement("diffuse")) shape.diffuse = toColor(material->Diffuse());
  if (element->HasElement("ambient")) shape.ambient = toColor(material->Ambient());
  return shape;
}

SdfLink linkOf(const sdf::Link& source) {
  SdfLink link;
  link.name = source.Name();
  link.X_ML = poseOf(source.SemanticPose(), "__model__");
  for (std::uint64_t k = 0; k < source.VisualCount(); ++k) {
    link.visuals.push_back(visualOf(*source.VisualByIndex(k), source));
  }
  for (std::uint64_t k = 0; k < source.CollisionCount(); ++k) {
    link.collisions.push_back(shapeOf(*source.CollisionByIndex(k), source));
  }
  return link;
}

SdfJoint::Type typeOf(sdf::JointType type) {
  switch (type) {
    case sdf::JointType::FIXED:
      return SdfJoint::Type::kFixed;
    case sdf::JointType::CONTINUOUS:
      return SdfJoint::Type::kContinuous;
    case sdf::JointType::REVOLUTE:
      return SdfJoint::Type::kRevolute;
    case sdf::JointType::PRISMATIC:
      return SdfJoint::Type::kPrismatic;
    case sdf::JointType::UNIVERSAL:
      return SdfJoint::Type::kUniversal;
    case sdf::JointType::REVOLUTE2:
      return SdfJoint::Type::kRevolute2;
    case sdf::JointType::BALL:
      return SdfJoint::Type::kBall;
    case sdf::JointType::SCREW:
      return SdfJoint::Type::kScrew;
    case sdf::JointType::GEARBOX:
      return SdfJoint::Type::kGearbox;
    case sdf::JointType::INVALID:
      break;
  }
  return SdfJoint::Type::kInvalid;
}

/// SDF 1.11, which this version of the library keeps without reading it.
std::optional<SdfMimic> mimicOf(const sdf::ElementPtr& axis) {
  const sdf::ElementPtr element = axis ? axis->FindElement("mimic") : nullptr;
  if (!element) return std::nullopt;
  const auto number = [&](const char* name, double otherwise) {
    const sdf::ElementPtr child = element->FindElement(name);
    return child ? std::strtod(child->Get<std::string>().c_str(), nullptr) : otherwise;
  };
  SdfMimic mimic;
  mimic.joint = element->GetAttribute("joint") ? element->GetAttribute("joint")->GetAsString() : "";
  const auto leading = element->GetAttribute("axis");
  mimic.second_axis = leading && leading->GetAsString() == "axis2";
  mimic.multiplier = number("multiplier", 1.0);
  mimic.offset = number("offset", 0.0);
  mimic.reference = number("reference", 0.0);
  return mimic;
}

SdfJointAxis axisOf(const sdf::JointAxis& source) {
  SdfJointAxis axis;
  ignition::math::Vector3d xyz;
  axis.fault = firstOf(source.ResolveXyz(xyz, "__model__"));
  const sdf::ElementPtr own = source.Element();  // The library takes z where it complains.
  if (own && own->HasElement("xyz") && own->Get<ignition::math::Vector3d>("xyz").Length() < 1e-9) xyz = {0, 0, 0};
  axis.xyz_M = toVector(xyz);
  axis.lower = source.Lower();
  axis.upper = source.Upper();
  axis.velocity = source.MaxVelocity();
  axis.mimic = mimicOf(own);
  return axis;
}

double pitchOf(const sdf::Joint& source) {
  const sdf::ElementPtr element = source.Element();
  const sdf::ElementPtr metres = element ? element->FindElement("screw_thread_pitch") : nullptr;
  return metres ? std::strtod(metres->Get<std::string>().c_str(), nullptr)
                : -2.0 * std::numbers::pi / source.ThreadPitch();  // Until SDF 1.9: radians a metre, left-handed.
}

SdfJoint jointOf(const sdf::Joint& source) {
  SdfJoint joint;
  joint.name = source.Name();
  joint.type = typeOf(source.Type());
  joint.parent_fault = firstOf(source.ResolveParentLink(joint.parent));
  joint.child_fault = firstOf(source.ResolveChildLink(joint.child));
  joint.X_MJ = poseOf(source.SemanticPose(), "__model__");
  for (unsigned k = 0; k < 2; ++k) {
    const sdf::JointAxis* const axis = source.Axis(k);
    joint.axes.push_back(axis ? std::optional(axisOf(*axis)) : std::nullopt);
  }
  if (joint.type == SdfJoint::Type::kScrew) joint.pitch = pitchOf(source);
  return joint;
}

SdfModel modelOf(const sdf::Model& source, bool nested) {
  SdfModel model;
  model.name = source.Name();
  model.X_P = poseOf(source.SemanticPose(), "");
  if (nested) model.X_M = poseOf(source.SemanticPose(), "__model__");
  for (std::uint64_t k = 0; k < source.LinkCount(); ++k) model.links.push_back(linkOf(*source.LinkByIndex(k)));
  for (std::uint64_t k = 0; k < source.JointCount(); ++k) model.joints.push_back(jointOf(*source.JointByIndex(k)));
  for (std::uint64_t k = 0; k < source.ModelCount(); ++k) {
    model.models.push_back(modelOf(*source.ModelByIndex(k), true));
  }
  return model;
}

SdfContent contentOf(const sdf::Root& root) {
  SdfContent content;
  content.has_world = root.WorldCount() > 0;
  const sdf::World* const world = content.has_world ? root.WorldByIndex(0) : nullptr;
  for (std::uint64_t k = 0; world && k < world->ModelCount(); ++k) {
    content.models.push_back(modelOf(*world->ModelByIndex(k), false));
  }
  if (!world && root.Model()) content.models.push_back(modelOf(*root.Model(), false));
  return content;
}

}  // namespace

Expected<SdfContent> resolveSdf(const std::string& text) {
  sdf::Console::Instance()->SetQuiet(true);
  try {
    sdf::Root root;
    const sdf::Errors errors = root.LoadSdfString(text);
    SdfContent content = contentOf(root);
    content.complaints = complaintsOf(errors);
    content.first_complaint = firstOf(errors);
    return content;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return makeError({.found = "content that makes the SDF library crash",
                      .expected = "SDF",
                      .fix = "Check it with another program (gz sdf --check), or export it again."});
  }
}

}  // namespace hapticell::importer
