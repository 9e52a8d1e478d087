// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/study/outcome.h"
#include "ui/dialogs/copy_table.h"
#include "ui/views/requirements/verdict_panel.h"
#include "ui/views/requirements/verdict_sections.h"

#include <QIcon>
#include <QLabel>
#include <QLocale>
#include <QObject>
#include <QScrollArea>
#include <QTest>

#include <clocale>
#include <string_view>
#include <vector>

/// The verdict panel on runs of two stages and more.
namespace verdict_bench {

using namespace sparkout;

inline Project traverseProject(int stages = 2) {
    Project p;
    p.part->tolerance.radial_runout_um = 6;
    p.machine->compliance_mm_per_n = ZoneCompliance{1.2e-4, 1.7e-4, 1.5e-4};
    p.machine->dwell_entry_s = 0.333;
    for (int z = 0; z < stages; ++z) {
        Stage stage;
        stage.radial_feed_mm = 0.004 / (1 + z);
        stage.axial_feed_mm_min = 1800 / (1 + z);
        stage.stock_mm = p.part->stock_mm / stages;
        p.cycle->stages.push_back(stage);
    }
    return p;
}

inline Project plungeProject(int sections, int stages = 2) {
    Project p = traverseProject();
    p.operation = Operation::plunge;
    p.sections = sections;
    p.part->length_mm = 40;
    p.machine->compliance_mm_per_n = std::vector<double>(static_cast<std::size_t>(sections), 2e-5);
    p.cycle->stages.clear();
    for (int z = 0; z < stages; ++z) {
        Stage stage;
        stage.radial_feed_mm_min = 0.6 / (1 + z);
        stage.stock_mm = p.part->stock_mm / stages;
        p.cycle->stages.push_back(stage);
    }
    return p;
}

inline OutcomePtr run(const Project& project) {
    return evaluate(project, {});
}

/// A test of the panel on a traverse and on a plunge of twenty sections.
class VerdictTest : public QObject {
protected:
    void begin() {
        std::setlocale(LC_NUMERIC, "C");
        QLocale::setDefault(QLocale::c());
        m_traverse = run(traverseProject());
        m_plunge = run(plungeProject(20));
    }

    OutcomePtr m_traverse, m_plunge;
};

/// A panel of a width, with an outcome, as it stands in the window.
struct Bench {
    explicit Bench(const OutcomePtr& outcome, QSize size = {320, 640}) {
        panel.resize(size);
        panel.show();
        show(outcome);
    }
    /// Until what queued calls and layouts leave is as it stays, however busy the machine is.
    void show(const OutcomePtr& outcome) {
        panel.setOutcome(outcome);
        QList<int> before;
        for (int calm = 0, round = 0; calm < 3 && round < 500; ++round) {
            QTest::qWait(10);
            const QWidget* page = area().widget();
            const QList<int> now{
                page->width(),   page->height(),   page->minimumSizeHint().height(),
                table().width(), table().height(), requirements().height()};
            calm = now == before ? calm + 1 : 0;
            before = now;
        }
    }
    [[nodiscard]] ValueModel& model() { return *panel.shop()->model(); }
    [[nodiscard]] CopyTable& table() { return *panel.shop()->table(); }
    [[nodiscard]] CopyTable& requirements() {
        return *panel.findChild<CopyTable*>(QStringLiteral("requirements"));
    }
    [[nodiscard]] QLabel& label(const char* name) {
        return *panel.findChild<QLabel*>(QString::fromLatin1(name));
    }
    [[nodiscard]] QScrollArea& area() { return *panel.findChild<QScrollArea*>(); }
    /// By the key of its output.
    [[nodiscard]] int row(const char* wanted) {
        for (int r = 0; r < model().rowCount(); ++r) {
            if (std::string_view(model().table().rows[std::size_t(r)].key) == wanted) {
                return r;
            }
        }
        return -1;
    }
    [[nodiscard]] QString cell(const char* wanted, int column, int role = Qt::DisplayRole) {
        return model().index(row(wanted), column).data(role).toString();
    }
    [[nodiscard]] bool marked(const char* wanted, int column) {
        return !model().index(row(wanted), column).data(Qt::DecorationRole).value<QIcon>().isNull();
    }

    VerdictPanel panel;
};

inline bool isInSight(const QWidget& widget, const QWidget& in) {
    const QRect where(widget.mapTo(&in, QPoint(0, 0)), widget.size());
    return in.rect().contains(where) && widget.visibleRegion().boundingRect() == widget.rect();
}

inline QPoint middleOfRow(const CopyTable& table, int row) {
    return table.visualRect(table.model()->index(row, 0)).center();
}

} // namespace verdict_bench
