// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The design helper in the window: the sheet of a stiffness trial, its readings typed and taken as
// one edit, and which trial tells most.
#include "core/measured/calibrated_inputs.h"
#include "core/process/system_compliance.h"
#include "tests/registry.h"
#include "tests/ui/measured/calibration_bench.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/languages.h"
#include "ui/measured/stiffness_sheet.h"

#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPrinter>
#include <QPushButton>
#include <QTemporaryDir>

namespace sparkout::test_trial_pages {

using namespace calibration_bench;

constexpr double headstock = 45, tailstock = 30; ///< of the truth [N/µm]
constexpr int stiffnessTab = 2, trialTab = 3;

/// Works in the dialog on one of its pages.
void onPage(const Bench& bench, int tab, const std::function<void(QDialog&)>& work) {
    inDialog(bench, [&](QDialog& dialog) {
        QTabBar* bar = part<QTabWidget>(dialog, "calibrationTabs")->tabBar();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(tab).center());
        work(dialog);
    });
}

/// The shaft of the example, at a machine whose heads give more than the project says.
double deflection_um(Project project, double position_mm, double load_n) {
    project.machine->stiffness_n_um = Stiffness{headstock, tailstock, 50};
    constexpr int places = 2001;
    const std::vector<CompliantPlace> along = complianceAlong(project, places);
    double length = 0;
    for (const ShaftSegment& segment : project.part->shaft.segments) {
        length += segment.length_mm;
    }
    const auto at = static_cast<std::size_t>(std::lround(position_mm / length * (places - 1)));
    const ComplianceParts& parts = along[at].parts;
    return load_n * (parts.headstock + parts.tailstock + parts.bending) * 1000;
}

void openSlender(Bench& bench) {
    QVERIFY(bench.open(examplePath("slender-shaft")));
    QTRY_VERIFY(!bench.window->runs().running());
}

/// Types the deflections of all rows whose place and load stand there.
void typeReadings(QDialog& dialog, const Project& project) {
    auto* table = part<QTableView>(dialog, "stiffnessReadings");
    QVERIFY(table && table->isVisible());
    const QLocale locale;
    for (int row = 0; row + 1 < table->model()->rowCount(); ++row) {
        const double at = locale.toDouble(cellOf(dialog, "stiffnessReadings", row, 0));
        const double load = locale.toDouble(cellOf(dialog, "stiffnessReadings", row, 1));
        QVERIFY(at > 0 && load > 0);
        table->setFocus();
        table->setCurrentIndex(table->model()->index(row, 2));
        const QString text = locale.toString(deflection_um(project, at, load), 'f', 2);
        QTest::keyClicks(table, text.left(1));                  // opens the cell
        const auto editors = table->findChildren<QLineEdit*>(); // the last one may go later
        QVERIFY(!editors.isEmpty());
        QLineEdit* const editor = editors.last();
        QTest::keyClicks(editor, text.mid(1));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(cellOf(dialog, "stiffnessReadings", row, 2), text);
    }
}

