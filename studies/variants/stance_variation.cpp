// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "geometry/system/listed.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/shape/figure_model.h"
#include "studies/document/study_section.h"
#include "studies/variants/placed_entities.h"
#include "studies/variants/variation_kinds.h"

namespace hapticell::studies {

namespace {

const std::vector<std::string> kStances{"given", "seated"};

/// A mannequin as it is in the cell, or seated at its place.
class StanceChoice : public Variation {
 public:
  StanceChoice(std::string name, ValueRange range, workcell::EntityId body)
      : Variation(std::move(name), std::move(range)), body_(body) {}

  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    const std::string& stance = std::get<std::string>(value);
    if (stance == kStances.front()) return {};
    const workcell::Entity& body = *cell.document.find(body_);
    cell.stances[body.name] = stance;
    const auto posture = mannequin::toPosture(*body.figure(), {body.X_WE, body.joints()});
    const auto sits = mannequin::toModel(*body.figure(), ergonomics::seatedAt(posture, *body.figure()));
    HAPTICELL_TRY(cell.document.execute(workcell::SetConfiguration{body_, sits.X_WE, sits.joints}));
    return {};
  }

 private:
  workcell::EntityId body_;
};

}  // namespace

MadeVariation makeStanceChoice(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  std::string name;
  reader.fields().require("entity");
  reader.fields().read("entity", name);
  auto range = ValueRange::words(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  const auto body = inputs.entityNamed(section, name);
  HAPTICELL_TRY(body);
  if (!(*body)->figure())
    return makeError(section.fault(Text("entity '%1' of another kind", name), Text("a mannequin")));
  for (std::size_t i = 0; i < range->count(); ++i) {
    const std::string& stance = std::get<std::string>(range->at(i));
    if (std::find(kStances.begin(), kStances.end(), stance) != kStances.end()) continue;
    return makeError(section.fault(Text("the stance '%1'", stance), Text("one of %1", listed(kStances))));
  }
  return std::make_unique<StanceChoice>(section.name, std::move(*range), (*body)->id);
}

}  // namespace hapticell::studies
