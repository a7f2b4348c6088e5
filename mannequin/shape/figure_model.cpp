// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/figure_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "geometry/system/assertion.h"
#include "mannequin/body/joint_limits.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/face_shape.h"
#include "mannequin/shape/hair_shape.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;
using kinematics::Joint;
using kinematics::JointType;

// m of the grids of what is drawn and what is checked (coarse); the outline is off by less than a cell. Half: four
// times the triangles, slower checks; twice: edges of fingers and faces are seen.
constexpr double kFineCell = 0.011, kCoarseCell = 0.024, kFineFinger = 0.0042, kCoarseFinger = 0.009,
                 kHeadCell = 0.0065;

const char* bodyName(std::size_t body) {
  if (body < kSegmentCount) return segmentInfo(static_cast<Segment>(body)).name;
  const std::size_t i = body - kSegmentCount, of_hand = kDigits * kPhalanges;
  const Side side = i < of_hand ? Side::kLeft : Side::kRight;
  return phalanxName(side, static_cast<Digit>(i % of_hand / kPhalanges), i % kPhalanges);
}

class ModelBuilder {
 public:
  explicit ModelBuilder(const Figure& figure) : figure_(figure), flesh_(fleshOf(figure)) {
    model_.name = "mannequin";
    model_.links.push_back({"floor", -1, {}, {}});
    model_.moving.assign(kModelVariables, -1);
  }

  std::shared_ptr<const kinematics::RobotModel> make() {
    std::array<int, kSegmentCount> link{};
    link[0] = addJoint({"humanoid_root", 0, rootInPelvis(figure_).inverse().p, bodyName(0)});
    dress(link[0], 0);
    for (std::size_t i = 1; i < kSegmentCount; ++i) {
      const Segment segment = static_cast<Segment>(i);
      link[i] = addSegment(segment, link[indexOf(*segmentInfo(segment).parent)]);
    }
    for (const Side side : {Side::kLeft, Side::kRight}) addFingers(side, link[indexOf(armSegment(side, S::kLeftHand))]);
    addEyes(link[indexOf(S::kHead)]);
    return std::make_shared<const kinematics::RobotModel>(std::move(model_));
  }

 private:
  struct NewJoint {
    std::string name;
    int parent = 0;
    dvec3 p_PJ{0.0};
    std::string link;
  };

  /// A fixed joint with its new link; the link's index.
  int addJoint(const NewJoint& wanted) {
    Joint joint;
    joint.name = wanted.name;
    joint.parent_link = wanted.parent;
    joint.child_link = static_cast<int>(model_.links.size());
    joint.X_PJ = Pose::translation(wanted.p_PJ);
    model_.links.push_back({wanted.link, static_cast<int>(model_.joints.size()), {}, {}});
    model_.joints.push_back(joint);
    return joint.child_link;
  }

  int addTurn(const NewJoint& wanted, Dof dof) {
    const int link = addJoint(wanted);
    const DofInfo& info = dofInfo(dof);
    Joint& joint = model_.joints.back();
    joint.type = JointType::kRevolute;
    joint.axis_J = dvec3(0.0);
    joint.axis_J[info.axis] = info.sign;
    // Any orientation of a ball joint must have its three angles within the model's bounds.
    joint.lower = isCoupled(dof) ? -std::numbers::pi : info.lower;
    joint.upper = isCoupled(dof) ? std::numbers::pi : info.upper;
    joint.variable = static_cast<int>(indexOf(dof));
    model_.moving[indexOf(dof)] = static_cast<int>(model_.joints.size()) - 1;
    return link;
  }

  /// The turns of a segment, about y, x and z in this order, as far as it has them.
  int addSegment(Segment segment, int parent) {
    std::vector<Dof> turns;
    for (const int axis : {1, 0, 2}) {
      for (std::size_t k = 0; k < kDofCount; ++k) {
        const DofInfo& info = dofInfo(static_cast<Dof>(k));
        const std::string_view joint = info.joint;
        const bool finger = joint.find("index") != joint.npos || joint.find("thumb") != joint.npos;
        if (info.segment == segment && info.axis == axis && !finger) turns.push_back(static_cast<Dof>(k));
      }
    }
    dvec3 offset = figure_.p_PS[indexOf(segment)];
    for (std::size_t i = 0; i < turns.size(); ++i) {
      const std::string name = dofInfo(turns[i]).name;
      const bool last = i + 1 == turns.size();
      parent = addTurn({name, parent, offset, last ? bodyName(indexOf(segment)) : name + "_link"}, turns[i]);
      offset = dvec3(0.0);
    }
    dress(parent, indexOf(segment));
    return parent;
  }

  void addFingers(Side side, int hand) {
    const auto bones = phalangesOf(figure_, side);
    const int curl = addCarrier(side, hand, Dof::kLeftFingersCurl);
    const int flexion = addCarrier(side, hand, Dof::kLeftThumbFlexion);
    for (std::size_t d = 0; d < kDigits; ++d) {
      int parent = hand;
      for (std::size_t k = 0; k < kPhalanges; ++k) {
        const NewJoint joint{std::string(phalanxName(side, static_cast<Digit>(d), k)) + "_joint", parent,
                             bones[d][k].p_Joint, bodyName(phalanxBody(side, d, k))};
        if (d == 0 && k == 0) {
          parent = addTurn({dofInfo(armDof(side, Dof::kLeftThumbAbduction)).name, parent, joint.p_PJ, joint.link},
                           armDof(side, Dof::kLeftThumbAbduction));
        } else {
          parent = addMimic(joint, d == 0 ? flexion : curl);
        }
        dress(parent, phalanxBody(side, d, k));
      }
    }
  }

