// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/plot_view.h"

#include "core/study/outcome.h"
#include "core/units.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_cursors.h"
#include "ui/chart/view_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/metrics.h"
#include "ui/kit/tool_row.h"
#include "ui/session/job.h"
#include "ui/text/names.h"

#include <QAbstractButton>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

namespace sparkout {

namespace {
constexpr int progressSteps = 1000;
constexpr double quickRadii = 2e8; ///< about two seconds of one processor
} // namespace

RunBar::RunBar(const QString& name, QWidget* parent, Progress text)
    : QWidget(parent)
    , m_text(text)
    , m_run(new QPushButton(this))
    , m_stop(new QPushButton(this))
    , m_state(new QLabel(this))
    , m_progress(new QProgressBar(this)) {
    m_run->setObjectName(name + QStringLiteral("Run"));
    m_stop->setObjectName(name + QStringLiteral("Stop"));
    m_state->setObjectName(name + QStringLiteral("State"));
    m_progress->setObjectName(name + QStringLiteral("Progress"));
    m_state->setTextFormat(Qt::PlainText);
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(true);
}

void RunBar::layOut(std::initializer_list<QWidget*> before, std::initializer_list<QWidget*> behind,
                    int letters) {
    auto* row = new ToolRow(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_run);
    row->addWidget(m_stop);
    for (QWidget* part : before) {
        row->addWidget(part);
    }
    row->addText(m_state, letters, 1);
    row->addWidget(m_progress, 1);
    for (QWidget* part : behind) {
        row->addWidget(part);
    }
}

void RunBar::follow(Job& job) {
    connect(&job, &Job::progressed, this, qOverload<qint64, qint64, double>(&RunBar::showProgress));
    connect(m_stop, &QPushButton::clicked, &job, &Job::stop);
}

QString RunBar::withTimeLeft(const QString& count, double left_s) {
    if (left_s < 0) {
        return count;
    }
    constexpr double perMinute = units::secondsPerMinute;
    return left_s < 2 * perMinute
               ? tr("%1, %2 s left").arg(count).arg(std::ceil(left_s), 0, 'f', 0)
               : tr("%1, %2 min left").arg(count).arg(std::ceil(left_s / perMinute), 0, 'f', 0);
}

bool RunBar::areQuick(std::int64_t runs, std::int64_t radii) {
    return static_cast<double>(runs) * static_cast<double>(radii) <= quickRadii;
}

void RunBar::showProgress(qint64 done, qint64 parts, double left_s) {
    m_progress->setValue(static_cast<int>(done * progressSteps / std::max(parts, qint64(1))));
    m_progress->setFormat(m_text(done, parts, left_s));
}

void RunBar::showProgress(double share, const QString& text) {
    m_progress->setValue(static_cast<int>(share * progressSteps));
    m_progress->setFormat(text);
}

void RunBar::showRunning(bool runs, bool mayRun) {
    m_progress->setVisible(runs);
    m_run->setEnabled(mayRun && !runs);
    m_stop->setEnabled(runs || m_turns);
    if (m_turns) { // shows the new button before hiding the old one, so that the focus moves to it
        QPushButton* const coming = runs ? m_stop : m_run;
        QPushButton* const going = runs ? m_run : m_stop;
        coming->show();
        going->hide();
    }
    m_state->setVisible(!runs);
}

namespace {

/// Processor time of this thread, so that other load does not count.
double ownTime_ms() {
    std::timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

} // namespace

PlotView::PlotView(const QString& name, QWidget* parent, Settings* settings)
    : View(parent)
    , m_settings(settings)
    , m_notice(new QLabel(this))
    , m_legend(new LegendStrip(this))
    , m_values(new QLabel(this)) {
    setObjectName(name);
    m_notice->setObjectName(name + QStringLiteral("Notice"));
    m_legend->setObjectName(name + QStringLiteral("Legend"));
    m_values->setObjectName(name + QStringLiteral("Values"));
    setUpNotice(*m_notice);
    m_notice->setTextInteractionFlags(m_notice->textInteractionFlags() | Qt::LinksAccessibleByMouse
                                      | Qt::LinksAccessibleByKeyboard);
    connect(m_notice, &QLabel::linkActivated, this,
            [this](const QString& path) { emit inputAsked(path.toStdString()); });
    setUpReadout(*m_values);
    hideUntilDrawn({m_legend, m_values});
    connect(m_legend, &LegendStrip::toggled, this, [this](int key) { toggleCurve(key); });
    connect(m_legend, &LegendStrip::onlyAsked, this, [this](int key) { showOnly(key); });
}

// --- building -----------------------------------------------------------------------------------

void PlotView::addPlot(ViewPlot& plot, PlotSubject subject) {
    m_plots.push_back(&plot);
    m_front = m_front ? m_front : &plot;
    if (!subject.heading) {
        subject.heading = [this] { return heading(); };
    }
    plot.addTools(std::move(subject), m_settings);
    connect(&plot, &ViewPlot::pointed, this, &PlotView::readOut);
    connect(&plot, &ViewPlot::contentChanged, this, &PlotView::showLegend);
}

void PlotView::addCursors(ViewPlot& plot) {
    m_strip = new CursorStrip(plot.addCursors(), this);
}

void PlotView::addPage(ViewPlot& plot, PlotSubject subject) {
    if (!m_pages) {
        m_pages = new QStackedWidget(this);
        hideUntilDrawn({m_pages});
    }
    addPlot(plot, std::move(subject));
    m_pages->addWidget(scrolled(plot));
    m_buttons.push_back(pageButtons(*plot.tools()));
}

QScrollArea* PlotView::scrolled(QWidget& plots) {
    auto* area = new QScrollArea(this);
    area->setMinimumSize(plots.minimumSize());
    plots.setMinimumSize(0, 0);
    area->setWidget(&plots);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus); // the plot has it
    return area;
}

QWidget* PlotView::pageButtons(PlotTools& tools) {
    auto* buttons = new QWidget(this);
    auto* row = rowIn<QHBoxLayout>(buttons);
    if (tools.fit->isVisible()) { // otherwise everything is visible
        row->addWidget(PlotTools::button(tools.fit, buttons));
    }
    row->addWidget(tools.exportButton(buttons));
    return buttons;
}

void PlotView::addBoxes(QLayout& row, std::initializer_list<QComboBox*> boxes) {
    for (QComboBox* box : boxes) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        row.addWidget(box);
    }
}

