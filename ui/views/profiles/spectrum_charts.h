// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"
#include "ui/charts/profiles_look.h"
#include "ui/plot/line_chart.h"

#include <QCoreApplication>

#include <functional>
#include <vector>

namespace sparkout {

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
