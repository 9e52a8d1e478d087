// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/calibrated_inputs.h"

#include "core/project/machine.h"
#include "core/project/member.h"
#include "core/project/number_input.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace sparkout {

namespace {

bool isSource(std::string_view path) {
    return path.starts_with("/machine/stiffness_n_um/") || path == "/part/shaft/youngs_modulus_gpa";
}

} // namespace

const Calibration* calibrationOf(const Project& project, std::string_view path) {
    if (!project.measured) {
        return nullptr;
    }
    const std::vector<Calibration>& records = project.measured->calibrations;
    const auto found = std::ranges::find(records, path, &Calibration::input);
    return found == records.end() ? nullptr : &*found;
}

bool hasCalibratedValue(const Project& project, const Calibration& calibration) {
    constexpr double rounding = 1e-9;
    const auto input = numberInput(project, calibration.input);
    return input && input->value
           && std::abs(*input->value - calibration.value) <= rounding * std::abs(calibration.value);
}

bool isCalibrated(const Project& project, const Field& input) {
    if (!project.measured) {
        return false;
    }
    const bool isComputed =
        &input == findMember(project, "/machine/compliance_mm_per_n").field
        && std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
    bool any = false;
    for (const Calibration& record : project.measured->calibrations) {
        const bool concerns =
            isComputed ? isSource(record.input) : nearestField(project, record.input) == &input;
        if (concerns && !hasCalibratedValue(project, record)) {
            return false;
        }
        any = any || concerns;
    }
    return any;
}

} // namespace sparkout
