// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/study/new_project.h"
#include "ui/form/number_field.h"
#include "ui/inputs/stage_table.h"
#include "ui/session/document.h"

#include <QComboBox>
#include <QTableView>
#include <QTest>

#include <vector>

/// The table of the stages beside a document of its own.
namespace sparkout::stage_table_bench {

struct Bench {
    explicit Bench(Operation operation = Operation::traverse) : table(document) {
        table.resize(340, 400);
        table.show();
        document.startUntitled(newProject(operation));
        table.view().setFocus();
    }
    /// With a cell selected.
    Bench(int row, int column) : Bench() { select(row, column); }
    [[nodiscard]] const std::vector<Stage>& stages() const {
        return document.project().cycle->stages;
    }
    void select(int row, int column) {
        table.view().setCurrentIndex(table.view().model()->index(row, column));
    }
    [[nodiscard]] NumberField* openEditor() {
        QTest::keyClick(&table.view(), Qt::Key_F2);
        return table.view().findChild<NumberField*>();
    }
    /// A text in place of that of the selected cell; the editor, still open.
    NumberField* typeOver(const QString& text) {
        NumberField* const editor = openEditor();
        editor->selectAll();
        QTest::keyClicks(editor, text);
        return editor;
    }
    void enter(const QString& text) { QTest::keyClick(typeOver(text), Qt::Key_Return); }
    [[nodiscard]] double stockSum() const {
        double sum = 0;
        for (const Stage& stage : stages()) {
            sum += stage.stock_mm;
        }
        return sum;
    }
    Document document;
    StageTable table;
};

/// Opens the spark-out of the last stage; its choice of what to do.
inline QComboBox* sparkOutEditor(Bench& bench) {
    const int row = int(bench.stages().size()) - 1;
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // an editor closed before
    bench.select(row, bench.table.view().model()->columnCount() - 2);
    QTest::keyClick(&bench.table.view(), Qt::Key_F2);
    return bench.table.view().findChild<QComboBox*>();
}

} // namespace sparkout::stage_table_bench
