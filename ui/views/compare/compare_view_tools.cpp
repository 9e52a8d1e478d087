// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the view of compared runs: building, connecting and naming.
#include "ui/views/compare/compare_view.h"

#include "ui/charts/compare_plot.h"
#include "ui/charts/run_table_model.h"
#include "ui/charts/runs_model.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/kit/tool_row.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/feed_text.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_tools.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

namespace sparkout {

namespace {

/// Lets a name that is being typed be, unless the row itself gets another name.
class RunDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        const QVariant name = index.data(Qt::EditRole);
        if (editor->property("runName") != name) {
            editor->setProperty("runName", name);
            QStyledItemDelegate::setEditorData(editor, index);
        }
    }
};

constexpr int runsWidth = 184, curvesWidth = 500;
constexpr int curvesHeight = 330, tableHeight = 170;

QVBoxLayout* columnIn(QWidget* widget) {
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    return column;
}

} // namespace

CompareView::CompareView(KeptRuns& kept, QWidget* parent, Settings* settings)
    : View(parent)
    , m_kept(kept)
    , m_plot(new ComparePlot(this))
    , m_legend(new LegendStrip(this))
    , m_zone(new QComboBox(this))
    , m_axis(new QComboBox(this))
    , m_notice(new QLabel(this))
    , m_values(new QLabel(this))
    , m_list(new QListView(this))
    , m_runs(new RunsModel(this))
    , m_table(
          new CopyTable([this] { return tabSeparated(m_tableModel->table(), QLocale()); }, this))
    , m_tableModel(new RunTableModel(this))
    , m_empty(new QLabel(this))
    , m_keepHere(new QPushButton(this))
    , m_columns(new QSplitter(Qt::Horizontal, this))
    , m_halves(new QSplitter(Qt::Vertical, this)) {
    setObjectName(QStringLiteral("compare"));
    build(settings);
    connectParts();
    built();
}

QAction* CompareView::makeAction(const char* name, const char16_t* icon, const QKeySequence& keys) {
    auto* action = new QAction(themeIcon(icon), QString(), this);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    return action;
}

