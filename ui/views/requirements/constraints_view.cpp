// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/requirements/constraints_view.h"

#include "ui/chart/legend.h"
#include "ui/chart/plot_cursors.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/tool_row.h"
#include "ui/results/margin_model.h"
#include "ui/results/verdict_table.h"
#include "ui/text/calibration_text.h"
#include "ui/text/formula_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/requirements/constraints_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTextDocument>
#include <QTextEdit>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int plotShare = 340, lowerShare = 200; ///< initial shares of the height
constexpr int tableShare = 480, sheetShare = 190;
// Least widths of the margins' table, at the usual font size.
constexpr int leastColumn = 60, wideTable = 400, leastTable = 110, leastSheet = 66;
constexpr int bothBeside = 440; ///< table and formulas side by side
constexpr int leastPlot = 150;  ///< least height at the usual font size

/// Formats indices; puts numbers and result of a formula on lines of their own.
QString sheetHtml(const QString& text) {
    const QString equals = QStringLiteral(" = ");
    QStringList lines;
    for (const QString& line : text.split(u'\n')) {
        const QStringList parts = withIndices(line).split(equals);
        lines << parts.mid(0, 2).join(equals);
        for (const QString& part : parts.mid(2)) {
            lines << QStringLiteral("&nbsp;&nbsp;= ") + part;
        }
    }
    return lines.join(QStringLiteral("<br>"));
}

} // namespace

ConstraintsView::ConstraintsView(QWidget* parent, Settings* settings)
    : PlotView(QStringLiteral("constraints"), parent, settings)
    , m_plot(new ConstraintsPlot(this))
    , m_zone(new QComboBox(this))
    , m_logarithmic(new QCheckBox(this))
    , m_places(new QCheckBox(this))
    , m_splitter(new QSplitter(Qt::Vertical, this))
    , m_model(new MarginModel(this))
    , m_sheet(new QTextEdit(this))
    , m_goTo(new QPushButton(this))
    , m_off(new QLabel(this)) {
    addPlot(*m_plot);
    addCursors(*m_plot);
    hideUntilDrawn({m_plot});
    disableUntilDrawn({m_zone, m_logarithmic});
    build();
    m_logarithmic->setChecked(true); // far limits and the last cuts in one picture
    m_plot->setLogarithmic(true);
    connectParts();
    built();
}

void ConstraintsView::build() {
    setUpReadout(*values(), 4);
    m_off->setWordWrap(true);
    m_off->setTextFormat(Qt::RichText);
    m_off->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    m_plot->setMinimumWidth(240);
    setTextMinimumHeight(*m_plot, leastPlot);
    QWidget* upper = buildCurves();
    m_lower = new QSplitter(Qt::Horizontal, m_splitter);
    m_lower->addWidget(buildMargins());
    m_lower->addWidget(buildSheet());
    m_lower->setChildrenCollapsible(false);
    m_lower->setSizes({tableShare, sheetShare});
    share(*m_splitter, {{upper, plotShare}, {m_lower, lowerShare}});
    auto* content = new QWidget(this); // scrolls if curves and table do not fit
    auto* column = rowIn<QVBoxLayout>(content);
    column->addWidget(legend());
    column->addWidget(m_splitter, 1);
    column->addWidget(m_off);
    QScrollArea* area = scrolled(*content);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setObjectName(QStringLiteral("constraintsArea"));
    addColumn({buildTools(), notice(), area}, area)->addStretch();
    nameObjects({{m_plot, "constraintsPlot"},
                 {m_zone, "constraintsZone"},
                 {m_logarithmic, "logarithmic"},
                 {m_places, "everyPlace"},
                 {m_table, "margins"},
                 {m_sheet, "formulaSheet"},
                 {m_goTo, "showWhere"},
                 {m_off, "limitsOff"}});
}

QWidget* ConstraintsView::buildTools() {
    auto* bar = new QWidget(this);
    auto* row = rowIn<ToolRow>(bar);
    addBoxes(*row, {m_zone});
    row->addStretch(1);
    row->addWidget(m_logarithmic);
    addButtons(*row, {cursors()->toggle, tools()->back, tools()->forward, tools()->fit});
    return bar;
}

QWidget* ConstraintsView::buildCurves() {
    auto* box = new QWidget(m_splitter);
    auto* curves = rowIn<QVBoxLayout>(box);
    curves->addWidget(m_plot, 1);
    curves->addWidget(strip());
    curves->addWidget(values());
    return box;
}

QWidget* ConstraintsView::buildMargins() {
    m_table = addTable(
        *m_model, [this] { return m_model->table(); }, [this] { return m_model->asTsv(); });
    m_table->setItemDelegateForColumn(MarginModel::requirement, new MarginName(m_table));
    m_table->setItemDelegateForColumn(MarginModel::usage, new MarginBar(m_table));
    connect(m_table, &CopyTable::resized, this,
            [this] { m_model->setStacked(m_table->viewport()->width() < atFontSize(wideTable)); });
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    setTextMinimumHeight(*m_table, leastTable);
    m_table->verticalHeader()->hide();
    QHeaderView* header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(MarginModel::requirement, QHeaderView::Stretch);
    // Names wrap in a narrower column; requested when all columns have their widths.
    connect(
        header, &QHeaderView::sectionResized, m_table, [this] { m_table->resizeRowsToContents(); },
        Qt::QueuedConnection);
    return m_table;
}

