// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/operation_card.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <vector>

namespace sparkout::report {

/// A line of an operation card as text, not yet wrapped.
struct CardRow {
    QString symbol; ///< "О"; empty: a continuation
    QString text;
    QStringList cells; ///< from ПИ to V; empty: the text may extend over them
    QString main, auxiliary;
    bool keeps = false; ///< keep on one sheet with the next row
};

/// The texts of operation card and sketch sheet, in the current language.
class CardRows {
    Q_DECLARE_TR_FUNCTIONS(OperationCard)
public:
    [[nodiscard]] static std::vector<CardRow> of(const OperationCard& card, const Setup& setup,
                                                 const SetupRun& run);
    static QString operation(const Setup& setup); ///< its name, for all surfaces
    static QString surfaceName(const Setup& setup, std::size_t surface); ///< "2 (bearing seat)"
    static QStringList tolerances(const Part& part); ///< "roundness 0.003", in mm
    static QString minutes(double value_min);        ///< two decimals
    /// Rounds minutes so that they add up to the rounded sum.
    static QStringList minutesAddingUp(const std::vector<double>& values_min);

private:
    static QString text(const CardLine& line, const Setup& setup, const SetupRun& run);
    static QString fixture(const Setup& setup);
    static QString grind(const CardLine& line, const Setup& setup, const Project& project);
    static QString tooling(const Project& project);
    static QString settings(const CardLine& line, const SetupRun& run, const Project& project);
    static QString regime(const CardRegime& regime);
    static QString measuring(const Project& project);
    static QString control(const CardLine& line, const Setup& setup);
    static QStringList cells(const CardRegime& regime);
};

} // namespace sparkout::report