void PlotView::addButtons(QLayout& row, const QList<QAction*>& actions) const {
    QWidget* bar = row.parentWidget();
    for (QAction* action : actions) {
        row.addWidget(PlotTools::button(action, bar));
    }
    row.addWidget(tools()->exportButton(bar));
}

void PlotView::closeUp(QLayout& row) {
    row.setContentsMargins(0, 0, 0, 0);
    row.setSpacing(metrics::tight);
}

void PlotView::addPageButtons(QLayout& row) const {
    for (QWidget* buttons : m_buttons) {
        row.addWidget(buttons);
    }
}

QComboBox* PlotView::content() {
    if (!m_content) {
        m_content = new QComboBox(this);
        m_content->setObjectName(objectName() + QStringLiteral("Content"));
        m_content->addItems(QStringList(m_pages->count(), QString()));
        m_content->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    }
    return m_content;
}

void PlotView::showPage(std::size_t index) {
    m_pages->setCurrentIndex(static_cast<int>(index));
    m_front = m_plots[index];
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setVisible(i == index);
    }
    showLegend();
    replotFront();
}

void PlotView::share(QSplitter& splitter, std::initializer_list<std::pair<QWidget*, int>> parts) {
    QList<int> sizes;
    for (const auto& [part, size] : parts) {
        splitter.addWidget(part);
        splitter.setStretchFactor(splitter.count() - 1, size);
        sizes << size;
    }
    splitter.setChildrenCollapsible(false);
    splitter.setSizes(sizes);
}

