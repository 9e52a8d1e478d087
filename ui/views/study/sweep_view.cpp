// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/sweep_view.h"

#include "core/file/project_file.h"
#include "core/process/force.h"
#include "core/project/number_input.h"
#include "core/project/sweep.h"
#include "core/project/wheel.h"
#include "core/study/sweep_edits.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/legend.h"
#include "ui/kit/search_combo.h"
#include "ui/kit/tool_row.h"
#include "ui/text/names.h"
#include "ui/views/study/phase_chart.h"
#include "ui/views/study/sweep_bars.h"
#include "ui/views/study/sweep_charts.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int valueLines = 3;
constexpr std::size_t curvesPage = 0, mapPage = 1, phasesPage = 2;

} // namespace

SweepView::SweepView(QWidget* parent, Settings* settings, Studies* studies)
    : StudyView(QStringLiteral("sweep"), parent, settings, studies)
    , m_subject(new QComboBox(this))
    , m_entry(new SearchCombo(this))
    , m_side(new QComboBox(this))
    , m_phaseBar(new PhaseBar(this))
    , m_axes{new SweepAxisBox(0, this), new SweepAxisBox(1, this)}
    , m_curves(new ChartPlot(this))
    , m_map(new ChartPlot(this))
    , m_phases(new ChartPlot(this))
    , m_point(new QSpinBox(this))
    , m_bar(new RunBar(QStringLiteral("sweep"), this, SweepText::progress))
    , m_take(new QAction(this))
    , m_takeButton(new QPushButton(this))
    , m_add(new QPushButton(this)) {
    for (ChartPlot* plot : {m_curves, m_map}) {
        plot->setMinimumSize(240, 120);
        PlotSubject subject;
        subject.own = {m_take};
        addPage(*plot, std::move(subject));
    }
    m_phases->setMinimumSize(240, 120);
    addPage(*m_phases);
    setUpReadout(*values(), valueLines);
    setUpNotice(*m_bar->state());
    m_point->setKeyboardTracking(false);
    disableUntilDrawn({m_point, m_entry, m_side});
    constexpr int letters = 30; // least width of the text on the run, in letters
    m_bar->layOut({}, {m_point, m_takeButton}, letters);
    QVBoxLayout* const column =
        addColumn({m_toolBar = buildTools(), m_phaseBar, m_axes[0], m_axes[1], m_bar, notice(),
                   m_add, legend(), pages(), values()},
                  pages());
    column->setAlignment(m_add, Qt::AlignLeft);
    column->addStretch(0);
    nameObjects({{m_curves, "sweepCurves"},
                 {m_map, "sweepMap"},
                 {m_phases, "sweepPhases"},
                 {m_subject, "sweepSubject"},
                 {m_entry, "sweepResult"},
                 {m_side, "sweepSide"},
                 {m_point, "sweepPoint"},
                 {m_add, "sweepAdd"},
                 {m_takeButton, "sweepTake"}});
    connectParts();
    connectEdits();
    built();
}

QWidget* SweepView::buildTools() {
    auto* bar = new QWidget(this);
    auto* row = rowIn<ToolRow>(bar);
    addBoxes(*row, {m_subject, m_entry, m_side});
    row->addStretch(1);
    addPageButtons(*row);
    return bar;
}

void SweepView::connectParts() {
    connect(m_subject, &QComboBox::currentIndexChanged, this, &SweepView::chooseSubject);
    connect(m_phaseBar, &PhaseBar::changed, this, &SweepView::takePhases);
    connect(m_entry, &QComboBox::currentIndexChanged, this, &SweepView::chooseEntry);
    connect(m_side, &QComboBox::currentIndexChanged, this, &SweepView::chooseEntry);
    for (ChartPlot* plot : {m_curves, m_map}) {
        connect(plot, &ChartPlot::placeClicked, this, [this](double place, double value) {
            if (!m_shown.empty()) {
                choosePoint(m_shown.pointNear(place, value));
            }
        });
    }
    connect(m_bar->run(), &QPushButton::clicked, this, &SweepView::runSweep);
    connect(m_take, &QAction::triggered, this, &SweepView::takeValues);
    connect(m_takeButton, &QPushButton::clicked, m_take, &QAction::trigger);
    connect(m_point, &QSpinBox::valueChanged, this, [this](int number) {
        choosePoint(number > 0 ? std::optional(static_cast<std::size_t>(number - 1))
                               : std::nullopt);
    });
    m_bar->follow(studies().sweep.job());
    connect(&studies().sweep.job(), &Job::answered, this, &SweepView::takeSweep);
}

