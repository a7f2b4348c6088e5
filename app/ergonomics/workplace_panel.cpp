// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/workplace_panel.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/ergonomics/live_scores.h"
#include "app/ergonomics/score_painting.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/dock_front.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/kit/thread_pool_task.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/library_text.h"
#include "app/style/units.h"
#include "app/style/value_field.h"
#include "geometry/system/atomic_file.h"
#include "manipulation/scene/scene_service.h"
#include "studies/workplace/workplace_check.h"
#include "workcell/document/part_resize.h"
#include "workcell/entity/built_in_parts.h"

namespace hapticell::app {

namespace {

/// What sets an adjustable bench that stands upright higher by `rise`; nothing for other parts, and below its least.
std::optional<std::vector<workcell::Command>> benchAt(const workcell::DocumentState& state,
                                                      const workcell::Entity& entity, double rise) {
  if (!entity.source.path.starts_with("bench:") || entity.X_WE.rotate({0.0, 0.0, 1.0}).z < 0.999) return std::nullopt;
  std::vector<double> sizes = workcell::partSizes(entity.source);
  if (sizes.empty()) return std::nullopt;
  sizes.back() += rise;
  auto commands = workcell::resizePart(state, entity.id, sizes);
  if (!commands) return std::nullopt;
  return std::move(*commands);
}

}  // namespace

WorkplacePanel::WorkplacePanel(MannequinContext& context, const LiveScores& scores, QWidget* parent)
    : QWidget(parent), context_(context), scores_(scores) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* what = addSection(*column, tr("These parts can move, with the targets of the hands"));
  station_ = new QListWidget;
  station_->setObjectName("listStation");
  station_->setMaximumHeight(130);
  station_->setAccessibleName(tr("Parts that can move"));
  what->addWidget(station_);
  moves_ = makeLive(2, TextRole::kSecond);
  moves_->setObjectName("labelMoves");
  what->addWidget(moves_);
  QVBoxLayout* how = addSection(*column, tr("Range"));
  const auto field = [&](const char* name, const QString& words, double least, double most, double value) {
    auto* made = new ValueField({tr("mm"), 0, least, most, 10.0});
    made->setObjectName(name);
    made->setValue(value);
    addRow(*how, words, made);
    return made;
  };
  rise_ = field("fieldRise", tr("Up/down ±"), 0.0, 600.0, 200.0);
  away_ = field("fieldAway", tr("Near/far ±"), 0.0, 600.0, 160.0);
  step_ = field("fieldStep", tr("In steps of"), 5.0, 200.0, 40.0);
  sit_ = new QCheckBox(tr("Try sitting as well"));
  sit_->setObjectName("checkSit");
  how->addWidget(sit_);
  auto* line = new QHBoxLayout;
  search_ = new QPushButton(tr("Search"));
  search_->setObjectName("buttonStartSearch");
  search_->setProperty("main", true);
  cancel_ = new QPushButton(tr("Cancel"));
  cancel_->setObjectName("buttonCancelSearch");
  line->addWidget(search_);
  line->addWidget(cancel_);
  how->addLayout(line);
  bar_ = new QProgressBar;
  bar_->setTextVisible(false);
  bar_->setMaximumHeight(6);
  how->addWidget(bar_);
  QVBoxLayout* found = addSection(*column, tr("Worst RULA of four mannequins"));
  view_ = new WorkplaceView;
  found->addWidget(view_);
  result_ = makeLive(4, TextRole::kText);
  result_->setObjectName("labelSearch");
  found->addWidget(result_);
  take_ = new QPushButton(tr("Move it there"));
  take_->setObjectName("buttonTakePlace");
  save_ = new QPushButton(tr("Save as study…"));
  save_->setObjectName("buttonSaveWorkplaceStudy");
  save_->setToolTip(tr("Write the search as a study, and open it in the study panel"));
  auto* after = new QHBoxLayout;
  after->addWidget(take_);
  after->addWidget(save_);
  after->addStretch(1);
  found->addLayout(after);
  column->addStretch(1);
  poll_.setInterval(100);
  connect(&poll_, &QTimer::timeout, this, [this] { bar_->setValue(static_cast<int>(100.0 * run_->progress)); });
  connect(station_, &QListWidget::itemChanged, this, &WorkplacePanel::showMoves);
  connect(search_, &QPushButton::clicked, this, &WorkplacePanel::search);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (run_) run_->cancel = true;
  });
  connect(take_, &QPushButton::clicked, this, &WorkplacePanel::take);
  connect(save_, &QPushButton::clicked, this, &WorkplacePanel::saveStudy);
  connect(view_, &WorkplaceView::chose, this, &WorkplacePanel::showMap);
  connect(&context_, &MannequinContext::documentChanged, this, &WorkplacePanel::fillStation);
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, [this] {
    if (run_) run_->cancel = true;
    run_.reset();
    busy_ = false;
    poll_.stop();
    bar_->setValue(0);
    map_.reset();
    asked_ = {};
    view_->setMap(nullptr);
    station_->clear();
    showMap();
  });
  fillStation();
  showMap();
}

