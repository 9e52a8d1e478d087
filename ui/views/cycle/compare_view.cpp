// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/compare_view.h"

#include "core/study/run_comparison.h"
#include "ui/chart/compare_plot.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_cursors.h"
#include "ui/chart/plot_tools.h"
#include "ui/chart/quantity_colour.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/kit/tool_row.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/cycle/runs_panel.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>
#include <vector>

namespace sparkout {

class ComparePlot;

/// The quantities on the right-hand axes of the compared curves, the upper and the lower, chosen
/// from one menu.
class SecondAxisMenu : public QMenu {
    Q_DECLARE_TR_FUNCTIONS(sparkout::SecondAxisMenu)
public:
    explicit SecondAxisMenu(ComparePlot& plot, QWidget* parent = nullptr);

    void retranslate();

private:
    void addRow(std::size_t row);

    ComparePlot& m_plot;
    std::vector<QAction*> m_quantities; ///< actions row by row
};

SecondAxisMenu::SecondAxisMenu(ComparePlot& plot, QWidget* parent) : QMenu(parent), m_plot(plot) {
    setObjectName(QStringLiteral("secondAxis"));
    setIcon(themeIcon(u"second_axis"));
    for (std::size_t row = 0; row < CompareChart::rowCount; ++row) {
        addSeparator();
        addRow(row);
    }
}

void SecondAxisMenu::addRow(std::size_t row) {
    auto* group = new QActionGroup(this);
    for (const Quantity quantity : CompareChart::secondQuantities[row]) {
        QAction* action = addAction(QString());
        action->setObjectName(QStringLiteral("second%1").arg(static_cast<int>(quantity)));
        action->setCheckable(true);
        action->setChecked(m_plot.secondQuantity(row) == quantity);
        group->addAction(action);
        m_quantities.push_back(action);
        connect(action, &QAction::triggered, this, [this, row, quantity] {
            m_plot.setSecond(row, quantity);
            m_plot.replot(QCustomPlot::rpQueuedReplot);
            m_plot.tools()->navigation().forgetViews(); // its ranges belong to another quantity
        });
    }
}

void SecondAxisMenu::retranslate() {
    setTitle(tr("Right-hand axes"));
    menuAction()->setToolTip(
        tr("Right-hand axes: the second quantity of the upper and of the lower plot"));
    auto action = m_quantities.begin();
    for (std::size_t row = 0; row < CompareChart::rowCount; ++row) {
        for (const Quantity quantity : CompareChart::secondQuantities[row]) {
            (*action++)->setText(
                (row == 0 ? tr("Above: %1") : tr("Below: %1")).arg(quantityWithUnit(quantity)));
        }
    }
}

namespace {

constexpr int runsWidth = 184, curvesWidth = 500;
constexpr int curvesHeight = 330, tableHeight = 170;
constexpr int widestValue = 120, leastName = 130, wantedName = 220; ///< columns, usual font size
constexpr int mostChanges = 3; ///< named for a run in the notice; the list's tool tip has all

} // namespace

CompareView::CompareView(KeptRuns& kept, QWidget* parent, Settings* settings)
    : PlotView(QStringLiteral("compare"), parent, settings)
    , m_kept(kept)
    , m_plot(new ComparePlot(this))
    , m_second(new SecondAxisMenu(*m_plot, this))
    , m_zone(new QComboBox(this))
    , m_axis(new QComboBox(this))
    , m_runs(new RunsPanel(kept, this))
    , m_tableModel(new ValueModel(this))
    , m_table(addTable(*m_tableModel))
    , m_empty(new QLabel(this))
    , m_keepHere(new QPushButton(this))
    , m_columns(new QSplitter(Qt::Horizontal, this))
    , m_halves(new QSplitter(Qt::Vertical, this)) {
    addPlot(*m_plot);
    addCursors(*m_plot);
    tools()->addTool(m_second->menuAction());
    disableUntilDrawn({m_zone, m_axis});
    build();
    connectParts();
    built();
}

void CompareView::build() {
    setUpNotice(*m_empty);
    setTextLines(*m_empty, 3, 2); // a splitter would give a wrapped text only one line
    m_columns->addWidget(m_runs);
    m_columns->addWidget(buildCurves());
    m_columns->setStretchFactor(1, 1);
    m_columns->setSizes({runsWidth, curvesWidth});
    m_halves->addWidget(buildUpper());
    m_halves->addWidget(buildTable());
    m_halves->setStretchFactor(0, 1);
    m_heights = {curvesHeight, tableHeight};
    m_table->hide();
    for (QSplitter* splitter : {m_columns, m_halves}) {
        splitter->setChildrenCollapsible(false);
    }
    addColumn({notice(), m_halves}, m_halves);
    nameObjects({{m_plot, "comparePlot"},
                 {m_zone, "compareZone"},
                 {m_axis, "compareAxis"},
                 {m_table, "compareTable"},
                 {m_empty, "compareEmpty"},
                 {m_keepHere, "compareStart"}});
}

/// Tools and legend take the whole width, which leaves more height for the curves beside the list.
QWidget* CompareView::buildUpper() {
    auto* upper = new QWidget(this);
    auto* column = rowIn<QVBoxLayout>(upper);
    auto* row = new ToolRow;
    column->addLayout(row);
    row->setSpacing(metrics::hair); // to fit many widgets
    addBoxes(*row, {m_zone, m_axis});
    row->addStretch(1);
    QToolButton* second = PlotTools::button(m_second->menuAction(), upper);
    second->setPopupMode(QToolButton::InstantPopup);
    second->setObjectName(QStringLiteral("secondAxisButton"));
    row->addWidget(second);
    addButtons(*row, {cursors()->toggle, tools()->back, tools()->forward, tools()->fit});
    column->addWidget(legend());
    column->addWidget(m_columns, 1);
    column->addWidget(values());
    return upper;
}

QWidget* CompareView::buildCurves() {
    auto* panel = new QWidget(this);
    auto* column = rowIn<QVBoxLayout>(panel);
    m_plot->setMinimumSize(240, 150);
    QScrollArea* area = scrolled(*m_plot);
    area->setObjectName(QStringLiteral("compareArea"));
    hideUntilDrawn({area});
    column->addWidget(area, 1);
    column->addWidget(strip());
    return panel;
}

/// The table of differences, or a text on how to get them.
QWidget* CompareView::buildTable() {
    auto* panel = new QWidget(this);
    auto* column = rowIn<QVBoxLayout>(panel);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setMinimumHeight(80);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setMinimumSectionSize(10);
    QHeaderView* const head = m_table->horizontalHeader();
    head->setDefaultAlignment(
        Qt::Alignment::fromInt(head->defaultAlignment().toInt() | Qt::TextWordWrap));
    connect(m_table, &CopyTable::resized, this, &CompareView::fitTable);
    connect(m_tableModel, &QAbstractItemModel::modelReset, this, &CompareView::fitTable);
    column->addWidget(m_table, 1);
    column->addWidget(m_empty);
    column->addWidget(m_keepHere, 0, Qt::AlignLeft);
    column->addStretch(0);
    return panel;
}

void CompareView::connectParts() {
    connect(&m_kept, &KeptRuns::changed, this, [this] { setOutcome(latest()); });
    connect(&m_kept, &KeptRuns::runRecalled, this, [this] { setOutcome(latest()); });
    connect(m_runs->keep(), &QAction::triggered, this, &CompareView::keepWanted);
    connect(m_keepHere, &QPushButton::clicked, this, &CompareView::keepWanted);
    connect(m_zone, &QComboBox::activated, this, [this](int index) {
        m_wanted = static_cast<std::size_t>(std::max(index, 0));
        showCurves();
        PlotView::showState();
        replotAll();
    });
    connect(m_axis, &QComboBox::activated, this, [this] {
        m_plot->setAxis(static_cast<CycleAxis>(m_axis->currentData().toInt()));
        replotFront();
        tools()->navigation().forgetViews();
    });
    connect(m_plot, &ComparePlot::timeClicked, this,
            [this](double time_s) { cycle().toTime(time_s); });
}

QListView* CompareView::list() const {
    return m_runs->list();
}

std::vector<int> CompareView::chosenRuns() const {
    std::vector<int> runs;
    for (int run = 0; run < m_kept.listed(); ++run) {
        if (m_kept.isChosen(run)) {
            runs.push_back(run);
        }
    }
    return runs;
}

// --- displayed runs -----------------------------------------------------------------------------

void CompareView::takeOutcome(const OutcomePtr& before) {
    if (good() == before) {
        return;
    }
    m_present = ReadSummary{summarise(good()->result, good()->accuracy, good()->constraints), {}};
    if (hasOtherPlaces(before)) {
        m_wanted = good()->result.sections.size() / 2; // the gauge's zone, or the middle section
    }
    fillAxes();
    fillZones();
}

void CompareView::setJudged(const JudgedRun& judged) {
    if (judged.outcome && judged.outcome->ran()) {
        m_judged = judged;
    }
    showJudged();
}

/// The judgement may belong to a run that this view does not show yet.
void CompareView::showJudged() {
    m_runs->setJudgement(good() && m_judged.outcome == good() ? &m_judged.judgement : nullptr);
}

void CompareView::dropOutcome() {
    m_present.reset();
    m_judged = {};
    fillAxes();
    fillZones();
}

/// The feeds of the zone or section chosen by the user: the same one if both runs have the same
/// places, otherwise the nearest along the part. Empty until they are computed, or if they were not
/// recorded.
std::optional<ComparedFeeds> CompareView::feedsOf(int run) const {
    const RecalledRun* const now = m_kept.recalled(run);
    const Project* const inputs = m_kept.inputs(run);
    if (!now || !now->feeds || now->feeds->columns.empty() || !now->summary || !inputs) {
        return std::nullopt;
    }
    const RunPlaces shown{good()->result.project, m_present->summary};
    const RunPlaces kept{*inputs, *now->summary};
    ComparedFeeds feeds{m_runs->nameOf(run), now->feeds, matchingPlace(shown, m_wanted, kept)};
    if (!haveSamePlaces(shown, kept)) {
        const FeedColumn& column = now->feeds->columns[feeds.column];
        feeds.name = tr("%1: %2").arg(feeds.name, Names::zone(column.zone, column.section));
    }
    return feeds;
}

void CompareView::showCurves() {
    std::vector<ComparedFeeds> runs;
    if (good() && m_wanted < good()->feeds.columns.size()) {
        runs.push_back({tr("Current run"), {good(), &good()->feeds}, m_wanted});
        int number = 0;
        for (const int run : chosenRuns()) {
            ++number; // counts runs that are not drawn yet, too
            if (auto feeds = feedsOf(run)) {
                feeds->number = number;
                runs.push_back(std::move(*feeds));
            }
        }
    }
    if (m_plot->setRuns(std::move(runs))) {
        tools()->navigation().forgetViews(); // ranges of another unit
    }
}

/// A run whose repetition gives other results has two columns: as kept and as computed.
void CompareView::showTable() {
    std::vector<ComparedRun> runs;
    QStringList names;
    std::vector<ReadSummary> computed;
    const std::vector<int> chosen = chosenRuns();
    computed.reserve(chosen.size());
    if (m_present && !chosen.empty()) {
        names << tr("Current run");
        runs.push_back({&good()->result.project, &*m_present});
        for (const int run : chosen) {
            const QString name = m_runs->nameOf(run);
            names << name;
            runs.push_back({m_kept.inputs(run), m_kept.summary(run)});
            const RecalledRun* const now = m_kept.recalled(run);
            if (m_kept.isChanged(run) && now && now->summary) {
                computed.push_back({*now->summary, {}});
                names << tr("now: %1").arg(name);
                runs.push_back({m_kept.inputs(run), &computed.back()});
            }
        }
    }
    m_rows = differingRows(runs);
    m_tableModel->setTable(runTable(m_rows, names));
}

void CompareView::followCycle() {
    const CycleCursor* const at = cycleIn(good());
    m_plot->setMoment(at && !at->atEnd() ? std::optional(at->time_s()) : std::nullopt);
}

/// Without a table the curves take its space.
void CompareView::shareHeight(bool withTable) {
    const bool had = !m_table->isHidden();
    m_table->setVisible(withTable);
    m_table->parentWidget()->setSizePolicy(
        QSizePolicy::Preferred, withTable ? QSizePolicy::Preferred : QSizePolicy::Maximum);
    if (withTable && !had) {
        m_halves->setSizes(m_heights);
    } else if (!withTable) {
        m_heights = had ? m_halves->sizes() : m_heights;
        m_halves->setSizes({m_halves->height(), 0});
    }
}

/// Wraps heads and long values if the columns would not all be visible.
void CompareView::fitTable() {
    const QAbstractItemView& table = *m_table; // the base class makes it public
    QHeaderView* const head = m_table->horizontalHeader();
    const int columns = m_tableModel->columnCount() - 1;
    std::vector<int> least, wanted;
    int rest = m_table->viewport()->width() - atFontSize(wantedName);
    for (int column = 1; column <= columns; ++column) {
        least.push_back(widthOfWords(column));
        wanted.push_back(
            std::max({std::min(table.sizeHintForColumn(column), atFontSize(widestValue)),
                      head->sectionSizeHint(column), least.back()}));
        rest -= least.back();
    }
    const int spare = columns > 0 ? std::max(rest, 0) / columns : 0;
    int values = 0;
    for (int column = 1; column <= columns; ++column) {
        const auto i = static_cast<std::size_t>(column - 1);
        const int width = std::min(wanted[i], least[i] + spare);
        head->resizeSection(column, width);
        values += width;
    }
    head->resizeSection(0, std::max(m_table->viewport()->width() - values, atFontSize(leastName)));
    head->setFixedHeight(heightOfHeads());
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // measures
}

/// The width of the longest word in a column, with its margins.
int CompareView::widthOfWords(int column) const {
    const QHeaderView& head = *m_table->horizontalHeader();
    int words = 0, heads = 0;
    const auto widest = [](const QFontMetrics& metrics, const QString& text) {
        int width = 0;
        for (const QString& word : text.split(u' ')) {
            width = std::max(width, metrics.horizontalAdvance(word));
        }
        return width;
    };
    heads = widest(head.fontMetrics(),
                   m_tableModel->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    for (int row = 0; row < m_tableModel->rowCount(); ++row) {
        words = std::max(words, widest(m_table->fontMetrics(),
                                       m_tableModel->index(row, column).data().toString()));
    }
    const int cell = m_table->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, m_table);
    const int own = m_table->style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &head);
    return std::max(heads + 2 * own, words + 2 * (cell + 1)) + 2;
}

