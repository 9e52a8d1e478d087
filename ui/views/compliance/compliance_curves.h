// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/compliance_part.h"
#include "core/process/system_compliance.h"
#include "core/study/outcome.h"
#include "ui/views/compliance/length_curves.h"

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

inline constexpr double nmPerMm = 1e6; ///< γ is drawn in nm/N

/// γ along the part as stacked parts, its sum, and the γ used for each zone or section.
class ComplianceCurves : public LengthCurves {
    Q_DECLARE_TR_FUNCTIONS(ComplianceCurves)
public:
    static constexpr int sumKey = 100, usedKey = 101; ///< legend keys; below: a CompliancePart

    ComplianceCurves(ViewPlot& plot, QCPAxisRect& rect);

    void show(OutcomePtr outcome);

    [[nodiscard]] const std::vector<CompliantPlace>& places() const;
    [[nodiscard]] QCPGraph* sum() const { return m_sum; }
    [[nodiscard]] QCPGraph* used() const { return m_used; }
    [[nodiscard]] QCPGraph* stack(CompliancePart part) const; ///< upper edge; rests have none

    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] QString valuesAt(double x_mm) const override;
    void restyle() override;
    [[nodiscard]] ReadCurves readCurves() const override;
    [[nodiscard]] QCPRange values() const override;
    [[nodiscard]] QString axisLabel() const override;

private:
    void applyChoice() override;
    void fillUsed();
    [[nodiscard]] bool has(CompliancePart part) const;
    [[nodiscard]] bool hasZones() const;
    [[nodiscard]] std::optional<double> groundWith(double x_mm) const; ///< γ [nm/N]
    [[nodiscard]] QColor colourOf(CompliancePart part) const;
    [[nodiscard]] static QString nameOf(CompliancePart part);

    OutcomePtr m_outcome;
    QCPGraph* m_base;                   ///< the axis, for the first fill
    std::array<QCPGraph*, 4> m_stack{}; ///< parts up to bending
    QCPGraph* m_sum;
    QCPGraph* m_used;
};

} // namespace sparkout
