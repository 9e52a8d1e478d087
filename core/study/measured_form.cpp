// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/measured_form.h"

#include "core/project/measured.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sparkout {

namespace {

/// Rounds to a hundredth of a micrometre, the resolution of such instruments.
double rounded_um(double value_um) {
    return std::round(value_um * 100) / 100;
}

std::optional<double> meanOf(const Measured& measured, MeasuredQuantity quantity,
                             std::optional<double> MeasuredPart::*value, int place) {
    double sum = 0;
    int count = 0;
    for (const MeasuredPart& part : measured.parts) {
        if (part.place == place && part.*value) {
            sum += *(part.*value);
            ++count;
        }
    }
    if (count > 0) {
        return rounded_um(sum / count);
    }
    const auto summary = std::ranges::find_if(measured.summaries, [&](const MeasuredSummary& each) {
        return each.quantity == quantity && each.place == place;
    });
    return summary == measured.summaries.end() ? std::nullopt
                                               : std::optional(rounded_um(summary->mean_um));
}

std::optional<std::vector<double>> byPlace(const Project& project, MeasuredQuantity quantity,
                                           std::optional<double> MeasuredPart::*value) {
    std::vector<double> means;
    for (int place = 0; place < placeCount(project); ++place) {
        const std::optional<double> mean = meanOf(*project.measured, quantity, value, place);
        if (!mean) {
            return std::nullopt;
        }
        means.push_back(*mean);
    }
    return means;
}

} // namespace

std::optional<MachineForm> measuredForm(const Project& project) {
    if (!project.measured) {
        return std::nullopt;
    }
    MachineForm form = project.machine->form.value_or(MachineForm());
    form.roundness_um = byPlace(project, MeasuredQuantity::roundness, &MeasuredPart::roundness_um);
    form.runout_um =
        byPlace(project, MeasuredQuantity::radial_runout, &MeasuredPart::radial_runout_um);
    if (!form.roundness_um && !form.runout_um) {
        return std::nullopt;
    }
    for (std::size_t i = 0; form.roundness_um && form.runout_um && i < form.runout_um->size();
         ++i) {
        double& runout_um = (*form.runout_um)[i]; // measured separately, it may be smaller
        runout_um = std::max(runout_um, (*form.roundness_um)[i]);
    }
    return form;
}

Project withMeasuredForm(Project project) {
    if (auto form = measuredForm(project)) {
        project.machine->form = std::move(form);
    }
    return project;
}

} // namespace sparkout