int CompareView::heightOfHeads() const {
    const QHeaderView& head = *m_table->horizontalHeader();
    const int margin = m_table->style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &head);
    int height = 0;
    for (int column = 0; column < m_tableModel->columnCount(); ++column) {
        const QRect room(0, 0, head.sectionSize(column) - 2 * margin, 10'000);
        const QString text =
            m_tableModel->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        height = std::max(height,
                          head.fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height());
    }
    return height + 2 * margin;
}

bool CompareView::drawn() const {
    return !m_plot->runs().empty();
}

void CompareView::showState() {
    m_runs->setRuns(m_present ? &*m_present : nullptr,
                    m_present ? &good()->result.project : nullptr);
    showJudged();
    showCurves();
    showTable();
    followCycle();
    PlotView::showState();
    m_keepHere->setVisible(m_kept.count() == 0);
    const QString empty = emptyText();
    m_empty->setText(empty);
    m_empty->setVisible(!empty.isEmpty());
    shareHeight(empty.isEmpty());
    readOut();
}

// --- texts --------------------------------------------------------------------------------------

QString CompareView::title() const {
    return tr("Compare");
}

QString CompareView::hint() const {
    return tr("Point at a curve to read its values beside those of the current run.");
}

QString CompareView::emptyText() const {
    if (m_kept.listed() == 0) {
        return tr("No run is kept yet. Keep the current run and change the inputs; the curves of "
                  "both runs, and the inputs and results that differ, are shown here.");
    }
    if (chosenRuns().empty()) {
        return tr("Check a run in the list to draw it over the current run.");
    }
    return m_rows.empty()
               ? tr("The chosen runs have the same inputs and results as the current run.")
               : QString();
}

