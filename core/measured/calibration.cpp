// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/calibration.h"

#include "core/measured/cycle_response.h"
#include "core/process/compliance.h"
#include "core/process/force.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/number_input.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout {

namespace {

/// The fitted factor of an input, with the standard error of its logarithm.
struct Found {
    double factor = 1;
    double error = 0;
};

/// Rounds to two digits of the standard error, which is that of its logarithm; at least 3 and at
/// most 9 digits.
double roundedTo(double value, double error) {
    constexpr double fewest = 3, most = 9;
    const double digits =
        error > 0 ? std::clamp(std::ceil(-std::log10(error)) + 2, fewest, most) : most;
    char text[32];
    const auto [end, failed] =
        std::to_chars(text, text + sizeof text, value, std::chars_format::scientific,
                      static_cast<int>(digits) - 1);
    double rounded = value;
    std::from_chars(text, end, rounded);
    return rounded;
}

class Calibrator {
public:
    Calibrator(const Project& project, const Identification& result, std::string data,
               std::string date)
        : m_before(project)
        , m_made(project)
        , m_result(result)
        , m_data(std::move(data))
        , m_date(std::move(date)) {}

    // Applies the factors like scaledProject() and the problem: γ' = γ·c·α, η' = η·d·β/α, with the
    // products of the powers as fitted: μ'·η' = μ·η·d·m.
    Project make() {
        if (hasThreshold(m_before)) {
            return makeThreshold();
        }
        changeCompliance();
        change("/material/flow_stress_mpa", {{FittedKind::flow_stress, 1}});
        change(dullnessPath(*m_before.wheel),
               {{FittedKind::dullness, 1}, {FittedKind::beta, 1}, {FittedKind::alpha, -1}});
        change("/material/shear_strain", {{FittedKind::chip_power, 1}});
        change("/material/friction",
               {{FittedKind::friction_power, 1}, {FittedKind::alpha, 1}, {FittedKind::beta, -1}},
               has(FittedKind::friction_power));
        changeRunout();
        changeSetting();
        return std::move(m_made);
    }

private:
    /// Applies K' = K·α, F'_0' = F'_0·β, with the powers as fitted: K_z' = K_z·c, μ'·F'_0' =
    /// μ·F'_0·m.
    Project makeThreshold() {
        changeCompliance();
        change("/material/specific_force_mpa", {{FittedKind::alpha, 1}});
        change("/material/threshold_force_n_mm", {{FittedKind::beta, 1}});
        if (has(FittedKind::chip_power)) {
            const Material& material = *m_before.material;
            auto& tangential = m_made.material->specific_tangential_force_mpa;
            const Found found = productOf({find(FittedKind::chip_power, {})}, {1});
            tangential =
                material.specific_tangential_force_mpa.value_or(
                    material.specific_force_mpa * material.shear_strain / material.shear_factor)
                * found.factor;
            record("/material/specific_tangential_force_mpa", found.error);
        } else if (auto& tangential = m_made.material->specific_tangential_force_mpa;
                   has(FittedKind::alpha) && !tangential) { // keeps the predicted power
            const Material& material = *m_before.material;
            tangential =
                material.specific_force_mpa * material.shear_strain / material.shear_factor;
        }
        change("/material/friction", {{FittedKind::friction_power, 1}, {FittedKind::beta, -1}},
               has(FittedKind::friction_power));
        changeRunout();
        changeSetting();
        return std::move(m_made);
    }

    struct Term {
        FittedKind kind;
        double sign; ///< sign in the sum of the logarithms
    };

    [[nodiscard]] bool has(FittedKind kind) const {
        return find(kind, {}) < m_result.values.size();
    }

    [[nodiscard]] std::size_t find(FittedKind kind, std::optional<int> place) const {
        const auto found = std::ranges::find_if(m_result.values, [&](const FittedValue& value) {
            return value.parameter.kind == kind && value.parameter.place == place;
        });
        return static_cast<std::size_t>(found - m_result.values.begin());
    }

    /// Product of factors; its error by their covariance.
    [[nodiscard]] Found productOf(const std::vector<std::size_t>& at,
                                  const std::vector<double>& signs) const {
        Found found;
        double variance = 0;
        for (std::size_t i = 0; i < at.size(); ++i) {
            found.factor *= std::pow(m_result.values[at[i]].value, signs[i]);
            for (std::size_t k = 0; k < at.size(); ++k) {
                variance += signs[i] * signs[k] * m_result.covariance[at[i]][at[k]];
            }
        }
        found.error = std::sqrt(std::max(0.0, variance));
        return found;
    }

    [[nodiscard]] std::pair<std::vector<std::size_t>, std::vector<double>>
    termsOf(const std::vector<Term>& terms) const {
        std::pair<std::vector<std::size_t>, std::vector<double>> found;
        for (const Term& term : terms) {
            if (has(term.kind)) {
                found.first.push_back(find(term.kind, {}));
                found.second.push_back(term.sign);
            }
        }
        return found;
    }

