// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_scale.h"

namespace sparkout {

namespace {

constexpr double fewDecades = 1.2, manyDecades = 4; ///< with ticks at 1, 2, 5, 10
constexpr double mostDecades = 300;

} // namespace

QVector<double> SweepTicker::createTickVector(double step, const QCPRange& range) {
    if (!m_scale.ratios || range.size() > mostDecades) {
        return QCPAxisTicker::createTickVector(step, range);
    }
    QVector<double> ticks;
    if (range.size() < fewDecades) {
        const QCPRange values(m_scale.valueAt(range.lower), m_scale.valueAt(range.upper));
        for (const double value : QCPAxisTicker::createTickVector(getTickStep(values), values)) {
            if (value > 0) {
                ticks << m_scale.at(value);
            }
        }
        return ticks;
    }
    for (double decade = std::floor(range.lower); decade <= range.upper; ++decade) {
        ticks << decade;
        if (range.size() < manyDecades) {
            ticks << decade + std::log10(2) << decade + std::log10(5);
        }
    }
    return ticks;
}

QString SweepTicker::getTickLabel(double tick, const QLocale& locale, QChar format, int precision) {
    return NumberTicker::getTickLabel(m_scale.shown.shown(m_scale.valueAt(tick)), locale, format,
                                      precision);
}

} // namespace sparkout
