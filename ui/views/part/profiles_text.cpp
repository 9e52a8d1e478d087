// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/profiles_text.h"

#include "core/surface/harmonics.h"
#include "core/units.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

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

QString ProfilesText::roundness(const RoundnessZone& zone, bool brief, bool knowsRoundness,
                                bool knowsEccentricity) {
    const int decimals = brief ? 2 : 3;
    const QString deviation = formUm(zone.deviation(), knowsRoundness, decimals);
    const QString eccentricity =
        formUm(std::hypot(zone.x_mm, zone.y_mm), knowsEccentricity, decimals);
    if (brief) {
        return tr("RONt %1, e %2 µm").arg(deviation, eccentricity);
    }
    return Names::ofMachine(tr("RONt %1 µm, eccentricity %2 µm").arg(deviation, eccentricity),
                            knowsRoundness && knowsEccentricity);
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

Profile shownProfile(Profile profile, ReferenceCircles circles, std::optional<int> cutoff_upr) {
    if (cutoff_upr) {
        filterProfile(profile, *cutoff_upr);
    }
    if (circles == ReferenceCircles::minimumZone) {
        addMinimumZone(profile);
    } else if (circles == ReferenceCircles::inscribed
               || circles == ReferenceCircles::circumscribed) {
        addHeldCircles(profile);
    }
    return profile;
}

const RoundnessZone* shownZone(const Profile& profile, ReferenceCircles circles) {
    const auto held = [](const std::optional<RoundnessZone>& zone) {
        return zone ? &*zone : nullptr;
    };
    switch (circles) {
    case ReferenceCircles::leastSquares: return &profile.leastSquares;
    case ReferenceCircles::minimumZone: return &profile.minimumZone;
    case ReferenceCircles::inscribed: return held(profile.inscribed);
    case ReferenceCircles::circumscribed: return held(profile.circumscribed);
    case ReferenceCircles::none: break;
    }
    return nullptr;
}

std::optional<ProfileLine> lineOf(ReferenceCircles circles) {
    switch (circles) {
    case ReferenceCircles::leastSquares: return ProfileLine::leastSquares;
    case ReferenceCircles::minimumZone: return ProfileLine::minimumZone;
    case ReferenceCircles::inscribed: return ProfileLine::inscribed;
    case ReferenceCircles::circumscribed: return ProfileLine::circumscribed;
    case ReferenceCircles::none: break;
    }
    return std::nullopt;
}

namespace {

/// Radii of the drawn circles in a direction [mm].
std::vector<double> circleRadii(const Profile& profile, ReferenceCircles circles, double phi) {
    const RoundnessZone* const zone = shownZone(profile, circles);
    const auto at = [&](double radius) { return radiusOf({zone->x_mm, zone->y_mm, radius}, phi); };
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    switch (circles) {
    case ReferenceCircles::leastSquares: return {at(zone->reference_mm)};
    case ReferenceCircles::minimumZone: return {at(zone->inner_mm), at(zone->outer_mm)};
    case ReferenceCircles::inscribed:
    case ReferenceCircles::circumscribed: return {zone ? at(zone->reference_mm) : none};
    case ReferenceCircles::none: break;
    }
    return {};
}

} // namespace

QStringList ProfilesTable::circleNames(ReferenceCircles circles) {
    switch (circles) {
    case ReferenceCircles::leastSquares: return {tr("%1: least-squares circle from target, µm")};
    case ReferenceCircles::minimumZone:
        return {tr("%1: inner circle of the minimum zone from target, µm"),
                tr("%1: outer circle of the minimum zone from target, µm")};
    case ReferenceCircles::inscribed: return {tr("%1: maximum inscribed circle from target, µm")};
    case ReferenceCircles::circumscribed:
        return {tr("%1: minimum circumscribed circle from target, µm")};
    case ReferenceCircles::none: break;
    }
    return {};
}

CsvTable ProfilesTable::across(const ProfileSeries& series, const std::vector<Profile>& drawn,
                               const QStringList& names, ReferenceCircles circles,
                               const ProfileLines& hidden) {
    const auto on = [&](ProfileLine line) { return !hidden.contains(line); };
    const auto line = lineOf(circles);
    const bool hasCircles = line && on(*line);
    const auto fromTarget_um = [&](double radius_mm) {
        return (radius_mm - series.target_mm) * units::umPerMm;
    };
    const auto radii = static_cast<std::size_t>(series.radii());
    const auto hasOwnAngles = [radii](const Profile& p) { return p.radii_mm.size() != radii; };
    CsvTable table;
    table.header = {tr("radius no."), tr("angle, °")};
    if (on(ProfileLine::blank)) {
        table.header << tr("blank: radius from target, µm");
    }
    std::size_t rows = radii;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const QString& name = names.at(static_cast<qsizetype>(i));
        rows = std::max(rows, drawn[i].radii_mm.size());
        if (hasOwnAngles(drawn[i])) {
            table.header << tr("%1: angle, °").arg(name);
        }
        if (on(ProfileLine::profile)) {
            table.header << tr("%1: radius from target, µm").arg(name);
        }
        for (const QString& circle : hasCircles ? circleNames(circles) : QStringList()) {
            table.header << circle.arg(name);
        }
    }
    constexpr double turn_deg = 360;
    for (std::size_t k = 0; k < rows; ++k) {
        const auto angle = [k](std::size_t count) {
            return static_cast<double>(k) * turn_deg / static_cast<double>(count);
        };
        const bool has = k < radii;
        std::vector<CsvCell> row{double(k), has ? CsvCell(angle(radii)) : CsvCell()};
        if (on(ProfileLine::blank)) {
            row.push_back(has ? CsvCell(fromTarget_um(series.blank_mm[k])) : CsvCell());
        }
        for (const Profile& p : drawn) {
            const std::size_t count = p.radii_mm.size();
            const bool own = k < count;
            if (hasOwnAngles(p)) {
                row.push_back(own ? CsvCell(angle(count)) : CsvCell());
            }
            if (on(ProfileLine::profile)) {
                row.push_back(own ? CsvCell(fromTarget_um(p.radii_mm[k])) : CsvCell());
            }
            const double phi = angleOf(static_cast<int>(k), static_cast<int>(count));
            for (const double radius :
                 hasCircles ? circleRadii(p, circles, phi) : std::vector<double>()) {
                row.push_back(own && !std::isnan(radius) ? CsvCell(fromTarget_um(radius))
                                                         : CsvCell());
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

CsvTable ProfilesTable::along(const ProfileSeries& series, LengthQuantity quantity,
                              const ProfileLines& hidden) {
    const auto on = [&](ProfileLine line) { return !hidden.contains(line); };
    const QString value = quantity == LengthQuantity::radius_mm ? tr("radius, mm")
                          : quantity == LengthQuantity::diameter_um
                              ? tr("diameter from nominal, µm")
                              : tr("radius from target, µm");
    struct Column {
        ProfileLine line;
        LengthLine curve;
        QString name;
    };
    const Column columns[] = {
        {ProfileLine::profile, LengthLine::mean, tr("mean %1")},
        {ProfileLine::spread, LengthLine::min, tr("minimum %1")},
        {ProfileLine::spread, LengthLine::max, tr("maximum %1")},
        {ProfileLine::blank, LengthLine::blankMin, tr("blank, minimum %1")},
        {ProfileLine::blank, LengthLine::blankMax, tr("blank, maximum %1")},
        {ProfileLine::target, LengthLine::target, tr("target %1")},
        {ProfileLine::field, LengthLine::lowerLimit, tr("lower limit %1")},
        {ProfileLine::field, LengthLine::upperLimit, tr("upper limit %1")},
    };
    CsvTable table;
    table.header = {series.operation->travels ? tr("zone") : tr("section"), tr("from, mm"),
                    tr("middle, mm"), tr("to, mm")};
    for (const Column& column : columns) {
        if (on(column.line)) {
            table.header << column.name.arg(value);
        }
    }
    for (const Profile& p : alongThePart(series)) {
        std::vector<CsvCell> row{Names::zone(p.zone, p.section), p.from_mm, p.position_mm, p.to_mm};
        for (const Column& column : columns) {
            if (on(column.line)) {
                row.emplace_back(lengthValue(series, p, column.curve, quantity));
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

namespace {

constexpr int visibleUndulations = 18;
constexpr double barShare = 0.4;      ///< width relative to the step between two bars
constexpr double faintest_um = 1e-4;  ///< a tenth of a nanometre: smaller is out of sight
constexpr double spectrumRoom = 1.15; ///< headroom above the highest bar
constexpr double logarithmicRoom = 2;

/// Amplitudes by the number of undulations [µm]; number 0 is the mean radius.
std::vector<double> spectrumOf(const std::vector<double>& radii_mm, const Directions& directions) {
    std::vector<double> amplitudes;
    for (const Harmonic& harmonic : harmonics(radii_mm, directions)) {
        amplitudes.push_back(harmonic.amplitude_mm * units::umPerMm);
    }
    return amplitudes;
}

ChartSeries barsOf(const std::vector<double>& spectrum, ProfileLine line, double beside) {
    ChartSeries bars{.key = static_cast<int>(line),
                     .name = ProfileLook::name(line),
                     .kind = ChartSeries::Kind::bars,
                     .colour =
                         line == ProfileLine::blank ? style::Drawn::blank : style::Drawn::profile,
                     .barWidth = barShare};
    for (std::size_t n = 1; n < spectrum.size(); ++n) {
        bars.points.push_back({static_cast<double>(n) + beside, spectrum[n]});
    }
    return bars;
}

} // namespace

ChartGrid SpectrumCharts::of(const ProfileSeries& series, const std::vector<int>& shown,
                             bool isLogarithmic, const std::function<bool(ProfileLine)>& isShown) {
    ChartGrid grid;
    if (series.profiles.empty() || shown.empty()) {
        return grid;
    }
    grid.columns = shown.size();
    grid.caption = tr("Undulations per revolution");
    grid.sharesValues = true;
    const Directions directions(series.blank_mm.size());
    const std::vector<double> blank = spectrumOf(series.blank_mm, directions);
    QStringList names;
    std::vector<std::vector<double>> spectra;
    for (const int index : shown) {
        const Profile& profile = series.profiles[static_cast<std::size_t>(index)];
        spectra.push_back(spectrumOf(profile.radii_mm, directions));
        LineChart chart;
        const QString name = Names::zone(profile.zone, profile.section);
        chart.headings << name;
        chart.series = {barsOf(blank, ProfileLine::blank, -barShare / 2),
                        barsOf(spectra.back(), ProfileLine::profile, barShare / 2)};
        chart.placeText = [name, blank, left = spectra.back(),
                           knowsEccentricity = series.knowsEccentricity,
                           knowsRoundness = series.knowsRoundness](double place) {
            const auto n = std::lround(place);
            if (n < 1 || n >= std::ssize(left)) {
                return QString();
            }
            const auto um = [n](const std::vector<double>& spectrum, bool isKnown) {
                const double value_um = spectrum[static_cast<std::size_t>(n)];
                return isKnown ? Names::significant(value_um)
                               : Names::formAmount(value_um, isKnown, 3);
            };
            return (n == 1 ? tr("%1, %2 undulation per revolution (eccentricity): amplitude %3 µm, "
                                "of the blank %4 µm")
                           : tr("%1, %2 undulations per revolution: amplitude %3 µm, of the blank "
                                "%4 µm"))
                .arg(name, QString::number(n),
                     um(left, n == 1 ? knowsEccentricity : knowsRoundness), um(blank, true));
        };
        names << name;
        grid.cells.push_back(std::move(chart));
    }
    double highest = 0; // one scale for all
    for (const LineChart& chart : grid.cells) {
        for (const ChartSeries& bars : chart.series) {
            for (const XY& bar : bars.points) {
                highest = std::max(highest, bar.y);
            }
        }
    }
    const int last = std::clamp(static_cast<int>(blank.size()) - 1, 2, visibleUndulations);
    for (LineChart& chart : grid.cells) {
        chart.across = {.range = {0.4, last + 0.6}, .room = 0, .isCounted = true, .hasGrid = false};
        chart.up = {.label = tr("Amplitude, µm"), .room = 0, .isLogarithmic = isLogarithmic};
        chart.up.range =
            isLogarithmic
                ? ChartSpan{faintest_um, std::max(highest, 10 * faintest_um) * logarithmicRoom}
                : ChartSpan{0, std::max(highest, faintest_um) * spectrumRoom};
    }
    grid.cells.front().table = [names, blank, spectra, isShown] {
        ChartTable table;
        table.cells.header << tr("undulations per revolution");
        const bool withBlank = isShown(ProfileLine::blank);
        const bool withProfile = isShown(ProfileLine::profile);
        if (withBlank) {
            table.cells.header << tr("blank: amplitude, µm");
        }
        for (const QString& name : withProfile ? names : QStringList()) {
            table.cells.header << tr("%1: amplitude, µm").arg(name);
        }
        for (std::size_t n = 1; n < blank.size(); ++n) {
            const auto place = static_cast<double>(n);
            std::vector<CsvCell> row{place};
            if (withBlank) {
                row.emplace_back(blank[n]);
            }
            for (std::size_t i = 0; withProfile && i < spectra.size(); ++i) {
                row.emplace_back(spectra[i][n]);
            }
            table.cells.rows.push_back(std::move(row));
            table.places.push_back({.across = {place, place}});
        }
        return table;
    };
    return grid;
}

} // namespace sparkout
