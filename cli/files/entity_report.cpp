// SPDX-License-Identifier: Apache-2.0
#include "cli/files/entity_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cli/kit/result_writer.h"
#include "geometry/shapes/mass_properties.h"
#include "geometry/system/in_parallel.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/jacobian.h"
#include "mannequin/body/skeleton.h"
#include "workcell/import/imported_entities.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

ordered_json boundsReport(const geometry::Bounds& bounds) {
  if (bounds.isEmpty()) return nullptr;
  return {{"min", toJson(bounds.min)}, {"max", toJson(bounds.max)}};
}

geometry::Bounds boundsOfReport(const ordered_json& report) {
  const ordered_json& json = report["bounds"];
  if (json.is_null()) return {};
  const auto point = [](const ordered_json& p) { return dvec3(p[0], p[1], p[2]); };
  return {point(json["min"]), point(json["max"])};
}

double rounded(float part) {
  return std::round(static_cast<double>(part) * 1e4) / 1e4;
}

ordered_json colorReport(float red, float green, float blue) {
  return ordered_json::array({rounded(red), rounded(green), rounded(blue)});
}

/// A node that only holds others: its bounds and volume are theirs.
ordered_json groupReport(const std::string& name, const std::string& kind, ordered_json children) {
  geometry::Bounds bounds;
  double volume = 0.0;
  for (const ordered_json& child : children) {
    bounds.add(boundsOfReport(child));
    volume += child["volume"].get<double>();
  }
  ordered_json report{{"name", name}, {"kind", kind}};
  report["color"] = children.empty() ? ordered_json(nullptr) : children[0]["color"];
  report["triangles"] = 0;
  report["bounds"] = boundsReport(bounds);
  report["volume"] = volume;
  report["children"] = std::move(children);
  return report;
}

/// The visual shapes of one link as one node.
ordered_json linkReport(const kinematics::Link& link, const Pose& X_WL) {
  geometry::TriangleMesh whole;
  for (const kinematics::LinkShape& shape : link.visuals) geometry::append(whole, *shape.mesh, shape.X_LS);
  const auto& color = link.visuals.front().color;
  return meshReport(link.name, whole, X_WL, {color[0], color[1], color[2]}, factsOf(whole));
}

const char* wordOf(kinematics::JointType type) {
  switch (type) {
    case kinematics::JointType::kRevolute:
      return "revolute";
    case kinematics::JointType::kContinuous:
      return "continuous";
    case kinematics::JointType::kPrismatic:
      return "prismatic";
    case kinematics::JointType::kFixed:
      break;
  }
  return "fixed";
}

ordered_json jointsReport(const kinematics::RobotModel& robot) {
  ordered_json joints = ordered_json::array();
  for (const int index : robot.moving) {
    const kinematics::Joint& joint = robot.joints[static_cast<std::size_t>(index)];
    joints.push_back({{"name", joint.name},
                      {"type", wordOf(joint.type)},
                      {"lower", finiteOrNull(joint.lower)},
                      {"upper", finiteOrNull(joint.upper)},
                      {"velocity", joint.velocity}});
  }
  return joints;
}

/// The ends of what joints move, each with the variables that move it: the default tip, and every other last link that
/// ends on a joint of its own. What a closure holds together has only its tip.
ordered_json chainsReport(const kinematics::RobotModel& robot, int default_tip) {
  std::vector<int> tips;
  if (default_tip >= 0) tips.push_back(default_tip);
  std::vector<bool> carries(robot.links.size(), false);
  for (const kinematics::Joint& joint : robot.joints) carries[static_cast<std::size_t>(joint.parent_link)] = true;
  const std::vector<int> body = kinematics::rigidBodies(robot);
  const auto isListed = [&](int link) {
    const auto same = [&](int tip) {
      return body[static_cast<std::size_t>(tip)] == body[static_cast<std::size_t>(link)];
    };
    return std::any_of(tips.begin(), tips.end(), same);
  };
  for (std::size_t k = 0; k < robot.links.size() && !robot.closure; ++k) {
    if (!carries[k] && !isListed(static_cast<int>(k))) tips.push_back(static_cast<int>(k));
  }
  ordered_json chains = ordered_json::array();
  for (const int tip : tips) {
    ordered_json joints = ordered_json::array();
    for (const int variable : kinematics::variablesOfChain(robot, tip)) {
      joints.push_back(robot.joints[static_cast<std::size_t>(robot.moving[static_cast<std::size_t>(variable)])].name);
    }
    if (!joints.empty()) {
      chains.push_back({{"tip", robot.links[static_cast<std::size_t>(tip)].name}, {"joints", std::move(joints)}});
    }
  }
  return chains;
}

