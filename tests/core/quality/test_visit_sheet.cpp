// SPDX-License-Identifier: GPL-3.0-or-later
// What the sheet of a visit says is what the engine cut, for every radius of every pass.
#include "core/quality/visit_sheet.h"
#include "tests/core/support/formula_reader.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_visit_sheet {

using fixtures::within;

const FormulaTerm* termOf(const FormulaSheet& sheet, const std::string& symbol) {
    const FormulaTerm* found = nullptr;
    for (const FormulaStep& step : sheet.steps) {
        found = step.result.symbol == symbol ? &step.result : found;
    }
    return found;
}

Project sections(int count) {
    Project p = fixtures::plunge();
    p.part->radii_per_section = 12;
    p.part->initial_runout_mm = 0.03;
    p.sections = count;
    p.machine->compliance_mm_per_n = std::vector<double>(static_cast<std::size_t>(count), 3e-5);
    p.cycle->stages = {fixtures::plungeStage(1.2, 0.15), fixtures::sparkStage(fixtures::count(7))};
    return p;
}

std::vector<Project> samples() {
    Project bore = sections(2);
    bore.part->surface = Surface::internal;
    bore.wheel->diameter_mm = 20;
    Project soft = sections(2);
    soft.machine->wheel_contact = WheelContact{{{{0, 20}, {200, 60}}}};
    Project wavy = sections(2);
    wavy.wheel->runout = WheelRunout{.amplitude_um = 2};
    resolveWaves(wavy);
    Project wavyBore = bore;
    wavyBore.wheel->runout = wavy.wheel->runout;
    wavyBore.machine->wheel_speed_m_s = 7;
    resolveWaves(wavyBore);
    return {fixtures::traverse(), sections(3), bore, soft, wavy, wavyBore};
}

class TestVisitSheet : public QObject {
    Q_OBJECT

private slots:
    void theSheetGivesWhatTheEngineCut() {
        int cuts = 0, misses = 0;
        for (const Project& project : samples()) {
            Trajectory trajectory;
            const SimulationResult result = simulateUnchecked(project, &trajectory);
            QVERIFY(!trajectory.passes.empty());
            for (std::size_t i = 0; i < trajectory.passes.size(); ++i) {
                for (int k = 0; k < trajectory.radii; k += 5) {
                    const Visit& visit =
                        trajectory
                            .visits[trajectory.passes[i].firstVisit + static_cast<std::size_t>(k)];
                    const FormulaSheet sheet = visitSheet(result, trajectory, i, k);
                    QVERIFY(within(termOf(sheet, "a")->value, visit.actual_mm, 1e-12));
                    QVERIFY(within(termOf(sheet, "R_k′")->value, visit.radius_mm, 1e-12));
                    if (visit.actual_mm > 0) {
                        QVERIFY(within(termOf(sheet, "P_y")->value, visit.normalForce_n,
                                       1e-6 * visit.normalForce_n));
                        QVERIFY(termOf(sheet, "h")->value > visit.actual_mm);
                        // The coefficients as the sources name them.
                        const bool isPlunge = trajectory.passes[i].axialFeed_mm_min == 0;
                        QVERIFY(termOf(sheet, isPlunge ? "K_3" : "K_1"));
                        QVERIFY(!termOf(sheet, isPlunge ? "K_1" : "K_3"));
                        ++cuts;
                    } else {
                        QVERIFY(termOf(sheet, "h")->value <= 1e-12);
                        ++misses;
                    }
                }
            }
        }
        QVERIFY(cuts > 1000 && misses > 10);
    }

    void everyEquationHolds() {
        for (const Project& project : samples()) {
            Trajectory trajectory;
            const SimulationResult result = simulateUnchecked(project, &trajectory);
            for (std::size_t i = 0; i < trajectory.passes.size();
                 i += trajectory.passes.size() / 40 + 1) {
                const FormulaSheet sheet = visitSheet(result, trajectory, i, 7);
                for (const FormulaStep& step : sheet.steps) {
                    if (!step.terms.empty()) {
                        const fixtures::Quantity said = fixtures::workOut(step);
                        QVERIFY2(std::abs(said.value - step.result.value) <= 4 * said.uncertainty,
                                 step.text);
                    }
                }
            }
        }
    }
};

} // namespace sparkout::test_visit_sheet

SPARKOUT_TEST(test_visit_sheet, TestVisitSheet)
#include "test_visit_sheet.moc"
