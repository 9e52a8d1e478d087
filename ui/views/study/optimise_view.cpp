// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/optimise_view.h"

#include "core/file/project_file.h"
#include "core/project/optimisation.h"
#include "core/setup/worn_project.h"
#include "core/study/search_edits.h"
#include "ui/chart/compare_plot.h"
#include "ui/chart/legend.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/tool_row.h"
#include "ui/session/part_runs.h"
#include "ui/text/names.h"
#include "ui/views/study/found_table.h"
#include "ui/views/study/margin_front_plot.h"
#include "ui/views/study/optimise_text.h"
#include "ui/views/study/state_grid_bar.h"
#include "ui/views/study/state_grid_plot.h"
#include "ui/views/study/state_grid_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <utility>

namespace sparkout {

namespace {
constexpr int curvesShare = 240, foundShare = 75; ///< initial shares of the height
/// The methods in the order of the box; the first is the default.
constexpr std::array methods{SearchMethod::pruned, SearchMethod::full, SearchMethod::published,
                             SearchMethod::labels};
} // namespace

OptimiseView::OptimiseView(QWidget* parent, Settings* settings, Studies* studies)
    : StudyView(QStringLiteral("optimise"), parent, settings, studies)
    , m_curves(new ComparePlot(this))
    , m_times(new StageCountPlot(this))
    , m_margins(new MarginFrontPlot(this))
    , m_grid(new StateGridPlot(this))
    , m_gridBar(new StateGridBar(this))
    , m_splitter(new QSplitter(Qt::Vertical, this))
    , m_answer(new ValueModel(this))
    , m_found(new ValueModel(this))
    , m_zone(new QComboBox(this))
    , m_bar(new RunBar(QStringLiteral("optimise"), this))
    , m_take(new QPushButton(this))
    , m_add(new QPushButton(this))
    , m_method(new QComboBox(this))
    , m_phases(new QCheckBox(this))
    , m_refine(new QCheckBox(this))
    , m_trials(new RunController(this)) {
    for (ViewPlot* plot : std::initializer_list<ViewPlot*>{m_curves, m_times, m_margins, m_grid}) {
        plot->setMinimumSize(240, 120);
        addPage(*plot);
    }
    m_bar->takeTurns();
    m_bar->layOut({m_method, m_phases, m_refine}, {m_take});
    share(*m_splitter, {{pages(), curvesShare}, {buildTable(), foundShare}});
    QVBoxLayout* const column =
        addColumn({m_bar, m_gridBar, buildAnswer(), notice(), m_add,
                   m_choice = pageTools<ToolRow>({m_zone}), legend(), m_splitter, values()},
                  m_splitter);
    column->setAlignment(m_add, Qt::AlignLeft);
    column->addStretch(0);
    nameObjects({{m_curves, "optimiseCurves"},
                 {m_times, "optimiseTimes"},
                 {m_margins, "optimiseMargins"},
                 {m_grid, "optimiseGrid"},
                 {m_zone, "optimiseZone"},
                 {m_take, "optimiseTake"},
                 {m_add, "optimiseAdd"},
                 {m_method, "optimiseMethod"},
                 {m_phases, "optimisePhases"},
                 {m_refine, "optimiseRefine"},
                 {m_answerTable, "optimiseAnswer"},
                 {m_table, "optimiseFound"}});
    m_table->setArrangeable(settings);
    connectParts();
    built();
    chooseContent();
}

CopyTable* OptimiseView::buildTable() {
    m_table = addTable(*m_found);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setUniformRows();
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    return m_table;
}

/// Makes a table as high as its rows, with a wrapped last column, or scrolled: see limitAnswer().
CopyTable* OptimiseView::buildAnswer() {
    m_answerTable = addTable(*m_answer);
    m_answerTable->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    m_answerTable->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);
    m_answerTable->verticalHeader()->hide();
    QHeaderView* const header = m_answerTable->horizontalHeader();
    header->setStretchLastSection(false); // stretching would not make the last section narrower
    // Queued until all columns have their widths.
    connect(
        header, &QHeaderView::sectionResized, m_answerTable,
        [this] { m_answerTable->resizeRowsToContents(); }, Qt::QueuedConnection);
    return m_answerTable;
}

