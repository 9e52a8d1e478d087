// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the view of the constraints: building and connecting.
#include "ui/charts/margin_model.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/metrics.h"
#include "ui/kit/tool_row.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_tools.h"
#include "ui/text/limit_names.h"
#include "ui/views/constraints/constraints_plot.h"
#include "ui/views/constraints/constraints_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

namespace sparkout {

namespace {
constexpr int plotShare = 340, lowerShare = 200; ///< of the height at first
constexpr int tableShare = 450, sheetShare = 220;
} // namespace

ConstraintsView::ConstraintsView(QWidget* parent, Settings* settings)
    : View(parent)
    , m_plot(new ConstraintsPlot(this))
    , m_legend(new LegendStrip(this))
    , m_zone(new QComboBox(this))
    , m_logarithmic(new QCheckBox(this))
    , m_places(new QCheckBox(this))
    , m_splitter(new QSplitter(Qt::Vertical, this))
    , m_model(new MarginModel(this))
    , m_sheet(new QPlainTextEdit(this))
    , m_goTo(new QPushButton(this))
    , m_notice(new QLabel(this))
    , m_off(new QLabel(this))
    , m_values(new QLabel(this)) {
    setObjectName(QStringLiteral("constraints"));
    build(settings);
    m_logarithmic->setChecked(true); // far limits and the last cuts in one picture
    m_plot->setLogarithmic(true);
    connectParts();
    built();
}

void ConstraintsView::build(Settings* settings) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    auto* bar = new QWidget(this);
    buildTools(bar, settings);
    setUpNotice(*m_notice);
    setUpReadout(*m_values, 3);
    m_off->setWordWrap(true);
    m_off->setTextFormat(Qt::RichText);
    m_off->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    m_plot->setMinimumSize(240, 140);
    auto* upper = new QWidget(m_splitter);
    auto* curves = new QVBoxLayout(upper);
    curves->setContentsMargins(0, 0, 0, 0);
    curves->setSpacing(metrics::tight);
    curves->addWidget(m_plot, 1);
    curves->addWidget(m_strip);
    curves->addWidget(m_values);
    auto* lower = new QSplitter(Qt::Horizontal, m_splitter);
    lower->addWidget(buildMargins());
    const auto project = [this] {
        return m_good ? QString::fromStdString(m_good->result.project.title).simplified()
                      : QString();
    };
    m_table->setSaving([this] { return m_model->table(); }, project, settings);
    lower->addWidget(buildSheet());
    lower->setChildrenCollapsible(false);
    lower->setSizes({tableShare, sheetShare});
    m_splitter->addWidget(upper);
    m_splitter->addWidget(lower);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setStretchFactor(0, plotShare);
    m_splitter->setStretchFactor(1, lowerShare);
    m_splitter->setSizes({plotShare, lowerShare});
    layout->addWidget(bar);
    layout->addWidget(m_notice);
    layout->addWidget(m_legend);
    layout->addWidget(m_splitter, 1);
    layout->addWidget(m_off);
    const std::pair<QWidget*, const char*> names[] = {
        {m_plot, "constraintsPlot"},     {m_legend, "constraintsLegend"},
        {m_zone, "constraintsZone"},     {m_logarithmic, "logarithmic"},
        {m_places, "everyPlace"},        {m_table, "margins"},
        {m_sheet, "formulaSheet"},       {m_goTo, "showWhere"},
        {m_notice, "constraintsNotice"}, {m_off, "limitsOff"},
        {m_values, "constraintsValues"},
    };
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

void ConstraintsView::buildTools(QWidget* bar, Settings* settings) {
    PlotSubject subject;
    subject.heading = [this] {
        QStringList heading{title()};
        if (m_good) {
            const int group = m_plot->group();
            heading << QString::fromStdString(m_good->result.project.title).simplified()
                    << (group >= 0 ? LimitNames::group(
                            m_good->limits.groups[static_cast<std::size_t>(group)])
                                   : QString());
        }
        heading.removeAll(QString());
        return heading;
    };
    subject.legend = [this] { return m_plot->legendEntries(); };
    subject.table = [this] { return m_plot->table(); };
    subject.restyle = [this] { m_plot->restyle(); };
    subject.navigation.fit = [this] { m_plot->fit(); };
    m_tools = new PlotTools(*m_plot, std::move(subject));
    m_tools->setSettings(settings);
    m_cursors = new PlotCursors(*m_plot, m_plot->cursorSubject());
    m_strip = new CursorStrip(*m_cursors, this);
    m_tools->addTool(m_cursors->toggle);
    m_zone->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_zone);
    row->addStretch(1);
    row->addWidget(m_logarithmic);
    row->addWidget(PlotTools::button(m_cursors->toggle, bar));
    row->addWidget(PlotTools::button(m_tools->back, bar));
    row->addWidget(PlotTools::button(m_tools->forward, bar));
    row->addWidget(PlotTools::button(m_tools->fit, bar));
    row->addWidget(m_tools->exportButton(bar));
}

