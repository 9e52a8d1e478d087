// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QObject>
#include <QString>

namespace sparkout {

/// Whether the inputs show and accept the stock of the part and of the stages per side, as files,
/// model and results do, or on the diameter.
class StockReading : public QObject {
    Q_OBJECT

public:
    [[nodiscard]] static StockReading& instance();

    [[nodiscard]] bool onDiameter() const { return m_onDiameter; }
    void setOnDiameter(bool onDiameter);

    /// Whether an input has both readings.
    [[nodiscard]] static bool isStock(const Field& field);
    /// Whether the input is currently shown on the diameter.
    [[nodiscard]] static bool isOnDiameter(const Field& field);
    /// The name of an input; for a stock with its reading: "Stock on diameter".
    [[nodiscard]] static QString label(const Field& field);
    /// The short form for the heading of a column.
    [[nodiscard]] static QString column(const Field& field);
    [[nodiscard]] static QString column(const Field& field, bool onDiameter);
    [[nodiscard]] static QString symbol(const Field& field); ///< "2Π" for "Π" on the diameter

signals:
    void changed();

private:
    StockReading() = default;

    bool m_onDiameter = false;
};

} // namespace sparkout