QVBoxLayout* PlotView::addColumn(std::initializer_list<QWidget*> parts, QWidget* main) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::tight, metrics::gap, metrics::tight, metrics::gap);
    column->setSpacing(metrics::tight);
    for (QWidget* part : parts) {
        column->addWidget(part, part == main ? 1 : 0);
    }
    return column;
}

CopyTable* PlotView::addTable(QAbstractItemModel& model, std::function<CsvTable()> table,
                              std::function<QString()> text) {
    if (!text) {
        text = [table] { return tabSeparated(table(), QLocale()); };
    }
    auto* const view = new CopyTable(std::move(text), this);
    view->setModel(&model);
    setUpTable(*view, std::move(table));
    return view;
}

CopyTable* PlotView::addTable(ValueModel& model, std::function<CsvTable()> saved) {
    if (!saved) {
        saved = [&model] { return model.shown(); };
    }
    const auto whole = [saved] { return tabSeparated(saved(), QLocale()); };
    auto* const view = new CopyTable(model, this, whole);
    setUpTable(*view, std::move(saved));
    return view;
}

void PlotView::setUpTable(CopyTable& table, std::function<CsvTable()> saved) {
    table.setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    table.setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded); // needed with large fonts
    table.verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table.setSaving(
        std::move(saved), [this] { return projectTitle(); }, m_settings);
}

void PlotView::fillChoice(QComboBox& box, const QStringList& texts) {
    const QSignalBlocker blocker(box);
    const int index = std::max(box.currentIndex(), 0);
    box.clear();
    box.addItems(texts);
    box.setCurrentIndex(index);
}

void PlotView::hideUntilDrawn(std::initializer_list<QWidget*> parts) {
    m_hidden.insert(m_hidden.end(), parts);
}

void PlotView::disableUntilDrawn(std::initializer_list<QWidget*> parts) {
    m_disabled.insert(m_disabled.end(), parts);
}

