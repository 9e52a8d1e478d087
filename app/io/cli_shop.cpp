// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/io/cli_shop.h"

#include "app/io/cli_report.h"
#include "core/digits.h"
#include "core/quality/ranges.h"

#include <algorithm>
#include <vector>

namespace sparkout::cli {

namespace {

constexpr std::size_t labelWidth = 26, cellWidth = 12;

/// Formats four significant digits without an exponent.
std::string significant(double value) {
    return fixed(value, decimalsOf(value, 4));
}

std::size_t codePoints(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

std::string label(const std::string& text) {
    const std::size_t size = codePoints(text);
    return text + std::string(size < labelWidth ? labelWidth - size : 1, ' ');
}

/// Right-aligns a text.
std::string cell(const std::string& text) {
    const std::size_t size = codePoints(text);
    return std::string(size < cellWidth ? cellWidth - size : 1, ' ') + text;
}

/// "-" without a value.
std::string valueText(const OutputValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return std::to_string(*whole);
    }
    const auto* number = std::get_if<double>(&value);
    return number ? significant(*number) : "-";
}

/// A value with a mark if it lies outside its band.
std::string marked(BandSide band, const std::string& value) {
    const char* const mark = band == BandSide::below ? "(<)" : band == BandSide::above ? "(>)" : "";
    return mark + value;
}

std::string nameOf(const OutputRow& row, bool revolutions = false) {
    return std::string("  ") + row.labelOf(revolutions)
           + (*row.unit ? std::string(", ") + row.unit : std::string());
}

std::string bandText(const ShopNumbers& shop) {
    const bool isOutside = std::ranges::any_of(shop.stages, [](const ShopColumn& stage) {
        return std::ranges::any_of(shopColumnOutputs(), [&stage](const Output<ShopColumn>& row) {
            const BandSide band = row.bandOf(stage);
            return band == BandSide::below || band == BandSide::above;
        });
    });
    return isOutside ? label("  (<) below, (>) above") + "the usual: energy "
                           + fixed(leastSpecificEnergy_j_mm3, 0) + "…"
                           + fixed(mostSpecificEnergy_j_mm3, 0) + " J/mm³, overlap from "
                           + fixed(leastOverlap, 0) + '\n'
                     : std::string();
}

} // namespace

std::string shopText(const ShopNumbers& shop, bool revolutions) {
    std::vector<const ShopColumn*> columns;
    std::string text = label("shop's numbers");
    for (const ShopColumn& stage : shop.stages) {
        columns.push_back(&stage);
        text += cell("stage " + std::to_string(columns.size()));
    }
    columns.push_back(&shop.cycle);
    text += cell("cycle") + '\n';
    for (const Output<ShopColumn>& row : shopColumnOutputs()) {
        const auto has = [&row](const ShopColumn* column) { return row.of(*column).index() != 0; };
        if (row.detail || (row.sparse && std::ranges::none_of(columns, has))) {
            continue;
        }
        text += label(nameOf(row, revolutions));
        for (const ShopColumn* column : columns) {
            text += cell(marked(row.bandOf(*column), valueText(row.of(*column))));
        }
        text += '\n';
    }
    text += bandText(shop);
    for (const Output<ShopNumbers>& row : shopOutputs()) {
        if (!row.detail) {
            text += label(nameOf(row)) + valueText(row.of(shop))
                    + (row.bandOf(shop) == BandSide::above ? ", near a whole number: WAVINESS" : "")
                    + '\n';
        }
    }
    return text;
}

} // namespace sparkout::cli