WorkplacePanel::~WorkplacePanel() {
  if (run_) run_->cancel = true;
}

void WorkplacePanel::fillStation() {
  const auto& entities = context_.host().documentModel().document().state().entities;
  std::vector<const workcell::Entity*> wanted;
  for (const auto& entity : entities)
    if (!entity->figure() && entity->kind() != workcell::EntityKind::kFrame && entity->attachment.to.empty() &&
        !entity->locked)
      wanted.push_back(entity.get());
  bool same = station_->count() == static_cast<int>(wanted.size());
  for (int i = 0; same && i < station_->count(); ++i)
    same = station_->item(i)->text().toStdString() == wanted[static_cast<std::size_t>(i)]->name &&
           station_->item(i)->data(Qt::UserRole).toULongLong() == wanted[static_cast<std::size_t>(i)]->id;
  if (same) return showMoves();
  const auto chosen = station();
  const QSignalBlocker quiet(station_);
  station_->clear();
  for (const workcell::Entity* entity : wanted) {
    auto* item = new QListWidgetItem(QString::fromStdString(entity->name), station_);
    item->setData(Qt::UserRole, static_cast<qulonglong>(entity->id));
    const bool on = std::find(chosen.begin(), chosen.end(), entity->id) != chosen.end();
    item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
  }
  showMoves();
}

studies::WorkplaceQuestion WorkplacePanel::questionOfStation() const {
  studies::WorkplaceQuestion question;
  question.entities = context_.host().documentModel().document().snapshotEntities();
  if (const workcell::Entity* entity = context_.entity()) question.mannequin = entity->id;
  question.station = station();
  return question;
}

studies::WorkplaceQuestion WorkplacePanel::questionOfFields() const {
  studies::WorkplaceQuestion question = questionOfStation();
  question.task = scores_.isEmpty() ? ergonomics::WorkTask{} : scores_.task();
  question.rise_to = rise_->value() / 1000.0;
  question.rise_from = -question.rise_to;
  question.away_to = away_->value() / 1000.0;
  question.away_from = -question.away_to;
  question.rise_step = question.away_step = step_->value() / 1000.0;
  question.may_sit = sit_->isChecked();
  return question;
}

void WorkplacePanel::showMoves() {
  const auto question = questionOfStation();
  QStringList along;
  for (const workcell::EntityId id : studies::movedWith(question)) {
    const workcell::Entity* entity = context_.host().documentModel().document().find(id);
    if (entity && !entity->attachment.to.empty()) along << QString::fromStdString(entity->name);
  }
  save_->setEnabled(context_.entity() && !question.station.empty());
  search_->setEnabled(!busy_ && context_.entity() && !question.station.empty());
  if (!context_.entity()) {
    return moves_->setText(tr("There is no mannequin in the cell. Add one, and give its hands what they reach for."));
  }
  if (question.station.empty()) return moves_->setText(tr("Tick at least one part: a bench, a shelf, a fixture."));
  moves_->setText(along.isEmpty()
                      ? tr("The ticked parts move; everything else stays.")
                      : tr("The ticked parts move, and what is attached to them: %1. Everything else stays.")
                            .arg(along.join(", ")));
}

std::optional<ergonomics::WorkplaceFinding> WorkplacePanel::finding() const {
  if (!map_) return std::nullopt;
  ergonomics::WorkplaceFinding found;
  found.moves = asked_.moved;
  const int cell = view_->chosen();
  if (cell < 0 || map_->cells[static_cast<std::size_t>(cell)].worst == 0) return found;
  const auto& place = map_->cells[static_cast<std::size_t>(cell)];
  found.is_found = true;
  found.rise = place.rise;
  found.away = place.away;
  found.is_seated = place.is_seated;
  found.rula = place.rula;
  return found;
}

std::vector<workcell::EntityId> WorkplacePanel::station() const {
  std::vector<workcell::EntityId> ids;
  for (int i = 0; i < station_->count(); ++i)
    if (station_->item(i)->checkState() == Qt::Checked)
      ids.push_back(station_->item(i)->data(Qt::UserRole).toULongLong());
  return ids;
}

