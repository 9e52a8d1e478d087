// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/work_title.h"

#include "ui/report/course/lesson_markup.h"
#include "ui/report/course/paper_writer.h"

#include <QRegularExpression>

namespace sparkout::report {

WorkTitle::WorkTitle(const Bilingual& title)
    : m_full(LessonMarkup::inOneLine(PaperWriter::text(title))) {
    static const QRegularExpression numbered(
        QStringLiteral(
            "^(?:(?:Лабораторная )?работа|(?:Laboratory )?work)\\s+(?:№|No\\.)?\\s*(\\d+)"
            "[.:]?\\s*(.+)$"),
        QRegularExpression::CaseInsensitiveOption);
    const auto match = numbered.match(m_full);
    number = match.captured(1);
    name = match.hasMatch() ? match.captured(2) : m_full;
}

QString WorkTitle::inFull() const {
    return m_full;
}

} // namespace sparkout::report
