// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/layers_view.h"

#include "core/units.h"
#include "ui/kit/tool_row.h"
#include "ui/plot/legend.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
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

LayersView::LayersView(QWidget* parent, Settings* settings)
    : PlotView(QStringLiteral("layers"), parent, settings)
    , m_plot(new LayersPlot(this))
    , m_surface(new LayersSurface(this))
    , m_side(new SidePlot(this))
    , m_radius(new QComboBox(this))
    , m_summary(new QLabel(this)) {
    for (ViewPlot* plot : std::initializer_list<ViewPlot*>{m_plot, m_surface, m_side}) {
        plot->setMinimumSize(240, 140);
        addPage(*plot);
    }
    setUpNotice(*m_summary);
    hideUntilDrawn({m_summary});
    addColumn({pageTools<ToolRow>({m_radius}), m_summary, notice(), legend(), pages(), values()},
              pages())
        ->addStretch();
    disableUntilDrawn({content(), m_radius});
    nameObjects({{m_plot, "layersPlot"},
                 {m_surface, "layersSurface"},
                 {m_side, "layersSide"},
                 {m_radius, "layersRadius"},
                 {m_summary, "layersSummary"}});
    connectTools();
    built();
    chooseContent();
}

void LayersView::connectTools() {
    connect(m_plot, &LayersPlot::strokeClicked, this,
            [this](int stroke) { cycle().toStroke(stroke); });
    connect(content(), &QComboBox::currentIndexChanged, this, &LayersView::chooseContent);
    connect(m_radius, &QComboBox::activated, this, [this](int index) {
        m_wanted = index > 0 ? std::optional(index - 1) : std::nullopt;
        setSeries();
        showState();
        replotFront();
    });
}

QString LayersView::title() const {
    return tr("Layers");
}

void LayersView::chooseContent() {
    showPage(static_cast<std::size_t>(content()->currentIndex()));
    m_radius->setVisible(&front() != m_side); // it shows the radius that faces the wheel
    showState();
    replotFront();
}

// --- the run ------------------------------------------------------------------------------------

void LayersView::takeOutcome(const OutcomePtr&) {
    fillRadii();
    m_side->setRun(good());
    setSeries();
}

void LayersView::setSeries() {
    if (!good()) {
        return;
    }
    const int index = m_radius->currentIndex();
    const LayerSeries series =
        index > 0 ? makeLayerSeries(good()->result, good()->trajectory, index - 1) : good()->layers;
    m_plot->setSeries(series);
    m_surface->setSeries(series);
    showDone();
}

void LayersView::fillRadii() {
    const QSignalBlocker blocker(m_radius);
    const int radii = good() ? good()->trajectory.radii : 0;
    m_radius->clear();
    QStringList names{tr("Mean of the radii")};
    for (int k = 0; k < radii; ++k) {
        names << tr("Radius %1, %2°").arg(k).arg(QLocale().toString(360.0 * k / radii, 'g', 4));
    }
    m_radius->addItems(names);
    m_radius->setCurrentIndex(m_wanted && *m_wanted < radii ? *m_wanted + 1 : 0);
}

// --- the moment ---------------------------------------------------------------------------------

void LayersView::followCycle() {
    showDone();
    showState();
    replotFront();
}

/// If the cycle's cursor is in another run, all layers are shown.
void LayersView::showDone() {
    const LayerSeries& series = m_plot->series();
    const CycleCursor* const at = cycleIn(good());
    const LayersDone done = at && !at->atEnd()
                                ? layersDone(series, good()->trajectory, at->progress())
                                : allLayers(series);
    m_plot->setDone(done);
    m_surface->setDone(done);
    if (good()) {
        m_side->setScene(
            grindingScene(good()->result, good()->trajectory, at ? at->progress() : Progress{}));
    }
}

// --- texts --------------------------------------------------------------------------------------

bool LayersView::drawn() const {
    return good() && !good()->layers.columns.empty();
}

void LayersView::showState() {
    PlotView::showState();
    m_summary->setText(summary());
    readOut();
    m_plot->setAccessibleDescription(m_summary->text());
    m_surface->setAccessibleDescription(m_summary->text());
    m_side->setAccessibleDescription(m_side->values());
}

QString LayersView::hint() const {
    if (&front() == m_side) {
        return m_side->values();
    }
    return &front() == m_surface
               ? tr("Drag or press the arrow keys to turn the surface; the wheel zooms.")
               : tr("Point at a layer to read the values.");
}

QString LayersView::keptText() const {
    return tr("The inputs are refused; the layers are those of the last valid inputs.");
}

QString LayersView::remark() const {
    if (!drawn()) {
        return tr("The cycle is too long to be recorded: its layers are not drawn. Fewer radii or "
                  "sections help.");
    }
    QStringList lines{Names::uncutStrips(good()->result.project)};
    if (good()->result.status != RunStatus::completed) {
        lines.prepend(Names::status(good()->result.status));
    }
    return joined(lines, QStringLiteral("\n"));
}

/// The stock removed at each place up to the cursor.
QString LayersView::summary() const {
    const LayerSeries& series = m_plot->series();
    if (series.columns.empty()) {
        return {};
    }
    const LayersDone& done = m_plot->done();
    const auto [least, most] = std::ranges::minmax_element(done.sum_mm);
    const CycleCursor* const at = cycleIn(good());
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
        return Names::within(Names::zone(of.zone, of.section));
    };
    return tr("%1: most off %2, %3 µm; least off %4, %5 µm.")
        .arg(when, zone(most), um(*most), zone(least), um(*least));
}

QStringList LayersView::subheading() const {
    return {m_radius->currentText(), summary(), Names::uncutStrips(good()->result.project)};
}

void LayersView::nameParts() {
    nameAround(tr("Legend of the layers"), tr("State of the layers"), tr("Values under the mouse"));
    m_plot->setAccessibleName(tr("Layers of the stock along the part"));
    m_surface->setAccessibleName(tr("Accumulated actual feed over length and number"));
    m_side->setAccessibleName(tr("Wheel and part from the side, heights exaggerated"));
    m_side->setToolTip(tr("Heights are exaggerated. As in the model, a zone is ground during the "
                          "whole stroke; the whole deflection is drawn at the part."));
    m_summary->setAccessibleName(tr("How much has come off"));
    fillChoice(*content(), {tr("Stacked layers"), tr("Surface"), tr("Wheel and part")});
    tell(*content(), tr("How the layers are drawn"));
    tell(*m_radius, tr("Radius whose layers are drawn"));
    fillRadii();
}

} // namespace sparkout
