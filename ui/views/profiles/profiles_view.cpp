// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profiles_view.h"

#include "core/simulation/feed_series.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_tools.h"
#include "ui/text/names.h"
#include "ui/views/profiles/longitudinal_plot.h"
#include "ui/views/profiles/profiles_plot.h"
#include "ui/views/profiles/profiles_text.h"
#include "ui/views/profiles/spectrum_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>

namespace sparkout {

void ProfilesView::showOutcome() {
    QElapsedTimer clock;
    clock.start();
    const bool ran = latest() && latest()->ran() && !latest()->result.sections.empty();
    if (ran) {
        const auto kind = [](const OutcomePtr& o) {
            return std::pair(o->result.project.operation, o->result.sections.size());
        };
        if (!m_good || kind(m_good) != kind(latest())) {
            m_chosen.reset();
        }
        m_good = latest();
        fillStrokes();
        fillSections();
        showSeries();
    }
    m_across->setDimmed(m_good && !ran);
    m_along->setDimmed(m_good && !ran);
    m_spectrum->setDimmed(m_good && !ran);
    showState();
    showLegend();
    m_across->replot();
    m_along->replot();
    m_spectrum->replot();
    for (PlotTools* tools : {m_acrossTools, m_alongTools, m_spectrumTools}) {
        tools->navigation().amendView();
    }
    m_lastUpdate_ms = static_cast<double>(clock.nsecsElapsed()) / 1e6;
    emit updated();
}

// --- what is shown ------------------------------------------------------------------------------

bool ProfilesView::recorded() const {
    return m_good && !m_good->trajectory.passes.empty();
}

int ProfilesView::stroke() const {
    const CycleCursor* const at = cycleIn(m_good);
    return at && !at->atEnd() ? at->stroke() : m_good ? m_good->result.cycleCount : 0;
}

void ProfilesView::showSeries() {
    if (!m_good) {
        return;
    }
    const CycleCursor* const at = cycleIn(m_good);
    const ProfileSeries series =
        makeProfileSeries(m_good->result, m_good->trajectory,
                          at && !at->atEnd() ? std::optional(at->progress()) : std::nullopt);
    const std::vector<int> shown = shownProfiles();
    m_across->setSeries(series, shown);
    m_along->setSeries(series, shaftSteps(m_good->result.project), shown);
    showSpectrum();
    fillMagnifications();
    showStroke();
    showDescription();
}

/// Of the profiles shown across; nothing is computed while it is not in sight.
void ProfilesView::showSpectrum() {
    if (m_good && showsSpectrum()) {
        m_spectrum->setSeries(m_across->series(), m_across->shown());
    }
}

void ProfilesView::showState() {
    const bool refused = latest() && !latest()->ran();
    QString text;
    if (refused) {
        text = (m_good ? tr("The inputs are refused; the profiles are those of the last accepted "
                            "ones.")
                       : tr("The inputs are refused:"))
               + QLatin1Char('\n') + Names::refusal(latest()->issues, 2);
    } else if (!m_good) {
        text = tr("No result yet.");
    } else if (m_good->result.status != RunStatus::completed) {
        text = Names::status(m_good->result.status);
    }
    if (m_good && !recorded()) {
        text += (text.isEmpty() ? QString() : QStringLiteral("\n"))
                + tr("The cycle is too long to be recorded: only its end is shown.");
    }
    if (const QString strips = m_good ? Names::uncutStrips(m_good->result.project) : QString();
        !strips.isEmpty()) {
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + strips;
    }
    m_notice->setText(text);
    m_notice->setVisible(!text.isEmpty());
    for (QWidget* w : std::initializer_list<QWidget*>{m_legend, m_values, m_strokeBar}) {
        w->setVisible(m_good != nullptr);
    }
    for (QWidget* tool : std::initializer_list<QWidget*>{m_parts, m_section, m_magnification,
                                                         m_reference, m_circles, m_blank, m_fit}) {
        tool->setEnabled(m_good != nullptr);
    }
    m_acrossTools->setEnabled(m_good != nullptr);
    m_alongTools->setEnabled(m_good != nullptr);
    m_spectrumTools->setEnabled(m_good != nullptr);
    showParts();
}

ProfilesView::Parts ProfilesView::parts() const {
    return static_cast<Parts>(std::max(m_parts->currentIndex(), 0));
}

bool ProfilesView::showsAcross() const {
    return parts() != Parts::length && parts() != Parts::spectrum;
}

bool ProfilesView::showsAlong() const {
    return parts() == Parts::sectionsAndLength || parts() == Parts::length;
}

bool ProfilesView::showsSpectrum() const {
    return parts() == Parts::sectionsAndSpectrum || parts() == Parts::spectrum;
}

/// The tools of what is not in sight go with it.
void ProfilesView::showParts() {
    m_splitter->setVisible(m_good != nullptr);
    for (QWidget* w : std::initializer_list<QWidget*>{m_across, m_acrossExport, m_magnification,
                                                      m_reference, m_circles}) {
        w->setVisible(showsAcross());
    }
    for (QWidget* w : std::initializer_list<QWidget*>{m_along, m_alongExport, m_cursorsButton,
                                                      m_quantity, m_toScale}) {
        w->setVisible(showsAlong());
    }
    for (QWidget* w :
         std::initializer_list<QWidget*>{m_spectrum, m_spectrumExport, m_logarithmic}) {
        w->setVisible(showsSpectrum());
    }
    m_quantity->setEnabled(m_good && !m_toScale->isChecked());
}

// --- the moment ---------------------------------------------------------------------------------

void ProfilesView::fillStrokes() {
    const int count = m_good->result.cycleCount;
    const QSignalBlocker sliderBlocker(m_slider);
    const QSignalBlocker numberBlocker(m_number);
    m_slider->setRange(0, count);
    m_slider->setPageStep(std::max(count / 10, 1));
    m_number->setRange(0, count);
}

void ProfilesView::showStroke() {
    const QSignalBlocker sliderBlocker(m_slider);
    const QSignalBlocker numberBlocker(m_number);
    const int number = stroke();
    m_slider->setValue(number);
    m_number->setValue(number);
    const bool strokes = !m_good || m_good->result.project.operation->countsStrokes;
    m_strokeLabel->setText(strokes ? tr("Double stroke") : tr("Revolution"));
    m_number->setSuffix(tr(" of %1").arg(m_slider->maximum()));
    const bool can = recorded();
    for (QWidget* w : std::initializer_list<QWidget*>{m_slider, m_number}) {
        w->setEnabled(can);
    }
    m_previous->setEnabled(can && number > 0);
    m_next->setEnabled(can && number < m_slider->maximum());
    const QString moment = m_good ? ProfilesText::moment(m_across->series()) : QString();
    for (QWidget* w : std::initializer_list<QWidget*>{m_slider, m_number}) {
        w->setToolTip(moment);
        w->setAccessibleDescription(moment);
    }
}

void ProfilesView::setStroke(int number) {
    if (m_good && number >= m_good->result.cycleCount) {
        cycle().setPosition(cycle().count());
    } else if (m_good) {
        cycle().toStroke(number);
    }
}

void ProfilesView::followCycle() {
    showSeries();
    replotAll();
}

void ProfilesView::showSection(int section) {
    redraw();
    if (m_good) {
        setStroke(m_good->result.cycleCount);
        m_section->setCurrentIndex(std::max(m_section->findData(section), 0));
    }
}

// --- drawing ------------------------------------------------------------------------------------

void ProfilesView::fit() {
    for (PlotTools* tools : {m_acrossTools, m_alongTools, m_spectrumTools}) {
        tools->navigation().fit();
    }
}

void ProfilesView::replotAll() {
    m_across->replot(QCustomPlot::rpQueuedReplot);
    m_along->replot(QCustomPlot::rpQueuedReplot);
    m_spectrum->replot(QCustomPlot::rpQueuedReplot);
    for (PlotTools* tools : {m_acrossTools, m_alongTools, m_spectrumTools}) {
        tools->navigation().amendView();
    }
}

// --- texts --------------------------------------------------------------------------------------

std::vector<ProfileLine> ProfilesView::acrossLines() const {
    using enum ProfileLine;
    switch (m_across->circles()) {
    case ReferenceCircles::leastSquares: return {profile, target, leastSquares, field, blank};
    case ReferenceCircles::minimumZone: return {profile, target, minimumZone, field, blank};
    case ReferenceCircles::none: break;
    }
    return {profile, target, field, blank};
}

std::vector<ProfileLine> ProfilesView::legendLines() const {
    using enum ProfileLine;
    std::vector<ProfileLine> lines;
    switch (parts()) {
    case Parts::sections:
    case Parts::sectionsAndSpectrum: return acrossLines();
    case Parts::length: return {profile, spread, target, field, blank, gauge};
    case Parts::spectrum: return {profile, blank};
    case Parts::sectionsAndLength:
        lines = acrossLines();
        lines.insert(lines.begin() + 1, spread);
        lines.push_back(gauge);
    }
    return lines;
}

LegendEntries ProfilesView::entriesOf(const std::vector<ProfileLine>& lines,
                                      const QPalette& palette) const {
    LegendEntries entries;
    const bool dim = m_good && latest() && !latest()->ran();
    for (const ProfileLine line : lines) {
        LegendEntry entry;
        const bool swatch = line == ProfileLine::spread || line == ProfileLine::field;
        const QPen pen = ProfileLook::pen(line, palette, dim);
        entry.colour = swatch ? ProfileLook::fill(line, palette, dim) : pen.color();
        entry.pen = swatch ? Qt::NoPen : pen.style();
        entry.text = ProfileLook::name(line);
        entry.key = static_cast<int>(line);
        entry.shown = !m_hidden.contains(line);
        entries.push_back(entry);
    }
    return entries;
}

void ProfilesView::showLegend() {
    m_legend->setEntries(entriesOf(legendLines(), palette()));
}

void ProfilesView::showDescription() {
    const QString text = ProfilesText::summary(m_across->series(), m_across->shown());
    setAccessibleDescription(text);
    m_across->setAccessibleDescription(text + QStringLiteral(". ") + m_across->caption());
    m_along->setAccessibleDescription(text);
    m_spectrum->setAccessibleDescription(text);
}

QString ProfilesView::brief() const {
    return tr("Profiles", "the view's tab");
}

QString ProfilesView::title() const {
    return tr("Zone profiles");
}

void ProfilesView::retranslate() {
    m_acrossTools->retranslate();
    m_alongTools->retranslate();
    m_spectrumTools->retranslate();
    m_strip->retranslate();
    m_legend->retranslate();
    buildLabels();
    if (m_good) {
        fillSections();
    }
    m_across->retranslate();
    m_along->retranslate();
    m_spectrum->retranslate();
    if (m_good) {
        fillMagnifications();
        showStroke();
        showDescription();
    }
    showState();
    showLegend();
    readOut();
    replotAll();
}

QString ProfilesView::hint() const {
    return tr("Point at a profile to read its values.");
}

void ProfilesView::recolour() {
    showLegend();
}

} // namespace sparkout
