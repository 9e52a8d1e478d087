// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/paper_writer.h"

#include "core/version.h"
#include "ui/report/course/lesson_markup.h"
#include "ui/report/parts/cell_text.h"

#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace sparkout::report {

PaperWriter::PaperWriter(const QString& title, const QString& subject, const QString& file,
                         const QDate& date, PageStyle style) {
    m_report.title = title;
    m_report.subject = subject;
    m_report.file = manyLines(QFileInfo(file).fileName()).simplified();
    m_report.program = QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version));
    m_report.language = QLocale().bcp47Name().section(u'-', 0, 0);
    m_report.date = date;
    m_report.style = style;
}

bool PaperWriter::isRussian() {
    return QLocale().language() == QLocale::Russian;
}

QString PaperWriter::text(const Bilingual& text) {
    return QString::fromStdString(text.in(isRussian()));
}

void PaperWriter::part(const QString& text) {
    add(Heading{text, Heading::Level::part});
}

void PaperWriter::section(const QString& text) {
    m_subsections = 0;
    add(Heading{QStringLiteral("%1 %2").arg(QString::number(++m_sections), text)});
}

void PaperWriter::subsection(const QString& text) {
    add(Heading{QStringLiteral("%1.%2 %3")
                    .arg(QString::number(m_sections), QString::number(++m_subsections), text),
                Heading::Level::subsection});
}

void PaperWriter::add(std::vector<Block> blocks) {
    std::ranges::move(blocks, std::back_inserter(m_report.blocks));
}

void PaperWriter::table(Table table, const QString& caption) {
    if (table.rows.empty()) {
        return;
    }
    table.caption = caption;
    table.number = ++m_tables;
    add(std::move(table));
}

int PaperWriter::figure(Figure figure) {
    figure.caption = tr("Figure %1 — %2").arg(QString::number(++m_figures), figure.caption);
    add(std::move(figure));
    return m_figures;
}

void PaperWriter::lesson(const Bilingual& text) {
    add(LessonMarkup::blocks(PaperWriter::text(text), &m_formulas));
}

void PaperWriter::lines(const std::string& text) {
    for (const QString& line : manyLines(QString::fromStdString(text)).split(u'\n')) {
        if (const QString plain = line.simplified(); !plain.isEmpty()) {
            say(plain);
        }
    }
}

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
