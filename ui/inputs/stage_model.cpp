// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stage_model.h"

#include "ui/inputs/form_row.h"
#include "ui/session/document.h"
#include "ui/session/number_text.h"
#include "ui/session/texts.h"

#include <QGuiApplication>
#include <QPalette>

namespace sparkout {

namespace {

const std::string stagesPath = "/cycle/stages";

} // namespace

StageModel::StageModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document) {
    update(true);
}

std::vector<const Field*> StageModel::relevantColumns() const {
    const StructInfo& table = tableOf<Stage>();
    std::vector<const Field*> columns;
    for (const Field& field : table.fields) {
        if (!field.relevant || field.relevant(m_document.project(), table.defaults)) {
            columns.push_back(&field);
        }
    }
    return columns;
}

int StageModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : m_rows;
}

int StageModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

const Field& StageModel::field(const QModelIndex& index) const {
    return *m_columns[std::size_t(index.column())];
}

const Stage& StageModel::stage(const QModelIndex& index) const {
    return m_document.project().cycle.stages[std::size_t(index.row())];
}

bool StageModel::relevant(const QModelIndex& index) const {
    const Field& row = field(index);
    if (row.kind == Kind::sparkOut) {
        return index.row() == m_rows - 1 || stage(index).spark_out.mode != SparkOut::Mode::none;
    }
    return !row.relevant || row.relevant(m_document.project(), &stage(index));
}

std::optional<double> StageModel::number(const QModelIndex& index) const {
    const Field& row = field(index);
    return row.kind == Kind::number ? std::optional(row.as<double>(&stage(index)))
                                    : row.as<std::optional<double>>(&stage(index));
}

void StageModel::setNumber(const QModelIndex& index, std::optional<double> value) {
    Project project = m_document.project();
    const Field& row = field(index);
    Stage& to = project.cycle.stages[std::size_t(index.row())];
    if (row.kind == Kind::number) {
        row.as<double>(&to) = value.value_or(0);
    } else {
        row.as<std::optional<double>>(&to) = value;
    }
    m_document.edit(std::move(project), {"Input", row.label}, QString::fromStdString(path(index)));
}

void StageModel::setSparkOut(const QModelIndex& index, SparkOut sparkOut) {
    Project project = m_document.project();
    Stage& to = project.cycle.stages[std::size_t(index.row())];
    const Stage before = to;
    to.spark_out = sparkOut;
    const bool feeds = sparkOut.mode == SparkOut::Mode::none;
    if (!feeds) { // a spark-out feeds nothing
        to.radial_feed_mm.reset();
        to.radial_feed_mm_min.reset();
    } else if (before.spark_out.mode != SparkOut::Mode::none) {
        const bool traverse = project.operation == Operation::traverse;
        auto& feed = traverse ? to.radial_feed_mm : to.radial_feed_mm_min;
        feed = feed ? feed : std::optional(traverse ? 0.001 : 0.1);
    }
    m_document.edit(std::move(project), {"Input", field(index).label},
                    QString::fromStdString(path(index)));
}

std::string StageModel::path(const QModelIndex& index) const {
    return stagesPath + "/" + std::to_string(index.row()) + "/" + field(index).key;
}

QModelIndex StageModel::indexAt(const std::string& wanted) const {
    for (int row = 0; row < m_rows; ++row) {
        for (int column = 0; column < columnCount(); ++column) {
            const QModelIndex cell = index(row, column);
            if (path(cell) == wanted) {
                return cell;
            }
        }
        if (wanted.starts_with(stagesPath + "/" + std::to_string(row) + "/")) {
            return index(row, 0);
        }
    }
    return wanted.starts_with(stagesPath) && m_rows > 0 ? index(0, 0) : QModelIndex();
}

QString StageModel::sparkOutShown(const QModelIndex& index) const {
    const SparkOut& sparkOut = stage(index).spark_out;
    switch (sparkOut.mode) {
    case SparkOut::Mode::none: return tr("none");
    case SparkOut::Mode::untilSize: return tr("until size");
    case SparkOut::Mode::count: break;
    }
    return m_document.project().operation == Operation::traverse
               ? tr("%n double strokes", nullptr, sparkOut.count)
               : tr("%n revolutions", nullptr, sparkOut.count);
}

