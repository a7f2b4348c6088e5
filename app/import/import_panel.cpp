// SPDX-License-Identifier: Apache-2.0
#include "app/import/import_panel.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/import/import_choice_fields.h"
#include "app/import/import_progress.h"
#include "app/kit/form.h"
#include "app/style/library_text.h"
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
    ground.setColorAt(0.0, theme.scene.background_top);
    ground.setColorAt(1.0, theme.scene.background_bottom);
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

int sizeDecimals(double largest) {
  if (largest < 10.0) return 3;
  if (largest < 100.0) return 2;
  return largest < 1000.0 ? 1 : 0;
}

QString sizeLine(const FileImport& file) {
  const double factor =
      file.choices.metres_per_unit.value_or(file.facts->metres_per_unit) / file.facts->metres_per_unit;
  const dvec3 size = file.facts->size * factor;
  const Units units = unitsNow();
  if (file.unit_is_open) {
    const dvec3 in_units = file.facts->size / file.facts->metres_per_unit;
    const auto plain = [](double value) { return numberText(value, 3); };
    return QObject::tr("%1 × %2 × %3, unit unknown").arg(plain(in_units.x), plain(in_units.y), plain(in_units.z));
  }
  const int decimals = sizeDecimals(units.perMetre() * std::max({size.x, size.y, size.z}));
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
  choices_ = new ImportChoiceFields(session_);
  column->addWidget(choices_);
  connect(choices_, &ImportChoiceFields::unitAnswered, this, &ImportPanel::refresh);
  progress_ = new ImportProgress;
  column->addWidget(progress_);
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
  const auto& files = session_.files();
  if (!session_.find(current_)) current_ = files.empty() ? 0 : files.front().id;
  fillFiles();
  const FileImport* file = session_.find(current_);
  facts_->setVisible(file);
  choices_->setVisible(file && file->facts);
  if (file && file->facts) choices_->showFile(*file);
  if (file) showFile(*file);
  import_->setVisible(file);
  import_->setEnabled(file && file->stage != FileImport::Stage::kImporting && !file->unit_is_open);
  import_->setToolTip(file && file->unit_is_open ? tr("Choose the size first") : QString());
  import_all_->setVisible(files.size() > 1);
  undo_hint_->setVisible(files.size() == 1);
  import_all_->setText(tr("Import all %1").arg(files.size()));
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
  if (facts.incomplete) {
    preview_->setPicture(QImage(), tr("Enter the arguments that have no value"));
    size_->setText(QFileInfo(file.path).fileName());
    kind_->setText(QStringLiteral("%1, %2").arg(facts.format, sizeText(facts.bytes)));
  }
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
    stage = file->queued ? tr("Waiting for the previous file") : shownText(file->progress.stage);
  }
  QString words = capital(stage.isEmpty() ? tr("Reading") : stage);
  if (file != shown) words = QFileInfo(file->path).fileName() + QStringLiteral(": ") + words;
  // Of the whole: before it, the time left is a guess of twenty times what passed. Half: it leaps at the beginning;
  // twice: it comes later.
  constexpr double kKnown = 0.05;
  progress_->showWork(words, share, file && share > kKnown ? file->elapsed * (1.0 - share) / share : 0.0);
}

}  // namespace hapticell::app
