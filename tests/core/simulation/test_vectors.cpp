// SPDX-License-Identifier: GPL-3.0-or-later
// tests/data/vectors: whole cycles computed by a separate program, and the closed forms of its page
// (those of MODEL-2…7; the table's lengths are µm).
#include "core/simulation/simulate.h"

#include "core/process/force.h"
#include "tests/check_line.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <QDir>
#include <QFile>

#include <map>

namespace sparkout::test_vectors {

using fixtures::close;
using fixtures::within;
using nlohmann::json;

constexpr double umPerMm = 1000;

QString vectorsFolder() {
    return QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/data/vectors");
}

json readVector(const QString& name) {
    QFile file(vectorsFolder() + "/" + name);
    return file.open(QIODevice::ReadOnly) ? json::parse(file.readAll().toStdString()) : json();
}

/// Half a unit of the last printed digit, and the digit itself as read.
double printed(double value, double lastDigit) {
    return 0.5 * lastDigit + 4 * fixtures::epsilon * std::abs(value);
}

/// One plunge cycle of the radius K − 1, which sees the whole infeed of each revolution: so many
/// revolutions at 5 µm, then spark-out.
struct ClosedForm {
    double gamma = 2e-5;
    double dullness = 0.02;
    double gammaK = 0; ///< given: γ is set so that γ·b·k_s has this value
    int revolutions = 10;
    int sparkOut = 0;

    std::vector<double> depth_um{}, deflection_um{}, removed_um{}; ///< revolution by revolution

    void run() {
        Project p = fixtures::plunge();
        p.wheel->dullness = dullness;
        const double bks = 40 * fixtures::Law(p).ks;
        const double used = gammaK > 0 ? gammaK / bks : gamma;
        p.machine->compliance_mm_per_n = std::vector<double>{used};
        p.gauge->control = Control::position; // the feed ends after exactly so many revolutions
        p.part->stock_mm = 0.005 * revolutions;
        p.cycle->stages = {fixtures::plungeStage(0.005 * 180, p.part->stock_mm)};
        if (sparkOut > 0) {
            p.cycle->stages.push_back(fixtures::sparkStage(fixtures::count(sparkOut)));
        }
        const fixtures::Traced run(p);
        for (const Pass& pass : run.trajectory.passes) {
            const Visit& last = run.visit(pass, 3);
            depth_um.push_back(last.actual_mm * umPerMm);
            removed_um.push_back(last.accumulated_mm * umPerMm);
            deflection_um.push_back((last.programmed_mm - last.accumulated_mm) * umPerMm);
        }
        completed = run.result.status == RunStatus::completed
                    && static_cast<int>(depth_um.size()) == revolutions + sparkOut;
    }
    /// After so many revolutions of spark-out.
    [[nodiscard]] double sparkDepth(int m) const {
        return depth_um.at(static_cast<std::size_t>(revolutions + m - 1));
    }
    [[nodiscard]] double sparkDeflection(int m) const {
        return deflection_um.at(static_cast<std::size_t>(revolutions + m - 1));
    }
    bool completed = false;
};

/// Enough revolutions for any transient to be gone: the slowest one here falls by 0.6 each.
constexpr int steady = 400;

class TestVectors : public QObject {
    Q_OBJECT

    HeldFunctions m_held;

private slots:
    void cleanup() { m_held.count(); }
    void cleanupTestCase() {
        m_held.print("17", QStringLiteral("whole cycles and tables of a separate program"));
    }

    void everyVectorIsThere() {
        const QStringList files = QDir(vectorsFolder()).entryList({"*.json"});
        QVERIFY2(files.filter("traverse").size() >= 5, qPrintable(files.join(' ')));
        QVERIFY2(files.filter("plunge").size() >= 4, qPrintable(files.join(' ')));
    }

    void wholeCycleIsTheOneOfTheSeparateProgram_data() {
        QTest::addColumn<QString>("name");
        for (const QString& name : QDir(vectorsFolder()).entryList({"*.json"})) {
            QTest::newRow(qPrintable(name)) << name;
        }
    }
    // Counts exact; lengths to the page's own 1e-6 µm; times to 1e-12, some hundred roundings.
    void wholeCycleIsTheOneOfTheSeparateProgram() {
        QFETCH(QString, name);
        const json vector = readVector(name);
        const json expect = vector.at("expect");
        const Project project = fixtures::read(vector.at("project"));
        const bool traverse = project.operation == Operation::traverse;
        const SimulationResult result = simulateUnchecked(project);
        QCOMPARE(result.status, RunStatus::completed);
        QCOMPARE(result.cycleCount,
                 expect.at(traverse ? "double_strokes" : "revolutions").get<int>());
        QCOMPARE(result.countsByStage,
                 expect.at(traverse ? "double_strokes_by_stage" : "revolutions_by_stage")
                     .get<std::vector<int>>());
        QVERIFY(close(result.time_s / 60, expect.at("cycle_time_min").get<double>(), 1e-12));
        std::vector<json> places;
        if (traverse) {
            for (const char* zone : {"rz1", "nz", "rz2"}) {
                places.push_back(expect.at("zones").at(zone));
            }
        } else {
            places = expect.at("sections").get<std::vector<json>>();
        }
        QCOMPARE(result.sections.size(), places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            checkPlace(result.sections[i], places[i], project.part->diameter_mm);
        }
    }

