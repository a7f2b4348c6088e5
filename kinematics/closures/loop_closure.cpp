// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/loop_closure.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"
#include "kinematics/closures/closure_inverse.h"
#include "kinematics/model/jacobian.h"

namespace hapticell::kinematics {

namespace {

// m, root mean square of all equations times the mechanism's size; some thousand roundings. Half: one more iteration,
// may stall at rounding; twice: Newton's next step is saved.
constexpr double kClosed = 1e-12;
// m: what still counts as closed where the loop is singular and rounding ends the descent; as kAccepted of the serial
// arms. Half: more singular poses are refused; twice: gaps of 2e-9 m are drawn.
constexpr double kAssembled = 1e-9;
// rad, or part of the size: of the set joints, while following them; chosen by trial, so that a loop keeps its
// assembly. Half: twice the steps after a jump; twice: a four-bar may flip.
constexpr double kLongestStride = 0.15;
// Damped Newton steps that a stride may take, as kFull of closure_inverse.cpp. Half: loops near a dead centre may count
// as open; twice: longer until a loop that cannot close is reported.
constexpr int kIterations = 60;

Error refusal(const RobotModel& model, const Text& found, const Text& expected, const Text& fix) {
  return {.place = Text("the loops of robot '%1'", model.name), .found = found, .expected = expected, .fix = fix};
}

int equationsOf(LoopConstraint::Kind kind) {
  if (kind == LoopConstraint::Kind::kPoint) return 3;
  return kind == LoopConstraint::Kind::kAxis ? 5 : 6;
}

}  // namespace

/// The equations of all loops at one position of the tree.
struct LoopSolver {
  explicit LoopSolver(const LoopClosure& of) : closure(of) {}

  const LoopClosure& closure;
  std::vector<Pose> X_BL;
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;  ///< One column a variable of the tree.

  Eigen::Index equations() const {
    Eigen::Index count = 0;
    for (const LoopConstraint& loop : closure.loops_) count += equationsOf(loop.kind);
    return count;
  }

  void evaluate(const std::vector<double>& x, bool with_jacobian) {
    forwardKinematics(closure.tree_, x, X_BL);
    residual.resize(equations());
    if (with_jacobian) jacobian.setZero(equations(), static_cast<Eigen::Index>(x.size()));
    Eigen::Index row = 0;
    for (const LoopConstraint& loop : closure.loops_) {
      const Pose A = X_BL[static_cast<std::size_t>(loop.link_a)] * loop.X_AC;
      const Pose B = X_BL[static_cast<std::size_t>(loop.link_b)] * loop.X_BC;
      writeRows(loop.kind, row, {A.p - B.p, turnBetween(loop.kind, A, B)});
      if (with_jacobian) {
        addColumns(loop, row, loop.link_a, A.p, 1.0);
        addColumns(loop, row, loop.link_b, B.p, -1.0);
      }
      row += equationsOf(loop.kind);
    }
  }

 private:
  /// Rotation vector from B to A; for an axis the two components that tilt it, in a frame across B's z.
  dvec3 turnBetween(LoopConstraint::Kind kind, const Pose& A, const Pose& B) {
    if (kind == LoopConstraint::Kind::kPoint) return dvec3(0.0);
    if (kind == LoopConstraint::Kind::kWeld) return rotationVector(A.q * glm::conjugate(B.q));
    across_u_ = B.rotate({1, 0, 0});
    across_v_ = B.rotate({0, 1, 0});
    return glm::cross(B.rotate({0, 0, 1}), A.rotate({0, 0, 1}));
  }

  void put(Eigen::Ref<Eigen::VectorXd> rows, LoopConstraint::Kind kind, const Twist& t) const {
    for (int i = 0; i < 3; ++i) rows[i] = t.linear[i];
    if (kind == LoopConstraint::Kind::kPoint) return;
    const double lever = closure.size_;
    if (kind == LoopConstraint::Kind::kWeld) {
      for (int i = 0; i < 3; ++i) rows[3 + i] = lever * t.angular[i];
    } else {
      rows[3] = lever * glm::dot(across_u_, t.angular);
      rows[4] = lever * glm::dot(across_v_, t.angular);
    }
  }

  void writeRows(LoopConstraint::Kind kind, Eigen::Index row, const Twist& t) {
    put(residual.segment(row, equationsOf(kind)), kind, t);
  }

