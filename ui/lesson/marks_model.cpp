// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/marks_model.h"

#include "ui/lesson/lesson_text.h"
#include "words/lesson_words.h"

#include <QLocale>

#include <utility>

namespace sparkout {

namespace {

constexpr int markedTimeDigits = 3;

} // namespace

void MarksModel::setMarks(const Lesson& lesson, std::vector<GradedWork> works) {
    beginResetModel();
    m_lesson = lesson;
    m_works = std::move(works);
    endResetModel();
}

int MarksModel::rowsShown() const {
    return static_cast<int>(m_works.size());
}

int MarksModel::columnsShown() const {
    return m_works.empty() ? 0 : firstStep + steps() + static_cast<int>(After::count_);
}

QString MarksModel::remarks(const GradedWork& work) {
    QStringList texts;
    for (const WorkFlag flag : work.flags) {
        QString text = QCoreApplication::translate("Grading", flagText(flag));
        if (flag == WorkFlag::copied && !work.copiedFrom.empty()) {
            QStringList others;
            for (const std::string& other : work.copiedFrom) {
                others += QString::fromStdString(other);
            }
            text = tr("%1: %2").arg(text, others.join(QStringLiteral(", ")));
        }
        texts += text;
    }
    return texts.join(QStringLiteral("; "));
}

QString MarksModel::after(const GradedWork& work, After column) {
    switch (column) {
    case After::points: return LessonText::points(work.points);
    case After::most: return LessonText::points(work.most);
    case After::pending: return work.pending > 0 ? LessonText::points(work.pending) : QString();
    case After::time:
        return work.time_min ? QLocale().toString(*work.time_min, 'f', markedTimeDigits)
                             : QString();
    case After::remarks: return remarks(work);
    case After::count_: break;
    }
    return {};
}

QString MarksModel::text(const GradedWork& work, int column) const {
    switch (column) {
    case name: return QString::fromStdString(work.name.empty() ? work.file : work.name);
    case group: return QString::fromStdString(work.group);
    case variant: return work.variant > 0 ? QString::number(work.variant) : QString();
    default: break;
    }
    const int step = column - firstStep;
    if (step >= steps()) {
        return after(work, static_cast<After>(step - steps()));
    }
    const auto index = static_cast<std::size_t>(step);
    return index < work.steps.size() ? LessonText::points(work.steps[index].points)
                                     : QStringLiteral("—");
}

CsvCell MarksModel::value(const GradedWork& work, int column) const {
    const auto ofTime = [](const std::optional<double>& time_min) {
        return time_min ? CsvCell(*time_min) : CsvCell();
    };
    if (column == variant) {
        return work.variant > 0 ? CsvCell(double(work.variant)) : CsvCell();
    }
    const int step = column - firstStep;
    if (step < 0) {
        return text(work, column);
    }
    if (step < steps()) {
        const auto index = static_cast<std::size_t>(step);
        return index < work.steps.size() ? CsvCell(work.steps[index].points) : CsvCell();
    }
    switch (static_cast<After>(step - steps())) {
    case After::points: return work.points;
    case After::most: return work.most;
    case After::pending: return work.pending;
    case After::time: return ofTime(work.time_min);
    case After::remarks:
    case After::count_: break;
    }
    return remarks(work);
}

CsvTable MarksModel::table() const {
    CsvTable table;
    for (int column = 0; column < columnsShown(); ++column) {
        const int step = column - firstStep;
        table.header += step >= 0 && step < steps() ? tr("Step %1").arg(step + 1)
                                                    : head(column, Qt::DisplayRole).toString();
    }
    for (const GradedWork& work : m_works) {
        auto& row = table.rows.emplace_back();
        for (int column = 0; column < columnsShown(); ++column) {
            row.push_back(value(work, column));
        }
    }
    return table;
}

QVariant MarksModel::cell(int row, int column, int role) const {
    const GradedWork& work = m_works[static_cast<std::size_t>(row)];
    const bool isText = column == name || column == group || column == columnsShown() - 1;
    switch (role) {
    case Qt::DisplayRole: return text(work, column);
    case Qt::TextAlignmentRole: return aligned(!isText);
    case Qt::ToolTipRole: return isText ? text(work, column) : QVariant();
    default: return {};
    }
}

QVariant MarksModel::head(int column, int role) const {
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (column) {
    case name: return tr("Student");
    case group: return tr("Group");
    case variant: return tr("Variant");
    default: break;
    }
    const int step = column - firstStep;
    if (step < steps()) {
        return QString::number(step + 1);
    }
    switch (static_cast<After>(step - steps())) {
    case After::points: return tr("Points");
    case After::most: return tr("of");
    case After::pending: return tr("To be marked");
    case After::time: return tr("Time, min");
    case After::remarks: return tr("Remarks");
    case After::count_: break;
    }
    return {};
}

} // namespace sparkout
