// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profiles_text.h"

#include "core/study/length_lines.h"
#include "core/units.h"
#include "ui/text/names.h"

#include <QStringList>

#include <cmath>

namespace sparkout {

namespace {

/// µm with three decimals, the resolution of the magnified profiles.
QString signedUm(double value_mm, int decimals = 3) {
    const double value_um = value_mm * units::umPerMm;
    const bool positive = value_um >= 0.5 * std::pow(10.0, -decimals);
    return (positive ? QStringLiteral("+") : QString()) + Names::fixed(value_um, decimals);
}

QString range(double low_mm, double high_mm, int decimals = 3) {
    const QString low = signedUm(low_mm, decimals), high = signedUm(high_mm, decimals);
    return low == high ? low : low + QChar(0x2026) + high;
}

/// A value to which the machine adds its own.
QString formUm(double value_mm, bool knowsMachine, int decimals = 3) {
    return Names::formAmount(value_mm * units::umPerMm, knowsMachine, decimals);
}

} // namespace

QString ProfilesText::blankText(const ProfileSeries& series, const Profile& profile, int k) {
    const double blank = series.blankOf(profile)[static_cast<std::size_t>(k)];
    return tr("; blank %1 µm from target").arg(signedUm(blank - series.target_mm));
}

QString ProfilesText::magnification(double value) {
    return QChar(0x00D7) + Names::fixed(value, 0);
}

QString ProfilesText::numbers(const ProfileSeries& series, const Profile& profile, bool brief) {
    if (!series.isWhole) {
        return brief ? tr("strips uncut") : tr("Strips stay uncut: size and form are not known");
    }
    const int decimals = brief ? 2 : 3;
    const QString diameters = range(profile.diameterMin_mm, profile.diameterMax_mm, decimals);
    const QString runout = formUm(profile.radialRunout_mm, series.knowsRunout, decimals);
    const bool out = outOfField(series, profile);
    if (brief) {
        return tr("ΔD %1 %2", "deviations of the diameter in µm, short; then ✓ or ✗")
                   .arg(diameters, out ? QStringLiteral("✗") : QStringLiteral("✓"))
               + u'\n' + tr("runout %1 µm").arg(runout);
    }
    return (out ? tr("✗ Diameter %1 µm: outside the field") : tr("✓ Diameter %1 µm: in the field"))
               .arg(diameters)
           + u'\n' + Names::ofMachine(tr("Radial runout %1 µm").arg(runout), series.knowsRunout);
}

QString ProfilesText::roundness(const RoundnessZone& zone, bool brief, bool knowsMachine) {
    const int decimals = brief ? 2 : 3;
    const QString deviation = formUm(zone.deviation(), knowsMachine, decimals);
    const QString eccentricity =
        Names::amountFixed(std::hypot(zone.x_mm, zone.y_mm) * units::umPerMm, decimals);
    if (brief) {
        return tr("RONt %1, e %2 µm").arg(deviation, eccentricity);
    }
    return Names::ofMachine(tr("RONt %1 µm, eccentricity %2 µm").arg(deviation, eccentricity),
                            knowsMachine);
}

QString ProfilesText::measured(const Profile& profile) {
    return tr("%1 radii, from own mean").arg(profile.radii_mm.size());
}

QString ProfilesText::filter(std::optional<int> cutoff_upr) {
    return cutoff_upr ? tr("Gaussian filter %1 UPR").arg(*cutoff_upr) : tr("not filtered");
}

QString ProfilesText::sample(const ProfileSeries& series, const Profile& profile,
                             const QString& name, int k, bool withBlank) {
    const double angle = k * 360.0 / static_cast<double>(profile.radii_mm.size());
    const double radius = profile.radii_mm[static_cast<std::size_t>(k)];
    const double across = diameterAt(profile, k);
    if (std::isnan(radius)) {
        return tr("%1, φ = %2° (k = %3): in a gap of the surface")
            .arg(name, Names::fixed(angle, 1), QString::number(k));
    }
    if (std::isnan(across)) {
        const QString text =
            tr("%1, φ = %2° (k = %3): radius %4 µm from target, %5 µm from its "
               "mean; opposite a gap")
                .arg(name, Names::fixed(angle, 1), QString::number(k),
                     signedUm(radius - series.target_mm), signedUm(radius - profile.mean_mm));
        return withBlank ? text + blankText(series, profile, k) : text;
    }
    QString text = tr("%1, φ = %2° (k = %3): radius %4 µm from target, %5 µm from its mean; "
                      "diameter across %6 mm, %7 µm from nominal")
                       .arg(name, Names::fixed(angle, 1), QString::number(k),
                            signedUm(radius - series.target_mm), signedUm(radius - profile.mean_mm),
                            Names::fixed(across, 5), signedUm(across - series.nominal_mm));
    return withBlank ? text + blankText(series, profile, k) : text;
}

QString ProfilesText::stretch(const ProfileSeries& series, const Profile& profile, bool withBlank) {
    const LengthSpread radius = spreadOf(profile.radii_mm, series, LengthQuantity::radius_um);
    const auto mm = [](double value_um) { return value_um / units::umPerMm; };
    const QString place =
        series.operation->travels
            ? tr("%1…%2 mm").arg(Names::fixed(profile.from_mm, 1), Names::fixed(profile.to_mm, 1))
            : tr("%1 mm").arg(Names::fixed(profile.position_mm, 1));
    QString text = tr("%1, %2: radius %3 µm from target, mean %4 µm; diameter %5 µm from nominal; "
                      "runout %6 µm")
                       .arg(Names::zone(profile.zone, profile.section), place,
                            range(mm(radius.min), mm(radius.max)), signedUm(mm(radius.mean)),
                            range(profile.diameterMin_mm, profile.diameterMax_mm),
                            formUm(profile.radialRunout_mm, series.knowsRunout));
    text = Names::ofMachine(text, series.knowsRunout);
    if (series.isWhole && !series.zoneForms.empty()) {
        const ZoneForm& zone = series.zoneForms.at(static_cast<std::size_t>(profile.section));
        text += tr("; cylindricity %1 µm, total runout %2 µm, taper %3 µm")
                    .arg(formUm(zone.cylindricity_mm, series.knowsRoundness, 2),
                         formUm(zone.totalRunout_mm, series.knowsRunout, 2),
                         Names::signedMicrometres(zone.profile.taper_mm * units::umPerMm));
    }
    if (withBlank) {
        const LengthSpread blank =
            spreadOf(series.blankOf(profile), series, LengthQuantity::radius_um);
        text += tr("; blank %1 µm from target").arg(range(mm(blank.min), mm(blank.max)));
    }
    return text;
}

QString ProfilesText::moment(const ProfileSeries& series) {
    QString text =
        Names::moment(series.operation, series.stroke, series.strokeCount, series.strokeDone);
    if (series.stroke == 0) {
        return text;
    }
    if (series.stage > 0) {
        text = tr("%1, stage %2").arg(text).arg(series.stage);
    }
    return tr("%1, %2 s").arg(text, Names::fixed(series.time_s, 1));
}

QString ProfilesText::summary(const ProfileSeries& series, const std::vector<int>& shown) {
    QStringList sentences{moment(series)};
    for (const int index : shown) {
        const Profile& p = series.profiles[static_cast<std::size_t>(index)];
        sentences << tr("%1. %2").arg(
            Names::zoneFull(p.zone, p.section),
            numbers(series, p, false).replace(u'\n', QStringLiteral("; ")));
    }
    return sentences.join(QStringLiteral(". "));
}

} // namespace sparkout
