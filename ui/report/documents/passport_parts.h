// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_verdict.h"
#include "ui/report/documents/report_kinds.h"

#include <QCoreApplication>

/// The parts of the accuracy passport.
namespace sparkout::report {

class Passport {
    Q_DECLARE_TR_FUNCTIONS(Passport)
public:
    // What was put in.
    static Facts drawing(const Project& project);                ///< tolerances and other limits
    static std::vector<Block> scenarios(const Subject& subject); ///< factors, laws, correlations
    static QString law(const GivenFactor& factor);               ///< "uniform, 0.14…0.16"
    static Table inputs(const Project& project);                 ///< all that the model reads
    static std::vector<Block> recomputing(const Subject& subject);

    // What comes out.
    static Fitness fitness(const Subject& subject);
    static QString decision(const Subject& subject); ///< what decided it
    static std::vector<Block> verdict(const Subject& subject);
    static Table nominal(const Outcome& outcome); ///< of a passport without a batch
    static Table values(const Subject& subject);  ///< nominal, extremes, mean and s
    static Table capability(const BatchSummary& summary);
    static Table percentiles(const BatchSummary& summary);
    static std::vector<Block> worst(const Subject& subject);
    static Table requirements(const Outcome& outcome); ///< of one part, with margins and place

    // Figures, made in the window's thread.
    static Figure histograms(const BatchSummary& summary, const std::string& name);
    static std::optional<Figure> capabilityChart(const BatchSummary& summary);
    static Figure alongThePart(const Outcome& outcome);
    static Figure crossSections(const Outcome& outcome);

    /// The characteristic that decides: of the greatest share out of tolerance, else the least
    /// Ppk; null when none is limited.
    static const CharacteristicSummary* deciding(const BatchSummary& summary);
    static const CharacteristicSummary* leastCapable(const BatchSummary& summary);
};

} // namespace sparkout::report
