// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/gpu_mesh.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "app/viewport/drawing/buffer_offset.h"
#include "app/viewport/drawing/instance_buffer.h"
#include "app/viewport/meshes/posed_mesh.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::app {
namespace {

// Triangles: sooner made ready than handed over. Half: small parts appear a frame later; twice: many of them delay a
// frame.
constexpr std::size_t kSmallMesh = 2000;
// Triangles, so few that coarser ones would win nothing. Half: work for nothing; twice: parts of 200 keep all.
constexpr std::size_t kTinyMesh = 100;
// Bytes handed to the graphics card between two looks at the time, some ms. Half: more calls; twice: a frame may be
// late.
constexpr std::size_t kRunBytes = std::size_t{4} << 20;
// Edges of a buffer of 16 MB: larger ones are allocated slowly. By trial. Half, twice: more buffers, or longer pauses.
constexpr std::size_t kEdgesABuffer = (std::size_t{16} << 20) / sizeof(DisplayEdge);

/// From a sample of triangles and creases: it decides how dark lines are, no more.
double creaseSpacingOf(const DisplayMesh& mesh) {
  // Triangles and edges whose mean stands for all. Half: less exact spacing of edges; twice: time of each mesh.
  constexpr std::size_t kSample = 20000;
  if (mesh.creases == 0 || mesh.steps.empty()) return std::numeric_limits<double>::infinity();
  const std::size_t triangles = mesh.steps[0].count / 3;
  const std::size_t stride = triangles / kSample + 1, edge_stride = mesh.creases / kSample + 1;
  double area = 0.0, length = 0.0;
  for (std::size_t t = 0; t < triangles; t += stride) {
    const auto corner = [&](std::size_t i) { return mesh.vertices[mesh.indices[3 * t + i]].position; };
    area += 0.5 * static_cast<double>(glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))));
  }
  for (std::size_t e = 0; e < mesh.creases; e += edge_stride)
    length += static_cast<double>(glm::length(mesh.edges[e].to - mesh.edges[e].from));
  length *= static_cast<double>(edge_stride);
  area *= static_cast<double>(stride);
  return length > 0.0 ? area / length : std::numeric_limits<double>::infinity();
}

/// What brings its normals and coarser triangles is drawn as it is.
DisplayMesh displayOf(const PosedMesh& mesh) {
  DisplayMesh display;
  display.bounds = mesh.bounds();
  display.center = display.bounds.center();
  display.closed = false;
  display.vertices.reserve(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    display.vertices.push_back({fvec3(mesh.vertices[v] - display.center), mesh.normals[v]});
  for (const PosedMesh::Step& step : *mesh.steps) {
    display.steps.push_back({display.indices.size(), step.indices.size(), step.error});
    display.indices.insert(display.indices.end(), step.indices.begin(), step.indices.end());
  }
  return display;
}

}  // namespace

GpuMesh::GpuMesh(Gl& gl, const DisplayMesh& mesh, DrawCount& counted)
    : gl_(gl), counted_(counted), steps_(mesh.steps), center_(mesh.center), bounds_(mesh.bounds), closed_(mesh.closed) {
  edge_count_ = mesh.edges.size();
  crease_count_ = mesh.creases;
  crease_spacing_ = creaseSpacingOf(mesh);
  buffers_.resize(2 + (edge_count_ + kEdgesABuffer - 1) / kEdgesABuffer);
  gl_.glGenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  gl_.glGenVertexArrays(1, &face_array_);
  gl_.glBindVertexArray(face_array_);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl_.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  for (GLuint i = 0; i < 2; ++i) {
    gl_.glEnableVertexAttribArray(i);
    gl_.glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(DisplayVertex), bufferOffset(i * sizeof(fvec3)));
  }
  gl_.glGenVertexArrays(1, &edge_array_);
  gl_.glBindVertexArray(0);
}

