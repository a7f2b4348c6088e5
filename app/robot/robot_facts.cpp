// SPDX-License-Identifier: Apache-2.0
#include "app/robot/robot_facts.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <vector>

namespace hapticell::app {
namespace {

// Places tried along a joint. The reach is shown in mm. Half: a limit between two is missed; twice: twice the time.
constexpr int kGrid = 24;
// Over all joints; kStarts of the search; kHalvings of the grid (each to a sixth) about the best place. By trial. Half:
// the reach may be too short; twice: twice the time.
constexpr int kSweeps = 5;
constexpr int kStarts = 4;    // Of the search.
constexpr int kHalvings = 9;  // Of the grid, about the best place.

struct Reach {
  const kinematics::RobotModel& model;
  int tip;
  std::vector<Pose> X_BL = {};

  double operator()(const std::vector<double>& q) {
    kinematics::forwardKinematics(model, q, X_BL);
    const dvec3 p_BT = X_BL[static_cast<std::size_t>(tip)].p;
    const auto& first = model.joints[static_cast<std::size_t>(model.moving.front())];
    const Pose X_BJ = X_BL[static_cast<std::size_t>(first.parent_link)] * first.X_PJ;
    if (first.type == kinematics::JointType::kPrismatic) return glm::length(p_BT - X_BJ.p);
    return glm::length(glm::cross(X_BJ.rotate(first.axis_J), p_BT - X_BJ.p));
  }
};

/// The best place of one joint, others staying.
double improve(Reach& reach, std::vector<double>& q, std::size_t variable, double lower, double upper) {
  double best = reach(q);
  double width = upper - lower;
  double middle = 0.5 * (lower + upper);
  for (int round = 0; round < kHalvings; ++round) {
    const double from = middle - 0.5 * width;
    double at = q[variable];
    for (int i = 0; i <= kGrid; ++i) {
      q[variable] = std::clamp(from + width * i / kGrid, lower, upper);
      const double value = reach(q);
      if (value > best) best = value, at = q[variable];
    }
    q[variable] = middle = at;
    width *= 4.0 / kGrid;
  }
  return best;
}

std::string squeezed(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80)
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

double flangeReach(const kinematics::RobotModel& model) {
  const int tip = model.defaultTip();
  if (model.closure || model.moving.empty() || tip < 0) return 0.0;
  Reach reach{model, tip};
  double best = 0.0;
  for (int start = 0; start < kStarts; ++start) {
    std::vector<double> q = kinematics::restPositions(model);
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += 0.4 * ((start + static_cast<int>(i)) % 3 - 1);
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      for (std::size_t i = 0; i < q.size(); ++i) {
        const auto& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
        const double lower = std::isfinite(joint.lower) ? joint.lower : -3.1416;
        const double upper = std::isfinite(joint.upper) ? joint.upper : 3.1416;
        q[i] = std::clamp(q[i], lower, upper);
        best = std::max(best, improve(reach, q, i, lower, upper));
      }
  }
  return best;
}

bool matchesSearch(const std::string& text, const std::string& search) {
  const std::string in = squeezed(text);
  std::istringstream words(search);
  for (std::string word; words >> word;)
    if (in.find(squeezed(word)) == std::string::npos) return false;
  return true;
}

}  // namespace hapticell::app