/// Side by side, the table and the formulas would both be too narrow.
void ConstraintsView::resizeEvent(QResizeEvent* event) {
    PlotView::resizeEvent(event);
    const bool isNarrow = width() < atFontSize(bothBeside);
    m_lower->setOrientation(isNarrow ? Qt::Vertical : Qt::Horizontal);
}

QWidget* ConstraintsView::buildSheet() {
    auto* box = new QWidget(this);
    auto* column = rowIn<QVBoxLayout>(box);
    setTextMinimumHeight(*m_sheet, leastSheet);
    m_sheet->setReadOnly(true);
    m_sheet->document()->setDocumentMargin(metrics::hair); // avoids a scroll bar for the margin
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
    connect(m_zone, &QComboBox::currentIndexChanged, this, [this](int group) {
        if (good() && group >= 0) {
            m_group = keyOf(good()->limits.groups[static_cast<std::size_t>(group)]);
            showGroup(group);
            m_plot->replot();
            tools()->navigation().noteView();
        }
    });
    connect(m_logarithmic, &QCheckBox::toggled, this, [this](bool on) {
        m_plot->setLogarithmic(on);
        m_plot->replot();
        tools()->navigation().forgetViews(); // they are ranges of the other scale
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

QString ConstraintsView::title() const {
    return tr("Constraints");
}

void ConstraintsView::dropStudies() {
    m_plot->fitNext();
}

void ConstraintsView::takeOutcome(const OutcomePtr& before) {
    if (hasOtherPlaces(before)) {
        m_group.reset();
        m_chosen.reset();
        m_plot->fitNext();
    }
    m_model->setOutcome(good());
    fillGroups();
    showGroup(wantedGroup());
    selectChosen();
    showSheet();
}

/// Without rows and zones nothing can be selected.
void ConstraintsView::dropOutcome() {
    m_group.reset();
    m_chosen.reset();
    m_model->setOutcome(nullptr);
    fillGroups();
    m_plot->setRun(nullptr, -1);
    m_plot->setMarked(std::nullopt);
    showSheet();
}

// --- zones --------------------------------------------------------------------------------------

void ConstraintsView::fillGroups() {
    const QSignalBlocker blocker(m_zone);
    const int current = m_zone->currentIndex();
    m_zone->clear();
    if (!good()) {
        return;
    }
    const bool limited = limitsGroups(good()->limits, good()->result.project);
    for (const LimitGroup& group : good()->limits.groups) {
        const QString name = LimitNames::group(group);
        m_zone->addItem(limited ? tr("%1 — %2").arg(name, LimitNames::percent(group.worst.usage))
                                : name);
    }
    m_zone->setCurrentIndex(std::min(current, m_zone->count() - 1));
}

ConstraintsView::GroupKey ConstraintsView::keyOf(const LimitGroup& group) {
    return {group.zone, group.section, group.standing};
}

/// The group chosen by the user, otherwise the one nearest to its limit.
int ConstraintsView::wantedGroup() const {
    const auto& groups = good()->limits.groups;
    const auto same = [this](const LimitGroup& group) { return keyOf(group) == m_group; };
    const auto chosen = std::ranges::find_if(groups, same);
    if (chosen != groups.end() || groups.empty()) {
        return groups.empty() ? -1 : static_cast<int>(chosen - groups.begin());
    }
    const auto nearest = [](const LimitGroup& group) {
        return std::pair(group.worst.usage, group.worst.depth_mm);
    };
    return static_cast<int>(std::ranges::max_element(groups, {}, nearest) - groups.begin());
}

void ConstraintsView::followCycle() {
    const CycleCursor* const at = cycleIn(good());
    m_plot->setMoment(at && !at->atEnd()
                          ? stockAt(good()->limits, good()->layers, good()->trajectory,
                                    m_plot->group(), at->progress())
                          : std::nullopt);
}

void ConstraintsView::showGroup(int group) {
    m_plot->setRun(good(), group);
    followCycle();
    const QSignalBlocker blocker(m_zone);
    m_zone->setCurrentIndex(group);
}

// --- requirements -------------------------------------------------------------------------------

/// The selected requirement with the values of this run.
std::optional<ConstraintResult> ConstraintsView::chosen() const {
    const int row = m_chosen ? m_model->rowOf(*m_chosen) : -1;
    return row >= 0 ? std::optional(m_model->at(row)) : std::nullopt;
}

void ConstraintsView::selectChosen() {
    const int row = m_chosen ? m_model->rowOf(*m_chosen) : -1;
    if (row >= 0) {
        const QSignalBlocker blocker(m_table->selectionModel());
        m_table->selectRow(row);
    }
    m_plot->setMarked(chosen());
}

void ConstraintsView::showRequirement(const ConstraintResult& requirement) {
    redraw();
    const int row = good() ? m_model->rowOf(requirement) : -1;
    if (row >= 0) {
        choose(row);
        selectChosen();
    }
}

void ConstraintsView::choose(int row) {
    m_chosen = m_model->at(row);
    if (m_chosen->at || m_chosen->section >= 0) {
        Place place;
        place.zone = m_chosen->zone;
        place.section = std::max(m_chosen->section, 0);
        place = m_chosen->at.value_or(place);
        const int group = limitGroupAt(good()->limits, place);
        if (group >= 0) {
            m_group = keyOf(good()->limits.groups[static_cast<std::size_t>(group)]);
            showGroup(group);
        }
    }
    m_plot->setMarked(m_chosen);
    m_plot->replot();
    tools()->navigation().amendView();
    showSheet();
    emit requirementChosen(*m_chosen);
}

void ConstraintsView::showSheet() {
    const std::optional<ConstraintResult> about = good() ? chosen() : std::nullopt;
    m_goTo->setEnabled(about.has_value());
    QStringList text;
    if (!about) {
        text << tr("Choose a requirement to see where it was worst and how its value arose.");
    } else {
        text << verdict::why(*good(), *about);
        if (text.back().isEmpty()) {
            text.back() = tr("%1, %2: a setting compared with its range.")
                              .arg(Names::constraint(about->kind), Names::where(*about));
        }
        if (const auto sheet = constraintSheet(good()->result, good()->accuracy, *about)) {
            text << QString() << formulaText(*sheet);
            if (const QString names =
                    sourceCoefficients(*sheet, good()->result.project.operation->travels);
                !names.isEmpty()) {
                text << names;
            }
        }
        if (const QString estimates = EstimateNames::behind(good()->result.project, about->kind);
            !estimates.isEmpty()) {
            text << QString() << estimates;
        }
    }
    m_sheet->setHtml(sheetHtml(text.join(u'\n')));
}

// --- texts --------------------------------------------------------------------------------------

bool ConstraintsView::drawn() const {
    return good() && !good()->limits.groups.empty();
}

QString ConstraintsView::remark() const {
    if (!drawn()) {
        return tr("The cycle is too long to be recorded: its cuts are not drawn. Fewer radii or "
                  "sections help; the requirements below apply to the whole cycle.");
    }
    if (!limitsFeed(good()->limits)) {
        return tr("No limit of the feed is active, so any feed is allowed: enter the burn limit of "
                  "the material, or the power of a drive. The links below lead to the fields.");
    }
    if (good()->result.status != RunStatus::completed) {
        return Names::status(good()->result.status);
    }
    return limitsGroups(good()->limits, good()->result.project)
               ? QString()
               : tr("Coupled sections share the power of the drives, so it does not limit the feed "
                    "of a single section. The requirements below apply to the whole length.");
}

void ConstraintsView::showState() {
    PlotView::showState();
    m_off->clear(); // links keep an old palette until the text changes
    m_off->setText(good() ? LimitNames::missingLinks(good()->result.project) : QString());
    m_off->setVisible(good() && !m_off->text().isEmpty());
    m_splitter->setVisible(good() != nullptr);
}

QStringList ConstraintsView::subheading() const {
    const int group = m_plot->group();
    return {group >= 0 ? LimitNames::group(good()->limits.groups[static_cast<std::size_t>(group)])
                       : QString()};
}

void ConstraintsView::nameParts() {
    nameAround(tr("Legend of the curves"), tr("State of the curves"), tr("Values under the mouse"));
    m_plot->setAccessibleName(tr("Actual feed under its limits"));
    m_off->setAccessibleName(tr("Requirements that are not checked"));
    m_table->setAccessibleName(tr("Requirements by the used share of their limit"));
    m_sheet->setAccessibleName(tr("Origin of the value"));
    m_logarithmic->setText(tr("Logarithmic"));
    m_places->setText(tr("Every place"));
    m_goTo->setText(tr("Show where"));
    m_table->retranslate();
    m_table->horizontalHeader()->setMinimumSectionSize(atFontSize(leastColumn));
    tell(*m_zone, tr("Zone or section with the used share of its limit. In a reversal zone, the "
                     "width of cut depends on whether the wheel stands or travels."));
    tell(*m_logarithmic,
         tr("Actual feeds on a logarithmic axis: spark-out and distant limits in one plot"));
    tell(*m_places, tr("Every zone, section and stage; otherwise the worst of each requirement"));
    tell(*m_goTo, tr("Goes to the passes, the profile or the field behind the requirement; also "
                     "Enter or a double click on its row"));
    m_model->retranslate();
    m_model->setIcons(lightIcons(*m_table, false));
    fillGroups();
    showSheet();
}

QString ConstraintsView::hint() const {
    return tr("Point at the curve to read the values.");
}

void ConstraintsView::recolour() {
    m_model->setIcons(lightIcons(*m_table, false));
    PlotView::recolour();
    showState();
}

} // namespace sparkout