    // linear law, γK = 2, infeed 5 a revolution, from rest
    void linearLawFollowsTheTable() {
        ClosedForm cut{.dullness = 0, .gammaK = 2};
        cut.run();
        QVERIFY(cut.completed);
        const std::map<int, double> table{
            {1, 1.666667}, {2, 2.777778}, {3, 3.518519}, {5, 4.341564}, {10, 4.913292}};
        for (const auto& [m, a] : table) {
            QVERIFY2(within(cut.depth_um[std::size_t(m) - 1], a, printed(a, 1e-6)),
                     qPrintable(QString("revolution %1").arg(m)));
        }
        QVERIFY(within(cut.removed_um[9], 40.173415, printed(40, 1e-6)));
        // Its printed value is 50 − 40.17341513…, cut off after six decimals.
        QVERIFY(within(cut.deflection_um[9], 9.826585, printed(10, 1e-6)));
    }

    void linearLawSparksOutAsInTheTable() {
        ClosedForm cut{.dullness = 0, .gammaK = 2, .sparkOut = 5};
        cut.run();
        QVERIFY(cut.completed);
        const double table[] = {3.275528, 2.183685, 1.455790, 0.970527, 0.647018};
        for (int m = 1; m <= 5; ++m) {
            QVERIFY2(within(cut.sparkDepth(m), table[m - 1], printed(5, 1e-6)),
                     qPrintable(QString("revolution %1").arg(m)));
        }
    }

    void fullLawFollowsTheTable_data() {
        QTest::addColumn<double>("gamma");
        QTest::addColumn<QList<double>>("depths"); // revolutions 1, 2, 3, 5, 10
        QTest::addColumn<double>("deflection");
        QTest::newRow("2e-5 mm/N")
            << 2e-5 << QList<double>{2.244004, 4.035116, 4.697678, 4.972395, 4.999933} << 4.154412;
        QTest::newRow("5e-5 mm/N")
            << 5e-5 << QList<double>{0.833545, 2.256665, 3.395466, 4.528188, 4.982020} << 10.386031;
    }
    void fullLawFollowsTheTable() {
        QFETCH(double, gamma);
        QFETCH(QList<double>, depths);
        QFETCH(double, deflection);
        ClosedForm cut{.gamma = gamma, .revolutions = steady};
        cut.run();
        QVERIFY(cut.completed);
        const int at[] = {1, 2, 3, 5, 10};
        for (int i = 0; i < 5; ++i) {
            QVERIFY2(within(cut.depth_um[std::size_t(at[i]) - 1], depths[i], printed(5, 1e-6)),
                     qPrintable(QString("revolution %1").arg(at[i])));
        }
        QVERIFY(within(cut.deflection_um.back(), deflection, printed(deflection, 1e-6)));
        // and it is γ·P_y(5 µm), to the rounding of 2 mm of infeed in 400 steps
        const Project p = fixtures::plunge();
        QVERIFY(within(cut.deflection_um.back(), gamma * fixtures::Law(p).force(40, 0.005) * 1000,
                       1000 * fixtures::rounding(2, steady)));
    }