  /// A variable that moves nothing itself, for others to follow; the index of its joint.
  int addCarrier(Side side, int hand, Dof left) {
    const std::string name = dofInfo(armDof(side, left)).name;
    addTurn({name, hand, dvec3(0.0), name + "_link"}, armDof(side, left));
    return static_cast<int>(model_.joints.size()) - 1;
  }

  int addMimic(const NewJoint& wanted, int followed) {
    const int link = addJoint(wanted);
    const Joint& leader = model_.joints[static_cast<std::size_t>(followed)];
    Joint& joint = model_.joints.back();
    joint.type = JointType::kRevolute;
    joint.axis_J = leader.axis_J;
    joint.lower = leader.lower;
    joint.upper = leader.upper;
    joint.mimic = kinematics::Mimic{followed, 1.0, 0.0};
    return link;
  }

  /// The left eye turns by the gaze, the right one along with it.
  void addEyes(int head) {
    int yaw = -1, pitch = -1;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::string name = side == Side::kLeft ? "l_eyeball" : "r_eyeball";
      const bool leads = side == Side::kLeft;
      const int turned =
          addJoint({leads ? "gaze_yaw" : name + "_yaw", head, eyeCentre(figure_, side), name + "_yaw_link"});
      yaw = turnEye({2, -kGazeYawLimit, kGazeYawLimit}, yaw);
      const int eye = addJoint({leads ? "gaze_pitch" : name + "_pitch", turned, dvec3(0.0), name});
      pitch = turnEye({1, -kGazeUpLimit, kGazeDownLimit}, pitch);
      for (FacePiece& piece : eyePieces(figure_)) wear(eye, piece.color, std::move(piece.mesh));
    }
  }

  struct EyeTurn {
    int axis;
    double lower, upper;
  };
  /// Makes the newest joint a turn of an eye: a variable of its own, or one that goes along with another.
  int turnEye(const EyeTurn& turn, int followed) {
    const int index = static_cast<int>(model_.joints.size()) - 1;
    Joint& joint = model_.joints.back();
    joint.type = JointType::kRevolute;
    joint.axis_J = dvec3(0.0);
    joint.axis_J[turn.axis] = 1.0;
    joint.lower = turn.lower;
    joint.upper = turn.upper;
    if (followed >= 0) {
      joint.mimic = kinematics::Mimic{followed, 1.0, 0.0};
      return followed;
    }
    joint.variable = static_cast<int>(kDofCount) + (turn.axis == 2 ? 0 : 1);
    model_.moving[static_cast<std::size_t>(joint.variable)] = index;
    return index;
  }

  void wear(int link, const std::array<float, 3>& color, geometry::TriangleMesh mesh) {
    kinematics::LinkShape shape;
    shape.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
    shape.color = {color[0], color[1], color[2], 1.0f};
    shape.source = "body";
    model_.links[static_cast<std::size_t>(link)].visuals.push_back(std::move(shape));
  }

  void dress(int link, std::size_t body) {
    const bool finger = body >= kSegmentCount;
    const bool hand = body == indexOf(S::kLeftHand) || body == indexOf(S::kRightHand);
    const Flesh& flesh = flesh_[body];
    const bool head = body == indexOf(S::kHead);
    kinematics::LinkShape checked;
    double coarse = hand ? 0.5 * kCoarseCell : kCoarseCell;
    double fine = head ? kHeadCell : kFineCell;
    if (finger) coarse = kCoarseFinger;
    if (finger || hand) fine = kFineFinger;
    checked.mesh = std::make_shared<const geometry::TriangleMesh>(bodyMesh(flesh, coarse));
    checked.color = {flesh.color[0], flesh.color[1], flesh.color[2], 1.0f};
    checked.source = "body";
    model_.links[static_cast<std::size_t>(link)].collisions.push_back(std::move(checked));
    wear(link, flesh.color, bodyMesh(flesh, fine));
    if (!head) return;
    wear(link, kHairColor, hairMesh(figure_, kHeadCell));
    for (FacePiece& piece : facePieces(figure_)) wear(link, piece.color, std::move(piece.mesh));
  }

  const Figure& figure_;
  std::vector<Flesh> flesh_;
  kinematics::RobotModel model_;
};

}  // namespace

Pose rootInPelvis(const Figure& figure) {
  return Pose::translation({0.0, 0.0, -figure.p_PS[0].z});
}

std::shared_ptr<const kinematics::RobotModel> figureModel(const Figure& figure) {
  return ModelBuilder(figure).make();
}

ModelConfiguration toModel(const Figure& figure, const Posture& posture) {
  ModelConfiguration configuration{posture.X_WR * rootInPelvis(figure), {posture.angles.begin(), posture.angles.end()}};
  configuration.joints.push_back(posture.gaze.yaw);
  configuration.joints.push_back(posture.gaze.pitch);
  return configuration;
}

Posture toPosture(const Figure& figure, const ModelConfiguration& configuration) {
  HAPTICELL_DEMAND(configuration.joints.size() == kModelVariables);
  Posture posture;
  posture.X_WR = configuration.X_WE * rootInPelvis(figure).inverse();
  std::copy_n(configuration.joints.begin(), kDofCount, posture.angles.begin());
  posture.gaze = {configuration.joints[kDofCount], configuration.joints[kDofCount + 1]};
  return posture;
}

int bodyOfLink(const kinematics::RobotModel& model, int link) {
  const std::string& name = model.links[static_cast<std::size_t>(link)].name;
  for (std::size_t body = 0; body < kBodies; ++body) {
    if (name == bodyName(body)) return static_cast<int>(body);
  }
  return -1;
}

}  // namespace hapticell::mannequin
