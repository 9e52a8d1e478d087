// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/dialogs/copy_table.h"
#include "ui/results/margin_model.h"
#include "ui/text/formula_text.h"
#include "ui/views/requirements/constraints_plot.h"
#include "ui/views/requirements/constraints_view.h"

#include <QRegularExpression>
#include <QTest>
#include <QTextEdit>

/// The view "Constraints" on runs whose feed is limited.
namespace constraints_bench {

using namespace sparkout;
using fixtures::plungeProject;
using fixtures::run;
using fixtures::traverseProject;

inline Project limitedProject() {
    Project p = traverseProject();
    p.material->burn_rise_k = 700;
    p.machine->wheel_drive_kw = 4;
    p.part->tolerance.roughness_ra_um = 0.8;
    p.wheel->roughness_factor = 1.5; // calibrated
    return p;
}

/// All that is evaluated.
inline Project fullyLimitedProject() {
    Project p = limitedProject();
    p.machine->work_drive_kw = 1;
    p.wheel->grain_surface_energy_j_m2 = 1800;
    p.wheel->grain_modulus_gpa = 390;
    p.wheel->bond_surface_energy_j_m2 = 400;
    p.wheel->bond_modulus_gpa = 65;
    p.part->tolerance = {4, 6, 5, 8, 0.8, {}};
    return p;
}

inline Project unlimited(Project p) {
    p.material->burn_rise_k.reset();
    p.machine->wheel_drive_kw.reset();
    p.machine->work_drive_kw.reset();
    return p;
}

/// A formula's text without spaces, line breaks and what marks indices, which are typeset.
inline QString bare(QString text) {
    static const QRegularExpression set(QStringLiteral("[\\s_\u00a0]"));
    return text.remove(set);
}

/// A view as it stands in the window, with a run drawn.
struct Shown {
    explicit Shown(const OutcomePtr& outcome) {
        view.resize(760, 620);
        view.show();
        show(outcome);
    }
    void show(const OutcomePtr& outcome) {
        fixtures::draw(view, outcome);
        QTest::qWait(20);
    }
    [[nodiscard]] ConstraintsPlot& plot() const { return *view.plot(); }
    /// The points drawn first under a key of the legend; none if it is not drawn.
    [[nodiscard]] std::vector<XY> points(int key) const {
        const ChartSeries* const of = plot().chart().find(key);
        return of ? of->points : std::vector<XY>();
    }
    [[nodiscard]] std::vector<XY> actual() const { return points(LimitChart::actualKey); }
    /// The cuts above their limit.
    [[nodiscard]] std::vector<XY> exceeded() const { return plot().chart().series.at(1).points; }
    template <typename T>
    [[nodiscard]] T& part(const char* name) const {
        return *view.findChild<T*>(QLatin1String(name));
    }
    [[nodiscard]] QString sheet() const { return part<QTextEdit>("formulaSheet").toPlainText(); }
    [[nodiscard]] int rowOf(ConstraintKind kind) const {
        for (int row = 0; row < view.margins()->rowCount(); ++row) {
            if (view.margins()->at(row).kind == kind) {
                return row;
            }
        }
        return -1;
    }
    void click(int row) const {
        auto& table = part<CopyTable>("margins");
        const QModelIndex index = view.margins()->index(row, 0);
        table.scrollTo(index);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(index).center());
    }
    ConstraintsView view;
};

} // namespace constraints_bench