    void change(const char* path, const std::vector<Term>& terms, bool wanted = true) {
        const auto [at, signs] = termsOf(terms);
        if (at.empty() || !wanted) {
            return;
        }
        const Found found = productOf(at, signs);
        const auto input = numberInput(m_before, path);
        if (input && input->value) {
            setNumberInput(m_made, path, *input->value * found.factor);
            record(path, found.error);
        }
    }

    void changeCompliance() {
        const auto [common, signs] =
            hasThreshold(m_before) ? termsOf({{FittedKind::compliance, 1}})
                                   : termsOf({{FittedKind::compliance, 1}, {FittedKind::alpha, 1}});
        std::vector<Found> places(static_cast<std::size_t>(placeCount(m_before)));
        bool any = !common.empty(), anyPlace = false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            std::vector<std::size_t> at = common;
            std::vector<double> sign = signs;
            const std::size_t own = find(FittedKind::compliance, static_cast<int>(i));
            if (own < m_result.values.size()) {
                at.push_back(own);
                sign.push_back(1);
                any = anyPlace = true;
            }
            places[i] = productOf(at, sign);
        }
        if (!any) {
            return;
        }
        if (anyPlace) {
            std::vector<double> factors;
            factors.reserve(places.size());
            for (const Found& place : places) {
                factors.push_back(place.factor);
            }
            scalePlaceCompliances(m_made, factors);
        } else {
            scaleCompliance(m_made, places.front().factor);
        }
        recordCompliance(places);
    }

    void recordCompliance(const std::vector<Found>& places) {
        const GivenCompliance& given = m_made.machine->compliance_mm_per_n;
        const std::string path = "/machine/compliance_mm_per_n/";
        if (std::holds_alternative<ZoneCompliance>(given)) {
            record(path + "rz1", places[0].error);
            record(path + "nz", places[1].error);
            record(path + "rz2", places[2].error);
        } else if (const auto* const sections = std::get_if<std::vector<double>>(&given)) {
            const std::size_t count = std::min(sections->size(), places.size());
            for (std::size_t i = 0; i < count; ++i) {
                record(path + std::to_string(i), places[i].error);
            }
        } else {
            for (const char* part :
                 {"/machine/stiffness_n_um/headstock", "/machine/stiffness_n_um/tailstock",
                  "/machine/stiffness_n_um/wheel_head", "/part/shaft/youngs_modulus_gpa"}) {
                record(part, places.front().error);
            }
        }
    }

    void changeRunout() {
        const std::size_t at = find(FittedKind::blank_runout, {});
        if (at < m_result.values.size()) {
            m_made.part->initial_runout_mm = m_result.values[at].value;
            record("/part/initial_runout_mm", m_result.values[at].error);
        }
    }

    void changeSetting() {
        const std::size_t at = find(FittedKind::gauge_setting, {});
        if (at < m_result.values.size()) {
            const FittedValue& value = m_result.values[at];
            m_made.part->target_diameter_mm = value.value;
            record("/part/target_diameter_mm", value.error / value.value);
        }
    }

    /// Records that an input, if given, comes from these data, rounded to its significant digits.
    void record(const std::string& path, double error) {
        const auto input = numberInput(m_made, path);
        if (!input || !input->value) {
            return;
        }
        constexpr double quantile = 1.959963984540054; // 97.5 % quantile of the normal distribution
        const double fitted = *input->value, value = roundedTo(fitted, error);
        setNumberInput(m_made, path, value);
        Calibration calibration;
        calibration.input = path;
        calibration.value = value;
        calibration.low = std::min(value, fitted * std::exp(-quantile * error));
        calibration.high = std::max(value, fitted * std::exp(quantile * error));
        calibration.data = m_data;
        calibration.count = static_cast<int>(m_result.count);
        calibration.date = m_date;
        recordCalibration(m_made, std::move(calibration));
    }

    const Project& m_before;
    Project m_made;
    const Identification& m_result;
    std::string m_data, m_date;
};

} // namespace

Project withCalibration(const Project& project, const Identification& result,
                        const std::string& data, const std::string& date) {
    return result.status == IdentificationStatus::fitted
               ? Calibrator(project, result, data, date).make()
               : project;
}

void recordCalibration(Project& project, Calibration calibration) {
    Measured& measured = project.measured ? *project.measured : project.measured.emplace();
    const auto before =
        std::ranges::find(measured.calibrations, calibration.input, &Calibration::input);
    if (before != measured.calibrations.end()) {
        *before = std::move(calibration);
    } else {
        measured.calibrations.push_back(std::move(calibration));
    }
}

std::string today() {
    using namespace std::chrono;
    const year_month_day date(floor<days>(system_clock::now()));
    const auto twoDigits = [](unsigned number) {
        return (number < 10 ? "-0" : "-") + std::to_string(number);
    };
    return std::to_string(int(date.year())) + twoDigits(unsigned(date.month()))
           + twoDigits(unsigned(date.day()));
}

} // namespace sparkout