  void addColumns(const LoopConstraint& loop, Eigen::Index row, int link, const dvec3& p_BC, double sign) {
    const RobotModel& tree = closure.tree_;
    for (int index = tree.links[static_cast<std::size_t>(link)].parent_joint; index >= 0;) {
      const Joint& joint = tree.joints[static_cast<std::size_t>(index)];
      index = tree.links[static_cast<std::size_t>(joint.parent_link)].parent_joint;
      if (joint.type == JointType::kFixed) continue;
      const Joint& driver = joint.mimic ? tree.joints[static_cast<std::size_t>(joint.mimic->joint)] : joint;
      if (driver.variable < 0) continue;
      const Pose& X_BJ = X_BL[static_cast<std::size_t>(joint.child_link)];
      const dvec3 axis = sign * (joint.mimic ? joint.mimic->multiplier : 1.0) * X_BJ.rotate(joint.axis_J);
      Twist t{axis, dvec3(0.0)};
      if (joint.type != JointType::kPrismatic) t = {glm::cross(axis, p_BC - X_BJ.p), axis};
      Eigen::VectorXd rows(equationsOf(loop.kind));
      put(rows, loop.kind, t);
      jacobian.col(driver.variable).segment(row, rows.size()) += rows;
    }
  }

  dvec3 across_u_{0.0}, across_v_{0.0};
};

namespace {

/// Levenberg-Marquardt on the chosen variables until the loops are closed; x is left at the best position.
bool closeBy(LoopSolver& solver, const std::vector<int>& free, std::vector<double>& x) {
  const auto n = static_cast<Eigen::Index>(free.size());
  double damping = 1e-9;
  solver.evaluate(x, true);
  double error = solver.residual.norm();
  for (int iteration = 0; iteration < kIterations && error > kClosed; ++iteration) {
    Eigen::MatrixXd J(solver.residual.size(), n);
    for (Eigen::Index k = 0; k < n; ++k) J.col(k) = solver.jacobian.col(free[static_cast<std::size_t>(k)]);
    Eigen::MatrixXd H = J.transpose() * J;
    const double scale = std::max(1e-12, H.diagonal().maxCoeff());
    const Eigen::VectorXd g = J.transpose() * solver.residual;
    bool better = false;
    for (int attempt = 0; attempt < 12 && !better; ++attempt) {
      Eigen::MatrixXd damped = H;
      damped.diagonal().array() += damping * scale;
      Eigen::VectorXd step = -damped.ldlt().solve(g);
      const double longest = step.cwiseAbs().maxCoeff();
      if (!(longest < 1e6)) break;
      if (longest > 0.7) step *= 0.7 / longest;
      std::vector<double> trial = x;
      for (Eigen::Index k = 0; k < n; ++k)
        trial[static_cast<std::size_t>(free[static_cast<std::size_t>(k)])] += step[k];
      solver.evaluate(trial, true);
      const double now = solver.residual.norm();
      better = now < error;
      damping = better ? std::max(1e-12, damping * 0.1) : std::max(1e-9, damping * 10.0);
      if (better) {
        x = std::move(trial);
        const bool stuck = now > 0.9999 * error && now > kAssembled;
        error = now;
        if (stuck) iteration += 10;
      }
    }
    if (!better) {
      solver.evaluate(x, true);
      break;
    }
  }
  return error < kAssembled;
}

Eigen::Index rankOf(const Eigen::MatrixXd& J) {
  if (J.cols() == 0 || J.rows() == 0) return 0;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(J);
  qr.setThreshold(1e-6);
  return qr.rank();
}

Eigen::MatrixXd columnsOf(const Eigen::MatrixXd& J, const std::vector<int>& columns) {
  Eigen::MatrixXd picked(J.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) picked.col(static_cast<Eigen::Index>(k)) = J.col(columns[k]);
  return picked;
}

std::vector<int> allBut(std::size_t count, const std::vector<int>& without) {
  std::vector<int> rest;
  for (int k = 0; k < static_cast<int>(count); ++k) {
    if (std::find(without.begin(), without.end(), k) == without.end()) rest.push_back(k);
  }
  return rest;
}

/// Prismatic joints first, then those nearest to the root: joints come breadth or depth first, so by depth.
std::vector<int> candidates(const RobotModel& tree) {
  std::vector<int> order(tree.dof());
  std::vector<int> depth(tree.dof(), 0);
  for (std::size_t v = 0; v < order.size(); ++v) {
    order[v] = static_cast<int>(v);
    const Joint& joint = tree.joints[static_cast<std::size_t>(tree.moving[v])];
    int link = joint.parent_link;
    while (tree.links[static_cast<std::size_t>(link)].parent_joint >= 0) {
      ++depth[v];
      link = tree.joints[static_cast<std::size_t>(tree.links[static_cast<std::size_t>(link)].parent_joint)].parent_link;
    }
    if (joint.type == JointType::kPrismatic) depth[v] -= 100000;
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return depth[static_cast<std::size_t>(a)] < depth[static_cast<std::size_t>(b)];
  });
  return order;
}

/// The set joints: a choice after which the rest still has the rank of the whole.
std::vector<int> chooseActuated(const RobotModel& tree, const Eigen::MatrixXd& J) {
  const Eigen::Index rank = rankOf(J);
  const auto wanted = static_cast<std::size_t>(J.cols() - rank);
  std::vector<int> chosen;
  for (const int candidate : candidates(tree)) {
    if (chosen.size() == wanted) break;
    std::vector<int> trial = chosen;
    trial.push_back(candidate);
    if (rankOf(columnsOf(J, allBut(tree.dof(), trial))) == rank) chosen = std::move(trial);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

double sizeOf(const RobotModel& tree) {
  double size = 0.0;
  for (const Joint& joint : tree.joints) size = std::max(size, glm::length(joint.X_PJ.p));
  return std::max(size, 1e-3);
}

Expected<int> variableNamed(const RobotModel& tree, const std::string& name) {
  const int joint = tree.findJoint(name);
  const int variable = joint < 0 ? -1 : tree.joints[static_cast<std::size_t>(joint)].variable;
  if (variable >= 0) return variable;
  return makeError(refusal(tree, Text("no moving joint is named '%1'", name), Text("an existing name"), ""));
}

/// Leaves only the set joints as variables of the model.
void keepVariables(RobotModel& model, const std::vector<int>& actuated) {
  std::vector<int> moving;
  moving.reserve(actuated.size());
  for (const int variable : actuated) moving.push_back(model.moving[static_cast<std::size_t>(variable)]);
  for (Joint& joint : model.joints) joint.variable = -1;
  for (std::size_t k = 0; k < moving.size(); ++k)
    model.joints[static_cast<std::size_t>(moving[k])].variable = static_cast<int>(k);
  model.moving = std::move(moving);
}

/// The Jacobian at a position that is not singular by chance: the best of the home and some places near it.
Eigen::MatrixXd genericJacobian(LoopSolver& solver, const std::vector<double>& home) {
  const std::vector<int> all = allBut(home.size(), {});
  solver.evaluate(home, true);
  Eigen::MatrixXd best = solver.jacobian;
  for (int trial = 1; trial <= 3; ++trial) {
    std::vector<double> x = home;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += 0.02 * std::sin(12.9898 * static_cast<double>(k + 1) * trial);
    if (!closeBy(solver, all, x)) continue;
    if (rankOf(solver.jacobian) > rankOf(best)) best = solver.jacobian;
  }
  return best;
}

}  // namespace

Expected<void> LoopClosure::close(RobotModel& tree, std::vector<LoopConstraint> loops, const LoopOptions& options) {
  HAPTICELL_DEMAND(!tree.closure);
  const auto closure = std::make_shared<LoopClosure>();
  closure->tree_ = tree;
  for (Link& link : closure->tree_.links) link.visuals = link.collisions = {};
  closure->loops_ = std::move(loops);
  closure->size_ = sizeOf(tree);
  closure->home_.assign(tree.dof(), 0.0);
  for (std::size_t v = 0; v < tree.dof(); ++v) {
    const Joint& joint = tree.joints[static_cast<std::size_t>(tree.moving[v])];
    closure->home_[v] = std::clamp(0.0, joint.lower, joint.upper);
  }
  std::vector<int> held;
  for (const auto& [name, position] : options.start) {
    const auto variable = variableNamed(tree, name);
    HAPTICELL_TRY(variable);
    closure->home_[static_cast<std::size_t>(*variable)] = position;
    held.push_back(*variable);
  }
  LoopSolver solver(*closure);
  const std::vector<int> all = allBut(tree.dof(), {});
  // What the user stated stays, if that is possible.
  std::vector<double> home = closure->home_;
  bool closed = closeBy(solver, allBut(tree.dof(), held), home);
  if (!closed) {
    home = closure->home_;
    closed = closeBy(solver, all, home);
  }
  if (!closed) {
    char gap[64];
    std::snprintf(gap, sizeof gap, "%.3g mm", 1e3 * closure->gap(home));
    return makeError(
        refusal(tree, Text("they cannot be closed from the start values; a gap of %1 remains", std::string(gap)),
                Text("joint positions near an assembled pose"), Text("Set start values nearer to an assembled pose.")));
  }
  closure->home_ = std::move(home);
  const Eigen::MatrixXd J = genericJacobian(solver, closure->home_);
  for (const std::string& name : options.actuated) {
    const auto variable = variableNamed(tree, name);
    HAPTICELL_TRY(variable);
    closure->actuated_.push_back(*variable);
  }
  if (options.actuated.empty()) closure->actuated_ = chooseActuated(tree, J);
  closure->passive_ = allBut(tree.dof(), closure->actuated_);
  if (rankOf(columnsOf(J, closure->passive_)) < rankOf(J)) {
    return makeError(refusal(tree, Text("the actuated joints block each other"),
                             Text("at most %1 independent actuated joints", J.cols() - rankOf(J)),
                             Text("Name fewer or other joints as actuated.")));
  }
  keepVariables(tree, closure->actuated_);
  tree.home.clear();
  for (const int variable : closure->actuated_) tree.home.push_back(closure->home_[static_cast<std::size_t>(variable)]);
  tree.closure = closure;
  return {};
}

double LoopClosure::gap(const std::vector<double>& all) const {
  LoopSolver solver(*this);
  solver.evaluate(all, false);
  return solver.residual.size() > 0 ? solver.residual.cwiseAbs().maxCoeff() : 0.0;
}

bool LoopClosure::solve(const std::vector<double>& q, std::vector<double>& all) const {
  HAPTICELL_DEMAND(q.size() == actuated_.size());
  const auto distance = [&](const std::vector<double>& from) {
    double farthest = 0.0;
    for (std::size_t k = 0; k < q.size(); ++k) {
      const auto v = static_cast<std::size_t>(actuated_[k]);
      const bool slides = tree_.joints[static_cast<std::size_t>(tree_.moving[v])].type == JointType::kPrismatic;
      farthest = std::max(farthest, std::abs(q[k] - from[v]) / (slides ? size_ : 1.0));
    }
    return farthest;
  };
  all = home_;
  {
    const std::lock_guard lock(mutex_);
    if (!last_.empty() && distance(last_) < kLongestStride) all = last_;
    if (!last_.empty() && distance(last_) == 0.0) return true;
  }
  LoopSolver solver(*this);
  const std::vector<double> from = all;
  const int strides = std::clamp(static_cast<int>(std::ceil(distance(all) / kLongestStride)), 1, 200);
  bool closed = true;
  for (int stride = 1; stride <= strides && closed; ++stride) {
    for (std::size_t k = 0; k < q.size(); ++k) {
      const auto v = static_cast<std::size_t>(actuated_[k]);
      all[v] = stride == strides ? q[k] : from[v] + (q[k] - from[v]) * stride / strides;
    }
    closed = closeBy(solver, passive_, all);
  }
  for (std::size_t k = 0; k < q.size(); ++k) all[static_cast<std::size_t>(actuated_[k])] = q[k];
  if (closed) {
    const std::lock_guard lock(mutex_);
    last_ = all;
  }
  return closed;
}

bool LoopClosure::pose(const std::vector<double>& q, std::vector<Pose>& X_BL) const {
  std::vector<double> all;
  const bool closed = solve(q, all);
  forwardKinematics(tree_, all, X_BL);
  return closed;
}

void LoopClosure::margins(const std::vector<double>& q, std::vector<ClosureMargin>& out) const {
  std::vector<double> all;
  solve(q, all);
  out.clear();
  for (const int variable : passive_) {
    const Joint& joint = tree_.joints[static_cast<std::size_t>(tree_.moving[static_cast<std::size_t>(variable)])];
    const double position = all[static_cast<std::size_t>(variable)];
    const auto kind = joint.type == JointType::kPrismatic ? ClosureMargin::Kind::kLength : ClosureMargin::Kind::kAngle;
    if (std::isfinite(joint.lower)) out.push_back({joint.name, position - joint.lower, kind});
    if (std::isfinite(joint.upper)) out.push_back({joint.name, joint.upper - position, kind});
  }
}

Expected<std::unique_ptr<InverseModel>> LoopClosure::inverse(const RobotModel& model, int tip_link,
                                                             const Pose& X_LT) const {
  return ClosureInverse::create(model, tip_link, X_LT);
}

}  // namespace hapticell::kinematics
