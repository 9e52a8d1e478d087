// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/part_window.h"

#include "core/project/part.h"
#include "core/quality/requirement.h"
#include "core/quality/verdict.h"
#include "core/study/run_comparison.h"
#include "core/study/search_edits.h"
#include "core/units.h"
#include "ui/chart/bar_chart.h"
#include "ui/chart/bar_plot.h"
#include "ui/chart/legend.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/results/verdict_table.h"
#include "ui/session/document.h"
#include "ui/session/part_runs.h"
#include "ui/session/surface_edits.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/part_drawing.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <QWidget>

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace sparkout {

namespace {

struct SurfaceTable {
    Q_DECLARE_TR_FUNCTIONS(SurfaceTable)
};

/// With its own unit; in the common one for a spreadsheet.
ValueCell cycleTimeCell(const std::optional<double>& time_s, const TimeUnit& unit) {
    constexpr int digits = 4;
    return ValueCell::of(time_s ? std::optional(unit.of(*time_s)) : std::nullopt,
                         [&time_s](double) { return Names::time(*time_s, digits); });
}

/// The cycle that a search found; null without one.
const FoundCycle* foundBy(const SurfaceStudy& study) {
    return study.search && study.search->ran() ? study.search->answer() : nullptr;
}

ValueCell searchCell(const PartStudies& studies, int id, const TimeUnit& unit) {
    const auto found = studies.searches.find(id);
    if (found == studies.searches.end()) {
        return {};
    }
    const SurfaceStudy& study = *found->second;
    if (!study.search || !study.search->ran()) {
        return {.text = SurfaceTable::tr("refused")};
    }
    const FoundCycle* const answer = foundBy(study);
    return answer ? cycleTimeCell(answer->time_s, unit)
                  : ValueCell{.text = SurfaceTable::tr("none feasible")};
}

QString rejectedText(std::int64_t bad, std::int64_t parts) {
    return SurfaceTable::tr("%1 of %2 rejected").arg(bad).arg(parts);
}

/// The batch of all surfaces, otherwise that of the verdict.
ValueCell batchCell(const PartStudies& studies, int id, const std::optional<JudgedBatch>& judged) {
    const auto found = studies.batches.find(id);
    if (found == studies.batches.end()) {
        return judged ? ValueCell{.text = rejectedText(judged->bad, judged->parts)} : ValueCell{};
    }
    const SurfaceStudy& study = *found->second;
    if (!study.isSetUp) {
        return {.text = SurfaceTable::tr("not set up")};
    }
    if (!study.issues.empty() || !study.batch || !study.batch->ran()) {
        return {.text = SurfaceTable::tr("refused")};
    }
    const BatchSummary& summary = study.batch->summary;
    return {.text = rejectedText(summary.bad.count, summary.parts)};
}

QString nameOf(const SetupState& state, std::size_t surface) {
    return QStringLiteral("%1. %2")
        .arg(surface + 1)
        .arg(printableText(SurfaceEdits::nameOf(state, surface)));
}

std::optional<double> timeOf(const SurfaceStatus& status) {
    return status.ran() ? std::optional(status.time_s) : std::nullopt;
}

/// The unit of the times of all surfaces, and of the cycles found for them.
TimeUnit commonUnit(const std::vector<SurfaceStatus>& statuses, const PartStudies& studies) {
    double longest_s = 0;
    for (const SurfaceStatus& status : statuses) {
        longest_s = std::max(longest_s, timeOf(status).value_or(0));
    }
    for (const auto& [id, study] : studies.searches) {
        const FoundCycle* const answer = foundBy(*study);
        longest_s = std::max(longest_s, answer ? answer->time_s : 0);
    }
    return TimeUnit(longest_s);
}

QIcon iconOf(const SurfaceStatus& status) {
    return QIcon(statusPixmap(status, metrics::iconSmall, qGuiApp->devicePixelRatio()));
}

QString requirementName(const std::vector<SurfaceStatus>& statuses, ConstraintKind kind) {
    const char* const unit = requirementOf(kind).unit;
    const bool isEstimate = kind == ConstraintKind::roughness
                            && std::ranges::any_of(statuses, &SurfaceStatus::isRoughnessEstimate);
    const QString name = isEstimate ? SurfaceTable::tr("Ra, estimate") : Names::constraint(kind);
    return *unit ? SurfaceTable::tr("%1, %2").arg(name, unitText(unit)) : name;
}

/// "12.3 / 25" beside its light; undecided values look different from those known to be met.
ValueCell requirementCell(const SurfaceStatus& status, ConstraintKind kind) {
    const auto found = std::ranges::find(status.requirements, kind, &ConstraintResult::kind);
    if (found == status.requirements.end()) {
        return {.text = QStringLiteral("–"), .value = QString()};
    }
    return {.text = QStringLiteral("%1 / %2").arg(Names::value(*found), Names::limit(*found)),
            .icon = QIcon(lightPixmap(lightOf(*found), metrics::iconSmall,
                                      qGuiApp->devicePixelRatio(), false))};
}

} // namespace

void PartStudies::add(int id, const SurfaceStudyPtr& study) {
    (study->kind == SurfaceStudy::Kind::search ? searches : batches)[id] = study;
}

ValueTable partTable(const SetupState& state, const std::vector<SurfaceStatus>& statuses,
                     const PartStudies& studies) {
    const TimeUnit unit = commonUnit(statuses, studies);
    ValueTable table{
        .columns = {{.text = SurfaceTable::tr("Surface"), .key = "surface", .isText = true},
                    {.text = SurfaceTable::tr("⌀, mm"), .key = "diameter"},
                    {.text = SurfaceTable::tr("Cycle"),
                     .name = unit.titled(SurfaceTable::tr("Cycle")),
                     .key = "time"},
                    {.text = SurfaceTable::tr("Verdict"), .key = "verdict", .isText = true},
                    {.text = SurfaceTable::tr("Minimum margin"), .key = "margin", .isText = true},
                    {.text = SurfaceTable::tr("Found"),
                     .name = unit.titled(SurfaceTable::tr("Found")),
                     .key = "search"},
                    {.text = SurfaceTable::tr("Batch"), .key = "batch"}},
        .isList = true};
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        const SurfaceState& of = *state.surfaces[i];
        const SurfaceStatus& status = statuses[i];
        const double diameter_mm = of.project.part->diameter_mm;
        table.addRow({.text = nameOf(state, i)},
                     {{.text = nameOf(state, i)},
                      {.text = printedNumber(diameter_mm), .value = diameter_mm},
                      cycleTimeCell(timeOf(status), unit),
                      {.text = statusText(status), .icon = iconOf(status)},
                      {.text = worstText(status)},
                      searchCell(studies, of.id, unit),
                      batchCell(studies, of.id, status.judgement.batch)});
    }
    return table;
}