QString CompareView::keptText() const {
    return tr("The inputs are refused; the current run is that of the last valid inputs.");
}

QString CompareView::remark() const {
    return good()->feeds.columns.empty()
               ? tr("The cycle is too long to be recorded: its curves are not drawn. Fewer radii "
                    "or sections help.")
               : QString();
}

QString CompareView::noticeText() const {
    QStringList lines{PlotView::noticeText()};
    for (const int run : chosenRuns()) {
        lines << runNotes(run);
    }
    return joined(lines, QStringLiteral("\n"));
}

/// The reasons why a run is not drawn as it was kept.
QStringList CompareView::runNotes(int run) const {
    const KeptRun& kept = m_kept.run(run);
    const RecalledRun* const now = m_kept.recalled(run);
    const QString name = m_runs->nameOf(run);
    if (now && hasErrors(now->issues)) {
        return {tr("“%1” can no longer be run: %2").arg(name, Names::refusal(now->issues, 1))};
    }
    if (now && now->summary && m_kept.isChanged(run)) {
        const QStringList all = m_kept.summary(run)
                                    ? changesShown(*m_kept.summary(run), *now->summary)
                                    : QStringList{tr("its results cannot be read")};
        QString named = all.mid(0, mostChanges).join(QStringLiteral("; "));
        if (all.size() > mostChanges) {
            named += tr("; and %n more", nullptr, static_cast<int>(all.size()) - mostChanges);
        }
        return {tr("“%1” was kept by version %2 of the program; this version gives different "
                   "results: %3")
                    .arg(name, QString::fromStdString(kept.engine_version), named)};
    }
    if (now && now->feeds && now->feeds->columns.empty()) {
        return {tr("“%1” is too long to be recorded: its curves are not drawn.").arg(name)};
    }
    return {};
}