ordered_json inverseModelReport(const kinematics::RobotModel& robot, const std::string& tip_link) {
  const int tip = tip_link.empty() ? robot.defaultTip() : robot.findLink(tip_link);
  if (tip < 0) return nullptr;
  const auto inverse = kinematics::createInverse(robot, tip);
  return inverse ? ordered_json((*inverse)->name()) : ordered_json(nullptr);
}

ordered_json robotReport(const workcell::Entity& entity) {
  const kinematics::RobotModel& robot = *entity.robot();
  const std::vector<double> q =
      entity.joints().size() == robot.dof() ? entity.joints() : kinematics::restPositions(robot);
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(robot, q, X_BL);
  ordered_json links = ordered_json::array();
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    if (!robot.links[k].visuals.empty()) links.push_back(linkReport(robot.links[k], entity.X_WE * X_BL[k]));
  }
  const bool mannequin = entity.kind() == workcell::EntityKind::kMannequin;
  ordered_json report = groupReport(entity.name, wordOf(entity.kind()), std::move(links));
  report["dof"] = mannequin ? mannequin::kDofCount : robot.dof();  // The gaze is not counted.
  report["joints"] = jointsReport(robot);
  if (!mannequin) report["chains"] = chainsReport(robot, robot.defaultTip());
  report["unchecked_links"] = ordered_json::array();
  for (const kinematics::Link& link : robot.links) {
    if (link.isUnchecked()) report["unchecked_links"].push_back(link.name);
  }
  report["inverse_model"] =
      mannequin ? ordered_json("mannequin") : inverseModelReport(robot, entity.jointed().tip_link);
  report["tip_link"] = entity.jointed().tip_link;
  return report;
}

ordered_json poseReport(const Pose& X_W) {
  return {{"position", toJson(X_W.p)}, {"quaternion", {X_W.q.w, X_W.q.x, X_W.q.y, X_W.q.z}}};
}

/// An entity's own frames, in the world.
ordered_json ownFrames(const workcell::Entity& entity) {
  ordered_json frames = ordered_json::array();
  for (const workcell::Frame& frame : entity.frames)
    frames.push_back({{"name", frame.name}, {"placement", poseReport(entity.X_WE * frame.X_EF)}});
  return frames;
}

/// A frame of the cell: where it stands, and what it goes with.
ordered_json frameReport(const workcell::Entity& entity) {
  ordered_json report = groupReport(entity.name, "frame", ordered_json::array());
  report["placement"] = poseReport(entity.X_WE);
  report["attached_to"] = entity.attachment.to.empty() ? ordered_json(nullptr) : ordered_json(entity.attachment.to);
  report["attached_link"] =
      entity.attachment.link.empty() ? ordered_json(nullptr) : ordered_json(entity.attachment.link);
  return report;
}

/// The box, in W, of a mesh's vertices.
geometry::Bounds placedBox(const geometry::TriangleMesh& mesh, const Pose& X_WM) {
  // Vertices for a thread to be worth it. Half, twice: no effect.
  constexpr std::size_t kLeast = 100'000;
  const std::size_t count = mesh.vertices.size();
  std::vector<geometry::Bounds> of_ranges(geometry::rangesOf(count, kLeast));
  geometry::inRanges(count, of_ranges.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    geometry::Bounds bounds;
    for (std::size_t k = begin; k < end; ++k) bounds.add(X_WM * mesh.vertices[k]);
    of_ranges[range] = bounds;
  });
  geometry::Bounds whole;
  for (const geometry::Bounds& bounds : of_ranges) whole.add(bounds);
  return whole;
}

}  // namespace

SolidFacts factsOf(const geometry::TriangleMesh& mesh) {
  geometry::TriangleMesh welded = mesh;
  geometry::weld(welded, geometry::weldTolerance(welded));
  return {geometry::enclosedVolume(mesh), geometry::isClosed(welded)};
}

ordered_json meshReport(const std::string& name, const geometry::TriangleMesh& mesh, const Pose& X_WM,
                        const std::array<float, 3>& color, const SolidFacts& facts) {
  const geometry::Bounds bounds = placedBox(mesh, X_WM);
  ordered_json report{{"name", name}, {"kind", "solid"}, {"color", colorReport(color[0], color[1], color[2])}};
  report["triangles"] = mesh.triangles.size();
  report["bounds"] = boundsReport(bounds);
  report["volume"] = facts.volume;
  report["closed"] = facts.closed;
  report["children"] = ordered_json::array();
  return report;
}

