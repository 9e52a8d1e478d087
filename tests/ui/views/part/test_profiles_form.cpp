// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Form in the view "Zone profiles": magnification, reference circles, spectrum.
#include "core/surface/harmonics.h"
#include "core/surface/roundness_readings.h"
#include "tests/registry.h"
#include "tests/ui/support/on_disk.h"
#include "tests/ui/views/part/profiles_bench.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/plot_tools.h"
#include "ui/text/names.h"
#include "ui/views/part/profiles_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QTemporaryDir>

#include <numbers>

namespace sparkout::test_profiles_form {

using namespace profiles_bench;

/// A part with some form left: lobes, and an eccentricity besides by its measured profile.
Project outOfRound() {
    Project p = plungeProject(2);
    p.part->profile = ProfileForm::measured;
    p.part->radii_per_section = 48;
    std::vector<double> radii;
    for (int k = 0; k < 48; ++k) {
        const double phi = angleOf(k, 48);
        radii.push_back(-20 + 8 * std::cos(phi - 0.4) + 7 * std::cos(3 * phi) + k % 5);
    }
    const double highest = *std::ranges::max_element(radii);
    for (double& radius : radii) {
        radius -= highest;
    }
    p.part->radii_um = radii;
    return p;
}

const std::vector<XY>& bars(const ProfilesView& view, std::size_t cell, ProfileLine line) {
    return view.spectrum()->chart(cell).find(static_cast<int>(line))->points;
}

class TestProfilesForm : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_of.ran()); }

    // --- choices --------------------------------------------------------------------------------

    void theBlankLowersTheMagnification() {
        ShownProfiles view(m_of.traverse);
        const double before = view.across()->magnification();
        QCOMPARE(before, 2000.0); // the field of 16 µm on a diameter of 30 mm
        auto* blank = part<QCheckBox>(view, "blank");
        QTest::mouseClick(blank, Qt::LeftButton, {}, QPoint(8, blank->height() / 2));
        settle();
        QVERIFY(view.across()->curve(0, ProfileLine::blank)->visible());
        QVERIFY(view.along()->graph(LengthLine::blankMax)->visible());
        QCOMPARE(view.across()->magnification(), 50.0); // 170 µm above the target
        QVERIFY(view.across()->caption().contains(QStringLiteral("×50,")));
        QVERIFY(
            part<QComboBox>(view, "magnification")->currentText().contains(QStringLiteral("×50")));
        QTest::mouseClick(blank, Qt::LeftButton, {}, QPoint(8, blank->height() / 2));
        QCOMPARE(view.across()->magnification(), before);
    }

    void aMagnificationIsChosenByKeysAndForAll() {
        ShownProfiles view(m_of.traverse);
        auto* box = part<QComboBox>(view, "magnification");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Down);
        QTest::keyClick(box, Qt::Key_Down);
        settle();
        QCOMPARE(box->currentText(), QStringLiteral("×2"));
        QCOMPARE(view.across()->magnification(), 2.0);
        for (int i = 0; i < 3; ++i) {
            const double target = view.across()->series().target_mm;
            QVERIFY(std::abs(view.across()->field(i)->outer() - target - 0.008) < 1e-9);
        }
        // It stays with the next result; automatic takes over again.
        show(view, run(traverseProject()));
        QCOMPARE(view.across()->magnification(), 2.0);
        QTest::keyClick(box, Qt::Key_Home);
        QCOMPARE(view.across()->magnification(), 2000.0);
    }

    void theOwnMeanShowsTheFormLarger() {
        ShownProfiles view(m_of.plunge);
        const double before = view.across()->magnification();
        auto* box = part<QComboBox>(view, "reference");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Down);
        settle();
        QVERIFY(view.across()->magnification() > 2 * before);
        const auto data = view.across()->curve(0, ProfileLine::profile)->data();
        double mean = 0;
        for (int k = 0; k < 36; ++k) {
            mean += std::hypot(data->at(k)->key, data->at(k)->value) / 36;
        }
        QVERIFY(std::abs(mean - view.across()->series().target_mm) < 1e-6);
    }

    void aClickInTheLegendHidesInBothPlots() {
        ShownProfiles view(m_of.traverse);
        clickLegend(view, QStringLiteral("tolerance band"));
        QVERIFY(!view.across()->field(0)->visible());
        QVERIFY(!view.along()->graph(LengthLine::upperLimit)->visible());
        const int index = legendIndex(view, QStringLiteral("tolerance band"));
        QVERIFY(!view.legend()->entries()[static_cast<std::size_t>(index)].shown);
        clickLegend(view, QStringLiteral("tolerance band"));
        QVERIFY(view.across()->field(0)->visible());
        QVERIFY(view.along()->graph(LengthLine::upperLimit)->visible());
        clickLegend(view, QStringLiteral("blank"));
        QVERIFY(part<QCheckBox>(view, "blank")->isChecked());
        QVERIFY(view.across()->curve(2, ProfileLine::blank)->visible());
    }

    void theLeastSquaresCircleFollowsTheProfile() {
        ShownProfiles view(m_of.plunge);
        const auto circle = view.across()->curve(0, ProfileLine::leastSquares)->data();
        const RoundnessZone& fitted = view.across()->series().profiles[0].leastSquares;
        const double target = view.across()->series().target_mm;
        const double times = view.across()->magnification();
        const FittedCircle about{fitted.x_mm, fitted.y_mm, fitted.reference_mm};
        const double drawn = target + times * (radiusOf(about, 0) - target);
        QVERIFY(std::abs(circle->at(0)->key - drawn) < 1e-9);
        QVERIFY(std::abs(circle->at(0)->value) < 1e-9);
        const auto centre = view.across()->centreMark(0)->data();
        QCOMPARE(centre->at(0)->key, times * fitted.x_mm);
        QCOMPARE(centre->at(0)->value, times * fitted.y_mm);
    }

    void theMinimumZoneTouchesInTurn() {
        ShownProfiles view(run(outOfRound()));
        part<QComboBox>(view, "circles")->setCurrentIndex(1);
        settle();
        for (const int stroke : {0, view.stroke() / 2, view.stroke()}) {
            view.setStroke(stroke);
            for (int cell = 0; cell < 2; ++cell) {
                const ProfilesPlot& plot = *view.across();
                const Profile& p = plot.drawn(cell);
                const auto line = plot.curve(cell, ProfileLine::profile)->data();
                const auto outer = plot.curve(cell, ProfileLine::minimumZone)->data();
                const auto inner = plot.innerCircle(cell)->data();
                const int each = (outer->size() - 1) / plot.series().radii();
                const auto reach = [](const QCPCurveDataContainer& curve, int i) {
                    return std::hypot(curve.at(i)->key, curve.at(i)->value);
                };
                const double near = 1e-9 * plot.magnification(); // of a radius
                QList<bool> outside; // which circle is touched, by rising k
                for (int k = 0; k < plot.series().radii(); ++k) {
                    const double here = reach(*line, k);
                    QVERIFY(here <= reach(*outer, k * each) + near);
                    QVERIFY(here >= reach(*inner, k * each) - near);
                    const bool touches =
                        std::ranges::find(p.minimumZone.contacts, static_cast<std::size_t>(k))
                        != p.minimumZone.contacts.end();
                    if (touches) {
                        outside << (std::abs(here - reach(*outer, k * each)) <= near);
                        QVERIFY(outside.back() || std::abs(here - reach(*inner, k * each)) <= near);
                    }
                }
                QCOMPARE(outside.size(), 4);
                QVERIFY(outside[0] != outside[1] && outside[1] != outside[2]
                        && outside[2] != outside[3]);
                QCOMPARE(plot.contacts(cell)->data()->size(), 4);
                QVERIFY(p.minimumZone.deviation() <= p.leastSquares.deviation());
            }
        }
    }

    void theCirclesAreChosen() {
        ShownProfiles view(run(outOfRound()));
        auto* circles = part<QComboBox>(view, "circles");
        const auto seen = [&](ProfileLine line) {
            return view.across()->curve(0, line)->visible();
        };
        const auto lines = [&] { return view.across()->numbers(0).count(u'\n') + 1; };
        QVERIFY(seen(ProfileLine::leastSquares) && !seen(ProfileLine::minimumZone));
        const QString square = view.across()->numbers(0);
        QCOMPARE(lines(), 3);
        circles->setCurrentIndex(1);
        QVERIFY(!seen(ProfileLine::leastSquares) && seen(ProfileLine::minimumZone));
        QVERIFY(view.across()->numbers(0) != square);
        const RoundnessZone& zone = view.across()->drawn(0).minimumZone;
        const double ron_um = std::round(zone.deviation() * 1e5) / 100;
        QVERIFY(view.across()->numbers(0).contains(QLocale().toString(ron_um, 'f', 2).chopped(1)));
        clickLegend(view, QStringLiteral("circles of the minimum zone"));
        QVERIFY(!seen(ProfileLine::minimumZone) && !view.across()->contacts(0)->visible());
        circles->setCurrentIndex(circles->count() - 1);
        QVERIFY(!seen(ProfileLine::leastSquares) && !seen(ProfileLine::minimumZone));
        QCOMPARE(lines(), 2);
    }

    void heldCirclesTouchAndAreStated() {
        ShownProfiles view(run(outOfRound()));
        auto* circles = part<QComboBox>(view, "circles");
        for (const int choice : {2, 3}) {
            circles->setCurrentIndex(choice);
            settle();
            const bool inscribed = choice == 2;
            const Profile& p = view.across()->drawn(0);
            const RoundnessReading expected = roundnessReading(p.radii_mm, std::nullopt);
            const RoundnessZone& zone = inscribed ? *expected.inscribed : *expected.circumscribed;
            const QString ron = Names::fixed(zone.deviation() * 1000, 2);
            QVERIFY2(view.across()->numbers(0).contains(ron),
                     qPrintable(view.across()->numbers(0) + u' ' + ron));
            const ProfileLine line =
                inscribed ? ProfileLine::inscribed : ProfileLine::circumscribed;
            const QCPCurve* circle = view.across()->curve(0, line);
            QVERIFY(circle && circle->visible());
            QCOMPARE(circle->pen().style() == Qt::DotLine, false);
            const auto profile = view.across()->curve(0, ProfileLine::profile)->data();
            const auto reference = circle->data();
            const int each = (reference->size() - 1) / view.across()->series().radii();
            double nearest = 1e9;
            for (int k = 0; k < view.across()->series().radii(); ++k) {
                const auto reach = [](const QCPCurveData* at) {
                    return std::hypot(at->key, at->value);
                };
                const double gap = reach(&*profile->at(k)) - reach(&*reference->at(k * each));
                const double inside = inscribed ? gap : -gap;
                QVERIFY(inside >= -1e-9 * view.across()->magnification());
                nearest = std::min(nearest, inside);
            }
            QVERIFY(nearest <= 1e-9 * view.across()->magnification());
        }
    }

    void theFilterSmoothsWhatIsDrawnAndStated() {
        ShownProfiles view(run(outOfRound()));
        const Profile raw = view.across()->drawn(0);
        const QString before = view.across()->numbers(0);
        auto* filter = part<QComboBox>(view, "filter");
        filter->setFocus();
        QTest::keyClick(filter, Qt::Key_Down);
        settle();
        const Profile& shown = view.across()->drawn(0);
        QCOMPARE(shown.radii_mm,
                 gaussianFiltered(raw.radii_mm, Directions(raw.radii_mm.size()), 15));
        QVERIFY(shown.leastSquares.deviation() < raw.leastSquares.deviation());
        QVERIFY(view.across()->numbers(0) != before);
        QVERIFY(view.across()->caption().contains(QStringLiteral("15 UPR")));
        QCOMPARE(view.across()->series().profiles[0].radii_mm, raw.radii_mm); // the spectrum's
    }

    void aMeasuredProfileStandsBesideThePredicted() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("section.csv"));
        constexpr int points = 359; // odd, and not those of the project
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("angle,deg;deviation,um\n");
        for (int k = 0; k < points; ++k) {
            const double phi = 2 * std::numbers::pi * k / points;
            file.write(QStringLiteral("%1;%2\n")
                           .arg(k * 360.0 / points, 0, 'f', 6)
                           .arg(1.5 * std::cos(3 * phi), 0, 'f', 6)
                           .toUtf8());
        }
        file.close();
        ProfilesView view;
        const OutcomePtr outcome = run(outOfRound());
        show(view, outcome);
        QString reason;
        const double nominal = outcome->result.project.part->diameter_mm / 2;
        const auto section = MeasuredSection::read(path, nominal, reason);
        QVERIFY2(section, qPrintable(reason));
        const int cells = static_cast<int>(outcome->result.sections.size());
        view.showMeasured(section);
        settle();
        QCOMPARE(view.across()->drawn(cells).radii_mm.size(), std::size_t{points});
        QVERIFY(
            view.across()->numbers(cells).contains(Names::fixed(3, 2).chopped(1))); // twice 1.5 µm
        QVERIFY(!view.across()->curve(cells, ProfileLine::blank)->visible());
        QVERIFY(view.across()->accessibleDescription().contains(QStringLiteral("section.csv")));
        const CsvTable table = view.across()->table();
        QCOMPARE(table.rows.size(), std::size_t{points});
        view.showMeasured(std::nullopt);
        settle();
        QCOMPARE(view.across()->table().rows.size(),
                 static_cast<std::size_t>(view.across()->series().radii()));
        on_disk::write(path, "angle;deviation\n0;1\nhello;2\n");
        QVERIFY(!MeasuredSection::read(path, nominal, reason));
        QVERIFY2(reason.contains(QStringLiteral("3")), qPrintable(reason));
    }

    void aLobedBlankIsOneBar() {
        for (const int lobes : {2, 3, 7}) {
            Project project = plungeProject(3);
            project.part->profile = ProfileForm::lobes;
            project.part->lobes = lobes;
            project.part->radii_per_section = 42;
            ShownProfiles view(run(project));
            part<QComboBox>(view, "parts")->setCurrentIndex(3);
            QCOMPARE(view.spectrum()->cellCount(), 3U);
            const std::vector<XY> blank = bars(view, 1, ProfileLine::blank);
            QCOMPARE(blank.size(), 21U);
            for (const XY& bar : blank) {
                const bool one = qRound(bar.x) == lobes;
                const double amplitude = one ? project.part->initial_runout_mm * 1000 / 2 : 0;
                QVERIFY(std::abs(bar.y - amplitude) < 1e-8);
            }
            view.setStroke(0); // what is left is the blank still
            const std::vector<XY>& left = bars(view, 1, ProfileLine::profile);
            for (std::size_t i = 0; i < left.size(); ++i) {
                QVERIFY(std::abs(left[i].y - blank[i].y) < 1e-8);
            }
        }
    }

    void theSpectrumDecaysWithTheCycle() {
        ShownProfiles view(m_of.plunge); // an ellipse
        part<QComboBox>(view, "parts")->setCurrentIndex(4);
        QVERIFY(view.spectrum()->isVisible() && !view.across()->isVisible());
        const auto oval = [&] { return bars(view, 0, ProfileLine::profile)[1].y; };
        const double end = oval();
        view.setStroke(view.stroke() / 2);
        const double middle = oval();
        view.setStroke(0);
        const double before = oval();
        QVERIFY(end < middle && middle < before);
        QCOMPARE(before, bars(view, 0, ProfileLine::blank)[1].y);
        const QCPRange sight = view.spectrum()->cell(0).axis(QCPAxis::atLeft)->range();
        QVERIFY(sight.contains(before) && sight.contains(middle)); // one scale for the whole cycle
        const std::vector<double>& radii = view.across()->series().profiles[0].radii_mm;
        const std::vector<Harmonic> spectrum = harmonics(radii, Directions(radii.size()));
        QVERIFY(std::abs(before - spectrum[2].amplitude_mm * 1000) < 1e-9);
    }

    void barsThatOutgrowTheSpectrumBringItAlong() {
        Project project = plungeProject(2);
        ShownProfiles view(run(project));
        part<QComboBox>(view, "parts")->setCurrentIndex(4);
        const auto sight = [&] { return view.spectrum()->cell(1).axis(QCPAxis::atLeft)->range(); };
        const auto higherBlank = [&] {
            project.part->initial_runout_mm *= 4;
            show(view, run(project));
            return bars(view, 1, ProfileLine::blank)[1].y;
        };
        const QCPRange first = sight();
        const double higher = higherBlank();
        QVERIFY(higher > first.upper && sight().upper >= higher);
        view.spectrum()->cell(0).axis(QCPAxis::atLeft)->setRange(1e-3, 1); // by hand: that stays
        QVERIFY(higherBlank() > 1);
        QCOMPARE(sight(), QCPRange(1e-3, 1));
        Project more = plungeProject(3);
        show(view, run(more));
        QCOMPARE(view.spectrum()->cellCount(), 3U);
    }

    void spectraMoveTogetherAndAreSaved() {
        ShownProfiles view(m_of.traverse);
        part<QComboBox>(view, "parts")->setCurrentIndex(3);
        settle();
        ChartPlot& plot = *view.spectrum();
        QCOMPARE(plot.cellCount(), 3U);
        const auto range = [&](std::size_t cell, QCPAxis::AxisType side) {
            return plot.cell(cell).axis(side)->range();
        };
        const QCPRange before = range(2, QCPAxis::atBottom);
        view.spectrum()->tools()->navigation().zoom(0.5);
        QVERIFY(range(2, QCPAxis::atBottom).size() < before.size());
        QCOMPARE(range(2, QCPAxis::atBottom), range(0, QCPAxis::atBottom));
        view.spectrum()->tools()->fit->trigger();
        QCOMPARE(range(1, QCPAxis::atBottom), before);
        QVERIFY(range(0, QCPAxis::atLeft).lower > 0); // logarithmic at first
        part<QCheckBox>(view, "logarithmicSpectrum")->click();
        QCOMPARE(range(0, QCPAxis::atLeft).lower, 0.0);
        const bool blankShown = part<QCheckBox>(view, "blank")->isChecked();
        QCOMPARE(plot.shows(static_cast<int>(ProfileLine::blank)), blankShown);
        const CsvTable table = plot.table();
        QCOMPARE(table.header.size(), 1 + 3 + (blankShown ? 1 : 0));
        QCOMPARE(table.rows.size(), 18u);
        const double bar = bars(view, 2, ProfileLine::profile)[1].y;
        QCOMPARE(std::get<double>(table.rows[1].back()), bar);
        QSignalSpy pointed(&plot, &ChartPlot::pointed);
        QTest::mouseMove(&plot, plot.cell(1).center());
        QTRY_VERIFY(pointed.count() > 0 && !pointed.last().first().toString().isEmpty());
    }

    void radiiUpToThirtySixAreMarked() {
        ShownProfiles view(m_of.traverse);
        const auto style = [&] {
            return view.across()->curve(0, ProfileLine::profile)->scatterStyle().shape();
        };
        QVERIFY(style() != QCPScatterStyle::ssNone);
        Project fine = traverseProject();
        fine.part->radii_per_section = 72;
        show(view, run(fine));
        QVERIFY(style() == QCPScatterStyle::ssNone);
        QCOMPARE(view.across()->curve(0, ProfileLine::profile)->data()->size(), 73);
    }

private:
    Cycles m_of;
};

} // namespace sparkout::test_profiles_form

SPARKOUT_TEST(test_profiles_form, TestProfilesForm)
#include "test_profiles_form.moc"
