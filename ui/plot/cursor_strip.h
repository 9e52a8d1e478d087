// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include <array>

class QLabel;

namespace sparkout {

class CopyTable;
class CursorModel;
class NumberField;
class PlotCursors;
class ReasonLabel;

/// The strip below a plot with cursors: fields for their places, and the values of the curves
/// there.
class CursorStrip : public QWidget {
    Q_OBJECT
public:
    explicit CursorStrip(PlotCursors& cursors, QWidget* parent = nullptr);

    [[nodiscard]] NumberField* field(std::size_t cursor) const { return m_fields.at(cursor); }
    [[nodiscard]] CursorModel* model() const { return m_model; }
    void retranslate();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void follow(); ///< updates later, in the event loop
    void fill();
    void showReason();
    void showDifference();

    PlotCursors& m_cursors;
    QLabel* m_axis;
    QLabel* m_difference; ///< difference of the places
    std::array<QLabel*, 2> m_letters{};
    std::array<NumberField*, 2> m_fields{};
    ReasonLabel* m_reason;
    CursorModel* m_model;
    CopyTable* m_table;
    QTimer m_later;
};

} // namespace sparkout
