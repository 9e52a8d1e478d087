// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_view.h"

#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_pages.h"
#include "ui/text/names.h"
#include "ui/views/sweep/sweep_axis_box.h"
#include "ui/views/sweep/sweep_curves.h"
#include "ui/views/sweep/sweep_map.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

/// Whether no result of any point differs from those of the first.
bool nothingChanges(const SweepResult& sweep) {
    const SweepPoint* first = nullptr;
    for (const SweepPoint& point : sweep.points) {
        if (point.status != SweepStatus::done) {
            return false;
        }
        first = first ? first : &point;
        const bool same =
            std::ranges::equal(point.values, first->values, [](const auto& a, const auto& b) {
                const auto equal = [](double x, double y) {
                    return x == y || (std::isnan(x) && std::isnan(y));
                };
                return equal(a.value, b.value) && equal(a.low, b.low) && equal(a.high, b.high);
            });
        if (!same) {
            return false;
        }
    }
    return sweep.points.size() > 1;
}

} // namespace

QString SweepView::brief() const {
    return tr("Sweep", "the view's tab");
}

QString SweepView::title() const {
    return tr("Sweep");
}

std::array<SweepPlot*, 2> SweepView::plots() const {
    return {m_curves, m_map};
}

SweepPlot& SweepView::plot() const {
    return *plots()[m_sweep && m_sweep->result.inputs.size() > 1 ? 1 : 0];
}

PlotTools* SweepView::tools() const {
    return m_pages->page().tools;
}

SweepEntry SweepView::chosenEntry() const {
    const auto at = static_cast<std::size_t>(std::max(m_entry->currentIndex(), 0));
    return at < m_entries.size() ? m_entries[at] : SweepEntry{};
}

void SweepView::chooseEntry() {
    if (!m_entries.empty()) {
        m_wanted = chosenEntry().key;
    }
    showPlots();
    showState();
    m_pages->page().tools->navigation().forgetViews();
}

void SweepView::choosePoint(std::optional<std::size_t> point) {
    m_chosen = m_sweep ? point : std::nullopt;
    const QSignalBlocker blocker(m_point);
    m_point->setValue(m_chosen ? static_cast<int>(*m_chosen) + 1 : 0);
    plot().setChosen(m_chosen);
    showState();
    replotShown();
}

// --- showing ------------------------------------------------------------------------------------

/// What was chosen stays, as long as there is such a result.
void SweepView::fillEntries() {
    const QSignalBlocker blocker(m_entry);
    m_entry->clear();
    m_entries.clear();
    if (!m_sweep) {
        return;
    }
    const SweepResult& sweep = m_sweep->result;
    m_entries = sweepEntries(sweep, sweep.inputs.size() > 1);
    for (const SweepEntry& entry : m_entries) {
        const bool all = entry.quantities.size() > 1 && sweep.inputs.size() > 1;
        const QString text = SweepText::entry(sweep, entry);
        m_entry->addItem(all ? tr("%1, worst place").arg(text) : text);
    }
    const auto found = std::ranges::find(m_entries, m_wanted, &SweepEntry::key);
    m_entry->setCurrentIndex(
        found == m_entries.end() ? 0 : static_cast<int>(found - m_entries.begin()));
}

void SweepView::showSweep() {
    const int points = m_sweep ? static_cast<int>(m_sweep->result.points.size()) : 0;
    if (m_chosen && *m_chosen >= static_cast<std::size_t>(points)) {
        m_chosen.reset();
    }
    {
        const QSignalBlocker blocker(m_point);
        m_point->setRange(0, points);
        m_point->setValue(m_chosen ? static_cast<int>(*m_chosen) + 1 : 0);
        m_point->setSuffix(points > 0 ? tr(" of %1").arg(points) : QString());
    }
    fillEntries();
    showPlots();
    if (m_good) {
        showPresent();
    }
    for (const PlotPages::Page& each : m_pages->all()) {
        each.tools->navigation().amendView();
    }
}

void SweepView::showPlots() {
    for (SweepPlot* other : plots()) {
        const bool shown = other == &plot();
        other->setChosen(shown ? m_chosen : std::nullopt);
        other->setSweep(shown ? m_sweep : nullptr, shown ? chosenEntry() : SweepEntry{},
                        m_side->currentIndex() == 1);
    }
    m_pages->show(&plot() == m_map ? 1 : 0);
    showState();
    replotShown();
}

void SweepView::replotShown() {
    plot().replot(QCustomPlot::rpQueuedReplot);
}

QString SweepView::hint() const {
    return m_sweep && m_chosen ? SweepText::point(m_sweep->result, *m_chosen, chosenEntry())
                               : tr("Point at a place to read its values; a click chooses it.");
}

void SweepView::showState() {
    const bool faint = m_sweep && (stale() || (latest() && !latest()->ran()));
    for (SweepPlot* each : plots()) {
        each->setDimmed(faint);
    }
    m_notice->setText(notice());
    m_notice->setVisible(!m_notice->text().isEmpty());
    m_state->setText(m_sweep ? SweepText::run(m_sweep->result) : QString());
    showButtons();
    readOut();
    plot().setAccessibleDescription(m_state->text());
}

