// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profiles_table.h"

#include "core/units.h"
#include "ui/text/names.h"

namespace sparkout {

CsvTable ProfilesTable::across(const ProfileSeries& series, const std::vector<int>& shown,
                               const ProfileLines& hidden) {
    const auto on = [&](ProfileLine line) { return !hidden.contains(line); };
    const auto fromTarget_um = [&](double radius_mm) {
        return (radius_mm - series.target_mm) * units::umPerMm;
    };
    CsvTable table;
    table.header = {tr("radius no."), tr("angle, °")};
    if (on(ProfileLine::blank)) {
        table.header << tr("blank: radius from target, µm");
    }
    for (const int index : shown) {
        const Profile& p = series.profiles[static_cast<std::size_t>(index)];
        const QString name = Names::zone(p.zone, p.section);
        if (on(ProfileLine::profile)) {
            table.header << tr("%1: radius from target, µm").arg(name);
        }
        if (on(ProfileLine::leastSquares)) {
            table.header << tr("%1: least-squares circle from target, µm").arg(name);
        }
        if (on(ProfileLine::minimumZone)) {
            table.header << tr("%1: inner circle of the minimum zone from target, µm").arg(name)
                         << tr("%1: outer circle of the minimum zone from target, µm").arg(name);
        }
    }
    for (int k = 0; k < series.radii(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        const double phi = angleOf(k, series.radii());
        std::vector<CsvCell> row{double(k), k * 360.0 / series.radii()};
        if (on(ProfileLine::blank)) {
            row.emplace_back(fromTarget_um(series.blank_mm[i]));
        }
        for (const int index : shown) {
            const Profile& p = series.profiles[static_cast<std::size_t>(index)];
            const auto circle = [&](const RoundnessZone& about, double radius) {
                return fromTarget_um(radiusOf({about.x_mm, about.y_mm, radius}, phi));
            };
            if (on(ProfileLine::profile)) {
                row.emplace_back(fromTarget_um(p.radii_mm[i]));
            }
            if (on(ProfileLine::leastSquares)) {
                row.emplace_back(circle(p.leastSquares, p.leastSquares.reference_mm));
            }
            if (on(ProfileLine::minimumZone)) {
                row.emplace_back(circle(p.minimumZone, p.minimumZone.inner_mm));
                row.emplace_back(circle(p.minimumZone, p.minimumZone.outer_mm));
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
        {ProfileLine::spread, LengthLine::min, tr("smallest %1")},
        {ProfileLine::spread, LengthLine::max, tr("largest %1")},
        {ProfileLine::blank, LengthLine::blankMin, tr("blank, smallest %1")},
        {ProfileLine::blank, LengthLine::blankMax, tr("blank, largest %1")},
        {ProfileLine::target, LengthLine::target, tr("target %1")},
        {ProfileLine::field, LengthLine::lowerLimit, tr("lower limit %1")},
        {ProfileLine::field, LengthLine::upperLimit, tr("upper limit %1")},
    };
    CsvTable table;
    table.header = {series.operation->hasZones ? tr("zone") : tr("section"), tr("from, mm"),
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
