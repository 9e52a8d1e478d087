// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/compliance_part.h"
#include "core/process/system_compliance.h"
#include "core/study/outcome.h"
#include "ui/plot/line_chart.h"

#include <QCoreApplication>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

inline constexpr double nmPerMm = 1e6; ///< γ is drawn in nm/N

/// γ along the part as stacked parts, its sum, and the γ each zone or section is ground with.
class ComplianceCurves {
    Q_DECLARE_TR_FUNCTIONS(ComplianceCurves)
public:
    static constexpr int sumKey = 100, usedKey = 101; ///< legend keys; below: a CompliancePart

    explicit ComplianceCurves(OutcomePtr outcome = nullptr) : m_outcome(std::move(outcome)) {}

    [[nodiscard]] const std::vector<CompliantPlace>& places() const;
    [[nodiscard]] LineChart chart() const;

private:
    [[nodiscard]] ChartTable table() const;
    [[nodiscard]] QString valuesAt(double x_mm) const;
    /// [nm/N]
    [[nodiscard]] std::vector<XY>
    along(const std::function<double(const ComplianceParts&)>& value) const;
    void addReadings(LineChart& chart) const;
    [[nodiscard]] bool has(CompliancePart part) const;
    [[nodiscard]] bool hasZones() const;
    [[nodiscard]] std::optional<double> groundWith(double x_mm) const; ///< γ [nm/N]
    [[nodiscard]] static QString nameOf(CompliancePart part);

    OutcomePtr m_outcome;
};

} // namespace sparkout
