// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/surface_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace hapticell::app {
namespace {

constexpr double kShadowShift =
    3.0;  // Texels of the shadow map that a face looks at its shadow from the side of the light.
constexpr double kFrontRange = 0.01;  // Of the depth range: what is drawn over the scene.
fvec3 linear(const std::array<float, 3>& srgb) {
  return {srgb[0] * srgb[0], srgb[1] * srgb[1], srgb[2] * srgb[2]};
}

/// Parts of a few pixels are all edge: lines would only darken them. What the eye does not see needs none.
bool showsEdges(const Frame& frame, const FrameView& view, const RenderItem& item, const GpuMesh& mesh) {
  constexpr double kFewPixels = 4.0;  // Radius.
  const dvec3 p_WC = item.X_WM * (item.scale * mesh.bounds().center());
  const double radius = item.scale * mesh.bounds().radius();
  if (isOutside(view.band_from_world, p_WC, radius)) return false;
  const ViewSize size{static_cast<double>(frame.width), static_cast<double>(frame.height)};
  return radius >= kFewPixels * frame.pixel_ratio * frame.camera.metresPerPixel(p_WC, size);
}

/// Where lines would lie so close that they only darken the part (a fence, far away), they are fainter.
double lineStrength(const Frame& frame, const RenderItem& item, const GpuMesh& mesh) {
  constexpr double kClose = 1.0, kApart = 6.0, kLeast = 0.15;  // Pixels between lines; of the full strength.
  const ViewSize size{static_cast<double>(frame.width), static_cast<double>(frame.height)};
  const dvec3 p_WC = item.X_WM * (item.scale * mesh.bounds().center());
  const double pixel = frame.pixel_ratio * frame.camera.metresPerPixel(p_WC, size);
  const double apart = std::clamp((item.scale * mesh.creaseSpacing() / pixel - kClose) / (kApart - kClose), 0.0, 1.0);
  return kLeast + (1.0 - kLeast) * apart * apart * (3.0 - 2.0 * apart);
}

glm::dmat4 bandFromClip(const Frame& frame) {
  if (frame.bands <= 1) return glm::dmat4(1.0);
  const double low = std::max(0, frame.height * frame.band / frame.bands - kBandRoom);
  const double high = std::min(frame.height, frame.height * (frame.band + 1) / frame.bands + kBandRoom);
  const double middle = (low + high) / frame.height - 1.0, half = (high - low) / frame.height;
  return glm::scale(glm::dmat4(1.0), dvec3(1.0, 1.0 / half, 1.0)) *
         glm::translate(glm::dmat4(1.0), dvec3(0.0, -middle, 0.0));
}

}  // namespace

FrameView viewOf(const Frame& frame) {
  FrameView view;
  const ViewSize size{static_cast<double>(frame.width), static_cast<double>(frame.height)};
  const glm::dvec2 place = samplePlace(frame.sample);
  const glm::dmat4 shift =
      glm::translate(glm::dmat4(1.0), dvec3(2.0 * place.x / frame.width, 2.0 * place.y / frame.height, 0.0));
  geometry::Bounds reach = frame.bounds_W;
  // The floor belongs to what must be seen.
  const double floor = 13.0 * floorCell(frame.camera);
  reach.add(dvec3(frame.camera.target_W.x - floor, frame.camera.target_W.y - floor, 0.0));
  reach.add(dvec3(frame.camera.target_W.x + floor, frame.camera.target_W.y + floor, 0.0));
  view.clip_from_view = shift * frame.camera.projectionMatrix(size, reach);
  view.view_from_world = frame.camera.viewMatrix();
  view.clip_from_world = view.clip_from_view * view.view_from_world;
  view.band_from_world = bandFromClip(frame) * view.clip_from_world;
  return view;
}

SurfacePass::SurfacePass(Gl& gl)
    : gl_(gl), programs_("surface", "surface", {"SHADOWED", "HATCHED", "GHOST", "SECTIONED", "SOFT"}), uses_(gl) {}

