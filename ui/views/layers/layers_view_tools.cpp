// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the view of layers: building and connecting.
#include "ui/views/layers/layers_view.h"

#include "ui/kit/metrics.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_pages.h"
#include "ui/views/layers/layers_plot.h"
#include "ui/views/layers/layers_surface.h"
#include "ui/views/layers/side_plot.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace sparkout {

LayersView::LayersView(QWidget* parent, Settings* settings)
    : View(parent)
    , m_plot(new LayersPlot(this))
    , m_surface(new LayersSurface(this))
    , m_side(new SidePlot(this))
    , m_legend(new LegendStrip(this))
    , m_pages(new PlotPages(
          *this, *m_legend, [this] { return heading(); }, settings))
    , m_radius(new QComboBox(this))
    , m_summary(new QLabel(this))
    , m_notice(new QLabel(this))
    , m_values(new QLabel(this)) {
    setObjectName(QStringLiteral("layers"));
    build();
    connectParts();
    built();
    chooseContent();
}

void LayersView::build() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    auto* bar = new QWidget(this);
    buildTools(bar);
    setUpNotice(*m_summary);
    setUpNotice(*m_notice);
    setUpReadout(*m_values);
    for (const PlotPages::Page& page : m_pages->all()) {
        page.plot->setMinimumSize(240, 140);
    }
    layout->addWidget(bar);
    layout->addWidget(m_summary);
    layout->addWidget(m_notice);
    layout->addWidget(m_legend);
    layout->addWidget(m_pages->stack(), 1);
    layout->addWidget(m_values);
    const std::pair<QWidget*, const char*> names[] = {
        {m_plot, "layersPlot"},
        {m_surface, "layersSurface"},
        {m_side, "layersSide"},
        {m_legend, "layersLegend"},
        {m_pages->content(), "layersContent"},
        {m_radius, "layersRadius"},
        {m_summary, "layersSummary"},
        {m_notice, "layersNotice"},
        {m_values, "layersValues"},
    };
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

void LayersView::buildTools(QWidget* bar) {
    PlotSubject surface;
    surface.navigation.state = [this] { return m_surface->sight(); };
    surface.navigation.setState = [this](const PlotHistory::State& sight) {
        m_surface->setSight(sight);
    };
    m_pages->add(*m_plot);
    m_pages->add(*m_surface, std::move(surface));
    m_pages->add(*m_side);
    m_radius->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_pages->content());
    row->addWidget(m_radius);
    row->addStretch(1);
    m_pages->addButtons(*row);
}

void LayersView::connectParts() {
    connect(m_pages->content(), &QComboBox::currentIndexChanged, this, &LayersView::chooseContent);
    connect(m_radius, &QComboBox::activated, this, [this](int index) {
        m_wanted = index > 0 ? std::optional(index - 1) : std::nullopt;
        setSeries();
        showState();
        replotShown();
    });
    connect(m_plot, &LayersPlot::pointed, this, &LayersView::readOut);
    connect(m_plot, &LayersPlot::strokeClicked, this,
            [this](int stroke) { cycle().toStroke(stroke); });
}

} // namespace sparkout
