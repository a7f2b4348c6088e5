// SPDX-License-Identifier: Apache-2.0
#include "app/kit/file_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QGridLayout>
#include <QHeaderView>
#include <QIdentityProxyModel>
#include <QImageReader>
#include <QLabel>
#include <QLocale>
#include <QRegularExpression>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "app/kit/kept_picture.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr QSize kPreviewPicture(240, 150);
constexpr QSize kFileDialogSize(980, 560);

/// The picture of a cell as the first page has it; of a picture, itself.
QPixmap pictureOf(const QFileInfo& file) {
  if (file.suffix().compare(QStringLiteral("hcell"), Qt::CaseInsensitive) == 0)
    return QPixmap::fromImage(keptPicture(file.absoluteFilePath()));
  QImageReader reader(file.absoluteFilePath());
  const QSize whole = reader.size();
  if (!whole.isValid()) return {};
  reader.setScaledSize(whole.scaled(kPreviewPicture, Qt::KeepAspectRatio));
  return QPixmap::fromImage(reader.read());
}

/// What is known of the file that is looked at.
class FilePreview final : public QWidget {
 public:
  FilePreview() {
    setObjectName("filePreview");
    picture_ = new QLabel;
    picture_->setObjectName("filePreviewPicture");
    picture_->setFixedSize(kPreviewPicture);
    picture_->setAlignment(Qt::AlignCenter);
    picture_->setAutoFillBackground(true);
    picture_->setBackgroundRole(QPalette::Base);
    words_ = new QLabel;
    words_->setObjectName("filePreviewWords");
    words_->setWordWrap(true);
    words_->setFixedWidth(kPreviewPicture.width());
    words_->setFont(textFont(TextRole::kSecond));
    words_->setForegroundRole(kQuietText);
    words_->setTextFormat(Qt::PlainText);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 0, 0, 0);
    column->addWidget(picture_);
    column->addWidget(words_);
    column->addStretch(1);
    show({});
  }
  void show(const QString& path) {
    const QFileInfo file(path);
    const bool is_file = !path.isEmpty() && file.isFile();
    const QPixmap picture = is_file ? pictureOf(file) : QPixmap();
    if (picture.isNull())
      picture_->setPixmap(icon(is_file ? "cell" : "folder").pixmap(32, 32));
    else
      picture_->setPixmap(picture.scaled(kPreviewPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    if (!is_file) return words_->setText(QObject::tr("Choose a file to see what it is."));
    QStringList lines{file.fileName(), QLocale().formattedDataSize(file.size()),
                      QLocale().toString(file.lastModified(), QObject::tr("d MMM yyyy, HH:mm"))};
    if (picture.isNull() && file.suffix() == QStringLiteral("hcell"))
      lines << QObject::tr("The preview is made when the file is saved or closed here.");
    words_->setText(lines.join('\n'));
  }

 private:
  QLabel* picture_;
  QLabel* words_;
};

/// "Workcells (*.hcell)" has "hcell".
QString firstEnding(const QString& filter) {
  static const QRegularExpression ending(QStringLiteral("\\*\\.([\\w.]+)"));
  return ending.match(filter).captured(1);
}

/// Times in the window's language: Qt's are in the desktop's.
class FileTimes final : public QIdentityProxyModel {
 public:
  using QIdentityProxyModel::QIdentityProxyModel;
  QVariant data(const QModelIndex& index, int role) const override {
    const auto* files = qobject_cast<const QFileSystemModel*>(sourceModel());
    if (index.column() != kTimeColumn || role != Qt::DisplayRole || !files)
      return QIdentityProxyModel::data(index, role);
    return QLocale().toString(files->lastModified(mapToSource(index)), QLocale::ShortFormat);
  }
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    const QStringList names{QObject::tr("Name"), QObject::tr("File size"), QObject::tr("Type"), QObject::tr("Changed")};
    const bool named = role == Qt::DisplayRole && orientation == Qt::Horizontal && section < names.size();
    return named ? names[section] : QIdentityProxyModel::headerData(section, orientation, role);
  }
  static constexpr int kSizeColumn = 1, kKindColumn = 2, kTimeColumn = 3;
};