namespace {

/// By which an item is known in the id buffer: its place, or that of the item it has no border with.
std::uint32_t identityOf(const std::vector<RenderItem>& items, std::uint32_t index) {
  while (index > 0 && items[index].borderless && items[index - 1].entity == items[index].entity) --index;
  return index + 1;
}

}  // namespace

void SurfacePass::fill(const std::vector<ItemBatch>& batches, const DrawContext& context) {
  std::vector<ItemInstance> uses;
  for (const ItemBatch& batch : batches) {
    for (const std::uint32_t index : batch.items) {
      const RenderItem& item = context.frame.items[index];
      ItemInstance& use = uses.emplace_back();
      setRows(use, context.view.view_from_world * worldFromDrawn(batch, item));
      use.albedo = linear(item.color);
      use.id = item.ghost != Ghost::kNone ? 0u : identityOf(context.frame.items, index) | item.state << 24;
    }
  }
  uses_.fill(uses);
}

void SurfacePass::drawBatches(QOpenGLShaderProgram& program, const std::vector<ItemBatch>& batches,
                              const DrawContext& context, bool hatched) {
  const Frame& frame = context.frame;
  fill(batches, context);
  const glm::vec4 section = sectionIn(frame, context.view.view_from_world);
  std::size_t before = 0;
  for (const ItemBatch& batch : batches) {
    const fvec3& hatch = frame.colors.set_colors[batch.set_color].contact;
    if (hatched) program.setUniformValue("hatch_color", hatch.x, hatch.y, hatch.z);
    if (batch.own) program.setUniformValue("hatch_color", (*batch.own)[0], (*batch.own)[1], (*batch.own)[2]);
    program.setUniformValue("pattern", static_cast<float>(batch.pattern));
    if (frame.section && batch.over_scene)
      program.setUniformValue("section", 0.0f, 0.0f, 0.0f, 1.0f);
    else if (frame.section)
      program.setUniformValue("section", section.x, section.y, section.z, section.w);
    if (batch.over_scene) gl_.glDepthRange(0.0, kFrontRange);
    context.share.offer({batch.mesh->trianglesOf(batch.step), batch.items.size()},
                        [&](const DrawPart& part) { batch.mesh->drawUses(batch.step, uses_, before, part); });
    if (batch.over_scene) gl_.glDepthRange(0.0, 1.0);
    before += batch.items.size();
  }
}

void SurfacePass::prepare(QOpenGLShaderProgram& program, const Frame& frame, const FrameView& view,
                          const ShadowPass* shadow) {
  program.bind();
  const fvec3 key(keyLightDirection_W());
  const fvec3 eye(-frame.camera.forward_W());
  const glm::mat3 world_from_view = glm::transpose(glm::mat3(view.view_from_world));
  setMatrix(gl_, program, "clip_from_view", view.clip_from_view);
  program.setUniformValue("key_direction", key.x, key.y, key.z);
  program.setUniformValue("eye_direction", eye.x, eye.y, eye.z);
  program.setUniformValue("perspective", frame.camera.perspective);
  program.setUniformValue("pixel_ratio", static_cast<float>(frame.pixel_ratio));
  gl_.glUniformMatrix3fv(program.uniformLocation("world_from_view"), 1, GL_FALSE, glm::value_ptr(world_from_view));
  if (!shadow) return;
  setMatrix(gl_, program, "light_from_view", shadow->lightFromWorld() * glm::inverse(view.view_from_world));
  bindTexture(gl_, program, "shadow_map", 0, shadow->map());
  program.setUniformValue("shadow_shift", static_cast<float>(kShadowShift * shadow->texel()));
  program.setUniformValue("turn", static_cast<float>(frame.sample));
}

