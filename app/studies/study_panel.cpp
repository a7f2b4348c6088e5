// SPDX-License-Identifier: Apache-2.0
#include "app/studies/study_panel.h"

#include <QComboBox>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/studies/study_run_section.h"
#include "app/studies/section_form.h"
#include "app/studies/study_fields.h"
#include "app/studies/study_tree.h"
#include "app/style/library_text.h"
#include "app/style/value_field.h"

namespace hapticell::app {

using studies::StudyValue;

namespace {

constexpr const char* kMethods[] = {"grid", "list", "halton", "sobol", "search"};
constexpr const char* kSearches[] = {"nelder-mead", "sbplx", "cobyla", "bobyqa", "crs2", "isres", "direct", "esch"};

QPushButton* makeStudyButton(const char* name, const QString& text) {
  auto* button = new QPushButton(text);
  button->setObjectName(QString::fromLatin1(name));
  return button;
}

/// The number of variants of a grid; nothing where the document cannot say it.
std::optional<double> gridSize(const StudyDraft& draft) {
  double count = 1.0;
  for (std::size_t i = 0; i < draft.text().count("vary"); ++i) {
    const studies::StudyPlace place{"vary", i};
    const StudyValue values = draft.text().value(place, "values"), steps = draft.text().value(place, "steps");
    if (const auto* numbers = std::get_if<std::vector<double>>(&values)) {
      count *= static_cast<double>(numbers->size());
    } else if (const auto* words = std::get_if<std::vector<std::string>>(&values)) {
      count *= static_cast<double>(words->size());
    } else if (const auto* number = std::get_if<double>(&steps)) {
      count *= *number;
    } else {
      return std::nullopt;
    }
  }
  return count;
}

}  // namespace

StudyPanel::StudyPanel(Host& host, StudyDraft& draft, StudyRunner& runner, QWidget* parent)
    : QWidget(parent), host_(host), draft_(draft) {
  setObjectName("studyPanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addTop(*column);
  addContent(*column);
  addVariants(*column);
  QVBoxLayout* run = addSection(*column, tr("Run"));
  auto* section = new StudyRunSection(host_, draft_, runner);
  run->addWidget(section);
  connect(section, &StudyRunSection::saveWanted, this, &StudyPanel::save);
  column->addStretch(1);
  connect(&draft_, &StudyDraft::changed, this, &StudyPanel::refresh);
  connect(&draft_, &StudyDraft::refused, this, [this](const Error& error) {
    host_.messages().reportCause(Severity::kWarning, tr("The study was not changed"), error);
  });
  connect(&host_.documentModel(), &DocumentModel::changed, this, &StudyPanel::refresh);
  connect(&host_.documentModel(), &DocumentModel::opened, this, &StudyPanel::refresh);
  connect(&host_.selection(), &Selection::allChanged, this, &StudyPanel::refresh);
  refresh();
}

void StudyPanel::addTop(QVBoxLayout& column) {
  QVBoxLayout* top = addSection(column, {});
  QPushButton* begin = makeStudyButton("buttonNewStudy", tr("New"));
  QPushButton* open = makeStudyButton("buttonOpenStudy", tr("Open…"));
  save_ = makeStudyButton("buttonSaveStudy", tr("Save"));
  save_as_ = makeStudyButton("buttonSaveStudyAs", tr("Save as…"));
  begin->setToolTip(tr("Create a study of the open workcell"));
  top->addWidget(sideBySide({begin, open}));
  top->addWidget(sideBySide({save_, save_as_}));
  about_ = makeLive(2, TextRole::kText);
  about_->setObjectName("labelStudy");
  top->addWidget(about_);
  connect(begin, &QPushButton::clicked, this, &StudyPanel::begin);
  connect(open, &QPushButton::clicked, this, &StudyPanel::open);
  connect(save_, &QPushButton::clicked, this, &StudyPanel::save);
  connect(save_as_, &QPushButton::clicked, this, &StudyPanel::saveAs);
}

void StudyPanel::addContent(QVBoxLayout& column) {
  QVBoxLayout* content = addSection(column, tr("Content"));
  tree_ = new StudyTree(draft_);
  tree_->setFixedHeight(210);
  content->addWidget(tree_);
  add_ = makeStudyButton("buttonAddToStudy", tr("Add"));
  auto* menu = new QMenu(add_);
  menu->setObjectName("menuAddToStudy");
  fillMenu(*menu);
  add_->setMenu(menu);
  area_ = makeStudyButton("buttonFloorArea", tr("Floor area"));
  area_->setToolTip(tr("The selected part or robot may stand anywhere in a rectangle; drag its handles in the scene"));
  remove_ = makeStudyButton("buttonRemoveFromStudy", tr("Remove"));
  content->addWidget(sideBySide({add_, area_, remove_}));
  form_ = new SectionForm(host_, draft_);
  content->addWidget(form_);
  fault_ = makeLive(3, TextRole::kSecond);
  fault_->setObjectName("labelStudyFault");
  content->addWidget(fault_);
  connect(area_, &QPushButton::clicked, this, &StudyPanel::addArea);
  connect(remove_, &QPushButton::clicked, this, &StudyPanel::removeChosen);
  connect(tree_, &StudyTree::placeChosen, this, [this] {
    form_->show(tree_->chosen());
    refresh();
  });
  form_->show(std::nullopt);
}

void StudyPanel::fillMenu(QMenu& menu) {
  const auto add = [&](QMenu& into, const QString& text, const std::string& table, const std::string& what) {
    QAction* action = into.addAction(text);
    action->setObjectName(QString::fromStdString("add_" + table + (what.empty() ? "" : "_" + what)));
    connect(action, &QAction::triggered, this, [this, table, what] { addKind(table, what); });
  };
  QMenu* vary = menu.addMenu(tr("What varies"));
  for (const StudyKind& kind : varyKinds()) add(*vary, studyFieldLabel(kind.label), "vary", kind.name);
  QMenu* ask = menu.addMenu(tr("What is asked"));
  for (const StudyKind& kind : askKinds()) add(*ask, studyFieldLabel(kind.label), "ask", kind.name);
  add(menu, tr("Requirement"), "require", "");
  add(menu, tr("Objective"), "objective", "");
  menu.addSeparator();
  QAction* workplace = menu.addAction(tr("Workplace for four bodies"));
  workplace->setObjectName("add_workplace");
  connect(workplace, &QAction::triggered, this, &StudyPanel::addWorkplace);
}

void StudyPanel::addVariants(QVBoxLayout& column) {
  QVBoxLayout* variants = addSection(column, tr("Variants"));
  method_ = new QComboBox;
  method_->setObjectName("choiceMethod");
  method_->addItems({tr("Every combination"), tr("Lists in parallel"), tr("Halton samples"), tr("Sobol samples"),
                     tr("Search for the best")});
  addRow(*variants, tr("Method"), method_);
  const auto field = [&](const char* name, double most) {
    auto* made = new ValueField({{}, 0, 1.0, most, 1.0});
    made->setObjectName(QString::fromLatin1(name));
    return made;
  };
  samples_ = field("fieldSamples", 1e7);
  search_ = new QComboBox;
  search_->setObjectName("choiceSearch");
  for (const char* search : kSearches) search_->addItem(QString::fromLatin1(search));
  evaluations_ = field("fieldEvaluations", 1e6);
  starts_ = field("fieldStarts", 1e4);
  samples_row_ = addRow(*variants, tr("Samples"), samples_);
  search_row_ = addRow(*variants, tr("Search"), search_);
  evaluations_row_ = addRow(*variants, tr("At most"), evaluations_);
  starts_row_ = addRow(*variants, tr("Starts"), starts_);
  count_ = makeLive(1, TextRole::kSecond, true);
  count_->setObjectName("labelVariants");
  variants->addWidget(count_);
  connect(method_, &QComboBox::activated, this, [this](int index) { draft_.setMethod(kMethods[index]); });
  connect(search_, &QComboBox::activated, this, [this](int index) {
    draft_.set({"search", 0}, "method", std::string(kSearches[index]));
  });
  const auto follow = [this](ValueField* one, const char* table, const char* key) {
    connect(one, &ValueField::edited, this,
            [this, table, key](double value) { draft_.set({table, 0}, key, std::round(value)); });
  };
  follow(samples_, "sampling", "samples");
  follow(evaluations_, "search", "evaluations");
  follow(starts_, "search", "starts");
}

void StudyPanel::begin() {
  const workcell::Document& document = host_.documentModel().document();
  if (document.path().empty()) {
    host_.messages().tell(Severity::kInformation, tr("Save the workcell first"),
                          tr("A study names the file of its workcell, and this one has none yet."));
    about_->setText(tr("Save the workcell first: a study names its file."));
    return;
  }
  if (mayDrop()) draft_.begin(QString::fromStdString(document.path().string()));
}

void StudyPanel::open() {
  const QString start = QString::fromStdString(host_.documentModel().document().path().parent_path().string());
  const QString file = askToOpen(window(), tr("Open a study"), start, tr("Studies (*.hstudy)"));
  if (!file.isEmpty()) openFile(file);
}

void StudyPanel::openFile(const QString& file) {
  if (!mayDrop()) return;
  const auto opened = draft_.open(file);
  if (!opened) host_.messages().reportCause(Severity::kProblem, tr("The study could not be opened"), opened.error());
}

bool StudyPanel::save() {
  if (draft_.file().isEmpty()) {
    saveAs();
    return !draft_.isChanged() && !draft_.file().isEmpty();
  }
  const auto saved = draft_.save(draft_.file());
  if (!saved) host_.messages().reportCause(Severity::kProblem, tr("The study could not be saved"), saved.error());
  return saved.has_value();
}

void StudyPanel::saveAs() {
  const QFileInfo base(draft_.file().isEmpty() ? draft_.cell() : draft_.file());
  const QString start = base.absolutePath() + '/' + base.completeBaseName() + QStringLiteral(".hstudy");
  const QString file = askToSave(window(), tr("Save the study"), start, tr("Studies (*.hstudy)"));
  if (file.isEmpty()) return;
  const auto saved = draft_.save(file);
  if (!saved) host_.messages().reportCause(Severity::kProblem, tr("The study could not be saved"), saved.error());
}

bool StudyPanel::mayDrop() {
  if (!draft_.isChanged()) return true;
  QMessageBox question(QMessageBox::Question, tr("Study"), tr("Save the changes of \"%1\"?").arg(draft_.title()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window());
  question.setObjectName("questionStudy");
  const int answer = question.exec();
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

std::string StudyPanel::selectedEntity(bool carrier) const {
  const workcell::DocumentState& state = host_.documentModel().document().state();
  const workcell::Entity* entity = state.find(host_.selection().current());
  while (carrier && entity != nullptr && !entity->attachment.to.empty()) {
    const workcell::Entity* below = state.findByName(entity->attachment.to);
    if (below == nullptr) break;
    entity = below;
  }
  return entity != nullptr ? entity->name : std::string();
}

/// The selected one if it is of the right kind, else the only one of that kind.
std::string StudyPanel::entityFor(const std::string& what) const {
  const bool places = what == "position" || what == "rotation" || what == "size";
  if (places) return selectedEntity(what != "size");
  if (what == "motion" && selectedEntity(false).empty()) return {};
  const bool body = what == "body" || what == "stance" || what == "posture" || what == "sight";
  const auto fits = [&](const workcell::Entity& one) { return body ? one.figure() != nullptr : workcell::isMachine(one); };
  const workcell::DocumentState& state = host_.documentModel().document().state();
  const workcell::Entity* selected = state.find(host_.selection().current());
  if (selected != nullptr && fits(*selected)) return selected->name;
  std::string only;
  for (const auto& entity : state.entities) {
    if (!fits(*entity)) continue;
    if (!only.empty()) return {};
    only = entity->name;
  }
  return only;
}

/// The finder of commands runs what can be added even when the button Add is off.
bool StudyPanel::lacksStudy() {
  if (!draft_.isEmpty()) return false;
  host_.messages().tell(Severity::kInformation, tr("No study is open"),
                        tr("What is added becomes part of a study. Press New or Open in the dock Study, then add it "
                           "again."));
  about_->setText(tr("No study is open. Press New or Open first."));
  return true;
}

void StudyPanel::addKind(const std::string& table, const std::string& what) {
  if (lacksStudy()) return;
  std::vector<std::pair<std::string, StudyValue>> keys;
  const auto word = [](const std::string& text) { return text.empty() ? StudyValue() : StudyValue(text); };
  if (table == "require" || table == "objective") {
    const auto names = draft_.resultNames();
    keys.emplace_back("value", names.empty() ? std::string() : names.front());
    if (table == "require") keys.emplace_back("at_least", 1.0);
  } else {
    keys.emplace_back("what", what);
    const std::string name = draft_.freeName(table, what);
    if (name != what) keys.emplace_back("name", name);
    if (what != "motion" || table == "ask") keys.emplace_back("entity", word(entityFor(what)));
    if (what == "position" || what == "rotation" || what == "tool_offset") keys.emplace_back("axis", std::string("z"));
    const StudyKind* kind = studyKind(table, what);
    for (const StudyField& field : kind->fields) {
      if (field.edit != StudyEdit::kRange) continue;
      const double half = what == "rotation" || what == "joint" ? 45.0 : 0.2;
      keys.insert(keys.end(), {{"from", what == "size" ? 0.7 : -half}, {"to", what == "size" ? 1.1 : half},
                               {"steps", 5.0}});
    }
  }
  const std::size_t index = draft_.add(table, keys);
  tree_->choose({table, index});
}

void StudyPanel::addArea() {
  const std::string entity = selectedEntity(true);
  if (entity.empty()) return;
  const std::size_t before = draft_.text().count("vary");
  draft_.addFloorRange(entity);
  tree_->choose({"vary", before});
}

/// The selected parts move; the selected mannequin, or the only one, shows the work.
void StudyPanel::addWorkplace() {
  if (lacksStudy()) return;
  const workcell::DocumentState& state = host_.documentModel().document().state();
  const workcell::Entity* worker = state.findByName(entityFor("posture"));
  std::vector<std::string> station;
  for (const workcell::EntityId id : host_.selection().all()) {
    const workcell::Entity* entity = state.find(id);
    if (entity == nullptr) continue;
    if (entity->figure() != nullptr) {
      worker = entity;
    } else {
      station.push_back(entity->name);
    }
  }
  if (worker == nullptr || station.empty()) {
    host_.messages().tell(Severity::kInformation, tr("Select the parts that can move"),
                          tr("Select a bench, a shelf or a fixture; with several mannequins in the cell, also the one "
                             "that shows the work. Then add the workplace again."));
    return fault_->setText(tr("Select the parts that can move, and the mannequin if there are several."));
  }
  draft_.addWorkplace(*worker, station);
  tree_->choose({"ask", draft_.text().count("ask") - 1});
}

void StudyPanel::removeChosen() {
  if (const auto place = tree_->chosen()) draft_.remove(*place);
  form_->show(tree_->chosen());
}

void StudyPanel::refresh() {
  const bool any = !draft_.isEmpty();
  save_->setEnabled(any && (draft_.isChanged() || draft_.file().isEmpty()));
  save_as_->setEnabled(any);
  add_->setEnabled(any);
  area_->setEnabled(any && host_.selection().current() != 0);
  remove_->setEnabled(any && tree_->chosen().has_value());
  tree_->setEnabled(any);
  const QString cell = QFileInfo(draft_.cell()).fileName();
  const QString title = draft_.title() + (draft_.isChanged() ? QStringLiteral("*") : QString());
  about_->setText(any ? tr("%1, of %2").arg(title, cell) : tr("No study is open."));
  const auto fault = any ? draft_.fault() : std::nullopt;
  fault_->setText(fault ? tr("Not complete: %1").arg(shownText(*fault)) : QString());
  method_->setEnabled(any);
  const std::string method = draft_.method();
  for (int i = 0; i < 5; ++i)
    if (method == kMethods[i]) method_->setCurrentIndex(i);
  const bool sampled = method == "halton" || method == "sobol", searched = method == "search";
  samples_row_->setVisible(sampled);
  for (QWidget* row : {search_row_, evaluations_row_, starts_row_}) row->setVisible(searched);
  const auto number = [&](const char* table, const char* key, double otherwise) {
    const StudyValue value = draft_.text().value({table, 0}, key);
    const auto* now = std::get_if<double>(&value);
    return now != nullptr ? *now : otherwise;
  };
  samples_->setValue(number("sampling", "samples", 100.0));
  evaluations_->setValue(number("search", "evaluations", 200.0));
  starts_->setValue(number("search", "starts", 1.0));
  search_->setCurrentText(QString::fromStdString(draft_.text().word({"search", 0}, "method")));
  const auto grid = method == "grid" && any && draft_.text().count("vary") > 0 ? gridSize(draft_) : std::nullopt;
  count_->setText(grid ? tr("%n variant(s)", nullptr, static_cast<int>(std::min(*grid, 1e9))) : QString());
}

}  // namespace hapticell::app