class TestTrialPages : public QObject {
    Q_OBJECT

private slots:
    void typedDeflectionsGiveTheStiffnessOfBothHeads() {
        Bench bench(QStringLiteral("en"));
        openSlender(bench);
        Document& document = bench.window->document();
        const Project before = document.project();
        onPage(bench, stiffnessTab, [&](QDialog& dialog) {
            QVERIFY(!part<QPushButton>(dialog, "stiffnessTake")->isEnabled());
            typeReadings(dialog, before);
            QCOMPARE(cellOf(dialog, "stiffnessFound", 0, 0), QStringLiteral("headstock"));
            const double head = QLocale().toDouble(cellOf(dialog, "stiffnessFound", 0, 2));
            const double tail = QLocale().toDouble(cellOf(dialog, "stiffnessFound", 1, 2));
            QVERIFY2(std::abs(head / headstock - 1) < 0.02, qPrintable(QString::number(head)));
            QVERIFY2(std::abs(tail / tailstock - 1) < 0.02, qPrintable(QString::number(tail)));
            QCOMPARE(cellOf(dialog, "stiffnessFound", 2, 2), QStringLiteral("not measured"));
            QVERIFY(part<QTableView>(dialog, "stiffnessCompliance")->model()->rowCount() >= 2);
            QTest::mouseClick(part<QPushButton>(dialog, "stiffnessTake"), Qt::LeftButton);
            QVERIFY(!dialog.isVisible());
        });
        const Stiffness found = *document.project().machine->stiffness_n_um;
        QVERIFY(std::abs(found.headstock / headstock - 1) < 0.02);
        QCOMPARE(found.wheel_head, before.machine->stiffness_n_um->wheel_head);
        const Calibration* const record =
            calibrationOf(document.project(), "/machine/stiffness_n_um/headstock");
        QVERIFY(record && record->low && hasCalibratedValue(document.project(), *record));
        QCOMPARE(QString::fromStdString(record->data),
                 QStringLiteral("stiffness trial at 3 places"));
        bench.action("undo")->trigger();
        QVERIFY(!document.canUndo()); // it was one edit
        QCOMPARE(document.project().machine->stiffness_n_um->headstock,
                 before.machine->stiffness_n_um->headstock);
    }

    void aTableIsPastedAndItsFaultsAreNamed() {
        Bench bench(QStringLiteral("en"));
        openSlender(bench);
        const Project project = bench.window->document().project();
        onPage(bench, stiffnessTab, [&](QDialog& dialog) {
            auto* table = part<QTableView>(dialog, "stiffnessReadings");
            const auto paste = [&](const QString& text) {
                QApplication::clipboard()->setText(text);
                table->setFocus();
                table->setCurrentIndex(table->model()->index(0, 0));
                QTest::keySequence(table, QKeySequence::Paste);
            };
            const auto line = [&](double at, double load) {
                return QStringLiteral("%1\t%2\t%3\n")
                    .arg(at)
                    .arg(load)
                    .arg(deflection_um(project, at, load), 0, 'f', 2);
            };
            const double first = QLocale().toDouble(cellOf(dialog, "stiffnessReadings", 0, 0));
            const double last = QLocale().toDouble(cellOf(dialog, "stiffnessReadings", 11, 0));
            QVERIFY(last > first);
            QTest::keyClick(table, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClick(table, Qt::Key_Delete);
            paste(line(first, 200) + line(last, 200));
            const double head = QLocale().toDouble(cellOf(dialog, "stiffnessFound", 0, 2));
            QVERIFY2(std::abs(head / headstock - 1) < 0.02, qPrintable(QString::number(head)));
            paste(QStringLiteral("100\tabc\t5\n"));
            const QString words = part<QLabel>(dialog, "stiffnessWords")->text();
            QVERIFY2(words.contains(QStringLiteral("Row 1")), qPrintable(words));
            QVERIFY(!part<QPushButton>(dialog, "stiffnessTake")->isEnabled());
        });
    }

    /// Without the steps of the shaft there are no places on it.
    void withoutAShaftTheTrialSaysWhatItNeeds() {
        Bench bench(QStringLiteral("en"));
        Project project = traced::plunge();
        project.part->shaft.segments.clear();
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(!bench.window->runs().running());
        onPage(bench, stiffnessTab, [](QDialog& dialog) {
            QVERIFY(part<QLabel>(dialog, "stiffnessWords")
                        ->text()
                        .contains(QStringLiteral("steps are given on the page Part")));
            QVERIFY(!part<QPushButton>(dialog, "stiffnessPrint")->isEnabled());
            QVERIFY(!part<QTableView>(dialog, "stiffnessReadings")->isEnabled());
            QCOMPARE(part<QTableView>(dialog, "stiffnessReadings")->model()->rowCount(), 1);
        });
    }

    void theSheetIsPrinted() {
        Bench bench(QStringLiteral("ru"));
        openSlender(bench);
        const StiffnessSheet sheet(bench.window->document().project(), {60, 300, 540}, 120);
        const QString html = sheet.html();
        for (const char* place : {">60<", ">300<", ">540<", ">120<"}) {
            QVERIFY2(html.contains(QLatin1String(place)), place);
        }
        QVERIFY(englishIn(sheet.steps().join(u' ')).isEmpty());
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("sheet.pdf"));
        QPrinter printer(QPrinter::HighResolution);
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(file);
        sheet.printOn(printer);
        QFile pdf(file);
        QVERIFY(pdf.open(QIODevice::ReadOnly) && pdf.size() > 1000);
    }

