// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"

#include <QObject>
#include <QString>

#include <optional>
#include <string>

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

/// The display of a number that differs from the file: sections are counted from 0 in files and
/// from 1 on screen and paper; in the inputs, stock may be on the diameter. Other numbers are
/// unchanged.
struct ShownScale {
    double factor = 1;
    double shift = 0; ///< added after the factor

    /// For an input, by its row or its path.
    [[nodiscard]] static ShownScale of(const Field& field);
    [[nodiscard]] static ShownScale at(const std::string& path);
    /// For an input where it is entered, and in its hints and messages.
    [[nodiscard]] static ShownScale ofInput(const Field& field);
    /// For the numbers of a message.
    [[nodiscard]] static ShownScale of(const Issue& issue);

    [[nodiscard]] double shown(double kept) const { return kept * factor + shift; }
    [[nodiscard]] double kept(double shown) const { return (shown - shift) / factor; }
    [[nodiscard]] std::optional<double> shown(const std::optional<double>& kept) const;
    [[nodiscard]] std::optional<double> kept(const std::optional<double>& shown) const;
    [[nodiscard]] Range shown(Range kept) const;
    [[nodiscard]] Detail shown(Detail kept) const; ///< converts only numbers

    friend bool operator==(const ShownScale&, const ShownScale&) = default;
};

} // namespace sparkout