void OptimiseView::limitAnswer() {
    const int spare = height() - layout()->totalMinimumHeightForWidth(width());
    const int wanted = m_curves->minimumSizeHint().height() - pages()->minimumSizeHint().height();
    m_answerTable->setMaximumHeight(m_answerTable->minimumSizeHint().height()
                                    + std::max(0, spare - std::max(0, wanted)));
}

bool OptimiseView::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) {
        limitAnswer();
    }
    return StudyView::event(event);
}

void OptimiseView::connectParts() {
    connect(content(), &QComboBox::currentIndexChanged, this, &OptimiseView::chooseContent);
    connect(m_zone, &QComboBox::currentIndexChanged, this, &OptimiseView::chooseZone);
    connect(m_bar->run(), &QPushButton::clicked, this, &OptimiseView::runSearch);
    connect(m_method, &QComboBox::currentIndexChanged, this, &OptimiseView::showState);
    connect(m_phases, &QCheckBox::toggled, this, &OptimiseView::showState);
    connect(m_bar->stop(), &QPushButton::clicked, &studies().search.job(), &Job::stop);
    connect(m_take, &QPushButton::clicked, this, &OptimiseView::takeCycle);
    connect(m_table, &CopyTable::rowEntered, this, &OptimiseView::takeCycle);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &OptimiseView::tryCycle);
    connect(m_add, &QPushButton::clicked, this, [this] {
        // The view shows the last accepted inputs; the current ones may have a grid.
        emit editWanted(
            [](Project project) {
                return project.optimisation ? project : usualSearch(std::move(project));
            },
            {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a search")});
    });
    connect(&studies().search.job(), &Job::progressed, this, [this] {
        SearchState state = studies().search.state();
        state.took_s = studies().search.job().took_s();
        const double share = state.best_s ? std::clamp(state.bound_s / *state.best_s, 0.0, 1.0) : 0;
        m_bar->showProgress(std::max(share, state.share), OptimiseText::state(state));
        m_bar->progress()->setToolTip(m_bar->progress()->format());
    });
    connect(&studies().search.job(), &Job::answered, this, &OptimiseView::takeSearch);
    connect(m_trials, &RunController::finished, this, &OptimiseView::takeTrial);
    connect(m_gridBar, &StateGridBar::changed, this, &OptimiseView::takeGrid);
    connect(m_gridBar, &StateGridBar::moved, this, &OptimiseView::moveGrid);
    connect(m_margins, &MarginFrontPlot::cycleClicked, this, [this](std::size_t row) {
        chooseRow(row);
        m_table->setFocus(); // its keys continue from there
    });
    connect(m_margins, &MarginFrontPlot::cyclePointed, this, &OptimiseView::chooseRow);
    connect(m_margins, &MarginFrontPlot::cycleEntered, this, &OptimiseView::takeCycle);
    connect(m_grid, &StateGridPlot::stateClicked, this, [this](int level, std::size_t feed) {
        m_gridBar->setMoment(momentOf(m_grid->outcome()->grid, level, feed));
    });
}

const FoundCycle* OptimiseView::chosen() const {
    const int row = m_found->rowAt(m_table->currentIndex().row());
    return row >= 0 ? &m_listed->found[static_cast<std::size_t>(row)] : nullptr;
}

ValueTable OptimiseView::tableOfFound() const {
    return m_listed ? foundTable(*m_listed, before_s()) : ValueTable();
}

void OptimiseView::listFound() {
    m_listed = search();
    m_found->setTable(tableOfFound());
}

void OptimiseView::listAnswer() {
    m_answer->update(m_listed ? answerTable(*m_listed, before_s(), beforeMargin()) : ValueTable());
    QHeaderView* const header = m_answerTable->horizontalHeader();
    for (int column = 0; column < header->count(); ++column) {
        const bool isLast = column + 1 == header->count();
        header->setSectionResizeMode(column,
                                     isLast ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
    }
}

std::optional<double> OptimiseView::before_s() const {
    return m_before && m_before->result.status == RunStatus::completed
               ? std::optional(m_before->result.time_s)
               : std::nullopt;
}

/// Whether the current cycle is one of the found ones.
bool OptimiseView::isTaken() const {
    return !stale() && std::ranges::any_of(search()->found, [&](const FoundCycle& found) {
        const Project& present = good()->result.project;
        return sameProject(withFound(present, found), present);
    });
}

// --- searching ----------------------------------------------------------------------------------

void OptimiseView::takeOutcome(const OutcomePtr& before) {
    if (good() == before) {
        return;
    }
    if (hasOtherPlaces(before)) { // the gauge's zone, or the middle section
        m_wanted = good()->result.sections.size() / 2;
        fillZones();
    }
    studies().search.follow(&good()->result.project);
    m_goesOn = m_goesOn && studies().search.isAnswered();
    const bool mayCompare =
        m_own && isTaken() && sameSearch(m_own->result.project, good()->result.project);
    m_before = mayCompare ? m_own : good();
    m_found->update(tableOfFound());
    showBefore();
    fillCurves(); // drawn together with the rest
    followGrid();
}

void OptimiseView::dropOutcome() {
    m_before.reset();
    studies().search.follow(nullptr);
    fillZones();
    fillCurves();
}

bool OptimiseView::busy() const {
    return studies().search.running() || m_gridBar->busy();
}

bool OptimiseView::stale() const {
    return studies().search.stale()
           || (search()->wear && m_document
               && !sameWear(SurfaceWear(m_document->setup(), m_document->surface()),
                            *search()->wear));
}

SearchWish OptimiseView::wish() const {
    const int method = std::max(m_method->currentIndex(), 0);
    return {.method = methods[static_cast<std::size_t>(method)],
            .phases = m_phases->isChecked() && m_phases->isEnabled(),
            .refine = m_refine->isChecked() && m_refine->isEnabled(),
            .front = true};
}

SearchTicks OptimiseView::ticks() const {
    return {.phases = m_phases->isChecked(), .refine = m_refine->isChecked()};
}

void OptimiseView::runSearch() {
    if (!good()) {
        return;
    }
    m_bar->showProgress(0, OptimiseText::state({}));
    SearchWish asked = wish();
    if (m_document) {
        asked.wear = searchWear(m_document->setup(), m_document->surface());
    }
    m_goesOn = false;
    studies().search.start(good()->result.project, asked);
    showState();
}

/// An answer can be chosen and applied during the search for the margins by time.
void OptimiseView::takeSearch() {
    if (m_goesOn) {
        addToAnswer();
    } else {
        showSearch();
    }
    m_goesOn = studies().search.isAnswered();
    if (!studies().search.running()) {
        emit ended();
    }
}

/// Keeps the chosen cycle, and the one that a taken cycle replaced.
void OptimiseView::addToAnswer() {
    const FoundCycle* const was = chosen();
    const std::optional<FoundCycle> kept = was ? std::optional(*was) : std::nullopt;
    {
        const QSignalBlocker blocker(m_table->selectionModel());
        listFound();
        const auto row = std::ranges::find_if(search()->found, [&](const FoundCycle& each) {
            return kept && each.machine == kept->machine
                   && sameProject(withFound(search()->project, each),
                                  withFound(search()->project, *kept));
        });
        chooseRow(row == search()->found.end()
                      ? 0
                      : static_cast<std::size_t>(row - search()->found.begin()));
    }
    showBefore();
    for (const ViewPlot* plot : plots()) {
        plot->tools()->navigation().forgetViews();
    }
    tryCycle();
    showCurves();
}

void OptimiseView::dropStudies() {
    studies().search.forget();
    m_gridBar->forget();
    showSearch();
}

void OptimiseView::showSearch() {
    m_own.reset();
    m_before = good();
    listFound();
    showBefore();
    m_trial.reset();
    if (search() && search()->best()) {
        chooseRow(0);
    }
    for (const ViewPlot* plot : plots()) {
        plot->tools()->navigation().forgetViews();
    }
    tryCycle();
    showCurves();
}

std::optional<double> OptimiseView::beforeMargin() const {
    return before_s() && !m_before->constraints.empty()
               ? std::optional(std::ranges::min_element(m_before->constraints, {},
                                                        &ConstraintResult::relativeMargin)
                                   ->relativeMargin)
               : std::nullopt;
}

void OptimiseView::showBefore() {
    std::optional<TimedMargin> yours;
    if (const std::optional<double> margin = beforeMargin()) {
        yours = {*before_s(), *margin};
    }
    listAnswer();
    m_times->setSearch(search(), before_s());
    m_margins->setSearch(search(), yours);
    m_margins->setChosen(chosen());
}

void OptimiseView::chooseRow(std::size_t row) {
    const int line = m_found->lineOf(static_cast<int>(row));
    m_table->selectRow(line);
    m_table->scrollTo(m_found->index(line, 0));
}

void OptimiseView::tryCycle() {
    if (const FoundCycle* cycle = chosen()) {
        m_trials->request(withFound(search()->project, *cycle));
    }
    m_margins->setChosen(chosen());
    m_margins->replot(QCustomPlot::rpQueuedReplot);
    showState();
}

void OptimiseView::takeTrial(const OutcomePtr& outcome) {
    m_trial = chosen() && outcome->ran() ? outcome : nullptr; // the search may be dropped
    showCurves();
}

void OptimiseView::takeCycle() {
    const FoundCycle* cycle = chosen();
    if (!cycle || stale()) {
        return;
    }
    if (!isTaken()) {
        m_own = good();
    }
    const auto take = [searched = search()->project, found = *cycle](Project project) {
        // Unchanged if the search has been edited meanwhile.
        return sameSearch(searched, project) ? withFound(std::move(project), found) : project;
    };
    emit editWanted(take, {"Edit", QT_TRANSLATE_NOOP("Edit", "Apply the cycle found")});
}

// --- showing ------------------------------------------------------------------------------------

bool OptimiseView::showsGrid() const {
    return &front() == m_grid;
}

/// Updates the grid only while it is shown.
void OptimiseView::followGrid() {
    if (showsGrid() && good()) {
        m_gridBar->follow(good()->result.project);
    }
}

void OptimiseView::takeGrid() {
    if (m_grid->outcome() != m_gridBar->outcome()) {
        m_grid->setGrid(m_gridBar->outcome());
        m_grid->setMoment(m_gridBar->moment());
    }
    showState();
    replotFront();
}

void OptimiseView::moveGrid(int moment) {
    m_grid->setMoment(moment);
    readOut();
    m_grid->replot(QCustomPlot::rpQueuedReplot);
}

void OptimiseView::chooseContent() {
    showPage(static_cast<std::size_t>(content()->currentIndex()));
    followGrid();
    m_zone->setVisible(&front() == m_curves);
    showState();
    replotFront();
}

void OptimiseView::chooseZone() {
    m_wanted = static_cast<std::size_t>(std::max(m_zone->currentIndex(), 0));
    showCurves();
}

void OptimiseView::fillZones() {
    const QSignalBlocker blocker(m_zone);
    m_zone->clear();
    if (good()) {
        for (const SectionResult& section : good()->result.sections) {
            const auto number = static_cast<int>(&section - good()->result.sections.data());
            m_zone->addItem(Names::zoneFull(section.zone, number));
        }
        m_zone->setCurrentIndex(static_cast<int>(m_wanted));
    }
}

void OptimiseView::fillCurves() {
    std::vector<ComparedFeeds> runs;
    if (m_before && m_wanted < m_before->feeds.columns.size()) {
        runs.push_back({tr("Your cycle"), {m_before, &m_before->feeds}, m_wanted});
        if (m_trial && m_wanted < m_trial->feeds.columns.size()) {
            runs.push_back({tr("Cycle found"), {m_trial, &m_trial->feeds}, m_wanted, 1});
        }
    }
    m_curves->setRuns(std::move(runs));
}

void OptimiseView::showCurves() {
    fillCurves();
    showState();
    replotAll();
}

bool OptimiseView::isGiven() const {
    return good() && good()->result.project.optimisation;
}

bool OptimiseView::isFound() const {
    return search() && search()->best();
}

bool OptimiseView::hasCurves() const {
    return showsGrid()             ? m_grid->outcome() != nullptr
           : &front() == m_times   ? isFound()
           : &front() == m_margins ? m_margins->hasFront()
                                   : !m_curves->runs().empty();
}

bool OptimiseView::drawn() const {
    if (showsGrid()) {
        return m_grid->outcome() != nullptr;
    }
    return hasCurves() && (isGiven() || isFound());
}

/// The earlier result is faint while another search runs and after an edit.
bool OptimiseView::faint() const {
    return showsGrid() ? m_gridBar->stale() || refused()
                       : stale() || (studies().search.running() && !studies().search.isAnswered());
}

bool OptimiseView::isFaint(const ViewPlot& plot) const {
    return faint() && (&plot != m_curves || m_trial);
}

void OptimiseView::showState() {
    const bool searching = studies().search.running(), grid = showsGrid();
    for (QWidget* part : std::initializer_list<QWidget*>{m_method, m_phases, m_refine}) {
        part->setVisible(!searching); // the progress needs their space
        part->setEnabled(isGiven());
    }
    const bool betweenDressings =
        isGiven() && objectiveOf(good()->result.project) != SearchObjective::time;
    if (isGiven() && (betweenDressings || good()->result.project.optimisation->margin_within_min)) {
        m_refine->setEnabled(false); // a refinement supports only the least time
    }
    m_phases->setEnabled(isGiven() && !betweenDressings);
    nameRun(); // the notice refers to the button
    PlotView::showState();
    tools()->setEnabled(hasCurves());
    m_add->setVisible(good() && !isGiven());
    m_choice->setVisible(isGiven() || isFound()); // otherwise there is no choice
    m_bar->setVisible(!grid);
    m_gridBar->setVisible(grid && isGiven());
    m_gridBar->showState(!refused());
    m_bar->showRunning(searching, isGiven() && !refused());
    m_bar->state()->setText(isGiven() && !searching
                                ? OptimiseText::gridSize(sparkout::gridSize(good()->result.project))
                                : QString());
    m_answer->setGreyed(faint());
    for (QWidget* table : {m_answerTable, m_table}) {
        table->setVisible(isFound() && !grid);
    }
    m_take->setEnabled(chosen() && !stale() && (!searching || studies().search.isAnswered()));
    readOut();
}

// --- texts --------------------------------------------------------------------------------------

QString OptimiseView::title() const {
    return tr("Optimise");
}

QString OptimiseView::hint() const {
    if (showsGrid()) {
        return m_grid->outcome() ? StateGridText::moment(
                   m_grid->outcome()->grid, momentAt(m_grid->outcome()->grid, m_grid->moment()))
                                 : QString();
    }
    if (&front() == m_margins) {
        return !isFound()              ? QString()
               : m_margins->hasFront() ? tr("A click or the arrow keys choose a cycle, “Apply this "
                                            "cycle” or Enter applies it.")
                                             + u' ' + OptimiseText::front(*search())
                                       : OptimiseText::front(*search());
    }
    return &front() == m_curves
               ? tr("Point at a curve to read its values beside those of your cycle.")
               : tr("Point at a number of stages to read its time.");
}

QString OptimiseView::keptText() const {
    if (showsGrid()) {
        return m_grid->outcome()
                   ? tr("The inputs are refused; the grid is that of the last valid inputs.")
                   : refusedText();
    }
    return search() ? tr("The inputs are refused; the search is that of the last valid inputs.")
                    : refusedText();
}

QString OptimiseView::remark() const {
    if (!isGiven()) {
        return tr("This project defines no search. A search tries every listed feed and stock of "
                  "the stages and finds the quickest cycle that meets every requirement. Choose "
                  "them on the page Search of the inputs, or start with typical ones.");
    }
    if (showsGrid()) {
        return m_gridBar->remark();
    }
    const SearchOutcomePtr& refusal = studies().search.refusal();
    if (refusal && refusal->method == wish().method) {
        return OptimiseText::fault(*refusal);
    }
    if (!search()) {
        return studies().search.running() ? QString()
               : objectiveOf(good()->result.project) != SearchObjective::time
                   ? OptimiseText::offer(objectiveOf(good()->result.project))
               : good()->result.project.optimisation->margin_within_min
                   ? tr("“Search” finds the cycle of the grid farthest from its limits within the "
                        "time given. It can be stopped at any time and keeps the best so far.")
                   : tr("“Search” finds the quickest cycle of the grid that meets every "
                        "requirement. It can be stopped at any time and keeps the best so far.");
    }
    if (stale()) {
        return staleText(studies().search.running(), m_bar->run()->text());
    }
    return OptimiseText::notes(*search());
}

const Project* OptimiseView::shownProject() const {
    if (showsGrid()) {
        return m_grid->outcome() ? &m_grid->outcome()->project : nullptr;
    }
    return PlotView::shownProject();
}

QStringList OptimiseView::subheading() const {
    if (showsGrid()) {
        return QStringList{OptimiseText::method(SearchMethod::published)}
               + m_gridBar->remark().split(u'\n');
    }
    return &front() == m_curves ? QStringList(m_zone->currentText()) : QStringList();
}

void OptimiseView::nameParts() {
    nameAround(tr("Legend of the search"), tr("Result of the search"),
               tr("Values under the mouse"));
    m_curves->setAccessibleName(tr("Feeds and radii of your cycle and of the one found"));
    m_times->setAccessibleName(tr("Machining time over the number of stages"));
    m_margins->setAccessibleName(
        tr("Maximum margin over the machining time; the table below lists its cycles"));
    m_grid->setAccessibleName(tr("Grid of dynamic programming"));
    m_bar->state()->setAccessibleName(tr("Size of the grid"));
    m_bar->progress()->setAccessibleName(tr("Progress of the search"));
    m_answerTable->setAccessibleName(tr("The answer and the compared cycles"));
    m_table->setAccessibleName(tr("The best cycles found"));
    fillChoice(*content(), {tr("Before and after"), tr("Time by stages"), tr("Margin by time"),
                            OptimiseText::method(SearchMethod::published)});
    QStringList names;
    std::ranges::transform(methods, std::back_inserter(names), &OptimiseText::method);
    fillChoice(*m_method, names);
    tell(*content(), tr("Displayed results of the search"));
    tell(*m_zone, tr("Zone or section of the curves"));
    nameButtons();
    m_gridBar->retranslate();
    listAnswer();
    m_answerTable->retranslate();
    m_found->update(tableOfFound());
    m_table->retranslate();
    fillZones();
    showCurves();
}

void OptimiseView::nameRun() {
    const SearchMethod method = wish().method;
    tell(*m_method, tr("Method of the search"), OptimiseText::methodHint(method));
    if (good() && studies().search.isContinued(good()->result.project, wish())) {
        tellButton(*m_bar->run(), tr("Continue"),
                   tr("Continue the search from where it was stopped; the answer is the same as "
                      "without the stop"));
    } else {
        tellButton(*m_bar->run(), tr("Search"),
                   tr("Find the quickest cycle of the grid that meets every requirement"));
    }
}

void OptimiseView::nameButtons() {
    tellButton(*m_bar->stop(), tr("Stop"),
               tr("Stop the search; the best so far is kept and shown"));
    tellButton(*m_take, tr("Apply this cycle"),
               tr("Replaces the current cycle with the chosen one; undo restores yours"));
    tellButton(*m_phases, tr("For every stock"),
               tr("The cycle must also be fit for stocks spread over one feed step of every stage: "
                  "the size depends on the position of the last step"));
    tellButton(
        *m_refine, tr("Between levels"),
        tr("Continue from the quickest cycle between the levels of the grid, in the machine's "
           "steps: every cycle is run in full, but the result is not proved to be the quickest"));
    tellButton(*m_add, tr("Add a typical search"),
               tr("Levels of each feed about the current cycle in steps of the machine, stocks, "
                  "spark-out, and the usual minimum overlap and steps of a stage where none are "
                  "given; the answer is fit for the batch, or without one for every stock; can be "
                  "undone and changed on the pages Search and Cycle"));
}

} // namespace sparkout
