// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/residual_plot.h"

#include "ui/kit/font_size.h"
#include "ui/plot/plot_style.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr double residualSize = 3;
constexpr double residualRoom = 0.06; ///< beside the outermost points, of the range

} // namespace

ResidualPlot::ResidualPlot(QWidget* parent)
    : ViewPlot(parent), m_rect(addCell()), m_points(addLine(*m_rect)), m_zero(nullptr) {
    m_points->setLineStyle(QCPGraph::lsNone);
    m_points->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, residualSize));
    m_zero = addRule(*m_rect, 0, false);
    built();
}

QSize ResidualPlot::minimumSizeHint() const {
    return {atFontSize(260), atFontSize(150)};
}

void ResidualPlot::setResiduals(const std::vector<double>& at, const std::vector<double>& values,
                                const QString& across, const QString& up) {
    QVector<QCPGraphData> points;
    for (std::size_t i = 0; i < std::min(at.size(), values.size()); ++i) {
        points.push_back({at[i], values[i]});
    }
    m_points->data()->set(points, false);
    m_rect->axis(QCPAxis::atBottom)->setLabel(across);
    m_rect->axis(QCPAxis::atLeft)->setLabel(up);
    fit();
    replot(rpQueuedReplot);
}

void ResidualPlot::fit() {
    bool anyAcross = false, anyUp = false;
    const QCPRange across = m_points->getKeyRange(anyAcross);
    const QCPRange up = m_points->getValueRange(anyUp);
    if (anyAcross && anyUp) {
        const double pad = std::max(across.size() * residualRoom, 1e-9);
        style::setSafeRange(*m_rect->axis(QCPAxis::atBottom), across.lower - pad,
                            across.upper + pad);
        const double most = std::max({std::abs(up.lower), std::abs(up.upper), 1e-12});
        style::setSafeRange(*m_rect->axis(QCPAxis::atLeft), -most * (1 + residualRoom),
                            most * (1 + residualRoom));
    }
}

void ResidualPlot::restyle() {
    ViewPlot::restyle();
    m_points->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, toned(style::Drawn::actualFeed), residualSize));
    m_zero->setPen(QPen(ink(), 1, Qt::DashLine));
}

} // namespace sparkout
