// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report.h"
#include "ui/session/outcome.h"

#include <QCoreApplication>

/// The parts of the cycle card.
namespace sparkout::report {

class CycleCard {
    Q_DECLARE_TR_FUNCTIONS(CycleCard)
public:
    static QString operation(const Project& project); ///< its full name
    static Facts header(const Project& project, const QDate& date);
    static Facts settings(const Outcome& outcome); ///< speeds, dwells, overruns, tooling, gauge
    static Table stages(const Outcome& outcome);
    static Table accuracy(const Outcome& outcome); ///< by zone or section
    static Table requirements(const Outcome& outcome);
    static std::vector<Block> verdict(const Outcome& outcome);
    static QStringList estimates(const Outcome& outcome);
    static QStringList remarks(const Outcome& outcome);
};

/// A text of the user in one line, without signs that no document may hold.
[[nodiscard]] QString oneLine(const std::string& text);
/// The same over several lines.
[[nodiscard]] QString manyLines(QString text);
/// A deviation as a drawing writes it: "+18", "0", "−16" [µm].
[[nodiscard]] QString drawnDeviation(double value_um);
/// For a cell: never empty.
[[nodiscard]] QString cell(const QString& text);

} // namespace sparkout::report
