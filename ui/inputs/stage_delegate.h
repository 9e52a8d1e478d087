// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/list_delegate.h"

namespace sparkout {

/// Edits a cell of the stage table in place: numbers, and the spark-out of the last stage.
class StageDelegate : public ListDelegate {
    Q_OBJECT

public:
    using ListDelegate::ListDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
};

} // namespace sparkout
