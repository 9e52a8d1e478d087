// SPDX-License-Identifier: GPL-3.0-or-later
// A force with a threshold [MODEL-2, MODEL-3]: closed forms of lag, spark-out and rest, the balance
// of every state, alone, with a wheel contact and coupled, and what is refused beside it.
#include "core/process/compliance.h"
#include "core/process/contact_compliance.h"
#include "core/process/coupled_sections.h"
#include "core/process/force.h"
#include "core/project/validate.h"
#include "core/quality/power.h"
#include "core/quality/shop_numbers.h"
#include "core/quality/visit_sheet.h"
#include "core/simulation/simulate.h"
#include "core/surface/cutting.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/shaft_system.h"
#include "tests/registry.h"

#include <cstdint>
#include <random>

namespace sparkout::test_threshold_law {

using fixtures::close;
using fixtures::plungeStage;
using fixtures::sparkStage;
using fixtures::Traced;
using fixtures::within;

Project withThreshold(Project p, double F0 = 0.8, double K0 = 60'000) {
    p.material->force_law = ForceLawKind::threshold;
    p.material->threshold_force_n_mm = F0;
    p.material->specific_force_mpa = K0;
    return p;
}

/// A round part that is fed by f = 2 µm a revolution 200 times, then sparks out.
Project steady() {
    Project p = withThreshold(fixtures::plunge());
    p.machine->compliance_mm_per_n = std::vector<double>{8e-5};
    p.gauge->control = Control::position;
    p.part->stock_mm = 0.4;
    p.cycle->stages = {plungeStage(0.36, 0.4), sparkStage(fixtures::count(30))};
    return p;
}

/// K, written out.
double stiffnessOfCut(const Project& p) {
    return p.material->specific_force_mpa * std::numbers::pi * p.part->diameter_mm
           * p.machine->work_speed_rpm / (p.machine->wheel_speed_m_s * 60e3);
}

/// The visits of the radius that is cut at the end of each revolution.
std::vector<Visit> lastVisits(const Traced& run) {
    std::vector<Visit> visits;
    for (const Pass& pass : run.trajectory.passes) {
        visits.push_back(run.visit(pass, run.trajectory.radii - 1));
    }
    return visits;
}

/// How far the visits of a run are from one of the three states [mm], by G of the sections: G has
/// one row for each, of independent sections nothing beside its diagonal.
struct Balance {
    std::vector<double> G; ///< [mm/N]
    double width = 0;      ///< of a section, whose force is all of G's
    double recorded = 0;   ///< width that a visit's force is of
    std::optional<ContactCompliance> contact;
};

double worstFault(const Project& p, const Traced& run, const Balance& balance) {
    const auto sections = static_cast<std::size_t>(p.sections);
    const double K = stiffnessOfCut(p), F0 = p.material->threshold_force_n_mm;
    const std::vector<double> blank = fixtures::blankDepths(p);
    double worst = 0;
    for (std::size_t first = 0; first < run.trajectory.passes.size(); first += sections) {
        for (int k = 0; k < run.trajectory.radii; ++k) {
            std::vector<double> pressure;
            for (std::size_t j = 0; j < sections; ++j) {
                const Visit& v = run.visit(run.trajectory.passes[first + j], k);
                pressure.push_back(v.normalForce_n / balance.recorded);
            }
            for (std::size_t j = 0; j < sections; ++j) {
                const Visit& v = run.visit(run.trajectory.passes[first + j], k);
                const double a = v.actual_mm, before = v.accumulated_mm - a;
                long double rest = a;
                for (std::size_t l = 0; l < sections; ++l) {
                    rest += static_cast<long double>(balance.G[j * sections + l]) * pressure[l]
                            * balance.width;
                }
                if (balance.contact) {
                    rest += balance.contact->deflection(v.normalForce_n);
                }
                rest -= v.programmed_mm - before - blank[static_cast<std::size_t>(k)];
                const double fault = static_cast<double>(rest);
                // off: nothing presses; touching or cutting: in balance
                worst = std::max(worst, pressure[j] > 0 ? std::abs(fault) : -fault);
                // a = max(0, p − F'_0)/K, and a touching section is below F'_0
                worst = std::max(worst, std::abs(a - std::max(0.0, pressure[j] - F0) / K));
            }
        }
    }
    return worst;
}

Balance alone(const Project& p) {
    const auto& gamma = std::get<std::vector<double>>(p.machine->compliance_mm_per_n);
    Balance balance{std::vector<double>(gamma.size() * gamma.size()), p.part->length_mm,
                    p.part->length_mm, wheelContact(p)};
    for (std::size_t j = 0; j < gamma.size(); ++j) {
        balance.G[j * (gamma.size() + 1)] = gamma[j];
    }
    return balance;
}

double uniform(std::mt19937_64& bits, double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11U) * 0x1p-53;
}

