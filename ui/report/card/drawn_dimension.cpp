// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/card/drawn_dimension.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/report/parts/input_fact.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace sparkout::report {

namespace {

constexpr int leastDecimals = 3, mostDecimals = 6;

/// Both deviations have the same decimals, as many as either needs.
int decimalsOf(double upper_um, double lower_um) {
    int decimals = leastDecimals;
    const auto isWhole = [](double value) { return std::abs(value - std::round(value)) < 1e-9; };
    for (double scale = 1;
         decimals < mostDecimals && !(isWhole(upper_um * scale) && isWhole(lower_um * scale));
         scale *= 10) {
        ++decimals;
    }
    return decimals;
}

} // namespace

DrawnDimension DrawnDimension::of(const Part& part) {
    DrawnDimension made;
    const QString whole = drawnSize(part);
    made.nominal = whole.left(whole.indexOf(u'(')).trimmed();
    const double upper = part.upper_deviation_um, lower = part.lower_deviation_um;
    const int decimals = decimalsOf(upper, lower);
    const auto text = [decimals](double value_um) {
        if (value_um == 0) {
            return QString();
        }
        const QString digits =
            QLocale().toString(std::abs(value_um) / units::umPerMm, 'f', decimals);
        return (value_um < 0 ? QStringLiteral("−") : QStringLiteral("+")) + digits;
    };
    made.isSymmetric = upper == -lower && upper != 0;
    made.upper = made.isSymmetric ? text(upper).replace(u'+', u'±') : text(upper);
    made.lower = made.isSymmetric ? QString() : text(lower);
    return made;
}

} // namespace sparkout::report
