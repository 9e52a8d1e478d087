// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers_view.h"

#include "core/units.h"
#include "ui/metrics.h"
#include "ui/views/layers_plot.h"
#include "ui/views/layers_surface.h"
#include "ui/views/legend_strip.h"
#include "ui/views/names.h"
#include "ui/views/plot_tools.h"
#include "ui/views/side_plot.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

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

QString LayersView::title() const {
    return tr("Layers");
}

const LayersView::Page& LayersView::page() const {
    return m_pages[static_cast<std::size_t>(m_content->currentIndex())];
}

PlotTools* LayersView::tools() const {
    return page().tools;
}

void LayersView::chooseContent() {
    m_stack->setCurrentWidget(page().plot);
    for (const Page& other : m_pages) {
        other.buttons->setVisible(&other == &page());
    }
    m_radius->setVisible(page().plot != m_side); // its radius is the one that faces the wheel
    showLegend();
    showState();
    replotShown();
}

// --- the run ------------------------------------------------------------------------------------

void LayersView::showOutcome() {
    const bool ran = latest() && latest()->ran() && !latest()->result.sections.empty();
    if (ran) {
        m_good = latest();
        fillRadii();
        m_side->setRun(m_good);
        setSeries();
    }
    m_plot->setDimmed(m_good && !ran);
    m_surface->setDimmed(m_good && !ran);
    m_side->setDimmed(m_good && !ran);
    showState();
    showLegend();
    for (const Page& page : m_pages) {
        page.plot->replot();
        page.tools->navigation().amendView();
    }
    emit updated();
}

void LayersView::setSeries() {
    if (!m_good) {
        return;
    }
    const int index = m_radius->currentIndex();
    const LayerSeries series =
        index > 0 ? makeLayerSeries(m_good->result, m_good->trajectory, index - 1) : m_good->layers;
    m_plot->setSeries(series);
    m_surface->setSeries(series);
    showDone();
}

void LayersView::fillRadii() {
    const QSignalBlocker blocker(m_radius);
    const int radii = m_good ? m_good->trajectory.radii : 0;
    m_radius->clear();
    m_radius->addItem(tr("Mean of the radii"));
    for (int k = 0; k < radii; ++k) {
        m_radius->addItem(
            tr("Radius %1, %2°").arg(k).arg(QLocale().toString(360.0 * k / radii, 'g', 4)));
    }
    m_radius->setCurrentIndex(m_wanted && *m_wanted < radii ? *m_wanted + 1 : 0);
}

// --- the moment ---------------------------------------------------------------------------------

void LayersView::followCycle() {
    showDone();
    showState();
    replotShown();
}

/// While the cycle stands in another run, all layers are shown.
void LayersView::showDone() {
    const LayerSeries& series = m_plot->series();
    const CycleCursor* const at = cycleIn(m_good);
    const LayersDone done = at && !at->atEnd()
                                ? layersDone(series, m_good->trajectory, at->progress())
                                : allLayers(series);
    m_plot->setDone(done);
    m_surface->setDone(done);
    if (m_good) {
        m_side->setScene(grindingScene(m_good->result, m_good->trajectory,
                                       at ? at->progress() : Progress{}));
    }
}

void LayersView::replotShown() {
    page().plot->replot(QCustomPlot::rpQueuedReplot);
}

// --- texts --------------------------------------------------------------------------------------

void LayersView::showLegend() {
    m_legend->setEntries(page().legend());
}

void LayersView::showState() {
    const bool drawn = m_good && !m_good->layers.columns.empty();
    m_notice->setText(notice());
    m_notice->setVisible(!m_notice->text().isEmpty());
    m_summary->setText(summary());
    for (QWidget* part : std::initializer_list<QWidget*>{m_stack, m_legend, m_values, m_summary}) {
        part->setVisible(drawn);
    }
    m_content->setEnabled(drawn);
    m_radius->setEnabled(drawn);
    for (const Page& page : m_pages) {
        page.tools->setEnabled(drawn);
    }
    m_values->setText(hint());
}

