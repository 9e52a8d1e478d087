// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/project_fixtures.h"

#include <algorithm>
#include <random>
#include <vector>

/// Small grids about random parts, for the tests of the searches.
namespace sparkout::search_cases {

class Dice {
public:
    explicit Dice(unsigned seed) : m_engine(seed) {}
    int integer(int low, int high) {
        return low + static_cast<int>(m_engine() % static_cast<unsigned>(high - low + 1));
    }
    double uniform(double low, double high) { return low + (high - low) * (m_engine() / 0x1p32); }
    bool chance(double share) { return uniform(0, 1) < share; }

private:
    std::mt19937 m_engine;
};

/// Sections on a shaft between centres, each yielding with all others.
inline void couple(Project& p, Dice& dice) {
    p.sections_coupled = true;
    p.sections = dice.integer(2, 3);
    p.machine->compliance_mm_per_n = {};
    p.machine->stiffness_n_um = Stiffness{dice.uniform(20, 60), dice.uniform(20, 60), 50};
    p.part->shaft.segments = {{150, 30}};
    p.part->shaft.ground_from_mm = dice.uniform(0, 110);
}

inline void makeBore(Project& p) {
    p.part->surface = Surface::internal;
    p.part->diameter_mm = 50;
    p.wheel->diameter_mm = 40;
}

/// What is less usual about a part, its machine and gauge.
inline void addOptions(Project& p, Dice& dice) {
    p.part->profile = static_cast<ProfileForm>(dice.integer(0, 2));
    if (dice.chance(0.3)) {
        p.part->tolerance.roundness_um = dice.uniform(0.5, 4);
    }
    if (dice.chance(0.2)) {
        p.part->tolerance.roughness_ra_um = 2 * dice.uniform(0.1, 0.6);
        p.wheel->roughness_factor = 2; // as measured
    }
    if (dice.chance(0.2)) {
        p.machine->work_drive_kw = dice.uniform(0.02, 0.1);
    }
    if (p.operation == Operation::plunge && dice.chance(0.2)) {
        makeBore(p);
    } else if (p.operation == Operation::plunge && dice.chance(0.2)) {
        couple(p, dice);
    } else if (dice.chance(0.2)) {
        p.machine->wheel_contact =
            WheelContact{std::vector<std::vector<double>>{{50, 20}, {500, dice.uniform(30, 60)}}};
    }
    if (p.operation == Operation::plunge && dice.chance(0.2)) {
        p.gauge->position_mm = dice.uniform(0, p.part->length_mm);
        if (!p.sections_coupled) {
            p.gauge->compliance_mm_per_n = dice.uniform(1e-5, 1e-4);
        }
    }
}

/// A small grid about a random part, with requirements that about half of its cycles hold.
inline Project smallCase(unsigned seed) {
    Dice dice(seed);
    const bool traverse = dice.chance(0.5);
    Project p = traverse ? fixtures::traverse() : fixtures::plunge();
    p.part->radii_per_section = 2 * dice.integer(2, 6);
    p.part->stock_mm = dice.chance(0.3) ? 0.045 : 0.01 * dice.integer(2, 5);
    p.part->initial_runout_mm = dice.uniform(0, 0.02);
    p.part->lower_deviation_um = -dice.uniform(6, 30);
    p.part->tolerance.radial_runout_um = dice.uniform(0.5, 6);
    p.wheel->dullness = dice.uniform(0, 0.04);
    p.material->burn_rise_k = std::nullopt;
    if (dice.chance(0.6)) {
        p.material->burn_rise_k = dice.uniform(200, 900);
    }
    if (dice.chance(0.6)) {
        p.machine->wheel_drive_kw = dice.uniform(0.3, 6);
    }
    p.gauge->rule = static_cast<GaugeRule>(dice.integer(0, 2));
    if (dice.chance(0.25)) {
        p.gauge->control = Control::position;
        p.wheel->radius_wear_um = 0.25 * (seed % 4);
    }
    p.gauge->commands = dice.integer(2, 5);
    Optimisation grid;
    grid.stages = dice.chance(0.5) ? std::vector<double>{1, 2, 3} : std::vector<double>{2, 1};
    grid.stock_step_mm = 0.01;
    grid.non_increasing = dice.chance(0.3);
    if (traverse) {
        const double scale = dice.uniform(0.5, 2.5);
        p.machine->compliance_mm_per_n =
            ZoneCompliance{dice.uniform(5e-5, 3e-4), dice.uniform(5e-5, 3e-4), 1.5e-4};
        p.machine->limits.radial_feed_mm = std::vector<double>{0.001, 0.02, 0.0001};
        grid.radial_feed_mm = std::vector<double>{0.002 * scale, 0.005 * scale};
        grid.axial_feed_mm_min = std::vector<double>{1800, 600};
    } else {
        p.sections = dice.integer(1, 3);
        std::vector<double> compliance;
        for (int j = 0; j < p.sections; ++j) {
            compliance.push_back(dice.uniform(1e-5, 1e-4));
        }
        p.machine->compliance_mm_per_n = compliance;
        const double scale = dice.uniform(0.5, 2);
        grid.radial_feed_mm_min = std::vector<double>{1.2 * scale, 0.3 * scale, 0.6 * scale};
    }
    if (dice.chance(0.3)) {
        const double least = 0.005 * dice.integer(0, 3);
        grid.last_stock_mm = std::vector<double>{least, least + 0.005 * dice.integer(1, 3)};
    }
    p.optimisation = grid;
    addOptions(p, dice);
    if (traverse) {
        p.machine->overrun_entry_mm = dice.uniform(0.51, 0.8) * p.wheel->width_mm;
        p.machine->overrun_exit_mm = dice.uniform(0.51, 0.8) * p.wheel->width_mm;
        p.machine->dwell_entry_s = dice.integer(0, 2) / 3.0; // in whole revolutions
        p.machine->dwell_exit_s = dice.integer(0, 2) / 3.0;
        p.machine->reversal_infeed = static_cast<ReversalInfeed>(seed % 3);
        if (seed % 5 == 1) {
            p.zone_sections = 2 + static_cast<int>(seed % 3);
        } else if (seed % 5 == 2) {
            makeBore(p);
        }
    }
    if (seed % 7 == 2 && p.part->radii_per_section >= 8) {
        p.part->gaps = {{static_cast<double>(seed * 37 % 360), 50}};
    }
    return p;
}

inline bool holds(const SimulationResult& result) {
    const std::vector<ConstraintResult> all = evaluateConstraints(result);
    return result.status == RunStatus::completed
           && std::all_of(all.begin(), all.end(), [](const auto& each) { return each.holds; });
}

} // namespace sparkout::search_cases
