// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Measurements on their way into a project, as a user brings them: by the file dialog, from the
// clipboard, typed; and what the view "Measured" says of the model.
#include "core/measured/adequacy.h"
#include "core/measured/hold_out.h"
#include "core/project/batch.h"
#include "core/project/machine.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/statistics/intervals.h"
#include "core/study/whole_batch.h"
#include "tests/registry.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/traced_project.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/bar_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/measured/import_dialog.h"
#include "ui/measured/measured_boxes.h"
#include "ui/measured/measured_text.h"
#include "ui/views/part/overview_view.h"
#include "ui/views/study/measured_view.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFile>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace sparkout::test_measured_view {

constexpr int patience_ms = 120'000;

QString factoryPath() {
    const QStringList paths = examplePaths();
    return *std::ranges::find(paths, QStringLiteral("shaft-30h6-factory"),
                              [](const QString& path) { return nameOf(path); });
}

/// A window with a project that has a batch, and the view in front.
struct Desk {
    explicit Desk(const char* language = "en") : bench(QString::fromLatin1(language)) {
        opened = bench.open(factoryPath()) && bench.window->showView(QStringLiteral("measured"));
        view = bench.window->findChild<MeasuredView*>();
        bench.settle();
    }
    [[nodiscard]] bool settled() const {
        bench.settle();
        return QTest::qWaitFor([this] { return !view->rows().empty() && !view->busy(); },
                               patience_ms);
    }
    [[nodiscard]] const Measured* measured() const {
        const Project& project = bench.window->document().project();
        return project.measured ? &*project.measured : nullptr;
    }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) const {
        return *view->findChild<Widget*>(QLatin1String(name));
    }
    void click(const char* button) const {
        QTest::mouseClick(&part<QPushButton>(button), Qt::LeftButton);
    }
    Bench bench;
    MeasuredView* view = nullptr;
    bool opened = false;
};

/// The parts that the project's own batch predicts, shifted and spread, as a measuring machine
/// writes them.
QByteArray generated(const Project& project, double shift_um, double spread, int parts,
                     bool isRussian) {
    const BatchOutcomePtr batch = runWholeBatch(predictingProject(project));
    QByteArray text = isRussian ? "деталь;зона;диаметр, мм\n" : "part,zone,\"diameter, mm\"\n";
    for (int part = 0; part < parts; ++part) {
        for (int zone = 0; zone < 3; ++zone) {
            const auto range =
                *predicted(batch->result, MeasuredQuantity::diameter_deviation, zone);
            // Quantiles of a normal law of that mean and scatter, in a mixed order.
            const double order = (((part * 7 + zone * 5) % parts) + 0.5) / parts;
            const double z = normalQuantile(order);
            const double deviation_um =
                range.mean + shift_um + spread * range.deviation.value_or(0) * z;
            QByteArray number =
                QByteArray::number(project.part->diameter_mm + deviation_um / 1000, 'f', 5);
            if (isRussian) {
                number.replace('.', ',');
            }
            const char comma = isRussian ? ';' : ',';
            text += QByteArray::number(part + 1) + comma + QByteArray::number(zone + 1) + comma
                    + number + '\n';
        }
    }
    return text;
}

QString write(const QTemporaryDir& folder, const char* name, const QByteArray& bytes) {
    const QString path = folder.filePath(QLatin1String(name));
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() ? path : QString();
}

/// The editor of a cell, opened by F2; null if there is none of that kind.
template <typename Editor>
Editor* editorOf(CopyTable& table, int row, int column) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the last editor
    table.setCurrentIndex(table.model()->index(row, column));
    QTest::keyClick(&table, Qt::Key_F2);
    return table.viewport()->findChild<Editor*>();
}

void typeInto(CopyTable& table, int row, int column, const QString& text) {
    auto* line = editorOf<QLineEdit>(table, row, column);
    QVERIFY(line);
    line->clear();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    QCoreApplication::processEvents(); // it is taken after the key
}

/// Waits until the dialog has read its table.
bool isRead(const QDialog& dialog) {
    return QTest::qWaitFor(
        [&dialog] {
            const auto* progress = dialog.findChild<QWidget*>(QStringLiteral("importProgress"));
            return progress && !progress->isVisible();
        },
        patience_ms);
}

