// SPDX-License-Identifier: Apache-2.0
#include "app/edit/part_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/controls/ghost_placer.h"
#include "app/controls/place_fields.h"
#include "app/controls/pose_text.h"
#include "app/edit/part_names.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/live_label.h"
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

using workcell::BuiltInPart;
using workcell::Entity;

constexpr QSize kPartThumb{72, 54};
constexpr QSize kPartCell{96, 84};  // Three in a row beside the scroll bar.
constexpr QSize kPartPicture{308, 130};
constexpr int kPartListHeight = 3 * kPartCell.height() + 8;
// ms between two small pictures of robots, so that clicks come between. Half: the panel answers later; twice: the list
// fills slowly.
constexpr int kPartDrawPause = 30;
constexpr double kMillimetres = 1000.0;

/// The point of the floor in the middle of the picture; the origin where the eye does not look at the floor nearby.
dvec3 floorInView(const Camera& camera) {
  const dvec3 eye = camera.eye_W(), ahead = camera.forward_W();
  if (ahead.z > -0.05) return dvec3(0.0);
  const dvec3 p = eye - (eye.z / ahead.z) * ahead;
  if (eye.z <= 0.0 || glm::length(p - camera.target_W) > 2.0 * camera.distance) return dvec3(0.0);
  const auto rounded = [](double x) { return 0.05 * std::round(x / 0.05); };
  return {rounded(p.x), rounded(p.y), 0.0};
}

/// The link that carries the robot's tool; -1 where it has none.
int tipOf(const Entity& robot) {
  const int tip = robot.robot()->findLink(robot.jointed().tip_link);
  return tip >= 0 ? tip : robot.robot()->defaultTip();
}

}  // namespace

PartPanel::PartPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  auto* scrolled = new QWidget;
  auto* column = new QVBoxLayout(scrolled);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  QVBoxLayout* choice = addSection(*column, {});
  list_ = new QListWidget;
  list_->setObjectName("listParts");
  list_->setAccessibleName(tr("Built-in parts"));
  list_->setViewMode(QListView::IconMode);
  list_->setMovement(QListView::Static);
  list_->setResizeMode(QListView::Adjust);
  list_->setIconSize(kPartThumb);
  list_->setGridSize(kPartCell);
  list_->setUniformItemSizes(true);
  list_->setSpacing(0);
  list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  list_->setFixedHeight(kPartListHeight);
  for (const BuiltInPart& part : workcell::builtInParts()) {
    auto* item = new QListWidgetItem(icon("cube"), partName(part), list_);
    item->setData(Qt::UserRole, QLatin1String(part.scheme));
  }
  choice->addWidget(list_);
  big_picture_ = new QLabel;
  big_picture_->setFixedHeight(kPartPicture.height());
  big_picture_->setAlignment(Qt::AlignCenter);
  choice->addWidget(big_picture_);
  column->addWidget(makeSizes());
  column->addStretch(1);
  whole->addWidget(scrolledPanel(scrolled), 1);
  whole->addWidget(makePlace());  // Never scrolled away: it holds the button that inserts.
  connect(list_, &QListWidget::currentRowChanged, this, &PartPanel::showChosen);
  connect(list_, &QListWidget::itemPressed, this, &PartPanel::showGhost);
  connect(list_, &QListWidget::itemDoubleClicked, this, &PartPanel::insert);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &PartPanel::showRobots);
  connect(&draw_, &QTimer::timeout, this, &PartPanel::drawPictures);
  list_->setCurrentRow(0);
}

QWidget* PartPanel::makeSizes() {
  auto* holder = new QWidget;
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* section = addSection(*column, tr("Size"));
  for (std::size_t i = 0; i < kMostSizes; ++i) {
    sizes_[i] = new ValueField({QStringLiteral("mm"), 1, 0.001, 1e6, 10.0});
    sizes_[i]->setObjectName(QStringLiteral("sizePart%1").arg(i + 1));
    names_[i] = makeLabel({}, TextRole::kSecond, true);
    names_[i]->setFixedWidth(kLabelColumn);
    // Rows that a part has no use for keep their room, so that nothing below moves from part to part.
    rows_[i] = new QWidget;
    auto* row = new QHBoxLayout(rows_[i]);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(names_[i]);
    row->addWidget(sizes_[i], 1);
    QSizePolicy kept = rows_[i]->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    rows_[i]->setSizePolicy(kept);
    section->addWidget(rows_[i]);
    connect(sizes_[i], &ValueField::edited, this, &PartPanel::showPart);
  }
  problem_ = makeLive(1, TextRole::kSecond, true);
  problem_->setObjectName("labelPartProblem");
  section->addWidget(problem_);
  return holder;
}

