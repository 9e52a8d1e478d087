// SPDX-License-Identifier: GPL-3.0-or-later
// A list as a table: sorted, copied, with the columns that were chosen.
#include "tests/registry.h"
#include "ui/dialogs/copy_table.h"
#include "ui/session/settings.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QMenu>
#include <QSignalSpy>

namespace sparkout::test_value_table {

namespace {

ValueCell number(const std::optional<double>& value) {
    return ValueCell::of(value, [](double of) { return QString::number(of) + u'!'; });
}

/// Names and numbers, one of which is missing.
ValueTable list() {
    ValueTable table{.columns = {{.text = QStringLiteral("Name"), .key = "name", .isText = true},
                                 {.text = QStringLiteral("Number"), .key = "number"},
                                 {.text = QStringLiteral("1")},
                                 {.text = QStringLiteral("2")}},
                     .isList = true};
    const std::vector<std::pair<QString, std::optional<double>>> rows{
        {QStringLiteral("Shaft 10"), 9.5},
        {QStringLiteral("Shaft 9"), {}},
        {QStringLiteral("Bore"), 10.25},
        {QStringLiteral("Axle"), -0.5}};
    for (const auto& [name, value] : rows) {
        table.addRow({.text = name}, {{.text = name}, number(value), number(1), number(2)});
    }
    return table;
}

/// The table in a window.
struct Shown {
    explicit Shown(Settings& settings) {
        model.setTable(list());
        view.setObjectName(QStringLiteral("sortedTable"));
        view.setArrangeable(&settings);
        view.resize(500, 300);
        view.show();
    }
    [[nodiscard]] QStringList names() const {
        QStringList texts;
        for (int line = 0; line < model.rowCount(); ++line) {
            texts << model.index(line, 0).data().toString();
        }
        return texts;
    }
    void clickHead(int column) {
        QHeaderView& head = *view.horizontalHeader();
        const QPoint at(head.sectionViewportPosition(column) + head.sectionSize(column) / 2,
                        head.height() / 2);
        QTest::mouseClick(head.viewport(), Qt::LeftButton, {}, at);
    }
    void clickRow(int line) {
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {},
                          view.visualRect(model.index(line, 0)).center());
    }
    /// The entry of the menu that shows and hides a column; null: there is none.
    [[nodiscard]] QAction* columnEntry(const QString& name) {
        QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, view.mapToGlobal(QPoint(5, 5)));
        QCoreApplication::sendEvent(view.viewport(), &event);
        for (QMenu* menu : view.findChildren<QMenu*>()) {
            for (QAction* action : menu->actions()) {
                if (action->isCheckable() && action->text() == name) {
                    return action;
                }
            }
        }
        return nullptr;
    }

    ValueModel model;
    CopyTable view{model};
};

} // namespace

