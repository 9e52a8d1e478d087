// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/lesson_markup.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace sparkout::report {

namespace {

QString withoutEntities(QString text) {
    for (const auto& [entity, sign] : {std::pair("&lt;", u'<'), std::pair("&gt;", u'>'),
                                       std::pair("&quot;", u'"'), std::pair("&nbsp;", u'\u00a0'),
                                       std::pair("&#160;", u'\u00a0'), std::pair("&amp;", u'&')}) {
        text.replace(QLatin1StringView(entity), QString(QChar(sign)));
    }
    return text;
}

/// Raises "2"; a character without a superscript form follows a caret.
QString raised(const QString& text) {
    static const QString plain = QStringLiteral("0123456789+-−n()");
    static const QString above = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻ⁿ⁽⁾");
    QString signs;
    for (const QChar c : text) {
        const qsizetype at = plain.indexOf(c);
        if (at < 0) {
            return QStringLiteral("^(%1)").arg(text);
        }
        signs += above[at];
    }
    return signs;
}

class MarkupReader {
public:
    explicit MarkupReader(int* formulas) : m_formulas(formulas) {}

    std::vector<Block> read(const QString& markup) {
        static const QRegularExpression tag(QStringLiteral("<(/?)([a-z0-9]+)([^>]*)>"));
        qsizetype from = 0;
        for (auto it = tag.globalMatch(markup); it.hasNext();) {
            const auto match = it.next();
            text(markup.mid(from, match.capturedStart() - from));
            const QString name = match.captured(2);
            if (match.captured(1).isEmpty()) {
                open(name, match.captured(3));
            } else {
                close(name);
            }
            from = match.capturedEnd();
        }
        text(markup.mid(from));
        end();
        return std::move(m_blocks);
    }

private:
    void text(const QString& part) {
        static const QRegularExpression space(QStringLiteral("[ \\t\\r\\n]+"));
        static const QRegularExpression word(QStringLiteral("(\\w+)"),
                                             QRegularExpression::UseUnicodePropertiesOption);
        QString plain = withoutEntities(part);
        if (!m_isFormula) {
            plain.replace(space, QStringLiteral(" "));
        }
        if (m_script == u"sub") {
            m_hasIndices = true;
            m_text += plain.trimmed().replace(word, QStringLiteral("_\\1"));
            m_isAfterIndex = true;
            return;
        }
        if (m_script == u"sup") {
            m_text += raised(plain.trimmed());
            return;
        }
        if (m_isAfterIndex && !plain.isEmpty() && plain.front().isLetterOrNumber()) {
            plain.prepend(QChar(0x200a)); // otherwise it would join the index
        }
        m_isAfterIndex = m_isAfterIndex && plain.isEmpty();
        m_text += plain;
    }

    void open(const QString& name, const QString& attributes) {
        if (name == u"sub" || name == u"sup") {
            m_script = name;
        } else if (name == u"br") {
            m_text += u'\n';
        } else if (name == u"p") {
            end();
            m_isFormula = attributes.contains(QStringLiteral("formula"));
        } else if (name == u"h3") {
            end();
            m_isStrong = true;
        } else if (name == u"ul" || name == u"ol") {
            end();
            m_lists.push_back(name == u"ol" ? 1 : 0);
        } else if (name == u"li") {
            end();
            if (!m_lists.empty()) {
                int& number = m_lists.back();
                m_item = number > 0 ? QStringLiteral("%1) ").arg(number++) : QStringLiteral("– ");
            }
        } else if (name == u"table") {
            end();
            m_rows.clear();
        } else if (name == u"tr") {
            m_rows.emplace_back();
        } else if (name == u"td") {
            m_text.clear();
        }
    }

    void close(const QString& name) {
        if (name == u"sub" || name == u"sup") {
            m_script.clear();
        } else if (name == u"p" || name == u"h3" || name == u"li") {
            end();
        } else if (name == u"ul" || name == u"ol") {
            end();
            if (!m_lists.empty()) {
                m_lists.pop_back();
            }
        } else if (name == u"td" && !m_rows.empty()) {
            const QString cell = m_text.trimmed();
            m_rows.back() << (cell.isEmpty() ? QStringLiteral("–") : cell);
            m_text.clear();
        } else if (name == u"table") {
            endTable();
        }
    }

    /// Ends a paragraph, an item or a formula.
    void end() {
        const QString text = std::exchange(m_text, {}).trimmed();
        const bool isFormula = std::exchange(m_isFormula, false);
        const bool isStrong = std::exchange(m_isStrong, false);
        const bool symbols = std::exchange(m_hasIndices, false);
        const QString item = std::exchange(m_item, {});
        m_isAfterIndex = false;
        if (text.isEmpty()) {
            return;
        }
        if (isFormula) {
            Formula formula;
            formula.sides = {{FormulaNode::Kind::text, text, 2, 0, {}}};
            formula.label = m_formulas ? QStringLiteral("(%1)").arg(++*m_formulas) : QString();
            m_blocks.emplace_back(std::move(formula));
            return;
        }
        m_blocks.emplace_back(Paragraph{item + text, isStrong, symbols});
    }

    /// The first row is the head.
    void endTable() {
        std::vector<QStringList> rows = std::exchange(m_rows, {});
        m_hasIndices = false;
        qsizetype columns = 0;
        for (const QStringList& row : rows) {
            columns = std::max(columns, row.size());
        }
        if (rows.empty() || columns == 0) {
            return;
        }
        for (QStringList& row : rows) {
            while (row.size() < columns) {
                row << QStringLiteral("–");
            }
        }
        Table table;
        table.head = rows.front();
        table.rows.assign(rows.begin() + 1, rows.end());
        table.texts.assign(static_cast<std::size_t>(columns), true);
        table.symbols = true;
        m_blocks.emplace_back(std::move(table));
    }

    int* m_formulas;
    std::vector<Block> m_blocks;
    QString m_text, m_script, m_item;
    std::vector<int> m_lists; ///< number of the next item; 0: unnumbered
    std::vector<QStringList> m_rows;
    bool m_isFormula = false, m_isStrong = false, m_hasIndices = false, m_isAfterIndex = false;
};

} // namespace

std::vector<Block> LessonMarkup::blocks(const QString& markup, int* formulas) {
    return MarkupReader(formulas).read(markup);
}

QString LessonMarkup::inOneLine(const QString& markup) {
    static const QRegularExpression within(QStringLiteral("</?(?:i|b|sub|sup|code)>"));
    static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
    static const QRegularExpression power(QStringLiteral("<sup>([^<]*)</sup>"));
    QString text = markup;
    for (auto found = power.match(text); found.hasMatch(); found = power.match(text)) {
        text.replace(found.capturedStart(), found.capturedLength(), raised(found.captured(1)));
    }
    return withoutEntities(text.remove(within).replace(tag, QStringLiteral(" "))).simplified();
}

} // namespace sparkout::report
