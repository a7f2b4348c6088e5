// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/robot_differential.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "manipulation/manipulators/closure_jets.h"
#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {

namespace {

using kinematics::Joint;
using kinematics::JointType;
using kinematics::RobotModel;
using Matrix6 = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Singular value, m (rotation times the lever), as kWall: from there on joints are damped. Half: twice the joint
/// speeds there; twice: the tool lags farther from it.
constexpr double kDampedBelow = 0.02;
/// m/rad2: under this a singularity is no edge of the workspace (wrist, shoulder); an elbow's is of the order of a
/// link's length. Half: small robots' wrists are felt as edges; twice: their elbows are not.
constexpr double kFoldCurvature = 0.02;

/// Velocities and accelerations of all links for joint rates and accelerations, in W.
struct LinkMotion {
  std::vector<dvec3> w, v, alpha, a;
};

/// One robot at one configuration: what the recursion needs.
struct Arm {
  const RobotModel& model;
  std::vector<Pose> X_WL;
  int tip;
  dvec3 p_WTcp;
  const ClosureJets* jets = nullptr;  ///< Of a robot with a closure.
};

double factorOf(const RobotModel& model, const Joint& joint, int& variable) {
  variable = joint.variable;
  if (!joint.mimic) return 1.0;
  variable = model.joints[static_cast<std::size_t>(joint.mimic->joint)].variable;
  return joint.mimic->multiplier;
}

/// The same for a robot with a closure, from its derivatives over the variables.
void moveClosedLinks(const ClosureJets& jets, const Eigen::VectorXd& u, const Eigen::VectorXd& du, LinkMotion& motion) {
  const auto n = static_cast<std::size_t>(u.size());
  for (auto* part : {&motion.w, &motion.v, &motion.alpha, &motion.a}) part->assign(jets.links(), dvec3(0.0));
  for (std::size_t i = 0; i < n; ++i) {
    const double rate = u[static_cast<Eigen::Index>(i)], acceleration = du[static_cast<Eigen::Index>(i)];
    for (std::size_t k = 0; k < jets.links(); ++k) {
      const Twist& V = jets.velocity(i, k);
      motion.v[k] += V.linear * rate;
      motion.w[k] += V.angular * rate;
      motion.a[k] += V.linear * acceleration;
      motion.alpha[k] += V.angular * acceleration;
      for (std::size_t j = 0; j < n; ++j) {
        const Twist& A = jets.acceleration(i, j, k);
        const double product = rate * u[static_cast<Eigen::Index>(j)];
        motion.a[k] += A.linear * product;
        motion.alpha[k] += A.angular * product;
      }
    }
  }
}

/// The usual outward recursion (Featherstone 2008, section 4), joint rates `u` and accelerations `du` one a variable.
void moveLinks(const Arm& arm, const Eigen::VectorXd& u, const Eigen::VectorXd& du, LinkMotion& motion) {
  if (arm.jets) return moveClosedLinks(*arm.jets, u, du, motion);
  const std::size_t n = arm.model.links.size();
  for (auto* part : {&motion.w, &motion.v, &motion.alpha, &motion.a}) part->assign(n, dvec3(0.0));
  for (const Joint& joint : arm.model.joints) {
    const auto parent = static_cast<std::size_t>(joint.parent_link), child = static_cast<std::size_t>(joint.child_link);
    int variable = -1;
    const double factor = factorOf(arm.model, joint, variable);
    const bool moves = joint.type != JointType::kFixed && variable >= 0;
    const double rate = moves ? factor * u[variable] : 0.0, acceleration = moves ? factor * du[variable] : 0.0;
    const dvec3 axis = arm.X_WL[child].rotate(joint.axis_J);
    const dvec3 lever = arm.X_WL[child].p - arm.X_WL[parent].p;
    const dvec3 &w = motion.w[parent], &alpha = motion.alpha[parent];
    motion.w[child] = w;
    motion.alpha[child] = alpha;
    motion.v[child] = motion.v[parent] + glm::cross(w, lever);
    motion.a[child] = motion.a[parent] + glm::cross(alpha, lever) + glm::cross(w, glm::cross(w, lever));
    if (joint.type == JointType::kPrismatic) {
      motion.v[child] += axis * rate;
      motion.a[child] += axis * acceleration + 2.0 * glm::cross(w, axis * rate);
    } else {
      motion.w[child] += axis * rate;
      motion.alpha[child] += axis * acceleration + glm::cross(w, axis * rate);
    }
  }
}

Eigen::Matrix<double, 6, 1> tcpVelocity(const Arm& arm, const LinkMotion& motion) {
  const auto tip = static_cast<std::size_t>(arm.tip);
  const dvec3 v = motion.v[tip] + glm::cross(motion.w[tip], arm.p_WTcp - arm.X_WL[tip].p);
  Eigen::Matrix<double, 6, 1> result;
  result << v.x, v.y, v.z, motion.w[tip].x, motion.w[tip].y, motion.w[tip].z;
  return result;
}

Eigen::Matrix<double, 6, 1> tcpAcceleration(const Arm& arm, const LinkMotion& motion) {
  const auto tip = static_cast<std::size_t>(arm.tip);
  const dvec3 lever = arm.p_WTcp - arm.X_WL[tip].p;
  const dvec3& w = motion.w[tip];
  const dvec3 a = motion.a[tip] + glm::cross(motion.alpha[tip], lever) + glm::cross(w, glm::cross(w, lever));
  Eigen::Matrix<double, 6, 1> result;
  result << a.x, a.y, a.z, motion.alpha[tip].x, motion.alpha[tip].y, motion.alpha[tip].z;
  return result;
}

/// The Jacobian's decomposition with rotation weighed, and the damped inverse.
struct Inverse {
  Eigen::MatrixXd plus;  ///< n x 6, over unweighed twists.
  Eigen::MatrixXd u, v;  ///< Singular vectors, column by column, the least value first.
  Eigen::VectorXd s;
};

Inverse invert(const Matrix6& J) {
  Eigen::Matrix<double, 6, 1> weights;
  weights << 1.0, 1.0, 1.0, haptic::kRotationLever, haptic::kRotationLever, haptic::kRotationLever;
  const Eigen::MatrixXd weighed = weights.asDiagonal() * J;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(weighed, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& s = svd.singularValues();
  Eigen::VectorXd reciprocal(s.size());
  Inverse inverse;
  for (Eigen::Index k = 0; k < s.size(); ++k) {
    const double missing = std::max(0.0, 1.0 - (s[k] / kDampedBelow) * (s[k] / kDampedBelow));
    const double damping = missing * kDampedBelow * kDampedBelow;
    reciprocal[k] = s[k] > 1e-12 ? s[k] / (s[k] * s[k] + damping) : 0.0;
  }
  inverse.plus = svd.matrixV() * reciprocal.asDiagonal() * svd.matrixU().transpose() * weights.asDiagonal();
  const Eigen::Index moving = (weighed.colwise().norm().array() > 1e-9).count();
  const Eigen::Index rank = std::min<Eigen::Index>(6, moving);
  inverse.s = s.head(rank).reverse();
  inverse.u = svd.matrixU().leftCols(rank).rowwise().reverse();
  inverse.v = svd.matrixV().leftCols(rank).rowwise().reverse();
  return inverse;
}

// A wrist that is singular too hides the arm's own edge behind a smaller value: all of them are looked at.
void findEdge(const Arm& arm, const Inverse& inverse, RobotDifferential& result) {
  /// rad to the fold, from where one quadratic term says enough (off by a twelfth of its square, 0.75 %). Half: the
  /// edge appears late; twice: it is 3 % off.
  constexpr double kNearTurn = 0.3;
  Eigen::Matrix<double, 6, 1> weights;
  weights << 1.0, 1.0, 1.0, haptic::kRotationLever, haptic::kRotationLever, haptic::kRotationLever;
  for (Eigen::Index k = 0; k < inverse.s.size(); ++k) {
    LinkMotion motion;
    moveLinks(arm, inverse.v.col(k), Eigen::VectorXd::Zero(inverse.v.rows()), motion);
    const Eigen::Matrix<double, 6, 1> u = inverse.u.col(k);
    const double c = u.dot(weights.asDiagonal() * tcpAcceleration(arm, motion));
    if (std::abs(c) < kFoldCurvature || (k > 0 && inverse.s[k] > kNearTurn * std::abs(c))) continue;
    const double gap = inverse.s[k] * inverse.s[k] / (2.0 * std::abs(c));
    if (result.has_edge && gap >= result.edge.gap) continue;
    result.has_edge = true;
    result.edge.gap = gap;
    const Eigen::Matrix<double, 6, 1> gradient = (c > 0.0 ? 1.0 : -1.0) * (weights.asDiagonal() * u);
    for (std::size_t i = 0; i < 6; ++i) result.edge.gradient[i] = gradient[static_cast<Eigen::Index>(i)];
  }
}

/// Links' and joints' quadratic terms along one direction of the TCP: J q'' = -J' q'.
struct Quadratic {
  LinkMotion links;
  Eigen::VectorXd joints;
};

Quadratic alongDirection(const Arm& arm, const Eigen::MatrixXd& plus, const Eigen::Matrix<double, 6, 1>& direction) {
  Quadratic result;
  const Eigen::VectorXd rates = plus * direction;
  moveLinks(arm, rates, Eigen::VectorXd::Zero(rates.size()), result.links);
  result.joints = -plus * tcpAcceleration(arm, result.links);
  moveLinks(arm, rates, result.joints, result.links);
  return result;
}

void fillVelocities(const Arm& arm, const Eigen::MatrixXd& plus, RobotDifferential& result) {
  LinkMotion motion;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(plus.rows());
  for (std::size_t i = 0; i < 6; ++i) {
    moveLinks(arm, plus.col(static_cast<Eigen::Index>(i)), rest, motion);
    for (std::size_t k = 0; k < result.links.size(); ++k) result.links[k].velocity[i] = {motion.v[k], motion.w[k]};
    for (std::size_t q = 0; q < result.joint_velocity.size(); ++q) {
      result.joint_velocity[q][i] = plus(static_cast<Eigen::Index>(q), static_cast<Eigen::Index>(i));
    }
  }
}

/// The bilinear terms by polarisation, Q(i, j) = (Q(i + j) - Q(i) - Q(j)) / 2.
void fillAccelerations(const Arm& arm, const Eigen::MatrixXd& plus, RobotDifferential& result) {
  std::array<Quadratic, 6> single;
  for (int i = 0; i < 6; ++i) {
    single[static_cast<std::size_t>(i)] = alongDirection(arm, plus, Eigen::Matrix<double, 6, 1>::Unit(i));
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = i; j < 6; ++j) {
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      const std::size_t at = packedIndex(i, j);
      const Quadratic both =
          i == j ? single[i]
                 : alongDirection(arm, plus,
                                  Eigen::Matrix<double, 6, 1>::Unit(row) + Eigen::Matrix<double, 6, 1>::Unit(column));
      const auto polarised = [&](const auto& whole, const auto& first, const auto& second) {
        return i == j ? whole : decltype(whole + whole)(0.5 * (whole - first - second));
      };
      for (std::size_t k = 0; k < result.links.size(); ++k) {
        result.links[k].acceleration[at] = {
            polarised(both.links.a[k], single[i].links.a[k], single[j].links.a[k]),
            polarised(both.links.alpha[k], single[i].links.alpha[k], single[j].links.alpha[k])};
      }
      for (std::size_t q = 0; q < result.joint_acceleration.size(); ++q) {
        const auto v = static_cast<Eigen::Index>(q);
        result.joint_acceleration[q][at] = polarised(both.joints[v], single[i].joints[v], single[j].joints[v]);
      }
    }
  }
}

void addMargins(const ClosureJets& jets, const Eigen::MatrixXd& plus, RobotDifferential& result) {
  for (const ClosureJets::Margin& margin : jets.margins()) {
    const Eigen::Map<const Eigen::VectorXd> over_q(margin.gradient.data(),
                                                   static_cast<Eigen::Index>(margin.gradient.size()));
    const Eigen::VectorXd over_xi = plus.transpose() * over_q;
    RobotDifferential::Margin made{margin.at, {}};
    made.constraint.gap = margin.at.value;
    for (std::size_t i = 0; i < 6; ++i) made.constraint.gradient[i] = over_xi[static_cast<Eigen::Index>(i)];
    result.margins.push_back(std::move(made));
  }
}

}  // namespace