void SweepView::connectEdits() {
    const auto choose = [this](std::size_t place, const std::string& path) {
        edit([place,
              path](Project project) { return withSweptInput(std::move(project), place, path); },
             {"Edit", QT_TRANSLATE_NOOP("Edit", "Input of the sweep")});
    };
    for (std::size_t place = 0; place < m_axes.size(); ++place) {
        connect(m_axes[place], &SweepAxisBox::inputChosen, this,
                [choose, place](const std::string& path) { choose(place, path); });
        connect(m_axes[place], &SweepAxisBox::axisEdited, this,
                [this, place](const SweepAxis& axis) {
                    edit(
                        [place, axis](Project project) {
                            return withSweepAxis(std::move(project), place, axis);
                        },
                        {"Edit", QT_TRANSLATE_NOOP("Edit", "Range of the sweep")});
                });
    }
    connect(m_add, &QPushButton::clicked, this, [this] {
        edit(
            [](Project project) {
                const char* const path = dullnessPath(*project.wheel);
                return withSweptInput(std::move(project), 0, path);
            },
            {"Edit", QT_TRANSLATE_NOOP("Edit", "Input of the sweep")});
    });
}

// --- choices ------------------------------------------------------------------------------------

ChartPlot& SweepView::plot() const {
    return sweep() && sweep()->inputs.size() > 1 ? *m_map : *m_curves;
}

SweepEntry SweepView::chosenEntry() const {
    const auto at = static_cast<std::size_t>(std::max(m_entry->currentIndex(), 0));
    return at < m_entries.size() ? m_entries[at] : SweepEntry{};
}

void SweepView::chooseEntry() {
    if (!m_entries.empty()) {
        m_wanted = chosenEntry().key;
    }
    showEntry();
    tools()->navigation().forgetViews();
}

bool SweepView::showsPhases() const {
    return m_subject->currentIndex() == 1;
}

void SweepView::chooseSubject() {
    if (good()) {
        follow(false);
    }
    showFront();
    showState();
}

void SweepView::choosePoint(std::optional<std::size_t> point) {
    m_shown.chosen = sweep() ? point : std::nullopt;
    const QSignalBlocker blocker(m_point);
    m_point->setValue(m_shown.chosen ? static_cast<int>(*m_shown.chosen) + 1 : 0);
    plot().remake();
    showState();
    replotFront();
}

// --- running ------------------------------------------------------------------------------------

void SweepView::showOutcome() {
    m_edited = false;
    PlotView::showOutcome();
}

void SweepView::takeOutcome(const OutcomePtr&) {
    follow(std::exchange(m_asked, false));
}

bool SweepView::busy() const {
    return studies().sweep.running() || m_phaseBar->busy();
}

/// Runs only the visible content by itself.
void SweepView::follow(bool asked) {
    if (showsPhases()) {
        m_phaseBar->follow(good()->result.project);
    }
    followSweep(asked);
}

void SweepView::followSweep(bool asked) {
    const Project& project = good()->result.project;
    for (SweepAxisBox* box : m_axes) {
        box->show(project);
    }
    m_refused = project.sweep ? checkSweep(project) : Issues();
    StudyOf<SweepResult>& study = studies().sweep;
    study.follow(&project);
    if (!project.sweep) {
        forgetSweep();
    } else if (!m_refused.empty()) {
        study.job().drop();
    } else if (stale() && !study.running()) {
        const bool quick = RunBar::areQuick(pointsOf(project), good()->result.visits);
        if (asked || (quick && !showsPhases())) {
            runSweep();
        }
    }
    showPresent();
}

void SweepView::dropStudies() {
    m_phaseBar->forget();
    forgetSweep();
}

void SweepView::forgetSweep() {
    studies().sweep.forget();
    showSweep();
}

void SweepView::runSweep() {
    if (m_edited) { // the new project follows
        m_asked = true;
        return;
    }
    const Project& project = good()->result.project;
    m_bar->showProgress(0, pointsOf(project));
    studies().runSweep(project);
    showState();
}

void SweepView::takeSweep() {
    if (m_shown.result != sweep()) {
        m_shown.chosen.reset();
        showSweep();
    }
    showState();
    emit ended();
}

void SweepView::takePhases() {
    const PhaseOutcomePtr& phases = m_phaseBar->phases();
    const PhaseOutcomePtr decided = phases && phases->decision.isDecided ? phases : nullptr;
    if (m_phasesShown != decided) {
        m_phasesShown = decided;
        m_phases->setChart([decided] { return PhaseChart::of(decided); });
    }
    showState();
    replotFront();
}

void SweepView::edit(const std::function<Project(Project)>& edit, const EditText& text) {
    emit editWanted(
        [this, edit](Project project) {
            Project changed = edit(project);
            m_edited = !sameProject(changed, project);
            return changed;
        },
        text);
}

