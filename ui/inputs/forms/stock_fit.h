// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace sparkout {

class Document;

/// Makes the stocks of the stages add up to the part's.
class StockFit {
    Q_DECLARE_TR_FUNCTIONS(StockFit)

public:
    /// A description of the change; empty if the stocks add up.
    [[nodiscard]] static QString text(const Document& document);
    static void apply(Document& document); ///< as one step of the history
};

} // namespace sparkout
