// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the view of layers: building and connecting.
#include "ui/views/layers_view.h"

#include "ui/metrics.h"
#include "ui/views/layers_plot.h"
#include "ui/views/layers_surface.h"
#include "ui/views/legend_strip.h"
#include "ui/views/plot_tools.h"
#include "ui/views/side_plot.h"

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
    , m_stack(new QStackedWidget(this))
    , m_legend(new LegendStrip(this))
    , m_content(new QComboBox(this))
    , m_radius(new QComboBox(this))
    , m_summary(new QLabel(this))
    , m_notice(new QLabel(this))
    , m_values(new QLabel(this)) {
    setObjectName(QStringLiteral("layers"));
    build(settings);
    connectParts();
    retranslate();
    chooseContent();
}

void LayersView::build(Settings* settings) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    auto* bar = new QWidget(this);
    buildTools(bar, settings);
    setUpNotice(*m_summary);
    setUpNotice(*m_notice);
    setUpReadout(*m_values);
    for (const Page& page : m_pages) {
        page.plot->setMinimumSize(240, 140);
        m_stack->addWidget(page.plot);
    }
    layout->addWidget(bar);
    layout->addWidget(m_summary);
    layout->addWidget(m_notice);
    layout->addWidget(m_legend);
    layout->addWidget(m_stack, 1);
    layout->addWidget(m_values);
    const std::pair<QWidget*, const char*> names[] = {
        {m_plot, "layersPlot"},       {m_surface, "layersSurface"}, {m_side, "layersSide"},
        {m_legend, "layersLegend"},   {m_content, "layersContent"}, {m_radius, "layersRadius"},
        {m_summary, "layersSummary"}, {m_notice, "layersNotice"},   {m_values, "layersValues"},
    };
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

template <typename Plot>
void LayersView::addPage(Plot& plot, PlotSubject subject, Settings* settings) {
    subject.heading = [this] { return heading(); };
    subject.legend = [&plot] { return plot.legendEntries(); };
    subject.table = [&plot] { return plot.table(); };
    subject.restyle = [&plot] { plot.restyle(); };
    subject.navigation.fit = [&plot] { plot.fit(); };
    Page page;
    page.plot = &plot;
    page.legend = subject.legend;
    page.toggle = [&plot](int key) { plot.toggleCurve(key); };
    page.showOnly = [&plot](int key) { plot.showOnly(key); };
    page.tools = new PlotTools(plot, std::move(subject));
    page.tools->setSettings(settings);
    page.buttons = new QWidget(this);
    auto* row = new QHBoxLayout(page.buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(PlotTools::button(page.tools->fit, page.buttons));
    row->addWidget(page.tools->exportButton(page.buttons));
    connect(&plot, &Plot::contentChanged, this, &LayersView::showLegend);
    m_content->addItem(QString());
    m_pages.push_back(std::move(page));
}

void LayersView::buildTools(QWidget* bar, Settings* settings) {
    PlotSubject surface;
    surface.navigation.state = [this] { return m_surface->sight(); };
    surface.navigation.setState = [this](const PlotHistory::State& sight) {
        m_surface->setSight(sight);
    };
    addPage(*m_plot, {}, settings);
    addPage(*m_surface, std::move(surface), settings);
    addPage(*m_side, {}, settings);
    m_radius->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_content);
    row->addWidget(m_radius);
    row->addStretch(1);
    for (const Page& page : m_pages) {
        row->addWidget(page.buttons);
    }
}

void LayersView::connectParts() {
    connect(m_content, &QComboBox::currentIndexChanged, this, &LayersView::chooseContent);
    connect(m_radius, &QComboBox::activated, this, [this](int index) {
        m_wanted = index > 0 ? std::optional(index - 1) : std::nullopt;
        setSeries();
        showState();
        replotShown();
    });
    connect(m_plot, &LayersPlot::pointed, this,
            [this](const QString& text) { m_values->setText(text.isEmpty() ? hint() : text); });
    connect(m_plot, &LayersPlot::strokeClicked, this,
            [this](int stroke) { cycle().toStroke(stroke); });
    connect(m_legend, &LegendStrip::toggled, this, [this](int key) { page().toggle(key); });
    connect(m_legend, &LegendStrip::onlyAsked, this, [this](int key) { page().showOnly(key); });
}

} // namespace sparkout