class TestValueTable : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QStringLiteral("en"))); } // which sorts words
    void cleanupTestCase() { QLocale::setDefault(QLocale::system()); }

    void aClickOnAHeadSortsAndTheThirdPutsBack() {
        Settings settings = Settings::transient();
        Shown shown(settings);
        const QStringList given = shown.names();
        shown.clickHead(1);
        QCOMPARE(shown.names(), (QStringList{QStringLiteral("Axle"), QStringLiteral("Shaft 10"),
                                             QStringLiteral("Bore"), QStringLiteral("Shaft 9")}));
        shown.clickHead(1); // what is missing stays last
        QCOMPARE(shown.names(), (QStringList{QStringLiteral("Bore"), QStringLiteral("Shaft 10"),
                                             QStringLiteral("Axle"), QStringLiteral("Shaft 9")}));
        shown.clickHead(1);
        QCOMPARE(shown.names(), given);
        shown.clickHead(0); // numbers in words by their values
        QCOMPARE(shown.names(),
                 (QStringList{QStringLiteral("Axle"), QStringLiteral("Bore"),
                              QStringLiteral("Shaft 9"), QStringLiteral("Shaft 10")}));
    }

    void aRowIsTheSameHoweverItIsSorted() {
        Settings settings = Settings::transient();
        Shown shown(settings);
        QSignalSpy chosen(&shown.view, &CopyTable::rowChosen);
        shown.clickRow(2);
        QCOMPARE(chosen.back().front().toInt(), 2);
        shown.clickHead(1);
        QCOMPARE(shown.model.rowAt(shown.view.currentIndex().row()), 2); // it stays chosen
        shown.clickRow(0);
        QCOMPARE(chosen.back().front().toInt(), 3);
        for (int row = 0; row < 4; ++row) {
            QCOMPARE(shown.model.rowAt(shown.model.lineOf(row)), row);
        }
        ValueTable changed = list();
        changed.cells[3][1] = number(20);
        shown.model.update(std::move(changed)); // sorted as it was, with what was chosen
        QCOMPARE(shown.names().at(2), QStringLiteral("Axle"));
        QCOMPARE(shown.model.rowAt(shown.view.currentIndex().row()), 3);
    }

    void whatIsCopiedIsInTheOrderShownWithAllDigits() {
        Settings settings = Settings::transient();
        Shown shown(settings);
        shown.clickHead(1);
        shown.clickRow(1);
        shown.view.setFocus();
        QTest::keyClick(&shown.view, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("Shaft 10\t9.5\t1\t2\n"));
        QTest::keyClick(&shown.view, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        const QStringList lines = QApplication::clipboard()->text().split(u'\n');
        QCOMPARE(lines[0], QStringLiteral("Name\tNumber\t1\t2"));
        QCOMPARE(lines[1], QStringLiteral("Axle\t-0.5\t1\t2"));
        QCOMPARE(lines[4], QStringLiteral("Shaft 9\t\t1\t2"));
    }

    void theContextMenuCopiesToo() {
        Settings settings = Settings::transient();
        Shown shown(settings);
        shown.clickRow(0);
        (void)shown.columnEntry(QString()); // opens it
        auto* menu = shown.view.findChild<QMenu*>(QString(), Qt::FindDirectChildrenOnly);
        QVERIFY(menu);
        menu->actions().at(0)->trigger(); // what is selected
        QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("Shaft 10\t9.5\t1\t2\n"));
        menu->actions().at(1)->trigger(); // all
        QCOMPARE(QApplication::clipboard()->text().count(u'\n'), 5);
        menu->close();
    }

    void columnsAreChosenAndRemembered() {
        Settings settings = Settings::transient();
        {
            Shown shown(settings);
            QVERIFY(!shown.columnEntry(QStringLiteral("Name"))); // it names the rows
            QVERIFY(!shown.columnEntry(QStringLiteral("1")));    // has no key of its own
            QAction* const entry = shown.columnEntry(QStringLiteral("Number"));
            QVERIFY(entry && entry->isChecked());
            entry->trigger();
            QVERIFY(shown.view.isColumnHidden(1) && !shown.view.isColumnHidden(2));
        }
        Shown again(settings);
        QVERIFY(again.view.isColumnHidden(1));
        again.model.setTable(list());
        QVERIFY(again.view.isColumnHidden(1));
        again.columnEntry(QStringLiteral("Number"))->trigger();
        QVERIFY(!again.view.isColumnHidden(1));
        QVERIFY(settings.hiddenColumns(QStringLiteral("sortedTable")).isEmpty());
    }

    /// Rows of a sheet stand for the rows that are no groups.
    void groupsAreNeitherCopiedNorChosen() {
        ValueTable table{.columns = {{.text = QStringLiteral("What"), .isText = true}},
                         .sheet = {{QStringLiteral("Sheet")}, {{1.0}, {2.0}}},
                         .isList = true};
        table.addRow({.isGroup = true}, {{.text = QStringLiteral("Group")}});
        table.addRow({.text = QStringLiteral("one")}, {{.text = QStringLiteral("one")}});
        table.addRow({.isGroup = true}, {{.text = QStringLiteral("Group")}});
        table.addRow({.text = QStringLiteral("two")}, {{.text = QStringLiteral("two")}});
        const CsvTable copied = table.inOrder({3, 2, 1, 0});
        QCOMPARE(copied.rows.size(), std::size_t(2));
        QCOMPARE(std::get<double>(copied.rows[0][0]), 2.0);
        QCOMPARE(std::get<double>(copied.rows[1][0]), 1.0);
        ValueModel model;
        model.setTable(table);
        model.sort(0, Qt::DescendingOrder); // groups keep their rows
        QCOMPARE(model.rowAt(0), 0);
        QVERIFY(!(model.flags(model.index(0, 0)) & Qt::ItemIsSelectable));
        QVERIFY(model.flags(model.index(1, 0)) & Qt::ItemIsSelectable);
    }
};

} // namespace sparkout::test_value_table

SPARKOUT_TEST(test_value_table, TestValueTable)
#include "test_value_table.moc"