QWidget* PartPanel::makePlace() {
  auto* holder = new QWidget;
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* section = addSection(*column, tr("Placement"));
  place_ = new PlaceFields(host_, "placePart", tr("Click where the centre of its underside goes"));
  section->addWidget(place_);
  ghost_ = new GhostPlacer(
      host_, *place_, [this] { insertThere(); }, this);
  mount_on_ = new QComboBox;
  mount_on_->setObjectName("comboMountOn");
  mount_row_ = addRow(*section, tr("Mount on"), mount_on_);
  QSizePolicy kept = mount_row_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  mount_row_->setSizePolicy(kept);
  insert_ = new QPushButton(tr("Insert"));
  insert_->setObjectName("buttonInsertPart");
  insert_->setProperty("main", true);
  section->addSpacing(4);
  section->addWidget(insert_);
  connect(insert_, &QPushButton::clicked, this, &PartPanel::insert);
  connect(mount_on_, &QComboBox::activated, this, &PartPanel::showPart);
  return holder;
}

void PartPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  place_->set(floorInView(host_.viewport().camera()));
  showRobots();
  draw_.start(kPartDrawPause);
}

void PartPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  ghost_->end();
}

void PartPanel::choose(const QString& scheme) {
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(Qt::UserRole).toString() == scheme) list_->setCurrentRow(row);
}

const BuiltInPart& PartPanel::chosen() const {
  return workcell::builtInParts()[static_cast<std::size_t>(std::max(0, list_->currentRow()))];
}

std::string PartPanel::source() const {
  QString words = QLatin1String(chosen().scheme) + QLatin1Char(':');
  for (std::size_t i = 0; i < chosen().sizes.size(); ++i)
    words += (i == 0 ? QString() : QStringLiteral(",")) + QString::number(sizes_[i]->value() / kMillimetres, 'g', 9);
  return words.toStdString();
}

std::optional<Entity> PartPanel::part() const {
  auto made = workcell::makeBuiltInPart(source(), 1.0);
  if (!made) return std::nullopt;
  // The fields say where its lower side stands, whatever its own origin is.
  made->X_WE = place_->X_W() * Pose::translation({0.0, 0.0, -made->mesh()->bounds().min.z});
  made->name = partName(chosen()).toStdString();
  return std::move(*made);
}

void PartPanel::showChosen() {
  const BuiltInPart& part = chosen();
  for (std::size_t i = 0; i < kMostSizes; ++i) {
    const bool used = i < part.sizes.size();
    rows_[i]->setVisible(used);
    if (!used) continue;
    const QString name = sizeName(part.sizes[i]);
    names_[i]->setText(name);
    sizes_[i]->setAccessibleName(name);
    sizes_[i]->setValue(kMillimetres * part.sizes[i].standard);
  }
  mount_row_->setVisible(part.origin == BuiltInPart::Origin::kFlange);
  showPart();
}

void PartPanel::showPart() {
  std::optional<Entity> made = part();
  insert_->setEnabled(made.has_value());
  place_->setEnabled(robotToMountOn() == nullptr);
  QString problem;
  for (std::size_t i = 0; !made && i < chosen().sizes.size(); ++i) {
    const workcell::PartSize& size = chosen().sizes[i];
    if (sizes_[i]->value() < kMillimetres * size.least)
      problem = tr("%1: at least %2 mm").arg(sizeName(size)).arg(kMillimetres * size.least, 0, 'g', 6);
  }
  if (!made && problem.isEmpty()) problem = tr("The inner radius must be smaller than the outer one");
  problem_->setText(problem);
  if (ghost_->isOn()) showGhost();
  if (!made || !isVisible()) return;
  made->X_WE = {};
  const QImage picture = picture_.draw({std::move(*made)}, kPartPicture, themeOf(palette()));
  if (!picture.isNull()) big_picture_->setPixmap(QPixmap::fromImage(picture));
}

/// Not of what is mounted: that has its place.
void PartPanel::showGhost() {
  std::optional<Entity> made = part();
  if (!made || robotToMountOn()) return ghost_->end();
  made->X_WE = place_->X_W().inverse() * made->X_WE;
  QWidget* const focused = ghost_->isOn() ? nullptr : focusWidget();
  ghost_->begin(*made);
  if (focused) focused->setFocus();  // The pick took it; letters and arrows go on in the panel.
}

