// SPDX-License-Identifier: Apache-2.0
#include "app/import/import_panel.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "app/import/argument_fields.h"
#include "app/import/unit_question.h"
#include "app/kit/form.h"
#include "app/style/segmented.h"
#include "app/style/theme.h"
#include "app/style/units.h"

namespace hapticell::app {

/// The picture of a file on the scene's own ground.
class PreviewBox : public QWidget {
 public:
  PreviewBox() {
    setObjectName("importPreview");
    setFixedHeight(150);
  }
  void setPicture(const QImage& picture, const QString& otherwise) {
    picture_ = picture;
    otherwise_ = otherwise;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& theme = themeOf(palette());
    QPainter painter(this);
    QLinearGradient ground(0, 0, 0, height());
    ground.setColorAt(0.0, theme.background_top);
    ground.setColorAt(1.0, theme.background_bottom);
    painter.fillRect(rect(), ground);
    if (picture_.isNull()) {
      painter.setPen(theme.text2);
      painter.setFont(textFont(TextRole::kSecond));
      painter.drawText(rect(), Qt::AlignCenter, otherwise_);
      return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QSize fitted = picture_.size().scaled(size(), Qt::KeepAspectRatio);
    painter.drawImage(QRect(QPoint((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted),
                      picture_);
  }

 private:
  QImage picture_;
  QString otherwise_;
};

namespace {

constexpr std::array<double, 5> kUnits{0.001, 0.01, 1.0, 0.0254, 0.3048};

/// A deviation of a mesh: a decimal more than the user's.
QString fineLengthText(double metres) {
  const Units units = unitsNow();
  return numberText(units.perMetre() * metres, units.length_decimals + 1) + QLatin1Char(' ') + units.lengthUnit();
}

QString sizeLine(const FileImport& file) {
  const double factor =
      file.choices.metres_per_unit.value_or(file.facts->metres_per_unit) / file.facts->metres_per_unit;
  const dvec3 size = file.facts->size * factor;
  const Units units = unitsNow();
  if (file.unit_is_open) {
    const dvec3 in_units = file.facts->size / file.facts->metres_per_unit;
    const auto plain = [](double value) { return numberText(value, 3); };
    return QObject::tr("%1 × %2 × %3, unit not known").arg(plain(in_units.x), plain(in_units.y), plain(in_units.z));
  }
  const double largest = units.perMetre() * std::max({size.x, size.y, size.z});
  const int decimals = largest < 10.0 ? 3 : largest < 100.0 ? 2 : largest < 1000.0 ? 1 : 0;
  const auto number = [&](double metres) { return numberText(units.perMetre() * metres, decimals); };
  return QStringLiteral("%1 × %2 × %3 %4").arg(number(size.x), number(size.y), number(size.z), units.lengthUnit());
}

QString capital(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

ImportPanel::ImportPanel(ImportSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  setMinimumWidth(330);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addFacts();
  addChoices();
  addProgress();
  column->addStretch(1);
  addButtons();
  connect(&session_, &ImportSession::changed, this, &ImportPanel::refresh);
  connect(&session_, &ImportSession::progressed, this, &ImportPanel::showProgress);
  refresh();
}

void ImportPanel::addFacts() {
  facts_ = new QWidget;
  auto* column = new QVBoxLayout(facts_);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(8);
  file_ = new QComboBox;
  file_->setObjectName("importFile");
  file_->setAccessibleName(tr("File"));
  column->addWidget(file_);
  preview_ = new PreviewBox;
  column->addWidget(preview_);
  size_ = makeLabel({}, TextRole::kSection);
  size_->setObjectName("importSize");
  kind_ = makeLabel({}, TextRole::kSecond, true);
  kind_->setObjectName("importKind");
  auto* lines = new QVBoxLayout;
  lines->setSpacing(2);
  lines->addWidget(size_);
  lines->addWidget(kind_);
  column->addLayout(lines);
  layout()->addWidget(facts_);
  connect(file_, &QComboBox::activated, this, [this](int row) {
    current_ = file_->itemData(row).toInt();
    refresh();
  });
}

void ImportPanel::addChoices() {
  choices_ = new QWidget;
  auto* column = new QVBoxLayout(choices_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  arguments_ = new ArgumentFields;
  column->addWidget(arguments_);
  mesh_choices_ = new QWidget;
  column->addWidget(mesh_choices_);
  auto* mesh_column = new QVBoxLayout(mesh_choices_);
  mesh_column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* section = addSection(*mesh_column, {});
  unit_asked_ = makeLabel({}, TextRole::kText);
  unit_asked_->setObjectName("importUnitAsked");
  unit_asked_->setWordWrap(true);
  section->addWidget(unit_asked_);
  unit_question_ = new UnitQuestion;
  section->addWidget(unit_question_);
  unit_ = new QComboBox;
  unit_->setPlaceholderText(tr("Not known yet"));
  unit_->setObjectName("importUnit");
  addRow(*section, tr("Unit"), unit_);
  up_ = new Segmented({tr("X"), tr("Y"), tr("Z")});
  up_->setObjectName("importUp");
  addRow(*section, tr("Up axis"), up_);
  quality_ = new Segmented({tr("Coarse"), tr("Medium"), tr("Fine")});
  quality_->setObjectName("importQuality");
  addRow(*section, tr("Mesh"), quality_);
  estimate_ = makeLive(2, TextRole::kSecond, true);
  estimate_->setObjectName("importEstimate");
  addRow(*section, {}, estimate_);
  tree_ = new Segmented({tr("One solid"), tr("Tree")});
  tree_->setObjectName("importTree");
  addRow(*section, tr("Bring in as"), tree_);
  layout()->addWidget(choices_);
  connect(arguments_, &ArgumentFields::changed, this, [this](const std::map<std::string, std::string>& values) {
    chooseCurrent([&values](ImportChoices& choices) { choices.arguments = values; });
  });
  connect(unit_, &QComboBox::activated, this, [this](int row) {
    chooseCurrent([&](ImportChoices& choices) {
      const QVariant metres = unit_->itemData(row);
      choices.metres_per_unit = metres.isNull() ? std::nullopt : std::optional(metres.toDouble());
    });
  });
  connect(unit_question_, &UnitQuestion::chosen, this, [this](double metres) {
    chooseCurrent([metres](ImportChoices& choices) { choices.metres_per_unit = metres; });
    refresh();  // A card that was chosen already stays so.
  });
  connect(up_, &Segmented::chosen, this, [this](int axis) {
    chooseCurrent([axis](ImportChoices& choices) { choices.up_axis = static_cast<workcell::UpAxis>(axis); });
  });
  connect(quality_, &Segmented::chosen, this, [this](int quality) {
    chooseCurrent([quality](ImportChoices& choices) { choices.quality = static_cast<MeshQuality>(quality); });
  });
  connect(tree_, &Segmented::chosen, this,
          [this](int row) { chooseCurrent([row](ImportChoices& choices) { choices.merge = row == 0; }); });
}

void ImportPanel::addProgress() {
  progress_ = new QWidget;
  auto* column = new QVBoxLayout(progress_);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  auto* line = new QHBoxLayout;
  stage_ = makeLabel({}, TextRole::kText);
  stage_->setObjectName("importStage");
  share_ = makeLabel({}, TextRole::kText, true);
  share_->setObjectName("importShare");
  line->addWidget(stage_, 1);
  line->addWidget(share_);
  column->addLayout(line);
  bar_ = new QProgressBar;
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(6);
  column->addWidget(bar_);
  note_ = makeLabel(tr("The cell stays usable meanwhile."), TextRole::kSecond, true);
  note_->setWordWrap(true);
  column->addWidget(note_);
  layout()->addWidget(progress_);
}

void ImportPanel::addButtons() {
  auto* line = new QHBoxLayout;
  line->setContentsMargins(12, 8, 12, 10);
  line->setSpacing(8);
  undo_hint_ = makeLabel(tr("One undo step"), TextRole::kSecond, true);
  line->addWidget(undo_hint_);
  line->addStretch(1);
  const auto make = [line](const char* name, const QString& text) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    line->addWidget(button);
    return button;
  };
  cancel_ = make("importCancel", tr("Cancel"));
  import_all_ = make("importAll", tr("Import all"));
  import_ = make("importAccept", tr("Import"));
  import_->setProperty("main", true);
  static_cast<QVBoxLayout*>(layout())->addLayout(line);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (current_ != 0) {
      session_.cancel(current_);
    } else {
      emit otherCancelled();
    }
  });
  connect(import_, &QPushButton::clicked, this, [this] { session_.import(current_); });
  connect(import_all_, &QPushButton::clicked, this, [this] {
    std::vector<int> ids;
    for (const FileImport& file : session_.files()) ids.push_back(file.id);
    for (const int id : ids) session_.import(id);
  });
}

void ImportPanel::chooseCurrent(const std::function<void(ImportChoices&)>& change) {
  const FileImport* file = session_.find(current_);
  if (!file || filling_) return;
  ImportChoices choices = file->choices;
  change(choices);
  session_.choose(current_, choices);
}

QString ImportPanel::title() const {
  if (const FileImport* file = session_.find(current_)) return tr("Import — %1").arg(QFileInfo(file->path).fileName());
  return other_ ? tr("Open — %1").arg(other_->name) : tr("Import");
}

void ImportPanel::setOtherWork(const std::optional<OtherWork>& work) {
  other_ = work;
  if (current_ == 0) refresh();
}

void ImportPanel::fillFiles() {
  file_->clear();
  const auto& files = session_.files();
  for (std::size_t k = 0; k < files.size(); ++k) {
    file_->addItem(tr("%1 of %2:  %3").arg(k + 1).arg(files.size()).arg(QFileInfo(files[k].path).fileName()),
                   files[k].id);
  }
  file_->setCurrentIndex(file_->findData(current_));
  file_->setVisible(files.size() > 1);
}

void ImportPanel::refresh() {
  filling_ = true;
  const auto& files = session_.files();
  if (!session_.find(current_)) current_ = files.empty() ? 0 : files.front().id;
  fillFiles();
  const FileImport* file = session_.find(current_);
  facts_->setVisible(file);
  choices_->setVisible(file && file->facts);
  if (file) showFile(*file);
  import_->setVisible(file);
  import_->setEnabled(file && file->stage != FileImport::Stage::kImporting && !file->unit_is_open);
  import_->setToolTip(file && file->unit_is_open ? tr("Choose the size first") : QString());
  import_all_->setVisible(files.size() > 1);
  undo_hint_->setVisible(files.size() == 1);
  import_all_->setText(tr("Import all %1").arg(files.size()));
  filling_ = false;
  showProgress();
  emit titleChanged(title());
}

void ImportPanel::showFile(const FileImport& file) {
  const bool known = file.facts.has_value();
  preview_->setPicture(known ? file.facts->picture : QImage(), tr("The file is being read"));
  size_->setText(known ? sizeLine(file) : QFileInfo(file.path).fileName());
  if (!known) return kind_->setText(sizeText(QFileInfo(file.path).size()));
  const ImportFacts& facts = *file.facts;
  kind_->setText(QStringLiteral("%1, %2, %3 %4")
                     .arg(facts.format, sizeText(facts.bytes), countText(static_cast<double>(facts.parts)),
                          facts.parts == 1 ? tr("part") : tr("parts")));
  arguments_->setArguments(file.id, facts.arguments, file.choices.arguments);
  mesh_choices_->setVisible(!facts.robot);
  choices_->setEnabled(file.stage != FileImport::Stage::kImporting);
  if (facts.incomplete) {
    preview_->setPicture(QImage(), tr("Enter the arguments that have no value"));
    size_->setText(QFileInfo(file.path).fileName());
    kind_->setText(QStringLiteral("%1, %2").arg(facts.format, sizeText(facts.bytes)));
  }
  if (facts.robot) return;
  showUnits(file);
  up_->setCurrent(static_cast<int>(file.choices.up_axis.value_or(facts.up_axis)));
  quality_->setCurrent(facts.can_be_cut_finer ? static_cast<int>(file.choices.quality) : -1);
  for (int k = 0; k < 3; ++k) quality_->setChoiceEnabled(k, facts.can_be_cut_finer, tr("The file holds triangles."));
  const ImportEstimate estimate = ImportSession::estimateOf(file);
  const bool same = file.choices.quality == file.examined_with.quality;
  const QString triangles = tr("%1%2 triangles").arg(same ? QString() : tr("about "), countText(estimate.triangles));
  estimate_->setText(
      facts.can_be_cut_finer
          ? QStringLiteral("%1, %2, %3").arg(fineLengthText(estimate.chord), triangles, durationText(estimate.seconds))
          : triangles);
  tree_->setCurrent(file.choices.merge ? 0 : 1);
  const bool several = facts.parts > 1 || file.examined_with.merge;
  tree_->button(1)->setText(several && !file.examined_with.merge
                                ? tr("Tree of %1").arg(countText(static_cast<double>(facts.parts)))
                                : tr("Tree"));
  for (int k = 0; k < 2; ++k) tree_->setChoiceEnabled(k, several, tr("The file holds one part."));
  choices_->setEnabled(file.stage != FileImport::Stage::kImporting);
}

void ImportPanel::showUnits(const FileImport& file) {
  const ImportFacts& facts = *file.facts;
  unit_->clear();
  const bool stated = facts.unit_is_stated;
  if (stated) unit_->addItem(tr("%1, as the file says").arg(capital(unitText(facts.metres_per_unit))));
  for (const double metres : kUnits) {
    QString text = capital(unitText(metres));
    if (!stated && !facts.unit_is_open && metres == facts.likely_metres_per_unit) text += tr(", guessed from the size");
    unit_->addItem(text, metres);
  }
  unit_asked_->setVisible(!stated);
  unit_asked_->setText(file.unit_is_open ? tr("The file names no unit. Which size is right?")
                                         : tr("The file names no unit. Is this size right?"));
  unit_question_->setVisible(!stated);
  if (file.unit_is_open) {
    unit_->setCurrentIndex(-1);
    return unit_question_->setFile(facts, std::nullopt);
  }
  const double now = file.choices.metres_per_unit.value_or(facts.metres_per_unit);
  unit_question_->setFile(facts, now);
  if (stated && !file.choices.metres_per_unit) return unit_->setCurrentIndex(0);
  for (int row = 0; row < unit_->count(); ++row)
    if (!unit_->itemData(row).isNull() && std::abs(unit_->itemData(row).toDouble() / now - 1.0) < 1e-9)
      unit_->setCurrentIndex(row);
}

void ImportPanel::showProgress() {
  const FileImport* file = session_.find(current_);
  const FileImport* const shown = file;
  if (file && file->stage == FileImport::Stage::kReady)  // Another one may be on its way behind it.
    for (const FileImport& other : session_.files())
      if (other.stage != FileImport::Stage::kReady && !other.queued) file = &other;
  const bool working = file ? file->stage != FileImport::Stage::kReady : other_.has_value();
  progress_->setVisible(working);
  if (!working) return;
  double share = other_ ? other_->share : 0.0;
  QString stage = other_ ? other_->stage : QString();
  if (file) {
    share = file->progress.share;
    stage = file->queued ? tr("Waits for the file before it") : QString::fromStdString(file->progress.stage);
  }
  QString words = capital(stage.isEmpty() ? tr("Reading") : stage);
  if (file != shown) words = QFileInfo(file->path).fileName() + QStringLiteral(": ") + words;
  stage_->setText(stage_->fontMetrics().elidedText(words, Qt::ElideRight, width() - 130));
  stage_->setToolTip(words);
  QString text = QStringLiteral("%1 %").arg(std::lround(100.0 * share));
  constexpr double kKnown = 0.05, kWorthSaying = 2.0;  // Of the whole; seconds.
  const double left = file && share > kKnown ? file->elapsed * (1.0 - share) / share : 0.0;
  if (left > kWorthSaying) text += tr(" · %1 left").arg(durationText(left));
  share_->setText(text);
  bar_->setValue(static_cast<int>(std::lround(1000.0 * share)));
}

}  // namespace hapticell::app