class FileQuestion final : public QFileDialog {
 public:
  FileQuestion(QWidget* parent, const QString& title, const QString& start, const QString& filter)
      : QFileDialog(parent, title) {
    setObjectName("fileDialog");
    setOption(DontUseNativeDialog);  // A native one has the desktop's theme, and no pictures of cells.
    resize(kFileDialogSize);
    setProxyModel(new FileTimes(this));
    setWords();
    if (auto* table = findChild<QTreeView*>("treeView")) {
      table->header()->setSectionResizeMode(0, QHeaderView::Stretch);
      table->header()->resizeSection(FileTimes::kSizeColumn, 80);
      table->header()->resizeSection(FileTimes::kTimeColumn, 130);
      table->hideColumn(FileTimes::kKindColumn);  // The name's ending says it.
    }
    if (!filter.isEmpty()) setNameFilters(filter.split(QStringLiteral(";;")));
    const QFileInfo from(start);
    if (!start.isEmpty() && from.isDir()) {
      setDirectory(start);
    } else {
      if (from.isAbsolute()) setDirectory(from.absolutePath());
      if (!start.isEmpty()) selectFile(from.fileName());
    }
  }
  /// Qt's own words are English where its translations are not installed.
  void setWords() {
    setLabelText(LookIn, QObject::tr("Folder"));
    setLabelText(FileName, QObject::tr("Name"));
    setLabelText(FileType, QObject::tr("Type"));
    setLabelText(Reject, QObject::tr("Cancel"));
    const std::pair<const char*, QString> tips[]{
        {"backButton", QObject::tr("Previous folder")},   {"forwardButton", QObject::tr("Next folder")},
        {"toParentButton", QObject::tr("Parent folder")}, {"newFolderButton", QObject::tr("New folder")},
        {"listModeButton", QObject::tr("Names only")},    {"detailModeButton", QObject::tr("Details")}};
    for (const auto& [name, tip] : tips)
      if (auto* button = findChild<QToolButton*>(QLatin1String(name))) {
        button->setToolTip(tip);
        button->setAccessibleName(tip);
      }
  }
  void addPreview() {
    auto* grid = qobject_cast<QGridLayout*>(layout());
    if (!grid) return;
    auto* preview = new FilePreview;
    grid->addWidget(preview, 1, grid->columnCount());  // Beside the list of files.
    connect(this, &QFileDialog::currentChanged, preview, &FilePreview::show);
  }
  QStringList ask() { return exec() == Accepted ? selectedFiles() : QStringList(); }
};

QStringList openedBy(QFileDialog::FileMode mode, QWidget* parent, const QString& title, const QString& start,
                     const QString& filter) {
  FileQuestion dialog(parent, title, start, filter);
  dialog.setFileMode(mode);
  dialog.setLabelText(QFileDialog::Accept, QObject::tr("Open"));
  dialog.addPreview();
  return dialog.ask();
}

}  // namespace

QString askToOpen(QWidget* parent, const QString& title, const QString& start, const QString& filter) {
  return openedBy(QFileDialog::ExistingFile, parent, title, start, filter).value(0);
}

QStringList askToOpenSeveral(QWidget* parent, const QString& title, const QString& start, const QString& filter) {
  return openedBy(QFileDialog::ExistingFiles, parent, title, start, filter);
}

QString askToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter) {
  FileQuestion dialog(parent, title, {}, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setLabelText(QFileDialog::Accept, QObject::tr("Save"));
  const QFileInfo from(start);
  if (from.isAbsolute()) dialog.setDirectory(from.absolutePath());
  for (const QString& one : dialog.nameFilters())
    if (!from.suffix().isEmpty() && one.contains("*." + from.suffix())) {
      dialog.selectNameFilter(one);
      break;
    }
  dialog.setDefaultSuffix(firstEnding(dialog.selectedNameFilter()));
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                   [&dialog](const QString& chosen) { dialog.setDefaultSuffix(firstEnding(chosen)); });
  if (!start.isEmpty()) dialog.selectFile(from.fileName());
  if (filter.contains(QStringLiteral("*.hcell"))) dialog.addPreview();
  return dialog.ask().value(0);
}

QString askForFolder(QWidget* parent, const QString& title, const QString& start) {
  FileQuestion dialog(parent, title, start, {});
  dialog.setFileMode(QFileDialog::Directory);
  dialog.setOption(QFileDialog::ShowDirsOnly);
  dialog.setLabelText(QFileDialog::Accept, QObject::tr("Choose"));
  return dialog.ask().value(0);
}

}  // namespace hapticell::app
