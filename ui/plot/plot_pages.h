// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_tools.h"

#include <QObject>

#include <functional>
#include <vector>

class QLayout;
class QComboBox;
class QCustomPlot;
class QStackedWidget;

namespace sparkout {

class LegendStrip;

/// The plots of a view of which one is in sight, chosen in a box of contents or by the view: each
/// with its tools, their two buttons, and its legend in the strip that they share.
class PlotPages : public QObject {
    Q_OBJECT
public:
    struct Page {
        QCustomPlot* plot = nullptr;
        PlotTools* tools = nullptr;
        QWidget* buttons = nullptr;
        std::function<LegendEntries()> legend;
        std::function<void(int)> toggle, showOnly; ///< by the key of the legend
    };

    enum class Chosen { inBox, byView };

    /// @param heading over an exported picture
    PlotPages(QWidget& view, LegendStrip& legend, std::function<QStringList()> heading,
              Settings* settings, Chosen chosen = Chosen::inBox);

    /// The next page; the view names it in the box. The subject says what is special to the plot.
    template <typename Plot>
    void add(Plot& plot, PlotSubject subject = {}) {
        subject.legend = [&plot] { return plot.legendEntries(); };
        subject.table = [&plot] { return plot.table(); };
        subject.restyle = [&plot] { plot.restyle(); };
        subject.navigation.fit = [&plot] { plot.fit(); };
        Page page;
        page.plot = &plot;
        page.legend = subject.legend;
        page.toggle = [&plot](int key) { plot.toggleCurve(key); };
        page.showOnly = [&plot](int key) { plot.showOnly(key); };
        connect(&plot, &Plot::contentChanged, this, &PlotPages::showLegend);
        finish(std::move(page), std::move(subject));
    }

    [[nodiscard]] QComboBox* content() const { return m_content; } ///< null: the view chooses
    [[nodiscard]] QStackedWidget* stack() const { return m_stack; }
    [[nodiscard]] const std::vector<Page>& all() const { return m_pages; }
    [[nodiscard]] const Page& page() const; ///< in sight

    void addButtons(QLayout& row) const; ///< of all pages; show() leaves those of one
    void show();                         ///< what the box says, with its buttons and its legend
    void show(std::size_t index);
    void showLegend();

private:
    void finish(Page page, PlotSubject subject);

    QWidget& m_view;
    LegendStrip& m_legend;
    std::function<QStringList()> m_heading;
    Settings* m_settings;
    QComboBox* m_content = nullptr;
    QStackedWidget* m_stack;
    std::vector<Page> m_pages;
    std::size_t m_shown = 0;
};

} // namespace sparkout
