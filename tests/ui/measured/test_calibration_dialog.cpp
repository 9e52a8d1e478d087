// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Calibrate from measurements: fitted by clicks, taken as one edit, marked in the forms.
#include "core/measured/calibrated_inputs.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"
#include "tests/ui/measured/calibration_bench.h"
#include "tests/ui/support/languages.h"
#include "ui/chart/chart_plot.h"
#include "ui/form/input_marks.h"
#include "ui/form/number_field.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/kit/font_size.h"
#include "ui/measured/calibration_dialog.h"
#include "ui/report/cycle_card.h"
#include "ui/report/passport.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QStatusBar>

namespace sparkout::test_calibration_dialog {

using namespace calibration_bench;

void click(const QWidget& dialog, const char* name) {
    auto* button = part<QAbstractButton>(dialog, name);
    QVERIFY2(button, name);
    QVERIFY2(button->isVisible() && button->isEnabled(), name);
    if (auto* box = qobject_cast<QCheckBox*>(button)) {
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    } else {
        QTest::mouseClick(button, Qt::LeftButton);
    }
}

/// Fits by a click and waits for the end.
void fit(const QDialog& dialog) {
    click(dialog, "fit");
    const auto* fit = part<QPushButton>(dialog, "fit");
    QTRY_VERIFY_WITH_TIMEOUT(fit->isEnabled(), 60'000);
}

const Calibration* recordOf(const Bench& bench, const char* path) {
    return calibrationOf(bench.window->document().project(), path);
}

/// Fits what is proposed and takes it.
void calibrate(const Bench& bench) {
    inDialog(bench, [](QDialog& dialog) {
        fit(dialog);
        click(dialog, "fitTake");
    });
}

class TestCalibrationDialog : public QObject {
    Q_OBJECT

private slots:
    void withoutMeasurementsTheDialogSaysWhatToImport() {
        Bench bench(QStringLiteral("en"));
        bench.window->document().startUntitled(traced::plunge());
        bench.settle();
        inDialog(bench, [](QDialog& dialog) {
            QVERIFY(!part<QPushButton>(dialog, "fit"));
            const auto* words = part<QLabel>(dialog, "calibrationEmpty");
            QVERIFY(words && words->text().contains(QStringLiteral("Import measurements…")));
            QTest::keyClick(&dialog, Qt::Key_Escape);
            QVERIFY(!dialog.isVisible());
        });
        QVERIFY(!bench.window->document().canUndo());
    }

    void whatTheSizeTellsIsFoundTakenAndUndone() {
        Bench bench(QStringLiteral("en"));
        Document& document = bench.window->document();
        document.startUntitled(traced::project());
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [](QDialog& dialog) {
            for (const char* checked : {"trace0", "alpha", "beta", "size_offset", "time_shift"}) {
                QVERIFY2(part<QCheckBox>(dialog, checked)->isChecked(), checked);
            }
            for (const char* unchecked : {"compliance", "flow_stress", "chip_power"}) {
                QVERIFY2(!part<QCheckBox>(dialog, unchecked)->isChecked(), unchecked);
            }
            QVERIFY(!part<QPushButton>(dialog, "fitTake")->isEnabled());
            fit(dialog);
            QVERIFY(part<QTableView>(dialog, "fitValues")->isVisible());
            QCOMPARE(part<QTableView>(dialog, "fitValues")->model()->rowCount(), 4);
            const double alpha = QLocale().toDouble(cellOf(dialog, "fitValues", 0, 1));
            QVERIFY2(std::abs(alpha - traced::yields) < 0.05, qPrintable(QString::number(alpha)));
            QVERIFY(cellOf(dialog, "fitValues", 0, 2).contains(u'…'));
            QCOMPARE(part<QTableView>(dialog, "fitCorrelations")->model()->rowCount(), 4);
            QCOMPARE(part<QTableView>(dialog, "fitResiduals")->model()->rowCount(), 1);
            QVERIFY(cellOf(dialog, "fitResiduals", 0, 0).contains(QStringLiteral("cycle-17.csv")));
            QVERIFY(part<QLabel>(dialog, "fitNormality")->isVisible());
            const ChartPlot* const left = part<ChartPlot>(dialog, "fitPlot");
            QVERIFY(left->isVisible());
            QVERIFY(left->chart().series.at(0).points.size() > 10);
            QCOMPARE(left->chart().values().low, -left->chart().values().high);
            QCOMPARE(left->across().label(), QStringLiteral("Time of the trace, s"));
            click(dialog, "fitTake");
            QVERIFY(!dialog.isVisible());
        });
        const Calibration* const first = recordOf(bench, "/machine/compliance_mm_per_n/0");
        QVERIFY(first && recordOf(bench, "/machine/compliance_mm_per_n/1"));
        QVERIFY(recordOf(bench, "/wheel/dullness"));
        QVERIFY2(std::abs(first->value / traced::gamma - traced::yields) < 0.05,
                 qPrintable(QString::number(first->value)));
        QCOMPARE(QString::fromStdString(first->data), QStringLiteral("cycle-17.csv"));
        QVERIFY(first->low && *first->low<first->value&& * first->high> first->value);
        QVERIFY(hasCalibratedValue(document.project(), *first));
        QStringList said;
        for (const QLabel* label : bench.window->statusBar()->findChildren<QLabel*>()) {
            said << label->text();
        }
        said << bench.window->statusBar()->currentMessage();
        QVERIFY2(said.join(u'|').contains(QStringLiteral("Undo reverts it")),
                 qPrintable(said.join(u'|')));
        QVERIFY(document.undoText().contains(QStringLiteral("Calibrate from measurements")));
        bench.action("undo")->trigger();
        QVERIFY(!recordOf(bench, "/machine/compliance_mm_per_n/0"));
        const auto& given =
            std::get<std::vector<double>>(document.project().machine->compliance_mm_per_n);
        QCOMPARE(given.front(), traced::gamma);
        QVERIFY(!document.canUndo()); // it was one edit
    }

    void whatTheDataCannotTellIsNamedAndLeftOut() {
        Bench bench(QStringLiteral("en"));
        bench.window->document().startUntitled(traced::project());
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [](QDialog& dialog) {
            for (const char* name : {"alpha", "beta", "compliance", "flow_stress"}) {
                click(dialog, name); // the first two off, the others on
            }
            fit(dialog);
            const QString words = part<QLabel>(dialog, "fitWords")->text();
            QVERIFY2(words.contains(QStringLiteral("compliance"))
                         && words.contains(QStringLiteral("flow stress"))
                         && words.contains(QStringLiteral("power")),
                     qPrintable(words));
            QVERIFY(!part<QPushButton>(dialog, "fitTake")->isEnabled());
            QVERIFY(!part<QTableView>(dialog, "fitValues")->isVisible());
            click(dialog, "fitLeaveOut");
            const bool compliance = part<QCheckBox>(dialog, "compliance")->isChecked();
            const bool flow = part<QCheckBox>(dialog, "flow_stress")->isChecked();
            QVERIFY(compliance != flow);
            fit(dialog);
            QVERIFY(part<QTableView>(dialog, "fitValues")->isVisible());
        });
    }

