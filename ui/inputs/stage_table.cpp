// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stage_table.h"

#include "core/project/cycle.h"
#include "core/study/stage_edits.h"
#include "core/study/starting_project.h"
#include "core/units.h"
#include "ui/inputs/form_metrics.h"
#include "ui/inputs/row_sliders.h"
#include "ui/inputs/stage_delegate.h"
#include "ui/inputs/stage_model.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/session/document.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QTableView>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

const std::string stagesPath = "/cycle/stages";

const Field& stagesField() {
    return *tableOf<Cycle>().find("stages");
}

} // namespace

StageTable::StageTable(Document& document, QWidget* parent)
    : StageTable(document, new StageModel(stagesPath, stagesField(), document), parent) {}

StageTable::StageTable(Document& document, StageModel* model, QWidget* parent)
    : ListTable(stagesPath, stagesField(), document, model, new StageDelegate(document), parent)
    , m_stages(model)
    , m_continuous(new QCheckBox(this))
    , m_sparkOut(new QPushButton(this))
    , m_start(new QPushButton(this))
    , m_fit(new QPushButton(this))
    , m_follows(new QLabel(this)) {
    m_follows->setObjectName(QStringLiteral("followsDrawing"));
    m_follows->setTextFormat(Qt::PlainText);
    m_follows->setWordWrap(true);
    setRelativeFont(*m_follows, noteType);
    layout()->addWidget(m_follows);
    connect(&document, &Document::changed, this, &StageTable::showFollows);
    connect(&document, &Document::projectReplaced, this, [this] { m_hasFollowed = false; });
    m_sparkOut->setObjectName(QStringLiteral("addSparkOut"));
    m_sparkOut->setAutoDefault(false);
    layout()->addWidget(m_sparkOut);
    connect(m_sparkOut, &QPushButton::clicked, this, &StageTable::addSparkOut);
    connect(&document, &Document::changed, this, &StageTable::showSparkOut);
    m_continuous->setObjectName(QStringLiteral("continuousInfeed"));
    layout()->addWidget(m_continuous);
    connect(m_continuous, &QCheckBox::clicked, this, &StageTable::setContinuous);
    connect(&document, &Document::changed, this, &StageTable::showContinuous);
    m_start->setObjectName(QStringLiteral("startingCycle"));
    m_start->setAutoDefault(false);
    layout()->addWidget(m_start);
    connect(m_start, &QPushButton::clicked, this, [this] {
        apply(withStartingCycle(this->document().project()),
              {"Edit", QT_TRANSLATE_NOOP("Edit", "Starting cycle")}, 0);
    });
    m_fit->setObjectName(QStringLiteral("fitStocks"));
    m_fit->setAutoDefault(false);
    layout()->addWidget(m_fit);
    connect(m_fit, &QPushButton::clicked, this, [this] {
        view().setFocus(); // the button disappears
        StockFit::apply(this->document());
    });
    connect(&document, &Document::changed, this, &StageTable::showFit);
    setHelpTopic(*this, QStringLiteral("stages"));
    StageTable::fitRows();
    view().setWordWrap(true); // a spark-out takes two lines
    showTitleBold();
    StageTable::retranslate();
}

void StageTable::retranslate() {
    ListTable::retranslate();
    m_continuous->setText(tr("Continuous infeed"));
    m_continuous->setToolTip(QStringLiteral("<p>%1</p>")
                                 .arg(tr("The wheel is fed continuously while the table travels; "
                                         "each stage has a column for it.")));
    m_sparkOut->setText(tr("+ Spark-out"));
    m_sparkOut->setToolTip(tr("Adds a spark-out after the last feed; the stocks stay as they are"));
    m_sparkOut->setAccessibleDescription(m_sparkOut->toolTip());
    m_start->setText(tr("Starting cycle"));
    m_start->setToolTip(
        QStringLiteral("<p>%1</p>")
            .arg(tr("Work speed, feeds, stocks, spark-out, overruns and dwells as a shop would "
                    "first set them for this part, wheel and machine; an estimate")));
    m_start->setAccessibleDescription(m_start->toolTip());
    m_follows->setAccessibleName(tr("Whether the cycle follows the drawing"));
    showFollows();
    showSparkOut();
    showContinuous();
    showFit();
}