void SweepView::showButtons() {
    const bool has = m_good && m_good->result.project.sweep;
    const bool accepted = latest() && latest()->ran();
    const bool runs = busy();
    const bool drawn = m_sweep && !m_entries.empty();
    for (SweepAxisBox* box : m_axes) {
        box->setVisible(m_good != nullptr);
        box->setEnabled(accepted);
    }
    m_axes[1]->setVisible(has);
    m_add->setVisible(m_good && !has);
    m_add->setEnabled(accepted);
    m_runBar->setVisible(has);
    m_toolBar->setVisible(has);
    m_run->setEnabled(has && !runs && m_refused.empty());
    m_stop->setEnabled(runs);
    m_progress->setVisible(runs);
    m_state->setVisible(!runs);
    m_point->setEnabled(drawn);
    m_take->setEnabled(drawn && m_chosen && accepted);
    m_takeButton->setEnabled(m_take->isEnabled());
    m_entry->setEnabled(drawn);
    m_side->setEnabled(drawn);
    for (QWidget* part : std::initializer_list<QWidget*>{m_pages->stack(), m_legend, m_values}) {
        part->setVisible(drawn);
    }
    for (const PlotPages::Page& each : m_pages->all()) {
        each.tools->setEnabled(drawn);
    }
}

QString SweepView::notice() const {
    if (latest() && !latest()->ran()) {
        return (m_sweep ? tr("The inputs are refused; the sweep is that of the last accepted ones.")
                        : tr("The inputs are refused:"))
               + QLatin1Char('\n') + Names::refusal(latest()->issues, 2);
    }
    if (!m_good) {
        return tr("No result yet.");
    }
    if (!m_good->result.project.sweep) {
        return tr(
            "What does a dull wheel do, a soft tailstock, a longer dwell? Choose an input "
            "above, and see every result over a range of it: one input gives curves, two give "
            "a map. Or start with the wheel's dullness.");
    }
    if (!m_refused.empty()) {
        return tr("The sweep cannot be run:") + QLatin1Char('\n') + Names::refusal(m_refused, 2);
    }
    if (m_sweep && stale()) {
        return busy() ? tr("Of the inputs before the last edit; the new sweep is being run.")
                      : tr("Of the inputs before the last edit. Press “Run” for those of now.");
    }
    if (m_sweep) {
        return remark();
    }
    return busy() ? QString()
                  : tr("This sweep takes a while: press “Run”. It can be stopped at any time and "
                       "keeps what was done.");
}

QString SweepView::remark() const {
    const SweepResult& sweep = m_sweep->result;
    if (m_entries.empty()) {
        const auto refused =
            std::ranges::find(sweep.points, SweepStatus::refused, &SweepPoint::status);
        return refused == sweep.points.end()
                   ? tr("The cycle reaches size at no point of the range.")
                   : tr("No point has a result. Refused:") + QLatin1Char('\n')
                         + Names::refusal(refused->issues, 2);
    }
    return nothingChanges(sweep)
               ? tr("Nothing changes over this range: the model does not read the "
                    "input as this project is set.")
               : QString();
}

QStringList SweepView::heading() const {
    QStringList heading{title()};
    if (m_sweep) {
        heading << QString::fromStdString(m_sweep->result.project.title).simplified()
                << m_entry->currentText() << m_state->text();
    }
    heading.removeAll(QString());
    return heading;
}

void SweepView::nameParts() {
    m_legend->setAccessibleName(tr("Legend of the sweep"));
    m_notice->setAccessibleName(tr("State of the sweep"));
    m_state->setAccessibleName(tr("What was run"));
    m_values->setAccessibleName(tr("Values under the mouse, or of the point chosen"));
    m_progress->setAccessibleName(tr("Progress of the sweep"));
    m_curves->setAccessibleName(tr("Curves over the varied input"));
    m_map->setAccessibleName(tr("Map over the two varied inputs"));
    const auto name = [](QWidget& widget, const QString& text, const QString& tip) {
        widget.setAccessibleName(text);
        widget.setAccessibleDescription(tip);
        widget.setToolTip(tip);
    };
    name(*m_entry, tr("Result shown"), tr("The result that is shown over the varied inputs"));
    name(*m_side, tr("Values or margins"),
         tr("The values themselves, or how far they are from their limits: above 0 the requirement "
            "holds"));
    name(*m_point, tr("Point chosen"),
         tr("The point whose values can be taken; a click in the plot chooses one, too"));
    const auto button = [&name](QPushButton& of, const QString& text, const QString& tip) {
        of.setText(text);
        name(of, text, tip);
    };
    button(*m_run, tr("Run"), tr("Run the points of the sweep; a quick one runs by itself"));
    button(*m_stop, tr("Stop"), tr("End the sweep; what was done is kept and shown"));
    button(*m_add, tr("Vary the dullness"),
           tr("A sweep of the wheel's dullness from half to twice its value; can be undone"));
    const QString take = tr("Take these values");
    m_take->setText(take);
    button(*m_takeButton, take,
           tr("Put the inputs of the chosen point into this project; undo brings yours back"));
}

void SweepView::retranslate() {
    setAccessibleName(tr("Sweep"));
    nameParts();
    m_side->setItemText(0, tr("Values"));
    m_side->setItemText(1, tr("Margins"));
    m_point->setPrefix(tr("point "));
    m_point->setSpecialValueText(tr("no point"));
    m_legend->retranslate();
    for (SweepAxisBox* box : m_axes) {
        box->retranslate();
        box->show(m_good ? m_good->result.project : Project());
    }
    showSweep();
    for (const PlotPages::Page& each : m_pages->all()) {
        each.tools->retranslate();
    }
    for (SweepPlot* each : plots()) {
        each->retranslate();
        each->replot(QCustomPlot::rpQueuedReplot);
    }
}

void SweepView::recolour() {
    m_pages->showLegend();
}

} // namespace sparkout
