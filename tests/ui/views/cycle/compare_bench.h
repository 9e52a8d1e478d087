// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/compare_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/results/run_table.h"
#include "ui/session/cycle_cursor.h"
#include "ui/session/document.h"
#include "ui/session/kept_runs.h"
#include "ui/views/cycle/compare_view.h"

#include <QCoreApplication>
#include <QLabel>
#include <QListView>
#include <QTest>

#include <functional>
#include <utility>

/// The view "Compare" and what stands in it.
namespace sparkout::compare_bench {

inline constexpr EditText editText{"Input", "Diameter"};

/// The view as it stands in the window, beside a document.
struct Desk {
    explicit Desk(const Project& project = fixtures::traverseProject()) {
        document.startUntitled(project);
        view.shareCycle(&cursor);
        view.resize(720, 640);
        view.show();
        compute();
    }
    void compute() {
        outcome = fixtures::run(document.project());
        cursor.setOutcome(outcome);
        view.setOutcome(outcome);
        settle();
    }
    void change(const std::function<void(Project&)>& how) {
        Project project = document.project();
        how(project);
        document.edit(std::move(project), editText);
        compute();
    }
    void keep() {
        QVERIFY(kept.keep(*outcome) == KeptRuns::Kept::yes);
        settle();
    }
    /// Kept runs are computed, and what they and the keys have queued is done.
    void settle() {
        QVERIFY(QTest::qWaitFor([this] { return !kept.busy(); }, 20'000));
        QTest::qWait(20);
        for (int i = 0; i < 6; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
    }
    [[nodiscard]] ComparePlot& plot() { return *view.plot(); }
    [[nodiscard]] QString text(const char* label) {
        return view.findChild<QLabel*>(QLatin1String(label))->text();
    }
    [[nodiscard]] QModelIndex row(int run) { return view.list()->model()->index(run + 1, 0); }
    [[nodiscard]] const RunRow* find(const QString& what) {
        for (const RunRow& row : view.rows()) {
            if (row.what == what) {
                return &row;
            }
        }
        return nullptr;
    }

    Document document;
    KeptRuns kept{document};
    CycleCursor cursor;
    OutcomePtr outcome;
    CompareView view{kept};
};

/// With its first run kept.
struct KeptDesk : Desk {
    KeptDesk() { keep(); }
};

inline void quicker(Project& project) {
    project.cycle->stages[0].axial_feed_mm_min = 2400;
    project.wheel->dullness = 0.03;
}

} // namespace sparkout::compare_bench