    // its spark-out after 1, 2, 5, 10, 20, 50, 100, 200 revolutions, from the steady state
    void fullLawSparksOutAsInTheTable_data() {
        addColumns<int, double, double, double, double>("revolutions", "depth", "depthDigit",
                                                        "deflection", "deflectionDigit");
        QTest::newRow("1") << 1 << 1.73612 << 1e-5 << 2.41830 << 1e-5;
        QTest::newRow("2") << 2 << .793119 << 1e-6 << 1.62518 << 1e-5;
        QTest::newRow("5") << 5 << .174254 << 1e-6 << .756917 << 1e-6;
        QTest::newRow("10") << 10 << .043558 << 1e-6 << .377365 << 1e-6;
        QTest::newRow("20") << 20 << .0101442 << 1e-7 << .181844 << 1e-6;
        QTest::newRow("50") << 50 << .00147744 << 1e-8 << .069339 << 1e-6;
        QTest::newRow("100") << 100 << 3.51565e-4 << 1e-9 << .0338149 << 1e-7;
        QTest::newRow("200") << 200 << 8.51256e-5 << 1e-10 << .0166372 << 1e-7;
    }
    void fullLawSparksOutAsInTheTable() {
        QFETCH(int, revolutions);
        QFETCH(double, depth);
        QFETCH(double, depthDigit);
        QFETCH(double, deflection);
        QFETCH(double, deflectionDigit);
        ClosedForm cut{.revolutions = steady, .sparkOut = 200};
        cut.run();
        QVERIFY(cut.completed);
        QVERIFY(within(cut.sparkDepth(revolutions), depth, printed(depth, depthDigit)));
        QVERIFY(within(cut.sparkDeflection(revolutions), deflection,
                       printed(deflection, deflectionDigit)));
    }

    void softerSystemSparksOutAsInTheTable() {
        ClosedForm cut{.gamma = 5e-5, .revolutions = steady, .sparkOut = 200};
        cut.run();
        QVERIFY(cut.completed);
        QVERIFY(within(cut.sparkDeflection(20), 1.03858, printed(1, 1e-5)));
        QVERIFY(within(cut.sparkDeflection(200), .103137, printed(.1, 1e-6)));
    }

    // deflection·n → (γK4)², depth·n² → (γK4)². With x = deflection/(γK4)² and A = 1 + γK3 the
    // balance gives 1/x′ = 1/x + 1 − (2A − 1)·x + O(x²), hence 1/x = n − (2A − 1)·ln n + c + O(ln
    // n/n) and depth/(γK4)² = x²·(1 − 2A·x + O(x²)): the limits hold with these next terms.
    void longSparkOutFollowsItsLimitLaws() {
        constexpr int longest = 10'000;
        ClosedForm cut{.revolutions = 30, .sparkOut = longest};
        cut.run();
        QVERIFY(cut.completed);
        const fixtures::Law law(fixtures::plunge());
        const double limit = std::pow(2e-5 * 40 * law.kr, 2) * umPerMm;
        const double A = 1 + 2e-5 * 40 * law.ks;
        const auto inverse = [&](int n) { return limit / cut.sparkDeflection(n); };
        const auto constant = [&](int n) { return inverse(n) - n + (2 * A - 1) * std::log(n); };
        // The depth holds a cut of limit/n² to half a bit of 0.15 mm, n times: the share that may
        // be lost of it, and with it of 1/x.
        const auto lost = [&](double n) { return fixtures::epsilon * 150 * n * n / limit; };
        for (const int n : {1000, 2000, 5000}) {
            const double next = std::log(n) / n;
            // The O(ln n/n) has the coefficient (2A − 1)² ≈ 1.1; twice that.
            QVERIFY2(within(constant(n), constant(longest), 2.2 * next + longest * lost(longest)),
                     qPrintable(QString::number(n)));
            QVERIFY(within(n / inverse(n), 1, 2 * next + lost(n)));
            // depth_n is cut from the deflection before it; the O(x²) is 5A²·x²
            const double before = 1 / inverse(n - 1);
            QVERIFY(within(cut.sparkDepth(n) / limit / (before * before), 1 - 2 * A * before,
                           10.0 / n / n + 2 * lost(n)));
            QVERIFY(within(cut.sparkDepth(n) / limit * n * n, 1, 4 * next + 2 * lost(n)));
        }
    }

private:
    static void checkPlace(const SectionResult& section, const json& place, double nominal_mm) {
        constexpr double um = 1e-6;
        const auto deviation = place.at("diameter_deviation_um").get<std::vector<double>>();
        QVERIFY(within(section.diameterDeviationMin_mm * umPerMm, deviation[0], um));
        QVERIFY(within(section.diameterDeviationMax_mm * umPerMm, deviation[1], um));
        QVERIFY(within(section.radialRunout_mm * umPerMm,
                       place.at("radial_runout_um").get<double>(), um));
        const auto radii = place.at("radii_um").get<std::vector<double>>();
        QCOMPARE(section.radii_mm.size(), radii.size());
        for (std::size_t k = 0; k < radii.size(); ++k) {
            const double radius = (section.radii_mm[k] - nominal_mm / 2) * umPerMm;
            QVERIFY2(within(radius, radii[k], um), qPrintable(QString("radius %1").arg(k)));
        }
    }
};

} // namespace sparkout::test_vectors

SPARKOUT_TEST(test_vectors, TestVectors)
#include "test_vectors.moc"
