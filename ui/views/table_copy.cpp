// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/table_copy.h"

#include "ui/session/csv_table.h"

#include <QAction>
#include <QClipboard>
#include <QCoreApplication>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLocale>
#include <QTableView>

namespace sparkout {

namespace {

/// The action in the present language.
class CopyAction : public QAction {
    Q_DECLARE_TR_FUNCTIONS(TableCopy)
public:
    explicit CopyAction(QTableView& table) : QAction(&table) {
        setShortcut(QKeySequence::Copy);
        setShortcutContext(Qt::WidgetWithChildrenShortcut);
        table.installEventFilter(this);
        setText(tr("&Copy for a spreadsheet"));
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::LanguageChange) {
            setText(tr("&Copy for a spreadsheet"));
        }
        return QAction::eventFilter(watched, event);
    }
};

QList<int> shown(const QHeaderView& header) {
    QList<int> sections;
    for (int i = 0; i < header.count(); ++i) {
        const int section = header.logicalIndex(i); // in the order of the screen
        if (!header.isSectionHidden(section)) {
            sections << section;
        }
    }
    return sections;
}

/// A number may begin with a sign, no other text.
QString cell(const QVariant& value) {
    const QString text = value.toString().simplified();
    bool number = false;
    (void)QLocale().toDouble(text, &number);
    return number ? text : harmlessCell(text);
}

} // namespace

QString selectionAsTsv(const QTableView& table) {
    const QAbstractItemModel& model = *table.model();
    const QItemSelectionModel& selection = *table.selectionModel();
    const QList<int> rows = shown(*table.verticalHeader());
    const QList<int> columns = shown(*table.horizontalHeader());
    const auto selected = [&](int row, int column) {
        return selection.isSelected(model.index(row, column));
    };
    bool any = false, all = true;
    for (int row : rows) {
        for (int column : columns) {
            const bool taken = selected(row, column);
            any = any || taken;
            all = all && taken;
        }
    }
    const bool whole = all || !any;
    QString text;
    const auto line = [&text](const QStringList& cells) { text += cells.join(u'\t') + u'\n'; };
    if (whole) {
        QStringList names;
        for (int column : columns) {
            names << cell(model.headerData(column, Qt::Horizontal));
        }
        line(names);
    }
    for (int row : rows) {
        QStringList cells;
        bool inRow = whole;
        for (int column : columns) {
            const bool taken = whole || selected(row, column);
            cells << (taken ? cell(model.index(row, column).data()) : QString());
            inRow = inRow || taken;
        }
        if (inRow) {
            line(cells);
        }
    }
    return text;
}

void makeCopyable(QTableView& table) {
    auto* copy = new CopyAction(table);
    QObject::connect(copy, &QAction::triggered, &table,
                     [&table] { QGuiApplication::clipboard()->setText(selectionAsTsv(table)); });
    table.addAction(copy);
    table.setContextMenuPolicy(Qt::ActionsContextMenu);
}

} // namespace sparkout
