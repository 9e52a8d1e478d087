// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include <optional>

namespace sparkout {

/// Arithmetic in number fields: + − * / and brackets, numbers with a decimal point or comma. It is
/// computed in exact fractions and rounded once, so that (30-29,6)/2 is the same double as 0,2.
class Calculation {
    Q_DECLARE_TR_FUNCTIONS(Calculation)

public:
    /// Empty if the text has no operator and no bracket.
    [[nodiscard]] static std::optional<Calculation> of(const QString& text);

    [[nodiscard]] std::optional<double> value() const { return m_value; }
    /// Why there is no value, in the current language.
    [[nodiscard]] const QString& fault() const { return m_fault; }

private:
    class Reader;
    Calculation(std::optional<double> value, QString fault)
        : m_value(value), m_fault(std::move(fault)) {}

    std::optional<double> m_value;
    QString m_fault;
};

} // namespace sparkout
