// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <QImage>
#include <optional>
#include <vector>

#include "workcell/entity/entity.h"
#include "workcell/robots/robot_library.h"

namespace hapticell::app {

/// The built-in robots as a list: data sheets at once, models and pictures as they become ready. GUI thread.
class LibraryModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role {
    kSecondLineRole = Qt::UserRole,  ///< "KUKA · 6-axis · 16 kg".
    kPictureRole,                    ///< QImage; null until it is drawn.
    kMakerRole,
    kSearchRole,  ///< All text that a search looks at.
  };
  explicit LibraryModel(std::vector<workcell::LibraryRobot> robots, QObject* parent = nullptr);

  const workcell::LibraryRobot& robot(int row) const { return rows_[static_cast<std::size_t>(row)].robot; }
  /// Null until setEntity().
  const workcell::Entity* entity(int row) const;
  void setEntity(int row, workcell::Entity entity, double reach);
  void setPicture(int row, const QImage& picture);
  bool hasPicture(int row) const { return !rows_[static_cast<std::size_t>(row)].picture.isNull(); }
  /// Label and value of each line of the data sheet.
  std::vector<std::pair<QString, QString>> sheet(int row) const;
  QStringList makers() const;
  int rowOf(const std::string& name) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  struct Row {
    workcell::LibraryRobot robot;
    std::optional<workcell::Entity> entity;
    double reach = 0.0;
    QImage picture;
  };
  std::vector<Row> rows_;
};

}  // namespace hapticell::app
