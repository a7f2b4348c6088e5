// SPDX-License-Identifier: Apache-2.0
#include "bench/fcl_peer.h"

#include <fcl/fcl.h>

#include "bench/thread_clock.h"

namespace hapticell::bench {

namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

void fill(Model& model, const geometry::TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> vertices;
  std::vector<fcl::Triangle> triangles;
  for (const dvec3& v : mesh.vertices) vertices.emplace_back(v.x, v.y, v.z);
  for (const geometry::Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  model.beginModel();
  model.addSubModel(vertices, triangles);
  model.endModel();
}

fcl::Transform3d transformOf(const Pose& X) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = fcl::Quaterniond(X.q.w, X.q.x, X.q.y, X.q.z).toRotationMatrix();
  transform.translation() = fcl::Vector3d(X.p.x, X.p.y, X.p.z);
  return transform;
}

}  // namespace

struct FclPeer::Models {
  Model moved, standing;
  double build_ms = 0.0;
};

FclPeer::FclPeer(const geometry::TriangleMesh& moved, const geometry::TriangleMesh& standing)
    : models_(std::make_unique<Models>()) {
  const double begin = threadMilliseconds();
  fill(models_->moved, moved);
  fill(models_->standing, standing);
  models_->build_ms = threadMilliseconds() - begin;
}

FclPeer::~FclPeer() = default;

double FclPeer::distance(const Pose& X_WM) {
  fcl::DistanceRequestd request;
  request.enable_nearest_points = true;
  fcl::DistanceResultd result;
  fcl::distance<double>(&models_->moved, transformOf(X_WM), &models_->standing, fcl::Transform3d::Identity(), request,
                        result);
  return result.min_distance;
}

bool FclPeer::collides(const Pose& X_WM) {
  fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide<double>(&models_->moved, transformOf(X_WM), &models_->standing, fcl::Transform3d::Identity(),
                              request, result) > 0;
}

double FclPeer::buildMilliseconds() const {
  return models_->build_ms;
}

struct FclGroup::Objects {
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> moved, standing;
  fcl::DynamicAABBTreeCollisionManagerd moved_tree, standing_tree;

  static std::shared_ptr<Model> modelOf(const geometry::TriangleMesh& mesh) {
    auto model = std::make_shared<Model>();
    fill(*model, mesh);
    return model;
  }
  static std::unique_ptr<fcl::CollisionObjectd> object(const std::shared_ptr<Model>& model, const Pose& X) {
    auto result = std::make_unique<fcl::CollisionObjectd>(model, transformOf(X));
    result->computeAABB();
    return result;
  }
};

FclGroup::FclGroup(const std::vector<geometry::TriangleMesh>& moved,
                   const std::vector<geometry::TriangleMesh>& standing, const std::vector<Pose>& X_WStanding)
    : objects_(std::make_unique<Objects>()) {
  for (const auto& mesh : moved) objects_->moved.push_back(Objects::object(Objects::modelOf(mesh), {}));
  std::shared_ptr<Model> model;
  for (std::size_t i = 0; i < X_WStanding.size(); ++i) {
    if (i < standing.size()) model = Objects::modelOf(standing[i]);
    objects_->standing.push_back(Objects::object(model, X_WStanding[i]));
  }
  for (const auto& object : objects_->moved) objects_->moved_tree.registerObject(object.get());
  for (const auto& object : objects_->standing) objects_->standing_tree.registerObject(object.get());
  objects_->moved_tree.setup();
  objects_->standing_tree.setup();
}

FclGroup::~FclGroup() = default;

void FclGroup::place(const std::vector<Pose>& X_WMoved) {
  for (std::size_t i = 0; i < X_WMoved.size(); ++i) {
    objects_->moved[i]->setTransform(transformOf(X_WMoved[i]));
    objects_->moved[i]->computeAABB();
  }
  objects_->moved_tree.update();
}

double FclGroup::distance(const std::vector<Pose>& X_WMoved) {
  place(X_WMoved);
  fcl::DefaultDistanceData<double> data;
  data.request.enable_nearest_points = true;
  objects_->moved_tree.distance(&objects_->standing_tree, &data, fcl::DefaultDistanceFunction);
  return data.result.min_distance;
}

bool FclGroup::collides(const std::vector<Pose>& X_WMoved) {
  place(X_WMoved);
  fcl::DefaultCollisionData<double> data;
  objects_->moved_tree.collide(&objects_->standing_tree, &data, fcl::DefaultCollisionFunction);
  return data.result.isCollision();
}

}  // namespace hapticell::bench
