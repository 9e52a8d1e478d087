// SPDX-License-Identifier: GPL-3.0-or-later
// The view "Compliance": what it draws is the engine's, the part is to scale, the legend works.
#include "core/file/project_file.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_tools.h"
#include "ui/session/project_io.h"
#include "ui/views/part/compliance_plot.h"
#include "ui/views/part/compliance_view.h"

#include "tests/registry.h"

#include <QLabel>

#include <cmath>

namespace sparkout::test_compliance_view {

OutcomePtr example(const char* name) {
    return evaluate(exampleProject(name), {});
}

/// A view as it stands in the window, with a run drawn.
struct Bench {
    explicit Bench(const OutcomePtr& outcome) {
        view.resize(700, 620);
        view.show();
        show(outcome);
    }
    void show(const OutcomePtr& outcome) {
        fixtures::draw(view, outcome);
        QTest::qWait(20);
    }
    [[nodiscard]] CompliancePlot& plot() { return *view.plot(); }
    [[nodiscard]] QLabel& label(const char* name) {
        return *view.findChild<QLabel*>(QString::fromLatin1(name));
    }
    ComplianceView view;
};

const std::vector<XY>& pointsOf(const CompliancePlot& plot, int key) {
    return plot.chart().find(key)->points;
}

class TestComplianceView : public QObject {
    Q_OBJECT

private slots:
    void theCurveGoesThroughWhatTheZonesAreGroundWith() {
        const OutcomePtr outcome = example("slender-shaft");
        Bench bench(outcome);
        for (const SectionResult& zone : outcome->result.sections) {
            const double used = zone.compliance_mm_per_n * 1e6;
            // Between two of 241 places the curve is taken for straight.
            const auto sum =
                valueAt(pointsOf(bench.plot(), ComplianceCurves::sumKey), zone.position_mm);
            QVERIFY(sum && std::abs(*sum - used) < 1e-3 * used);
        }
        QCOMPARE(pointsOf(bench.plot(), ComplianceCurves::usedKey).size(), std::size_t{3});
    }

    void thePartsAreStackedToTheSum() {
        Bench bench(example("slender-shaft"));
        const std::vector<CompliantPlace>& places = bench.plot().gamma().places();
        QVERIFY(places.size() > 100);
        const std::vector<XY> sum = pointsOf(bench.plot(), ComplianceCurves::sumKey);
        const auto top = [&bench] { // the last of the stack is drawn the last
            int last = -1;
            for (const ChartSeries& of : bench.plot().chart().series) {
                last += of.isArea() && bench.plot().shows(of.key) ? 1 : 0;
            }
            return bench.plot().graph(last)->data();
        };
        QCOMPARE(top()->size(), static_cast<int>(places.size()));
        for (std::size_t i = 0; i < sum.size(); ++i) {
            QVERIFY(std::abs(top()->at(static_cast<int>(i))->value - sum[i].y) <= 1e-12 * sum[i].y);
        }
        // Without the wheel head the stack is lower by 1/j_w everywhere, the sum stays.
        const double before = top()->at(50)->value;
        const double wheelHead = places[50].parts.wheelHead * 1e6;
        bench.plot().toggleCurve(static_cast<int>(CompliancePart::wheelHead));
        QVERIFY(std::abs(before - wheelHead - top()->at(50)->value) <= 1e-12 * before);
        QCOMPARE(pointsOf(bench.plot(), ComplianceCurves::sumKey)[50].y, before);
    }

    void thePartIsDrawnToScale() {
        for (const char* name : {"slender-shaft", "shaft-30h6-factory", "internal-plunge"}) {
            Bench bench(example(name));
            for (const QSize size : {QSize(700, 620), QSize(1200, 500)}) {
                bench.view.resize(size);
                QTest::qWait(20);
                bench.plot().replot();
                const QCPAxisRect& rect = *bench.plot().shaftRect();
                const double x = rect.axis(QCPAxis::atBottom)->range().size() / rect.width();
                const double y = rect.axis(QCPAxis::atLeft)->range().size() / rect.height();
                QVERIFY2(std::abs(x / y - 1) < 1e-9, name);
                QCOMPARE(bench.plot().across().range().lower,
                         rect.axis(QCPAxis::atBottom)->range().lower);
                QCOMPARE(bench.plot().cell().left(), rect.left());
            }
        }
    }

