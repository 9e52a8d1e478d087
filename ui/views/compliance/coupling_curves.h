// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/coupling_comparison.h"
#include "ui/views/compliance/length_curves.h"

#include <memory>

namespace sparkout {

using CouplingPtr = std::shared_ptr<const CouplingComparison>;

/// The mean diameters of the sections by the models with independent and with coupled sections, and
/// their difference.
class CouplingCurves : public LengthCurves {
    Q_DECLARE_TR_FUNCTIONS(CouplingCurves)
public:
    static constexpr int independentKey = 400, coupledKey = 401, differenceKey = 402;

    CouplingCurves(ViewPlot& plot, QCPAxisRect& rect);

    void show(CouplingPtr comparison); ///< null: hides the curves
    [[nodiscard]] const CouplingComparison* comparison() const { return m_comparison.get(); }
    [[nodiscard]] QCPGraph* differenceGraph() const { return m_difference; }
    [[nodiscard]] QString summary() const;

    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] QString valuesAt(double x_mm) const override;
    void restyle() override;
    [[nodiscard]] Digits digits() const override { return Digits::thousandths; }

private:
    [[nodiscard]] double fromMiddle_um(const SectionResult& section) const;

    CouplingPtr m_comparison;
    QCPGraph* m_independent;
    QCPGraph* m_coupled;
    QCPGraph* m_difference;
};

} // namespace sparkout
