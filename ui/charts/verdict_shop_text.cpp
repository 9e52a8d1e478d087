// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/verdict_shop_text.h"

#include "core/units.h"
#include "ui/text/names.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace sparkout::shop {

namespace {

struct ShopText {
    Q_DECLARE_TR_FUNCTIONS(ShopText)
public:
    static QString outside(const ShopNumbers& shop, ShopRow row, BandSide side,
                           const QString& text);
};

/// `text` with the stages in place of %1; empty when there are none.
QString ShopText::outside(const ShopNumbers& shop, ShopRow row, BandSide side,
                          const QString& text) {
    QStringList stages;
    for (std::size_t z = 0; z < shop.stages.size(); ++z) {
        if (band(row, shop.stages[z]) == side) {
            stages << QString::number(z + 1);
        }
    }
    return stages.isEmpty() ? QString() : text.arg(stages.join(QStringLiteral(", ")));
}

QString depthText(const ShopColumn& column, Operation operation) {
    return ShopText::tr("a = %1 µm: %2")
        .arg(Names::significant(column.depth_mm.value * units::umPerMm),
             Names::place(column.depth_mm.at, operation));
}

QString energyText(const ShopColumn& column) {
    return ShopText::tr("%1 kJ for %2 mm³ in %3 min of grinding")
        .arg(Names::significant(column.energy_j / units::jPerKj),
             Names::significant(column.removedVolume_mm3),
             Names::significant(column.time_s / units::secondsPerMinute));
}

/// In the order of the rows.
constexpr const char* hints[] = {
    QT_TRANSLATE_NOOP("ShopText", "How many of them the stage took."),
    QT_TRANSLATE_NOOP("ShopText", "Machining time of the stage."),
    QT_TRANSLATE_NOOP(
        "ShopText", "Specific removal rate Q′_w = π·d·n·a/60: volume removed in a second by each "
                    "millimetre of the width that cuts, at the maximum actual feed a of the stage. "
                    "No band holds for every wheel: compare with cycles known to be good."),
    QT_TRANSLATE_NOOP("ShopText", "The specific removal rate at the mean actual feed of all passes "
                                  "of the stage, those that remove nothing included."),
    QT_TRANSLATE_NOOP(
        "ShopText",
        "Equivalent chip thickness h_eq = Q′_w/V_k, at the maximum actual feed of the stage: the "
        "layer of metal that leaves at the wheel's speed. Forces and roughness rise with it. No "
        "band holds for every wheel: compare with cycles known to be good."),
    QT_TRANSLATE_NOOP(
        "ShopText",
        "Aggressiveness 10⁶·(V_d/V_k)·√(a/D_e), at the maximum actual feed of the stage: how hard "
        "the contact loads a grain, for wheels of any size. Large, the grains break out; small, "
        "they rub. No band holds for every wheel: compare with cycles known to be good."),
    QT_TRANSLATE_NOOP("ShopText", "Overlap ratio B/s_ax, s_ax = S_ax/n: how many revolutions a "
                                  "place of the surface is under the wheel in one stroke. Below 1 "
                                  "strips stay unground. For the cycle: the least of its stages."),
    QT_TRANSLATE_NOOP(
        "ShopText",
        "Specific energy: ∫P_z·V_k dt over the volume removed. Plausible for steel: %1…%2 J/mm³. A "
        "dull wheel needs more; so does spark-out, where the wheel rubs more than it cuts."),
    QT_TRANSLATE_NOOP("ShopText", "Maximum wheel power P_z·V_k of any pass of the stage."),
    QT_TRANSLATE_NOOP(
        "ShopText", "Mean wheel power: the energy over the machining time of the stage, in all of "
                    "which the wheel grinds: plunging, dwells and strokes of the table."),
    QT_TRANSLATE_NOOP("ShopText", "Maximum normal force P_y of any pass of the stage."),
    QT_TRANSLATE_NOOP("ShopText", "Wheel rev/min to work rev/min. Within %1 of a whole number the "
                                  "waves of a wheel out of true print onto one another: over ten "
                                  "revolutions they shift by less than half of their length.")};

} // namespace

QString label(ShopRow row, Operation operation) {
    switch (row) {
    case ShopRow::count:
        return operation->countsStrokes ? ShopText::tr("Double strokes")
                                        : ShopText::tr("Revolutions");
    case ShopRow::time: return ShopText::tr("Time, min");
    case ShopRow::removalRate: return ShopText::tr("Q′w, mm³/(mm·s)");
    case ShopRow::meanRemovalRate: return ShopText::tr("   mean", "specific removal rate");
    case ShopRow::chip: return ShopText::tr("heq, µm");
    case ShopRow::aggressiveness: return ShopText::tr("Aggressiveness");
    case ShopRow::overlap: return ShopText::tr("Overlap B/s");
    case ShopRow::energy: return ShopText::tr("Energy, J/mm³");
    case ShopRow::peakPower: return ShopText::tr("Power, kW");
    case ShopRow::meanPower: return ShopText::tr("   mean", "power");
    case ShopRow::normalForce: return ShopText::tr("Force Py, N");
    case ShopRow::rotationRatio: return ShopText::tr("Rotation ratio");
    }
    return {};
}