    /// Wherever the wheel stands, and however wide the drawing is.
    void theWordsStandBesideTheWheelAndEachOther_data() {
        addColumns<QString, bool>("file", "fromTailstock");
        for (const char* file : {"slender-shaft", "plunge-shaft-two-stage", "setups/spindle"}) {
            for (const bool fromTailstock : {false, true}) {
                QTest::addRow("%s%s", file, fromTailstock ? " from the tailstock" : "")
                    << QString::fromLatin1(file) << fromTailstock;
            }
        }
        QTest::newRow("bore") << QStringLiteral("through-bore") << false;
    }
    void theWordsStandBesideTheWheelAndEachOther() {
        QFETCH(QString, file);
        QFETCH(bool, fromTailstock);
        Project project = exampleProject(qPrintable(file));
        project.machine->entry_side = fromTailstock ? EntrySide::tailstock : EntrySide::headstock;
        Bench bench(evaluate(project, {}));
        const auto* scene = bench.plot().findChild<ShaftScene*>();
        QVERIFY(scene);
        for (const QSize size : {QSize(560, 420), QSize(700, 620), QSize(1200, 500)}) {
            bench.view.resize(size);
            QTest::qWait(20);
            bench.plot().replot();
            int ofTheHead = 0;
            const std::vector<ShaftScene::Note>& notes = scene->notes();
            QVERIFY(!notes.empty());
            for (std::size_t i = 0; i < notes.size(); ++i) {
                const auto& [place, text] = notes[i];
                const QByteArray where =
                    QStringLiteral("%1 at %2").arg(text).arg(size.width()).toUtf8();
                ofTheHead += text.startsWith(QStringLiteral("wheel head")) ? 1 : 0;
                QVERIFY2(!place.intersects(scene->wheelBox()), where.constData());
                QVERIFY2(QRectF(bench.plot().shaftRect()->rect()).contains(place),
                         where.constData());
                for (std::size_t j = 0; j < i; ++j) {
                    QVERIFY2(!place.intersects(notes[j].place), where.constData());
                }
            }
            QCOMPARE(ofTheHead, 1);
        }
    }

    void givenComplianceIsShownAndSaid() {
        Bench bench(example("shaft-30h6-factory"));
        QVERIFY(bench.plot().gamma().places().empty());
        QVERIFY(bench.label("complianceNotice").isVisible());
        QCOMPARE(pointsOf(bench.plot(), ComplianceCurves::usedKey).size(), std::size_t{3});
        QCOMPARE(bench.plot().table().rows.size(), 3u);
        bench.show(example("slender-shaft"));
        QVERIFY(!bench.label("complianceNotice").isVisible());
        QVERIFY(bench.plot().table().rows.size() > 100);
    }

    /// The part is the same, what yields is another: the axis follows, but not where it was zoomed.
    void anotherRunOfThePartIsInSight() {
        Project project = exampleProject("shaft-30h6-factory");
        Bench bench(evaluate(project, {}));
        const QCPAxis& axis = bench.plot().up();
        const auto yieldTimes = [&](double factor) {
            Project other = project;
            auto& gamma = std::get<ZoneCompliance>(other.machine->compliance_mm_per_n);
            for (double* zone : {&gamma.rz1, &gamma.nz, &gamma.rz2}) {
                *zone *= factor;
            }
            bench.show(evaluate(other, {}));
            ChartSpan drawn;
            for (const XY& zone : pointsOf(bench.plot(), ComplianceCurves::usedKey)) {
                drawn.add(zone.y);
            }
            return drawn;
        };
        for (const double factor : {2.4, 0.1, 1.0}) {
            const ChartSpan drawn = yieldTimes(factor);
            QVERIFY2(axis.range().contains(drawn.high) && axis.range().contains(drawn.low)
                         && drawn.high > 0.3 * axis.range().upper,
                     qPrintable(QString::number(factor)));
        }
        const QCPRange zoomed(100, 130);
        bench.plot().up().setRange(zoomed);
        (void)yieldTimes(2.4);
        QCOMPARE(axis.range().lower, zoomed.lower);
        QCOMPARE(axis.range().upper, zoomed.upper);
    }

    void aBoreYieldsAlikeAllAlong() {
        Bench bench(example("internal-plunge"));
        const std::vector<XY>& sum = pointsOf(bench.plot(), ComplianceCurves::sumKey);
        QVERIFY(sum.size() > 2);
        QCOMPARE(sum.front().y, sum.back().y);
        QVERIFY(bench.label("complianceSummary").text().contains(QStringLiteral("Uniform")));
    }

    void theMouseReadsValuesAndTheLegendHides() {
        Bench bench(example("slender-shaft"));
        QTest::mouseMove(&bench.plot(), bench.plot().cell().center());
        QTRY_VERIFY(bench.label("complianceValues").text().contains(QStringLiteral("nm/N")));
        auto* legend = bench.view.findChild<LegendStrip*>();
        const int last = static_cast<int>(legend->entries().size()) - 1;
        QCOMPARE(legend->entries()[static_cast<std::size_t>(last)].key, ComplianceCurves::usedKey);
        QTest::mouseClick(legend, Qt::LeftButton, {}, legend->entryRect(last).center());
        QVERIFY(!bench.plot().shows(ComplianceCurves::usedKey));
        const QCPRange before = bench.plot().across().range();
        bench.view.tools()->navigation().zoom(0.5);
        QVERIFY(bench.plot().across().range().size() < before.size());
        bench.view.tools()->fit->trigger();
        QTRY_VERIFY(std::abs(bench.plot().across().range().size() - before.size())
                    < 1e-6 * before.size());
    }
};

} // namespace sparkout::test_compliance_view

SPARKOUT_TEST(test_compliance_view, TestComplianceView)
#include "test_compliance_view.moc"
