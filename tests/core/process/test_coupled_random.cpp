// SPDX-License-Identifier: GPL-3.0-or-later
// Random projects with coupled sections [MODEL-6]: every balance is solved. SPARKOUT_QUICK=1: 200
// (sanitizers). SPARKOUT_LONG=1: 30,000.
#include "core/process/compliance.h"
#include "core/project/validate.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/core/support/shaft_system.h"
#include "tests/registry.h"

#include <cstdint>
#include <random>

namespace sparkout::test_coupled_random {

using fixtures::plungeStage;
using fixtures::sparkStage;
using fixtures::Traced;

/// Draws the same numbers everywhere, which the distributions of <random> do not.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : m_bits(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(m_bits() >> 11U) * 0x1p-53;
    }
    double logUniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    int whole(int low, int high) {
        return low + static_cast<int>(m_bits() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double share) { return uniform(0, 1) < share; }

private:
    std::mt19937_64 m_bits;
};

void drawShaft(Draw& draw, Project& p) {
    Part& part = *p.part;
    Shaft& shaft = part.shaft;
    double length = 0;
    for (int segments = draw.chance(0.4) ? 1 : draw.whole(2, 5); segments > 0; --segments) {
        shaft.segments.push_back(
            {draw.logUniform(5, 200), draw.logUniform(0.3, 2) * part.diameter_mm});
        length += shaft.segments.back().length_mm;
    }
    part.length_mm = length * draw.uniform(0.1, 1);
    shaft.ground_from_mm = (length - part.length_mm) * draw.uniform(0, 1);
    shaft.mounting = draw.chance(0.3) ? Mounting::chuck : Mounting::centres;
    for (int rests = draw.chance(0.2) ? draw.whole(1, 3) : 0; rests > 0; --rests) {
        shaft.steady_rests.push_back(
            {length * draw.uniform(0.05, 0.95), draw.logUniform(0.5, 1e3)});
    }
    if (draw.chance(0.1)) {
        part.surface = Surface::internal;
        shaft.quill = Quill{draw.logUniform(10, 150), draw.logUniform(5, 40)};
    }
}

/// One to three stages, with or without a spark-out.
void drawCycle(Draw& draw, Project& p) {
    const int stages = draw.whole(1, 3);
    double left = p.part->stock_mm;
    double revolutions = p.sections > 25 ? 12 : 40; // about
    for (int z = 1; z <= stages; ++z) {
        const double stock = z == stages ? left : left * draw.uniform(0.3, 0.9);
        const double made = draw.uniform(1, revolutions / 2);
        p.cycle->stages.push_back(plungeStage(stock / made * p.machine->work_speed_rpm, stock));
        left -= stock;
        revolutions -= made;
    }
    const bool sparksOut = draw.chance(0.3);
    if (sparksOut) {
        p.cycle->stages.push_back(sparkStage(fixtures::count(draw.whole(1, 10))));
    }
    if (sparksOut || draw.chance(0.3)) {
        p.gauge->control = Control::position;
    } else if (draw.chance(0.2)) {
        p.gauge->position_mm = p.part->length_mm * draw.uniform(0, 1);
    }
}

int drawSections(Draw& draw) {
    const double kind = draw.uniform(0, 1);
    return kind < 0.95     ? draw.whole(2, 14)
           : kind < 0.99   ? draw.whole(15, 25)
           : kind < 0.9995 ? draw.whole(26, 70)
                           : draw.whole(71, 200);
}

/// A project of any stiffness, from a slender shaft between soft centres to a rigid one; of any
/// sharpness; round or not, with few radii.
Project randomProject(std::uint64_t seed) {
    Draw draw(seed);
    Project p = fixtures::plunge();
    p.sections_coupled = true;
    p.sections = drawSections(draw);
    p.part->diameter_mm = draw.logUniform(8, 120);
    p.part->radii_per_section = p.sections > 40 ? 4 : 2 * draw.whole(2, 6);
    p.part->initial_runout_mm = draw.chance(0.2) ? 0 : draw.logUniform(1e-4, 0.1);
    p.part->stock_mm = p.part->initial_runout_mm * draw.uniform(0, 1) + draw.logUniform(5e-3, 0.3);
    drawShaft(draw, p);
    p.material->flow_stress_mpa = draw.logUniform(200, 4000);
    p.wheel->diameter_mm = p.part->surface == Surface::internal
                               ? p.part->diameter_mm * draw.uniform(0.4, 0.95)
                               : draw.logUniform(200, 900);
    p.wheel->width_mm = p.part->length_mm;
    p.wheel->dullness = draw.chance(0.15) ? 0 : draw.logUniform(1e-4, 0.5);
    p.machine->wheel_speed_m_s = draw.uniform(20, 60);
    p.machine->work_speed_rpm = draw.logUniform(20, 600);
    p.machine->compliance_mm_per_n = std::monostate{};
    p.machine->stiffness_n_um =
        Stiffness{draw.logUniform(2, 500), draw.logUniform(2, 500), draw.logUniform(2, 500)};
    if (draw.chance(0.15)) {
        NumberRows rows = std::vector<std::vector<double>>{};
        double force = 0;
        for (int i = draw.whole(1, 4); i > 0; --i) {
            rows->push_back({force += draw.logUniform(1, 300), draw.logUniform(5, 500)});
        }
        p.machine->wheel_contact = WheelContact{rows};
    }
    drawCycle(draw, p);
    return p;
}