void PartPanel::showRobots() {
  const QVariant before = mount_on_->count() > 0 ? mount_on_->currentData() : QVariant();
  mount_on_->clear();
  mount_on_->addItem(tr("Nothing (free-standing)"), QVariant::fromValue<qulonglong>(0));
  for (const auto& entity : host_.documentModel().document().state().entities) {
    if (entity->kind() != workcell::EntityKind::kRobot || tipOf(*entity) < 0) continue;
    mount_on_->addItem(QString::fromStdString(entity->name), QVariant::fromValue<qulonglong>(entity->id));
  }
  // A gripper is for the robot that is chosen, or the only one.
  const qulonglong kept = before.toULongLong();
  const qulonglong wanted = kept != 0 ? kept : host_.selection().current();
  const int found = wanted != 0 ? mount_on_->findData(QVariant::fromValue(wanted)) : -1;
  const int only_robot = mount_on_->count() == 2 ? 1 : 0;
  mount_on_->setCurrentIndex(found >= 0 ? found : only_robot);
  showPart();
}

/// One small picture a call, until all are there.
void PartPanel::drawPictures() {
  if (!isVisible()) return draw_.stop();
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    if (item->data(Qt::UserRole + 1).toBool()) continue;
    item->setData(Qt::UserRole + 1, true);
    auto made = workcell::makeBuiltInPart(item->data(Qt::UserRole).toString().toStdString() + ":", 1.0);
    if (!made) continue;
    const QImage picture = picture_.draw({std::move(*made)}, kPartThumb * devicePixelRatioF(), themeOf(palette()));
    if (picture.isNull()) return draw_.stop();
    return item->setIcon(QIcon(QPixmap::fromImage(picture)));
  }
  draw_.stop();
}

const Entity* PartPanel::robotToMountOn() const {
  if (chosen().origin != BuiltInPart::Origin::kFlange || mount_on_->currentIndex() < 0) return nullptr;
  return host_.documentModel().document().find(mount_on_->currentData().toULongLong());
}

void PartPanel::insert() {
  ghost_->end();
  insertThere();
}

void PartPanel::insertThere() {
  std::optional<Entity> made = part();
  if (!made) return;
  DocumentModel& document = host_.documentModel();
  made->name = document.document().uniqueName(made->name);
  const std::string name = made->name;
  const Entity* robot = robotToMountOn();
  const workcell::EntityId mounted_on = robot ? robot->id : 0;
  if (robot) {
    const int tip = tipOf(*robot);
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(*robot->robot(), robot->joints(), X_BL);
    made->X_WE = robot->X_WE * X_BL[static_cast<std::size_t>(tip)];
  }
  document.beginStep(tr("Insert %1").arg(QString::fromStdString(name)));
  const bool added = document.execute(workcell::AddEntity{std::move(*made)});
  const Entity* entity = added ? document.document().findByName(name) : nullptr;
  const workcell::EntityId id = entity ? entity->id : 0;
  if (id != 0 && mounted_on != 0) mount(id, *document.document().find(mounted_on));
  document.endStep();
  if (id != 0) host_.selection().set(id);
}

/// The tool centre point goes with it where nobody has set another yet.
void PartPanel::mount(workcell::EntityId part, const Entity& robot) {
  DocumentModel& document = host_.documentModel();
  const workcell::EntityId id = robot.id;
  const int tip = tipOf(robot);
  const std::string link = robot.robot()->links[static_cast<std::size_t>(tip)].name;
  const bool bare = robot.jointed().X_LT.p == dvec3(0.0);
  const QString name = QString::fromStdString(robot.name);
  if (!document.execute(workcell::Attach{part, id, link}) || !bare) return;
  const double ahead = document.document().find(part)->mesh()->bounds().max.z;
  if (!document.execute(workcell::SetTool{id, link, Pose::translation({0.0, 0.0, ahead})})) return;
  host_.messages().tell(Severity::kInformation, tr("The TCP of %1 is at the gripper's finger tips").arg(name),
                        tr("%1 mm in front of the flange. To change it, use the Robot panel or undo the insertion.")
                            .arg(kMillimetres * ahead, 0, 'f', 0));
}

}  // namespace hapticell::app