    /// A power in a wrong unit: a good fit with factors that are never so large, and whose friction
    /// no project may have.
    void valuesThatWouldBeRefusedAreNotTaken() {
        Bench bench(QStringLiteral("en"));
        Project project = traced::project(true);
        constexpr double wrong = 50;
        MeasuredTrace& power = project.measured->traces.back();
        std::vector<double> values = power.values.values();
        for (double& value : values) {
            value *= wrong;
        }
        power.values = Samples(values);
        *power.idle *= wrong;
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [](QDialog& dialog) {
            fit(dialog);
            QVERIFY(part<QTableView>(dialog, "fitValues")->isVisible());
            const QString fault = part<QLabel>(dialog, "fitFault")->text();
            QVERIFY2(fault.contains(QStringLiteral("cannot be applied"))
                         && fault.contains(QStringLiteral("Friction")),
                     qPrintable(fault));
            const QString words = part<QLabel>(dialog, "fitWords")->text();
            QVERIFY2(words.contains(QStringLiteral("Not to be used: the model does not fit"))
                         && words.contains(QStringLiteral("; usual: 0.25…4.")),
                     qPrintable(words));
            QVERIFY(!part<QPushButton>(dialog, "fitTake")->isEnabled());
        });
        QVERIFY(!bench.window->document().canUndo());
    }

    /// The gauge drifts to and fro, slowly, as no parameter of the cycle does.
    void valuesOfAModelThatDoesNotFitAreShownAndNotTaken() {
        Bench bench(QStringLiteral("en"));
        Project project = traced::project();
        MeasuredTrace& size = project.measured->traces.front();
        std::vector<double> values = size.values.values();
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] += 3e-3 * std::sin(size.time_s[i] / 2);
        }
        size.values = Samples(std::move(values));
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [](QDialog& dialog) {
            fit(dialog);
            const QString words = part<QLabel>(dialog, "fitWords")->text();
            QVERIFY2(words.contains(QStringLiteral("the model does not fit"))
                         && words.contains(QStringLiteral("Does not fit: ")),
                     qPrintable(words));
            QVERIFY(!part<QPushButton>(dialog, "fitTake")->isEnabled());
        });
        QVERIFY(!bench.window->document().canUndo());
    }

    /// The cycle begins a tenth of a second into the recording: with that fitted the values are
    /// taken.
    void aTimeLeftOutIsFittedBeforeTheValuesAreTaken() {
        Bench bench(QStringLiteral("en"));
        bench.window->document().startUntitled(traced::project(false, 0.1));
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [](QDialog& dialog) {
            click(dialog, "time_shift"); // off
            fit(dialog);
            const QString words = part<QLabel>(dialog, "fitWords")->text();
            QVERIFY2(words.contains(QStringLiteral("Not to be used: the model does not fit"))
                         && words.contains(QStringLiteral("Left out: ")),
                     qPrintable(words));
            QVERIFY(part<QTableView>(dialog, "fitValues")->isVisible());
            QVERIFY(part<QPushButton>(dialog, "fitTimes")->isVisible());
            QVERIFY(!part<QPushButton>(dialog, "fitTake")->isEnabled());
            const QString fault = part<QLabel>(dialog, "fitFault")->text();
            QVERIFY2(fault.contains(QStringLiteral("Fit it too")), qPrintable(fault));
            click(dialog, "time_shift");
            fit(dialog);
            QVERIFY(!part<QPushButton>(dialog, "fitTimes")->isVisible());
            QVERIFY(part<QPushButton>(dialog, "fitTake")->isEnabled());
        });
    }

    void aReadingOverRangeIsNamed() {
        Bench bench(QStringLiteral("en"));
        Project project = traced::project();
        MeasuredTrace& size = project.measured->traces.front();
        std::vector<double> values = size.values.values();
        values[values.size() / 3] = 9.999;
        size.values = Samples(std::move(values));
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [](QDialog& dialog) {
            fit(dialog);
            const QString words = part<QLabel>(dialog, "fitWords")->text();
            QVERIFY2(words.contains(QStringLiteral("Over range: size at the gauge, cycle-17.csv"))
                         && words.contains(QStringLiteral("9.999 mm at ")),
                     qPrintable(words));
        });
    }

    /// A printed table of means: β and the setting of the gauge are ticked, fitted and taken over.
    void finishedPartsGiveBetaAndTheSetting() {
        Bench bench(QStringLiteral("en"));
        bench.window->document().startUntitled(
            samples::projectIn("resources/examples/shaft-30h6-measured.sparkout"));
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [](QDialog& dialog) {
            QVERIFY(part<QCheckBox>(dialog, "parts")->isChecked());
            QVERIFY(part<QCheckBox>(dialog, "beta")->isChecked());
            QVERIFY(part<QCheckBox>(dialog, "gauge_setting")->isChecked());
            fit(dialog);
            const double beta = QLocale().toDouble(cellOf(dialog, "fitValues", 0, 1));
            const double setting = QLocale().toDouble(cellOf(dialog, "fitValues", 1, 1));
            QVERIFY2(beta > 8.2 && beta < 8.8, qPrintable(QString::number(beta)));
            QVERIFY2(std::abs(setting - 30) < 2e-3, qPrintable(QString::number(setting)));
            click(dialog, "fitTake");
        });
        const Project& taken = bench.window->document().project();
        QVERIFY(std::abs(*taken.part->target_diameter_mm - 30) < 2e-3);
        QVERIFY(taken.wheel->dullness > 0.16);
        QVERIFY(bench.window->document().canUndo());
    }

    void aValueKnownBeforeIsTypedAndTakesPart() {
        Bench bench(QStringLiteral("en"));
        bench.window->document().startUntitled(traced::project());
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [](QDialog& dialog) {
            auto* mean = part<NumberField>(dialog, "alphaMean");
            auto* deviation = part<NumberField>(dialog, "alphaDeviation");
            mean->setFocus();
            QTest::keyClicks(mean, QStringLiteral("1.1"));
            QTest::keyClick(mean, Qt::Key_Tab);
            QTRY_VERIFY(!part<QPushButton>(dialog, "fit")->isEnabled()); // without its deviation
            QVERIFY(part<QLabel>(dialog, "fitFault")
                        ->text()
                        .contains(QStringLiteral("standard deviation")));
            deviation->setFocus();
            QTest::keyClicks(deviation, QStringLiteral("0.0001"));
            QTest::keyClick(deviation, Qt::Key_Tab);
            QTRY_VERIFY(part<QPushButton>(dialog, "fit")->isEnabled());
            fit(dialog);
            const double alpha = QLocale().toDouble(cellOf(dialog, "fitValues", 0, 1));
            QVERIFY2(std::abs(alpha - 1.1) < 0.01, qPrintable(QString::number(alpha)));
        });
    }

    void theMarkTellsTheCalibratedValueFromAnother() {
        Bench bench(QStringLiteral("en"));
        Document& document = bench.window->document();
        document.startUntitled(traced::project());
        QTRY_VERIFY(!bench.window->runs().running());
        calibrate(bench);
        bench.window->inputs().focusPath("/wheel/dullness");
        bench.settle();
        auto* field =
            bench.window->inputs().findChild<NumberField*>(QStringLiteral("/wheel/dullness"));
        QVERIFY(field && field->isVisible());
        const auto mark = [&]() -> const CalibratedMark* {
            for (const auto* one : bench.window->inputs().findChildren<CalibratedMark*>()) {
                if (one->isVisible()) {
                    return one;
                }
            }
            return nullptr;
        };
        QVERIFY(mark() && mark()->holds());
        const QString tip = mark()->toolTip();
        QVERIFY2(tip.contains(QStringLiteral("calibrated on cycle-17.csv (n = "))
                     && tip.contains(QStringLiteral("95\u00a0% interval: ")),
                 qPrintable(tip));
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, QStringLiteral("0.5"));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(document.project().wheel->dullness, 0.5);
        bench.settle();
        QVERIFY(mark() && !mark()->holds());
        QVERIFY(mark()->toolTip().startsWith(QStringLiteral("no longer the value calibrated on")));
        bench.action("undo")->trigger();
        bench.settle();
        QVERIFY(mark() && mark()->holds());
    }

    void cardAndPassportListWhatIsCalibrated() {
        Bench bench(QStringLiteral("en"));
        bench.window->document().startUntitled(traced::project());
        QTRY_VERIFY(!bench.window->runs().running());
        const auto tableIn = [](const report::Report& report) {
            bool next = false;
            for (const report::Block& block : report.blocks) {
                if (const auto* heading = std::get_if<report::Heading>(&block)) {
                    next = heading->text == QStringLiteral("Calibrated inputs");
                } else if (const auto* table = std::get_if<report::Table>(&block); table && next) {
                    return *table;
                }
            }
            return report::Table();
        };
        const OutcomePtr before = bench.window->studies().outcome;
        QVERIFY(tableIn(report::CycleCard::write(before, {}, QDate(2026, 11, 26))).rows.empty());
        QVERIFY(report::OutcomeRemarks::estimates(*before).join(u'\n').contains(
            QStringLiteral("dullness")));
        calibrate(bench);
        QTRY_VERIFY(bench.window->studies().outcome != before && !bench.window->runs().running());
        const OutcomePtr after = bench.window->studies().outcome;
        const report::Table card =
            tableIn(report::CycleCard::write(after, {}, QDate(2026, 11, 26)));
        QCOMPARE(card.rows.size(), std::size_t{3}); // two sections' compliance, dullness
        QVERIFY(card.rows.front().contains(QStringLiteral("cycle-17.csv")));
        report::Subject subject;
        subject.outcome = after;
        subject.date = QDate(2026, 11, 26);
        QCOMPARE(tableIn(report::passport(subject)).rows, card.rows);
        const QString estimates = report::OutcomeRemarks::estimates(*after).join(u'\n');
        QVERIFY2(!estimates.contains(QStringLiteral("dullness"))
                     && !estimates.contains(QStringLiteral("compliance"))
                     && estimates.contains(QStringLiteral("flow stress")),
                 qPrintable(estimates));
    }

    void raAndStrengthsAreTakenFromTheSecondTab() {
        Bench bench(QStringLiteral("en"));
        Project project = traced::plunge();
        project.wheel->grain_surface_energy_j_m2 = 20;
        project.wheel->grain_modulus_gpa = 400;
        project.wheel->bond_surface_energy_j_m2 = 10;
        project.wheel->bond_modulus_gpa = 60;
        project.measured.emplace().parts.resize(2);
        for (MeasuredPart& one : project.measured->parts) {
            one.part = "1";
            one.roughness_ra_um = 0.8;
        }
        Document& document = bench.window->document();
        document.startUntitled(project);
        QTRY_VERIFY(!bench.window->runs().running());
        const auto toWheel = [](const QDialog& dialog) {
            QTabBar* bar = part<QTabWidget>(dialog, "calibrationTabs")->tabBar();
            QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(1).center());
        };
        inDialog(bench, [&](QDialog& dialog) {
            toWheel(dialog);
            click(dialog, "roughnessTake");
        });
        QVERIFY(recordOf(bench, "/wheel/roughness_factor"));
        QVERIFY(document.project().wheel->roughness_factor != project.wheel->roughness_factor);
        inDialog(bench, [&](QDialog& dialog) {
            toWheel(dialog);
            QVERIFY(!part<QPushButton>(dialog, "strengthsTake")->isEnabled());
            auto* value = part<NumberField>(dialog, "limitValue");
            value->setFocus();
            QTest::keyClicks(value, QStringLiteral("150"));
            QTest::keyClick(value, Qt::Key_Tab);
            QTRY_VERIFY(part<QPushButton>(dialog, "strengthsTake")->isEnabled());
            click(dialog, "strengthsTake");
        });
        QVERIFY(recordOf(bench, "/wheel/bond_modulus_gpa"));
        QVERIFY(*document.project().wheel->bond_modulus_gpa != 60);

        // Values that the inputs would refuse are not taken over, and the field is named.
        Project far = project;
        for (MeasuredPart& one : far.measured->parts) {
            one.roughness_ra_um = 99;
        }
        document.startUntitled(far);
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [&](QDialog& dialog) {
            toWheel(dialog);
            QVERIFY(!part<QPushButton>(dialog, "roughnessTake")->isEnabled());
            QVERIFY(part<QLabel>(dialog, "roughnessFound")
                        ->text()
                        .contains(inputLocation("/wheel/roughness_factor")));
            auto* value = part<NumberField>(dialog, "limitValue");
            value->setFocus();
            QTest::keyClicks(value, QStringLiteral("1e9"));
            QTest::keyClick(value, Qt::Key_Tab);
            QTRY_VERIFY(!part<QLabel>(dialog, "strengthsFound")->text().isEmpty());
            QVERIFY(!part<QPushButton>(dialog, "strengthsTake")->isEnabled());
        });
    }

    void allTextsHaveRoomAndAreTranslated_data() { addLanguagesAndSizes(); }

    void allTextsHaveRoomAndAreTranslated() {
        QFETCH(QString, language);
        QFETCH(int, percent);
        applyFontSize(percent);
        Bench bench(language);
        bench.window->document().startUntitled(traced::project(true));
        QTRY_VERIFY(!bench.window->runs().running());
        inDialog(bench, [&](QDialog& dialog) {
            QVERIFY(dialog.width() <= 1366 && dialog.height() <= 768);
            const auto look = [&](const char* name) {
                bench.settle();
                const QStringList narrow = textsWithoutRoom(dialog);
                QVERIFY2(narrow.isEmpty(), qPrintable(narrow.join(u'\n')));
                if (language == u"ru") {
                    for (const ShownText& shown : textsOf(dialog)) {
                        QString text = shown.text;
                        text.remove(QStringLiteral("cycle-17.csv"));
                        QVERIFY2(englishIn(text).isEmpty(), qPrintable(shown.text));
                    }
                }
                if (const QString to = qEnvironmentVariable("SPARKOUT_PICTURES"); !to.isEmpty()) {
                    dialog.grab().save(QStringLiteral("%1/calibration-%2-%3-%4.png")
                                           .arg(to, language)
                                           .arg(percent)
                                           .arg(QLatin1String(name)));
                }
            };
            look("before");
            fit(dialog);
            look("fitted");
            QTabBar* bar = part<QTabWidget>(dialog, "calibrationTabs")->tabBar();
            QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(1).center());
            look("wheel");
        });
    }
};

} // namespace sparkout::test_calibration_dialog

SPARKOUT_TEST(test_calibration_dialog, TestCalibrationDialog)
#include "test_calibration_dialog.moc"