/// A system of sections and their lags.
struct System {
    std::vector<double> G, width, h;
    ForceLaw law;
    double least = 0; ///< no eigenvalue of G is below [mm/N]
};

/// Positive definite, as of a beam on springs; some lags negative.
System randomSystem(std::mt19937_64& bits) {
    const std::size_t J = 1 + bits() % 7;
    System s;
    s.law = {.ks = std::exp(uniform(bits, 1, 7)),
             .kr = bits() % 5 == 0 ? 0 : std::exp(uniform(bits, -4, 3)),
             .kt = 1,
             .mu = 0.3,
             .threshold = true};
    const double scale = std::exp(uniform(bits, -14, -8));
    s.least = 0.05 * scale;
    const double lag = std::exp(uniform(bits, -12, -3));
    s.G.assign(J * J, 0);
    for (std::size_t i = 0; i < J + 1; ++i) {
        std::vector<double> v;
        for (std::size_t j = 0; j < J; ++j) {
            v.push_back(uniform(bits, -0.3, 1));
        }
        for (std::size_t j = 0; j < J * J; ++j) {
            s.G[j] += scale * v[j / J] * v[j % J];
        }
    }
    for (std::size_t j = 0; j < J; ++j) {
        s.G[j * (J + 1)] += s.least;
        s.width.push_back(uniform(bits, 0.5, 20));
        s.h.push_back(lag * uniform(bits, -0.4, 1));
    }
    return s;
}

struct Solution {
    std::vector<double> u, v, f;
    bool converged = false;
};

Solution solve(const System& s, const std::vector<double>& h, Solution from = {}) {
    const std::size_t J = s.width.size();
    Solution found = std::move(from);
    found.u.resize(J);
    found.v.resize(J);
    CoupledSections sections(s.G, s.width, s.law);
    found.converged = sections.solve(h.data(), found.u.data(), {}, found.v.data()).converged;
    found.f.clear();
    for (std::size_t j = 0; j < J; ++j) {
        found.f.push_back(s.width[j]
                          * (s.law.ks * found.u[j] * found.u[j] + s.law.kr * found.v[j]));
    }
    return found;
}

/// The second implementation: section by section by bisection of its own force, in long double,
/// round and round until nothing moves. It comes to the solution as it lowers the energy.
std::vector<long double> bisected(const System& s, const std::vector<double>& h) {
    const std::size_t J = s.width.size();
    std::vector<long double> f(J, 0);
    for (int round = 0; round < 20'000; ++round) {
        long double moved = 0, largest = 0;
        for (std::size_t j = 0; j < J; ++j) {
            long double left = h[j];
            for (std::size_t l = 0; l < J; ++l) {
                left -= l == j ? 0 : static_cast<long double>(s.G[j * J + l]) * f[l];
            }
            const long double before = f[j], own = s.G[j * (J + 1)];
            long double low = 0, high = left > 0 ? left / own : 0;
            for (int i = 0; i < 200 && low < high; ++i) {
                const long double middle = low + (high - low) / 2;
                if (middle <= low || middle >= high) {
                    break;
                }
                const long double p = middle / s.width[j];
                const long double a = p > s.law.kr ? (p - s.law.kr) / s.law.ks : 0;
                (own * middle + a < left ? low : high) = middle;
            }
            f[j] = high;
            moved = std::max(moved, std::abs(f[j] - before));
            largest = std::max(largest, f[j]);
        }
        if (moved <= 1e-17L * largest) {
            break;
        }
    }
    return f;
}