void SweepView::takeValues() {
    if (sweep() && m_shown.chosen) {
        edit([from = sweep(), point = *m_shown.chosen](
                 Project project) { return withPoint(std::move(project), *from, point); },
             {"Edit", QT_TRANSLATE_NOOP("Edit", "Apply the values of a point of the sweep")});
    }
}

void SweepView::showPresent() {
    std::vector<std::optional<double>> values;
    for (std::size_t i = 0; sweep() && i < sweep()->inputs.size(); ++i) {
        const auto input = numberInput(good()->result.project, sweep()->inputs[i].axis.input);
        values.push_back(input ? input->value : std::nullopt);
    }
    if (m_shown.present != values) {
        m_shown.present = std::move(values);
        plot().remake();
    }
}

// --- showing ------------------------------------------------------------------------------------

/// Keeps the choice as long as the result exists.
void SweepView::fillEntries() {
    const QSignalBlocker blocker(m_entry);
    m_entry->clear();
    m_entries.clear();
    if (!sweep()) {
        return;
    }
    const SweepResult& result = *sweep();
    m_entries = sweepEntries(result, result.inputs.size() > 1);
    for (const SweepEntry& entry : m_entries) {
        const bool all = entry.quantities.size() > 1 && result.inputs.size() > 1;
        const QString text = SweepText::entry(result, entry);
        m_entry->addItem(all ? tr("%1, worst place").arg(text) : text);
    }
    const auto found = std::ranges::find(m_entries, m_wanted, &SweepEntry::key);
    m_entry->setCurrentIndex(
        found == m_entries.end() ? 0 : static_cast<int>(found - m_entries.begin()));
}

void SweepView::showSweep() {
    m_shown.result = sweep();
    const int points = sweep() ? static_cast<int>(sweep()->points.size()) : 0;
    if (m_shown.chosen && *m_shown.chosen >= static_cast<std::size_t>(points)) {
        m_shown.chosen.reset();
    }
    {
        const QSignalBlocker blocker(m_point);
        m_point->setRange(0, points);
        m_point->setValue(m_shown.chosen ? static_cast<int>(*m_shown.chosen) + 1 : 0);
        m_point->setSuffix(points > 0 ? tr(" of %1").arg(points) : QString());
    }
    fillEntries();
    showEntry();
    if (good()) {
        showPresent();
    }
    replotAll();
}

void SweepView::showEntry() {
    m_shown.entry = chosenEntry();
    m_shown.margins = m_side->currentIndex() == 1;
    m_map->setChart([this] { return SweepMap::chart(m_shown); });
    m_curves->setChart([this] { return SweepCurves::chart(m_shown); });
    showFront();
    showState();
}

void SweepView::showFront() {
    showPage(showsPhases() ? phasesPage : &plot() == m_map ? mapPage : curvesPage);
}

bool SweepView::drawn() const {
    return showsPhases() ? m_phaseBar->phases() != nullptr : sweep() && !m_entries.empty();
}

bool SweepView::faint() const {
    return showsPhases() ? m_phaseBar->phases() && (m_phaseBar->stale() || refused())
                         : sweep() && (stale() || refused());
}

const Project* SweepView::shownProject() const {
    if (showsPhases()) {
        return m_phaseBar->phases() ? &m_phaseBar->phases()->project : nullptr;
    }
    return sweep() ? &sweep()->project : nullptr;
}

void SweepView::showState() {
    PlotView::showState();
    const bool sweeps = good() && !showsPhases();
    const bool has = sweeps && good()->result.project.sweep;
    const bool accepted = latest() && latest()->ran();
    for (SweepAxisBox* box : m_axes) {
        box->setVisible(sweeps);
        box->setEnabled(accepted);
    }
    m_axes[1]->setVisible(has);
    m_add->setVisible(sweeps && !has);
    m_add->setEnabled(accepted);
    m_bar->setVisible(has);
    m_toolBar->setVisible(good() != nullptr);
    m_entry->setVisible(has);
    m_side->setVisible(has);
    m_phaseBar->setVisible(good() && showsPhases());
    m_phaseBar->showState(accepted);
    m_bar->showRunning(studies().sweep.running(), has && m_refused.empty() && !refused());
    m_bar->state()->setText(sweep() ? SweepText::run(*sweep()) : QString());
    m_take->setEnabled(drawn() && m_shown.chosen && accepted);
    m_takeButton->setEnabled(m_take->isEnabled());
    readOut();
    plot().setAccessibleDescription(m_bar->state()->text());
    m_phases->setAccessibleDescription(m_phaseBar->remark());
}