void SurfacePass::draw(const DrawContext& context, const ShadowPass* shadow) {
  const Frame& frame = context.frame;
  if (shadow && !shadow->ready()) shadow = nullptr;
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthMask(GL_TRUE);
  gl_.glDisable(GL_BLEND);
  if (frame.section) gl_.glEnable(GL_CLIP_DISTANCE0);
  const unsigned set = (shadow ? 1u : 0u) | (frame.section ? 8u : 0u) | (shadow && frame.refine ? 16u : 0u);
  for (const bool hatched : {false, true}) {
    const auto batches =
        batchesOf(frame, context.view.band_from_world, hatched ? ItemKind::kHatched : ItemKind::kPlain, context.meshes);
    if (batches.empty()) continue;
    QOpenGLShaderProgram* program = programs_.of(set | (hatched ? 2u : 0u));
    if (!program) break;
    prepare(*program, frame, context.view, shadow);
    drawBatches(*program, batches, context, hatched);
  }
  drawGhosts(context);
  gl_.glDisable(GL_CLIP_DISTANCE0);
}

void SurfacePass::drawGhosts(const DrawContext& context) {
  const Frame& frame = context.frame;
  for (const ItemKind kind : {ItemKind::kGhost, ItemKind::kTouchingGhost, ItemKind::kOwnGhost}) {
    const auto batches = batchesOf(frame, context.view.band_from_world, kind, context.meshes);
    if (batches.empty()) continue;
    QOpenGLShaderProgram* program = programs_.of(4u | (frame.section ? 8u : 0u));
    if (!program) return;
    prepare(*program, frame, context.view, nullptr);
    const fvec3& color = kind == ItemKind::kTouchingGhost ? frame.colors.contact : frame.colors.selected;
    program->setUniformValue("hatch_color", color.x, color.y, color.z);
    // What is behind keeps its identity: it is picked and outlined through the ghost.
    gl_.glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawBatches(*program, batches, context, false);
    gl_.glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
}

EdgePass::EdgePass(Gl& gl) : gl_(gl), program_(loadProgram("edge", "edge")) {}

void EdgePass::prepareItem(const DrawContext& context, const RenderItem& item, const GpuMesh& mesh) {
  const Frame& frame = context.frame;
  const glm::dmat4 world_from_model = worldFromDisplay(item, mesh.center());
  setMatrix(gl_, *program_, "clip_from_model", context.view.clip_from_world * world_from_model);
  const glm::vec4 section = sectionInModel(frame, item, world_from_model);
  program_->setUniformValue("section", section.x, section.y, section.z, section.w);
  const glm::dmat4 model_from_world = glm::inverse(world_from_model);
  const glm::dvec4 eye = frame.camera.perspective ? model_from_world * glm::dvec4(frame.camera.eye_W(), 1.0)
                                                  : model_from_world * glm::dvec4(-frame.camera.forward_W(), 0.0);
  program_->setUniformValue("eye_in_model", static_cast<float>(eye.x), static_cast<float>(eye.y),
                            static_cast<float>(eye.z));
  const bool ghost = item.ghost != Ghost::kNone;
  const glm::vec4& color = frame.colors.crease;
  const fvec3 own(item.color[0], item.color[1], item.color[2]);
  const fvec3& other = item.ghost == Ghost::kTouches ? frame.colors.contact : frame.colors.selected;
  const fvec3& ghostly = item.ghost == Ghost::kOwn ? own : other;
  program_->setUniformValue(
      "line_color",
      ghost ? QVector4D(ghostly.x, ghostly.y, ghostly.z, 1.0f)
            : QVector4D(color.x, color.y, color.z, color.w * static_cast<float>(lineStrength(frame, item, mesh))));
  program_->setUniformValue("dash", static_cast<float>(ghost ? 9.0 * frame.pixel_ratio : 0.0));
  program_->setUniformValue("width", static_cast<float>((ghost ? 1.6 : 1.1) * frame.pixel_ratio));
}

void EdgePass::drawItem(const DrawContext& context, const RenderItem& item, GpuMesh& mesh, bool creases_only) {
  bool prepared = false;
  if (item.over_scene) gl_.glDepthRange(0.0, kFrontRange);
  context.share.offer({creases_only ? mesh.creases() : mesh.edges(), 1}, [&](const DrawPart& part) {
    if (!prepared) prepareItem(context, item, mesh);
    prepared = true;
    mesh.drawEdges(part.first_unit, part.units);
  });
  if (item.over_scene) gl_.glDepthRange(0.0, 1.0);
}

void EdgePass::draw(const DrawContext& context, bool creases_only) {
  if (!program_) return;
  const Frame& frame = context.frame;
  program_->bind();
  program_->setUniformValue("pixels", static_cast<float>(frame.width), static_cast<float>(frame.height));
  program_->setUniformValue("perspective", frame.camera.perspective);
  program_->setUniformValue("crease_cosine", 0.8829f);  // 28 degrees.
  program_->setUniformValue("nearer", 8.0e-4f);
  program_->setUniformValue("depth_offset", static_cast<float>(context.view.clip_from_view[3][2]));
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthMask(GL_FALSE);
  gl_.glEnablei(GL_BLEND, 0);
  gl_.glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  if (frame.section) gl_.glEnable(GL_CLIP_DISTANCE0);
  for (const RenderItem& item : frame.items) {
    if (!item.mesh || item.smooth || (item.state & kContact)) continue;
    GpuMesh* mesh = context.meshes.of(item);
    if (mesh && showsEdges(frame, context.view, item, *mesh)) drawItem(context, item, *mesh, creases_only);
  }
  gl_.glDisable(GL_CLIP_DISTANCE0);
  gl_.glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.glDisablei(GL_BLEND, 0);
  gl_.glDepthMask(GL_TRUE);
}

FloorPass::FloorPass(Gl& gl) : gl_(gl), programs_("grid", "grid", {"SHADOWED", "SOFT"}) {
  gl_.glGenVertexArrays(1, &vertex_array_);
}
FloorPass::~FloorPass() {
  gl_.glDeleteVertexArrays(1, &vertex_array_);
}

void FloorPass::draw(const DrawContext& context, const ShadowPass* shadow) {
  const Frame& frame = context.frame;
  const FrameView& view = context.view;
  if (shadow && (!shadow->ready() || frame.camera.elevation <= 0.0)) shadow = nullptr;
  QOpenGLShaderProgram* program = programs_.of((shadow ? 1u : 0u) | (shadow && frame.refine ? 2u : 0u));
  if (!program) return;
  const double cell = floorCell(frame.camera);
  const dvec3 target = frame.camera.target_W;
  const glm::dmat4 world_from_floor = glm::translate(glm::dmat4(1.0), dvec3(target.x, target.y, 0.0));
  program->bind();
  setMatrix(gl_, *program, "clip_from_floor", view.clip_from_world * world_from_floor);
  setMatrix(gl_, *program, "light_from_floor",
            (shadow ? shadow->lightFromWorld() : glm::dmat4(1.0)) * world_from_floor);
  program->setUniformValue("reach", static_cast<float>(13.0 * cell));
  program->setUniformValue("origin", static_cast<float>(-std::fmod(target.x, cell)),
                           static_cast<float>(-std::fmod(target.y, cell)));
  program->setUniformValue("cell", static_cast<float>(cell));
  program->setUniformValue("fade_small", static_cast<float>(7.2 * cell));
  program->setUniformValue("fade_large", static_cast<float>(13.0 * cell));
  const glm::vec4& color = frame.colors.grid;
  program->setUniformValue("line_color", color.x, color.y, color.z, color.w);
  program->setUniformValue("shadow_strength", frame.colors.floor_shadow);
  program->setUniformValue("turn", static_cast<float>(frame.sample));
  if (shadow) bindTexture(gl_, *program, "shadow_map", 0, shadow->map());
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthMask(GL_FALSE);
  gl_.glEnablei(GL_BLEND, 0);
  gl_.glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl_.glBindVertexArray(vertex_array_);
  context.share.once(1, [&] { gl_.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); });
  gl_.glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.glDisablei(GL_BLEND, 0);
  gl_.glDepthMask(GL_TRUE);
}

}  // namespace hapticell::app