class TestThresholdLaw : public QObject {
    Q_OBJECT

private slots:
    // Lag γ·b·(F'_0 + K·f), then a_m = f·r^m, and γ·b·F'_0 stays.
    void lagSparkOutAndRestAreTheClosedForms() {
        const Project p = steady();
        const Traced run(p);
        QCOMPARE(run.result.status, RunStatus::completed);
        const std::vector<Visit> visits = lastVisits(run);
        const double f = 0.002, gamma = 8e-5, b = p.part->length_mm, K = stiffnessOfCut(p);
        const double F0 = p.material->threshold_force_n_mm;
        const auto fed = static_cast<std::size_t>(run.result.countsByStage[0]);
        QCOMPARE(fed, std::size_t(200));
        const Visit& last = visits[fed - 1];
        QVERIFY(close(last.actual_mm, f, 1e-12));
        QVERIFY(close(last.programmed_mm - last.accumulated_mm, gamma * b * (F0 + K * f), 1e-12));
        QVERIFY(close(last.normalForce_n, b * (F0 + K * f), 1e-12));
        const double x = gamma * b * K, r = x / (1 + x);
        for (std::size_t m = 1; m <= 15; ++m) {
            // of a lag that is rounded to ε·t_П
            const double rounding = 1e-15;
            QVERIFY(within(visits[fed + m - 1].actual_mm, f * std::pow(r, double(m)),
                           rounding + 1e-12 * f));
        }
        const double tau_s = -60 / (p.machine->work_speed_rpm * std::log(r));
        const double measured_s = -60 / p.machine->work_speed_rpm
                                  / std::log(visits[fed + 5].actual_mm / visits[fed + 4].actual_mm);
        QVERIFY2(close(measured_s, tau_s, 1e-9), qPrintable(QString::number(measured_s)));
        const Visit& end = visits.back();
        const double rest = end.programmed_mm - end.accumulated_mm;
        QVERIFY(within(rest, gamma * b * F0, f * std::pow(r, 29.0) * x + 1e-14));
        QVERIFY(close(end.normalForce_n, b * F0, 1e-5));
    }

    // As long as it is fed less than γ·b·F'_0 the wheel only rubs, with the force h/γ.
    void belowTheThresholdItRubsAndCutsNothing() {
        Project p = steady();
        p.material->threshold_force_n_mm = 5; // γ·b·F'_0 = 16 µm, eight revolutions
        const Traced run(p);
        const std::vector<Visit> visits = lastVisits(run);
        for (std::size_t m = 0; m < 7; ++m) {
            QCOMPARE(visits[m].actual_mm, 0.0);
            QVERIFY(close(visits[m].normalForce_n, 0.002 * double(m + 1) / 8e-5, 1e-12));
        }
        QVERIFY(visits[8].actual_mm > 0);
        // A stage of rubbing alone has its force and power, and removes nothing.
        p.cycle->stages = {plungeStage(0.36, 0.01), sparkStage(fixtures::count(5))};
        p.part->stock_mm = 0.01;
        const Traced rubs(p);
        const double P = 0.01 / 8e-5;
        QVERIFY(close(rubs.result.peakNormalForce_n, P, 1e-12));
        QVERIFY(close(rubs.result.sumsByStage[1].normalForce_n.value, P, 1e-12));
        QVERIFY(close(rubs.result.sumsByStage[1].power_w.value, 0.3 * P * 35, 1e-12));
        QVERIFY(close(rubs.result.sections[0].peakNormalForce_n, P, 1e-12));
        const ShopNumbers shop = shopNumbers(rubs.result);
        QCOMPARE(shop.stages[1].removedVolume_mm3, 0.0);
        QVERIFY(close(shop.stages[1].energy_j, 0.3 * P * 35 * 5 / 3, 1e-12)); // 5 rev at 3 rev/s
    }

    // F'_0 → 0 with K = k_s is the sources' law of a sharp wheel; K → ∞ cuts nothing.
    void limitsAreTheSharpWheelAndTheOneThatCutsNothing() {
        Project sharp = fixtures::plungeOfThree();
        sharp.wheel->dullness = 0;
        Project p = withThreshold(sharp, 0, 1.9 * 2000);
        p.material->specific_tangential_force_mpa = 2.8 * 2000;
        const Traced one(sharp), other(p);
        QCOMPARE(other.result.countsByStage, one.result.countsByStage);
        for (std::size_t i = 0; i < one.trajectory.visits.size(); ++i) {
            const Visit &a = one.trajectory.visits[i], &b = other.trajectory.visits[i];
            QVERIFY(within(b.actual_mm, a.actual_mm, 1e-15));
            QVERIFY(within(b.normalForce_n, a.normalForce_n, 1e-9 * a.normalForce_n + 1e-9));
        }
        QVERIFY(close(other.result.peakPower_w, one.result.peakPower_w, 1e-11));

        Project blunt = steady();
        blunt.material->specific_force_mpa = 1e8;
        blunt.material->threshold_force_n_mm = 0;
        const Traced none(blunt);
        const std::vector<Visit> visits = lastVisits(none);
        const double x = 8e-5 * blunt.part->length_mm * stiffnessOfCut(blunt);
        QVERIFY(close(visits.front().actual_mm, 0.002 / (1 + x), 1e-12));
        QVERIFY(visits.front().actual_mm < 1e-6);
    }

