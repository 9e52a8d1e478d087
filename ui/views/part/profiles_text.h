// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"
#include "ui/chart/line_chart.h"
#include "ui/chart/profiles_look.h"
#include "ui/table/csv_table.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

namespace sparkout {

/// The texts and numbers of the view "Zone profiles".
class ProfilesText {
    Q_DECLARE_TR_FUNCTIONS(ProfilesText)
public:
    static QString magnification(double value); ///< "×2000"
    /// Deviations of the diameter, runout, and whether the drawing is met, one per line.
    static QString numbers(const ProfileSeries& series, const Profile& profile, bool brief);
    /// Roundness deviation and eccentricity about reference circles, one line; each a lower bound
    /// where the machine's own is not known.
    static QString roundness(const RoundnessZone& zone, bool brief, bool knowsRoundness,
                             bool knowsEccentricity);
    /// The sample at angle φ_k, and the diameter across it.
    static QString sample(const ProfileSeries& series, const Profile& profile, const QString& name,
                          int k, bool withBlank);
    /// For a measured profile: the number of radii, in one line.
    static QString measured(const Profile& profile);
    static QString filter(std::optional<int> cutoff_upr); ///< "Gaussian filter 50 UPR"
    /// The zone or section at a place along the axis.
    static QString stretch(const ProfileSeries& series, const Profile& profile, bool withBlank);
    static QString moment(const ProfileSeries& series); ///< "After double stroke 27 of 54"
    /// A description of the plots: the moment and the numbers of each profile.
    static QString summary(const ProfileSeries& series, const std::vector<int>& shown);

private:
    static QString blankText(const ProfileSeries& series, const Profile& profile, int k);
};

/// A filtered profile with the chosen circles.
[[nodiscard]] Profile shownProfile(Profile profile, ReferenceCircles circles,
                                   std::optional<int> cutoff_upr);

/// The chosen circles; null if none are chosen or none are fitted.
[[nodiscard]] const RoundnessZone* shownZone(const Profile& profile, ReferenceCircles circles);

/// The circles' line in the legend.
[[nodiscard]] std::optional<ProfileLine> lineOf(ReferenceCircles circles);

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

/// Amplitudes of profiles over the undulations per revolution: 1 is the eccentricity, 2 an oval. A
/// cell for each zone or section side by side, blank and profile as bars, with their ProfileLine as
/// key.
struct SpectrumCharts {
    Q_DECLARE_TR_FUNCTIONS(SpectrumCharts)
public:
    static constexpr ProfileLine lines[] = {ProfileLine::blank, ProfileLine::profile};

    /// @param isShown whether a line is in the table now
    [[nodiscard]] static ChartGrid of(const ProfileSeries& series, const std::vector<int>& shown,
                                      bool isLogarithmic,
                                      const std::function<bool(ProfileLine)>& isShown);
};

} // namespace sparkout
