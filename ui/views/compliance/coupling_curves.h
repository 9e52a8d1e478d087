// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/coupling_comparison.h"
#include "ui/plot/line_chart.h"

#include <QCoreApplication>

#include <memory>
#include <utility>

namespace sparkout {

using CouplingPtr = std::shared_ptr<const CouplingComparison>;

/// The mean diameters of the sections by the models with independent and with coupled sections, and
/// their difference.
class CouplingCurves {
    Q_DECLARE_TR_FUNCTIONS(CouplingCurves)
public:
    static constexpr int independentKey = 400, coupledKey = 401, differenceKey = 402,
                         limitsKey = 403; ///< keys of the legend

    /// @param comparison null: nothing to show
    explicit CouplingCurves(CouplingPtr comparison = nullptr)
        : m_comparison(std::move(comparison)) {}

    [[nodiscard]] const CouplingComparison* comparison() const { return m_comparison.get(); }
    [[nodiscard]] LineChart chart() const;
    [[nodiscard]] QString summary() const;

private:
    [[nodiscard]] ChartTable table() const;
    [[nodiscard]] QString valuesAt(double x_mm) const;
    [[nodiscard]] double fromMiddle_um(const SectionResult& section) const;

    CouplingPtr m_comparison;
};

} // namespace sparkout