    void everyVisitIsInOneOfThreeStates() {
        for (const double F0 : {0.0, 0.1, 1.0, 12.0}) {
            Project p = withThreshold(fixtures::plungeOfThree(), F0);
            const Traced run(p);
            QVERIFY(worstFault(p, run, alone(p)) < 1e-14);
            p.machine->wheel_contact = WheelContact{NumberRows{{{10, 5}, {100, 20}, {400, 60}}}};
            const Traced soft(p);
            QVERIFY(worstFault(p, soft, alone(p)) < 1e-14);
            if (F0 >= 1) { // else the lags that only press are too few
                const auto rubs = [](const Visit& v) {
                    return v.actual_mm == 0 && v.normalForce_n > 0;
                };
                QVERIFY(std::ranges::any_of(run.trajectory.visits, rubs));
                QVERIFY(std::ranges::any_of(soft.trajectory.visits, rubs));
            }
        }
    }

    // Random systems against bisection; every solution is met from the solution of other lags, too,
    // and with more lag no section is cut less where the influence is none of others.
    void coupledSectionsAreSolvedAsByBisection() {
        std::mt19937_64 bits(1);
        int cutting = 0, touching = 0, off = 0;
        for (int trial = 0; trial < 200; ++trial) {
            const System s = randomSystem(bits);
            const std::size_t J = s.width.size();
            const Solution found = solve(s, s.h);
            QVERIFY2(found.converged, qPrintable(QString::number(trial)));
            const std::vector<long double> second = bisected(s, s.h);
            long double largest = 0;
            for (const long double f : second) {
                largest = std::max(largest, f);
            }
            std::vector<double> others = s.h;
            std::ranges::reverse(others);
            const Solution again = solve(s, s.h, solve(s, others));
            QVERIFY(again.converged);
            for (std::size_t j = 0; j < J; ++j) {
                const long double p = second[j] / s.width[j];
                const long double a = p > s.law.kr ? (p - s.law.kr) / s.law.ks : 0;
                // 1e-13 mm of the balance are so much force where G is softest
                const double of = 1e-9 * static_cast<double>(largest) + 1e-12 / s.least;
                QVERIFY2(within(found.f[j], static_cast<double>(second[j]), of),
                         qPrintable(QStringLiteral("%1: %2, %3")
                                        .arg(trial)
                                        .arg(found.f[j])
                                        .arg(static_cast<double>(second[j]))));
                QVERIFY(within(again.f[j], found.f[j], 2 * of));
                QVERIFY(within(found.u[j] * found.u[j], static_cast<double>(a), 3e-12));
                cutting += found.u[j] > 0;
                touching += found.u[j] == 0 && found.v[j] > 0;
                off += found.v[j] == 0;
            }
        }
        QVERIFY2(cutting > 100 && touching > 50 && off > 50,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(cutting).arg(touching).arg(off)));
    }

    // Sections that nothing couples are those of the closed form.
    void uncoupledInfluenceIsTheClosedForm() {
        std::mt19937_64 bits(2);
        for (int trial = 0; trial < 200; ++trial) {
            System s = randomSystem(bits);
            const std::size_t J = s.width.size();
            for (std::size_t j = 0; j < J * J; ++j) {
                s.G[j] = j % (J + 1) == 0 ? s.G[j] : 0;
            }
            const Solution found = solve(s, s.h);
            QVERIFY(found.converged);
            for (std::size_t j = 0; j < J; ++j) {
                const double gamma = s.G[j * (J + 1)] * s.width[j];
                const ThresholdState state =
                    thresholdState(gamma * s.law.kr, 4 * (1 + gamma * s.law.ks), s.h[j]);
                QVERIFY(within(found.u[j] * found.u[j], state.root * state.root, 2e-13));
                QVERIFY(
                    within(gamma * s.law.kr * found.v[j], gamma * s.law.kr * state.rubbing, 2e-13));
            }
        }
    }

    // A whole cycle on a shaft that bends, with and without a contact: the balances hold.
    void coupledCycleKeepsItsBalance() {
        for (const bool contact : {false, true}) {
            Project p = withThreshold(fixtures::slender(6), 0.7);
            p.cycle->stages = {plungeStage(0.9, 0.15), plungeStage(0.2, 0.05)};
            if (contact) {
                p.machine->wheel_contact =
                    WheelContact{NumberRows{{{10, 5}, {100, 20}, {400, 60}}}};
            }
            QVERIFY(!hasErrors(validate(p)));
            const Traced run(p);
            QCOMPARE(run.result.status, RunStatus::completed);
            const Compliance system = fixtures::shaftSystem(p);
            const auto sections = static_cast<std::size_t>(p.sections);
            Balance balance{{}, p.part->length_mm / p.sections, p.part->length_mm, wheelContact(p)};
            const auto middle = [&](std::size_t j) {
                return p.part->shaft.ground_from_mm + (double(j) + 0.5) * balance.width;
            };
            for (std::size_t j = 0; j < sections * sections; ++j) {
                balance.G.push_back(system.between(middle(j / sections), middle(j % sections)));
            }
            const double fault = worstFault(p, run, balance);
            QVERIFY2(fault < 2e-12, qPrintable(QString::number(fault)));
        }
    }

    // What the sheets state is what the engine takes.
    void sheetsAndLimitsAreThoseOfTheLaw() {
        Project p = withThreshold(fixtures::plunge());
        const ForceLaw law = forceLaw(p);
        QVERIFY(law.threshold);
        QVERIFY(close(law.ks, stiffnessOfCut(p), 1e-14));
        QVERIFY(close(law.kt, stiffnessOfCut(p) * 2.8 / 1.9, 1e-14));
        const double b = 40, a = 0.003;
        QVERIFY(close(normalForceSheet(p, b, a).result().value, b * (0.8 + law.ks * a), 1e-14));
        QVERIFY(close(tangentialForceSheet(p, b, a).result().value, b * (law.kt * a + 0.3 * 0.8),
                      1e-14));
        const PowerModel model(p);
        const double power = model.wheelPower(b, a);
        QVERIFY(close(model.wheelLimitDepth(b, power), a, 1e-12));
        QCOMPARE(model.wheelLimitDepth(b, 0.9 * b * 0.3 * 0.8 * 35'000), 0.0); // rubs beyond it
        for (const double h : {1e-4, 5e-4, 0.002, 0.02}) {
            const FormulaSheet sheet = balanceSheet(p, b, 2e-5, h);
            const ThresholdState state =
                thresholdState(2e-5 * b * 0.8, 4 * (1 + 2e-5 * b * law.ks), h);
            double depth = -1;
            for (const FormulaStep& step : sheet.steps) {
                depth = QLatin1String(step.result.symbol) == QLatin1String("a") ? step.result.value
                                                                                : depth;
            }
            QVERIFY(within(depth, state.root * state.root, 1e-16));
            QVERIFY(close(sheet.result().value + depth, h, 1e-14));
        }
    }

    // Temperature and pressure at a contact without length are not known; nor is the wheel's recipe
    // a part of this law.
    void whatBelongsToTheSourcesLawIsRefused() {
        const auto refuses = [](const Project& p, const char* path) {
            const Issues issues = validate(p);
            return std::ranges::any_of(issues, [&](const Issue& issue) {
                return issue.code == IssueCode::notWithThreshold && issue.path == path
                       && issue.severity == Severity::error;
            });
        };
        const Project plain = withThreshold(fixtures::plunge());
        QVERIFY(!hasErrors(validate(plain)));
        Project p = plain;
        p.material->burn_rise_k = 700;
        QVERIFY(refuses(p, "/material/burn_rise_k"));
        p.material->force_law = ForceLawKind::sources;
        QVERIFY(!hasErrors(validate(p)));
        p = plain;
        p.wheel->force_recipe.emplace();
        QVERIFY(refuses(p, "/wheel/force_recipe"));
        p = plain;
        p.wheel->grain_surface_energy_j_m2 = 18;
        p.wheel->grain_modulus_gpa = 390;
        p.wheel->bond_surface_energy_j_m2 = 4;
        QVERIFY(!hasErrors(validate(p)));
        p.wheel->bond_modulus_gpa = 65;
        QVERIFY(refuses(p, "/wheel/grain_surface_energy_j_m2"));
        p = plain;
        p.batch = Batch{};
        p.batch->factors.flow_stress_mpa.emplace().uniform = std::vector<double>{1900, 2100};
        QVERIFY(refuses(p, "/batch/factors/flow_stress_mpa"));
    }
};

} // namespace sparkout::test_threshold_law

SPARKOUT_TEST(test_threshold_law, TestThresholdLaw)
#include "test_threshold_law.moc"
