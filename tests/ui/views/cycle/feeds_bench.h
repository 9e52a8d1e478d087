// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/quantity_colour.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/feeds_view.h"

#include <QObject>
#include <QTest>

#include <clocale>

/// The view "Feeds by stage" on a traverse and a plunge.
namespace sparkout::feeds_bench {

using namespace fixtures;

inline void show(FeedsView& view, const OutcomePtr& outcome) {
    view.resize(700, 620);
    view.show();
    draw(view, outcome);
}

struct ShownFeeds : FeedsView {
    explicit ShownFeeds(const OutcomePtr& outcome) { feeds_bench::show(*this, outcome); }
};

inline QCPRange xRange(const FeedsView& view, int column, int row) {
    return view.plot()->cell(column, row)->axis(QCPAxis::atBottom)->range();
}

/// A curve of a column as a value; null if there is none.
inline const ChartSeries* curve(const FeedsPlot& plot, int column, Quantity quantity) {
    for (int row = 0; row < FeedsPlot::rowCount; ++row) {
        for (const ChartSeries& series : plot.chart(plot.at(column, row)).series) {
            if (series.name == quantityName(quantity)) {
                return &series;
            }
        }
    }
    return nullptr;
}

inline bool isShown(const FeedsPlot& plot, Quantity quantity) {
    return plot.shows(FeedsChart::keyOf(quantity));
}

/// A test of the view on a traverse and on a plunge of twenty sections.
class FeedsTest : public QObject {
protected:
    void begin() {
        setlocale(LC_NUMERIC, "C");
        QLocale::setDefault(QLocale::c());
        m_traverse = run(traverseProject());
        m_plunge = run(plungeProject(20));
        QVERIFY(m_traverse->ran() && m_traverse->result.status == RunStatus::completed);
        QVERIFY(m_plunge->ran() && !m_plunge->trajectory.passes.empty());
    }

    OutcomePtr m_traverse, m_plunge;
};

} // namespace sparkout::feeds_bench