class TestMeasuredView : public QObject {
    Q_OBJECT

private slots:
    void anEmptyViewSaysWhatWillBeThere() {
        const Desk desk;
        QVERIFY(desk.opened);
        QVERIFY(desk.part<QPushButton>("measuredStart").isVisible());
        QVERIFY(desk.view->findChild<QLabel*>(QStringLiteral("measuredNotice"))
                    ->text()
                    .contains(QStringLiteral("Import a table")));
        QVERIFY(!desk.view->boxes()->isVisible());
    }

    void aFileIsImportedJudgedAndUndone_data() {
        addColumns<double, double, AdequacyVerdict, QString>("shift", "spread", "verdict", "says");
        QTest::newRow("as predicted") << 0.0 << 1.0 << AdequacyVerdict::adequate
                                      << QStringLiteral("The model agrees with the parts");
        QTest::newRow("biased") << 50.0 << 1.0 << AdequacyVerdict::biased
                                << QStringLiteral("calibrate them on these parts");
        QTest::newRow("scatters") << 0.0 << 3.0 << AdequacyVerdict::scatterDiffers
                                  << QStringLiteral("measured scatter of stock");
    }

    void aFileIsImportedJudgedAndUndone() {
        QFETCH(double, shift);
        QFETCH(double, spread);
        QFETCH(AdequacyVerdict, verdict);
        QFETCH(QString, says);
        const Desk desk;
        QVERIFY(desk.opened);
        const QTemporaryDir folder;
        const QString path =
            write(folder, "parts.csv",
                  generated(desk.bench.window->document().project(), shift, spread, 40, false));
        DialogAnswers answers({QStringLiteral("file:") + path, QStringLiteral("importGo")});
        answers.seen = [](QDialog& dialog) {
            if (qobject_cast<ImportDialog*>(&dialog)) {
                QVERIFY(isRead(dialog));
            }
        };
        desk.click("measuredStart");
        QCOMPARE(answers.fault(), QString());
        QVERIFY(desk.measured());
        QCOMPARE(desk.measured()->parts.size(), 120U);
        QCOMPARE(desk.measured()->parts.back().place, 2); // counted from 1 in the file
        QVERIFY(desk.settled());
        QCOMPARE(desk.view->rows().size(), 3U);
        for (const AdequacyRow& row : desk.view->rows()) {
            QCOMPARE(row.verdict, verdict);
        }
        QVERIFY2(desk.part<QLabel>("measuredJudgement").text().contains(says),
                 qPrintable(desk.part<QLabel>("measuredJudgement").text()));
        QCOMPARE(desk.view->boxes()->chart().boxes.size(), 6U); // predicted and measured
        desk.bench.action("undo")->trigger();
        QVERIFY(!desk.measured());
        desk.bench.settle();
        QTRY_VERIFY(desk.view->rows().empty());
        desk.bench.action("redo")->trigger();
        QVERIFY(desk.measured());
    }

    void aRussianTableIsPastedAndReplaces() {
        const Desk desk;
        QVERIFY(desk.opened);
        const Project& project = desk.bench.window->document().project();
        QByteArray text = generated(project, 0, 1, 20, true);
        QApplication::clipboard()->setText(QString::fromUtf8(text).replace(u';', u'\t'));
        for (const char* how : {"importAdd", "importAdd", "importReplace"}) {
            const bool isFirst = !desk.measured();
            DialogAnswers answers(
                isFirst ? QStringList{QStringLiteral("importGo")}
                        : QStringList{QLatin1String(how), QStringLiteral("importGo")});
            answers.seen = [](QDialog& dialog) { QVERIFY(isRead(dialog)); };
            // The focus is on the tab when one comes to the view.
            QTest::keyClick(desk.bench.window->viewTabs().tabBar(), Qt::Key_V, Qt::ControlModifier);
            QCOMPARE(answers.fault(), QString());
            QCOMPARE(desk.measured()->parts.size(),
                     isFirst || qstrcmp(how, "importReplace") == 0 ? 60U : 120U);
        }
        desk.bench.action("undo")->trigger(); // one edit an import
        QCOMPARE(desk.measured()->parts.size(), 120U);
    }

