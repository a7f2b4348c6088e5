// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_reader.h"

#include <algorithm>
#include <functional>

#include "kinematics/closures/joint_graph.h"
#include "workcell/scenes/sdf_joints.h"
#include "workcell/scenes/sdf_robot.h"
#include "workcell/scenes/sdf_shapes.h"
#include "workcell/scenes/sdf_tidier.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

using kinematics::GraphJoint;
using kinematics::JointGraph;
using kinematics::LinkShape;

class SdfModelReader {
 public:
  SdfModelReader(const SdfSource& source, const SdfModel& model, const fs::path& file, Diagnostics& diagnostics,
                 ImportMonitor* monitor)
      : model_(model),
        file_(file),
        diagnostics_(diagnostics),
        shapes_(source, asGazeboDoes(), monitor),
        joints_(graph_, file, diagnostics) {}

  Expected<SdfRobot> read() {
    graph_.name = model_.name;
    HAPTICELL_TRY(addModel(model_, "", Pose()));
    if (graph_.links.empty())
      return makeError(
          refusal(Text("model '%1'", graph_.name), Text("the model has no links"), Text("at least one <link>")));
    if (shapes_.isCancelled()) return makeError({.file = file_.string(), .found = "the import was cancelled"});
    joints_.setMimics();
    graph_.root = root();
    if (!graph_.joints.empty()) fixFreeLinks();
    auto model = kinematics::modelOfGraph(graph_);
    if (!model) {
      Error error = model.error();
      error.file = file_.string();
      return makeError(std::move(error));
    }
    chooseTip(*model);
    for (const Text& note : shapes_.notes().warnings) diagnostics_.warn(Text("%1: %2", file_.string(), note));
    return SdfRobot{std::move(*model), graph_.links[static_cast<std::size_t>(graph_.root)].X_ML};
  }

 private:
  Error refusal(Text place, Text found, Text expected) const {
    return sdfRefusal(file_, std::move(place), std::move(found), std::move(expected));
  }

  int linkNamed(const std::string& name) const {
    for (std::size_t k = 0; k < graph_.links.size(); ++k) {
      if (graph_.links[k].link.name == name) return static_cast<int>(k);
    }
    return -1;
  }

  /// Links, then joints, of the model and of those inside it, whose names begin with `scope` ("load::").
  Expected<void> addModel(const SdfModel& model, const std::string& scope, const Pose& X_MN) {
    for (const SdfLink& link : model.links) {
      if (link.name == kNoLink) continue;
      if (auto added = addLink(link, scope, X_MN); !added) return added;
    }
    for (const SdfModel& inside : model.models) {
      if (!inside.X_M.fault.empty())
        return makeError(
            refusal(Text("model '%1'", inside.name), inside.X_M.fault, Text("a pose that can be resolved")));
      if (auto added = addModel(inside, scope + inside.name + "::", X_MN * inside.X_M.X); !added) return added;
    }
    for (const SdfJoint& joint : model.joints) {
      if (auto added = addJoint(joint, scope, X_MN); !added) return added;
    }
    return {};
  }

  void addShape(const SdfLink& link, const SdfShape& shape, std::vector<LinkShape>& shapes, const LinkShape& look) {
    const auto mesh = shapes_.meshOf(shape, link.name);
    if (!mesh) return;
    if (!shape.X_LS.fault.empty()) {
      diagnostics_.warn(Text("%1: link '%2': a shape is left out, because its placement is unknown: %3", file_.string(),
                             link.name, shape.X_LS.fault));
      return;
    }
    LinkShape made = look;
    made.mesh = mesh;
    made.X_LS = shape.X_LS.X;
    made.source = shape.kind == SdfShape::Kind::kMesh ? "mesh" : "shape";
    shapes.push_back(std::move(made));
  }

  Expected<void> addLink(const SdfLink& source, const std::string& scope, const Pose& X_MN) {
    kinematics::GraphLink link;
    link.link.name = scope + source.name;
    if (!source.X_ML.fault.empty())
      return makeError(
          refusal(Text("link '%1'", source.name), source.X_ML.fault, Text("a pose that can be resolved")));
    link.X_ML = X_MN * source.X_ML.X;
    if (!link.X_ML.isValid())
      return makeError(refusal(Text("link '%1'", source.name), Text("an invalid pose"), Text("finite numbers")));
    LinkShape look;
    for (const SdfShape& visual : source.visuals) {
      look.color = {0.7f, 0.7f, 0.7f, 1.0f};
      if (visual.diffuse) {
        const auto [r, g, b] = *visual.diffuse;
        if (r > 0.0f || g > 0.0f || b > 0.0f) look.color = {r, g, b, 1.0f};
      }
      addShape(source, visual, link.link.visuals, look);
    }
    for (const SdfShape& collision : source.collisions) addShape(source, collision, link.link.collisions, look);
    if (link.link.collisions.empty()) link.link.collisions = link.link.visuals;
    graph_.links.push_back(std::move(link));
    return {};
  }

