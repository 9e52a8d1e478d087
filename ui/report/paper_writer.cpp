// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/paper_writer.h"

#include "core/text.h"
#include "core/version.h"
#include "ui/report/cell_text.h"
#include "ui/report/lesson_markup.h"
#include "ui/session/kept_texts.h"

#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <iterator>

namespace sparkout {

using report::Institution;

template <>
const StructInfo& tableOf<Institution>() {
    using T = Institution;
    constexpr Range letters{0, 300};
    static const std::array rows{
        SPARKOUT_FIELD(T, ministry, .label = SPARKOUT_NOOP("Input", "Ministry"), .hard = letters),
        SPARKOUT_FIELD(T, university, .label = SPARKOUT_NOOP("Input", "University"),
                       .hard = letters),
        SPARKOUT_FIELD(T, faculty, .label = SPARKOUT_NOOP("Input", "Faculty or institute"),
                       .hard = letters),
        SPARKOUT_FIELD(T, department, .label = SPARKOUT_NOOP("Input", "University department"),
                       .hard = letters),
        SPARKOUT_FIELD(T, discipline, .label = SPARKOUT_NOOP("Input", "Discipline"),
                       .hard = letters),
        SPARKOUT_FIELD(T, accepted, .label = SPARKOUT_NOOP("Input", "Accepted by (post and name)"),
                       .hard = letters),
        SPARKOUT_FIELD(T, place, .label = SPARKOUT_NOOP("Input", "Town"), .hard = letters),
    };
    static const StructInfo info =
        makeTable<Institution>(SPARKOUT_NOOP("Struct", "Title page"), rows);
    return info;
}

QVariantMap Institution::kept() const {
    return keptTexts(tableOf<Institution>(), this);
}

Institution Institution::fromKept(const QVariantMap& kept) {
    Institution made;
    readKeptTexts(kept, tableOf<Institution>(), &made);
    return made;
}

} // namespace sparkout

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
        QStringLiteral("^(?:(?:Лабораторная )?работа|(?:Laboratory "
                       ")?work)\\s+(?:№|No\\.)?\\s*(\\d+)[.:]?\\s*(.+)$"),
        QRegularExpression::CaseInsensitiveOption);
    const auto match = numbered.match(m_full);
    number = match.captured(1);
    name = match.hasMatch() ? match.captured(2) : m_full;
}

QString WorkTitle::inFull() const {
    return m_full;
}

} // namespace sparkout::report