QString name(ShopRow row, Operation operation) {
    switch (row) {
    case ShopRow::meanRemovalRate: return ShopText::tr("Q′w mean, mm³/(mm·s)");
    case ShopRow::meanPower: return ShopText::tr("Power mean, kW");
    default: return label(row, operation);
    }
}

QString hint(ShopRow row) {
    const QString text = ShopText::tr(hints[static_cast<std::size_t>(row)]);
    switch (row) {
    case ShopRow::energy: return text.arg(leastSpecificEnergy_j_mm3).arg(mostSpecificEnergy_j_mm3);
    case ShopRow::rotationRatio: return text.arg(number(nearInteger));
    default: return text;
    }
}

QString number(double value) {
    if (!(value > 0)) {
        return QStringLiteral("0");
    }
    const int zeros = value < 1 ? -static_cast<int>(std::floor(std::log10(value))) - 1 : 0;
    return Names::significant(value, std::max(1, 3 - zeros));
}

std::optional<double> amount(ShopRow row, const ShopColumn& column) {
    switch (row) {
    case ShopRow::count: return column.count;
    case ShopRow::time: return column.time_s / units::secondsPerMinute;
    case ShopRow::removalRate: return column.removalRate_mm2_s;
    case ShopRow::meanRemovalRate: return column.meanRemovalRate_mm2_s;
    case ShopRow::chip: return column.equivalentChip_um;
    case ShopRow::aggressiveness: return column.aggressiveness;
    case ShopRow::overlap: return column.overlap;
    case ShopRow::energy: return column.energy_j_mm3;
    case ShopRow::peakPower: return column.power_w.value / units::wPerKw;
    case ShopRow::meanPower: return column.meanPower_w / units::wPerKw;
    case ShopRow::normalForce: return column.normalForce_n.value;
    case ShopRow::rotationRatio: break;
    }
    return {};
}

QString value(ShopRow row, const ShopColumn& column) {
    if (row == ShopRow::count) {
        return QString::number(column.count);
    }
    const std::optional<double> v = amount(row, column);
    return v ? number(*v) : QString();
}

QString detail(ShopRow row, const ShopColumn& column, Operation operation) {
    if (column.depth_mm.value <= 0) {
        return {};
    }
    switch (row) {
    case ShopRow::removalRate:
    case ShopRow::chip:
    case ShopRow::aggressiveness: return depthText(column, operation);
    case ShopRow::energy:
    case ShopRow::meanPower: return energyText(column);
    case ShopRow::peakPower: return Names::place(column.power_w.at, operation);
    case ShopRow::normalForce: return Names::place(column.normalForce_n.at, operation);
    default: return {};
    }
}

BandSide band(ShopRow row, const ShopColumn& column) {
    switch (row) {
    case ShopRow::overlap: return column.overlapBand();
    case ShopRow::energy: return column.specificEnergyBand();
    default: return BandSide::none;
    }
}

QStringList remarks(const ShopNumbers& shop) {
    const auto outside = [&shop](ShopRow row, BandSide side, const QString& text) {
        return ShopText::outside(shop, row, side, text);
    };
    QStringList sentences{
        outside(ShopRow::energy, BandSide::below,
                ShopText::tr("Specific energy below %2 J/mm³ (stage %1): too little to be true; "
                             "the wheel's dullness or the flow stress may be set too low.")
                    .arg(QStringLiteral("%1"), Names::significant(leastSpecificEnergy_j_mm3, 2))),
        outside(ShopRow::energy, BandSide::above,
                ShopText::tr("Specific energy above %2 J/mm³ (stage %1): the wheel rubs more than "
                             "it cuts, as it does late in spark-out or when dull.")
                    .arg(QStringLiteral("%1"), Names::significant(mostSpecificEnergy_j_mm3, 2))),
        outside(ShopRow::overlap, BandSide::below,
                ShopText::tr("Overlap below 1 (stage %1): the table advances more than the wheel's "
                             "width in a revolution, strips stay unground."))};
    if (shop.ratioNearInteger()) {
        sentences << ShopText::tr("Wheel and work turn %1 : 1, near a whole number: waves of the "
                                  "wheel print onto one another. Change the work speed a little.")
                         .arg(number(shop.rotationRatio));
    }
    sentences.removeAll(QString());
    return sentences;
}

} // namespace sparkout::shop
