// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/limit_names.h"

#include "core/quality/roughness.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QLocale>

#include <cmath>
#include <tuple>
#include <utility>

namespace sparkout {

namespace {

constexpr double mostPercent = 999;

/// The first strength of grain or bond that is missing; empty: all are given.
std::string missingStrength(const Wheel& wheel) {
    const std::pair<bool, const char*> strengths[] = {
        {wheel.grain_surface_energy_j_m2.has_value(), "/wheel/grain_surface_energy_j_m2"},
        {wheel.grain_modulus_gpa.has_value(), "/wheel/grain_modulus_gpa"},
        {wheel.bond_surface_energy_j_m2.has_value(), "/wheel/bond_surface_energy_j_m2"},
        {wheel.bond_modulus_gpa.has_value(), "/wheel/bond_modulus_gpa"},
    };
    for (const auto& [given, path] : strengths) {
        if (!given) {
            return path;
        }
    }
    return {};
}

} // namespace

QString LimitNames::limit(ConstraintKind kind) {
    switch (kind) {
    case ConstraintKind::burn: return tr("burn");
    case ConstraintKind::selfSharpening: return tr("self-sharpening");
    case ConstraintKind::wheelPower: return tr("wheel drive");
    case ConstraintKind::workPower: return tr("work drive");
    case ConstraintKind::roughness: return tr("roughness of the last cut");
    default: break;
    }
    return Names::inSentence(Names::constraint(kind));
}

QString LimitNames::group(const LimitGroup& group) {
    const QString zone = Names::zone(group.zone, group.section);
    if (group.zone == Zone::section || group.zone == Zone::nz) {
        return zone;
    }
    return group.standing ? tr("%1, wheel standing").arg(zone) : tr("%1, strokes").arg(zone);
}

QString LimitNames::percent(double share) {
    QLocale numbers;
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    const double percent = 100 * share;
    return percent > mostPercent || std::isnan(percent)
               ? tr(">%1 %").arg(numbers.toString(mostPercent, 'f', 0))
               : tr("%1 %").arg(numbers.toString(percent, 'f', percent < 10 ? 1 : 0));
}

std::vector<OffLimit> LimitNames::off(const Project& project) {
    using enum ConstraintKind;
    const Tolerance& tolerance = project.part.tolerance;
    const std::string strength = missingStrength(project.wheel);
    const std::tuple<bool, ConstraintKind, std::string> all[] = {
        {project.material.burn_rise_k.has_value(), burn, "/material/burn_rise_k"},
        {strength.empty(), selfSharpening, strength},
        {project.machine.wheel_drive_kw.has_value(), wheelPower, "/machine/wheel_drive_kw"},
        {project.machine.work_drive_kw.has_value(), workPower, "/machine/work_drive_kw"},
        {tolerance.roughness_ra_um.has_value(), roughness, "/part/tolerance/roughness_ra_um"},
        {tolerance.roundness_um.has_value(), roundness, "/part/tolerance/roundness_um"},
        {tolerance.radial_runout_um.has_value(), radialRunout, "/part/tolerance/radial_runout_um"},
        {tolerance.cylindricity_um.has_value(), cylindricity, "/part/tolerance/cylindricity_um"},
        {tolerance.total_runout_um.has_value(), totalRunout, "/part/tolerance/total_runout_um"},
    };
    std::vector<OffLimit> off;
    for (const auto& [on, kind, path] : all) {
        if (!on) {
            off.push_back({kind, path});
        }
    }
    return off;
}

QString LimitNames::notChecked(const QStringList& names) {
    return names.isEmpty()
               ? QString()
               : tr("Not checked, for want of an input: %1").arg(names.join(QLatin1String(", ")));
}

QString LimitNames::notChecked(const Project& project) {
    QStringList names;
    for (const OffLimit& each : off(project)) {
        names << limit(each.kind);
    }
    return notChecked(names);
}

bool LimitNames::isGuess(ConstraintKind kind, const Project& project) {
    return kind == ConstraintKind::roughness && !isRoughnessCalibrated(project);
}

QString LimitNames::guessed() {
    return tr("Roughness is not limiting while it is not calibrated: with the roughness "
              "calibration of 1 the computed Ra is too small, and no depth of cut can be told "
              "from it.");
}

QString LimitNames::missingLinks(const Project& project) {
    QStringList lines{notCheckedLinks(project)};
    if (project.part.tolerance.roughness_ra_um && isGuess(ConstraintKind::roughness, project)) {
        static const std::string path = "/wheel/roughness_factor";
        lines << tr("Roughness is not limiting while it is not calibrated: %1")
                     .arg(QStringLiteral("<a href=\"%1\">%2</a>")
                              .arg(QString::fromStdString(path),
                                   locationText(path).toHtmlEscaped()));
    }
    lines.removeAll(QString());
    return lines.join(QStringLiteral("<br>"));
}

QString LimitNames::notCheckedLinks(const Project& project) {
    QStringList links;
    for (const OffLimit& each : off(project)) {
        links << QStringLiteral("<a href=\"%1\">%2</a>")
                     .arg(QString::fromStdString(each.path), limit(each.kind).toHtmlEscaped());
    }
    return notChecked(links);
}

} // namespace sparkout
