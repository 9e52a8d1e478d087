// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/io/cli_shop.h"

#include "app/io/cli_report.h"
#include "core/digits.h"
#include "core/quality/ranges.h"
#include "core/units.h"

#include <algorithm>
#include <functional>

namespace sparkout::cli {

namespace {

/// Four significant digits, never an exponent.
std::string significant(double value) {
    return fixed(value, decimalsOf(value, 4));
}

std::string significant(const std::optional<double>& value) {
    return value ? significant(*value) : "-";
}

std::size_t codePoints(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

std::string padded(const std::string& text, std::size_t width) {
    const std::size_t size = codePoints(text);
    return size < width ? text + std::string(width - size, ' ') : text;
}

/// `value` of each stage and of the cycle, right-aligned after the label.
std::string line(const ShopNumbers& shop, const char* label,
                 const std::function<std::string(const ShopColumn&)>& value) {
    std::string text = padded(label, 21);
    const auto add = [&](const ShopColumn& column) {
        const std::string cell = value(column);
        const std::size_t size = codePoints(cell);
        text += std::string(size < 12 ? 12 - size : 1, ' ') + cell;
    };
    std::for_each(shop.stages.begin(), shop.stages.end(), add);
    add(shop.cycle);
    return text + '\n';
}

/// The value behind a mark when it lies outside its band.
std::string marked(BandSide band, const std::optional<double>& value) {
    const char* mark = band == BandSide::below ? "(<)" : band == BandSide::above ? "(>)" : "";
    return mark + significant(value);
}

bool isOutside(const ShopColumn& column) {
    const auto outside = [](BandSide band) {
        return band == BandSide::below || band == BandSide::above;
    };
    return outside(column.specificEnergyBand()) || outside(column.overlapBand());
}

std::string bandText(const ShopNumbers& shop) {
    if (std::none_of(shop.stages.begin(), shop.stages.end(), isOutside)) {
        return {};
    }
    return padded("  (<) below, (>) above", 24) + "the usual: energy "
           + fixed(leastSpecificEnergy_j_mm3, 0) + "…" + fixed(mostSpecificEnergy_j_mm3, 0)
           + " J/mm³, overlap from " + fixed(leastOverlap, 0) + '\n';
}

std::string headline(const ShopNumbers& shop) {
    std::size_t stage = 0;
    return line(shop, "shop's numbers", [&](const ShopColumn&) {
        return stage++ < shop.stages.size() ? "stage " + std::to_string(stage) : "cycle";
    });
}

std::string ratioText(const ShopNumbers& shop) {
    return padded("  rpm ratio", 21) + significant(shop.rotationRatio) + " wheel : work"
           + (shop.ratioNearInteger() ? ", near a whole number: WAVINESS" : "") + '\n';
}

} // namespace

std::string shopText(const ShopNumbers& shop) {
    using C = ShopColumn;
    std::string text = headline(shop);
    const auto add = [&](const char* label, const std::function<std::string(const C&)>& value) {
        text += line(shop, label, value);
    };
    add("  Q'w, mm³/(mm·s)", [](const C& c) { return significant(c.removalRate_mm2_s); });
    add("  mean Q'w", [](const C& c) { return significant(c.meanRemovalRate_mm2_s); });
    add("  h_eq, µm", [](const C& c) { return significant(c.equivalentChip_um); });
    add("  aggressiveness", [](const C& c) { return significant(c.aggressiveness); });
    if (shop.cycle.overlap) {
        add("  overlap B/s_ax", [](const C& c) { return marked(c.overlapBand(), c.overlap); });
    }
    add("  energy, J/mm³",
        [](const C& c) { return marked(c.specificEnergyBand(), c.energy_j_mm3); });
    add("  peak power, W", [](const C& c) { return significant(c.power_w.value); });
    add("  mean power, W", [](const C& c) { return significant(c.meanPower_w); });
    add("  peak force, N", [](const C& c) { return significant(c.normalForce_n.value); });
    return text + bandText(shop) + ratioText(shop);
}

} // namespace sparkout::cli
