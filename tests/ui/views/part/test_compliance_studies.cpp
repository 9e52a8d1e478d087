// SPDX-License-Identifier: GPL-3.0-or-later
// "Position of the gauge" and "coupled against independent" in the view "Compliance".
#include "core/process/system_compliance.h"
#include "core/simulation/simulate.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/session/project_io.h"
#include "ui/text/names.h"
#include "ui/views/part/compliance_curves.h"
#include "ui/views/part/compliance_plot.h"
#include "ui/views/part/compliance_view.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include <cmath>

namespace sparkout::test_compliance_studies {

/// A stepped shaft between centres, ground by plunge in sections that can be coupled.
Project steppedShaft() {
    Project project = exampleProject("plunge-shaft-two-stage");
    project.machine->compliance_mm_per_n = std::monostate{};
    project.machine->stiffness_n_um = Stiffness{15, 5, 50}; // soft, and unlike at its ends
    project.cycle->stages.back().radial_feed_mm_min = 0.4;
    project.part->shaft.segments = {{60, 25}, {60, 40}, {50, 25}};
    project.part->shaft.ground_from_mm = 70;
    project.gauge->section = 3;
    return project;
}

/// One that takes its time: with a wheel contact that yields each radius is solved by itself.
Project slowShaft() {
    Project project = steppedShaft();
    project.sections = 40;
    project.sections_coupled = true;
    project.machine->wheel_contact = WheelContact{std::vector<std::vector<double>>{{100, 50}}};
    return project;
}

/// The greatest distance of a diameter from the middle of the field [µm], by the engine.
double farthest_um(const SimulationResult& result) {
    const Part& part = *result.project.part;
    const double middle = (part.upper_deviation_um + part.lower_deviation_um) / 2;
    double farthest = 0;
    for (const SectionResult& section : result.sections) {
        farthest = std::max({farthest, std::abs(section.diameterDeviationMin_mm * 1000 - middle),
                             std::abs(section.diameterDeviationMax_mm * 1000 - middle)});
    }
    return farthest;
}

/// The whole window with a project, the view in front.
struct Window {
    explicit Window(const Project& project, const char* language = "en")
        : bench(QString::fromLatin1(language)) {
        QSignalSpy shown(bench.window.get(), &MainWindow::outcomeShown);
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(shown.count() > 0 && bench.window->studies().outcome->ran());
        QVERIFY(bench.window->showView(QStringLiteral("compliance")));
        view = bench.window->findChild<ComplianceView*>();
        bench.settle();
    }
    /// Chooses by keyboard what stands below, and waits until it is there.
    void choose(ComplianceContent content) {
        auto* box = view->findChild<QComboBox*>(QStringLiteral("complianceContent"));
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < static_cast<int>(content); ++i) {
            QTest::keyClick(box, Qt::Key_Down);
        }
        QCOMPARE(plot().content(), content);
        QTRY_VERIFY_WITH_TIMEOUT(
            !label("complianceSummary").text().startsWith(QStringLiteral("Computing")), 20000);
        bench.settle();
    }
    [[nodiscard]] CompliancePlot& plot() { return *view->plot(); }
    [[nodiscard]] std::vector<XY> pointsOf(int key) {
        const ChartSeries* const of = plot().chart().find(key);
        return of ? of->points : std::vector<XY>();
    }
    [[nodiscard]] QLabel& label(const char* name) {
        return *view->findChild<QLabel*>(QString::fromLatin1(name));
    }
    [[nodiscard]] QPushButton& put() {
        return *view->findChild<QPushButton*>(QStringLiteral("putGauge"));
    }
    Bench bench;
    ComplianceView* view = nullptr;
};

class TestComplianceStudies : public QObject {
    Q_OBJECT

private slots:
    void theMarkedPlaceIsTheLeastOfTheCurveAndTheEnginesOwn() {
        Window window(steppedShaft());
        window.choose(ComplianceContent::gauge);
        const GaugeCurves& gauge = window.plot().gauge();
        const GaugePosition* best = gauge.best();
        QVERIFY(best);
        const std::vector<XY> curve = window.pointsOf(GaugeCurves::farthestKey);
        QVERIFY(curve.size() > 20);
        QVERIFY(window.pointsOf(ComplianceCurves::sumKey).empty());
        const double least = std::ranges::min_element(curve, {}, &XY::y)->y;
        const std::vector<XY> marked = window.pointsOf(GaugeCurves::bestKey);
        QCOMPARE(marked.size(), std::size_t{1});
        QCOMPARE(marked[0].y, least);
        QCOMPARE(marked[0].x, best->position_mm);
        Project there = steppedShaft();
        there.gauge->section.reset();
        there.gauge->position_mm = best->position_mm;
        QVERIFY(std::abs(farthest_um(simulate(there)) - least) < 1e-9);
        QVERIFY(least < farthest_um(simulate(steppedShaft()))); // there was something to gain
        QVERIFY(std::abs(window.pointsOf(GaugeCurves::presentKey).at(0).y
                         - farthest_um(simulate(steppedShaft())))
                < 1e-9);
    }

