// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/read_curves.h"

#include "ui/text/names.h"
#include "ui/text/number_text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <qcustomplot.h>

namespace sparkout {

namespace {

constexpr int sureDigits = 12;

/// Interpolates between two points along a straight line on the axis.
double interpolated(const XY& a, const XY& b, double x, bool logarithmic) {
    if (b.x <= a.x) {
        return b.y;
    }
    const double share = (x - a.x) / (b.x - a.x);
    return logarithmic && a.y > 0 && b.y > 0 ? a.y * std::pow(b.y / a.y, share)
                                             : a.y + share * (b.y - a.y);
}

std::optional<double> finite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<double> valueAt(const std::vector<XY>& line, double x, bool isLogarithmic) {
    const auto above = std::ranges::upper_bound(line, x, {}, &XY::x);
    if (above == line.begin()) {
        return std::nullopt;
    }
    const XY& below = *(above - 1);
    if (below.x == x) {
        return finite(below.y);
    }
    return above == line.end() ? std::nullopt
                               : finite(interpolated(below, *above, x, isLogarithmic));
}

std::optional<double> valueAt(const QCPGraph& graph, double x) {
    const auto data = graph.data();
    const auto above =
        std::upper_bound(data->constBegin(), data->constEnd(), x,
                         [](double place, const QCPGraphData& p) { return place < p.key; });
    if (above == data->constBegin()) {
        return std::nullopt;
    }
    const QCPGraphData& below = *(above - 1);
    if (below.key == x) {
        return finite(below.value);
    }
    if (above == data->constEnd()) {
        return std::nullopt;
    }
    return finite(interpolated({below.key, below.value}, {above->key, above->value}, x,
                               graph.valueAxis()->scaleType() == QCPAxis::stLogarithmic));
}

std::optional<double> lastValueAt(const std::vector<XY>& path, double x, bool isLogarithmic) {
    std::optional<double> value;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const XY a = path[i == 0 ? 0 : i - 1], b = path[i];
        if (x >= std::min(a.x, b.x) && x <= std::max(a.x, b.x)) {
            value = finite(a.x > b.x ? interpolated(b, a, x, isLogarithmic)
                                     : interpolated(a, b, x, isLogarithmic));
        }
    }
    return value;
}

QString stated(double value, Digits digits) {
    switch (digits) {
    case Digits::hundredths: return Names::micrometres(value);
    case Digits::signedHundredths: return Names::signedMicrometres(value);
    case Digits::thousandths: return Names::fixed(value, 3);
    case Digits::tenThousandths: return Names::millimetres(value);
    case Digits::significant: break;
    }
    return Names::significant(value);
}

QString statedDifference(double value, Digits digits, double beside) {
    if (digits == Digits::hundredths || digits == Digits::signedHundredths) {
        return Names::signedMicrometres(value);
    }
    const QString other = stated(beside, digits);
    const auto point = other.lastIndexOf(QLocale().decimalPoint());
    const auto decimals = point < 0 ? 0 : other.size() - point - QLocale().decimalPoint().size();
    const bool rises = value >= 0.5 * std::pow(10.0, -static_cast<double>(decimals));
    return (rises ? QStringLiteral("+") : QString())
           + Names::fixed(value, static_cast<int>(decimals));
}

constexpr double roundOff = 1e-12; ///< smaller than any step of places in mm, s or µm

double plainPlace(double x) {
    return std::abs(x) < roundOff ? 0 : QString::number(x, 'g', sureDigits).toDouble();
}

QString statedPlace(double x) {
    return printedNumber(plainPlace(x));
}

} // namespace sparkout