// --- texts --------------------------------------------------------------------------------------

QString SweepView::title() const {
    return tr("Sweep");
}

QString SweepView::hint() const {
    if (showsPhases()) {
        return tr("Point at a stock to read the steps, the time and the size of its cycle.");
    }
    return sweep() && m_shown.chosen
               ? SweepText::point(*sweep(), *m_shown.chosen, chosenEntry())
               : tr("Point at a place to read its values; a click chooses it.");
}

QString SweepView::keptText() const {
    if (showsPhases()) {
        return m_phaseBar->phases() ? tr(
                   "The inputs are refused; the stocks shown are those of the last valid inputs.")
                                    : refusedText();
    }
    return sweep() ? tr("The inputs are refused; the sweep is that of the last valid inputs.")
                   : refusedText();
}

QString SweepView::remark() const {
    if (showsPhases()) {
        return m_phaseBar->remark();
    }
    if (!good()->result.project.sweep) {
        return tr("What is the effect of a dull wheel, a soft tailstock, a longer dwell? Choose an "
                  "input above to see every result over its range: one input gives curves, two "
                  "give a map. Or start with the wheel's dullness.");
    }
    if (!m_refused.empty()) {
        return tr("The sweep cannot be run:") + QLatin1Char('\n') + Names::refusal(m_refused, 2);
    }
    if (sweep() && stale()) {
        return staleText(studies().sweep.running(), m_bar->run()->text());
    }
    if (sweep()) {
        return sweepRemark();
    }
    return studies().sweep.running() ? QString()
                                     : tr("This sweep takes a while: press “Run”. It can be "
                                          "stopped at any time and keeps the finished points.");
}

QString SweepView::sweepRemark() const {
    const SweepResult& result = *sweep();
    if (m_entries.empty()) {
        const auto refused =
            std::ranges::find(result.points, SweepStatus::refused, &SweepPoint::status);
        return refused == result.points.end()
                   ? tr("The cycle does not reach size at any point of the range.")
                   : tr("No point has a result. Refused:") + QLatin1Char('\n')
                         + Names::refusal(refused->issues, 2);
    }
    return changesNothing(result) ? tr("Nothing changes over this range: with the settings of this "
                                       "project, the model does not use this input.")
                                  : QString();
}

QStringList SweepView::subheading() const {
    return showsPhases() ? QStringList{m_subject->currentText()} + m_phaseBar->remark().split(u'\n')
                         : QStringList{m_entry->currentText(), m_bar->state()->text()};
}

void SweepView::nameParts() {
    nameAround(tr("Legend of the sweep"), tr("State of the sweep"),
               tr("Values under the mouse, or of the point chosen"));
    m_bar->state()->setAccessibleName(tr("Extent of the run"));
    m_bar->progress()->setAccessibleName(tr("Progress of the sweep"));
    m_curves->setAccessibleName(tr("Curves over the varied input"));
    m_map->setAccessibleName(tr("Map over the two varied inputs"));
    m_phases->setAccessibleName(tr("Size against stock"));
    tell(*m_subject, tr("Displayed content"),
         tr("Results over one or two inputs, or, exactly, the size over the stock of the blank"));
    tell(*m_entry, tr("Result shown"), tr("The result that is shown over the varied inputs"));
    tell(*m_side, tr("Values or margins"),
         tr("The values, or their distances from the limits: above 0 the requirement is met"));
    tell(*m_point, tr("Point chosen"),
         tr("The point whose values can be applied; a click in the plot chooses one, too"));
    fillChoice(*m_subject, {tr("Inputs varied"), tr("Size against stock")});
    fillChoice(*m_side, {tr("Values"), tr("Margins")});
    m_point->setPrefix(tr("point "));
    m_point->setSpecialValueText(tr("no point"));
    nameButtons();
    m_phaseBar->retranslate();
    for (SweepAxisBox* box : m_axes) {
        box->retranslate();
        box->show(good() ? good()->result.project : Project());
    }
    showSweep();
}

void SweepView::nameButtons() {
    tellButton(*m_bar->run(), tr("Run"),
               tr("Run the points of the sweep; a quick one runs by itself"));
    tellButton(*m_bar->stop(), tr("Stop"),
               tr("Stop the sweep; the completed points are kept and shown"));
    tellButton(*m_add, tr("Vary the dullness"),
               tr("A sweep of the wheel's dullness from half to twice its value; can be undone"));
    m_take->setText(tr("Apply these values"));
    tellButton(*m_takeButton, m_take->text(),
               tr("Use the inputs of the chosen point in this project; Undo restores the previous "
                  "inputs"));
}

} // namespace sparkout
