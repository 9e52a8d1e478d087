// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace sparkout {

class Document;

/// The command that makes the stocks of the stages add up to the part's.
class StockFit {
    Q_DECLARE_TR_FUNCTIONS(StockFit)

public:
    /// What it would do; empty where the stocks add up.
    [[nodiscard]] static QString text(const Document& document);
    static void apply(Document& document); ///< one step of the history
};

} // namespace sparkout