QWidget* ConstraintsView::buildMargins() {
    m_table = new CopyTable([this] { return m_model->asTsv(); }, this);
    m_table->setModel(m_model);
    m_table->setItemDelegateForColumn(MarginModel::usage, new MarginBar(m_table));
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded); // with large type
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setIconSize(QSize(metrics::iconSmall, metrics::iconSmall));
    m_table->setWordWrap(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    QHeaderView* header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(MarginModel::requirement, QHeaderView::Stretch);
    // In a narrower column names wrap; asked for when all columns have their widths.
    connect(
        header, &QHeaderView::sectionResized, m_table, [this] { m_table->resizeRowsToContents(); },
        Qt::QueuedConnection);
    return m_table;
}

QWidget* ConstraintsView::buildSheet() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    m_sheet->setReadOnly(true);
    m_sheet->setTabChangesFocus(true);
    auto* row = new ToolRow;
    row->addWidget(m_goTo);
    row->addStretch(1);
    row->addWidget(m_places);
    column->addWidget(m_sheet, 1);
    column->addLayout(row);
    return box;
}

void ConstraintsView::connectParts() {
    connect(m_plot, &ConstraintsPlot::contentChanged, this,
            [this] { m_legend->setEntries(m_plot->legendEntries()); });
    connect(m_plot, &ConstraintsPlot::pointed, this, &ConstraintsView::readOut);
    connect(m_legend, &LegendStrip::toggled, m_plot, &ConstraintsPlot::toggleCurve);
    connect(m_legend, &LegendStrip::onlyAsked, m_plot, &ConstraintsPlot::showOnly);
    connect(m_zone, &QComboBox::currentIndexChanged, this, [this](int group) {
        if (m_good && group >= 0) {
            m_group = keyOf(m_good->limits.groups[static_cast<std::size_t>(group)]);
            showGroup(group);
            m_plot->replot();
            m_tools->navigation().noteView();
        }
    });
    connect(m_logarithmic, &QCheckBox::toggled, this, [this](bool on) {
        m_plot->setLogarithmic(on);
        m_plot->replot();
        m_tools->navigation().forgetViews(); // ranges of the other scale
    });
    connect(m_places, &QCheckBox::toggled, this, [this](bool all) {
        m_model->setAllPlaces(all);
        selectChosen();
        m_plot->replot();
        showSheet();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (now.isValid()) {
                    choose(now.row());
                }
            });
    const auto enter = [this] {
        if (const auto requirement = chosen()) {
            emit requirementEntered(*requirement);
        }
    };
    connect(m_table, &CopyTable::rowEntered, this, enter);
    connect(m_goTo, &QPushButton::clicked, this, enter);
    connect(m_off, &QLabel::linkActivated, this,
            [this](const QString& path) { emit pathAsked(path.toStdString()); });
}

} // namespace sparkout
