// SPDX-License-Identifier: GPL-3.0-or-later
// The view "Zone profiles", worked with mouse and keys: cells, moments, sections.
#include "tests/registry.h"
#include "tests/ui/support/typing.h"
#include "tests/ui/views/part/profiles_bench.h"
#include "ui/text/names.h"

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

namespace sparkout::test_profiles_view {

using namespace profiles_bench;

class TestProfilesView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_of.ran()); }

    // --- across the axis ------------------------------------------------------------------------

    void eachZoneHasItsCellWithRingTargetAndProfile() {
        ShownProfiles view(m_of.traverse);
        ProfilesPlot* plot = view.across();
        QCOMPARE(plot->axisRectCount(), 3);
        const double times = plot->magnification();
        for (int i = 0; i < 3; ++i) {
            const double target = plot->series().target_mm;
            QCOMPARE(plot->target(i)->radius(), target);
            QVERIFY(std::abs(plot->field(i)->inner() - (target - 0.004 * times)) < 1e-6);
            QVERIFY(std::abs(plot->field(i)->outer() - (target + 0.004 * times)) < 1e-6);
            const auto data = plot->curve(i, ProfileLine::profile)->data();
            QCOMPARE(data->size(), 37);
            const double radius =
                m_of.traverse->result.sections[static_cast<std::size_t>(i)].radii_mm[0];
            QVERIFY(std::abs(data->at(0)->key - (target + times * (radius - target))) < 1e-9);
            QVERIFY(!plot->curve(i, ProfileLine::blank)->visible());
        }
    }

    void circlesStayRoundAtAnyWindowSize() {
        ShownProfiles view(m_of.plunge);
        for (const QSize size :
             {QSize(700, 620), QSize(1300, 500), QSize(480, 900), QSize(700, 620)}) {
            view.resize(size);
            settle();
            QVERIFY(sameScaleEverywhere(view.across(), 4));
            // The whole field is in sight in every cell.
            const double outer = view.across()->field(0)->outer();
            for (int i = 0; i < 4; ++i) {
                for (double angle = 0; angle < 6; angle += 0.5) {
                    QVERIFY(view.across()->cell(i)->rect().contains(
                        pixelOf(view.across(), i, outer, angle).toPoint()));
                }
            }
        }
    }

    void theWheelZoomsAllCellsAlike() {
        ShownProfiles view(m_of.traverse);
        ProfilesPlot* plot = view.across();
        const double before = pixelsPerUnit(plot->cell(2)->axis(QCPAxis::atLeft));
        wheel(plot, plot->cell(0)->rect().center(), 240);
        QVERIFY(pixelsPerUnit(plot->cell(2)->axis(QCPAxis::atLeft)) > before * 1.2);
        QVERIFY(sameScaleEverywhere(plot, 3));
        view.resize(1000, 500);
        settle();
        QVERIFY(sameScaleEverywhere(plot, 3));
        QTest::mouseClick(part<QToolButton>(view, "fit"), Qt::LeftButton);
        view.resize(700, 620);
        settle();
        QCOMPARE(pixelsPerUnit(plot->cell(2)->axis(QCPAxis::atLeft)), before);
    }

    void draggingMovesAllCellsAndADoubleClickFits() {
        ShownProfiles view(m_of.traverse);
        ProfilesPlot* plot = view.across();
        const QPoint at = plot->cell(1)->rect().center();
        const QPointF before = pixelOf(plot, 0, 0, 0);
        drag(plot, at, {30, 20});
        const QPointF moved = pixelOf(plot, 0, 0, 0) - before;
        QVERIFY(std::abs(moved.x() - 30) < 1.5 && std::abs(moved.y() - 20) < 1.5);
        QTest::mouseDClick(plot, Qt::LeftButton, {}, at);
        settle();
        QCOMPARE(pixelOf(plot, 0, 0, 0), before);
    }

    void theGridNamesRoundDeviations() {
        ShownProfiles view(m_of.traverse);
        view.grab();
        const QStringList labels = view.across()->grid(0)->drawnLabels();
        QVERIFY2(labels.contains(QStringLiteral("0")), qPrintable(labels.join(u' ')));
        QVERIFY(labels.size() >= 3);
        // 1, 2 or 5 apart.
        QList<double> values;
        for (const QString& label : labels) {
            values << label.toDouble();
        }
        const double step = values[1] - values[0];
        QVERIFY(std::abs(roundDown125(step) - step) < 1e-9 * step);
    }

    void theNumbersOfTheGridStandBesideTheProfile() {
        ProfilesView view;
        for (const QSize size : {QSize(700, 620), QSize(700, 480), QSize(1100, 800)}) {
            show(view, m_of.traverse);
            view.resize(size);
            settle();
            view.grab();
            for (int cell = 0; cell < 3; ++cell) {
                const std::vector<QRectF>& boxes = view.across()->grid(cell)->labelBoxes();
                QVERIFY(boxes.size() >= 2);
                const QCPCurve* profile = view.across()->curve(cell, ProfileLine::profile);
                for (auto at = profile->data()->constBegin(); at != profile->data()->constEnd();
                     ++at) {
                    const QPointF here(profile->keyAxis()->coordToPixel(at->key),
                                       profile->valueAxis()->coordToPixel(at->value));
                    for (const QRectF& box : boxes) {
                        QVERIFY(!box.contains(here));
                    }
                }
            }
        }
    }

    void pointingAtASampleTellsAngleAndDeviation() {
        ShownProfiles view(m_of.plunge);
        auto* values = part<QLabel>(view, "profilesValues");
        const QString before = values->text();
        hover(view.across(), pixelOf(view.across(), 1, 10, angleOf(9, 36) + 0.05));
        const Profile& p = view.across()->series().profiles[1];
        const double deviation = (p.radii_mm[9] - view.across()->series().target_mm) * 1000;
        const double across = (p.radii_mm[9] + p.radii_mm[27] - 30) * 1000;
        for (const QString& piece :
             {QStringLiteral("Section 2"), QStringLiteral("φ = 90.0°"), QStringLiteral("k = 9"),
              Names::fixed(deviation, 3), Names::fixed(across, 3)}) {
            QVERIFY2(values->text().contains(piece), qPrintable(values->text()));
        }
        QVERIFY(view.across()->pointer(1)->shown());
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(view.across(), &leave);
        QVERIFY(!view.across()->pointer(1)->shown());
        QCOMPARE(values->text(), before);
    }

    void keysWalkFromSampleToSample() {
        ShownProfiles view(m_of.plunge);
        auto* values = part<QLabel>(view, "profilesValues");
        QTest::keyClick(view.across(), Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(values->text().contains(QStringLiteral("Section 1, φ = 0.0° (k = 0)")));
        QTest::keyClick(view.across(), Qt::Key_Left, Qt::ControlModifier);
        QVERIFY(values->text().contains(QStringLiteral("k = 35")));
        QTest::keyClick(view.across(), Qt::Key_PageDown);
        QVERIFY(values->text().contains(QStringLiteral("Section 2")));
        QTest::keyClick(view.across(), Qt::Key_Escape);
        QVERIFY(!values->text().contains(QStringLiteral("Section")));
    }

    void pointingAlongTheAxisTellsTheZone() {
        ShownProfiles view(m_of.traverse);
        auto* values = part<QLabel>(view, "profilesValues");
        LongitudinalPlot* plot = view.along();
        const double x = plot->cell()->axis(QCPAxis::atBottom)->coordToPixel(46);
        hover(plot, QPointF(x, plot->cell()->rect().center().y()));
        QVERIFY2(values->text().startsWith(QStringLiteral("NZ, 38.0…54.0 mm")),
                 qPrintable(values->text()));
        QTest::keyClick(plot, Qt::Key_Left, Qt::ControlModifier);
        QVERIFY(values->text().startsWith(QStringLiteral("RZ1")));
    }

    // --- the moment -----------------------------------------------------------------------------

    void theSliderShowsAnyStroke() {
        ShownProfiles view(m_of.traverse);
        auto* slider = part<QSlider>(view, "strokeSlider");
        const int count = m_of.traverse->result.cycleCount;
        QCOMPARE(slider->value(), count);
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Left);
        settle();
        QCOMPARE(view.stroke(), count - 1);
        QTest::mouseClick(part<QToolButton>(view, "previous"), Qt::LeftButton);
        QCOMPARE(view.across()->series().stroke, count - 2);
        auto* number = part<QSpinBox>(view, "stroke");
        typeOver(*number, QStringLiteral("20"));
        QTest::keyClick(number, Qt::Key_Return);
        settle();
        QCOMPARE(view.across()->series().stroke, 20);
        // At stroke 20 the radius is still far above the target.
        const double height = view.along()->graph(LengthLine::mean)->data()->at(0)->value;
        QVERIFY(height > 50 && height < 150);
        QTest::keyClick(slider, Qt::Key_End);
        QVERIFY(view.across()->series().atEnd());
    }

    void theFirstMomentIsTheBlank() {
        ShownProfiles view(m_of.plunge);
        auto* slider = part<QSlider>(view, "strokeSlider");
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Home);
        settle();
        QCOMPARE(view.across()->series().profiles[0].radii_mm, view.across()->series().blank_mm);
        QVERIFY(part<QSpinBox>(view, "stroke")->text().startsWith(QStringLiteral("blank")));
        QVERIFY(!part<QToolButton>(view, "previous")->isEnabled());
    }

    void theMomentOutlivesANewOutcome() {
        ShownProfiles view(m_of.traverse);
        view.setStroke(20);
        Project longer = traverseProject();
        longer.machine->dwell_entry_s = 1;
        show(view, run(longer));
        QCOMPARE(view.across()->series().stroke, 20);
        view.setStroke(100000);
        show(view, m_of.traverse);
        QVERIFY(view.across()->series().atEnd());
    }

    void anUnrecordedCycleShowsItsEnd() {
        ShownProfiles view(run(traverseProject(), false));
        QVERIFY(view.across()->isVisible());
        QVERIFY(view.across()->series().atEnd());
        QVERIFY(!part<QSlider>(view, "strokeSlider")->isEnabled());
        QVERIFY(
            part<QLabel>(view, "profilesNotice")->text().contains(QStringLiteral("only its end")));
    }

    // Wherever they run, also in a low plot: "gauge" beside its line, across none of them.
    void theNameOfTheGaugeStandsBesideTheCurves() {
        ShownProfiles view(m_of.traverse);
        LongitudinalPlot& plot = *view.along();
        QCPAxis* const values = plot.cell()->axis(QCPAxis::atLeft);
        for (const double top : {0.2, 1.0, 3.0, 8.0}) { // µm above the target
            values->setRange(top - 14, top);
            plot.replot(QCustomPlot::rpImmediateRefresh);
            const QCPItemText& name = *plot.gaugeName();
            QVERIFY(name.visible());
            const QRectF box(name.topLeft->pixelPosition(), name.bottomRight->pixelPosition());
            const double x = plot.cell()
                                 ->axis(QCPAxis::atBottom)
                                 ->coordToPixel(view.across()->series().gauge_mm);
            QVERIFY(QRectF(plot.cell()->rect()).adjusted(-1, -1, 1, 1).contains(box));
            QVERIFY(std::min(std::abs(box.left() - x), std::abs(box.right() - x)) <= 8);
            QVERIFY(x < box.left() || x > box.right());
            for (const LengthLine line : {LengthLine::mean, LengthLine::target}) {
                const QCPGraph* const graph = plot.graph(line);
                QVERIFY(graph->visible() && graph->dataCount() > 1);
                for (double at = box.left(); at <= box.right(); ++at) {
                    const double mm = plot.cell()->axis(QCPAxis::atBottom)->pixelToCoord(at);
                    const auto next = graph->data()->findBegin(mm, false);
                    if (next != graph->data()->constEnd()) {
                        const double y = values->coordToPixel(next->value);
                        QVERIFY2(y <= box.top() || y >= box.bottom(),
                                 qPrintable(QString::number(top)));
                    }
                }
            }
        }
        plot.cell()->axis(QCPAxis::atBottom)->setRange(0, 1); // the gauge is out of sight
        plot.replot(QCustomPlot::rpImmediateRefresh);
        QVERIFY(!plot.gaugeName()->visible());
    }

    // --- sections -------------------------------------------------------------------------------

    void atMostFourSectionsAndTheChosenOneAmongThem() {
        ShownProfiles view(m_of.many);
        QCOMPARE(view.across()->axisRectCount(), 4);
        QVERIFY(std::ranges::count(view.across()->shown(), 10) == 1); // the gauge's
        auto* section = part<QComboBox>(view, "section");
        section->setFocus();
        QTest::keyClick(section, Qt::Key_Down);
        QTest::keyClick(section, Qt::Key_Down);
        QTest::keyClick(section, Qt::Key_Down);
        settle();
        QCOMPARE(view.across()->axisRectCount(), 4);
        QVERIFY(std::ranges::count(view.across()->shown(), 2) == 1);
        // The sections drawn above are marked along the axis.
        QCOMPARE(view.along()->bands()->bands().size(), std::size_t{4});
        QCOMPARE(view.along()->graph(LengthLine::mean)->dataCount(), 20);
    }

    void aClickAlongTheAxisChoosesTheSection() {
        ShownProfiles view(m_of.many);
        const QCPAxisRect* rect = view.along()->cell();
        const auto at = [rect](double x_mm) {
            const double x = rect->axis(QCPAxis::atBottom)->coordToPixel(x_mm);
            return QPoint(static_cast<int>(std::lround(x)), rect->center().y());
        };
        QTest::mouseClick(view.along(), Qt::LeftButton, {}, at(15)); // sections are 2 mm long
        settle();
        QVERIFY(std::ranges::count(view.across()->shown(), 7) == 1);
        QCOMPARE(part<QComboBox>(view, "section")->currentData().toInt(), 7);
        drag(view.along(), at(20), {40, 0}); // a drag moves, it chooses nothing
        QCOMPARE(part<QComboBox>(view, "section")->currentData().toInt(), 7);
        QVERIFY(rect->axis(QCPAxis::atBottom)->range().lower < -1.5);
        ShownProfiles few(m_of.plunge);
        QTest::mouseClick(few.along(), Qt::LeftButton, {}, few.along()->cell()->center());
        QCOMPARE(few.across()->axisRectCount(), 4); // all have room already
    }

    void onlyTheChosenSectionIsShownLarge() {
        ShownProfiles view(m_of.many);
        const int before = view.across()->cell(0)->width();
        auto* alone = part<QToolButton>(view, "alone");
        QVERIFY(alone->isVisible() && !alone->isEnabled());
        auto* section = part<QComboBox>(view, "section");
        section->setFocus();
        QTest::keyClick(section, Qt::Key_End);
        QTest::mouseClick(alone, Qt::LeftButton);
        settle();
        QCOMPARE(view.across()->shown(), std::vector<int>{19});
        QVERIFY(view.across()->cell(0)->width() > 2 * before);
    }

    void aZoneChosenIsShownLarge() {
        ShownProfiles view(m_of.traverse);
        QVERIFY(!part<QToolButton>(view, "alone")->isVisible());
        auto* section = part<QComboBox>(view, "section");
        section->setFocus();
        QTest::keyClick(section, Qt::Key_End);
        settle();
        QCOMPARE(view.across()->axisRectCount(), 1);
        QCOMPARE(view.across()->shown(), std::vector<int>{2});
        for (const QSize size : {QSize(560, 620), QSize(800, 620), QSize(1300, 900)}) {
            view.resize(size); // numbers below the circle, or beside it
            settle();
            const QCPAxisRect* rect = view.across()->axisRect(0);
            const double share = double(std::min(rect->width(), rect->height()))
                                 / std::min(view.across()->width(), view.across()->height());
            QVERIFY2(share > 0.5, qPrintable(QStringLiteral("%1 of %2×%3")
                                                 .arg(share)
                                                 .arg(view.across()->width())
                                                 .arg(view.across()->height())));
        }
        QTest::keyClick(section, Qt::Key_Home);
        QCOMPARE(view.across()->axisRectCount(), 3);
    }

    void aChangeOfOperationRebuildsTheCells() {
        ShownProfiles view(m_of.traverse);
        show(view, m_of.plunge);
        QCOMPARE(view.across()->axisRectCount(), 4);
        hover(view.across(), view.across()->cell(3)->rect().center() + QPoint(20, 0));
        show(view, m_of.traverse);
        QCOMPARE(view.across()->axisRectCount(), 3);
        show(view, run(plungeProject(1)));
        QCOMPARE(view.across()->axisRectCount(), 1);
        QCOMPARE(view.along()->graph(LengthLine::mean)->dataCount(), 1);
    }

    void internalGrindingDrawsTheBlankInside() {
        Project p = plungeProject(4);
        p.part->surface = Surface::internal;
        p.wheel->diameter_mm = 20;
        ShownProfiles view(run(p));
        clickLegend(view, QStringLiteral("blank"));
        const auto blank = view.across()->curve(0, ProfileLine::blank)->data();
        const auto profile = view.across()->curve(0, ProfileLine::profile)->data();
        for (int k = 0; k < 36; ++k) {
            QVERIFY(std::hypot(blank->at(k)->key, blank->at(k)->value)
                    < std::hypot(profile->at(k)->key, profile->at(k)->value));
        }
    }

private:
    Cycles m_of;
};

} // namespace sparkout::test_profiles_view

SPARKOUT_TEST(test_profiles_view, TestProfilesView)
#include "test_profiles_view.moc"
