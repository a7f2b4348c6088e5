// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

#include <random>
#include <vector>

#include "geometry/shapes/bounds.h"
#include "planning/free_space.h"
#include "planning/search.h"

namespace hapticell::planning {

/// How configurations are numbers for OMPL: joints (of a mannequin: StandingFigure::Numbers) times their levers, so that
/// distances are metres of the parts; or a pose, turns times the radius. Constant once it is made; any thread.
class Coordinates {
 public:
  /// `space` must outlive it and is asked here only, but for its kind and radius.
  Coordinates(const FreeSpace& space, const SearchJob& job);

  ompl::base::StateSpacePtr makeSpace() const;
  void write(const EntityConfiguration& at, ompl::base::State* state) const;
  EntityConfiguration read(const ompl::base::State* state) const;
  /// A state anywhere, of `random`.
  void sample(std::mt19937_64& random, ompl::base::State* state) const;
  /// m, as the parts move.
  double distance(const EntityConfiguration& a, const EntityConfiguration& b) const;

 private:
  void setJointRanges(const SearchJob& job);
  void setFigureRanges(const SearchJob& job);
  void setBox(const SearchJob& job);
  void sampleFigure(std::mt19937_64& random, ompl::base::State* state) const;
  /// What is multiplied by the levers.
  std::vector<double> numbersOf(const EntityConfiguration& at) const;

  const FreeSpace& space_;
  EntityConfiguration start_;
  std::vector<double> lower_, upper_, lever_;
  std::vector<double> numbers_of_start_;     ///< Of a mannequin.
  std::vector<std::vector<double>> goals_;  ///< Of a mannequin.
  geometry::Bounds box_;
};

}  // namespace hapticell::planning
