// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/meshes/edge_chains.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>

namespace hapticell::app {
namespace {

// 35 degrees: a turn that ends a chain of edges; circles of 12 edges turn by 30. Half: circles break; twice: corners
// are passed.
constexpr double kCornerCosine = 0.81915;
// Of the size: a line; floats of files are off by 1e-7 of it. Half: lines of rounded files break; twice: flat arcs are
// lines.
constexpr double kRelativeTolerance = 5e-6;
// Of the radius: rounding of files of 0.01 mm at 100 mm. Half: rounded circles are not found; twice: ellipses nearly
// round are circles.
constexpr double kCircleTolerance = 1e-4;
// Fewer lie on some circle by chance (three points do). Half: corners are arcs; twice: short arcs are not found.
constexpr std::size_t kArcEdges = 4;

struct Circle {
  dvec3 center{0.0}, axis{0.0, 0.0, 1.0};
  double radius = 0.0;
};

std::optional<Circle> circleThrough(const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 u = b - a, v = c - a;
  const dvec3 n = glm::cross(u, v);
  const double n2 = glm::dot(n, n);
  if (!(n2 > 1e-20 * glm::dot(u, u) * glm::dot(v, v))) return std::nullopt;
  const dvec3 to_center = glm::cross(n, u) * glm::dot(v, v) + glm::cross(v, n) * glm::dot(u, u);
  const dvec3 offset = to_center / (2.0 * n2);
  return Circle{a + offset, n / std::sqrt(n2), glm::length(offset)};
}

class Cutter {
 public:
  Cutter(const std::vector<EdgeEnds>& edges, const std::vector<dvec3>& vertices) : edges_(edges), vertices_(vertices) {
    dvec3 low(1e300), high(-1e300);
    for (const EdgeEnds& edge : edges) {
      for (const std::uint32_t v : edge) {
        at_[v].push_back(static_cast<std::uint32_t>(&edge - edges.data()));
        low = glm::min(low, vertices[v]);
        high = glm::max(high, vertices[v]);
      }
    }
    tolerance_ = edges.empty() ? 0.0 : std::max(1e-7, kRelativeTolerance * glm::distance(low, high));
    used_.assign(edges.size(), false);
  }

  std::vector<EdgeChain> cut() {
    std::vector<EdgeChain> chains;
    // From corners first; what then remains is closed.
    for (const bool from_corners : {true, false}) {
      for (std::size_t e = 0; e < edges_.size(); ++e) {
        for (int end = 0; end < 2 && !used_[e]; ++end) {
          const std::uint32_t start = edges_[e][static_cast<std::size_t>(end)];
          if (from_corners && !isCorner(start)) continue;
          split(walk(start, static_cast<std::uint32_t>(e)), chains);
        }
      }
    }
    return chains;
  }

