// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stage_model.h"

#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/study/stage_edits.h"
#include "ui/inputs/column_header.h"
#include "ui/session/document.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace sparkout {

QString percentText(double share) {
    const double percent = share * 100;
    const bool small = percent > 0 && percent < 0.95;
    return QLocale().toString(percent, 'f', small ? 1 : 0) + QStringLiteral("\u00a0%");
}

namespace {

/// Three digits, never an exponent.
QString timeText(double time_s) {
    return printedNumber(time_s < 1000 ? time_s : std::round(time_s), time_s < 1000 ? 3 : 15);
}

/// A stage of a spark-out becomes one that feeds.
void setFeeding(Stage& stage, const Operation& operation) {
    stage.dropSparkOut();
    auto& feed = stage.*operation->radial().value;
    feed = feed.value_or(operation->usualRadial);
}

} // namespace

StageModel::StageModel(std::string path, const Field& list, Document& document)
    : ListModel(std::move(path), list, document) {
    update(true); // updates the visible columns
}

bool StageModel::shows(const Field& column) const {
    return std::string_view(column.key) != "continuous_feed_mm_min"
           || statesContinuousInfeed(document().project());
}

const Stage& StageModel::stage(const QModelIndex& index) const {
    return document().project().cycle->stages[std::size_t(index.row())];
}

bool StageModel::relevant(const QModelIndex& index) const {
    if (field(index).kind == Kind::countOrWord) {
        return index.row() == rowCount() - 1 || !stage(index).feeds();
    }
    return ListModel::relevant(index);
}

void StageModel::setSparkOut(const QModelIndex& index, Stage edited) {
    Project project = document().project();
    Stage& to = project.cycle->stages[std::size_t(index.row())];
    const Stage before = std::exchange(to, std::move(edited));
    if (!to.feeds() && before.feeds()) { // a spark-out has no infeed
        to.radial_feed_mm.reset();
        to.radial_feed_mm_min.reset();
        to.continuous_feed_mm_min.reset();
    } else if (to.feeds() && !before.feeds()) {
        const Project begun = document().beforeEditsOf(QString::fromStdString(path(index)));
        const auto& started = begun.cycle->stages;
        if (std::size_t(index.row()) < started.size()) { // restores values removed by this edit
            to.radial_feed_mm = started[std::size_t(index.row())].radial_feed_mm;
            to.radial_feed_mm_min = started[std::size_t(index.row())].radial_feed_mm_min;
            to.continuous_feed_mm_min = started[std::size_t(index.row())].continuous_feed_mm_min;
        }
        auto& feed = to.*project.operation->radial().value;
        feed = feed.value_or(project.operation->usualRadial);
    }
    document().edit(std::move(project), {"Input", field(index).label},
                    QString::fromStdString(path(index)));
}

std::size_t StageModel::lastRowsKept(const std::vector<const Field*>& given) const {
    const auto& stages = document().project().cycle->stages;
    const bool said = std::ranges::any_of(
        given, [](const Field* field) { return field->kind == Kind::countOrWord; });
    return !said && !stages.empty() && !stages.back().feeds() ? 1 : 0;
}

void StageModel::resizeRows(Project& project, std::size_t rows, std::size_t last) const {
    auto& stages = project.cycle->stages;
    const auto end = [&] { return stages.end() - std::ptrdiff_t(last); };
    if (rows < stages.size()) {
        stages.erase(end() - std::ptrdiff_t(stages.size() - rows), end());
    }
    while (stages.size() < rows) {
        const std::size_t at = stages.size() - last;
        Stage added = at > 0 ? stages[at - 1] : Stage{};
        if (!added.feeds() || at == 0) {
            setFeeding(added, project.operation);
        }
        stages.insert(end(), added);
    }
}

QString StageModel::takeText(Project& project, int row, const Field& column,
                             const QString& text) const {
    if (column.kind == Kind::countOrWord) {
        return takeSparkOut(project, std::size_t(row), column, text);
    }
    const auto feed = feedFromForm(project, column, text.toStdString());
    return ListModel::takeText(project, row, column, feed ? showNumber(*feed, QLocale::c()) : text);
}

QString StageModel::takeSparkOut(Project& project, std::size_t row, const Field& column,
                                 const QString& text) const {
    Stage& stage = project.cycle->stages[row];
    const QString said = text.simplified();
    const auto isWord = [&said](const QString& word) {
        return said.compare(word, Qt::CaseInsensitive) == 0;
    };
    if (said.isEmpty() || said == QStringLiteral("—") || isWord(tr("none"))) {
        if (!stage.feeds()) {
            setFeeding(stage, project.operation);
        }
        return {};
    }
    static const QRegularExpression counted(QStringLiteral("^(\\S+)(?: \\D+)?$"));
    const std::optional<double> count = pastedNumber(counted.match(said).captured(1));
    const bool isCount = count && *count == std::floor(*count) && column.hard.contains(*count);
    if (!isCount && !isWord(tr("until size"))) {
        return tr("spark-out “%1” is invalid; allowed: %2, “%3”, “%4”")
            .arg(text, rangeShown(column.hard, ""), tr("none"), tr("until size"));
    }
    if (row + 1 != project.cycle->stages.size()) {
        return tr("“%1”: only the last stage may spark out").arg(text);
    }
    isCount ? stage.sparkOutFor(int(*count)) : stage.sparkOutUntilSize();
    stage.radial_feed_mm.reset(); // a spark-out has no infeed
    stage.radial_feed_mm_min.reset();
    stage.continuous_feed_mm_min.reset();
    return {};
}

