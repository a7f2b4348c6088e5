// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/content_rules.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/system/assertion.h"

namespace hapticell::workcell {

namespace {

using enum Treatment;

constexpr ContentRule kSdfRules[] = {
    {"sdf/world"},
    {"sdf/model"},
    {"sdf/include"},
    {"sdf/actor", kReported, HAPTICELL_TRANSLATED("an animated actor")},
    {"sdf/light", kNoted},
    {"world/model"},
    {"world/include"},
    {"world/frame"},
    {"world/population"},
    {"world/actor", kReported, HAPTICELL_TRANSLATED("an animated actor")},
    {"world/road", kReported, HAPTICELL_TRANSLATED("a road")},
    {"world/joint", kReported, HAPTICELL_TRANSLATED("a joint between models of a world")},
    {"world/state", kReported, HAPTICELL_TRANSLATED("a saved simulation state; the models are placed as described")},
    {"world/light", kNoted},
    {"world/plugin", kNoted},
    {"world/physics", kNoted},
    {"world/scene", kNoted},
    {"world/gui", kNoted},
    {"world/gravity", kNoted},
    {"world/magnetic_field", kNoted},
    {"world/atmosphere", kNoted},
    {"world/wind", kNoted},
    {"world/audio", kNoted},
    {"world/spherical_coordinates", kNoted},
    {"population/model"},
    {"population/include"},
    {"population/pose"},
    {"population/box"},
    {"population/cylinder"},
    {"population/model_count"},
    {"population/distribution"},
    {"distribution/type"},
    {"distribution/rows"},
    {"distribution/cols"},
    {"distribution/step"},
    {"include/uri"},
    {"include/name"},
    {"include/pose"},
    {"include/static", kNoted},
    {"include/placement_frame"},
    {"include/plugin", kNoted},
    {"include/experimental:params", kReported, HAPTICELL_TRANSLATED("changes to the included model")},
    {"model/link"},
    {"model/joint"},
    {"model/frame"},
    {"model/model"},
    {"model/include"},
    {"model/pose"},
    {"model/static", kNoted},
    {"model/self_collide", kNoted},
    {"model/allow_auto_disable", kNoted},
    {"model/enable_wind", kNoted},
    {"model/plugin", kNoted},
    {"model/gripper", kNoted},
    {"model/drake:joint", kReported, HAPTICELL_TRANSLATED("a joint type of Drake only")},
    {"frame/pose"},
    {"link/pose"},
    {"link/visual"},
    {"link/collision"},
    {"link/inertial", kNoted},
    {"link/gravity", kNoted},
    {"link/enable_wind", kNoted},
    {"link/self_collide", kNoted},
    {"link/kinematic", kNoted},
    {"link/must_be_base_link", kNoted},
    {"link/velocity_decay", kNoted},
    {"link/sensor", kNoted},
    {"link/light", kNoted},
    {"link/projector", kNoted},
    {"link/audio_sink", kNoted},
    {"link/audio_source", kNoted},
    {"link/battery", kNoted},
    {"link/particle_emitter", kNoted},
    {"link/plugin", kNoted},
    {"visual/geometry"},
    {"visual/pose"},
    {"visual/material"},
    {"visual/cast_shadows", kNoted},
    {"visual/laser_retro", kNoted},
    {"visual/transparency", kNoted},
    {"visual/visibility_flags", kNoted},
    {"visual/meta", kNoted},
    {"visual/plugin", kNoted},
    {"collision/geometry"},
    {"collision/pose"},
    {"collision/laser_retro", kNoted},
    {"collision/max_contacts", kNoted},
    {"collision/surface", kNoted},
    {"collision/density", kNoted},
    {"collision/auto_inertia_params", kNoted},
    {"geometry/box"},
    {"geometry/sphere"},
    {"geometry/cylinder"},
    {"geometry/capsule"},
    {"geometry/ellipsoid"},
    {"geometry/mesh"},
    {"geometry/empty"},
    {"geometry/plane", kReported, HAPTICELL_TRANSLATED("an infinite plane")},
    {"geometry/heightmap", kReported, HAPTICELL_TRANSLATED("terrain from an image")},
    {"geometry/image", kReported, HAPTICELL_TRANSLATED("a 3D grid of boxes from an image")},
    {"geometry/polyline", kReported, HAPTICELL_TRANSLATED("an extruded outline")},
    {"geometry/cone", kReported, HAPTICELL_TRANSLATED("a cone")},
    {"box/size"},
    {"sphere/radius"},
    {"cylinder/radius"},
    {"cylinder/length"},
    {"capsule/radius"},
    {"capsule/length"},
    {"ellipsoid/radii"},
    {"mesh/uri"},
    {"mesh/scale"},
    {"mesh/submesh"},
    {"mesh/convex_decomposition", kNoted},
    {"submesh/name"},
    {"submesh/center"},
    {"material/diffuse"},
    {"material/ambient"},
    {"material/specular", kNoted},
    {"material/emissive", kNoted},
    {"material/script", kNoted},
    {"material/shader", kNoted},
    {"material/lighting", kNoted},
    {"material/render_order", kNoted},
    {"material/double_sided", kNoted},
    {"material/shininess", kNoted},
    {"material/pbr", kNoted},
    {"joint/parent"},
    {"joint/child"},
    {"joint/pose"},
    {"joint/axis"},
    {"joint/axis2"},
    {"joint/thread_pitch"},
    {"joint/screw_thread_pitch"},
    {"joint/gearbox_ratio", kReported, HAPTICELL_TRANSLATED("two joints that turn in a fixed ratio")},
    {"joint/gearbox_reference_body", kNoted},
    {"joint/physics", kNoted},
    {"joint/sensor", kNoted},
    {"axis/xyz"},
    {"axis/limit"},
    {"axis/use_parent_model_frame"},
    {"axis/mimic"},
    {"axis/dynamics", kNoted},
    {"axis/initial_position", kNoted},
    {"axis2/xyz"},
    {"axis2/limit"},
    {"axis2/use_parent_model_frame"},
    {"axis2/mimic"},
    {"axis2/dynamics", kNoted},
    {"axis2/initial_position", kNoted},
    {"limit/lower"},
    {"limit/upper"},
    {"limit/velocity"},
    {"limit/effort", kNoted},
    {"limit/stiffness", kNoted},
    {"limit/dissipation", kNoted},
    {"mimic/multiplier"},
    {"mimic/offset"},
    {"mimic/reference"},
};

constexpr ContentRule kGltfRules[] = {
    {"KHR_mesh_quantization"},
    {"KHR_draco_mesh_compression"},
    {"EXT_meshopt_compression"},
    {"EXT_mesh_gpu_instancing"},
    {"KHR_materials_pbrSpecularGlossiness"},
    {"animations", kReported, HAPTICELL_TRANSLATED("animation; all parts are shown at rest")},
    {"skins", kReported, HAPTICELL_TRANSLATED("bones; the mesh is shown as modelled")},
    {"morph targets", kReported, HAPTICELL_TRANSLATED("shape morphing; the mesh is shown as modelled")},
    {"further scenes", kReported, HAPTICELL_TRANSLATED("scenes other than the main one")},
    {"points and lines", kReported, HAPTICELL_TRANSLATED("points and lines")},
    {"KHR_texture_transform", kNoted},
    {"KHR_texture_basisu", kNoted},
    {"EXT_texture_webp", kNoted},
    {"EXT_texture_avif", kNoted},
    {"MSFT_texture_dds", kNoted},
    {"KHR_lights_punctual", kNoted},
    {"EXT_lights_image_based", kNoted},
    {"KHR_materials_unlit", kNoted},
    {"KHR_materials_anisotropy", kNoted},
    {"KHR_materials_clearcoat", kNoted},
    {"KHR_materials_diffuse_transmission", kNoted},
    {"KHR_materials_dispersion", kNoted},
    {"KHR_materials_emissive_strength", kNoted},
    {"KHR_materials_ior", kNoted},
    {"KHR_materials_iridescence", kNoted},
    {"KHR_materials_sheen", kNoted},
    {"KHR_materials_specular", kNoted},
    {"KHR_materials_transmission", kNoted},
    {"KHR_materials_variants", kNoted},
    {"KHR_materials_volume", kNoted},
    {"KHR_animation_pointer", kNoted},
    {"KHR_xmp_json_ld", kNoted},
    {"KHR_xmp", kNoted},
    {"MSFT_lod", kNoted},
    {"other required extensions", kRefused},
};

constexpr ContentRule kColladaRules[] = {
    {"library_geometries"},
    {"library_visual_scenes"},
    {"library_nodes"},
    {"library_materials"},
    {"library_effects"},
    {"library_controllers", kReported, HAPTICELL_TRANSLATED("bones and shape morphing; the mesh is shown as modelled")},
    {"library_animations", kReported, HAPTICELL_TRANSLATED("animation; all parts are shown at rest")},
    {"library_kinematics_models", kReported, HAPTICELL_TRANSLATED("joints; all parts are read as rigid bodies")},
    {"library_articulated_systems", kReported, HAPTICELL_TRANSLATED("joints; all parts are read as rigid bodies")},
    {"library_physics_models", kReported, HAPTICELL_TRANSLATED("simulation bodies")},
    {"geometry/spline", kReported, HAPTICELL_TRANSLATED("curves")},
    {"geometry/brep", kReported, HAPTICELL_TRANSLATED("exact surfaces")},
    {"library_cameras", kNoted},
    {"library_lights", kNoted},
    {"library_images", kNoted},
    {"library_animation_clips", kNoted},
    {"library_physics_materials", kNoted},
    {"library_physics_scenes", kNoted},
};

constexpr ContentRule kThreeMfRules[] = {
    {"production"},
    {"material"},
    {"mesh"},
    {"components"},
    {"trianglesets", kNoted},
    {"beamlattice", kReported, HAPTICELL_TRANSLATED("a lattice of beams and balls")},
    {"slicestack", kReported, HAPTICELL_TRANSLATED("slices")},
    {"booleanshape", kReported, HAPTICELL_TRANSLATED("one shape cut out of another")},
    {"displacementmesh", kReported, HAPTICELL_TRANSLATED("a mesh displaced by an image")},
    {"levelset", kReported, HAPTICELL_TRANSLATED("an implicit shape")},
    {"implicit", kReported, HAPTICELL_TRANSLATED("an implicit shape")},
    {"other required extensions", kRefused},
};

constexpr ContentRule kStepRules[] = {
    {"solids, shells and surfaces"},
    {"assemblies"},
    {"references to other files"},
    {"names"},
    {"colours"},
    {"raw 8-bit names", kReported, HAPTICELL_TRANSLATED("the encoding is guessed")},
    {"tessellated shapes beside exact ones", kReported, HAPTICELL_TRANSLATED("triangles as in AP242")},
    {"faces that cannot be cut", kReported, HAPTICELL_TRANSLATED("missing triangles")},
    {"parts without a shape", kReported, HAPTICELL_TRANSLATED("lines only, or a file that is missing")},
    {"product manufacturing information", kNoted},
    {"layers", kNoted},
    {"properties", kNoted},
    {"joints", kReported, HAPTICELL_TRANSLATED("all parts are read as rigid bodies")},
    {"tessellated shapes only", kRefused},
};

constexpr FormatRules kFormats[] = {
    {"SDF", kSdfRules}, {"glTF", kGltfRules}, {"Collada", kColladaRules}, {"3MF", kThreeMfRules}, {"STEP", kStepRules},
};

/// "'a', 'b' and 3 more".
Text placesListed(const std::vector<Text>& places) {
  // Places in a message; the rest is counted. Half, twice: shorter or longer messages.
  constexpr std::size_t kMost = 5;
  Text list;
  for (std::size_t k = 0; k < std::min(kMost, places.size()); ++k) {
    list = list.empty() ? places[k] : Text("%1, %2", std::move(list), places[k]);
  }
  return places.size() > kMost ? Text("%1 and %2 more", std::move(list), places.size() - kMost) : list;
}

}  // namespace

const char* toString(Treatment treatment) {
  switch (treatment) {
    case kUsed:
      return "used";
    case kNoted:
      return "noted";
    case kReported:
      return "reported";
    case kRefused:
      break;
  }
  return "refused";
}

std::span<const FormatRules> contentRules() {
  return kFormats;
}

ContentReport::ContentReport(std::string_view format) {
  const auto* const found =
      std::find_if(std::begin(kFormats), std::end(kFormats), [&](const FormatRules& f) { return f.format == format; });
  HAPTICELL_DEMAND(found != std::end(kFormats));
  rules_ = found;
}

const ContentRule* ContentReport::rule(std::string_view element) const {
  const auto found = std::find_if(rules_->rules.begin(), rules_->rules.end(),
                                  [&](const ContentRule& rule) { return rule.element == element; });
  return found == rules_->rules.end() ? nullptr : &*found;
}

Treatment ContentReport::meet(std::string_view element, const Text& place) {
  const ContentRule* const known = rule(element);
  const Treatment unknown = element.find(':') == std::string_view::npos ? kReported : kNoted;
  const Treatment treatment = known ? known->treatment : unknown;
  if (treatment == kReported) reported_[std::string(element)].push_back(place);
  return treatment;
}

void ContentReport::tell(std::vector<Text>& warnings) const {
  for (const auto& [element, places] : reported_) {
    const ContentRule* const known = rule(element);
    const Text meaning = known ? Text(known->meaning) : Text("not supported by this reader");
    const bool has_place = std::any_of(places.begin(), places.end(), [](const Text& place) { return !place.empty(); });
    warnings.push_back(has_place ? Text("%1 (%2) is left out: %3", element, meaning, placesListed(places))
                                 : Text("%1 (%2) is left out", element, meaning));
  }
}

}  // namespace hapticell::workcell
