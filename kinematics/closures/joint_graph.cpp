// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/joint_graph.h"

#include <deque>

#include "kinematics/model/turns.h"

namespace hapticell::kinematics {

namespace {

// m: an origin is on the joint's axis; some thousand roundings of a place at 1 m. Half, twice: no effect but a frame
// more or less in the tree.
constexpr double kSamePoint = 1e-12;

Pose plainAt(const dvec3& p, const Pose& X_ML) {
  return {p, X_ML.q};
}

/// Builds the tree; the graph's links and joints are counted apart from the model's.
class TreeMaker {
 public:
  explicit TreeMaker(const JointGraph& graph) : graph_(graph) {
    model_.name = graph.name;
    link_of_.assign(graph.links.size(), -1);
    joint_of_.assign(graph.joints.size(), -1);
  }

  Expected<RobotModel> make(const LoopOptions& options) {
    addRoot();
    std::deque<int> open{graph_.root};
    std::vector<bool> used(graph_.joints.size(), false);
    while (!open.empty()) {
      const int link = open.front();
      open.pop_front();
      for (std::size_t j = 0; j < graph_.joints.size(); ++j) {
        const Joint& joint = graph_.joints[j].joint;
        if (used[j] || (joint.parent_link != link && joint.child_link != link)) continue;
        used[j] = true;
        const int other = joint.parent_link == link ? joint.child_link : joint.parent_link;
        if (link_of_[static_cast<std::size_t>(other)] >= 0) {
          closeLoop(j, link, other);
        } else {
          addJoint(j, link, &graph_.links[static_cast<std::size_t>(other)], other);
          open.push_back(other);
        }
      }
    }
    for (std::size_t k = 0; k < link_of_.size(); ++k) {
      if (link_of_[k] >= 0) continue;
      return makeError({.place = Text("link '%1'", graph_.links[k].link.name),
                        .found = Text("no joint connects it to the root link '%1'",
                                      graph_.links[static_cast<std::size_t>(graph_.root)].link.name),
                        .expected = "a joint",
                        .fix = "Connect it with a joint, for example a fixed joint."});
    }
    for (std::size_t j = 0; j < graph_.joints.size(); ++j) setMimic(j);
    if (!loops_.empty()) {
      if (auto closed = LoopClosure::close(model_, std::move(loops_), options); !closed)
        return makeError(closed.error());
    }
    return std::move(model_);
  }

 private:
  void addRoot() {
    const GraphLink& root = graph_.links[static_cast<std::size_t>(graph_.root)];
    Link link = root.link;
    link.parent_joint = -1;
    model_.links.push_back(std::move(link));
    X_ML_.push_back(root.X_ML);
    link_of_[static_cast<std::size_t>(graph_.root)] = 0;
  }

  int addLink(Link link, const Pose& X_ML, int parent_joint) {
    link.parent_joint = parent_joint;
    model_.links.push_back(std::move(link));
    X_ML_.push_back(X_ML);
    return static_cast<int>(model_.links.size()) - 1;
  }

  /// The joint from the model's link of graph link `from` to a new link with frame at X_MJ (turned like `X_ML`).
  int addElement(Joint joint, int parent, int child, const Pose& X_MChild) {
    joint.parent_link = parent;
    joint.child_link = child;
    joint.X_PJ = X_ML_[static_cast<std::size_t>(parent)].inverse() * X_MChild;
    if (joint.type != JointType::kFixed && !joint.mimic) {
      joint.variable = static_cast<int>(model_.moving.size());
      model_.moving.push_back(static_cast<int>(model_.joints.size()));
    }
    model_.joints.push_back(std::move(joint));
    return static_cast<int>(model_.joints.size()) - 1;
  }

