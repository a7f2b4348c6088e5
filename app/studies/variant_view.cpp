// SPDX-License-Identifier: Apache-2.0
#include "app/studies/variant_view.h"

#include <QMouseEvent>
#include <algorithm>
#include <filesystem>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/thread_pool_task.h"
#include "app/studies/result_table.h"
#include "app/studies/study_runner.h"
#include "app/style/library_text.h"
#include "app/viewport/widget/floor_point.h"
#include "app/viewport/widget/viewport_widget.h"
#include "studies/variants/cell_change.h"

namespace hapticell::app {

namespace fs = std::filesystem;
using studies::Study;

namespace {

constexpr const char* kResultsOwner = "study results";

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code fault;
  return !a.empty() && !b.empty() && (a == b || fs::equivalent(a, b, fault));
}

/// Where the document of results was, or a file of the same name beside the results: they may come from elsewhere.
fs::path documentOf(const studies::ResultHead& head, const fs::path& results) {
  std::error_code fault;
  const fs::path there(head.file), here = results.parent_path() / there.filename();
  const auto named = studies::StudyDocument::parse(head.study, there);
  if (named && fs::exists(named->cell, fault)) return there;
  return here;
}

Expected<std::shared_ptr<const Study>> loadedFor(const studies::ResultHead& head, const fs::path& results) {
  auto study = Study::load(head.study, documentOf(head, results), head.version);
  HAPTICELL_TRY(study);
  HAPTICELL_TRY(studies::checkSameStudy(head, (*study)->head(), results));
  return std::shared_ptr<const Study>(std::move(*study));
}

}  // namespace

VariantView::VariantView(Host& host, ResultTable& table, QObject* parent) : QObject(parent), host_(host), table_(table) {
  connect(&table_, &ResultTable::modelReset, this, &VariantView::showMap);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] {
    if (!busy_) endShowing();
  });
  connect(&host_.documentModel(), &DocumentModel::closing, this, &VariantView::endShowing);
  connect(&host_.documentModel(), &DocumentModel::opened, this, [this] {
    showMap();
    emit changed();
  });
  host_.viewport().installEventFilter(this);
}

VariantView::~VariantView() = default;

void VariantView::setStudy(std::shared_ptr<const Study> study) {
  endShowing();
  ++generation_;
  study_ = std::move(study);
  failed_ = preparing_ = wanted_ = false;
  showMap();
  emit changed();
}

void VariantView::setMapShown(bool on) {
  map_shown_ = on;
  showMap();
}

void VariantView::setDockShown(bool on) {
  dock_shown_ = on;
  showMap();
}

void VariantView::setMapColumn(int column) {
  column_ = column;
  showMap();
}

/// The file of the study's cell; empty: not known.
fs::path VariantView::cellFile() const {
  if (table_.head().file.empty()) return {};
  if (study_) return study_->document().cell;
  const fs::path document = documentOf(table_.head(), table_.file().toStdString());
  const auto named = studies::StudyDocument::parse(table_.head().study, document);
  return named ? named->cell : fs::path();
}

bool VariantView::isOpen() const {
  const DocumentModel& model = host_.documentModel();
  const fs::path cell = cellFile();
  return sameFile(model.document().path(), cell) || sameFile(model.origin(), cell);
}

QString VariantView::otherCell() const {
  return table_.isEmpty() || isOpen() ? QString() : QString::fromStdString(cellFile().string());
}

QString VariantView::obstacle() const {
  if (table_.isEmpty()) return tr("No results yet.");
  if (failed_) return shownText(study_fault_);
  if (!isOpen())
    return tr("The study is about %1, not about the open workcell.")
        .arg(QString::fromStdString(fs::path(otherCell().toStdString()).filename().string()));
  return {};
}

void VariantView::showMap() {
  map_ = {};
  if (map_shown_ && dock_shown_ && isOpen()) {
    const auto& state = study_ ? study_->cell().state() : host_.documentModel().document().state();
    const int column = column_ >= 0 ? column_ : static_cast<int>(ResultTable::kObjective);
    map_ = mapOf(table_, state, column);
  }
  host_.viewport().scene().setExtras(kResultsOwner, map_.items());
  host_.viewport().refresh();
}

void VariantView::prepare() {
  if (preparing_ || study_ || failed_) return;
  preparing_ = true;
  emit changed();
  runInThreadPool(
      this,
      [head = table_.head(), file = fs::path(table_.file().toStdString())] { return loadedFor(head, file); },
      [this, generation = generation_](Expected<std::shared_ptr<const Study>> study) {
        if (generation != generation_) return;
        preparing_ = false;
        if (study) {
          study_ = std::move(*study);
          showMap();
          if (wanted_) show();
        } else {
          failed_ = true;
          study_fault_ = study.error();
        }
        emit changed();
      });
}

