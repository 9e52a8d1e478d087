// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QObject>
#include <QString>

namespace sparkout {

/// Whether the inputs show and take the stock of the part and of the stages per side, as files keep
/// it and as the model and all results state it, or on the diameter.
class StockReading : public QObject {
    Q_OBJECT

public:
    [[nodiscard]] static StockReading& instance();

    [[nodiscard]] bool onDiameter() const { return m_onDiameter; }
    void setOnDiameter(bool onDiameter);

    /// Whether an input has both readings.
    [[nodiscard]] static bool isStock(const Field& field);
    /// Whether it is read on the diameter now.
    [[nodiscard]] static bool isOnDiameter(const Field& field);
    /// The name of an input; of a stock with its reading: "Stock on diameter".
    [[nodiscard]] static QString label(const Field& field);
    /// The same where it must be short, at the head of a column.
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
