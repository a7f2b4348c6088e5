// SPDX-License-Identifier: Apache-2.0
// How the panel is put together; what it does stands in guides_panel_edit.cpp.
#include "app/guides/guides_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/guides/detents_text.h"
#include "app/guides/guide_making.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/kit/switch_list.h"
#include "app/style/icon.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

QPushButton* makeButton(const char* name, const QString& text, const QString& tip = {}) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  return button;
}

QLineEdit* makeShown(const char* name) {
  auto* line = new QLineEdit;
  line->setObjectName(name);
  line->setReadOnly(true);
  line->setFocusPolicy(Qt::NoFocus);
  return line;
}

/// A field and what stands beside it.
QWidget* beside(QWidget* field, std::initializer_list<QWidget*> more) {
  auto* holder = new QWidget;
  auto* row = new QHBoxLayout(holder);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(field, 1);
  for (QWidget* widget : more) row->addWidget(widget);
  return holder;
}

}  // namespace

GuidesPanel::GuidesPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addList(*column);
  addKinds(*column);
  editor_ = new QWidget;
  auto* editor = new QVBoxLayout(editor_);
  editor->setContentsMargins(0, 0, 0, 0);
  editor->setSpacing(0);
  addGeometry(*editor);
  addFields(*editor);
  column->addWidget(editor_);
  column->addStretch(1);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] { current_.clear(); });
  connect(&host_.documentModel(), &DocumentModel::changed, this, &GuidesPanel::show);
  connect(&host_.selection(), &Selection::changed, this, &GuidesPanel::show);
  show();
}

void GuidesPanel::addList(QVBoxLayout& column) {
  list_ = new SwitchList(tr("No guides yet"));
  list_->setObjectName("listGuides");
  list_->setAccessibleName(tr("Guides"));
  column.addSpacing(8);
  column.addWidget(list_);
  QVBoxLayout* section = addSection(column, {});
  new_ = makeButton("buttonNewGuide", tr("New guide"), tr("Choose a kind below, then pick its geometry in the scene"));
  new_->setProperty("main", true);
  remove_ = makeButton("buttonRemoveGuide", tr("Remove"));
  section->addWidget(sideBySide({new_, remove_}));
  auto* words =
      makeLabel(tr("A guide holds what you move on a line, a plane, a hinge … Select an entity, choose a kind, "
                   "then pick an edge or a face."),
                TextRole::kSecond, true);
  words->setWordWrap(true);
  empty_ = words;
  section->addWidget(words);
  connect(list_, &SwitchList::chosen, this, [this](int index) {
    const auto& guides = host_.documentModel().document().state().guides;
    if (index >= 0 && index < static_cast<int>(guides.size()))
      choose(QString::fromStdString(guides[static_cast<std::size_t>(index)].name));
  });
  connect(list_, &SwitchList::switched, this,
          [this](int, bool on) { edit([on](auto& guide) { guide.enabled = on; }); });
  connect(list_, &SwitchList::renamed, this, [this](int index, const QString& name) {
    list_->setCurrent(index);
    edit([&name](auto& guide) { guide.name = name.toStdString(); });
    show();
  });
  connect(new_, &QPushButton::clicked, this, &GuidesPanel::startNew);
  connect(remove_, &QPushButton::clicked, this, &GuidesPanel::removeGuide);
}

void GuidesPanel::addKinds(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Kind"));
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  kinds_ = new QButtonGroup(this);
  int place = 0;
  for (const workcell::GuideKind kind : guideKinds()) {
    const QString name = QString::fromStdString(guideKindName(kind));
    auto* button = new QToolButton;
    button->setObjectName("kind" + name);
    button->setIcon(icon("guide_" + name.toLower()));
    button->setIconSize(QSize(22, 22));
    button->setText(tr(name.toLatin1().constData()));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFixedHeight(50);
    kinds_->addButton(button, static_cast<int>(kind));
    grid->addWidget(button, place / 5, place % 5);
    ++place;
  }
  kinds_->button(static_cast<int>(wanted_))->setChecked(true);
  section->addLayout(grid);
  connect(kinds_, &QButtonGroup::idClicked, this, [this](int id) { chooseKind(static_cast<workcell::GuideKind>(id)); });
}