    void thePlaceIsTakenAsOneStepOfTheHistory() {
        Window window(steppedShaft());
        window.choose(ComplianceContent::gauge);
        QVERIFY(window.put().isVisible() && window.put().isEnabled());
        const double best = window.plot().gauge().best()->position_mm;
        const double promised = window.plot().gauge().farthest_um(*window.plot().gauge().best());
        QSignalSpy shown(window.bench.window.get(), &MainWindow::outcomeShown);
        window.put().setFocus();
        QTest::keyClick(&window.put(), Qt::Key_Space);
        Document& document = window.bench.window->document();
        QVERIFY(document.project().gauge->position_mm == best);
        QVERIFY(!document.project().gauge->section);
        QTRY_VERIFY(shown.count() > 0);
        QVERIFY(std::abs(farthest_um(window.bench.window->studies().outcome->result) - promised)
                < 1e-9);
        QTRY_VERIFY(window.pointsOf(GaugeCurves::presentKey).size() == 1
                    && window.pointsOf(GaugeCurves::presentKey)[0].x == best);
        QTRY_VERIFY(!window.put().isEnabled()); // it is there
        document.undo();
        QVERIFY(document.project().gauge->section == 3);
        QVERIFY(!document.canUndo());
    }

    /// The curve of a section has its own name and its own numbers, in the legend and the table.
    void eachCurveIsNamedAfterItsSection() {
        const Project project = steppedShaft();
        Window window(project);
        window.choose(ComplianceContent::gauge);
        const GaugeCurves& gauge = window.plot().gauge();
        const LegendEntries entries = window.plot().legendEntries();
        QStringList names;
        for (const LegendEntry& entry : entries) {
            names << entry.text;
        }
        const CsvTable table = window.plot().table();
        const auto& positions = gauge.placement()->positions;
        const double middle =
            (project.part->upper_deviation_um + project.part->lower_deviation_um) / 2;
        const qsizetype sections = project.sections;
        QCOMPARE(sections, qsizetype{4});
        for (qsizetype j = 0; j < sections; ++j) {
            const QString name = Names::zone(Zone::section, static_cast<int>(j));
            QVERIFY2(name.contains(QString::number(j + 1)), qPrintable(name));
            QCOMPARE(names.count(name), 1);
            const qsizetype column = table.header.size() - sections + j;
            QVERIFY2(table.header[column].contains(name), qPrintable(table.header[column]));
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const double mean_um =
                    positions[i].meanDeviations_mm[static_cast<std::size_t>(j)] * 1000;
                const double shown =
                    std::get<double>(table.rows[i][static_cast<std::size_t>(column)]);
                QVERIFY(std::abs(shown - (mean_um - middle)) < 1e-9);
            }
        }
        // What is read off at a place names the sections of the smallest and the largest diameter.
        for (const GaugePosition& position : positions) {
            const QString read = window.plot().chart().placeText(position.position_mm);
            const QString smallest =
                Names::zone(Zone::section, static_cast<int>(position.sectionOfMin));
            const QString largest =
                Names::zone(Zone::section, static_cast<int>(position.sectionOfMax));
            QVERIFY(smallest != largest);
            const qsizetype first = read.indexOf(u'(' + smallest + u')');
            const qsizetype second = read.indexOf(u'(' + largest + u')');
            QVERIFY2(first > 0 && first < second, qPrintable(read));
        }
    }

    void inTraverseEachZoneIsAskedAndNothingCanBePut() {
        const Project project = exampleProject("shaft-30h6-factory");
        Window window(project);
        window.choose(ComplianceContent::gauge);
        const GaugeCurves& gauge = window.plot().gauge();
        QCOMPARE(gauge.placement()->positions.size(), std::size_t{3});
        QVERIFY(window.put().isVisible() && !window.put().isEnabled());
        QVERIFY(window.label("complianceNotice").isVisible());
        const auto& positions = gauge.placement()->positions;
        const auto least = std::ranges::min_element(
            positions, {}, [&](const GaugePosition& p) { return gauge.farthest_um(p); });
        QCOMPARE(gauge.farthest_um(*gauge.best()), gauge.farthest_um(*least));
        for (const GaugePosition& position : positions) {
            if (position.zone == Zone::nz) { // where it stands
                QVERIFY(std::abs(gauge.farthest_um(position) - gauge.farthestNow_um()) < 1e-9);
            }
        }
        QVERIFY2(
            window.label("complianceSummary")
                .text()
                .contains(QStringLiteral("Best place: %1;").arg(Names::zone(gauge.best()->zone))),
            qPrintable(window.label("complianceSummary").text()));
        // Each zone is a step of its own length.
        const std::vector<XY> curve = window.pointsOf(GaugeCurves::farthestKey);
        QCOMPARE(curve.size(), std::size_t{6});
        QCOMPARE(curve.front().x, 0.0);
        QCOMPARE(curve.back().x, project.part->length_mm);
    }

    void coupledAndIndependentAreDrawnWithTheirDifference() {
        Window window(steppedShaft());
        window.choose(ComplianceContent::coupling);
        const CouplingCurves& coupling = window.plot().coupling();
        QVERIFY(coupling.comparison());
        const std::vector<XY> difference = window.pointsOf(CouplingCurves::differenceKey);
        QCOMPARE(difference.size(), std::size_t(steppedShaft().sections));
        for (std::size_t i = 0; i < difference.size(); ++i) {
            QCOMPARE(difference[i].y, coupling.comparison()->differences_mm[i] * 1000);
        }
        QVERIFY(!window.put().isVisible());
        QCOMPARE(window.plot().table().rows.size(), std::size_t(steppedShaft().sections));
    }

    void whereItDoesNotApplyItIsExplained() {
        for (const char* name : {"shaft-30h6-factory", "plunge-shaft-two-stage"}) {
            Window window(exampleProject(name));
            window.choose(ComplianceContent::coupling);
            QVERIFY2(window.label("complianceNotice").isVisible(), name);
            QVERIFY(window.plot().legendEntries().empty());
            window.choose(ComplianceContent::compliance);
            QVERIFY(!window.pointsOf(ComplianceCurves::usedKey).empty());
        }
    }

    void theNewestProjectWinsAndTheWindowDoesNotWait() {
        Project project = slowShaft();
        Window window(project);
        auto* box = window.view->findChild<QComboBox*>(QStringLiteral("complianceContent"));
        box->setCurrentIndex(static_cast<int>(ComplianceContent::gauge));
        for (int i = 0; i < 5; ++i) {
            const double edit_ms = leastOfTries_ms(200, [&] { // four times 50 ms
                project.part->stock_mm += 0.001;
                RunningTimer clock;
                window.bench.window->document().edit(project, {"Input", "Stock per side"});
                return clock.elapsed();
            });
            QVERIFY2(edit_ms <= 200, qPrintable(QString::number(edit_ms)));
            QTest::qWait(20);
        }
        const Project last = steppedShaft(); // quick
        window.bench.window->document().edit(last, {"Input", "Stock per side"});
        QTRY_VERIFY_WITH_TIMEOUT(window.plot().gauge().placement() != nullptr, 20000);
        QTRY_VERIFY_WITH_TIMEOUT(
            window.label("complianceSummary").text().startsWith(QStringLiteral("Best")), 20000);
        const auto& positions = window.plot().gauge().placement()->positions;
        QCOMPARE(positions.front().meanDeviations_mm.size(), std::size_t(last.sections));
    }

    void whileItIsComputedTheWindowAnswers() {
        Window window(slowShaft());
        auto* box = window.view->findChild<QComboBox*>(QStringLiteral("complianceContent"));
        box->setCurrentIndex(static_cast<int>(ComplianceContent::gauge));
        const double longest_ms = leastOfTries_ms(200, [] {
            double worst_ms = 0;
            QElapsedTimer all, beat;
            all.start();
            while (all.elapsed() < 500) {
                beat.start();
                QCoreApplication::processEvents();
                worst_ms = std::max(worst_ms, double(beat.nsecsElapsed()) * 1e-6);
            }
            return worst_ms;
        });
        QVERIFY2(longest_ms <= 200, qPrintable(QString::number(longest_ms))); // four times 50 ms
        qInfo("longest stall while the gauge is placed: %.1f ms", longest_ms);
        QVERIFY(window.label("complianceSummary").text().startsWith(QStringLiteral("Computing")));
        RunningTimer clock; // closing stops what is being computed
        window.bench.window.reset();
        QVERIFY2(clock.elapsed() < 1000, qPrintable(QString::number(clock.elapsed())));
    }

    void legendsHaveRoomInBothLanguages() {
        for (const char* language : {"en", "ru"}) {
            Window window(steppedShaft(), language);
            for (const int content : {1, 2}) {
                auto* box = window.view->findChild<QComboBox*>(QStringLiteral("complianceContent"));
                box->setCurrentIndex(content);
                QTRY_VERIFY_WITH_TIMEOUT(!window.plot().legendEntries().empty(), 20000);
                window.bench.settle();
                const QStringList tight = textsWithoutRoom(*window.bench.window);
                QVERIFY2(tight.isEmpty(), qPrintable(tight.join(u'\n')));
            }
        }
    }
};

} // namespace sparkout::test_compliance_studies

SPARKOUT_TEST(test_compliance_studies, TestComplianceStudies)
#include "test_compliance_studies.moc"
