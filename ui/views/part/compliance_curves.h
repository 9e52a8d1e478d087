// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/compliance.h"
#include "core/process/system_compliance.h"
#include "core/study/gauge_placement.h"
#include "core/study/outcome.h"
#include "ui/chart/line_chart.h"

#include <QCoreApplication>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

struct Part;

/// Common functions of the charts over the length of the part. Diameters are drawn relative to the
/// middle of the tolerance band.
class LengthCurves {
    Q_DECLARE_TR_FUNCTIONS(LengthCurves)
public:
    static double middle_um(const Part& part); ///< middle of the tolerance band, from nominal
    static LineChart chart();                  ///< without series
    /// Adds the limits of the tolerance band over the length, ± half of it, after the series;
    /// visible unless they are far from the curves.
    static void addLimits(LineChart& chart, const Part& part, int key);
    /// Makes a series readable by the cursors if it runs along the part; of a band both edges.
    static void read(LineChart& chart, const ChartSeries& of, Digits digits);
};

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

using GaugePlacementPtr = std::shared_ptr<const GaugePlacement>;

/// The diameters of all zones or sections over the place of the gauge, the one farthest from the
/// middle of the tolerance, the best place and the current one.
class GaugeCurves {
    Q_DECLARE_TR_FUNCTIONS(GaugeCurves)
public:
    static constexpr int spreadKey = 200, farthestKey = 201, bestKey = 202, presentKey = 203,
                         limitsKey = 204, sectionKey = 300; ///< keys of the legend; sections follow

    GaugeCurves() = default;
    /// @param outcome the run with the gauge at `present_mm`
    GaugeCurves(GaugePlacementPtr placement, OutcomePtr outcome, double present_mm);

    [[nodiscard]] const GaugePlacement* placement() const { return m_placement.get(); }
    [[nodiscard]] const GaugePosition* best() const;
    /// The greatest distance of a diameter from the middle of the tolerance [µm].
    [[nodiscard]] double farthest_um(const GaugePosition& position) const;
    [[nodiscard]] double farthestNow_um() const; ///< in the shown run
    [[nodiscard]] LineChart chart() const;

private:
    /// A position of the gauge at a place: in traverse each represents its zone.
    struct Place {
        double x_mm;
        const GaugePosition* position;
    };
    using Value = std::function<double(const GaugePosition&)>;

    [[nodiscard]] std::vector<Place> drawn() const;
    /// Values at the places of completed cycles, with gaps at the others.
    [[nodiscard]] std::vector<XY> lineOf(const Value& value) const;
    [[nodiscard]] std::vector<ChartSeries> sections() const;
    [[nodiscard]] double fromMiddle_um(double deviation_mm) const;
    [[nodiscard]] QString nameOf(std::size_t section) const;
    [[nodiscard]] ChartTable table() const;
    [[nodiscard]] QString valuesAt(double x_mm) const;

    GaugePlacementPtr m_placement;
    OutcomePtr m_outcome;
    double m_present_mm = 0;
};

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