bool GpuMesh::fill(const DisplayMesh& mesh, const std::function<bool()>& has_time) {
  const auto bytes_of = [&mesh](std::size_t buffer) -> std::span<const std::byte> {
    if (buffer == 0) return std::as_bytes(std::span(mesh.vertices));
    if (buffer == 1) return std::as_bytes(std::span(mesh.indices));
    const std::size_t first = (buffer - 2) * kEdgesABuffer;
    return std::as_bytes(std::span(mesh.edges).subspan(first, std::min(kEdgesABuffer, mesh.edges.size() - first)));
  };
  for (; filled_buffers_ < buffers_.size(); ++filled_buffers_, filled_ = 0) {
    const std::span<const std::byte> source = bytes_of(filled_buffers_);
    // Room alone takes long where a renderer clears it, so it is taken by one buffer at a time.
    if (filled_ == 0 && !has_time()) return false;
    gl_.glBindBuffer(GL_COPY_WRITE_BUFFER, buffers_[filled_buffers_]);
    if (filled_ == 0)
      gl_.glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(source.size()), nullptr, GL_STATIC_DRAW);
    while (filled_ < source.size()) {
      if (!has_time()) return false;
      const std::size_t count = std::min(kRunBytes, source.size() - filled_);
      gl_.glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(filled_), static_cast<GLsizeiptr>(count),
                          source.data() + filled_);
      filled_ += count;
    }
  }
  return true;
}

GpuMesh::~GpuMesh() {
  gl_.glDeleteVertexArrays(1, &face_array_);
  gl_.glDeleteVertexArrays(1, &edge_array_);
  gl_.glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
}

void GpuMesh::drawFaces() {
  if (steps_.empty()) return;
  gl_.glBindVertexArray(face_array_);
  gl_.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(steps_[0].count), GL_UNSIGNED_INT, nullptr);
  ++counted_.calls;
  counted_.triangles += triangles();
}

void GpuMesh::drawUses(std::size_t step, const InstanceBuffer& uses, std::size_t before, const DrawPart& part) {
  if (steps_.empty() || part.uses == 0) return;
  const DetailStep& drawn = steps_[std::min(step, steps_.size() - 1)];
  gl_.glBindVertexArray(face_array_);
  uses.attach(before + part.first_use);
  gl_.glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(3 * part.units), GL_UNSIGNED_INT,
                              bufferOffset((drawn.first + 3 * part.first_unit) * sizeof(std::uint32_t)),
                              static_cast<GLsizei>(part.uses));
  ++counted_.calls;
  counted_.instances += part.uses;
  counted_.triangles += part.units * part.uses;
}

void GpuMesh::drawEdges(std::size_t first, std::size_t count) {
  gl_.glBindVertexArray(edge_array_);
  for (const std::size_t end = first + count; first < end;) {
    const std::size_t buffer = first / kEdgesABuffer, in_buffer = first % kEdgesABuffer;
    const std::size_t run = std::min(end - first, kEdgesABuffer - in_buffer);
    gl_.glBindBuffer(GL_ARRAY_BUFFER, buffers_[2 + buffer]);
    for (GLuint i = 0; i < 4; ++i) {
      gl_.glEnableVertexAttribArray(i);
      gl_.glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(DisplayEdge),
                                bufferOffset(in_buffer * sizeof(DisplayEdge) + i * sizeof(fvec3)));
      gl_.glVertexAttribDivisor(i, 1);
    }
    gl_.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(run));
    ++counted_.calls;
    first += run;
  }
}