 private:
  std::uint32_t otherEnd(std::uint32_t edge, std::uint32_t vertex) const {
    return edges_[edge][0] == vertex ? edges_[edge][1] : edges_[edge][0];
  }
  dvec3 direction(std::uint32_t from, std::uint32_t to) const {
    const dvec3 along = vertices_[to] - vertices_[from];
    const double length = glm::length(along);
    return length > 0.0 ? along / length : dvec3(0.0);
  }
  bool isCorner(std::uint32_t vertex) const {
    const auto& around = at_.at(vertex);
    if (around.size() != 2) return true;
    const dvec3 in = direction(otherEnd(around[0], vertex), vertex);
    const dvec3 out = direction(vertex, otherEnd(around[1], vertex));
    return glm::dot(in, out) < kCornerCosine;
  }
  std::vector<std::uint32_t> walk(std::uint32_t start, std::uint32_t edge) {
    std::vector<std::uint32_t> chain{start};
    std::uint32_t here = start;
    for (;;) {
      used_[edge] = true;
      here = otherEnd(edge, here);
      chain.push_back(here);
      if (isCorner(here) || here == start) return chain;
      const auto& around = at_.at(here);
      edge = around[0] == edge ? around[1] : around[0];
      if (used_[edge]) return chain;
    }
  }
  bool onCircle(std::span<const std::uint32_t> points, Circle& circle) const {
    if (points.size() < 3) return false;
    const bool closed = points.front() == points.back();
    const std::size_t n = points.size() - (closed ? 1 : 0);
    const auto found = circleThrough(vertices_[points[0]], vertices_[points[n / 3 == 0 ? 1 : n / 3]],
                                     vertices_[points[closed ? 2 * n / 3 : n - 1]]);
    if (!found) return false;
    circle = *found;
    const double tolerance = std::max(tolerance_, kCircleTolerance * circle.radius);
    return std::all_of(points.begin(), points.end(), [&](std::uint32_t v) {
      const dvec3 d = vertices_[v] - circle.center;
      const double off = glm::dot(d, circle.axis);
      return std::abs(off) <= tolerance && std::abs(glm::length(d - off * circle.axis) - circle.radius) <= tolerance;
    });
  }
  bool onLine(std::span<const std::uint32_t> points) const {
    const dvec3 a = vertices_[points.front()];
    const dvec3 along = direction(points.front(), points.back());
    return std::all_of(points.begin(), points.end(), [&](std::uint32_t v) {
      const dvec3 d = vertices_[v] - a;
      return glm::length(d - glm::dot(d, along) * along) <= tolerance_;
    });
  }
  /// A closed chain of lines and arcs begins behind its longest edge, which is a line.
  void turnToLongest(std::vector<std::uint32_t>& chain) const {
    chain.pop_back();
    std::size_t longest = 0;
    double length = -1.0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const double l = glm::distance(vertices_[chain[i]], vertices_[chain[(i + 1) % chain.size()]]);
      if (l > 1.001 * length) longest = i, length = l;
    }
    std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>((longest + 1) % chain.size()), chain.end());
    chain.push_back(chain.front());
  }
  void split(std::vector<std::uint32_t> chain, std::vector<EdgeChain>& chains) const {
    Circle circle;
    if (chain.size() > kArcEdges && onCircle(chain, circle)) return addCircle(chain, circle, chains);
    if (chain.front() == chain.back() && chain.size() > 2) turnToLongest(chain);
    std::size_t loose = 0;  // Where a run that is neither line nor arc began.
    std::size_t from = 0;
    const std::span<const std::uint32_t> all(chain);
    const auto flush = [&](std::size_t end) {
      if (end > loose) addPlain(all.subspan(loose, end - loose + 1), chains);
    };
    while (from + 1 < chain.size()) {
      std::size_t line = from + 1;
      while (line + 1 < chain.size() && onLine(all.subspan(from, line + 2 - from))) ++line;
      std::size_t arc = from + kArcEdges;
      const bool is_arc = arc < chain.size() && onCircle(all.subspan(from, kArcEdges + 1), circle);
      while (is_arc && arc + 1 < chain.size() && onCircle(all.subspan(from, arc + 2 - from), circle)) ++arc;
      if (is_arc && onCircle(all.subspan(from, arc + 1 - from), circle)) {
        flush(from);
        addCircle(
            {chain.begin() + static_cast<std::ptrdiff_t>(from), chain.begin() + static_cast<std::ptrdiff_t>(arc + 1)},
            circle, chains);
        from = loose = arc;
      } else if (line > from + 1) {
        flush(from);
        addPlain(all.subspan(from, line + 1 - from), chains);
        from = loose = line;
      } else {
        ++from;
      }
    }
    flush(from);
  }
  void addCircle(std::vector<std::uint32_t> points, const Circle& circle, std::vector<EdgeChain>& chains) const {
    chains.push_back({std::move(points), false, true, circle.center, circle.axis, circle.radius});
  }
  void addPlain(std::span<const std::uint32_t> points, std::vector<EdgeChain>& chains) const {
    EdgeChain chain;
    chain.vertices.assign(points.begin(), points.end());
    chain.is_line = points.front() != points.back() && onLine(points);
    chain.center = 0.5 * (vertices_[points.front()] + vertices_[points.back()]);
    if (chain.is_line) chain.axis = direction(points.front(), points.back());
    chains.push_back(std::move(chain));
  }

  const std::vector<EdgeEnds>& edges_;
  const std::vector<dvec3>& vertices_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> at_;
  std::vector<bool> used_;
  double tolerance_ = 0.0;
};

}  // namespace

std::vector<EdgeChain> edgeChains(const std::vector<EdgeEnds>& edges, const std::vector<dvec3>& vertices) {
  return Cutter(edges, vertices).cut();
}

}  // namespace hapticell::app