/// How far the depths of a run are from a ≥ 0, r ≥ 0, a·r = 0, the rest r worked out in long double
/// from what the run has recorded [mm]. The gauge's place and the contact's deflection are left to
/// the projects without. Not counted is the rounding of the sum over the sections, which matters
/// where the softest systems give by hundreds of millimetres.
double worstFault(const Project& p) {
    const Traced run(p);
    const Compliance system = fixtures::shaftSystem(p);
    const auto sections = static_cast<std::size_t>(p.sections);
    const auto middle = [&](std::size_t j) {
        return p.part->shaft.ground_from_mm
               + p.part->length_mm * (double(j) + 0.5) / double(sections);
    };
    std::vector<double> G;
    for (std::size_t j = 0; j < sections * sections; ++j) {
        G.push_back(system.between(middle(j / sections), middle(j % sections)));
    }
    const fixtures::Law law(p);
    const std::vector<double> blank = fixtures::blankDepths(p);
    const double slice = p.part->length_mm / double(sections);
    double worst = 0;
    for (std::size_t m = 0; m < std::size_t(run.result.cycleCount); ++m) {
        for (int k = 0; k < p.part->radii_per_section; ++k) {
            std::vector<const Visit*> visits;
            for (std::size_t j = 0; j < sections; ++j) {
                visits.push_back(&run.visit(run.trajectory.passes[m * sections + j], k));
            }
            for (std::size_t j = 0; j < sections; ++j) {
                const Visit& v = *visits[j];
                long double rest = v.actual_mm;
                for (std::size_t l = 0; l < sections; ++l) {
                    rest += static_cast<long double>(G[j * sections + l])
                            * law.force(slice, visits[l]->actual_mm);
                }
                const double before = v.accumulated_mm - v.actual_mm;
                rest -= static_cast<long double>(v.programmed_mm) - before
                        - blank[static_cast<std::size_t>(k)];
                // what the section would lose by letting go
                const double own =
                    v.actual_mm + G[j * (sections + 1)] * law.force(slice, v.actual_mm);
                const double rounding =
                    8 * std::numeric_limits<double>::epsilon() * double(sections) * v.programmed_mm;
                worst =
                    std::max(worst, std::abs(std::min(own, static_cast<double>(rest))) - rounding);
            }
        }
    }
    return worst;
}

class TestCoupledRandom : public QObject {
    Q_OBJECT

private slots:
    void everyRandomProjectIsSolved() {
        const int projects = samples::sized(3000, 200, 30'000);
        int cut = 0, refused = 0;
        for (int seed = 0; seed < projects; ++seed) {
            const Project p = randomProject(static_cast<std::uint64_t>(seed));
            if (hasErrors(validate(p))) { // the machine's range of a feed or a stiffness
                ++refused;
                continue;
            }
            const SimulationResult result = simulateUnchecked(p);
            QVERIFY2(result.status != RunStatus::notSolved, qPrintable(QString::number(seed)));
            cut += result.peakNormalForce_n > 0;
        }
        QVERIFY2(cut > projects * 9 / 10, qPrintable(QString::number(cut)));
        QVERIFY(refused <= projects / 1000);
    }

    void theirBalancesHold() {
        const int projects = samples::sized(200, 20, 2000);
        for (int seed = 0; seed < projects; ++seed) {
            Project p = randomProject(static_cast<std::uint64_t>(seed));
            p.machine->wheel_contact.reset();
            p.gauge->position_mm.reset();
            if (p.part->surface == Surface::external) {
                const double fault = worstFault(p);
                QVERIFY2(fault < 1e-12,
                         qPrintable(QStringLiteral("%1: %2 mm").arg(seed).arg(fault)));
            }
        }
    }

    // A shaft off its middle, ground over 60 mm: many sections barely touch in turn.
    void manySectionsOnAUniformShaftAreSolved_data() {
        QTest::addColumn<int>("sections");
        for (const int sections : {50, 75, 100}) {
            QTest::addRow("%d", sections) << sections;
        }
    }
    void manySectionsOnAUniformShaftAreSolved() {
        QFETCH(int, sections);
        Project p = fixtures::plunge();
        p.part->shaft.segments = {{300, 16}};
        p.part->shaft.ground_from_mm = 90;
        p.part->length_mm = p.wheel->width_mm = 60;
        p.part->initial_runout_mm = 0.04;
        p.machine->work_speed_rpm = 150;
        p.machine->compliance_mm_per_n = std::monostate{};
        p.machine->stiffness_n_um = Stiffness{40, 20, 50};
        p.cycle->stages = {plungeStage(0.5, p.part->stock_mm)};
        p.sections = sections;
        p.sections_coupled = true;
        QVERIFY(!hasErrors(validate(p)));
        QCOMPARE(simulateUnchecked(p).status, RunStatus::completed);
        QVERIFY(worstFault(p) < 1e-12);
    }
};

} // namespace sparkout::test_coupled_random

SPARKOUT_TEST(test_coupled_random, TestCoupledRandom)
#include "test_coupled_random.moc"