ordered_json entityReport(const workcell::Entity& entity) {
  switch (entity.kind()) {
    case workcell::EntityKind::kSolid:
      if (entity.mesh()) return meshReport(entity.name, *entity.mesh(), entity.X_WE, entity.color, factsOf(*entity.mesh()));
      break;
    case workcell::EntityKind::kRobot:
    case workcell::EntityKind::kMechanism:
    case workcell::EntityKind::kMannequin:
      return robotReport(entity);
    case workcell::EntityKind::kFrame:
      return frameReport(entity);
    case workcell::EntityKind::kAssembly:
      break;
  }
  return groupReport(entity.name, "assembly", ordered_json::array());
}

namespace {

/// The tree that `parent`s make; those that name no entity are mere folders.
class TreeReporter {
 public:
  explicit TreeReporter(const std::vector<workcell::Entity>& entities) : entities_(entities) {
    for (const workcell::Entity& entity : entities) names_.insert(entity.name);
    for (std::size_t k = 0; k < entities.size(); ++k) children_[entities[k].parent].push_back(k);
  }

  ordered_json report() {
    ordered_json tree = ordered_json::array();
    std::set<std::string> folders;
    for (const workcell::Entity& entity : entities_) {
      if (entity.parent.empty()) {
        tree.push_back(reportOf(entity));
      } else if (!names_.contains(entity.parent) && folders.insert(entity.parent).second) {
        tree.push_back(groupReport(entity.parent, "assembly", below(entity.parent)));
      }
    }
    return tree;
  }

 private:
  ordered_json below(const std::string& name) {
    ordered_json children = ordered_json::array();
    for (std::size_t k : children_[name]) children.push_back(reportOf(entities_[k]));
    return children;
  }

  ordered_json reportOf(const workcell::Entity& entity) {
    ordered_json children = entity.parent == entity.name ? ordered_json::array() : below(entity.name);
    if (entity.kind() == workcell::EntityKind::kAssembly) {
      return groupReport(entity.name, "assembly", std::move(children));
    }
    ordered_json own = entityReport(entity);
    for (ordered_json& child : children) own["children"].push_back(std::move(child));
    if (!entity.frames.empty()) own["frames"] = ownFrames(entity);
    return own;
  }

  const std::vector<workcell::Entity>& entities_;
  std::set<std::string> names_;
  std::map<std::string, std::vector<std::size_t>> children_;
};

}  // namespace

ordered_json treeReport(const std::vector<workcell::Entity>& entities) {
  return TreeReporter(entities).report();
}

ordered_json sceneReport(const workcell::ImportedScene& scene, std::span<const SolidFacts> known) {
  const std::vector<Pose> X_W = workcell::nodePoses(scene);
  std::vector<ordered_json> reports(scene.nodes.size());
  std::vector<ordered_json> children(scene.nodes.size(), ordered_json::array());
  std::map<int, ordered_json> shapes;  // What is the same for all uses of a mesh is worked out once.
  ordered_json tree = ordered_json::array();
  for (std::size_t k = scene.nodes.size(); k-- > 0;) {
    const workcell::SceneNode& node = scene.nodes[k];
    ordered_json& report = reports[k];
    std::reverse(children[k].begin(), children[k].end());
    if (node.robot) {
      workcell::Entity robot = workcell::robotEntity(node.robot, node.name);
      robot.X_WE = X_W[k];
      report = robotReport(robot);
    } else if (node.mesh < 0) {
      report = groupReport(node.name, "assembly", std::move(children[k]));
      if (node.color) report["color"] = colorReport((*node.color)[0], (*node.color)[1], (*node.color)[2]);
    } else {
      const auto number = static_cast<std::size_t>(node.mesh);
      const geometry::TriangleMesh& mesh = scene.meshes[number];
      const workcell::Entity plain;
      const auto color = node.color.value_or(plain.color);
      auto& shape = shapes[node.mesh];
      if (shape.is_null()) {
        const SolidFacts facts = number < known.size() ? known[number] : factsOf(mesh);
        shape = meshReport(node.name, mesh, Pose::identity(), color, facts);
      }
      report = shape;
      report["name"] = node.name;
      report["color"] = colorReport(color[0], color[1], color[2]);
      report["bounds"] = boundsReport(placedBox(mesh, X_W[k]));
      report["children"] = std::move(children[k]);
    }
    if (!node.instance.empty()) report["instance"] = node.instance;
    (node.parent < 0 ? tree : children[static_cast<std::size_t>(node.parent)]).push_back(std::move(report));
  }
  std::reverse(tree.begin(), tree.end());
  return tree;
}

}  // namespace hapticell::cli