void CompareView::build(Settings* settings) {
    m_keep = makeAction("compareKeep", u"keep", {});
    m_restore = makeAction("compareRestore", u"restore", Qt::CTRL | Qt::Key_Return);
    m_rename = makeAction("compareRename", u"rename", Qt::Key_F2);
    m_delete = makeAction("compareDelete", u"remove", QKeySequence::Delete);
    for (QLabel* label : {m_notice, m_empty}) {
        setUpNotice(*label);
    }
    setTextLines(*m_empty, 3, 2); // a wrapped text tells a splitter one
    setUpReadout(*m_values);
    auto* layout = columnIn(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    buildTools(settings);
    m_columns->addWidget(buildRuns());
    m_columns->addWidget(buildCurves());
    m_columns->setStretchFactor(1, 1);
    m_columns->setSizes({runsWidth, curvesWidth});
    auto* upper = new QWidget(this);
    auto* column = columnIn(upper);
    column->addWidget(m_columns, 1);
    column->addWidget(m_values);
    m_halves->addWidget(upper);
    m_halves->addWidget(buildTable());
    m_table->setSaving([this] { return m_tableModel->table(); },
                       [this] { return heading().value(1); }, settings);
    m_halves->setStretchFactor(0, 1);
    m_heights = {curvesHeight, tableHeight};
    m_table->hide();
    for (QSplitter* splitter : {m_columns, m_halves}) {
        splitter->setChildrenCollapsible(false);
    }
    layout->addWidget(m_notice);
    layout->addWidget(m_halves, 1);
    const std::pair<QWidget*, const char*> names[] = {
        {m_plot, "comparePlot"},     {m_legend, "compareLegend"}, {m_zone, "compareZone"},
        {m_axis, "compareAxis"},     {m_notice, "compareNotice"}, {m_values, "compareValues"},
        {m_list, "compareRuns"},     {m_table, "compareTable"},   {m_empty, "compareEmpty"},
        {m_keepHere, "compareStart"}};
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

void CompareView::buildTools(Settings* settings) {
    PlotSubject subject;
    subject.heading = [this] { return heading(); };
    subject.legend = [this] { return m_plot->legendEntries(); };
    subject.table = [this] { return m_plot->table(); };
    subject.restyle = [this] { m_plot->restyle(); };
    subject.navigation.fit = [this] { m_plot->fit(); };
    subject.navigation.axes = [this](QCPAxisRect& rect) { return m_plot->movedAxes(rect); };
    m_tools = new PlotTools(*m_plot, std::move(subject));
    m_tools->setSettings(settings);
    m_cursors = new PlotCursors(*m_plot, m_plot->cursorSubject());
    m_strip = new CursorStrip(*m_cursors, this);
    m_tools->addTool(m_cursors->toggle);
    buildSecond();
}

/// What stands on the right-hand axes, chosen from one menu.
void CompareView::buildSecond() {
    m_second = new QMenu(this);
    m_second->setObjectName(QStringLiteral("secondAxis"));
    m_second->setIcon(themeIcon(u"second_axis"));
    for (std::size_t row = 0; row < ComparePlot::rowCount; ++row) {
        m_second->addSeparator();
        auto* group = new QActionGroup(m_second);
        for (const Quantity quantity : ComparePlot::secondQuantities[row]) {
            QAction* action = m_second->addAction(QString());
            action->setObjectName(QStringLiteral("second%1").arg(static_cast<int>(quantity)));
            action->setCheckable(true);
            action->setChecked(m_plot->second(row) == quantity);
            group->addAction(action);
            m_seconds.push_back(action);
            connect(action, &QAction::triggered, this, [this, row, quantity] {
                m_plot->setSecond(row, quantity);
                m_plot->replot(QCustomPlot::rpQueuedReplot);
                m_tools->navigation().forgetViews(); // ranges of another quantity
            });
        }
    }
    m_tools->addTool(m_second->menuAction());
}

void CompareView::nameSecond() {
    m_second->setTitle(tr("Right-hand axes"));
    m_second->menuAction()->setToolTip(
        tr("Right-hand axes: the second quantity of the upper and of the lower plot"));
    auto action = m_seconds.begin();
    for (std::size_t row = 0; row < ComparePlot::rowCount; ++row) {
        for (const Quantity quantity : ComparePlot::secondQuantities[row]) {
            (*action++)->setText(
                (row == 0 ? tr("Above: %1") : tr("Below: %1")).arg(quantityWithUnit(quantity)));
        }
    }
}

/// The list of runs with its buttons.
QWidget* CompareView::buildRuns() {
    auto* panel = new QWidget(this);
    auto* column = columnIn(panel);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::hair);
    for (QAction* action : {m_keep, m_restore, m_rename, m_delete}) {
        row->addWidget(PlotTools::button(action, panel));
    }
    row->addStretch(1);
    column->addLayout(row);
    column->addWidget(m_list, 1);
    m_list->setModel(m_runs);
    m_list->setItemDelegate(new RunDelegate(m_list));
    m_list->setIconSize(RunsModel::sample);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setMinimumWidth(130);
    m_list->addActions({m_restore, m_rename, m_delete});
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    return panel;
}

QWidget* CompareView::buildCurves() {
    auto* panel = new QWidget(this);
    auto* column = columnIn(panel);
    auto* row = new ToolRow;
    row->setSpacing(metrics::hair); // many stand in it
    for (QComboBox* box : {m_zone, m_axis}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        row->addWidget(box);
    }
    row->addStretch(1);
    QToolButton* second = PlotTools::button(m_second->menuAction(), panel);
    second->setPopupMode(QToolButton::InstantPopup);
    second->setObjectName(QStringLiteral("secondAxisButton"));
    row->addWidget(second);
    for (QAction* action : {m_cursors->toggle, m_tools->back, m_tools->forward, m_tools->fit}) {
        row->addWidget(PlotTools::button(action, panel));
    }
    row->addWidget(m_tools->exportButton(panel));
    m_plot->setMinimumSize(240, 150);
    column->addLayout(row);
    column->addWidget(m_legend);
    column->addWidget(m_plot, 1);
    column->addWidget(m_strip);
    return panel;
}

/// What differs, or what to do to see it.
QWidget* CompareView::buildTable() {
    auto* panel = new QWidget(this);
    auto* column = columnIn(panel);
    m_table->setModel(m_tableModel);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setWordWrap(true);
    m_table->setMinimumHeight(80);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->verticalHeader()->setMinimumSectionSize(10);
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
    connect(m_keep, &QAction::triggered, this, &CompareView::keepWanted);
    connect(m_keepHere, &QPushButton::clicked, this, &CompareView::keepWanted);
    connect(m_runs, &RunsModel::chosen, &m_kept, &KeptRuns::choose);
    connect(m_runs, &RunsModel::renamed, &m_kept, &KeptRuns::rename);
    connect(m_rename, &QAction::triggered, this, [this] { m_list->edit(m_list->currentIndex()); });
    connect(m_delete, &QAction::triggered, this, [this] {
        if (const int run = selectedRun(); run >= 0) {
            m_kept.remove(run);
        }
    });
    connect(m_restore, &QAction::triggered, this, [this] {
        if (const int run = selectedRun(); run >= 0) {
            m_kept.restore(run);
        }
    });
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &CompareView::showState);
    connect(m_zone, &QComboBox::activated, this, [this](int index) {
        m_wanted = static_cast<std::size_t>(std::max(index, 0));
        showCurves();
        showState();
    });
    connect(m_axis, &QComboBox::activated, this, [this] {
        m_plot->setAxis(static_cast<CycleAxis>(m_axis->currentData().toInt()));
        m_plot->replot(QCustomPlot::rpQueuedReplot);
        m_tools->navigation().forgetViews();
    });
    connect(m_plot, &ComparePlot::contentChanged, this, &CompareView::showLegend);
    connect(m_plot, &ComparePlot::pointed, this, &CompareView::readOut);
    connect(m_plot, &ComparePlot::timeClicked, this,
            [this](double time_s) { cycle().toTime(time_s); });
    connect(m_legend, &LegendStrip::toggled, this, [this](int key) {
        m_plot->toggleCurve(key);
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    });
    connect(m_legend, &LegendStrip::onlyAsked, this, [this](int key) {
        m_plot->showOnly(key);
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    });
}

