// SPDX-License-Identifier: Apache-2.0
#include "workcell/sdf_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <sdf/sdf.hh>

#include "geometry/shapes.h"
#include "kinematics/joint_graph.h"
#include "workcell/mesh_reader.h"
#include "workcell/package_path.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

using kinematics::GraphJoint;
using kinematics::JointGraph;
using kinematics::JointType;
using kinematics::LinkShape;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Pose toPose(const ignition::math::Pose3d& X) {
  return {{X.Pos().X(), X.Pos().Y(), X.Pos().Z()},
          glm::normalize(dquat(X.Rot().W(), X.Rot().X(), X.Rot().Y(), X.Rot().Z()))};
}

std::string firstOf(const sdf::Errors& errors) {
  std::string text = errors.front().Message();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.substr(0, 400);
}

class SdfModelReader {
 public:
  SdfModelReader(const sdf::Model& source, const fs::path& file, Diagnostics& diagnostics)
      : source_(source), file_(file), diagnostics_(diagnostics) {}

  Expected<kinematics::RobotModel> read() {
    graph_.name = source_.Name();
    for (std::uint64_t k = 0; k < source_.LinkCount(); ++k) {
      if (auto added = addLink(*source_.LinkByIndex(k)); !added) return makeError(added.error());
    }
    if (graph_.links.empty())
      return makeError(refusal("model '" + graph_.name + "'", "no links", "at least one <link>"));
    for (std::uint64_t k = 0; k < source_.JointCount(); ++k) {
      if (auto added = addJoint(*source_.JointByIndex(k)); !added) return makeError(added.error());
    }
    graph_.root = root();
    if (source_.ModelCount() > 0) diagnostics_.warn(file_.string() + ": models inside the model are left out");
    auto model = kinematics::modelOfGraph(graph_);
    if (!model) {
      Error error = model.error();
      error.file = file_.string();
      return makeError(std::move(error));
    }
    chooseTip(*model);
    return model;
  }

 private:
  Error refusal(const std::string& place, const std::string& found, const std::string& expected) const {
    return {file_.string(), place, found, expected, ""};
  }

  int linkNamed(const std::string& name) const {
    for (std::size_t k = 0; k < graph_.links.size(); ++k) {
      if (graph_.links[k].link.name == name) return static_cast<int>(k);
    }
    return -1;
  }

  Expected<std::shared_ptr<const geometry::TriangleMesh>> meshOf(const std::string& link,
                                                                 const sdf::Geometry& geometry) {
    geometry::TriangleMesh mesh;
    if (const auto* box = geometry.BoxShape()) {
      mesh = geometry::makeBox({box->Size().X(), box->Size().Y(), box->Size().Z()});
    } else if (const auto* cylinder = geometry.CylinderShape()) {
      mesh = geometry::makeCylinder(cylinder->Radius(), cylinder->Length());
    } else if (const auto* sphere = geometry.SphereShape()) {
      mesh = geometry::makeSphere(sphere->Radius());
    } else if (const auto* file_mesh = geometry.MeshShape()) {
      std::string uri = file_mesh->Uri();
      if (uri.starts_with("model://")) uri = "package://" + uri.substr(8);
      const auto path = resolveMeshPath(uri, file_.parent_path());
      if (leavesPackage(uri)) {
        return makeError(refusal("link '" + link + "'", "its mesh " + file_mesh->Uri() + " leads out of the model",
                                 "a file of the model"));
      }
      if (!path)
        return makeError(refusal("link '" + link + "'", "its mesh " + file_mesh->Uri() + " is not there", "a file"));
      Diagnostics notes;
      auto read = readMesh(*path, {.scale = 1.0, .warn_about_unit = false}, notes);
      if (!read) return makeError(read.error());
      for (const std::string& note : notes.warnings) diagnostics_.warn(path->filename().string() + ": " + note);
      const auto scale = file_mesh->Scale();
      for (dvec3& v : read->vertices) v *= dvec3(scale.X(), scale.Y(), scale.Z());
      const bool is_mirrored = scale.X() * scale.Y() * scale.Z() < 0.0;
      for (geometry::Triangle& t : read->triangles) {
        if (is_mirrored) std::swap(t[1], t[2]);
      }
      mesh = std::move(*read);
    } else {
      diagnostics_.warn(file_.string() + ": link '" + link + "' has a shape of a kind that is left out");
    }
    return std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
  }

  /// Sizes that would break the makers of shapes.
  static bool hasSize(const sdf::Geometry& geometry) {
    if (const auto* box = geometry.BoxShape()) return box->Size().Min() > 0.0;
    if (const auto* cylinder = geometry.CylinderShape()) return cylinder->Radius() > 0.0 && cylinder->Length() > 0.0;
    if (const auto* sphere = geometry.SphereShape()) return sphere->Radius() > 0.0;
    return true;
  }

