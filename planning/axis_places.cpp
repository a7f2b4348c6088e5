// SPDX-License-Identifier: Apache-2.0
#include "planning/axis_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/system/assertion.h"
#include "kinematics/model/solution_list.h"
#include "planning/shortening.h"

namespace hapticell::planning {

namespace {

/// m, rad between places of one axis at most: a fraction of an arm's reach, so that none lies between two. Half: twice
/// the time before the search; twice: goals at the edge of the reach are missed.
constexpr double kSlideStep = 0.1, kTurnStep = 0.2;
/// Places of one axis at least, and of all axes at most. Half, twice: as the steps.
constexpr int kLeastPlaces = 16, kMostPlaces = 400;
/// m to both sides of the present place of a slide without limits. Half: what is farther is out of reach; twice: places
/// lie farther apart.
constexpr double kEndlessSlide = 10.0;

/// Solutions turned by full turns at one place of the axes. Half: goals that need a far turn are missed; twice: more that
/// are checked in vain.
constexpr std::size_t kTurnedAtPlace = 8;

struct Travel {
  double lower = 0.0, upper = 0.0;
  int places = kLeastPlaces;
};

Travel travelOf(const kinematics::Joint& joint, double present) {
  const bool slides = joint.type == kinematics::JointType::kPrismatic;
  const double endless = slides ? kEndlessSlide : std::numbers::pi;
  Travel travel;
  travel.lower = std::isfinite(joint.lower) ? joint.lower : present - endless;
  travel.upper = std::isfinite(joint.upper) ? joint.upper : present + endless;
  const double steps = (travel.upper - travel.lower) / (slides ? kSlideStep : kTurnStep);
  travel.places = std::clamp(static_cast<int>(std::min(std::ceil(steps), 1e6)) + 1, kLeastPlaces, kMostPlaces);
  return travel;
}

}  // namespace

std::vector<std::vector<double>> axisPlaces(const kinematics::RobotModel& robot, std::size_t variables,
                                            const std::vector<double>& present, std::uint64_t seed) {
  HAPTICELL_DEMAND(variables >= 1 && variables <= present.size());
  std::vector<Travel> travels;
  double wanted = 1.0;
  for (std::size_t v = 0; v < variables; ++v) {
    travels.push_back(travelOf(robot.joints[static_cast<std::size_t>(robot.moving[v])], present[v]));
    wanted *= travels.back().places;
  }
  std::vector<std::vector<double>> places{{present.begin(), present.begin() + static_cast<std::ptrdiff_t>(variables)}};
  const int count = static_cast<int>(std::min<double>(wanted, kMostPlaces));
  std::mt19937_64 random(seed);
  for (int i = 0; i < count; ++i) {
    std::vector<double> place;
    for (std::size_t v = 0; v < variables; ++v) {
      const double share = variables == 1 ? static_cast<double>(i) / std::max(1, count - 1)
                                          : static_cast<double>(random() >> 11) * 0x1.0p-53;
      place.push_back(travels[v].lower + share * (travels[v].upper - travels[v].lower));
    }
    places.push_back(std::move(place));
  }
  return places;
}

EntityConfiguration withAxesAt(EntityConfiguration at, const std::vector<double>& place) {
  std::copy(place.begin(), place.end(), at.joints.begin());
  return at;
}

std::vector<EntityConfiguration> soonestWithAxes(const FreeSpace& space, const kinematics::InverseModel& inverse,
                                                 const Pose& X_WT, const EntityConfiguration& start,
                                                 const std::vector<std::vector<double>>& places, std::size_t most) {
  kinematics::SolutionListOptions options;
  options.with_turns = true;
  options.most_turns = kTurnedAtPlace;
  struct Soonest {
    EntityConfiguration at;
    double time = 0.0;
  };
  std::vector<Soonest> all;
  for (const std::vector<double>& place : places) {
    const EntityConfiguration from = withAxesAt(start, place), own = space.ownAt(from);
    const auto solutions = kinematics::listSolutions(*space.ownEntity().robot(), inverse, own.X_WE.inverse() * X_WT,
                                                     own.joints, options);
    for (const auto& one : solutions) {
      if (!one.within_limits) continue;
      EntityConfiguration at = from;
      std::copy(one.q.begin(), one.q.end(), at.joints.begin() + static_cast<std::ptrdiff_t>(place.size()));
      const double time = leastTime(space, start, at);
      all.push_back({std::move(at), time});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Soonest& a, const Soonest& b) { return a.time < b.time; });
  std::vector<EntityConfiguration> soonest;
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) soonest.push_back(std::move(all[i].at));
  return soonest;
}

}  // namespace hapticell::planning