QString LayersView::hint() const {
    if (page().plot == m_side) {
        return m_side->values();
    }
    return page().plot == m_surface
               ? tr("Drag or press the arrow keys to turn the surface; the wheel zooms.")
               : tr("Point at a layer to read the values.");
}

QString LayersView::notice() const {
    if (latest() && !latest()->ran()) {
        return (m_good
                    ? tr("The inputs are refused; the layers are those of the last accepted ones.")
                    : tr("The inputs are refused:"))
               + QLatin1Char('\n') + Names::refusal(latest()->issues, 2);
    }
    if (!m_good) {
        return tr("No result yet.");
    }
    if (m_good->layers.columns.empty()) {
        return tr("The cycle is too long to be recorded: its layers are not drawn. Fewer radii or "
                  "sections help.");
    }
    return m_good->result.status == RunStatus::completed ? QString()
                                                         : Names::status(m_good->result.status);
}

/// How much has come off where, up to the cursor.
QString LayersView::summary() const {
    const LayerSeries& series = m_plot->series();
    if (series.columns.empty()) {
        return {};
    }
    const LayersDone& done = m_plot->done();
    const auto [least, most] = std::ranges::minmax_element(done.sum_mm);
    const CycleCursor* const at = cycleIn(m_good);
    const QString when = Names::moment(series.operation, at ? at->stroke() : series.strokeCount(),
                                       series.strokeCount(), !at || at->strokeDone());
    if (done.count == 0) {
        return when;
    }
    const auto um = [](double sum_mm) { return Names::micrometres(sum_mm * units::umPerMm); };
    if (*least == *most) {
        return tr("%1: %2 µm off everywhere.").arg(when, um(*most));
    }
    const auto zone = [&](auto sum) {
        const LayerColumn& of = series.columns[static_cast<std::size_t>(sum - done.sum_mm.begin())];
        return Names::zone(of.zone, of.section);
    };
    return tr("%1: most off %2, %3 µm; least off %4, %5 µm.")
        .arg(when, zone(most), um(*most), zone(least), um(*least));
}

QStringList LayersView::heading() const {
    QStringList heading{title()};
    if (m_good) {
        heading << QString::fromStdString(m_good->result.project.title).simplified()
                << m_radius->currentText() << summary();
    }
    heading.removeAll(QString());
    return heading;
}

void LayersView::retranslate() {
    setAccessibleName(tr("Layers"));
    m_plot->setAccessibleName(tr("Layers of the stock along the part"));
    m_surface->setAccessibleName(tr("Accumulated actual feed over length and number"));
    m_side->setAccessibleName(tr("Wheel and part from the side, heights exaggerated"));
    m_legend->setAccessibleName(tr("Legend of the layers"));
    m_notice->setAccessibleName(tr("State of the layers"));
    m_summary->setAccessibleName(tr("How much has come off"));
    m_values->setAccessibleName(tr("Values under the mouse"));
    m_content->setItemText(0, tr("Stacked layers"));
    m_content->setItemText(1, tr("Surface"));
    m_content->setItemText(2, tr("Wheel and part"));
    m_content->setAccessibleName(tr("How the layers are drawn"));
    m_content->setToolTip(m_content->accessibleName());
    m_radius->setAccessibleName(tr("Radius whose layers are drawn"));
    m_radius->setToolTip(m_radius->accessibleName());
    m_legend->retranslate();
    m_plot->retranslate();
    m_side->retranslate();
    fillRadii();
    showLegend();
    showState();
    for (const Page& page : m_pages) {
        page.tools->retranslate();
        page.plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

void LayersView::changeEvent(QEvent* event) {
    View::changeEvent(event);
    if (m_pages.empty()) {
        return;
    }
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        showLegend();
    }
}

} // namespace sparkout