void VariantView::show() {
  wanted_ = table_.chosen().has_value();
  if (!wanted_ || !isOpen() || failed_) return hide();
  if (!study_) return prepare();
  const auto& row = table_.rows()[*table_.chosen()];
  const auto variant = study_->cellOf(row.values);
  if (!variant) {
    host_.messages().reportCause(Severity::kWarning, tr("This variant cannot be shown"), variant.error());
    return hide();
  }
  showEntities(*variant);
  showing_ = true;
  emit changed();
}

/// The document's entities, with those that the variant changes as they are there.
void VariantView::showEntities(const workcell::Document& variant) {
  const workcell::Document& document = host_.documentModel().document();
  std::vector<workcell::Entity> entities = document.snapshotEntities();
  std::vector<GhostPose> places;
  for (const workcell::Entity* wanted : studies::changedEntities(study_->cell(), variant)) {
    const auto own = std::find_if(entities.begin(), entities.end(),
                                  [&](const workcell::Entity& one) { return one.name == wanted->name; });
    if (own == entities.end()) continue;
    const workcell::Entity now = *own;
    *own = *wanted;
    own->id = now.id;
    own->color = now.color;
    own->visible = now.visible;
    places.push_back({own->id, own->X_WE, own->joints(), false});
  }
  SceneModel& scene = host_.viewport().scene();
  scene.setEntities(std::move(entities));
  // A module that runs shows its own places otherwise.
  if (host_.snapshot()) scene.setPlayed(std::move(places));
  host_.viewport().refresh();
}

void VariantView::hide() {
  wanted_ = false;
  endShowing();
}

void VariantView::endShowing() {
  if (!showing_) return;
  showing_ = false;
  SceneModel& scene = host_.viewport().scene();
  scene.setEntities(host_.documentModel().document().snapshotEntities());
  if (host_.snapshot()) scene.setPlayed({});
  host_.viewport().refresh();
  emit changed();
}

bool VariantView::take() {
  if (!table_.chosen() || !study_ || !isOpen()) return false;
  const studies::ResultRow row = table_.rows()[*table_.chosen()];
  DocumentModel& model = host_.documentModel();
  const auto variant = study_->cellOf(row.values);
  const auto commands = variant ? studies::commandsFor(study_->cell(), *variant, model.document().state())
                                : Expected<std::vector<workcell::Command>>(tl::unexpected<Error>(variant.error()));
  if (!commands) {
    host_.messages().reportCause(Severity::kProblem, tr("This variant cannot be used"), commands.error());
    return false;
  }
  if (commands->empty()) {
    hide();
    host_.messages().tell(Severity::kInformation, tr("The cell already stands in variant %1").arg(row.number));
    return true;
  }
  busy_ = true;
  const bool done = model.executeAll(tr("Use variant %1").arg(row.number), *commands);
  busy_ = false;
  hide();
  if (done) check(row, model.document());
  return done;
}

/// A second evaluation from the values of the row: what is in the document now is what was measured.
void VariantView::check(const studies::ResultRow& row, const workcell::Document& taken) {
  const auto wanted = study_->cellOf(row.values);
  bool same = wanted.has_value();
  for (const auto& entity : study_->cell().state().entities) {
    const workcell::Entity* now = taken.findByName(entity->name);
    const workcell::Entity* measured = same ? wanted->findByName(entity->name) : nullptr;
    constexpr double kSame = 1e-6;  // m. Half and twice: far below what is measured.
    same = now != nullptr && measured != nullptr && glm::length(now->X_WE.p - measured->X_WE.p) < kSame;
    if (!same) break;
  }
  if (!same)
    host_.messages().tell(Severity::kWarning, tr("The cell differs from the one that was studied"),
                          tr("Variant %1 is in use, but other things stand elsewhere than in the study, so its results "
                             "may not hold. Undo, or run the study again for the cell as it is now.")
                              .arg(row.number));
  if (!same || row.answers.empty() || table_.head().version != studyVersion()) return;
  runInThreadPool(
      this, [study = study_, row] { return study->evaluate(row.number, row.values) == row; },
      [this, number = row.number](bool equal) {
        if (equal) return;
        host_.messages().tell(Severity::kProblem, tr("Variant %1 does not have the results of its row").arg(number),
                              tr("A new evaluation differs from the results file. Undo, and run the study again: the "
                                 "row was changed, or made by another kind of processor."));
      });
}

bool VariantView::eventFilter(QObject* watched, QEvent* event) {
  const auto* mouse = dynamic_cast<const QMouseEvent*>(event);
  if (mouse == nullptr || map_.isEmpty()) return QObject::eventFilter(watched, event);
  if (event->type() == QEvent::MouseButtonPress) pressed_ = mouse->position();
  ViewportWidget& viewport = host_.viewport();
  if (!endsClick(*mouse, pressed_) || viewport.isPicking() || isOverViewControls(viewport, mouse->position()))
    return QObject::eventFilter(watched, event);
  // Only what lies free: a part before the map is selected as ever.
  const auto p_W = floorPoint(viewport, mouse->position());
  if (p_W && !viewport.featureAt(mouse->position(), {.faces = true, .edges = false, .vertices = false})) {
    if (const MapCell* cell = map_.at(*p_W)) emit cellClicked(cell->number);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace hapticell::app
