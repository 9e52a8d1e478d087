// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"

#include <QCoreApplication>

#include <vector>

namespace sparkout {

struct Part;

/// Curves over the length of the part that share an axis rect with others: shown or hidden as a
/// whole, and one by one through the legend. Diameters are drawn relative to the middle of the
/// tolerance.
class LengthCurves {
    Q_DECLARE_TR_FUNCTIONS(LengthCurves)
public:
    /// Uses a rect of the plot.
    LengthCurves(ViewPlot& plot, QCPAxisRect& rect) : m_plot(plot), m_rect(rect) {}
    virtual ~LengthCurves() = default;

    void setShown(bool shown);
    void toggle(int key);
    void only(int key);

    [[nodiscard]] virtual LegendEntries legendEntries() const = 0;
    [[nodiscard]] virtual CsvTable table() const = 0;
    /// The values at a place as text; empty if there are none.
    [[nodiscard]] virtual QString valuesAt(double x_mm) const = 0;
    virtual void restyle() = 0;
    [[nodiscard]] virtual Digits digits() const { return Digits::signedHundredths; }
    /// The visible curves along the part.
    [[nodiscard]] virtual ReadCurves readCurves() const;
    /// The range of the curves, with a margin, and of the limits unless they are far away. Null
    /// without data.
    [[nodiscard]] virtual QCPRange values() const;
    [[nodiscard]] virtual QString axisLabel() const;  ///< label of the value axis …
    [[nodiscard]] virtual QString placeLabel() const; ///< … and of the horizontal axis

protected:
    /// Adds a graph with a key of the legend.
    QCPGraph* addGraph(int key);
    [[nodiscard]] LegendEntry entry(int key, QColor colour, Qt::PenStyle pen,
                                    const QString& text) const;
    void takeField(const Part& part);
    [[nodiscard]] double middle_um() const { return m_middle_um; } ///< middle of the tolerance
    /// Draws the limits of the tolerance along the length, ± half its width.
    void drawLimits(const Part& part);
    void clearLimits();
    void restyleLimits();
    [[nodiscard]] LegendEntry limitsEntry() const;
    [[nodiscard]] bool shows(int key) const { return m_shown && m_choice.shows(key); }
    [[nodiscard]] bool chosen(int key) const { return m_choice.shows(key); } ///< in the legend
    virtual void applyChoice();
    [[nodiscard]] const ViewPlot& plot() const { return m_plot; }

private:
    static constexpr int limitsKey = 900;

    struct Keyed {
        QCPGraph* graph;
        int key;
    };
    ViewPlot& m_plot;
    QCPAxisRect& m_rect;
    std::vector<Keyed> m_graphs;
    QCPGraph* m_limits[2] = {};
    double m_limit_um = 0, m_middle_um = 0; ///< half the tolerance, and its middle
    CurveChoice m_choice;
    bool m_shown = false;
};

} // namespace sparkout