ValueTable surfaceComparison(const SetupState& state, const std::vector<SurfaceStatus>& statuses) {
    ValueTable table{.columns = {{.text = SurfaceTable::tr("Value / limit"), .isText = true}},
                     .isList = true};
    std::set<ConstraintKind> kinds;
    const TimeUnit unit = commonUnit(statuses, {});
    std::vector<ValueCell> times{{.text = SurfaceTable::tr("Cycle time"),
                                  .value = unit.titled(SurfaceTable::tr("Cycle time"))}};
    for (std::size_t i = 0; i < statuses.size(); ++i) {
        table.columns.push_back({.text = nameOf(state, i), .isText = true}); // beside the lights
        times.push_back(cycleTimeCell(timeOf(statuses[i]), unit));
        for (const ConstraintResult& requirement : statuses[i].requirements) {
            kinds.insert(requirement.kind);
        }
    }
    table.addRow({.text = times.front().text}, times);
    for (const ConstraintKind kind : kinds) {
        std::vector<ValueCell> cells{{.text = requirementName(statuses, kind)}};
        for (const SurfaceStatus& status : statuses) {
            cells.push_back(requirementCell(status, kind));
        }
        table.addRow({.text = cells.front().text}, cells);
    }
    return table;
}

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr int barDigits = 3;
constexpr EditText takeFoundText{"Edit", QT_TRANSLATE_NOOP("Edit", "Apply the cycles found")};

} // namespace

/// The surfaces of a part side by side: the time of each cycle and its least margin, as bars. A bar
/// leads to its surface.
class SurfaceBars : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(sparkout::SurfaceBars)
public:
    /// `wanted` is called with the surface of a bar that was chosen.
    SurfaceBars(std::function<void(std::size_t)> wanted, QWidget* parent);

    void setPart(const SetupState& state, const std::vector<SurfaceStatus>& statuses);
    void retranslate(); ///< only the names; setPart() follows

    [[nodiscard]] static BarChart chartOf(const SetupState& state,
                                          const std::vector<SurfaceStatus>& statuses);

