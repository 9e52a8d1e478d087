// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profiles_table.h"

#include "core/units.h"
#include "ui/text/names.h"
#include "ui/views/profiles/shown_zone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace sparkout {

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

} // namespace sparkout
