// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/given_factors.h"
#include "ui/report/documents/report_kinds.h"

#include <QCoreApplication>

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

} // namespace sparkout::report
