// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/operation.h"
#include "ui/inputs/list_model.h"

#include <QWidget>

namespace sparkout {

class NumberField;
class StillComboBox;

/// Chooses what the last stage does: feed, spark out a number of times, or until size. An invalid
/// count matters only while it is used.
class SparkOutEditor : public QWidget {
    Q_OBJECT

public:
    SparkOutEditor(const Field& field, const Operation& operation, QWidget* parent);
    ~SparkOutEditor() override;

    void putInto(Stage& stage) const; ///< uses the last valid count
    void showStage(const Stage& stage);
    void revert(); ///< restores the initial value

    [[nodiscard]] bool refused() const; ///< false while typing
    [[nodiscard]] QString refusedText() const;
    [[nodiscard]] QString refusal() const;
    void showRefused(const QString& text);

signals:
    void edited();
    void left(); ///< the focus left, or Return ended the edit

protected:
    bool focusNextPrevChild(bool next) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void leave();
    [[nodiscard]] bool holds(const QWidget* widget) const;
    void showCount();
    [[nodiscard]] SparkOut::Mode mode() const;
    void setMode(SparkOut::Mode mode);

    StillComboBox* m_mode;
    NumberField* m_count;
    std::optional<SparkOut> m_before;
    bool m_left = false;
};

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