  /// Adds the joint and the link behind it: the graph's own, or (null) an empty one that closes a loop.
  int addJoint(std::size_t j, int from, const GraphLink* to, int to_index) {
    const GraphJoint& source = graph_.joints[j];
    const int parent = link_of_[static_cast<std::size_t>(from)];
    Joint joint = source.joint;
    joint.variable = -1;
    const Pose X_MLink = to ? to->X_ML : graph_.links[static_cast<std::size_t>(to_index)].X_ML;
    const bool fixed = joint.type == JointType::kFixed;
    const bool on_axis =
        fixed || joint.type == JointType::kPrismatic || glm::length(source.X_MJ.p - X_MLink.p) < kSamePoint;
    const Pose X_MNew = on_axis ? X_MLink : plainAt(source.X_MJ.p, X_MLink);
    const dvec3 axis_M = source.X_MJ.rotate(joint.axis_J);
    const double sign = source.joint.parent_link == from ? 1.0 : -1.0;
    joint.axis_J = sign * X_MNew.inverse().rotate(axis_M);
    const int next_joint = static_cast<int>(model_.joints.size());
    Link link;
    if (!to) {
      link.name = source.joint.name + " closure";
    } else if (on_axis) {
      link = to->link;
    } else {
      link.name = source.joint.name + " axis";
    }
    int child = addLink(std::move(link), X_MNew, next_joint);
    joint_of_[j] = addElement(std::move(joint), parent, child, X_MNew);
    if (to && !on_axis) {
      Joint rest;
      rest.name = source.joint.name + " offset";
      child = addLink(to->link, to->X_ML, static_cast<int>(model_.joints.size()));
      addElement(std::move(rest), child - 1, child, to->X_ML);
    }
    if (to) link_of_[static_cast<std::size_t>(to_index)] = child;
    return child;
  }

  void closeLoop(std::size_t j, int from, int to) {
    const GraphJoint& source = graph_.joints[j];
    LoopConstraint loop;
    loop.kind = LoopConstraint::Kind::kWeld;
    loop.name = source.joint.name;
    loop.link_b = link_of_[static_cast<std::size_t>(to)];
    loop.link_a = source.joint.type == JointType::kFixed ? link_of_[static_cast<std::size_t>(from)]
                                                         : addJoint(j, from, nullptr, to);
    const Pose X_MC = X_ML_[static_cast<std::size_t>(loop.link_a)];
    loop.X_BC = X_ML_[static_cast<std::size_t>(loop.link_b)].inverse() * X_MC;
    loops_.push_back(std::move(loop));
  }

  void setMimic(std::size_t j) {
    const auto& source = graph_.joints[j].joint.mimic;
    if (!source) return;
    model_.joints[static_cast<std::size_t>(joint_of_[j])].mimic->joint =
        joint_of_[static_cast<std::size_t>(source->joint)];
  }

  const JointGraph& graph_;
  RobotModel model_;
  std::vector<Pose> X_ML_;     // Of the model's links.
  std::vector<int> link_of_;   // Graph link -> model link.
  std::vector<int> joint_of_;  // Graph joint -> model joint.
  std::vector<LoopConstraint> loops_;
};

}  // namespace

Expected<RobotModel> modelOfGraph(const JointGraph& graph, const LoopOptions& options) {
  return TreeMaker(graph).make(options);
}

void addCompoundJoint(JointGraph& graph, const GraphJoint& prototype, const std::vector<dvec3>& axes_J) {
  int from = prototype.joint.parent_link;
  for (std::size_t k = 0; k < axes_J.size(); ++k) {
    GraphJoint one = prototype;
    std::string suffix;
    if (axes_J.size() > 1) suffix.append("_").append(std::to_string(k + 1));
    one.joint.name += suffix;
    one.joint.axis_J = axes_J[k];
    one.joint.parent_link = from;
    if (k + 1 < axes_J.size()) {
      Link between;
      between.name = prototype.joint.name + suffix + " cross";
      graph.links.push_back({std::move(between), prototype.X_MJ});
      one.joint.child_link = static_cast<int>(graph.links.size()) - 1;
      from = one.joint.child_link;
    }
    graph.joints.push_back(std::move(one));
  }
}

void addScrewJoint(JointGraph& graph, const GraphJoint& prototype, double pitch) {
  Link between;
  between.name = prototype.joint.name + " nut";
  graph.links.push_back({std::move(between), prototype.X_MJ});
  GraphJoint turn = prototype, slide = prototype;
  turn.joint.child_link = slide.joint.parent_link = static_cast<int>(graph.links.size()) - 1;
  slide.joint.name += "_slide";
  slide.joint.type = JointType::kPrismatic;
  slide.joint.lower = turn.joint.lower * pitch / kTurn;
  slide.joint.upper = turn.joint.upper * pitch / kTurn;
  if (slide.joint.lower > slide.joint.upper) std::swap(slide.joint.lower, slide.joint.upper);
  if (slide.joint.mimic) {  // The turn follows another joint, so does the slide.
    slide.joint.mimic->multiplier *= pitch / kTurn;
    slide.joint.mimic->offset *= pitch / kTurn;
  } else {
    slide.joint.mimic = Mimic{static_cast<int>(graph.joints.size()), pitch / kTurn, 0.0};
  }
  graph.joints.push_back(std::move(turn));
  graph.joints.push_back(std::move(slide));
}

}  // namespace hapticell::kinematics
