// SPDX-License-Identifier: GPL-3.0-or-later
// What the formulas of the hand-out are made of and taken from.

#include "ui/report/handout/formula_meanings.h"

#include "core/quality/depth_limits.h"

#include <QCoreApplication>

#include <algorithm>

namespace sparkout::report {

namespace {

// Sheets are identified by the engine's names.
constexpr const char *balanceName = "Elastic balance of one radius", *normalName = "Normal force",
                     *tangentialName = "Tangential force",
                     *burnName = "Limiting depth of cut, burn",
                     *roughnessName = "Limiting feed, roughness",
                     *sharpeningName = "Limiting depth of cut, self-sharpening";

struct Meaning {
    const char* symbol;
    const char* text;            ///< to be translated in the context "Symbol"
    const char* sheet = nullptr; ///< name of the sheet it applies to; null: all others
};

constexpr Meaning meanings[] = {
    {"D_e", QT_TRANSLATE_NOOP("Symbol", "equivalent diameter of wheel and part")},
    {"V_d", QT_TRANSLATE_NOOP("Symbol", "surface speed of the part")},
    {"n_c", QT_TRANSLATE_NOOP("Symbol", "cutting grains on a square millimetre of the contact")},
    {"b_j", QT_TRANSLATE_NOOP("Symbol", "width of the cut of one grain")},
    {"κ", QT_TRANSLATE_NOOP("Symbol", "chips of the grains over the metal removed")},
    {"η", QT_TRANSLATE_NOOP("Symbol", "dullness: share of wear flats")},
    {"k_s", QT_TRANSLATE_NOOP("Symbol", "normal force of shear, per width and depth")},
    {"k_r", QT_TRANSLATE_NOOP("Symbol", "normal force of the wear flats, per width and root of "
                                        "the depth")},
    {"k_t", QT_TRANSLATE_NOOP("Symbol", "tangential force of shear, per width and depth")},
    {"K", QT_TRANSLATE_NOOP("Symbol", "normal force beyond the threshold, per width and depth")},
    {"K_z0", QT_TRANSLATE_NOOP("Symbol", "tangential force per area of chip")},
    {"K_z", QT_TRANSLATE_NOOP("Symbol", "tangential force beyond friction, per width and depth")},
    {"h_0", QT_TRANSLATE_NOOP("Symbol", "lag up to which the wheel only rubs")},
    {"K_1", QT_TRANSLATE_NOOP("Symbol", "the sources' name of b·k_s with axial feed")},
    {"K_2", QT_TRANSLATE_NOOP("Symbol", "the sources' name of b·k_r with axial feed")},
    {"K_3", QT_TRANSLATE_NOOP("Symbol", "the sources' name of b·k_s in plunge")},
    {"K_4", QT_TRANSLATE_NOOP("Symbol", "the sources' name of b·k_r in plunge")},
    {"P_y", QT_TRANSLATE_NOOP("Symbol", "normal force")},
    {"P_z", QT_TRANSLATE_NOOP("Symbol", "tangential force")},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"), burnName},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"), roughnessName},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"), sharpeningName},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"),
     "Limiting depth of cut, wheel drive"},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"),
     "Limiting depth of cut, work drive"},
    {"a", QT_TRANSLATE_NOOP("Symbol", "actual feed: the depth of this cut")},
    {"b", QT_TRANSLATE_NOOP("Symbol", "effective width of cut")},
    {"t_П", QT_TRANSLATE_NOOP("Symbol", "accumulated programmed feed, from the first touch on")},
    {"w", QT_TRANSLATE_NOOP("Symbol", "fourth root of the depth of cut")},
    {"R_max0", QT_TRANSLATE_NOOP("Symbol", "maximum radius of the blank")},
    {"R_min0", QT_TRANSLATE_NOOP("Symbol", "minimum radius of the blank")},
    {"R_k", QT_TRANSLATE_NOOP("Symbol", "radius k before the cut")},
    {"R_k′", QT_TRANSLATE_NOOP("Symbol", "radius k after the cut")},
    {"R_t", QT_TRANSLATE_NOOP("Symbol", "target radius")},
    {"Π_k", QT_TRANSLATE_NOOP("Symbol", "stock left at radius k")},
    {"h", QT_TRANSLATE_NOOP("Symbol", "stock left below the cut"), burnName},
    {"h", QT_TRANSLATE_NOOP("Symbol", "lag of the radius: what the wheel head is ahead of it")},
    {"γ", QT_TRANSLATE_NOOP("Symbol", "compliance of the system")},
    {"A", QT_TRANSLATE_NOOP("Symbol", "lag per depth of cut, without the wear flats")},
    {"C", QT_TRANSLATE_NOOP("Symbol", "deflection by the wear flats, per root of the depth")},
    {"√a", QT_TRANSLATE_NOOP("Symbol", "root of the depth of cut")},
    {"γ·P_y", QT_TRANSLATE_NOOP("Symbol", "deflection of the system")},
    {"y", QT_TRANSLATE_NOOP("Symbol", "deflection of all that yields"), balanceName},
    {"T", QT_TRANSLATE_NOOP("Symbol", "temperature rise of the surface that is just allowed")},
    {"√(Ωτ)", QT_TRANSLATE_NOOP("Symbol", "depth that the heat reaches during the contact")},
    {"x", QT_TRANSLATE_NOOP("Symbol", "that stock over twice this depth")},
    {"c", QT_TRANSLATE_NOOP("Symbol", "temperature rise per force, from the heat conduction")},
    {"p", QT_TRANSLATE_NOOP("Symbol", "coefficient of the cubic equation w³ + p·w = Q")},
    {"Q", QT_TRANSLATE_NOOP("Symbol", "right side of that equation")},
    {"S", QT_TRANSLATE_NOOP("Symbol", "Cardano's root on the way to w")},
    {"N_s", QT_TRANSLATE_NOOP("Symbol", "structure number of the wheel")},
    {"G", QT_TRANSLATE_NOOP("Symbol", "profile of the dressed grains")},
    {"y", QT_TRANSLATE_NOOP("Symbol", "opening of the wheel's profile by the cut"), roughnessName},
    {"s", QT_TRANSLATE_NOOP("Symbol", "share of the profile that the cut takes")},
    {"f", QT_TRANSLATE_NOOP("Symbol", "calibration of Ra: measured over computed")},
    {"u", QT_TRANSLATE_NOOP("Symbol", "overlap: revolutions over a point in a stroke")},
    {"S_ф", QT_TRANSLATE_NOOP("Symbol", "limiting actual feed")},
    {"S_b", QT_TRANSLATE_NOOP("Symbol", "section of a bond bridge")},
    {"D_b", QT_TRANSLATE_NOOP("Symbol", "diameter of a bond bridge")},
    {"n_g", QT_TRANSLATE_NOOP("Symbol", "grains on a square millimetre of the wheel")},
    {"f_g", QT_TRANSLATE_NOOP("Symbol", "force that breaks a grain")},
    {"f_b", QT_TRANSLATE_NOOP("Symbol", "force that breaks its bond")},
    {"f_cr", QT_TRANSLATE_NOOP("Symbol", "critical force of one grain")},
    {"F",
     QT_TRANSLATE_NOOP("Symbol", "force that the wheel bears, per width and root of the "
                                 "depth"),
     sharpeningName},
    {"F", QT_TRANSLATE_NOOP("Symbol", "tangential force that the drive allows, per width")},
};

