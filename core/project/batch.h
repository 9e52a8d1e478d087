// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <vector>

namespace sparkout {

enum class Scenarios { corners, latin_hypercube, sobol, random };

/// How a quantity scatters over the batch; exactly one of the forms is given.
struct Factor {
    std::optional<std::vector<double>> uniform;    ///< [lowest, highest]
    std::optional<std::vector<double>> normal;     ///< [mean, standard deviation]
    std::optional<std::vector<double>> within;     ///< truncation of the normal, [lowest, highest]
    std::optional<std::vector<double>> triangular; ///< [lowest, most frequent, highest]
    std::optional<std::vector<double>> measured;   ///< values, each as frequent as any other
    std::optional<std::vector<double>> grows;   ///< from the first to the last part of a dressing
    std::optional<int> parts_between_dressings; ///< with `grows`
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
    std::optional<Factor> gauge_error;   ///< in standard deviations of the machine's gauge
    std::optional<Factor> gauge_age_h;   ///< since the machine's gauge was set: it drifts
    std::optional<Factor> part_warmer_k; ///< ΔT at the gauge
};

/// The batch a cycle must hold for.
struct Batch {
    int parts = 50;
    int seed = 1;
    Scenarios scenarios = Scenarios::latin_hypercube;
    Factors factors;
    // Lowest and highest of each zone or section, a row each; they scatter by themselves.
    NumberRows zone_stock_mm;  ///< δΠ [mm]
    NumberRows zone_runout_mm; ///< δ(ΔR) [mm]
    NumberRows zone_compliance;
    NumberRows correlation; ///< matrix over the factors, in the order of the table
    double least_ppk = 1;   ///< of its lower 95 % bound, for a cycle to be fit
    std::optional<double> most_outside_share; ///< of parts that are not good, and of expected ones
    // Of measured parts that are held against the batch.
    double measuring_uncertainty_um = 0; ///< standard uncertainty u of one measured value
    std::optional<double> bias_limit_um; ///< up to which measured and predicted mean are the same
    // The same of roundness, runout and cylindricity; as of the size where they are not given.
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