  template <typename Shape>
  Expected<void> addShape(const std::string& link, const Shape& shape, std::vector<LinkShape>& shapes,
                          const LinkShape& look) {
    if (!shape.Geom()) return {};
    if (!hasSize(*shape.Geom()))
      return makeError(refusal("link '" + link + "'", "a shape without size", "sizes above 0"));
    auto mesh = meshOf(link, *shape.Geom());
    if (!mesh) return makeError(mesh.error());
    if ((*mesh)->triangles.empty()) return {};
    ignition::math::Pose3d pose;
    if (const auto errors = shape.SemanticPose().Resolve(pose, link); !errors.empty())
      return makeError(refusal("link '" + link + "'", firstOf(errors), "a pose that can be told"));
    LinkShape made = look;
    made.mesh = *mesh;
    made.X_LS = toPose(pose);
    made.source = shape.Geom()->MeshShape() ? shape.Geom()->MeshShape()->Uri() : "shape";
    shapes.push_back(std::move(made));
    return {};
  }

  Expected<void> addLink(const sdf::Link& source) {
    kinematics::GraphLink link;
    link.link.name = source.Name();
    ignition::math::Pose3d pose;
    if (const auto errors = source.SemanticPose().Resolve(pose, "__model__"); !errors.empty())
      return makeError(refusal("link '" + source.Name() + "'", firstOf(errors), "a pose that can be told"));
    link.X_ML = toPose(pose);
    if (!link.X_ML.isValid())
      return makeError(refusal("link '" + source.Name() + "'", "a pose that is not one", "finite numbers"));
    LinkShape look;
    for (std::uint64_t k = 0; k < source.VisualCount(); ++k) {
      const sdf::Visual& visual = *source.VisualByIndex(k);
      look.color = {0.7f, 0.7f, 0.7f, 1.0f};
      if (const sdf::Material* material = visual.Material()) {
        const auto c = material->Diffuse();
        if (c.R() > 0.0f || c.G() > 0.0f || c.B() > 0.0f) look.color = {c.R(), c.G(), c.B(), 1.0f};
      }
      if (auto added = addShape(source.Name(), visual, link.link.visuals, look); !added) return added;
    }
    for (std::uint64_t k = 0; k < source.CollisionCount(); ++k) {
      if (auto added = addShape(source.Name(), *source.CollisionByIndex(k), link.link.collisions, look); !added)
        return added;
    }
    if (link.link.collisions.empty()) link.link.collisions = link.link.visuals;
    graph_.links.push_back(std::move(link));
    return {};
  }

  Expected<void> addJoint(const sdf::Joint& source) {
    const std::string place = "joint '" + source.Name() + "'";
    std::string parent, child;
    if (const auto errors = source.ResolveParentLink(parent); !errors.empty())
      return makeError(refusal(place, firstOf(errors), "the name of a link"));
    if (const auto errors = source.ResolveChildLink(child); !errors.empty())
      return makeError(refusal(place, firstOf(errors), "the name of a link"));
    if (parent == "world" || child == "world") {
      world_link_ = parent == "world" ? child : parent;
      if (source.Type() != sdf::JointType::FIXED)
        diagnostics_.warn(file_.string() + ": " + place + " to the world is read as fixed");
      return {};
    }
    GraphJoint joint;
    joint.joint.name = source.Name();
    joint.joint.parent_link = linkNamed(parent);
    joint.joint.child_link = linkNamed(child);
    if (joint.joint.parent_link < 0 || joint.joint.child_link < 0)
      return makeError(refusal(
          place,
          "it names the link '" + (joint.joint.parent_link < 0 ? parent : child) + "', which is not in the model",
          "a link of it"));
    ignition::math::Pose3d pose;
    if (const auto errors = source.SemanticPose().Resolve(pose, "__model__"); !errors.empty())
      return makeError(refusal(place, firstOf(errors), "a pose that can be told"));
    joint.X_MJ = Pose::translation(toPose(pose).p);  // Axes are asked for in the model's frame.
    return addTyped(source, joint, place);
  }