bool isSheet(const FormulaSheet& sheet, const char* name) {
    return QLatin1StringView(sheet.name) == QLatin1StringView(name);
}

} // namespace

QString symbolMeaning(const FormulaSheet& sheet, const char* symbol) {
    const auto found = std::ranges::find_if(meanings, [&](const Meaning& meaning) {
        return QString::fromUtf8(meaning.symbol) == QString::fromUtf8(symbol)
               && (!meaning.sheet || isSheet(sheet, meaning.sheet));
    });
    return found == std::end(meanings) ? QString()
                                       : QCoreApplication::translate("Symbol", found->text);
}

std::vector<FormulaSource> sourcesOf(const FormulaSheet& sheet, const Place& at) {
    std::vector<FormulaSource> sources{{sheet.source, ""}};
    const bool plunges = at.zone == Zone::section || wheelStands(at);
    if (isSheet(sheet, normalName) || isSheet(sheet, tangentialName)) {
        sources.push_back({"KORCHAK", ""});
        sources.push_back({"ALSIGAR2021", plunges ? "1" : "2"});
    } else if (isSheet(sheet, balanceName)) {
        sources.push_back({"ALSIGAR2021", plunges ? "3" : "4"});
        if (at.zone == Zone::section) {
            sources.push_back({"AKINTSEVA2020", "1"});
        }
    } else if (isSheet(sheet, burnName)) {
        sources.push_back({"PEREVERZEV1999", "25"});
    } else if (isSheet(sheet, sharpeningName)) {
        sources.push_back({"PEREVERZEV1999", "23, 24"});
    } else if (isSheet(sheet, roughnessName)) {
        sources.push_back({"PEREVERZEV1999", ""});
    }
    return sources;
}

} // namespace sparkout::report