QString StageModel::shown(const QModelIndex& index) const {
    if (!relevant(index)) {
        return QStringLiteral("—");
    }
    if (field(index).kind == Kind::sparkOut) {
        return sparkOutShown(index);
    }
    if (const QString text = refusedText(index); !text.isNull()) {
        return text;
    }
    const auto value = number(index);
    return value ? showNumber(*value, QLocale()) : QString();
}

Remark StageModel::remark(const QModelIndex& index) const {
    const auto refused = m_refused.constFind({index.row(), &field(index)});
    if (refused != m_refused.cend()) {
        return {Mark::error, refused->reason};
    }
    return remarkFor(m_issues, path(index));
}

QVariant StageModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Remark mark = remark(index);
    switch (role) {
    case Qt::DisplayRole: return shown(index);
    case Qt::TextAlignmentRole: return int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::DecorationRole:
        return mark.mark == Mark::none ? QVariant() : QVariant(markIcon(mark.mark));
    case Qt::ForegroundRole:
        if (mark.mark != Mark::none) {
            return markColor(mark.mark, QGuiApplication::palette());
        }
        return relevant(index)
                   ? QVariant()
                   : QVariant(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text));
    case Qt::ToolTipRole:
        return mark.mark == Mark::none
                   ? hintMarkup(field(index))
                   : QStringLiteral("<p>%1</p>").arg(mark.reason.toHtmlEscaped());
    case Qt::AccessibleTextRole:
        return tr("Stage %1, %2: %3")
            .arg(QString::number(index.row() + 1), inputText(field(index).label), shown(index));
    case Qt::AccessibleDescriptionRole: return mark.reason;
    default: return {};
    }
}

QVariant StageModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        return role == Qt::DisplayRole ? QVariant(QString::number(section + 1)) : QVariant();
    }
    const Field& column = *m_columns[std::size_t(section)];
    if (role == Qt::ToolTipRole) {
        return hintMarkup(column);
    }
    if (role == Qt::DisplayRole) {
        return *column.unit ? tr("%1,\n%2").arg(inputText(column.label), unitText(column.unit))
                            : inputText(column.label);
    }
    return {};
}

Qt::ItemFlags StageModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return index.isValid() && relevant(index) ? usual | Qt::ItemIsEditable : usual;
}

void StageModel::refuse(const QModelIndex& index, const QString& text, const QString& reason) {
    m_refused.insert({index.row(), &field(index)}, {text, reason});
    emit dataChanged(index, index);
    emit refusalsChanged();
}

void StageModel::accept(const QModelIndex& index) {
    if (m_refused.remove({index.row(), &field(index)}) > 0) {
        emit dataChanged(index, index);
        emit refusalsChanged();
    }
}

QString StageModel::refusedText(const QModelIndex& index) const {
    return m_refused.value({index.row(), &field(index)}).text;
}

std::vector<Refusal> StageModel::refusals() const {
    std::vector<Refusal> list;
    for (auto it = m_refused.cbegin(); it != m_refused.cend(); ++it) {
        list.push_back(
            {stagesPath + "/" + std::to_string(it.key().first) + "/" + it.key().second->key,
             it->reason});
    }
    return list;
}

void StageModel::setIssues(const Issues& issues) {
    m_issues = issues;
    if (m_rows > 0) {
        emit dataChanged(index(0, 0), index(m_rows - 1, columnCount() - 1));
    }
}

void StageModel::update(bool replaced) {
    const int rows = static_cast<int>(m_document.project().cycle.stages.size());
    auto columns = relevantColumns();
    if (replaced || rows != m_rows || columns != m_columns) {
        beginResetModel();
        m_refused.clear();
        m_rows = rows;
        m_columns = std::move(columns);
        endResetModel();
        emit refusalsChanged();
    } else if (m_rows > 0) {
        emit dataChanged(index(0, 0), index(m_rows - 1, columnCount() - 1));
    }
}

void StageModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    setIssues(m_issues);
}

} // namespace sparkout
