// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;

namespace sparkout {

class Document;

/// Makes the stocks of the stages add up to the part's.
class StockFit {
    Q_DECLARE_TR_FUNCTIONS(StockFit)

public:
    /// A description of the change; empty if the stocks add up.
    [[nodiscard]] static QString text(const Document& document);
    static void apply(Document& document); ///< as one step of the history
};

struct Field;
class ListModel;
class ValueSlider;

/// The sliders of one row of a table, a line for each number with one.
class RowSliders : public QWidget {
    Q_OBJECT

public:
    /// The sliders follow `before` in the tab order.
    RowSliders(ListModel& model, Document& document, QWidget& before, QWidget* parent = nullptr);

    void showRow(int row); ///< row of the model; −1: none
    void retranslate();
    [[nodiscard]] ValueSlider* slider(const QString& key) const; ///< null if there is none

private:
    struct Line {
        const Field* field;
        int column;
        QLabel* label;
        ValueSlider* slider;
        QLabel* value;
    };

    [[nodiscard]] std::vector<int> columns() const;
    void build();
    void addLine(int column);
    void showLine(const Line& line);
    void retranslate(const Line& line);

    ListModel& m_model;
    Document& m_document;
    QWidget& m_before;
    int m_row = -1;
    QLabel* m_title;
    QWidget* m_body = nullptr;
    QGridLayout* m_grid = nullptr;
    std::vector<Line> m_lines;
};

} // namespace sparkout
