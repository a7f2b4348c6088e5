// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "collision/surfaces/surface_model.h"

namespace hapticell::collision {

/// What a ball whose centre is somewhere in a small cube could meet within a reach.
struct SignatureCell {
  static constexpr std::uint32_t kOwn = 0x80000000u;

  /// Elements of the model, or from kOwn on those of `own`; a group is free if one of its elements is (elementValue >
  /// 0), the ball is free if all groups are.
  std::vector<std::vector<std::uint32_t>> groups;
  std::vector<SurfaceElement> own;  ///< Free places that the model's elements do not describe.
  bool overfull = false;            ///< Too many surfaces for one place: there are no groups.
  bool free_form = false;
  bool facets = false;  ///< Facets represent a free-form surface, or the mesh is open.

  const SurfaceElement& element(const SurfaceModel& model, std::uint32_t name) const {
    return name >= kOwn ? own[name - kOwn] : model.elements()[name];
  }
};

/// The groups of a mesh, computed on demand and kept.
///
/// Which surfaces share a group: for points s of the mesh's (offset) surface near the cube the signature of s is the
/// set of elements that s is behind or on; a point in front of one of them is not s. The groups are the signatures that
/// contain no other (a minimal conjunctive form of "outside", as for monotone functions: Fredman, Khachiyan 1996). They
/// depend only on the surface and the ball, so they are valid for every pose. One thread.
class SignatureCache {
 public:
  /// `model` outlives the cache.
  explicit SignatureCache(const SurfaceModel& model) : model_(&model) {}

  const SurfaceModel& model() const { return *model_; }

  /// The cell of a ball's centre p_MP for at least this reach (m). The reference is valid until the next call.
  const SignatureCell& cell(const dvec3& p_MP, double radius, double reach);
  /// Whether the cache already has that cell.
  bool knows(const dvec3& p_MP, double radius, double reach) const {
    return cells_.count(keyOf(p_MP, radius, reach)) != 0;
  }

  /// Cost of the cells made since the last call, in element values (about 10 ns each); the same in every run.
  std::size_t takeWork();
  std::size_t cellCount() const { return cells_.size(); }

 private:
  struct Key {
    std::int32_t x, y, z, level;
    double radius;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  struct Sample {
    dvec3 p_M, nhat_M;
    std::uint32_t component;
  };
  static Key keyOf(const dvec3& p_MP, double radius, double reach);
  SignatureCell made(const dvec3& center, double half, double radius, double reach);
  void sample(std::uint32_t triangle, const geometry::Bounds& box, double radius, double reach);
  void sampleEdge(std::uint32_t triangle, int k, const geometry::Bounds& box, double radius, double reach);
  void addSample(std::uint32_t triangle, const dvec3& on_facet, double radius);

  using Grain = std::tuple<int, int, int, std::uint32_t>;

  const SurfaceModel* model_;
  std::unordered_map<Key, SignatureCell, KeyHash> cells_;
  std::size_t work_ = 0;
  std::vector<std::uint32_t> near_;
  std::vector<Sample> samples_;
  std::set<Grain> grains_;
};

}  // namespace hapticell::collision
