// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/bars/bar_chart.h"

#include <QFrame>
#include <QString>

class QLabel;
class QPushButton;
class QToolButton;

namespace sparkout {

class BarPlot;
class LegendStrip;

/// One chart of the overview: its title, its legend, a button that gives it the whole page, and
/// where there is nothing to draw what will be there and the step to it.
class OverviewTile : public QFrame {
    Q_OBJECT
public:
    OverviewTile(const QString& name, QWidget* parent); ///< of its parts, too

    [[nodiscard]] BarPlot* plot() const { return m_plot; }
    void addExport(); ///< the button, once the plot has its tools
    void setTitle(const QString& title);
    void setChart(BarChart chart); ///< no replot
    /// In place of the chart; a step without a text has no button.
    void setEmpty(const QString& text, const QString& step = {});
    void setAlone(bool isAlone); ///< it has the page to itself
    void retranslate();
    void fitHeight(); ///< to the chart, in the type of the moment

    [[nodiscard]] bool isEmpty() const;
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString emptyText() const;

signals:
    void enlargeAsked();
    void stepAsked(); ///< the button of what is empty

private:
    void showLegend();
    void nameStep();
    void showParts();

    QLabel* m_title;
    QToolButton* m_enlarge;
    LegendStrip* m_legend;
    BarPlot* m_plot;
    QLabel* m_remark;
    QLabel* m_empty;
    QPushButton* m_step;
    bool m_isAlone = false;
};

} // namespace sparkout