void PlotView::nameObjects(std::initializer_list<std::pair<QWidget*, const char*>> names) {
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

void PlotView::tell(QWidget& widget, const QString& text) {
    widget.setAccessibleName(text);
    widget.setToolTip(text);
}

void PlotView::tell(QWidget& widget, const QString& name, const QString& tip) {
    widget.setAccessibleName(name);
    widget.setAccessibleDescription(tip);
    widget.setToolTip(tip);
}

void PlotView::tellButton(QAbstractButton& button, const QString& text, const QString& tip) {
    button.setText(text);
    tell(button, text, tip);
}

PlotTools* PlotView::tools() const {
    return m_front->tools();
}

PlotCursors* PlotView::cursors() const {
    for (const ViewPlot* plot : m_plots) {
        if (plot->cursors()) {
            return plot->cursors();
        }
    }
    return nullptr;
}

// --- displayed outcome --------------------------------------------------------------------------

bool PlotView::refused() const {
    return latest() && !latest()->ran();
}

bool PlotView::hasOtherPlaces(const OutcomePtr& before) const {
    return !before || before->result.project.operation != good()->result.project.operation
           || before->result.sections.size() != good()->result.sections.size();
}

bool PlotView::draws(const Outcome& outcome) const {
    return !outcome.result.sections.empty();
}

bool PlotView::faint() const {
    return m_good && latest() && !(latest()->ran() && draws(*latest()));
}

void PlotView::showOutcome() {
    const double begin_ms = ownTime_ms();
    if (latest() && latest()->ran() && draws(*latest())) {
        keepOutcome();
        takeOutcome(std::exchange(m_good, latest()));
    } else if (latest() && isOfBefore()) {
        keepOutcome();
        m_good.reset();
        dropOutcome();
    }
    showState();
    showLegend();
    showPlots();
    m_lastUpdate_ms = ownTime_ms() - begin_ms;
    emit updated();
}

// A page behind the front one is drawn when it comes to the front.
void PlotView::showPlots() {
    for (ViewPlot* plot : m_plots) {
        if (isShown(*plot)) {
            plot->replot();
        }
        plot->tools()->navigation().amendView();
    }
}

void PlotView::replotAll() {
    for (ViewPlot* plot : m_plots) {
        if (isShown(*plot)) {
            plot->replot(QCustomPlot::rpQueuedReplot);
        }
        plot->tools()->navigation().amendView();
    }
}

void PlotView::replotFront() {
    m_front->replot(QCustomPlot::rpQueuedReplot);
}

bool PlotView::isShown(const ViewPlot& plot) const {
    return &plot == m_front || !m_pages || !m_pages->isAncestorOf(&plot);
}

void PlotView::showState() {
    const QString text = noticeText();
    const bool incomplete = refused() && Names::incomplete(latest()->issues);
    m_notice->setTextFormat(incomplete ? Qt::RichText : Qt::PlainText);
    if (incomplete) { // each as a link to its field
        const QString old = tr("The pale curves are those of the last complete inputs.");
        m_notice->setText(refusedText() + u' ' + Names::missingLinks(latest()->issues) + u'.'
                          + (m_good ? u' ' + old : QString()));
    } else {
        m_notice->setText(text);
    }
    m_notice->setVisible(!text.isEmpty());
    const bool shown = drawn();
    for (QWidget* part : m_hidden) {
        part->setVisible(shown);
    }
    for (QWidget* part : m_disabled) {
        part->setEnabled(shown);
    }
    for (ViewPlot* plot : m_plots) {
        plot->setDimmed(isFaint(*plot));
        plot->tools()->setEnabled(shown);
    }
}

void PlotView::showLegend() {
    if (m_front) { // a plot may report its content before it is added
        m_legend->setEntries(m_front->legendEntries());
    }
}

void PlotView::toggleCurve(int key) {
    m_front->toggleCurve(key);
}

void PlotView::showOnly(int key) {
    m_front->showOnly(key);
}

// --- words --------------------------------------------------------------------------------------

QString PlotView::keptText() const {
    return tr("The inputs are refused; the curves are those of the last valid inputs.");
}

QString PlotView::refusedText() const {
    return latest() && Names::incomplete(latest()->issues)
               ? tr("The project is not complete. Still needed:")
               : tr("The inputs are refused:");
}

QString PlotView::noticeText() const {
    if (refused()) {
        return (m_good ? keptText() : refusedText()) + QLatin1Char('\n')
               + Names::refusal(latest()->issues, 2);
    }
    return m_good ? remark() : tr("No result yet.");
}

QStringList PlotView::heading() const {
    QStringList heading{title()};
    if (shownProject()) {
        heading << projectTitle() << subheading();
    }
    heading.removeAll(QString());
    return heading;
}

const Project* PlotView::shownProject() const {
    return m_good ? &m_good->result.project : nullptr;
}

QString PlotView::projectTitle() const {
    const Project* const project = shownProject();
    return project ? QString::fromStdString(project->title).simplified() : QString();
}

void PlotView::nameAround(const QString& legend, const QString& notice, const QString& values) {
    m_legend->setAccessibleName(legend);
    m_notice->setAccessibleName(notice);
    m_values->setAccessibleName(values);
}

void PlotView::retranslate() {
    setAccessibleName(title());
    m_legend->retranslate();
    if (m_strip) {
        m_strip->retranslate();
    }
    for (ViewPlot* plot : m_plots) {
        plot->retranslate();
    }
    nameParts();
    readOut();
    showState();
    showLegend();
    for (ViewPlot* plot : m_plots) {
        plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

} // namespace sparkout