QStringList CompareView::subheading() const {
    return {m_zone->currentText()};
}

void CompareView::fillAxes() {
    const bool strokes = !good() || good()->feeds.operation->travels;
    const int before = m_axis->currentIndex() < 0 ? 0 : m_axis->currentData().toInt();
    m_axis->clear();
    m_axis->addItem(tr("Time"), static_cast<int>(CycleAxis::time));
    m_axis->addItem(strokes ? tr("Double strokes") : tr("Revolutions"),
                    static_cast<int>(CycleAxis::strokes));
    m_axis->setCurrentIndex(std::max(m_axis->findData(before), 0));
}

void CompareView::fillZones() {
    m_zone->clear();
    if (good()) {
        for (const FeedColumn& column : good()->feeds.columns) {
            m_zone->addItem(Names::zoneFull(column.zone, column.section));
        }
        m_zone->setCurrentIndex(static_cast<int>(m_wanted));
    }
}

void CompareView::nameParts() {
    nameAround(tr("Legend of quantities and runs"), tr("State of the comparison"),
               tr("Values under the mouse"));
    m_second->retranslate();
    m_runs->retranslate();
    m_plot->setAccessibleName(tr("Curves of the compared runs"));
    m_table->setAccessibleName(tr("Inputs and results that differ"));
    m_empty->setAccessibleName(tr("Next step"));
    tell(*m_zone, tr("Zone or section whose curves are drawn"));
    tell(*m_axis, tr("Horizontal axis"));
    m_keepHere->setText(tr("Keep the current run"));
    m_table->retranslate();
    fillAxes();
    fillZones();
}

} // namespace sparkout