void GuidesPanel::addGeometry(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  name_ = new QLineEdit;
  name_->setObjectName("fieldGuideName");
  addRow(*section, tr("Name"), name_);
  entity_ = new QComboBox;
  entity_->setObjectName("comboGuided");
  addRow(*section, tr("Entity"), entity_);
  geometry_ = makeShown("fieldGeometry");
  pick_ = makeButton("buttonPickGeometry", tr("Pick"));
  addRow(*section, tr("Geometry"), beside(geometry_, {pick_}));
  path_ = makeButton("buttonPath", tr("From a recording…"), tr("The path of a recorded motion, thinned"));
  path_row_ = addRow(*section, {}, path_);
  reverse_ = makeButton("buttonReverse", tr("Turn round"), tr("The axis or normal points the other way"));
  place_ = makeButton("buttonPlace", tr("Through entity"),
                      tr("Moves the guide to where the entity is held, turned as it is"));
  addRow(*section, {}, sideBySide({reverse_, place_}));
  handle_ = makeShown("fieldHandle");
  handle_pick_ = makeButton("buttonPickHandle", tr("Pick"), tr("A point of the entity by which the hand holds it"));
  addRow(*section, tr("Handle at"), beside(handle_, {handle_pick_}));
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const QString name = name_->text().trimmed();
    if (!name.isEmpty() && name != current_) edit([&](auto& guide) { guide.name = name.toStdString(); });
    show();
  });
  connect(entity_, &QComboBox::activated, this,
          [this] { edit([this](auto& guide) { guide.entity = entity_->currentText().toStdString(); }); });
  connect(pick_, &QPushButton::clicked, this, [this] {
    if (const workcell::Guide* now = guide()) pickGeometry(now->kind, false);
  });
  connect(path_, &QPushButton::clicked, this, &GuidesPanel::takePath);
  connect(reverse_, &QPushButton::clicked, this, &GuidesPanel::reverseAxis);
  connect(place_, &QPushButton::clicked, this, &GuidesPanel::placeAtEntity);
  connect(handle_pick_, &QPushButton::clicked, this, &GuidesPanel::pickHandle);
}

void GuidesPanel::addStops(QVBoxLayout& section) {
  std::array<QWidget*, 2> sides{};
  for (std::size_t i = 0; i < 2; ++i) {
    has_stop_[i] = new QCheckBox;
    has_stop_[i]->setObjectName(i == 0 ? "checkLower" : "checkUpper");
    has_stop_[i]->setAccessibleName(i == 0 ? tr("Lower stop") : tr("Upper stop"));
    has_stop_[i]->setToolTip(i == 0 ? tr("Lower stop") : tr("Upper stop"));
    mm_stop_[i] = new ValueField({tr("mm"), 1, -1e5, 1e5, 1.0});
    degree_stop_[i] = new ValueField({QStringLiteral("°"), 1, -720.0, 720.0, 1.0});
    mm_stop_[i]->setObjectName(i == 0 ? "fieldLowerMm" : "fieldUpperMm");
    degree_stop_[i]->setObjectName(i == 0 ? "fieldLowerDegrees" : "fieldUpperDegrees");
    sides[i] = new QWidget;
    auto* row = new QHBoxLayout(sides[i]);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(has_stop_[i]);
    row->addWidget(mm_stop_[i], 1);
    row->addWidget(degree_stop_[i], 1);
    connect(has_stop_[i], &QCheckBox::clicked, this, [this, i] { editStop(i == 1); });
    for (ValueField* field : {mm_stop_[i], degree_stop_[i]})
      connect(field, &ValueField::edited, this, [this, i] { editStop(i == 1); });
  }
  stops_row_ = addRow(section, tr("Stops"), sideBySide({sides[0], sides[1]}));
}

