// SPDX-License-Identifier: Apache-2.0
#include "app/robot/library_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "app/controls/ghost_placer.h"
#include "app/controls/place_fields.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/robot/robot_facts.h"
#include "app/style/icon.h"
#include "app/viewport/widget/viewport_widget.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

constexpr QSize kThumb{72, 60};
constexpr QSize kBig{308, 190};
constexpr int kRow = 66;
constexpr int kListHeight = 5 * kRow;
constexpr int kSheetLines = 10;  // Five facts and a source of many words.
// ms between two small pictures, as kPartDrawPause of part_panel.cpp.
constexpr int kDrawMilliseconds = 30;

class LibraryDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {200, kRow}; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Theme& theme = themeOf(option.palette);
    const QRect row = option.rect;
    painter->save();
    if (option.state.testFlag(QStyle::State_Selected)) {
      painter->fillRect(row, theme.selected_row);
      painter->fillRect(QRect(row.left(), row.top(), 2, row.height()), theme.selection);
    } else if (option.state.testFlag(QStyle::State_MouseOver)) {
      painter->fillRect(row, theme.header);
    }
    const QRect thumb(QPoint(row.left() + 8, row.top() + 3), kThumb);
    const QImage picture = index.data(LibraryModel::kPictureRole).value<QImage>();
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    if (picture.isNull())
      icon("robot", theme.text3).paint(painter, thumb.adjusted(20, 14, -20, -14));
    else
      painter->drawImage(thumb, picture);
    const QRect words = row.adjusted(kThumb.width() + 18, 0, -8, 0);
    const auto write = [&](TextRole role, const QColor& color, int top, const QString& text) {
      painter->setFont(textFont(role));
      painter->setPen(color);
      painter->drawText(QRect(words.left(), row.top() + top, words.width(), 18), Qt::AlignVCenter,
                        painter->fontMetrics().elidedText(text, Qt::ElideRight, words.width()));
    };
    write(TextRole::kSection, theme.text1, 14, index.data().toString());
    write(TextRole::kSecond, theme.text2, 34, index.data(LibraryModel::kSecondLineRole).toString());
    painter->restore();
  }
};

}  // namespace

void LibraryFilter::set(const QString& search, const QString& maker) {
  search_ = search;
  maker_ = maker;
  invalidateFilter();
}

bool LibraryFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QModelIndex index = sourceModel()->index(row, 0, parent);
  if (!maker_.isEmpty() && index.data(LibraryModel::kMakerRole).toString() != maker_) return false;
  return matchesSearch(index.data(LibraryModel::kSearchRole).toString().toStdString(), search_.toStdString());
}

LibraryPanel::LibraryPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  Diagnostics diagnostics;
  model_ = new LibraryModel(workcell::listLibraryRobots(diagnostics), this);
  for (const Text& warning : diagnostics.warnings)
    host_.messages().reportCause(Severity::kWarning, tr("A library robot was not loaded"), warning);
  filter_.setSourceModel(model_);
  pool_.setMaxThreadCount(1);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  auto* scrolled = new QWidget;
  auto* column = new QVBoxLayout(scrolled);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  QVBoxLayout* choice = addSection(*column, {});
  search_ = new QLineEdit;
  search_->setObjectName("searchLibrary");
  search_->setProperty("search", true);
  search_->setPlaceholderText(tr("Name, manufacturer, type or payload"));
  search_->setClearButtonEnabled(true);
  search_->addAction(icon("search"), QLineEdit::LeadingPosition);
  search_->setAccessibleName(tr("Search the library"));
  maker_ = new QComboBox;
  maker_->setObjectName("comboMaker");
  maker_->setAccessibleName(tr("Manufacturer"));
  maker_->addItem(tr("All manufacturers"), QString());
  for (const QString& maker : model_->makers()) maker_->addItem(maker, maker);
  choice->addWidget(search_);
  choice->addWidget(maker_);
  list_ = new QListView;
  list_->setObjectName("listLibrary");
  list_->setAccessibleName(tr("Robot library"));
  list_->setModel(&filter_);
  list_->setItemDelegate(new LibraryDelegate(list_));
  list_->setUniformItemSizes(true);
  list_->setMouseTracking(true);
  list_->setFixedHeight(kListHeight);
  list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // Its width must not depend on how many are found.
  choice->addWidget(list_);
  column->addWidget(makeSheet());
  column->addStretch(1);
  whole->addWidget(scrolledPanel(scrolled), 1);
  whole->addWidget(makePlace());  // Never scrolled away: it holds the button that adds.
  const auto search = [this] { filter_.set(search_->text(), maker_->currentData().toString()); };
  connect(search_, &QLineEdit::textChanged, this, search);
  connect(maker_, &QComboBox::activated, this, search);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, &LibraryPanel::showChosen);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    if (ghost_->isOn()) showGhost();
  });
  connect(list_, &QListView::pressed, this, &LibraryPanel::showGhost);
  connect(list_, &QListView::doubleClicked, this, &LibraryPanel::add);
  connect(model_, &LibraryModel::dataChanged, this, &LibraryPanel::showChosen);
  connect(&draw_, &QTimer::timeout, this, &LibraryPanel::drawNext);
  showChosen();
}