    void theBestTrialStandsFirstAndSaysWhatToDo() {
        Bench bench(QStringLiteral("en"));
        bench.window->document().startUntitled(traced::plunge());
        QTRY_VERIFY(!bench.window->runs().running());
        onPage(bench, trialTab, [&](QDialog& dialog) {
            auto* find = part<QPushButton>(dialog, "trialFind");
            QTest::mouseClick(find, Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(find->isEnabled(), 60'000);
            auto* table = part<QTableView>(dialog, "trialTable");
            QVERIFY(table->isVisible());
            QCOMPARE(table->model()->rowCount(), 24);
            QCOMPARE(table->model()->columnCount(), 6); // α and β
            QVERIFY(cellOf(dialog, "trialTable", 0, 4).contains(u'…'));
            auto* words = part<QLabel>(dialog, "trialWords");
            QVERIFY2(words->text().contains(QStringLiteral("Most informative trial")),
                     qPrintable(words->text()));
            auto* record = part<QComboBox>(dialog, "trialRecord");
            record->setFocus();
            QTest::keyClick(record, Qt::Key_End); // the normal force alone
            QCOMPARE(table->model()->rowCount(), 6);
            QVERIFY(words->text().contains(QStringLiteral("normal force")));
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                              table->visualRect(table->model()->index(2, 0)).center());
            QVERIFY2(words->text().contains(QStringLiteral("The chosen trial")),
                     qPrintable(words->text()));
        });
        QVERIFY(!bench.window->document().canUndo());
    }

    void allTextsHaveRoomAndAreTranslated_data() { addLanguages(); }

    void allTextsHaveRoomAndAreTranslated() {
        QFETCH(QString, language);
        Bench bench(language);
        openSlender(bench);
        const Project project = bench.window->document().project();
        const auto look = [&](QDialog& dialog, const char* name) {
            bench.settle();
            const QStringList narrow = textsWithoutRoom(dialog);
            QVERIFY2(narrow.isEmpty(), qPrintable(narrow.join(u'\n')));
            for (const ShownText& shown : textsOf(dialog)) {
                QVERIFY2(language != u"ru" || englishIn(shown.text).isEmpty(),
                         qPrintable(shown.text));
            }
            if (const QString to = qEnvironmentVariable("SPARKOUT_PICTURES"); !to.isEmpty()) {
                dialog.grab().save(
                    QStringLiteral("%1/%2-%3.png").arg(to, QLatin1String(name), language));
            }
        };
        onPage(bench, stiffnessTab, [&](QDialog& dialog) {
            typeReadings(dialog, project);
            look(dialog, "stiffness");
        });
        onPage(bench, trialTab, [&](QDialog& dialog) {
            look(dialog, "trial-before");
            auto* find = part<QPushButton>(dialog, "trialFind");
            QTest::mouseClick(find, Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(find->isEnabled(), 60'000);
            look(dialog, "trial");
        });
    }
};

} // namespace sparkout::test_trial_pages

SPARKOUT_TEST(test_trial_pages, TestTrialPages)
#include "test_trial_pages.moc"