    void aRefusedCellIsNamedAndNothingIsLost() {
        const Desk desk;
        QVERIFY(desk.opened);
        QApplication::clipboard()->setText(
            QStringLiteral("part\tdiameter, mm\troundness, µm\n1\t29.99\t1.1\n2\tabc\t1.2\n"));
        DialogAnswers answers({QStringLiteral("importWithout"), QStringLiteral("importGo")});
        bool isFirst = true;
        answers.seen = [&isFirst](QDialog& dialog) {
            QVERIFY(isRead(dialog));
            if (std::exchange(isFirst, false)) {
                const auto* delimiter =
                    dialog.findChild<QComboBox*>(QStringLiteral("importDelimiter"));
                QCOMPARE(delimiter->currentText(), QStringLiteral("tab"));
                const auto* faults = dialog.findChild<QListWidget*>(QStringLiteral("importFaults"));
                QVERIFY(faults->isVisible());
                QCOMPARE(faults->count(), 1);
                QVERIFY(faults->item(0)->text().startsWith(QStringLiteral("Line 3, column 2:")));
                QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("importGo"))->isEnabled());
                const QString said =
                    dialog.findChild<QLabel*>(QStringLiteral("importState"))->text();
                QVERIFY2(said.contains(QStringLiteral("taken as those of RZ1")), qPrintable(said));
                QCOMPARE(dialog.findChild<QComboBox*>(QStringLiteral("importFirst"))->currentText(),
                         QStringLiteral("from 1"));
            }
        };
        desk.click("measuredPaste");
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(desk.measured()->parts.size(), 2U);
        QVERIFY(desk.measured()->parts[1].diameters_mm.empty());
        QCOMPARE(desk.measured()->parts[1].roundness_um, std::optional(1.2));
    }

    void aColumnIsChosenByItsBox() {
        const Desk desk;
        QVERIFY(desk.opened);
        QApplication::clipboard()->setText(QStringLiteral("x\ty\n1\t29990\n2\t29991\n"));
        DialogAnswers answers({QStringLiteral("importGo")});
        answers.seen = [](QDialog& dialog) {
            QVERIFY(isRead(dialog));
            QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("importGo"))->isEnabled());
            const auto choose = [&dialog](const char* name, int value) {
                auto* box = dialog.findChild<QComboBox*>(QLatin1String(name));
                QVERIFY(box);
                box->setFocus();
                const int wanted = box->findData(value);
                QVERIFY(wanted >= 0);
                for (int keys = 0; box->currentIndex() != wanted && keys < 20; ++keys) {
                    QTest::keyClick(box, box->currentIndex() < wanted ? Qt::Key_Down : Qt::Key_Up);
                }
            };
            choose("column-1-1", static_cast<int>(ColumnQuantity::diameter));
            choose("column-1-2", static_cast<int>(ColumnUnit::um));
            QVERIFY(isRead(dialog));
        };
        desk.click("measuredPaste");
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(desk.measured()->parts.size(), 2U);
        QVERIFY(std::abs(desk.measured()->parts[0].diameters_mm.at(0) - 29.99) < 1e-9);
    }

    /// The boxes are others as soon as the table is read in another way.
    void returnInABoxThatIsGoneIsForgotten() {
        const Desk desk;
        QVERIFY(desk.opened);
        QApplication::clipboard()->setText(QStringLiteral("x\ty\n1\t29990\n2\t29991\n"));
        WarningCatcher warnings;
        DialogAnswers answers({QStringLiteral("importCancel")});
        answers.seen = [](QDialog& dialog) {
            QVERIFY(isRead(dialog));
            auto* box = dialog.findChild<QComboBox*>(QStringLiteral("column-1-1"));
            QVERIFY(box);
            box->setFocus();
            QKeyEvent key(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
            QApplication::sendEvent(box, &key);
            auto* delimiter = dialog.findChild<QComboBox*>(QStringLiteral("importDelimiter"));
            delimiter->setCurrentIndex(delimiter->currentIndex() == 0 ? 1 : 0);
            QCoreApplication::processEvents();
            QVERIFY(isRead(dialog));
        };
        desk.click("measuredPaste");
        QCOMPARE(answers.fault(), QString());
        const QStringList warned = warnings.take();
        QVERIFY2(warned.isEmpty(), qPrintable(warned.join(u'\n')));
    }

    void cancelLeavesTheProjectAsItIs() {
        const Desk desk;
        QVERIFY(desk.opened);
        QApplication::clipboard()->setText(QStringLiteral("diameter, mm\n29.99\n"));
        DialogAnswers answers({QStringLiteral("Escape")});
        desk.click("measuredPaste");
        QCOMPARE(answers.fault(), QString());
        QVERIFY(!desk.measured());
        QVERIFY(!desk.bench.window->document().modified());
    }

    void aMillionSamplesDoNotStopTheWindow() {
        const Desk desk;
        QVERIFY(desk.opened);
        constexpr int samples = 1'000'000;
        QByteArray text = "time, s;size, mm\n";
        text.reserve(samples * 14);
        for (int i = 0; i < samples; ++i) {
            text += QByteArray::number(i * 0.001, 'f', 3) + ';'
                    + QByteArray::number(0.2 - i * 1e-7, 'f', 4) + '\n';
        }
        const QTemporaryDir folder;
        const QString path = write(folder, "trace.csv", text);
        DialogAnswers answers({QStringLiteral("file:") + path, QStringLiteral("importGo")});
        qint64 longest_ms = 0;
        answers.seen = [&longest_ms](QDialog& dialog) {
            if (!qobject_cast<ImportDialog*>(&dialog)) {
                return;
            }
            QElapsedTimer since;
            since.start();
            QTimer beat;
            connect(&beat, &QTimer::timeout, &dialog,
                    [&] { longest_ms = std::max(longest_ms, since.restart()); });
            beat.start(0);
            QVERIFY(isRead(dialog));
        };
        desk.click("measuredImport");
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(desk.measured()->traces.size(), 1U);
        const MeasuredTrace& trace = desk.measured()->traces.front();
        QCOMPARE(trace.source_samples, samples);
        QVERIFY(trace.values.size() <= limits::traceSamples);
        QCOMPARE(trace.source, std::string("trace.csv"));
        qInfo("SPEED longest wait while a million samples are read: %lld ms", longest_ms);
        QVERIFY(longest_ms < 500); // a machine with much else to do
    }

    void statisticsAreTypedAndJudged() {
        const Desk desk;
        QVERIFY(desk.opened);
        auto& sheet = desk.part<QComboBox>("measuredSheet");
        sheet.setFocus();
        QTest::keyClick(&sheet, Qt::Key_Down);
        QTest::keyClick(&sheet, Qt::Key_Down);
        QCOMPARE(sheet.currentIndex(), int(MeasuredView::summaries));
        desk.click("measuredSummariesAdd");
        QCOMPARE(desk.measured()->summaries.size(), 1U);
        auto& table = desk.part<CopyTable>("measuredSummaries");
        const auto type = [&table](int column, const QString& text) {
            typeInto(table, 0, column, text);
        };
        type(2, QStringLiteral("20"));
        type(3, QStringLiteral("-40,5")); // a comma is a decimal one in every language
        type(6, QStringLiteral("2"));
        type(2, QStringLiteral("one")); // refused, and kept in sight
        const MeasuredSummary& summary = desk.measured()->summaries.front();
        QCOMPARE(summary.count, 20);
        QCOMPARE(summary.mean_um, -40.5);
        QCOMPARE(summary.deviation_um, std::optional(2.0));
        QCOMPARE(table.model()->index(0, 2).data().toString(), QStringLiteral("one"));
        QVERIFY(table.model()
                    ->index(0, 2)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("is not a number")));
        sheet.setCurrentIndex(MeasuredView::comparison);
        QVERIFY(desk.settled());
        QCOMPARE(desk.view->rows().front().verdict, AdequacyVerdict::biasedAndScatters);
        for (int edits = 0; edits < 4; ++edits) {
            desk.bench.action("undo")->trigger();
        }
        QVERIFY(!desk.measured());
    }

    void partsAreEnteredByBoxAndByText() {
        const Desk desk;
        QVERIFY(desk.opened);
        desk.part<QComboBox>("measuredSheet").setCurrentIndex(MeasuredView::parts);
        auto& table = desk.part<CopyTable>("measuredParts");
        QAbstractItemModel& model = *table.model();
        constexpr int place = 1, diameters = 2, roundness = 3;
        desk.click("measuredPartsAdd");
        auto* box = editorOf<QComboBox>(table, 0, place);
        QVERIFY(box);
        QCOMPARE(box->currentText(), model.index(0, place).data().toString());
        QTest::keyClick(box, Qt::Key_Down);
        QCOMPARE(desk.measured()->parts.at(0).place, 1);
        desk.click("measuredPartsAdd");
        QCOMPARE(desk.measured()->parts.at(1).part, std::string("2"));
        QCOMPARE(desk.measured()->parts[1].place, 1); // that of the row above
        typeInto(table, 1, diameters, QStringLiteral("29.99; 29,98"));
        typeInto(table, 1, roundness, QStringLiteral("1.2"));
        QCOMPARE(desk.measured()->parts[1].roundness_um, std::optional(1.2));
        typeInto(table, 1, roundness, QString());
        // Three texts are refused and kept in sight, with the reason; the values stay.
        typeInto(table, 1, diameters, QStringLiteral("29.99; x"));
        typeInto(table, 1, roundness, QStringLiteral("-1"));
        QVERIFY(!model.setData(model.index(1, place), QStringLiteral("elsewhere")));
        for (const auto& [column, text, reason] :
             {std::tuple{diameters, "29.99; x", "separate several by semicolons"},
              std::tuple{roundness, "-1", "out of range; allowed: 0 to"},
              std::tuple{place, "elsewhere", "not one of the choices"}}) {
            const QModelIndex cell = model.index(1, column);
            QCOMPARE(cell.data().toString(), QLatin1String(text));
            const QString tip = cell.data(Qt::ToolTipRole).toString();
            QVERIFY2(tip.contains(QLatin1String(reason)), qPrintable(tip));
        }
        const MeasuredPart& entered = desk.measured()->parts[1];
        QCOMPARE(entered.diameters_mm, (std::vector{29.99, 29.98}));
        QVERIFY(!entered.roundness_um);
        QCOMPARE(entered.place, 1);
        for (int edits = 0; edits < 6; ++edits) { // one for each row and each accepted value
            QVERIFY(desk.measured());
            desk.bench.action("undo")->trigger();
        }
        QVERIFY(!desk.measured());
    }

    void ofATraceOnlyWhatDescribesItIsEdited() {
        const Desk desk;
        QVERIFY(desk.opened);
        desk.bench.window->document().startUntitled(traced::heldOut());
        const QAbstractItemModel& model = *desk.part<CopyTable>("measuredTraces").model();
        QCOMPARE(model.rowCount(), int(desk.measured()->traces.size()));
        QStringList heads, edited;
        for (int column = 0; column < model.columnCount(); ++column) {
            heads << model.headerData(column, Qt::Horizontal).toString().replace(u'\n', u' ');
            if (model.flags(model.index(0, column)) & Qt::ItemIsEditable) {
                edited << heads.last();
            }
        }
        const QStringList described{QStringLiteral("Zone or section"),
                                    QStringLiteral("Power to current, kW/A"),
                                    QStringLiteral("Idle value"), QStringLiteral("Note")};
        QCOMPARE(edited, described);
        QCOMPARE(model.index(0, int(heads.indexOf(QStringLiteral("Samples")))).data().toString(),
                 QLocale().toString(qulonglong(desk.measured()->traces[0].values.size())));
    }

    /// Without parts to compare, the sentence stands below that of the traces.
    void aCycleThatTheCalibrationHasNotUsedIsPredicted() {
        const Desk desk;
        QVERIFY(desk.opened);
        const Project project = traced::heldOut();
        const QStringList sentences = MeasuredText::holdOut(project, holdOut(project));
        QCOMPARE(sentences.size(), 1);
        QVERIFY2(sentences.front().startsWith(
                     QStringLiteral("Not used for the calibration, second.csv: time from ")),
                 qPrintable(sentences.front()));
        desk.bench.window->document().startUntitled(project);
        const auto* notice = desk.view->findChild<QLabel*>(QStringLiteral("measuredNotice"));
        QTRY_VERIFY_WITH_TIMEOUT(notice->text().contains(sentences.front()), patience_ms);
        // Both verdicts have their sentence.
        HoldOutRow row{0, HoldOutQuantity::time, 10.5, 10.2, {10, 10.6}, {-0.1, 0.5}};
        QVERIFY(MeasuredText::holdOut(project, {row})
                    .front()
                    .endsWith(QStringLiteral(
                        ": 10.5 s, predicted 10.2 (10.0…10.6). The prediction agrees.")));
        row.difference95 = {0.1, 0.5};
        QVERIFY(MeasuredText::holdOut(project, {row})
                    .front()
                    .endsWith(QStringLiteral(": 10.5 s, predicted 10.2 (10.0…10.6). The prediction "
                                             "does not agree: the difference is 0.100…0.500 s.")));
    }

    void rowsAreRemoved() {
        const Desk desk;
        QVERIFY(desk.opened);
        QApplication::clipboard()->setText(
            QStringLiteral("part\tdiameter, mm\n1\t29.99\n2\t29.98\n3\t29.97\n"));
        DialogAnswers answers({QStringLiteral("importGo")});
        answers.seen = [](QDialog& dialog) { QVERIFY(isRead(dialog)); };
        desk.click("measuredPaste");
        desk.part<QComboBox>("measuredSheet").setCurrentIndex(MeasuredView::parts);
        auto& table = desk.part<CopyTable>("measuredParts");
        table.setCurrentIndex(table.model()->index(1, 0));
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_Delete, Qt::ControlModifier);
        QCOMPARE(desk.measured()->parts.size(), 2U);
        QCOMPARE(desk.measured()->parts[1].part, std::string("3"));
    }

    /// A form without the machine's own is not compared: no box, and no figure that would be a
    /// zero.
    void aPredictedFormWithoutTheMachinesIsNoZero() {
        const Desk desk;
        QVERIFY(desk.opened);
        Project project = desk.bench.window->document().project();
        AdequacyRow row;
        row.measured.quantity = MeasuredQuantity::roundness;
        row.measured.values = {1.5, 1.6, 1.7, 1.8, 1.9};
        PredictedRange& predicted = row.predicted.emplace();
        predicted.high = 0.004;
        QVERIFY(!isRoundnessKnown(*project.machine));
        QCOMPARE(MeasuredText::predicted(project, row), QStringLiteral("–"));
        predicted.low = 0.7;
        QCOMPARE(MeasuredText::predicted(project, row), QStringLiteral("≥ 0.70"));
        const auto boxes = [&] {
            return MeasuredBoxes::chart(project, {row}, MeasuredQuantity::roundness).boxes.size();
        };
        predicted.count = 1;
        QCOMPARE(boxes(), 1U);
        project.machine->form.emplace().roundness_um.emplace();
        QVERIFY(isRoundnessKnown(*project.machine));
        QCOMPARE(boxes(), 2U);
        QVERIFY(MeasuredText::predicted(project, row).startsWith(QStringLiteral("0.7")));
    }

    void theOverviewShowsMeasuredDiametersBesideTheBatch() {
        const Desk desk;
        QVERIFY(desk.opened);
        Project project = desk.bench.window->document().project();
        Measured& measured = project.measured.emplace();
        for (int part = 0; part < 5; ++part) {
            MeasuredPart one;
            one.part = std::to_string(part);
            one.place = 1;
            one.diameters_mm = {29.99 + part * 0.001};
            measured.parts.push_back(std::move(one));
        }
        desk.bench.window->document().edit(project, {"Edit", "Import measurements"});
        QVERIFY(desk.bench.window->showView(QStringLiteral("batch")));
        auto* overview = desk.bench.window->findChild<OverviewView*>();
        const auto& chart = overview->tile(OverviewChart::boxes)->plot()->chart();
        QVERIFY(desk.bench.window->showView(QStringLiteral("overview")));
        QTRY_COMPARE_WITH_TIMEOUT(chart.boxes.size(), 4U, patience_ms);
        QCOMPARE(chart.boxKinds.size(), 2U);
        QCOMPARE(chart.boxes[2].kind, 1U); // behind the predicted NZ
        QVERIFY(std::abs(chart.boxes[2].median - (-8)) < 1e-6);
    }
};

} // namespace sparkout::test_measured_view

SPARKOUT_TEST(test_measured_view, TestMeasuredView)
#include "test_measured_view.moc"