  Expected<void> addTyped(const sdf::Joint& source, GraphJoint& joint, const std::string& place) {
    std::vector<dvec3> axes;
    for (unsigned k = 0; k < 2; ++k) {
      const sdf::JointAxis* axis = source.Axis(k);
      if (!axis) continue;
      ignition::math::Vector3d xyz;
      if (const auto errors = axis->ResolveXyz(xyz, "__model__"); !errors.empty())
        return makeError(refusal(place, firstOf(errors), "an axis"));
      const dvec3 direction(xyz.X(), xyz.Y(), xyz.Z());
      if (!(glm::length(direction) > 1e-9)) return makeError(refusal(place, "an axis of length zero", "a direction"));
      axes.push_back(glm::normalize(direction));
      if (k > 0) continue;
      joint.joint.lower = axis->Lower() < -1e15 ? -kInfinity : axis->Lower();
      joint.joint.upper = axis->Upper() > 1e15 ? kInfinity : axis->Upper();
      joint.joint.velocity = axis->MaxVelocity() > 0.0 && axis->MaxVelocity() < 1e15 ? axis->MaxVelocity() : 0.0;
      if (std::isnan(joint.joint.lower) || joint.joint.lower > joint.joint.upper)
        return makeError(refusal(place,
                                 "its lower limit " + std::to_string(joint.joint.lower) + " is over the upper " +
                                     std::to_string(joint.joint.upper),
                                 "lower <= upper"));
    }
    const auto need = [&](std::size_t count) { return axes.size() >= count; };
    const Error no_axis = refusal(place, "no axis", "<axis> with <xyz>");
    const bool endless = std::isinf(joint.joint.lower) || std::isinf(joint.joint.upper);
    joint.joint.type = endless ? JointType::kContinuous : JointType::kRevolute;
    if (endless) {
      joint.joint.lower = -kInfinity;
      joint.joint.upper = kInfinity;
    }
    switch (source.Type()) {
      case sdf::JointType::FIXED:
        joint.joint.type = JointType::kFixed;
        graph_.joints.push_back(joint);
        return {};
      case sdf::JointType::REVOLUTE:
      case sdf::JointType::CONTINUOUS:
        if (!need(1)) return makeError(no_axis);
        kinematics::addCompoundJoint(graph_, joint, {axes[0]});
        return {};
      case sdf::JointType::PRISMATIC:
        if (!need(1)) return makeError(no_axis);
        joint.joint.type = JointType::kPrismatic;
        kinematics::addCompoundJoint(graph_, joint, {axes[0]});
        return {};
      case sdf::JointType::UNIVERSAL:
      case sdf::JointType::REVOLUTE2:
        if (!need(2)) return makeError(no_axis);
        kinematics::addCompoundJoint(graph_, joint, {axes[0], axes[1]});
        return {};
      case sdf::JointType::BALL:
        joint.joint.type = JointType::kContinuous;
        joint.joint.lower = -kInfinity;
        joint.joint.upper = kInfinity;
        kinematics::addCompoundJoint(graph_, joint, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
        return {};
      case sdf::JointType::SCREW: {
        if (!need(1)) return makeError(no_axis);
        joint.joint.axis_J = axes[0];
        const double pitch = source.ThreadPitch();
        if (!(std::abs(pitch) > 1e-9)) return makeError(refusal(place, "a screw without pitch", "<thread_pitch>"));
        kinematics::addScrewJoint(graph_, joint, -2.0 * M_PI / pitch);
        return {};
      }
      case sdf::JointType::GEARBOX:
        diagnostics_.warn(file_.string() + ": " + place + " is a gearbox; it is left out");
        return {};
      case sdf::JointType::INVALID:
        break;
    }
    return makeError(refusal(place, "a joint type that is not known",
                             "revolute, continuous, prismatic, fixed, screw, universal, revolute2 or ball"));
  }

  /// The link that is fixed to the world, else the first that is no joint's child, else the first.
  int root() const {
    if (const int at = linkNamed(world_link_); at >= 0) return at;
    for (std::size_t k = 0; k < graph_.links.size(); ++k) {
      const bool is_child = std::any_of(graph_.joints.begin(), graph_.joints.end(), [&](const GraphJoint& joint) {
        return joint.joint.child_link == static_cast<int>(k);
      });
      const bool is_parent = std::any_of(graph_.joints.begin(), graph_.joints.end(), [&](const GraphJoint& joint) {
        return joint.joint.parent_link == static_cast<int>(k);
      });
      const bool named_base = graph_.links[k].link.name.find("base") != std::string::npos;
      if (!is_child && is_parent && (named_base || linkNamed("base_link") < 0)) return static_cast<int>(k);
    }
    return 0;
  }

  void chooseTip(kinematics::RobotModel& model) const {
    for (const char* word : {"end_effector", "platform"}) {
      for (const kinematics::GraphLink& link : graph_.links) {
        const int at = model.findLink(link.link.name);
        if (at > 0 && link.link.name.find(word) != std::string::npos) {
          model.tip = at;
          return;
        }
      }
    }
  }

  const sdf::Model& source_;
  const fs::path& file_;
  Diagnostics& diagnostics_;
  JointGraph graph_;
  std::string world_link_;
};

}  // namespace

Expected<kinematics::RobotModel> readSdf(const fs::path& file, Diagnostics& diagnostics) {
  static std::mutex mutex;  // The library's console is one for the process.
  const std::lock_guard lock(mutex);
  sdf::Console::Instance()->SetQuiet(true);
  sdf::Root root;
  sdf::Errors errors;
  try {
    errors = root.Load(file.string());
  } catch (const std::exception& exception) {
    return makeError({file.string(), "", std::string("sdformat cannot read it (") + exception.what() + ")", "SDF", ""});
  }
  if (!errors.empty()) {
    const auto line = errors.front().LineNumber();
    return makeError({file.string(), line ? "line " + std::to_string(*line) : "", firstOf(errors), "valid SDF", ""});
  }
  const sdf::Model* model = root.Model();
  if (!model && root.WorldCount() > 0 && root.WorldByIndex(0)->ModelCount() > 0) {
    model = root.WorldByIndex(0)->ModelByIndex(0);
    diagnostics.warn(file.string() + ": of the world the first model is read, '" + model->Name() + "'");
  }
  if (!model) return makeError({file.string(), "", "no model", "<model name=\"…\">", ""});
  return SdfModelReader(*model, file, diagnostics).read();
}

}  // namespace hapticell::workcell
