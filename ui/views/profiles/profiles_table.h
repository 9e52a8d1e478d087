// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/length_lines.h"
#include "ui/charts/profiles_look.h"
#include "ui/tables/csv_table.h"

#include <QCoreApplication>
#include <QStringList>

#include <vector>

namespace sparkout {

/// The drawn profiles as tables for a spreadsheet.
class ProfilesTable {
    Q_DECLARE_TR_FUNCTIONS(ProfilesTable)
public:
    /// A row for each angle, a column for each drawn profile with its name: deviations from the
    /// target radius, unmagnified. A measured profile with other angles has a column for them.
    static CsvTable across(const ProfileSeries& series, const std::vector<Profile>& drawn,
                           const QStringList& names, ReferenceCircles circles,
                           const ProfileLines& hidden);
    /// A row for each zone or section, from the headstock end on or in the order of the zones.
    static CsvTable along(const ProfileSeries& series, LengthQuantity quantity,
                          const ProfileLines& hidden);

private:
    static QStringList circleNames(ReferenceCircles circles);
};

} // namespace sparkout