/// Shows whether the cycle follows the drawing, or that it no longer does.
void StageTable::showFollows() {
    const bool follows = document().followsDrawing();
    m_hasFollowed = m_hasFollowed || follows;
    m_follows->setText(
        follows ? joined({tr("A starting cycle: it follows the drawing, material, wheel and "
                             "machine until any other input is edited."),
                          roughDepthText(), wheelText()},
                         QStringLiteral(" "))
        : m_hasFollowed && document().newFaults().empty()
            ? tr("Edited: the cycle no longer follows the drawing. “%1” creates a new one.")
                  .arg(m_start->text())
            : QString());
    m_follows->setVisible(!m_follows->text().isEmpty());
}

/// Which depth of cut the starting cycle roughs with, and what limits it; empty without one.
QString StageTable::roughDepthText() const {
    const StartingCycle* start = document().followingCycle();
    if (!start) {
        return {};
    }
    const auto shown = [](double depth_mm) {
        constexpr int digits = 2;
        return printedNumber(depth_mm * units::umPerMm, digits) + u'\u00a0' + unitText("µm");
    };
    const QString depth = shown(start->roughDepth_mm), usual = shown(start->usualDepth_mm);
    if (start->bound == RoughBound::table) {
        return tr("Its rough depth of cut is the usual one, %1.").arg(depth);
    }
    const QString bound =
        QCoreApplication::translate("StartingCycle", roughBoundText(start->bound));
    return (start->isExceeded ? tr("Its rough depth of cut, %1, is the machine's minimum and more "
                                   "than %2 allows; usual: %3.")
                              : tr("Its rough depth of cut, %1, is limited by %2; usual: %3."))
        .arg(depth, bound, usual);
}

/// The wheel that suits the required Ra better; empty where the part's own does, or without a
/// starting cycle.
QString StageTable::wheelText() const {
    const Issues advice =
        document().followingCycle() ? wheelAdvice(document().project()) : Issues();
    return advice.empty() ? QString() : tr("Wheel: %1.").arg(issueText(advice.front()));
}

void StageTable::showSparkOut() {
    const std::vector<Stage>& stages = document().project().cycle->stages;
    m_sparkOut->setVisible(!stages.empty() && stages.back().feeds());
}

