// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QCoreApplication>
#include <QStringList>

namespace sparkout::report {

/// Gathers the keys of core/SOURCES.md that are cited, in their order.
class Citations {
    Q_DECLARE_TR_FUNCTIONS(Citations)
public:
    QString cite(const QString& key);  ///< "[MODEL-3]"
    [[nodiscard]] Table table() const; ///< the keys with their sources

private:
    QStringList m_keys;
};

} // namespace sparkout::report
