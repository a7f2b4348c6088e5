// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/solid_place.h"

#include <QVBoxLayout>

#include "app/controls/pose_text.h"
#include "app/controls/reference_choice.h"
#include "app/edit/moved_entities.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr int kInParent = 1, kInFrame = 2;  // Of the choices of a reference.

}  // namespace

SolidPlace::SolidPlace(Host& host, QVBoxLayout& column, QObject* parent) : QObject(parent), host_(host) {
  QVBoxLayout* section = addSection(column, {});
  in_ = new Segmented({tr("World"), tr("Parent"), tr("Frame")});
  in_->setObjectName("segmentsPlaceIn");
  in_->setCurrent(0);
  addRow(*section, tr("Place in"), in_);
  frame_ = new ReferenceChoice(host_, {});
  frame_->setObjectName("comboPlaceFrame");
  frame_row_ = addRow(*section, tr("Frame"), frame_);
  const char* const names[]{"X", "Y", "Z", "A", "B", "C"};
  for (std::size_t i = 0; i < 6; ++i) {
    const double range = i < 3 ? 1e6 : 360.0;
    fields_[i] = new ValueField({i < 3 ? tr("mm") : QStringLiteral("°"), 1, -range, range, 1.0});
    fields_[i]->setObjectName(QStringLiteral("fieldSolid") + QString::fromLatin1(names[i]));
    connect(fields_[i], &ValueField::edited, this, &SolidPlace::place);
  }
  addRow(*section, tr("X Y Z"), sideBySide({fields_[0], fields_[1], fields_[2]}));
  addRow(*section, tr("A B C"), sideBySide({fields_[3], fields_[4], fields_[5]}));
  for (std::size_t i = 0; i < 6; ++i)
    fields_[i]->setAccessibleName(QString::fromLatin1(names[i]) + (i < 3 ? tr(" in millimetres") : tr(" in degrees")));
  connect(in_, &Segmented::chosen, this, &SolidPlace::showAgain);
  connect(frame_, &ReferenceChoice::referenceChanged, this, [this] {
    if (const workcell::Entity* now = solid()) showNow(*now);
  });
}

const workcell::Entity* SolidPlace::solid() const {
  const workcell::Entity* entity = host_.documentModel().document().find(host_.selection().current());
  return entity && entity->kind() == workcell::EntityKind::kSolid && entity->mesh() ? entity : nullptr;
}

void SolidPlace::showAgain() {
  const workcell::Entity* now = solid();
  if (!now) return;
  showChoices(*now);
  showNow(*now);
}

void SolidPlace::showChoices(const workcell::Entity& solid) {
  in_->setChoiceEnabled(kInParent, !solid.attachment.to.empty() || !solid.parent.empty(), tr("It has no parent"));
  for (ValueField* field : fields_) field->setEnabled(!solid.locked);
  frame_->leaveOut(solid.id);
  const bool frames = frame_->hasFrames();
  if (!frames && in_->current() == kInFrame) in_->setCurrent(0);
  in_->setChoiceEnabled(kInFrame, frames, tr("No frame in this cell yet. Add one with Insert > Frame."));
  frame_row_->setVisible(frames);
  frame_->setEnabled(in_->current() == kInFrame);
}

/// What its place is given in.
Pose SolidPlace::placeReference_W(const workcell::Entity& solid) const {
  if (in_->current() == kInFrame) return frame_->frame_W().value_or(Pose::identity());
  return in_->current() == kInParent ? parentPose_W(host_.documentModel().document().state(), solid) : Pose::identity();
}

void SolidPlace::showNow(const workcell::Entity& solid) {
  const Pose X_WE = host_.viewport().scene().placement_W(solid);
  const auto numbers = poseNumbers(placeReference_W(solid).inverse() * X_WE);
  for (std::size_t i = 0; i < 6; ++i)
    if (!fields_[i]->hasFocus()) fields_[i]->setValue(numbers[i]);
}

void SolidPlace::place() {
  const workcell::Entity* now = solid();
  if (!now) return;
  std::array<double, 6> numbers{};
  for (std::size_t i = 0; i < 6; ++i) numbers[i] = fields_[i]->value();
  const Pose X_WE = placeReference_W(*now) * poseFromNumbers(numbers);
  if (!host_.documentModel().execute(workcell::SetPlacement{now->id, X_WE})) showNow(*now);
}

}  // namespace hapticell::app