void StageTable::addSparkOut() {
    const Project& project = document().project();
    view().setFocus(); // the button disappears
    apply(withSparkOutAfter(project, usualSparkOut(project)),
          {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a spark-out")},
          static_cast<int>(project.cycle->stages.size()));
}

void StageTable::showContinuous() {
    const Project& project = document().project();
    m_continuous->setVisible(project.operation->travels);
    m_continuous->setChecked(statesContinuousInfeed(project));
}

void StageTable::setContinuous(bool stated) {
    apply(withContinuousInfeed(document().project(), stated),
          {"Edit", QT_TRANSLATE_NOOP("Edit", "Continuous infeed")}, std::max(0, currentRow()));
}

void StageTable::showFit() {
    const QString text = StockFit::text(document());
    // In two lines, since the page is narrow.
    m_fit->setText(QString(text)
                       .replace(QStringLiteral(": "), QStringLiteral(":\n"))
                       .replace(QStringLiteral(", "), QStringLiteral(",\n")));
    m_fit->setAccessibleName(text.isEmpty() ? tr("Fit the stocks") : text);
    m_fit->setVisible(!text.isEmpty());
}

void StageTable::fitRows() {
    setRowHeight(StageDelegate::rowHeight(view().fontMetrics()));
}

void StageTable::setOutcome(const OutcomePtr& outcome) {
    m_stages->setOutcome(outcome);
}

void StageTable::applyStages(std::vector<Stage> stages, EditText text, int selected) {
    Project project = document().project();
    project.cycle->stages = std::move(stages);
    apply(std::move(project), text, selected);
}

void StageTable::forgetResults() {
    m_stages->forgetOutcome();
}

void StageTable::setAccess(const FormAccessPtr& access) {
    ListTable::setAccess(access);
    m_continuous->setEnabled(mayHaveOtherRows());
    m_sparkOut->setEnabled(mayHaveOtherRows());
    m_start->setEnabled(mayHaveOtherRows());
    m_fit->setEnabled(mayHaveOtherRows());
}

void StageTable::addRow() {
    auto stages = document().project().cycle->stages;
    if (stages.empty()) {
        applyStages({Stage{}}, {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a stage")}, 0);
        return;
    }
    // The new stage shares the stock of the one before it; before a spark-out, of the one that it
    // precedes.
    auto at = static_cast<std::size_t>(std::max(0, currentRow()));
    const bool beforeSparkOut = !stages[at].feeds();
    if (beforeSparkOut && at > 0) {
        --at;
    }
    if (!stages[at].feeds()) {
        Stage added = stages[at];
        added.dropSparkOut();
        const Operation& operation = document().project().operation;
        added.*operation->radial().value = operation->usualRadial;
        stages.insert(stages.begin(), added);
        applyStages(std::move(stages), {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a stage")}, 0);
        return;
    }
    apply(withStageAfter(document().project(), at),
          {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a stage")}, static_cast<int>(at) + 1);
}

void StageTable::removeRow() {
    auto stages = document().project().cycle->stages;
    const int at = currentRow();
    if (at < 0 || stages.size() < 2) {
        return;
    }
    const auto index = static_cast<std::size_t>(at);
    Stage& heir = stages[index > 0 ? index - 1 : 1]; // keeps the sum of the stocks
    heir.stock_mm = tidyStock(heir.stock_mm + stages[index].stock_mm);
    stages.erase(stages.begin() + at);
    applyStages(std::move(stages), {"Edit", QT_TRANSLATE_NOOP("Edit", "Remove a stage")},
                std::min(at, static_cast<int>(stages.size()) - 1));
}

void StageTable::clearCell() {
    const QModelIndex cell = view().currentIndex();
    if (!m_stages->isField(cell) || m_stages->field(cell).kind != Kind::countOrWord) {
        ListTable::clearCell();
    } else if (m_stages->flags(cell) & Qt::ItemIsEditable) {
        m_stages->accept(cell);
        Stage stage = m_stages->stage(cell);
        stage.dropSparkOut();
        m_stages->setSparkOut(cell, std::move(stage));
        document().endMerge();
    }
}

bool StageTable::canMove(int by) const {
    const auto& stages = document().project().cycle->stages;
    const int from = currentRow();
    const int to = from + by;
    const int count = static_cast<int>(stages.size());
    return from >= 0 && to >= 0 && to < count && stages[std::size_t(from)].feeds()
           && stages[std::size_t(to)].feeds();
}

void StageTable::moveRow(int by) {
    if (!canMove(by)) {
        return;
    }
    auto stages = document().project().cycle->stages;
    const int from = currentRow();
    std::swap(stages[std::size_t(from)], stages[std::size_t(from + by)]);
    applyStages(std::move(stages), {"Edit", QT_TRANSLATE_NOOP("Edit", "Move a stage")}, from + by);
}

bool StageTable::canRemove() const {
    return rows() > 1 && currentRow() >= 0;
}

ListTable::Texts StageTable::texts() const {
    return {tr("Stages"),           tr("Stages of the cycle"), tr("Add a stage"),
            tr("Remove the stage"), tr("Move the stage up"),   tr("Move the stage down")};
}

} // namespace sparkout