LibraryPanel::~LibraryPanel() {
  pool_.clear();
  pool_.waitForDone();
}

QWidget* LibraryPanel::makeSheet() {
  auto* holder = new QWidget;
  auto* rows = new QVBoxLayout(holder);
  rows->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* inside = addSection(*rows, {});
  big_picture_ = new QLabel;
  big_picture_->setFixedHeight(kBig.height());
  big_picture_->setAlignment(Qt::AlignCenter);
  name_ = makeLabel({}, TextRole::kPanelState);
  name_->setObjectName("labelLibraryRobot");
  sheet_ = makeLabel({}, TextRole::kSecond, true);
  sheet_->setWordWrap(true);
  sheet_->setTextFormat(Qt::RichText);
  sheet_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  sheet_->setMinimumHeight(kSheetLines * sheet_->fontMetrics().lineSpacing());
  inside->addWidget(big_picture_);
  inside->addWidget(name_);
  inside->addWidget(sheet_);
  return holder;
}

QWidget* LibraryPanel::makePlace() {
  auto* holder = new QWidget;
  auto* rows = new QVBoxLayout(holder);
  rows->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* inside = addSection(*rows, tr("Base placement"));
  place_ = new PlaceFields(host_, QStringLiteral("placeLibrary"), tr("Click where to place the base"));
  inside->addWidget(place_);
  ghost_ = new GhostPlacer(
      host_, *place_, [this] { addThere(); }, this);
  add_ = new QPushButton(tr("Add"));
  add_->setObjectName("buttonAddFromLibrary");
  add_->setProperty("main", true);
  auto* file = new QPushButton(tr("From a file…"));
  file->setObjectName("buttonRobotFile");
  file->setToolTip(tr("URDF, xacro, SDF or robot.toml"));
  inside->addSpacing(4);
  inside->addWidget(sideBySide({file, add_}));
  connect(file, &QPushButton::clicked, this, &LibraryPanel::fileWanted);
  connect(add_, &QPushButton::clicked, this, &LibraryPanel::add);
  return holder;
}

void LibraryPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!list_->currentIndex().isValid() && filter_.rowCount() > 0) list_->setCurrentIndex(filter_.index(0, 0));
  draw_.start(kDrawMilliseconds);
}

void LibraryPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  ghost_->end();
}

void LibraryPanel::choose(const std::string& name) {
  const QModelIndex index = filter_.mapFromSource(model_->index(model_->rowOf(name)));
  if (index.isValid()) list_->setCurrentIndex(index);
}

int LibraryPanel::chosenRow() const {
  const QModelIndex index = list_->currentIndex();
  return index.isValid() ? filter_.mapToSource(index).row() : -1;
}

