// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/legend.h"
#include "ui/chart/painted_layer.h"
#include "ui/views/part/longitudinal_plot.h"
#include "ui/views/part/profile_cell.h"
#include "ui/views/part/profiles_plot.h"
#include "ui/views/part/profiles_view.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <clocale>
#include <cmath>

/// The view "Zone profiles" on cycles, and a hand on its plots.
namespace sparkout::profiles_bench {

using fixtures::hover;
using fixtures::plungeProject;
using fixtures::refused;
using fixtures::traverseProject;

inline OutcomePtr run(const Project& project, bool recorded = true) {
    auto outcome = std::make_shared<Outcome>();
    outcome->issues = validate(project);
    if (outcome->ran()) {
        outcome->result = simulate(project, recorded ? &outcome->trajectory : nullptr);
    }
    return outcome;
}

inline void show(ProfilesView& view, const OutcomePtr& outcome) {
    if (!view.isVisible()) {
        view.resize(700, 620);
        view.show();
    }
    fixtures::draw(view, outcome);
}

struct ShownProfiles : ProfilesView {
    explicit ShownProfiles(const OutcomePtr& outcome) { profiles_bench::show(*this, outcome); }
};

inline void settle() {
    QTest::qWait(30);
}

template <typename T>
T* part(const ProfilesView& view, const char* name) {
    return view.findChild<T*>(QLatin1String(name));
}

inline void wheel(QWidget* widget, const QPointF& at, int delta) {
    fixtures::wheel(widget, at, delta);
    settle();
}

inline void drag(QWidget* widget, const QPoint& from, const QPoint& by) {
    QTest::mousePress(widget, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, QPointF(from + by), widget->mapToGlobal(QPointF(from + by)),
                     Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(widget, &move);
    QTest::mouseRelease(widget, Qt::LeftButton, {}, from + by);
    settle();
}

/// Where a radius of the drawing stands on the screen.
inline QPointF pixelOf(const ProfilesPlot* plot, int cell, double drawn, double angle) {
    const QCPAxisRect* rect = plot->cell(cell);
    return {rect->axis(QCPAxis::atBottom)->coordToPixel(drawn * std::cos(angle)),
            rect->axis(QCPAxis::atLeft)->coordToPixel(drawn * std::sin(angle))};
}

inline double pixelsPerUnit(const QCPAxis* axis) {
    return std::abs(axis->coordToPixel(1) - axis->coordToPixel(0));
}

inline bool sameScaleEverywhere(const ProfilesPlot* plot, int cells) {
    const double scale = pixelsPerUnit(plot->cell(0)->axis(QCPAxis::atBottom));
    for (int i = 0; i < cells; ++i) {
        for (const auto type : {QCPAxis::atBottom, QCPAxis::atLeft}) {
            if (std::abs(pixelsPerUnit(plot->cell(i)->axis(type)) / scale - 1) > 1e-9) {
                return false;
            }
        }
    }
    return true;
}

inline int legendIndex(const ProfilesView& view, const QString& text) {
    const auto& entries = view.legend()->entries();
    const auto found = std::ranges::find(entries, text, &LegendEntry::text);
    return found == entries.end() ? -1 : static_cast<int>(found - entries.begin());
}

inline void clickLegend(const ProfilesView& view, const QString& text) {
    const int index = legendIndex(view, text);
    QVERIFY(index >= 0);
    QTest::mouseClick(view.legend(), Qt::LeftButton, {}, view.legend()->entryRect(index).center());
    settle();
}

/// Three cycles: of a shaft by traverse grinding, of four sections, and of twenty.
struct Cycles {
    Cycles() {
        std::setlocale(LC_NUMERIC, "C");
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        traverse = run(traverseProject());
        plunge = run(plungeProject(4));
        many = run(plungeProject(20));
    }
    [[nodiscard]] bool ran() const { return traverse->ran() && plunge->ran() && many->ran(); }
    OutcomePtr traverse, plunge, many;
};

} // namespace sparkout::profiles_bench
