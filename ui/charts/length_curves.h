// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/legend_drawing.h"
#include "ui/plot/read_curves.h"
#include "ui/tables/csv_table.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace sparkout {

struct Part;

/// Curves over the length of the part that share an axis rect with others: shown or not as a whole,
/// and one by one through the legend. Diameters are drawn from the middle of the tolerance field.
class LengthCurves {
public:
    explicit LengthCurves(QCPAxisRect& rect) : m_rect(rect) {}
    virtual ~LengthCurves() = default;

    void setShown(bool shown);
    void toggle(int key);
    void only(int key);

    [[nodiscard]] virtual LegendEntries legendEntries() const = 0;
    [[nodiscard]] virtual CsvTable table() const = 0;
    /// Values at a place, in words; empty where there are none.
    [[nodiscard]] virtual QString valuesAt(double x_mm) const = 0;
    virtual void restyle(bool dim) = 0;
    [[nodiscard]] virtual Digits digits() const { return Digits::signedHundredths; }
    [[nodiscard]] ReadCurves readCurves() const; ///< the shown ones that run along the part
    /// Of what is drawn, with room; the limits too unless they are far away. Null: nothing.
    [[nodiscard]] QCPRange values() const;
    [[nodiscard]] static QString axisLabel();

protected:
    /// A graph under a key of the legend.
    QCPGraph* addGraph(int key);
    [[nodiscard]] LegendEntry entry(int key, QColor colour, Qt::PenStyle pen,
                                    const QString& text) const;
    /// The limits of the tolerance field over the length, ± half of it.
    void drawLimits(const Part& part);
    void clearLimits();
    void restyleLimits(bool dim);
    [[nodiscard]] LegendEntry limitsEntry() const;
    [[nodiscard]] const QPalette& palette() const { return m_rect.parentPlot()->palette(); }

private:
    static constexpr int limitsKey = 900;

    void applyChoice();

    struct Keyed {
        QCPGraph* graph;
        int key;
    };
    QCPAxisRect& m_rect;
    std::vector<Keyed> m_graphs;
    QCPGraph* m_limits[2] = {};
    double m_limit_um = 0;
    CurveChoice m_choice;
    bool m_shown = false;
    bool m_dim = false;
};

} // namespace sparkout
