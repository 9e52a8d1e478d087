// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"
#include "core/project/project.h"

#include <optional>
#include <vector>

namespace sparkout {

/// Faults of a batch that can be found without making its parts: forms, bounds and the correlation
/// matrix. A single cycle does not use them, so validate() only warns about them.
[[nodiscard]] Issues batchFaults(const Project& project);

enum class Scenarios { corners, latin_hypercube, sobol, random };

/// The scatter of a quantity over the batch; exactly one of the forms is given.
struct Factor {
    std::optional<std::vector<double>> uniform;    ///< [lowest, highest]
    std::optional<std::vector<double>> normal;     ///< [mean, standard deviation]
    std::optional<std::vector<double>> within;     ///< bounds of the normal law, [lowest, highest]
    std::optional<std::vector<double>> triangular; ///< [lowest, most frequent, highest]
    std::optional<std::vector<double>> measured;   ///< values, all equally frequent
    std::optional<std::vector<double>> grows;   ///< from the first to the last part of a dressing
    std::optional<int> parts_between_dressings; ///< required with `grows`
};

struct Factors {
    std::optional<Factor> stock_mm;
    std::optional<Factor> initial_runout_mm;
    std::optional<Factor> dullness;
    std::optional<Factor> wheel_diameter_mm;
    std::optional<Factor> flow_stress_mpa;
    std::optional<Factor> compliance;
    std::optional<Factor> contact_width_mm;
    std::optional<Factor> machine_form;
    std::optional<Factor> runout_at_deg;
    std::optional<Factor> wheel_phase_deg; ///< ψ_0 of the wheel's runout
    std::optional<Factor> gauge_error;     ///< in standard deviations of the machine's gauge
    std::optional<Factor> gauge_age_h;     ///< since the machine's gauge was set: it drifts
    std::optional<Factor> part_warmer_k;   ///< ΔT at the gauge
};

/// The batch that a cycle must be fit for.
struct Batch {
    int parts = 50;
    int seed = 1;
    Scenarios scenarios = Scenarios::latin_hypercube;
    Factors factors;
    // Lowest and highest value of each zone or section, a row each; they scatter independently.
    NumberRows zone_stock_mm;  ///< δΠ [mm]
    NumberRows zone_runout_mm; ///< δ(ΔR) [mm]
    NumberRows zone_compliance;
    NumberRows correlation; ///< correlation matrix of the factors, in the order of the table
    double least_ppk = 1;   ///< least lower 95 % bound of Ppk of a fit cycle
    std::optional<double> most_outside_share; ///< greatest share of rejects, found and expected
    // The comparison of measured parts with the batch.
    double measuring_uncertainty_um = 0; ///< standard uncertainty u of one measured value
    std::optional<double> bias_limit_um; ///< greatest difference of means that counts as agreement
    // The same two quantities for roundness, runout and cylindricity; by default those of the size.
    std::optional<double> form_measuring_uncertainty_um, form_bias_limit_um;
};

template <>
std::span<const Choice> choicesOf<Scenarios>();
template <>
const StructInfo& tableOf<Factor>();
template <>
const StructInfo& tableOf<Factors>();
template <>
const StructInfo& tableOf<Batch>();

} // namespace sparkout
