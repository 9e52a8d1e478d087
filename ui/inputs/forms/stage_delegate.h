// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/forms/list_delegate.h"

namespace sparkout {

/// Edits cells of the stage table in place: numbers, and the spark-out of the last stage. Under
/// stock and time it paints the stage's share as a bar.
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
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] static int rowHeight(const QFontMetrics& font); ///< for a number above its share

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] static bool needsTwoLines(const QStyleOptionViewItem& item);
    static void paintWithForm(QPainter& painter, QStyleOptionViewItem item, const QString& form);
    static void paintInTwoLines(QPainter& painter, QStyleOptionViewItem item);
};

} // namespace sparkout
