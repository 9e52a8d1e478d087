// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_outputs.h"
#include "core/batch/batch_summary.h"
#include "core/study/whole_batch.h"
#include "ui/table/csv_table.h"
#include "ui/table/value_table.h"

#include <QCoreApplication>
#include <QString>

#include <string>
#include <string_view>

namespace sparkout {

/// The figures of one characteristic of a batch: a column for each zone or section, a row for each
/// figure. Unless `tellsIndices` is set, the interval of the mean, Pp and Ppk are dashes.
[[nodiscard]] ValueTable batchFigures(const BatchSummary& summary, const std::string& name,
                                      bool tellsIndices);

/// One figure of a characteristic as displayed, by the key of its output; a dash if it has no
/// value.
[[nodiscard]] QString figureText(const CharacteristicFigures& figures, std::string_view key);

/// All figures of all characteristics with all their digits: a row for each characteristic of a
/// place.
[[nodiscard]] CsvTable batchFiguresTable(const BatchSummary& summary);

/// Texts of the batch view about characteristics, factors and figures.
class BatchText {
    Q_DECLARE_TR_FUNCTIONS(BatchText)
public:
    static QString name(const Characteristic& characteristic);      ///< "Mean diameter"
    static QString shortName(const Characteristic& characteristic); ///< "Diameter"
    static QString where(const Characteristic& characteristic);     ///< "RZ1", "whole part"
    static QString full(const Characteristic& characteristic);      ///< "Mean diameter, RZ1"
    static QString axis(const Characteristic& characteristic);      ///< "Mean diameter, µm"
    static QString factor(const GivenFactor& factor);               ///< "Stock per side"
    static QString factorAxis(const GivenFactor& factor);           ///< "Stock per side, mm"

    /// The value without unit; an estimate has one digit; only 0 is shown as 0.
    static QString value(double value, const Characteristic& characteristic);
    static QString scatter(double deviation, const Characteristic& characteristic);
    /// The value with the same number of decimals for all ticks of an axis.
    static QString mark(double value, const Characteristic& characteristic);
    static QString range(const Interval& interval, const Characteristic& characteristic);
    /// Whether there are enough values to distinguish the percentile from the extremes.
    static bool isStated(const Percentile& percentile, const CharacteristicSummary& of);
    /// The percentile, or a dash if it is not stated.
    static QString percentile(const Percentile& percentile, const CharacteristicSummary& of);
    /// "1.42 (1.20…1.60)"; with further digits where the lower bound would read as the limit.
    static QString capability(const std::optional<Estimate>& capability,
                              std::optional<double> limit = std::nullopt);
    static QString brief(const Estimate& capability); ///< "1.42"
    static QString share(const Share& share);         ///< "3 (6 %; 1.3…16.5 %)"
    static QString normality(const CharacteristicSummary& summary);

    /// "50 parts, Latin hypercube, seed 1."
    static QString run(const BatchOutcome& outcome);
    /// The usual causes of scatter that the project's batch leaves out: "compliance; gauge drift",
    /// or a dash; and a sentence on them, empty if there are none.
    static QString notCounted(const Project& project);
    static QString notCountedSentence(const Project& project);
    static QString counts(const BatchSummary& summary); ///< numbers of rejected parts and of those
                                                        ///< that did not reach size
    /// The counts, the verdict and its reason.
    static QString verdict(const BatchOutcome& outcome);
    static QString fitness(Fitness fitness);                   ///< "conforms to the drawing"
    static QString decision(const BatchOutcome& outcome);      ///< the reason of the verdict
    static QString test(NormalityTest test);                   ///< "Shapiro–Wilk"
    static QString normalityName(const BatchSummary& summary); ///< "Normality, p (Shapiro–Wilk)"
    static QString shortNormalityName(const BatchSummary& summary); ///< "Shapiro–Wilk, p"
    static std::optional<NormalityTest> testOf(const BatchSummary& summary);
    static QString progress(qint64 done, qint64 parts, double left_s);
    /// Number of a part and the values of its factors.
    static QString part(const BatchOutcome& outcome, std::int64_t part);
};

} // namespace sparkout
