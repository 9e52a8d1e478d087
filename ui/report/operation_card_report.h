// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "core/setup/setup_run.h"
#include "ui/report/card_sheets.h"
#include "ui/report/format/report.h"
#include "ui/session/settings.h"

#include <QCoreApplication>

#include <utility>
#include <vector>

namespace sparkout::report {

/// The operation card of a set-up: the sheets of the form, and tables with the same contents for
/// other formats; and the sketch sheet after the card.
class OperationCardReport {
    Q_DECLARE_TR_FUNCTIONS(OperationCard)
public:
    [[nodiscard]] static Report write(const Setup& setup, const SetupRun& run,
                                      const Company& company, const QString& file,
                                      const QDate& date);

    /// Only the sketch sheet.
    [[nodiscard]] static Report sketch(const Setup& setup, const Company& company,
                                       const QString& file, const QDate& date);

    static CardHead head(const Setup& setup, const OperationCard& card, const Company& company,
                         const QDate& date);

private:
    static void addSketch(Report& report, const CardHead& head, const Setup& setup);
    static FormHead formHead(const CardHead& head, const form::Kind& kind);
    static std::vector<std::pair<QString, QString>> entries(const CardHead& head);
    static Table table(const std::vector<CardRow>& rows);
};

} // namespace sparkout::report
