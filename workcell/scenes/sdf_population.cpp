// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_population.h"

#include <cmath>
#include <numbers>

#include "geometry/shapes/pose.h"
#include "workcell/scenes/sdf_xml.h"

namespace hapticell::workcell {

namespace {

// Models of a population: guards time. Half, twice: other files lose theirs, with a message.
constexpr double kMostSettled = 5000.0;

double numberOr(const TiXmlElement* parent, const char* name, double otherwise) {
  const std::vector<double> numbers = numbersIn(textOf(parent, name));
  return numbers.size() == 1 && std::isfinite(numbers[0]) ? numbers[0] : otherwise;
}

dvec3 pointOr(const TiXmlElement* parent, const char* name, const dvec3& otherwise) {
  const std::vector<double> n = numbersIn(textOf(parent, name));
  return n.size() == 3 && std::isfinite(n[0] + n[1] + n[2]) ? dvec3(n[0], n[1], n[2]) : otherwise;
}

Pose poseOfPopulation(const TiXmlElement& population) {
  std::vector<double> n = numbersIn(textOf(&population, "pose"));
  n.resize(6, 0.0);
  const dquat q = glm::angleAxis(n[5], dvec3(0, 0, 1)) * glm::angleAxis(n[4], dvec3(0, 1, 0)) *
                  glm::angleAxis(n[3], dvec3(1, 0, 0));
  return {{n[0], n[1], n[2]}, glm::normalize(q)};
}

/// The digits of k in the base, mirrored at the point: spread evenly over 0 to 1 (van der Corput).
double spread(std::size_t k, std::size_t base) {
  double share = 0.0, step = 1.0;
  for (; k > 0; k /= base) {
    step /= static_cast<double>(base);
    share += step * static_cast<double>(k % base);
  }
  return share;
}

dvec3 spreadInCylinder(std::size_t k, double radius, double length) {
  const double r = radius * std::sqrt(spread(k, 2)), angle = 2.0 * std::numbers::pi * spread(k, 3);
  return {r * std::cos(angle), r * std::sin(angle), length * (spread(k, 5) - 0.5)};
}

/// The grid's columns go along x, its rows along y.
Population gridOf(const TiXmlElement& population, const TiXmlElement* distribution) {
  const double rows = numberOr(distribution, "rows", 1.0), columns = numberOr(distribution, "cols", 1.0);
  const dvec3 step = pointOr(distribution, "step", dvec3(0.5, 0.5, 0.0));
  if (!(rows >= 1.0 && columns >= 1.0 && rows * columns <= kMostSettled)) {
    return {{}, Text("the population is left out: its grid has no models or more than 5000")};
  }
  const Pose X_WP = poseOfPopulation(population);
  const dvec3 corner = X_WP.p - 0.5 * dvec3(step.x * (columns - 1.0), step.y * (rows - 1.0), 0.0);
  Population result;
  for (int row = 0; row < static_cast<int>(rows); ++row) {
    for (int column = 0; column < static_cast<int>(columns); ++column) {
      result.positions.push_back(corner + X_WP.rotate({column * step.x, row * step.y, 0.0}));
    }
  }
  return result;
}

}  // namespace

Population populationOf(const TiXmlElement& population) {
  const TiXmlElement* const distribution = population.FirstChildElement("distribution");
  const TiXmlElement* const box = population.FirstChildElement("box");
  const TiXmlElement* const cylinder = population.FirstChildElement("cylinder");
  const std::string kind = distribution ? textOf(distribution, "type") : "random";
  if (kind == "grid") return gridOf(population, distribution);
  const double count = numberOr(&population, "model_count", 1.0);
  if (!(count >= 1.0 && count <= kMostSettled) || (!box && !cylinder)) {
    return {{}, Text("the population is left out: it has no region, no models or more than 5000 models")};
  }
  const Pose X_WP = poseOfPopulation(population);
  const dvec3 size = pointOr(box, "size", dvec3(1.0));
  const bool in_line = kind == "linear-x" || kind == "linear-y" || kind == "linear-z";
  const int along = in_line ? kind.back() - 'x' : -1;
  Population result;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    if (along < 0 && cylinder) {
      result.positions.push_back(
          X_WP * spreadInCylinder(k + 1, numberOr(cylinder, "radius", 1.0), numberOr(cylinder, "length", 1.0)));
      continue;
    }
    dvec3 place = 0.5 * size;
    if (along >= 0) place[along] = size[along] * static_cast<double>(k) / count;
    if (along < 0) place = size * dvec3(spread(k + 1, 2), spread(k + 1, 3), spread(k + 1, 5));
    result.positions.push_back(X_WP.p - 0.5 * size + X_WP.rotate(place));
  }
  if (along < 0) result.remark = Text("the file places its models at random; they are spread evenly");
  return result;
}

}  // namespace hapticell::workcell