void GuidesPanel::addLocks(QVBoxLayout& section) {
  const char* const names[]{"X", "Y", "Z", "A", "B", "C"};
  for (std::size_t i = 0; i < 6; ++i) {
    locks_[i] = new QPushButton(names[i]);
    locks_[i]->setObjectName(QString("lock") + names[i]);
    locks_[i]->setCheckable(true);
    locks_[i]->setMinimumWidth(24);
    locks_[i]->setToolTip(i < 3 ? tr("Held along %1").arg(names[i]) : tr("No turning about %1").arg("XYZ"[i - 3]));
    locks_[i]->setAccessibleName(locks_[i]->toolTip());
    connect(locks_[i], &QPushButton::clicked, this,
            [this, i](bool on) { edit([&](auto& guide) { guide.locked[i] = on; }); });
  }
  locks_row_ =
      addRow(section, tr("Locked"), sideBySide({locks_[0], locks_[1], locks_[2], locks_[3], locks_[4], locks_[5]}));
}

void GuidesPanel::addFields(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  const auto field = [&](const char* name, const ValueField::Format& format, double unit,
                         double workcell::Guide::*what) {
    auto* made = new ValueField(format);
    made->setObjectName(name);
    connect(made, &ValueField::edited, this,
            [this, unit, what](double value) { edit([&](auto& guide) { guide.*what = value * unit; }); });
    return made;
  };
  radius_ = field("fieldRadius", {tr("mm"), 1, 0.1, 1e5, 1.0}, 1e-3, &workcell::Guide::radius);
  radius_row_ = addRow(*section, tr("Radius"), radius_);
  pitch_ = field("fieldPitch", {tr("mm a turn"), 2, -1000.0, 1000.0, 0.1}, 1e-3, &workcell::Guide::pitch);
  pitch_row_ = addRow(*section, tr("Pitch"), pitch_);
  offset_ = field("fieldOffset", {tr("mm"), 1, 0.0, 1e5, 1.0}, 1e-3, &workcell::Guide::offset);
  offset_row_ = addRow(*section, tr("Offset"), offset_);
  addStops(*section);
  detents_ = new QLineEdit;
  detents_->setObjectName("fieldDetents");
  detents_->setToolTip(tr("Where it snaps in, several with spaces between"));
  detents_row_ = addRow(*section, tr("Detents"), detents_);
  detent_width_ = field("fieldDetentWidth", {tr("mm wide"), 1, 0.1, 1000.0, 1.0}, 1e-3, &workcell::Guide::detent_width);
  detent_force_ = field("fieldDetentForce", {tr("N/mm"), 2, 0.0, 0.5, 0.05}, 1e3, &workcell::Guide::detent_stiffness);
  detent_row_ = addRow(*section, {}, sideBySide({detent_width_, detent_force_}));
  friction_ = field("fieldFriction", {tr("N"), 1, 0.0, 3.0, 0.1}, 1.0, &workcell::Guide::friction);
  addRow(*section, tr("Friction"), friction_);
  help_ = new QSlider(Qt::Horizontal);
  help_->setObjectName("sliderHelp");
  help_->setRange(0, 100);
  help_value_ = makeLabel({}, TextRole::kText);
  help_value_->setMinimumWidth(40);
  help_value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  help_row_ = addRow(*section, tr("Help"), beside(help_, {help_value_}));
  addLocks(*section);
  auto* words = makeLabel(tr("Felt at once while it is edited."), TextRole::kSecond, true);
  section->addWidget(words);
  connect(detents_, &QLineEdit::editingFinished, this, [this] {
    const workcell::Guide* now = guide();
    if (!now) return;
    const bool turns = now->kind == workcell::GuideKind::kHinge;
    const std::vector<double> places = readDetents(detents_->text(), turns, now->detents);
    if (places != now->detents) edit([&](auto& guide) { guide.detents = places; });
    show();
  });
  connect(help_, &QSlider::sliderReleased, this,
          [this] { edit([this](auto& guide) { guide.help = 5.0 * help_->value(); }); });
  connect(help_, &QSlider::valueChanged, this, [this](int value) {
    help_value_->setText(tr("%1 %").arg(value));
    if (!help_->isSliderDown() && help_->hasFocus()) edit([value](auto& guide) { guide.help = 5.0 * value; });
  });
}

}  // namespace hapticell::app
