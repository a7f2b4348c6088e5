// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/host/background_work.h"
#include "workcell/document/command.h"

class QLabel;
class QPushButton;

namespace hapticell::app {

class Host;
class Segmented;
class ValueField;

/// Care for the mesh of the selected solid: its defects, fewer triangles, faces turned outwards, and its collision
/// shape. Each change is one undo step, made in the background; the deviation is shown.
class MeshCarePanel : public QWidget {
  Q_OBJECT
 public:
  MeshCarePanel(Host& host, BackgroundWork& background, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void look();
  void simplify();
  void turnOutwards();
  void chooseProxy(int kind);
  const workcell::Entity* solid() const;
  void start(const QString& name, BackgroundWork::Work work);
  void replace(workcell::EntityId id, const workcell::SourceFile& source, geometry::TriangleMesh mesh,
               const QString& told);

  Host& host_;
  BackgroundWork& background_;
  QLabel *name_, *counts_, *proxy_text_;
  ValueField* tolerance_;
  QPushButton *simplify_, *turn_;
  Segmented* proxy_;
  const void* looked_at_ = nullptr;  // The mesh whose counts are shown.
};

}  // namespace hapticell::app
