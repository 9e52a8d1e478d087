// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/support/project_fixtures.h"

namespace sparkout::fixtures {

inline Factor uniform(double low, double high) {
    Factor factor;
    factor.uniform = {low, high};
    return factor;
}

inline Factor normal(double mean, double deviation) {
    Factor factor;
    factor.normal = {mean, deviation};
    return factor;
}

inline Factor triangular(double low, double mode, double high) {
    Factor factor;
    factor.triangular = {low, mode, high};
    return factor;
}

inline Factor measured(std::vector<double> values) {
    Factor factor;
    factor.measured = std::move(values);
    return factor;
}

/// The traverse shaft, its stock, runout and dullness scattering.
inline Project shaftBatch(int parts) {
    Project project = traverse();
    project.batch = Batch{};
    project.batch->parts = parts;
    project.batch->factors.stock_mm = uniform(0.13, 0.17);
    project.batch->factors.initial_runout_mm = uniform(0.01, 0.03);
    project.batch->factors.dullness = uniform(0.015, 0.03);
    return project;
}

/// A plunge system that does not yield, of which nothing scatters yet.
inline Project stiffBatch(int parts) {
    Project project = plunge();
    project.machine->compliance_mm_per_n = std::vector<double>{1e-18};
    project.machine->wheel_drive_kw = 10;
    project.batch = Batch{};
    project.batch->parts = parts;
    return project;
}

} // namespace sparkout::fixtures