private:
    void showLegend();

    LegendStrip* m_legend;
    BarPlot* m_plot;
};

SurfaceBars::SurfaceBars(std::function<void(std::size_t)> wanted, QWidget* parent)
    : QWidget(parent), m_legend(new LegendStrip(this)), m_plot(new BarPlot(this)) {
    m_plot->setObjectName(QStringLiteral("surfaceBars"));
    m_plot->setLeads(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    column->addWidget(m_legend);
    column->addWidget(m_plot);
    connect(m_plot, &ViewPlot::contentChanged, this, &SurfaceBars::showLegend);
    connect(m_plot, &BarPlot::entered, this,
            [wanted = std::move(wanted)](std::size_t, std::size_t surface) { wanted(surface); });
    connect(m_legend, &LegendStrip::toggled, m_plot, &BarPlot::toggleCurve);
    connect(m_legend, &LegendStrip::onlyAsked, m_plot, &BarPlot::showOnly);
}

BarChart SurfaceBars::chartOf(const SetupState& state, const std::vector<SurfaceStatus>& statuses) {
    BarChart chart;
    chart.shape = BarChart::Shape::grouped;
    chart.what = tr("Surface");
    chart.axis = tr("Cycle time");
    chart.secondAxis = tr("Margin");
    chart.secondUnit = QStringLiteral("%");
    chart.number = [](double value) { return Names::significant(value, barDigits); };
    chart.secondNumber = [](double value) {
        return Names::fixed(value, std::abs(value) < 10 ? 1 : 0);
    };
    chart.series = {{tr("cycle time"), barColour(style::Drawn::yourCycle), hatchAt(0), {}},
                    {tr("minimum margin"),
                     barColour(style::Drawn::everyRequirementHolds),
                     hatchAt(1),
                     {},
                     true}};
    for (std::size_t i = 0; i < statuses.size(); ++i) {
        const SurfaceStatus& status = statuses[i];
        chart.categories << printableText(SurfaceEdits::nameOf(state, i));
        chart.series[0].values.push_back(status.ran() ? status.time_s : noNumber);
        const auto least = leastMargin(status.requirements);
        chart.series[1].values.push_back(least ? 100 * least->relativeMargin : noNumber);
    }
    chart.fitTimeUnit();
    chart.remark =
        tr("Margin of the decided requirement nearest to its limit; below 0 if one is not met.");
    return chart;
}

void SurfaceBars::setPart(const SetupState& state, const std::vector<SurfaceStatus>& statuses) {
    m_plot->setChart(chartOf(state, statuses));
    m_plot->setAccessibleDescription(m_plot->chart().description());
    m_plot->setMinimumHeight(BarDrawing::leastHeight(m_plot->chart(), m_plot->font()));
    m_plot->setToolTip(m_plot->chart().remark);
    showLegend();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void SurfaceBars::showLegend() {
    m_legend->setEntries(m_plot->legendEntries());
}

void SurfaceBars::retranslate() {
    m_plot->setAccessibleName(tr("The surfaces compared, as bars"));
}

PartWindow::PartWindow(Document& document, const PartRuns& runs, std::function<SearchTicks()> ticks,
                       QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_runs(runs)
    , m_ticks(std::move(ticks))
    , m_head(new QLabel(this))
    , m_times(new QLabel(this))
    , m_state(new QLabel(this))
    , m_model(new ValueModel(this))
    , m_compared(new ValueModel(this))
    , m_table(new CopyTable(*m_model, this))
    , m_comparison(new CopyTable(*m_compared, this))
    , m_bars(new SurfaceBars([this](std::size_t surface) { emit surfaceWanted(surface); }, this))
    , m_search(new QPushButton(this))
    , m_batch(new QPushButton(this))
    , m_take(new QPushButton(this))
    , m_stop(new QPushButton(this))
    , m_progress(new QProgressBar(this)) {
    setObjectName(QStringLiteral("partWindow"));
    setHelpTopic(*this, QStringLiteral("surfaces#whole"));
    build();
    connect(m_table, &CopyTable::rowChosen, this,
            [this](int row) { emit surfaceWanted(static_cast<std::size_t>(row)); });
    connect(m_search, &QPushButton::clicked, this, &PartWindow::startSearches);
    connect(m_batch, &QPushButton::clicked, this, &PartWindow::startBatches);
    connect(m_take, &QPushButton::clicked, this, &PartWindow::takeOver);
    connect(m_stop, &QPushButton::clicked, this, [this] { m_study.stop(); });
    connect(&m_study, &PartStudy::progressed, this, [this](qint64 done, qint64 parts, double) {
        m_progress->setMaximum(static_cast<int>(std::min<qint64>(parts, INT_MAX)));
        m_progress->setValue(static_cast<int>(std::min<qint64>(done, INT_MAX)));
    });
    connect(&m_study, &PartStudy::surfaceDone, this, [this](const SurfaceStudyPtr& study) {
        m_studies.add(m_of[study->surface]->id, study);
        showTables();
        if (study->search && study->search->ran() && study->search->answer()) {
            m_found.push_back(study);
        }
    });
    connect(&m_study, &PartStudy::finished, this, [this](bool stopped) {
        m_stopped = stopped;
        showStudies();
    });
    connect(&runs, &PartRuns::changed, this, &PartWindow::follow);
    connect(&document, &Document::changed, this, &PartWindow::showStudies);
    connect(&document, &Document::replaced, this, [this] {
        m_study.drop();
        m_found.clear();
        m_of.clear();
        m_studies = {};
        showTables();
    });
    retranslate();
}

void PartWindow::build() {
    setRelativeFont(*m_head, 1.2, true);
    m_head->setTextFormat(Qt::PlainText);
    m_head->setWordWrap(true);
    m_times->setObjectName(QStringLiteral("pieceTime"));
    m_times->setTextFormat(Qt::RichText);
    m_times->setWordWrap(true);
    m_state->setObjectName(QStringLiteral("studyState"));
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("partTable"));
    m_comparison->setObjectName(QStringLiteral("surfaceComparison"));
    for (CopyTable* table : {m_table, m_comparison}) {
        table->setWordWrap(false);
        table->verticalHeader()->hide();
        table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
        table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
        table->horizontalHeader()->setStretchLastSection(false);
    }
    m_search->setObjectName(QStringLiteral("searchAll"));
    m_batch->setObjectName(QStringLiteral("batchAll"));
    m_take->setObjectName(QStringLiteral("takeFound"));
    m_stop->setObjectName(QStringLiteral("stopAll"));
    m_progress->setTextVisible(false);
    auto* line = new QHBoxLayout;
    line->setSpacing(metrics::gap);
    for (QPushButton* button : {m_search, m_batch, m_take}) {
        button->setAutoDefault(false);
        line->addWidget(button);
    }
    line->addStretch();
    line->addWidget(m_progress);
    m_stop->setAutoDefault(false);
    line->addWidget(m_stop);
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setSpacing(metrics::margin);
    column->addWidget(m_head);
    column->addWidget(m_table);
    column->addLayout(line);
    column->addWidget(m_state);
    column->addWidget(m_times);
    column->addWidget(m_bars);
    column->addWidget(m_comparison);
    column->addStretch();
    auto* area = new QScrollArea(this);
    area->setWidget(page);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(area);
    for (CopyTable* table : {m_table, m_comparison}) {
        connect(table, &CopyTable::resized, this, &PartWindow::fitTables, Qt::QueuedConnection);
    }
    resize(atFontSize(720), atFontSize(640));
}

void PartWindow::fitTables() {
    for (CopyTable* table : {m_table, m_comparison}) {
        const QHeaderView* head = table->horizontalHeader();
        const bool isWide = head->length() > table->viewport()->width();
        table->setHorizontalScrollBarPolicy(isWide ? Qt::ScrollBarAlwaysOn
                                                   : Qt::ScrollBarAlwaysOff);
        const int bar = isWide ? table->horizontalScrollBar()->sizeHint().height() : 0;
        const int height = head->sizeHint().height() + table->verticalHeader()->length()
                           + 2 * table->frameWidth() + bar;
        if (table->minimumHeight() != height || table->maximumHeight() != height) {
            table->setFixedHeight(height);
        }
    }
}

void PartWindow::showTables() {
    const SetupState& state = m_document.state();
    if (m_runs.statuses().size() == state.surfaces.size()) { // otherwise they follow soon
        m_model->update(partTable(state, m_runs.statuses(), m_studies));
        m_compared->update(surfaceComparison(state, m_runs.statuses()));
        fitTables();
    }
}

void PartWindow::follow() {
    const SetupState& state = m_document.state();
    const std::vector<SurfaceStatus>& statuses = m_runs.statuses();
    if (statuses.size() != state.surfaces.size()) {
        return; // they follow in a moment
    }
    showTables();
    m_bars->setPart(state, statuses);
    const auto holding = std::ranges::count_if(statuses, &SurfaceStatus::holds);
    double cycles_min = 0;
    bool areCompleted = true;
    for (const SurfaceStatus& status : statuses) {
        areCompleted = areCompleted && status.isCompleted();
        cycles_min += status.time_s / units::secondsPerMinute;
    }
    // The surface to report first: one that is not computed, otherwise the one with the first
    // state.
    const auto worst = std::ranges::min_element(statuses, {}, [](const SurfaceStatus& status) {
        return status.ran() ? status.judgement.state : JudgedState::notComputed;
    });
    const auto place = static_cast<std::size_t>(worst - statuses.begin());
    m_head->setText(m_runs.running()
                        ? tr("The surfaces are being run…")
                        : tr("%1 of %2 surfaces are fit. %3. %4: %5")
                              .arg(QString::number(holding), QString::number(statuses.size()),
                                   QString::number(place + 1),
                                   printableText(SurfaceEdits::nameOf(state, place)),
                                   statusText(*worst)));
    m_times->setText(
        withIndices(pieceTimeText(state.times, statuses.size(),
                                  areCompleted ? std::optional(cycles_min) : std::nullopt))
            .replace(u'\n', QStringLiteral("<br>")));
}

bool PartWindow::isCurrent() const {
    return m_of == m_document.state().surfaces;
}

void PartWindow::showStudies() {
    const bool runs = m_study.running();
    m_search->setEnabled(!runs);
    m_batch->setEnabled(!runs);
    m_take->setEnabled(!runs && !m_found.empty() && isCurrent());
    m_stop->setVisible(runs);
    m_progress->setVisible(runs);
    const bool isOld = !m_studies.empty() && !runs && !isCurrent();
    m_state->setText(isOld ? tr("The inputs have changed since the batch and the search were run.")
                     : m_stopped ? tr("Stopped; partial results are shown.")
                                 : QString());
    m_state->setVisible(!m_state->text().isEmpty());
}

/// Removes results for other inputs.
void PartWindow::begin() {
    if (!isCurrent()) {
        m_found.clear();
        m_studies = {};
        showTables();
    }
    m_stopped = false;
    m_of = m_document.state().surfaces;
    m_progress->setValue(0);
}

void PartWindow::startBatches() {
    begin();
    m_study.startBatches(m_document.setup());
    showStudies();
}

void PartWindow::startSearches() {
    begin();
    m_found.clear();
    m_study.startSearches(m_document.setup(), m_ticks());
    showStudies();
}

void PartWindow::takeOver() {
    if (!isCurrent()) {
        return;
    }
    SetupState state = m_document.state();
    for (const SurfaceStudyPtr& study : m_found) {
        auto surface = std::make_shared<SurfaceState>(*state.surfaces[study->surface]);
        Project& project = surface->project;
        if (!project.optimisation) {
            project = usualSearch(std::move(project)); // the search that found the cycle
        }
        project = withFound(std::move(project), *study->search->answer());
        state.surfaces[study->surface] = std::move(surface);
    }
    m_document.endMerge();
    m_document.editSetup(std::move(state), takeFoundText);
}

void PartWindow::retranslate() {
    setWindowTitle(tr("Whole part"));
    m_table->setAccessibleName(tr("Surfaces of the part"));
    m_comparison->setAccessibleName(tr("The surfaces compared"));
    m_table->retranslate();
    m_comparison->retranslate();
    m_bars->retranslate();
    m_search->setText(tr("&Optimise all"));
    m_search->setToolTip(
        tr("Finds the quickest cycle of every surface in the order of grinding, as ticked in the "
           "view Optimise; a surface without a search gets a typical one"));
    m_batch->setText(tr("&Batch of all"));
    m_batch->setToolTip(tr("Runs the batch of every surface that has one"));
    m_take->setText(tr("&Apply the cycles found"));
    m_stop->setText(tr("&Stop"));
    m_progress->setAccessibleName(tr("Progress"));
    follow();
    showStudies();
}

void PartWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        showTables(); // their lights
    }
    QDialog::changeEvent(event);
}

} // namespace sparkout
