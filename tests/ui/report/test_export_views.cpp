// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Plots and tables of the window, saved from their own menus.
#include "core/quality/verdict.h"
#include "tests/registry.h"
#include "tests/ui/report/export_bench.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/file_trouble.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/plot_tools.h"
#include "ui/dialogs/copy_table.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/window/view_tabs.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QRegularExpression>

namespace sparkout::test_export_views {

using namespace export_bench;

QString traverseExample() {
    return examplePaths().filter(QStringLiteral("30h6-factory")).value(0);
}

class TestExportViews : public ExportTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    /// As a view that was torn off and goes back while its picture is written.
    void aWindowThatIsGoneWhenItsFileIsWrittenIsNotAskedAgain() {
        const Bench bench(QStringLiteral("en"));
        auto* own = new QWidget;
        own->show();
        const QString path = m_folder.filePath(QStringLiteral("gone.txt"));
        const DialogAnswers answers({QStringLiteral("file:") + path});
        QVERIFY(saveWithDialog(own, nullptr,
                               {QStringLiteral("Save"), QStringLiteral("gone"),
                                QStringLiteral("txt"), QStringLiteral("Texts (*.txt)"), [own] {
                                    delete own;
                                    return [] { return QByteArrayLiteral("whole"); };
                                }}));
        QCOMPARE(answers.fault(), QString());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArrayLiteral("whole"));
    }

    void everyPlotIsSavedAsAWorkbookWithItsUnitsApart_data() { languageRows(); }
    void everyPlotIsSavedAsAWorkbookWithItsUnitsApart() {
        QFETCH(QString, language);
        OpenBench bench(language, traverseExample());
        int saved = 0, units = 0;
        for (View* view : bench.window->views()) {
            bench.window->viewTabs().showView(view);
            bench.settle();
            for (const PlotTools* tools : view->findChildren<PlotTools*>()) {
                if (!tools->xlsx->isEnabled() || view->objectName() == u"batch"
                    || view->objectName() == u"compare") { // nothing in them yet
                    continue;
                }
                const QString path =
                    m_folder.filePath(QStringLiteral("%1-%2.xlsx").arg(language).arg(++saved));
                const DialogAnswers answers({QStringLiteral("file:") + path});
                tools->xlsx->trigger();
                QCOMPARE(answers.fault(), QString());
                const XlsxReader read(path);
                QCOMPARE(read.fault(), QString());
                checkNoFormula(read);
                units += checkUnits(read);
                if (view->objectName() == u"feeds") { // a grid of zones
                    QCOMPARE(read.names(),
                             language == u"ru"
                                 ? QStringList({QStringLiteral("РЗ1"), QStringLiteral("НЗ"),
                                                QStringLiteral("РЗ2")})
                                 : QStringList({QStringLiteral("RZ1"), QStringLiteral("NZ"),
                                                QStringLiteral("RZ2")}));
                }
            }
        }
        QVERIFY2(saved >= 5 && units >= 20, qPrintable(QString::number(units)));
    }

    void tablesAreSavedFromTheirMenu() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        QVERIFY(bench.window->showView(QStringLiteral("constraints")));
        bench.settle();
        for (const char* name : {"requirements", "shop", "margins"}) {
            auto* table = bench.window->findChild<CopyTable*>(QLatin1StringView(name));
            const QStringList texts = saveTableByMenu(*table, 0, "table.xlsx");
            QCOMPARE(texts.size(),
                     6); // copy what is selected, copy all, save as, and three formats
            for (const QString& text : texts) {
                QCOMPARE(englishIn(text), QString());
            }
            const XlsxReader read(m_folder.filePath(QStringLiteral("table.xlsx")));
            QCOMPARE(read.fault(), QString());
            QVERIFY(read.rows(0) > 3);
            checkNoFormula(read);
            (void)saveTableByMenu(*table, 1, "table.csv");
            const QByteArray csv = trouble::bytesOf(m_folder.filePath(QStringLiteral("table.csv")));
            QVERIFY(csv.startsWith("\xEF\xBB\xBF") && csv.count(';') > 10);
        }
        // To the last bit, which the table on the screen does not show.
        auto* margins = bench.window->findChild<CopyTable*>(QStringLiteral("requirements"));
        (void)saveTableByMenu(*margins, 0, "table.xlsx");
        const XlsxReader read(m_folder.filePath(QStringLiteral("table.xlsx")));
        const auto& constraints = bench.window->studies().outcome->constraints;
        const int head = read.rows(0) - static_cast<int>(constraints.size());
        for (std::size_t i = 0; i < constraints.size(); ++i) {
            QVERIFY(sameBits(read.number(0, head + int(i), 2), constraints[i].value));
            const bool isKnown = marginKnown(constraints[i]) == MarginKnown::exactly;
            QVERIFY(isKnown ? sameBits(read.number(0, head + int(i), 4), constraints[i].margin)
                            : read.text(0, head + int(i), 4).isEmpty());
        }
    }

    void anEmptyTableIsNotOffered() {
        CopyTable table([] { return QString(); });
        table.setSaving([] { return CsvTable(); }, [] { return QString(); }, nullptr);
        table.show();
        QMenu* menu = menuOf(table);
        QVERIFY(menu);
        QVERIFY(!menu->actions().last()->isEnabled());
        menu->close();
    }

private:
    /// No name of a column ends in a unit; returns how many have one of their own.
    static int checkUnits(const XlsxReader& read) {
        static const QRegularExpression tail(
            QStringLiteral(", ([^ ,]+/[^ ,]+|[µмmcс%°НNWВтkкВJДж]{1,3}³?|min|мин|мкм|кВт)$"));
        int units = 0;
        for (int sheet = 0; sheet < read.names().size(); ++sheet) {
            for (int i = 0; i < read.columns(sheet); ++i) {
                const QString name = read.text(sheet, 0, i);
                if (tail.match(name).hasMatch()) {
                    QTest::qFail(qPrintable(name), __FILE__, __LINE__);
                }
                units += read.frozen(sheet) == u"A3" && !read.text(sheet, 1, i).isEmpty() ? 1 : 0;
            }
        }
        return units;
    }

    static QMenu* menuOf(CopyTable& table) {
        QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, table.mapToGlobal(QPoint(5, 5)));
        QCoreApplication::sendEvent(table.viewport(), &event);
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }

    /// Saves it in one of the formats of its menu; returns the texts of that.
    QStringList saveTableByMenu(CopyTable& table, int format, const char* name) {
        QMenu* menu = menuOf(table);
        if (!menu) {
            return {};
        }
        QMenu* formats = menu->actions().last()->menu();
        QStringList texts;
        for (const QAction* action : menu->actions() + formats->actions()) {
            texts << action->text();
        }
        const QString path = m_folder.filePath(QLatin1StringView(name));
        QFile::remove(path);
        const DialogAnswers answers({QStringLiteral("file:") + path});
        QAction* save = formats->actions().at(format);
        menu->hide();
        save->trigger();
        if (!answers.fault().isEmpty()) {
            QTest::qFail(qPrintable(answers.fault()), __FILE__, __LINE__);
        }
        return texts;
    }
};

} // namespace sparkout::test_export_views

SPARKOUT_TEST(test_export_views, TestExportViews)
#include "test_export_views.moc"
