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

/// One chart of the overview: its title, its legend, a button to enlarge it to the page, and,
/// without data, a text on its content with a button for the next step.
class OverviewTile : public QFrame {
    Q_OBJECT
public:
    OverviewTile(const QString& name, QWidget* parent); ///< `name` begins its parts' names, too

    [[nodiscard]] BarPlot* plot() const { return m_plot; }
    void addExport(); ///< adds the export button; requires the tools of the plot
    void setTitle(const QString& title);
    void setChart(BarChart chart); ///< no replot
    /// Shows a text in place of the chart; a step without text has no button.
    void setEmpty(const QString& text, const QString& step = {});
    void setAlone(bool isAlone); ///< whether it fills the page
    void retranslate();
    void fitHeight(); ///< sets the height for the chart and the current font

    [[nodiscard]] bool isEmpty() const;
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString emptyText() const;

signals:
    void enlargeAsked();
    void stepAsked(); ///< the button of the empty tile was clicked

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