void WorkplacePanel::search() {
  const workcell::Entity* entity = context_.entity();
  if (busy_ || !entity) return;
  studies::WorkplaceQuestion question = questionOfFields();
  const dvec3 ahead = context_.posture().X_WR.rotate({1.0, 0.0, 0.0});
  asked_.ahead_W = glm::normalize(dvec3(ahead.x, ahead.y, 0.0));
  asked_.station = question.station;
  asked_.moved.clear();
  for (const workcell::EntityId id : studies::movedWith(question))
    asked_.moved.push_back(context_.host().documentModel().document().find(id)->name);
  asked_.question = std::make_shared<const studies::WorkplaceQuestion>(std::move(question));
  run_ = std::make_shared<Run>();
  busy_ = true;
  map_.reset();
  view_->setMap(nullptr);
  poll_.start();
  showMap();
  runInThreadPool(
      this,
      [question = asked_.question, run = run_, scenes = context_.host().scenes()] {
        return studies::searchWorkplace(
            *question, *scenes, [&run](double share) { run->progress = share; }, run->cancel);
      },
      [this, run = run_](Expected<studies::WorkplaceMap> map) {
        if (run != run_) return;
        busy_ = false;
        poll_.stop();
        bar_->setValue(map ? 100 : 0);
        if (map) {
          map_ = std::move(*map);
          view_->setMap(&*map_);
        } else {
          context_.host().messages().reportCause(Severity::kWarning, tr("The workplace search failed"), map.error());
        }
        showMap();
      });
}

void WorkplacePanel::showMap() {
  emit findingChanged();
  showMoves();
  cancel_->setEnabled(busy_);
  const int cell = view_->chosen();
  take_->setEnabled(map_ && cell >= 0 && map_->cells[static_cast<std::size_t>(cell)].worst > 0);
  if (busy_) return result_->setText(tr("Trying every placement with four mannequins…"));
  if (!map_) return result_->setText(tr("Choose what can be moved, then search."));
  QStringList names;
  for (const std::string& name : asked_.moved) names << shown(name);
  QString text = map_->is_complete ? QString() : tr("Cancelled: the map is not complete. ");
  if (cell < 0) {
    result_->setText(text + tr("No placement suits all four mannequins.") + ' ' +
                     tr("Moved: %1.").arg(names.join(", ")));
    return;
  }
  const auto& place = map_->cells[static_cast<std::size_t>(cell)];
  const QString rise = lengthText(std::abs(place.rise), 0), away = lengthText(std::abs(place.away), 0);
  text += tr("%1, %2, %3: ")
              .arg(place.rise < 0.0 ? tr("%1 lower").arg(rise) : tr("%1 higher").arg(rise),
                   place.away < 0.0 ? tr("%1 nearer").arg(away) : tr("%1 farther").arg(away),
                   place.is_seated ? tr("sitting") : tr("standing"));
  text += place.worst > 0 ? tr("worst RULA %1 (P5 woman %2, P50 woman %3, P50 man %4, P95 man %5).")
                                .arg(place.worst)
                                .arg(place.rula[0])
                                .arg(place.rula[1])
                                .arg(place.rula[2])
                                .arg(place.rula[3])
                          : shown(place.why) + '.';
  text += ' ' + tr("Moved: %1.").arg(names.join(", "));
  result_->setText(text);
}

void WorkplacePanel::take() {
  if (!map_ || view_->chosen() < 0) return;
  const auto& place = map_->cells[static_cast<std::size_t>(view_->chosen())];
  const auto& document = context_.host().documentModel().document();
  std::vector<workcell::Command> commands;
  for (const workcell::EntityId id : asked_.station) {
    const workcell::Entity* entity = document.find(id);
    if (!entity) continue;
    Pose there = entity->X_WE;
    there.p += place.away * asked_.ahead_W;
    // An adjustable bench is set to another height; its feet stay on the floor.
    if (const auto higher = benchAt(document.state(), *entity, place.rise)) {
      commands.insert(commands.end(), higher->begin(), higher->end());
    } else {
      there.p.z += place.rise;
    }
    commands.emplace_back(workcell::SetPlacement{id, there});
  }
  if (commands.empty() || !context_.host().documentModel().executeAll(tr("Move the workplace"), commands)) return;
  checkTaken(place);
}

void WorkplacePanel::checkTaken(const studies::WorkplaceCell& place) {
  runInThreadPool(
      this,
      [question = asked_.question, place, after = context_.host().documentModel().document().snapshotEntities(),
       scenes = context_.host().scenes()] {
        return studies::workplacePromises(*question, place, after, *scenes);
      },
      [this](const Promises& promises) {
        if (promises.areKept()) return;
        context_.host().messages().tell(
            Severity::kProblem, tr("This placement does not give the score that was found"),
            shownText(promises.missed("")) + ' ' +
                tr("The parts were moved. Undo, or search again in the cell as it is now."));
      });
}