void LibraryPanel::showChosen() {
  const int row = chosenRow();
  add_->setEnabled(row >= 0);
  if (row < 0) {
    name_->setText(tr("No matching robot"));
    sheet_->setText({});
    big_picture_->setPixmap({});
    return;
  }
  name_->setText(model_->data(model_->index(row), Qt::DisplayRole).toString());
  QString table = QStringLiteral("<table cellspacing=\"0\">");
  for (const auto& [label, value] : model_->sheet(row))
    table += QStringLiteral("<tr><td style=\"padding-right:12px\">%1</td><td>%2</td></tr>")
                 .arg(label, value.toHtmlEscaped());
  sheet_->setText(table + QStringLiteral("</table>"));
  const QImage picture = model_->data(model_->index(row), LibraryModel::kPictureRole).value<QImage>();
  if (picture.isNull())
    big_picture_->setPixmap(icon("robot", themeOf(palette()).text3).pixmap(48, 48));
  else
    big_picture_->setPixmap(QPixmap::fromImage(picture));
}

void LibraryPanel::load(int row) {
  if (!asked_.insert(row).second) return;
  const std::string what = "library:" + model_->robot(row).name;
  pool_.start([this, row, what] {
    Diagnostics diagnostics;
    workcell::EntityLoader loader({});
    auto entity = loader.load(what, 0.0, diagnostics);
    if (!entity) return;
    entity->setJoints(kinematics::restPositions(*entity->robot()));
    const double reach = flangeReach(*entity->robot());
    QMetaObject::invokeMethod(
        this, [this, row, entity = std::move(*entity), reach] { model_->setEntity(row, entity, reach); },
        Qt::QueuedConnection);
  });
}

/// One picture a call: the chosen robot's first, then those in view.
void LibraryPanel::drawNext() {
  if (!isVisible()) return draw_.stop();
  std::vector<int> wanted;
  if (chosenRow() >= 0) wanted.push_back(chosenRow());
  const QRect seen = list_->viewport()->rect();
  for (int i = 0; i < filter_.rowCount(); ++i)
    if (list_->visualRect(filter_.index(i, 0)).intersects(seen))
      wanted.push_back(filter_.mapToSource(filter_.index(i, 0)).row());
  for (const int row : wanted) {
    if (model_->hasPicture(row)) continue;
    const workcell::Entity* entity = model_->entity(row);
    if (!entity) {
      load(row);
      continue;
    }
    const QImage picture = picture_.draw({*entity}, kBig, themeOf(palette()));
    if (picture.isNull()) return draw_.stop();
    return model_->setPicture(row, picture);
  }
}

/// At rest, standing at the origin; nothing, and a message, where its file cannot be read.
std::optional<workcell::Entity> LibraryPanel::chosenRobot() {
  const int row = chosenRow();
  if (row < 0) return std::nullopt;
  if (const workcell::Entity* known = model_->entity(row)) return *known;
  Diagnostics diagnostics;
  auto loaded = workcell::EntityLoader({}).load("library:" + model_->robot(row).name, 0.0, diagnostics);
  if (!loaded) {
    host_.messages().reportCause(Severity::kProblem, tr("The robot was not added"), loaded.error());
    return std::nullopt;
  }
  loaded->setJoints(kinematics::restPositions(*loaded->robot()));
  return std::move(*loaded);
}

void LibraryPanel::showGhost() {
  const std::optional<workcell::Entity> robot = chosenRobot();
  if (!robot) return ghost_->end();
  const bool begins = !ghost_->isOn();
  ghost_->begin(*robot);
  if (begins) list_->setFocus();  // The pick took it; letters and arrows go on in the list.
}

void LibraryPanel::add() {
  ghost_->end();
  const std::size_t before = host_.documentModel().document().state().entities.size();
  addThere();
  if (host_.documentModel().document().state().entities.size() > before)
    host_.viewport().fit(host_.viewport().scene().bounds_W());
}

void LibraryPanel::addThere() {
  std::optional<workcell::Entity> entity = chosenRobot();
  if (!entity) return;
  DocumentModel& document = host_.documentModel();
  entity->name = document.document().uniqueName(model_->robot(chosenRow()).sheet.name);
  entity->X_WE = place_->X_W();
  const std::string name = entity->name;
  if (!document.execute(workcell::AddEntity{std::move(*entity)})) return;
  if (const workcell::Entity* made = document.document().findByName(name)) host_.selection().set(made->id);
  emit added();
}

}  // namespace hapticell::app