GpuMesh* GpuMeshCache::of(const RenderItem& item) {
  const std::shared_ptr<const geometry::TriangleMesh>& mesh = item.mesh;
  Entry& entry = entries_[mesh.get()];
  entry.used = true;
  // An address that was reused by another mesh must not show the old one.
  if (entry.source.lock() != mesh) {
    entry = {};
    entry.source = mesh;
    if (item.smooth) {
      entry.mesh = wholeMesh(displayOf(static_cast<const PosedMesh&>(*mesh)));
    } else if (mesh->triangles.size() <= kSmallMesh && hasTime()) {
      entry.mesh = wholeMesh(makeDisplayMesh(*mesh));
      if (mesh->triangles.size() > kTinyMesh) entry.prepared = worker_.prepareLasting(mesh, kPartCrease);
    } else {
      entry.prepared = worker_.prepare(mesh, kPartCrease);
    }
  }
  if (!entry.mesh && !bring(entry)) left_over_ = true;
  return entry.mesh.get();
}

/// Goes on getting the best edition there is onto the card; false where more time is needed.
bool GpuMeshCache::bring(Entry& entry) {
  if (!entry.prepared) return true;
  const bool lasting = entry.prepared->ready.load(std::memory_order_acquire);
  if (!lasting && (entry.mesh || !entry.prepared->first_ready.load(std::memory_order_acquire))) return true;
  const DisplayMesh& made = lasting ? entry.prepared->mesh : entry.prepared->first;
  if (entry.next && entry.next_lasts != lasting) entry.next.reset();
  if (!entry.next) {
    if (!hasTime()) return false;
    entry.next = std::make_unique<GpuMesh>(gl_, made, counted_);
    entry.next_lasts = lasting;
  }
  if (!entry.next->fill(made, [this] { return hasTime(); })) return false;
  entry.mesh = std::move(entry.next);
  const auto source = entry.source.lock();
  entry.rough = !lasting && source && source->triangles.size() > DisplayMeshWorker::kLargeMesh;
  if (lasting) worker_.letGo(std::move(entry.prepared));
  return true;
}

void GpuMeshCache::wait() {
  worker_.wait();
  all_now_ = true;
  for (auto& [address, entry] : entries_) bring(entry);
}

std::unique_ptr<GpuMesh> GpuMeshCache::wholeMesh(const DisplayMesh& mesh) {
  auto made = std::make_unique<GpuMesh>(gl_, mesh, counted_);
  made->fill(mesh, [] { return true; });
  return made;
}

GpuMesh& GpuMeshCache::unitBox() {
  if (!unit_box_) unit_box_ = wholeMesh(makeDisplayMesh(geometry::makeBox(dvec3(1.0))));
  return *unit_box_;
}

/// Many small parts, or many that are ready at once, must not make one long frame.
bool GpuMeshCache::hasTime() {
  if (most_ms_ < 0 || all_now_) return true;
  if (!spending_.isValid()) spending_.start();
  return spending_.elapsed() < most_ms_;
}

std::size_t GpuMeshCache::pending() const {
  return static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(), [](const auto& known) {
    return known.second.prepared && (!known.second.mesh || known.second.rough);
  }));
}

void GpuMeshCache::collect() {
  for (auto& [address, entry] : entries_) {
    const bool was_rough = entry.rough;
    // What lasts looks the same but where it was rough: only that is worth another frame.
    if (entry.mesh && ((!bring(entry) && was_rough) || was_rough != entry.rough)) left_over_ = true;
  }
  spending_.invalidate();
  all_now_ = false;
  if (std::exchange(left_over_, false)) on_ready_();
  std::erase_if(entries_, [](const auto& known) {
    const Entry& entry = known.second;
    return entry.source.expired() || (!entry.used && entry.prepared && !entry.mesh);
  });
  // What was not drawn may be again with the next motion, as links behind a skin; large things are not kept for it.
  std::size_t spare = 0;
  for (const auto& [address, entry] : entries_) {
    const auto source = entry.source.lock();
    if (source && !entry.used) spare += source->triangles.size();
  }
  if (spare > kMostSpareTriangles) std::erase_if(entries_, [](const auto& entry) { return !entry.second.used; });
  for (auto& entry : entries_) entry.second.used = false;
}

}  // namespace hapticell::app