QString StageModel::valueShown(const QModelIndex& index) const {
    if (field(index).kind != Kind::countOrWord) {
        return ListModel::valueShown(index);
    }
    const std::optional<int> steps = stage(index).sparkOutSteps();
    if (!steps) {
        return stage(index).feeds() ? tr("none") : tr("until size");
    }
    return document().project().operation->travels ? tr("%n double strokes", nullptr, *steps)
                                                   : tr("%n revolutions", nullptr, *steps);
}

void StageModel::setOutcome(const OutcomePtr& outcome) {
    m_stale = !outcome->ran();
    if (outcome->ran()) {
        m_run = outcome;
    }
    if (rowCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
}

void StageModel::forgetOutcome() {
    m_run.reset();
    if (rowCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
}

bool StageModel::isStock(const QModelIndex& index) const {
    return isField(index) && std::string_view(field(index).key) == "stock_mm";
}

bool StageModel::known(int row) const {
    return m_run && m_run->result.timeByStage_s.size() == std::size_t(rowCount())
           && m_run->result.project.cycle->stages.size() == std::size_t(rowCount()) && row >= 0;
}

/// A stage's share of the part's stock: the first one gets the remainder of the later ones
/// [MODEL-7].
double StageModel::stockShare(int row) const {
    const Project& project = m_run->result.project;
    const auto& stages = project.cycle->stages;
    double later = 0;
    for (std::size_t i = 1; i < stages.size(); ++i) {
        later += stages[i].stock_mm;
    }
    const double own =
        row == 0 ? project.part->stock_mm - later : stages[std::size_t(row)].stock_mm;
    return std::clamp(own / project.part->stock_mm, 0.0, 1.0);
}

double StageModel::timeShare(int row) const {
    const double time_s = m_run->result.time_s;
    return time_s > 0 ? m_run->result.timeByStage_s[std::size_t(row)] / time_s : 0;
}

QStringList StageModel::formsOf(const QModelIndex& index) const {
    constexpr int digits = 2;
    if (!index.isValid() || !isField(index) || !relevant(index) || access(index) == Access::hidden
        || remark(index).mark != Mark::none) {
        return {};
    }
    if (const Kind kind = field(index).kind; kind != Kind::number && kind != Kind::optionalNumber) {
        return {}; // the spark-out
    }
    const auto value = number(index);
    const auto forms = value ? feedForms(document().project(), field(index), *value) : std::nullopt;
    if (!forms) {
        return {};
    }
    QStringList all{tr("%1 mm/rev").arg(printedNumber(forms->perRevolution_mm, digits))};
    if (forms->ofWidth) {
        all << tr("%1 B", "share of the wheel's width").arg(printedNumber(*forms->ofWidth, digits));
    }
    return all;
}

QVariant StageModel::data(const QModelIndex& index, int role) const {
    if (role == staleRole) {
        return m_stale;
    }
    if (role == formRole) {
        const QStringList forms = formsOf(index);
        return forms.isEmpty() ? QVariant() : QVariant(forms.last());
    }
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
        const QStringList forms = formsOf(index);
        const QString text = ListModel::data(index, role).toString();
        return forms.isEmpty() ? ListModel::data(index, role)
               : role == Qt::ToolTipRole
                   ? text
                         + QStringLiteral("<p>= %1</p><p>%2</p>")
                               .arg(forms.join(QStringLiteral(" = ")),
                                    forms.size() > 1 ? tr("12 mm/rev or 0.3B may also be typed.")
                                                     : tr("0.005 mm/rev may also be typed."))
                   : text + QStringLiteral(", ") + forms.join(QStringLiteral(", "));
    }
    if (role != shareRole || !known(index.row())) {
        return role == shareRole ? QVariant() : ListModel::data(index, role);
    }
    if (isStock(index)) {
        return stockShare(index.row());
    }
    return isField(index) ? QVariant() : QVariant(timeShare(index.row()));
}

QVariant StageModel::resultData(const QModelIndex& index, int role) const {
    const bool has = known(index.row());
    const QString time =
        has ? timeText(m_run->result.timeByStage_s[std::size_t(index.row())]) : QString();
    switch (role) {
    case Qt::DisplayRole: return has ? time : QStringLiteral("—");
    case Qt::TextAlignmentRole: return int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ForegroundRole:
        return m_stale || !has
                   ? QVariant(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text))
                   : QVariant();
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return has ? tr("Stage %1: %2 s, %3 of the machining time")
                         .arg(QString::number(index.row() + 1), time,
                              percentText(timeShare(index.row())))
                   : QVariant();
    default: return {};
    }
}

QVariant StageModel::resultHeader(int, int role) const {
    switch (role) {
    case Qt::DisplayRole:
    case ColumnHeader::markupRole: return tr("Time, s");
    case Qt::ToolTipRole: return tr("Machining time of the stage and its share of the cycle's.");
    default: return {};
    }
}

} // namespace sparkout