void CompareView::nameParts() {
    setAccessibleName(tr("Compare"));
    nameSecond();
    m_plot->setAccessibleName(tr("Curves of the compared runs"));
    m_legend->setAccessibleName(tr("Legend of quantities and runs"));
    m_notice->setAccessibleName(tr("State of the comparison"));
    m_values->setAccessibleName(tr("Values under the mouse"));
    m_list->setAccessibleName(tr("Runs; a check mark lays one over the present run"));
    m_table->setAccessibleName(tr("Inputs and results that differ"));
    m_empty->setAccessibleName(tr("What to do"));
    m_zone->setAccessibleName(tr("Zone or section whose curves are drawn"));
    m_zone->setToolTip(m_zone->accessibleName());
    m_axis->setAccessibleName(tr("Horizontal axis"));
    m_axis->setToolTip(m_axis->accessibleName());
    const auto name = [](QAction* action, const QString& text, const QString& tip) {
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        action->setText(text);
        action->setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys));
    };
    name(m_keep, tr("Keep the present run"),
         tr("Keep the present run: its inputs and results, for comparison"));
    name(m_restore, tr("Restore the inputs"),
         tr("Take the inputs of the selected run in place of the present ones; the kept runs "
            "stay"));
    name(m_rename, tr("Rename"), tr("Rename the selected run"));
    name(m_delete, tr("Delete"), tr("Delete the selected run"));
    m_keepHere->setText(tr("Keep the present run"));
}

} // namespace sparkout