void WorkplacePanel::saveStudy() {
  const DocumentModel& model = context_.host().documentModel();
  const std::filesystem::path cell = model.document().path();
  if (cell.empty() || model.isDirty()) {
    context_.host().messages().tell(Severity::kInformation, tr("Save the workcell first"),
                                    tr("A study names the file of its workcell, which must be as it is here."));
    return result_->setText(tr("Save the workcell first: a study names its file."));
  }
  const QFileInfo base(QString::fromStdString(cell.string()));
  const QString file = askToSave(window(), tr("Save the study"),
                                 base.absolutePath() + '/' + base.completeBaseName() + QStringLiteral("-workplace.hstudy"),
                                 tr("Studies (*.hstudy)"));
  if (file.isEmpty()) return;
  const std::filesystem::path target = QFileInfo(file).absoluteFilePath().toStdString();
  const bool beside = target.parent_path() == cell.parent_path();
  const auto text = studies::workplaceStudy(questionOfFields(), beside ? cell.filename().string() : cell.string());
  const Expected<void> written = text ? writeFileAtomically(target, *text) : tl::unexpected(text.error());
  if (!written)
    return context_.host().messages().reportCause(Severity::kProblem, tr("The study could not be saved"), written.error());
  // By name: features do not include each other.
  QMainWindow& window = context_.host().window();
  if (auto* panel = window.findChild<QWidget*>(QStringLiteral("studyPanel")))
    QMetaObject::invokeMethod(panel, "openFile", Q_ARG(QString, file));
  if (auto* dock = window.findChild<QDockWidget*>(QStringLiteral("dockStudy"))) bringToFront(dock);
}

WorkplaceView::WorkplaceView(QWidget* parent) : QWidget(parent) {
  setObjectName("workplaceMap");
  setAccessibleName(tr("Worst RULA by height and distance"));
}

void WorkplaceView::setMap(const studies::WorkplaceMap* map) {
  map_ = map;
  chosen_ = map ? map->best : -1;
  update();
}

QRectF WorkplaceView::rectOf(std::size_t cell) const {
  constexpr double kLeft = 52.0, kBottom = 34.0;
  const double columns = static_cast<double>(map_->aways.size()), rows = static_cast<double>(map_->rises.size());
  const std::size_t each = map_->aways.size() * map_->rises.size();
  const std::size_t stances = std::max<std::size_t>(1, map_->cells.size() / each);
  const double wide = (width() - kLeft - 4.0) / static_cast<double>(stances);
  const std::size_t stance = cell / each, row = cell % each / map_->aways.size(), column = cell % map_->aways.size();
  const double w = (wide - 8.0) / columns, h = (height() - kBottom) / rows;
  return {kLeft + wide * static_cast<double>(stance) + w * static_cast<double>(column),
          h * (rows - 1.0 - static_cast<double>(row)), w, h};
}

void WorkplaceView::mousePressEvent(QMouseEvent* event) {
  if (!map_) return;
  for (std::size_t i = 0; i < map_->cells.size(); ++i) {
    if (!rectOf(i).contains(event->position())) continue;
    chosen_ = static_cast<int>(i);
    update();
    emit chose(chosen_);
  }
}

void WorkplaceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kKeyCap));
  if (!map_ || map_->cells.empty()) {
    painter.setPen(theme.text3);
    painter.drawText(rect(), Qt::AlignCenter, tr("No map yet"));
    return;
  }
  for (std::size_t i = 0; i < map_->cells.size(); ++i) {
    const auto& cell = map_->cells[i];
    const QRectF box = rectOf(i).adjusted(1, 1, -1, -1);
    if (cell.worst > 0) {
      paintBand(painter, box, ergonomics::bandOfRula(cell.worst), theme);
      painter.setPen(QColor(0x1A, 0x20, 0x27));
      if (box.width() > 12 && box.height() > 12) painter.drawText(box, Qt::AlignCenter, QString::number(cell.worst));
    } else {
      painter.setPen(theme.line);
      painter.drawRect(box);
      painter.drawLine(box.topLeft(), box.bottomRight());
    }
    if (static_cast<int>(i) == chosen_) {
      painter.setPen(QPen(theme.scene.force, 2.5));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(box);
    }
  }
  painter.setPen(theme.text2);
  for (const std::size_t row : {std::size_t{0}, map_->rises.size() - 1}) {
    const QRectF box = rectOf(row * map_->aways.size());
    painter.drawText(QRectF(0, box.top(), 48, box.height()), Qt::AlignRight | Qt::AlignVCenter,
                     lengthText(map_->rises[row], 0));
  }
  for (const std::size_t column : {std::size_t{0}, map_->aways.size() - 1}) {
    const QRectF box = rectOf(column);
    painter.drawText(QRectF(box.center().x() - 40, height() - 32, 80, 14), Qt::AlignCenter,
                     lengthText(map_->aways[column], 0));
  }
  painter.drawText(QRectF(52, height() - 16, width() - 52, 14), Qt::AlignCenter, tr("farther away"));
}

}  // namespace hapticell::app
