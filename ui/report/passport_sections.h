// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/project/given_factors.h"
#include "ui/report/format/report.h"
#include "ui/report/report_kinds.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace sparkout::report {

/// The inputs of the cycle and its batch, for the accuracy passport.
class PassportInputs {
    Q_DECLARE_TR_FUNCTIONS(PassportInputs)
public:
    static Facts drawing(const Project& project);                ///< tolerances and other limits
    static std::vector<Block> scenarios(const Subject& subject); ///< factors, laws, correlations
    static QString law(const GivenFactor& factor);               ///< "uniform, 0.14…0.16"
    static Table inputs(const Project& project);                 ///< all inputs of the model
    static std::vector<Block> recomputing(const Subject& subject);
};

/// The predicted results of the cycle and its batch compared with the drawing, for the accuracy
/// passport.
class PassportPrediction {
    Q_DECLARE_TR_FUNCTIONS(PassportPrediction)
public:
    static Table nominal(const Outcome& outcome); ///< for a passport without a batch
    static Table values(const Subject& subject);  ///< nominal, extremes, mean and s
    static Table capability(const BatchSummary& summary);
    static Table percentiles(const BatchSummary& summary);
    static std::vector<Block> worst(const Subject& subject);
    /// The requirements of drawing and process on one part, with margins and places.
    static Table requirements(const Outcome& outcome);
    static Table settings(const Outcome& outcome); ///< requirements on the settings
};

/// Ppk of a batch with its bounds, a row for each characteristic, the least first.
class CapabilityChart {
    Q_DECLARE_TR_FUNCTIONS(CapabilityChart)
public:
    /// Empty if no characteristic has a Ppk.
    [[nodiscard]] static std::optional<Figure> figure(const BatchSummary& summary);

private:
    static constexpr double left = 270, right = 670, top = 6, bottom = 26, rowHeight = 20;
    static constexpr int fontPixels = 12;

    explicit CapabilityChart(std::vector<CharacteristicSummary> rows);

    [[nodiscard]] QSizeF size() const;
    void paint(QPainter& painter) const;
    void paintScale(QPainter& painter) const;
    void paintRow(QPainter& painter, const CharacteristicSummary& of, double y) const;
    [[nodiscard]] double x(double ppk) const;

    std::vector<CharacteristicSummary> m_rows; ///< the least Ppk first
    double m_lowest = 0, m_highest = 3;        ///< ends of the scale; values outside are cut off
};

} // namespace sparkout::report