  /// The cell itself as a link, for joints that move against it.
  int worldLink() {
    if (const int known = linkNamed("world"); known >= 0) return known;
    kinematics::GraphLink world;
    world.link.name = "world";
    if (model_.X_P.fault.empty() && model_.X_P.X.isValid()) world.X_ML = model_.X_P.X.inverse();
    graph_.links.push_back(std::move(world));
    world_link_ = "world";
    return static_cast<int>(graph_.links.size()) - 1;
  }

  Expected<void> addJoint(const SdfJoint& source, const std::string& scope, const Pose& X_MN) {
    const Text place("joint '%1'", scope + source.name);
    for (const std::string& fault : {source.parent_fault, source.child_fault}) {
      if (!fault.empty()) return makeError(refusal(place, fault, Text("the name of a link")));
    }
    const std::string &parent = source.parent, &child = source.child;
    const bool to_world = parent == "world" || child == "world";
    if (to_world && source.type == SdfJoint::Type::kFixed) {
      if (world_link_.empty()) world_link_ = scope + (parent == "world" ? child : parent);
      if (linkNamed("world") < 0) return {};
    }
    const auto number = [&](const std::string& name) {
      return name == "world" ? worldLink() : linkNamed(scope + name);
    };
    GraphJoint joint;
    joint.joint.name = scope + source.name;
    joint.joint.parent_link = number(parent);
    joint.joint.child_link = number(child);
    if (joint.joint.parent_link < 0 || joint.joint.child_link < 0)
      return makeError(refusal(place,
                               Text("its link '%1' is not in the model", joint.joint.parent_link < 0 ? parent : child),
                               Text("a link of the model")));
    if (!source.X_MJ.fault.empty())
      return makeError(refusal(place, source.X_MJ.fault, Text("a pose that can be resolved")));
    joint.X_MJ = Pose::translation((X_MN * source.X_MJ.X).p);  // Axes are asked for in the model's frame.
    return joints_.add(source, joint, scope, X_MN, place);
  }

  /// Bodies of the model that no joint reaches stand where the file puts them.
  void fixFreeLinks() {
    std::vector<int> group(graph_.links.size());
    for (std::size_t k = 0; k < group.size(); ++k) group[k] = static_cast<int>(k);
    const std::function<int(int)> find = [&](int k) {
      return group[static_cast<std::size_t>(k)] == k ? k : find(group[static_cast<std::size_t>(k)]);
    };
    for (const GraphJoint& joint : graph_.joints) {
      group[static_cast<std::size_t>(find(joint.joint.child_link))] = find(joint.joint.parent_link);
    }
    for (std::size_t k = 0; k < group.size(); ++k) {
      const int own = find(static_cast<int>(k)), base = find(graph_.root);
      if (own == base) continue;
      GraphJoint joint;
      joint.joint.name = graph_.links[k].link.name + " stands";
      joint.joint.parent_link = graph_.root;
      joint.joint.child_link = static_cast<int>(k);
      joint.X_MJ = graph_.links[k].X_ML;
      graph_.joints.push_back(joint);
      group[static_cast<std::size_t>(own)] = base;
      diagnostics_.warn(Text("%1: no joint connects the link '%2' to the root; it is fixed at its position",
                             file_.string(), graph_.links[k].link.name));
    }
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

  const SdfModel& model_;
  const fs::path& file_;
  Diagnostics& diagnostics_;
  SdfShapes shapes_;
  JointGraph graph_;
  SdfJointReader joints_;
  std::string world_link_;
};

bool movesInside(const SdfModel& model) {
  return hasMovingJoints(model) || std::any_of(model.models.begin(), model.models.end(), movesInside);
}

}  // namespace

bool hasMovingJoints(const SdfModel& model) {
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [](const SdfJoint& joint) { return joint.type != SdfJoint::Type::kFixed; });
}

Expected<SdfRobot> readSdfRobot(const SdfSource& source, const SdfModel& model, const fs::path& file,
                                Diagnostics& diagnostics, ImportMonitor* monitor) {
  return SdfModelReader(source, model, file, diagnostics, monitor).read();
}

Expected<SdfRobot> readSdf(const fs::path& file, Diagnostics& diagnostics, ImportMonitor* monitor) {
  const auto source = SdfSource::load(file, monitor);
  HAPTICELL_TRY(source);
  const std::vector<SdfModel>& models = source->models();
  if (models.empty())
    return makeError({.file = file.string(), .found = "the file has no model", .expected = "<model name=\"…\">"});
  for (const Text& warning : source->warnings()) diagnostics.warn(Text("%1: %2", file.string(), warning));
  const auto moving = std::find_if(models.begin(), models.end(), movesInside);
  const SdfModel& model = moving == models.end() ? models.front() : *moving;
  if (models.size() > 1) {
    diagnostics.warn(Text("%1: of %2 models, only '%3' is read, because it has moving joints", file.string(),
                          models.size(), model.name));
  }
  Expected<SdfRobot> robot = readSdfRobot(*source, model, file, diagnostics, monitor);
  if (robot && model.X_P.fault.empty() && model.X_P.X.isValid()) robot->X_FB = model.X_P.X * robot->X_FB;
  return robot;
}

}  // namespace hapticell::workcell
