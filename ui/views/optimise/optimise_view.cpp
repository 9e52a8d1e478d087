// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/optimise/optimise_view.h"

#include "core/format/project_file.h"
#include "core/study/search_edits.h"
#include "ui/charts/compare_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_pages.h"
#include "ui/text/names.h"
#include "ui/views/optimise/found_model.h"
#include "ui/views/optimise/optimise_text.h"
#include "ui/views/optimise/stage_count_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>

#include <algorithm>

namespace sparkout {

QString OptimiseView::brief() const {
    return tr("Optimise", "the view's tab");
}

QString OptimiseView::title() const {
    return tr("Optimise");
}

PlotTools* OptimiseView::tools() const {
    return m_pages->page().tools;
}

const FoundCycle* OptimiseView::chosen() const {
    const int row = m_table->currentIndex().row();
    return m_search && row >= 0 && row < static_cast<int>(m_search->found.size())
               ? &m_search->found[static_cast<std::size_t>(row)]
               : nullptr;
}

std::optional<double> OptimiseView::before_s() const {
    return m_before && m_before->result.status == RunStatus::completed
               ? std::optional(m_before->result.time_s)
               : std::nullopt;
}

/// Whether the present cycle is one of those that were found.
bool OptimiseView::isTaken() const {
    return !m_stale && std::ranges::any_of(m_search->found, [&](const FoundCycle& found) {
        Project taken = m_good->result.project;
        setMachine(taken, found.machine);
        taken.cycle = found.cycle;
        return sameProject(taken, m_good->result.project);
    });
}

// --- searching ----------------------------------------------------------------------------------

void OptimiseView::showOutcome() {
    if (latest() && latest()->ran() && m_good != latest()) {
        const bool same = m_good
                          && m_good->result.project.operation == latest()->result.project.operation
                          && m_good->result.sections.size() == latest()->result.sections.size();
        m_good = latest();
        if (!same) { // the gauge's zone, or the middle section
            m_wanted = m_good->result.sections.size() / 2;
            fillZones();
        }
        if (m_searching && busy() && !sameSearch(*m_searching, m_good->result.project)) {
            m_runner->drop();
        }
        noteStale();
        const bool mayCompare =
            m_own && isTaken() && sameSearch(m_own->result.project, m_good->result.project);
        m_before = mayCompare ? m_own : m_good;
        m_found->setBefore(before_s());
        m_times->setSearch(m_search, before_s());
        showCurves();
    }
    showState();
    emit updated();
}

void OptimiseView::noteStale() {
    m_stale = !m_search || !m_good || !sameSearch(m_search->project, m_good->result.project);
}

void OptimiseView::runSearch() {
    if (!m_good) {
        return;
    }
    m_searching = m_good->result.project;
    m_progress->setValue(0);
    m_progress->setFormat(OptimiseText::state({}));
    m_runner->start(*m_searching, {m_phases->isChecked(), m_refine->isChecked()});
    showState();
}

void OptimiseView::takeSearch(const SearchOutcomePtr& outcome) {
    m_search = outcome;
    noteStale();
    showSearch();
    emit searchShown();
}

void OptimiseView::forget() {
    m_runner->drop();
    m_search.reset();
    noteStale();
    showSearch();
}

void OptimiseView::showSearch() {
    m_own.reset();
    m_before = m_good;
    m_found->show(m_search, before_s());
    m_times->setSearch(m_search, before_s());
    m_trial.reset();
    if (m_search && m_search->best()) {
        m_table->selectRow(0);
    }
    for (const PlotPages::Page& page : m_pages->all()) {
        page.tools->navigation().forgetViews();
    }
    tryCycle();
    showCurves();
    showState();
}

void OptimiseView::tryCycle() {
    if (const FoundCycle* cycle = chosen()) {
        Project project = m_search->project;
        setMachine(project, cycle->machine);
        project.cycle = cycle->cycle;
        m_trials->request(std::move(project));
    }
    showState();
}

void OptimiseView::takeTrial(const OutcomePtr& outcome) {
    m_trial = chosen() && outcome->ran() ? outcome : nullptr; // forgotten meanwhile: none
    showCurves();
    emit curvesShown();
}

void OptimiseView::takeCycle() {
    const FoundCycle* cycle = chosen();
    if (!cycle || m_stale) {
        return;
    }
    if (!isTaken()) {
        m_own = m_good;
    }
    const auto take = [searched = m_search->project, found = *cycle](Project project) {
        if (sameSearch(searched, project)) { // else edited meanwhile
            setMachine(project, found.machine);
            project.cycle = found.cycle;
        }
        return project;
    };
    emit editWanted(take, {"Edit", QT_TRANSLATE_NOOP("Edit", "Take the cycle found")});
}

// --- showing ------------------------------------------------------------------------------------

void OptimiseView::chooseContent() {
    m_pages->show();
    m_zone->setVisible(m_pages->page().plot == m_curves);
    showState();
    m_pages->page().plot->replot(QCustomPlot::rpQueuedReplot);
}

void OptimiseView::chooseZone() {
    m_wanted = static_cast<std::size_t>(std::max(m_zone->currentIndex(), 0));
    showCurves();
}

void OptimiseView::fillZones() {
    const QSignalBlocker blocker(m_zone);
    m_zone->clear();
    if (m_good) {
        for (const SectionResult& section : m_good->result.sections) {
            const auto number = static_cast<int>(&section - m_good->result.sections.data());
            m_zone->addItem(Names::zoneFull(section.zone, number));
        }
        m_zone->setCurrentIndex(static_cast<int>(m_wanted));
    }
}

void OptimiseView::showCurves() {
    std::vector<ComparedFeeds> runs;
    if (m_before && m_wanted < m_before->feeds.columns.size()) {
        runs.push_back({tr("Your cycle"), {m_before, &m_before->feeds}, m_wanted});
        if (m_trial && m_wanted < m_trial->feeds.columns.size()) {
            runs.push_back({tr("Cycle found"), {m_trial, &m_trial->feeds}, m_wanted, 1});
        }
    }
    m_curves->setRuns(std::move(runs));
    dim();
    for (const PlotPages::Page& page : m_pages->all()) {
        page.tools->navigation().amendView();
        page.plot->replot(QCustomPlot::rpQueuedReplot);
    }
    m_pages->showLegend();
}

/// What was found before, while another search runs or after an edit.
void OptimiseView::dim() {
    const bool old = m_stale || busy();
    const std::pair<ViewPlot*, bool> plots[] = {{m_curves, old && m_trial}, {m_times, old}};
    for (const auto& [plot, isOld] : plots) {
        if (plot->isDimmed() != isOld) {
            plot->setDimmed(isOld);
            plot->replot(QCustomPlot::rpQueuedReplot);
        }
    }
}

void OptimiseView::showState() {
    const bool given = m_good && m_good->result.project.optimisation;
    const QString text = notice();
    m_notice->setText(text);
    m_notice->setVisible(!text.isEmpty());
    m_add->setVisible(m_good && !given);
    m_progress->setVisible(busy());
    m_stop->setVisible(busy());
    m_run->setVisible(!busy());
    m_run->setEnabled(given);
    for (QCheckBox* wish : {m_phases, m_refine}) { // the progress takes their room
        wish->setVisible(!busy());
        wish->setEnabled(given);
    }
    m_state->setText(given && !busy()
                         ? OptimiseText::gridSize(sparkout::gridSize(m_good->result.project))
                         : QString());
    m_state->setVisible(!busy());
    const bool found = m_search && m_search->best();
    m_table->setVisible(found);
    m_take->setEnabled(chosen() && !m_stale && !busy());
    dim();
    const bool drawn = m_pages->page().plot == m_times ? found : !m_curves->runs().empty();
    for (QWidget* part : std::initializer_list<QWidget*>{m_pages->stack(), m_legend, m_values}) {
        part->setVisible(drawn && (given || found));
    }
    m_pages->page().tools->setEnabled(drawn);
    readOut();
}

QString OptimiseView::hint() const {
    return m_pages->page().plot == m_curves
               ? tr("Point at a curve to read its values beside those of your cycle.")
               : tr("Point at a number of stages to read its time.");
}

QString OptimiseView::notice() const {
    if (latest() && !latest()->ran()) {
        return (m_search ? tr("The inputs are refused; the search is that of the last accepted "
                              "ones.")
                         : tr("The inputs are refused:"))
               + u'\n' + Names::refusal(latest()->issues, 2);
    }
    if (!m_good) {
        return tr("No result yet.");
    }
    if (!m_good->result.project.optimisation) {
        return tr("This project does not say what may be changed. A search takes every listed feed "
                  "and stock of the stages and finds the quickest cycle that holds every "
                  "requirement. Choose them on the page Search of the inputs, or start with usual "
                  "ones.");
    }
    if (!m_search) {
        return busy() ? QString()
                      : tr("“Search” finds the quickest cycle of the grid that holds every "
                           "requirement. It can be stopped at any time and keeps the best so far.");
    }
    if (m_stale) {
        return busy() ? tr("Of the inputs before the last edit; those of now are being searched.")
                      : tr("Of the inputs before the last edit. Press “Search” for those of now.");
    }
    if (!m_search->ran()) {
        return OptimiseText::fault(*m_search);
    }
    return OptimiseText::answer(*m_search, before_s());
}

QStringList OptimiseView::heading() const {
    QStringList heading{title()};
    if (m_good) {
        heading << QString::fromStdString(m_good->result.project.title).simplified();
        if (m_pages->page().plot == m_curves) {
            heading << m_zone->currentText();
        }
    }
    heading.removeAll(QString());
    return heading;
}

void OptimiseView::retranslate() {
    nameParts();
    m_legend->retranslate();
    m_curves->retranslate();
    m_times->retranslate();
    m_found->retranslate();
    m_table->retranslate();
    fillZones();
    for (const PlotPages::Page& page : m_pages->all()) {
        page.tools->retranslate();
    }
    showCurves();
    showState();
}

void OptimiseView::recolour() {
    m_pages->showLegend();
}

} // namespace sparkout
