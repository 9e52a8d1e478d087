// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/layers_view.h"

#include "core/units.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_pages.h"
#include "ui/text/names.h"
#include "ui/views/layers/layers_plot.h"
#include "ui/views/layers/layers_surface.h"
#include "ui/views/layers/side_plot.h"

#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QStackedWidget>

#include <algorithm>

namespace sparkout {

QString LayersView::title() const {
    return tr("Layers");
}

PlotTools* LayersView::tools() const {
    return m_pages->page().tools;
}

void LayersView::chooseContent() {
    m_pages->show();
    m_radius->setVisible(m_pages->page().plot
                         != m_side); // its radius is the one that faces the wheel
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
    m_pages->showLegend();
    for (const PlotPages::Page& page : m_pages->all()) {
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
        m_side->setScene(
            grindingScene(m_good->result, m_good->trajectory, at ? at->progress() : Progress{}));
    }
}

void LayersView::replotShown() {
    m_pages->page().plot->replot(QCustomPlot::rpQueuedReplot);
}

// --- texts --------------------------------------------------------------------------------------

void LayersView::showState() {
    const bool drawn = m_good && !m_good->layers.columns.empty();
    m_notice->setText(notice());
    m_notice->setVisible(!m_notice->text().isEmpty());
    m_summary->setText(summary());
    for (QWidget* part :
         std::initializer_list<QWidget*>{m_pages->stack(), m_legend, m_values, m_summary}) {
        part->setVisible(drawn);
    }
    m_pages->content()->setEnabled(drawn);
    m_radius->setEnabled(drawn);
    for (const PlotPages::Page& page : m_pages->all()) {
        page.tools->setEnabled(drawn);
    }
    readOut();
    m_plot->setAccessibleDescription(m_summary->text());
    m_surface->setAccessibleDescription(m_summary->text());
    m_side->setAccessibleDescription(m_side->values());
}

QString LayersView::hint() const {
    if (m_pages->page().plot == m_side) {
        return m_side->values();
    }
    return m_pages->page().plot == m_surface
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
    QStringList lines{Names::uncutStrips(m_good->result.project)};
    if (m_good->result.status != RunStatus::completed) {
        lines.prepend(Names::status(m_good->result.status));
    }
    lines.removeAll(QString());
    return lines.join(u'\n');
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
                << m_radius->currentText() << summary()
                << Names::uncutStrips(m_good->result.project);
    }
    heading.removeAll(QString());
    return heading;
}

void LayersView::retranslate() {
    setAccessibleName(tr("Layers"));
    m_plot->setAccessibleName(tr("Layers of the stock along the part"));
    m_surface->setAccessibleName(tr("Accumulated actual feed over length and number"));
    m_side->setAccessibleName(tr("Wheel and part from the side, heights exaggerated"));
    m_side->setToolTip(tr("Heights are exaggerated. As the model has it, a zone is ground during "
                          "the whole stroke; and all that yields is drawn at the part."));
    m_legend->setAccessibleName(tr("Legend of the layers"));
    m_notice->setAccessibleName(tr("State of the layers"));
    m_summary->setAccessibleName(tr("How much has come off"));
    m_values->setAccessibleName(tr("Values under the mouse"));
    m_pages->content()->setItemText(0, tr("Stacked layers"));
    m_pages->content()->setItemText(1, tr("Surface"));
    m_pages->content()->setItemText(2, tr("Wheel and part"));
    m_pages->content()->setAccessibleName(tr("How the layers are drawn"));
    m_pages->content()->setToolTip(m_pages->content()->accessibleName());
    m_radius->setAccessibleName(tr("Radius whose layers are drawn"));
    m_radius->setToolTip(m_radius->accessibleName());
    m_legend->retranslate();
    m_plot->retranslate();
    m_side->retranslate();
    fillRadii();
    m_pages->showLegend();
    showState();
    for (const PlotPages::Page& page : m_pages->all()) {
        page.tools->retranslate();
        page.plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

void LayersView::recolour() {
    m_pages->showLegend();
}

} // namespace sparkout