RobotDifferential differentiateRobot(const RobotModel& model, const std::vector<double>& q, const Pose& X_WB, int tip,
                                     const Pose& X_LT) {
  Arm arm{model, {}, tip, {}, nullptr};
  std::optional<ClosureJets> jets;
  if (model.closure) {
    arm.jets = &jets.emplace(model, q, X_WB);
    arm.X_WL = jets->poses();
  } else {
    kinematics::forwardKinematics(model, q, arm.X_WL);
    for (Pose& X_WL : arm.X_WL) X_WL = X_WB * X_WL;
  }
  arm.p_WTcp = (arm.X_WL[static_cast<std::size_t>(tip)] * X_LT).p;

  const auto n = static_cast<Eigen::Index>(model.dof());
  Matrix6 J(6, n);
  LinkMotion motion;
  for (Eigen::Index variable = 0; variable < n; ++variable) {
    moveLinks(arm, Eigen::VectorXd::Unit(n, variable), Eigen::VectorXd::Zero(n), motion);
    J.col(variable) = tcpVelocity(arm, motion);
  }
  const Inverse inverse = invert(J);

  RobotDifferential result;
  result.links.resize(model.links.size());
  result.joint_velocity.resize(model.dof());
  result.joint_acceleration.resize(model.dof());
  for (std::size_t k = 0; k < result.links.size(); ++k) result.links[k].p_WPo = arm.X_WL[k].p;
  fillVelocities(arm, inverse.plus, result);
  fillAccelerations(arm, inverse.plus, result);
  findEdge(arm, inverse, result);
  if (jets) addMargins(*jets, inverse.plus, result);
  return result;
}

}  // namespace hapticell::manipulation
