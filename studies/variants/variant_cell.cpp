// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/variant_cell.h"

#include "manipulation/scene/scene_service.h"

namespace hapticell::studies {

const std::shared_ptr<const manipulation::PreparedScene>& VariantCell::scene() {
  if (!scene_) scene_ = sceneOf(document);
  return scene_;
}

std::shared_ptr<const manipulation::PreparedScene> VariantCell::sceneOf(const workcell::Document& other) const {
  // Not by a SceneService: variants are prepared in parallel, and all that is slow in it is prepared already.
  const manipulation::SceneSource source =
      manipulation::sourceOf(other, manipulation::pairDefaults(inputs_.configuration));
  return manipulation::PreparedScene::prepare(source.entities, source.pairs, source.defaults, inputs_.scene.get());
}

}  // namespace hapticell::studies
