// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/report_text.h"

#include "ui/chart/svg_device.h"
#include "ui/report/format/formula_writer.h"
#include "ui/report/format/odt.h"
#include "ui/report/format/pages.h"
#include "ui/text/texts.h"

#include <QFileInfo>
#include <QPainter>
#include <QRegularExpression>

namespace sparkout::report {

namespace {

constexpr int figureDotsPerInch = 96;

const char* const styleSheet =
    "body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#000;"
    "background:#fff}h1{font-size:1.5em}h2{font-size:1.15em;margin-top:1.5em}"
    "table{border-collapse:collapse;width:100%;margin:.5em 0}"
    "th,td{border:1px solid #999;padding:.25em .5em;text-align:right;vertical-align:top}"
    "th{background:#eee;font-size:.85em}td.text,th.text{text-align:left}"
    "tr.sum td{font-weight:bold;background:#eee}dl{display:grid;"
    "grid-template-columns:repeat(auto-fill,minmax(16em,1fr));gap:.4em 1em}dt{font-size:.8em;"
    "color:#555}dd{margin:0;font-weight:bold}figure{margin:1em 0}figure svg{width:100%;"
    "height:auto}div.formula{display:flex;align-items:center;gap:1em;overflow-x:auto;"
    "margin:.4em 0 .4em 1.5em}div.formula math{margin:0}div.formula span{margin-left:auto;"
    "color:#555}@page{size:A4;margin:12mm 12mm 12mm 18mm}@media print{body{max-width:none;margin:0;"
    "padding:0;font-size:9.5pt}h1,h2{break-after:avoid}thead{display:table-header-group}"
    "tr,figure,dl div,div.formula{break-inside:avoid}p{orphans:3;widows:3}"
    "p:has(+table),p:has(+dl),p:has(+div.formula){break-after:avoid}"
    "th,tr.sum td{print-color-adjust:exact;-webkit-print-color-adjust:exact}"
    "div.page{break-before:page}div.title{break-after:page}}caption{text-align:left}"
    "div.title{text-align:center}p.blank{border-bottom:1px solid #999;margin:.4em 0}"
    "figcaption,footer{font-size:.8em;color:#555;text-align:"
    "center}";

QByteArray drawn(const Figure& figure) {
    SvgDevice device(figure.size.toSize(), figureDotsPerInch, figure.description);
    QPainter painter;
    if (painter.begin(&device)) {
        figure.paint(painter);
        painter.end();
    }
    return device.document();
}

/// A drawing as an element of its page; its identifiers are unique to it.
QString svgOf(const Figure& figure, int number) {
    QString svg = QString::fromUtf8(drawn(figure));
    svg.remove(0, svg.indexOf(QStringLiteral("<svg")));
    const QString own = QStringLiteral("f%1c").arg(number);
    svg.replace(QStringLiteral("<clipPath id=\"c"), QStringLiteral("<clipPath id=\"") + own);
    svg.replace(QStringLiteral("clip-path=\"url(#c"), QStringLiteral("clip-path=\"url(#") + own);
    return svg;
}

/// The headings of a report, line by line.
QStringList headingsOf(const Report& report) {
    QStringList headings;
    for (const Block& block : report.blocks) {
        if (const auto* heading = std::get_if<Heading>(&block)) {
            headings << heading->text;
        }
    }
    return headings;
}

bool hasTitlePage(const Report& report) {
    return !report.blocks.empty() && std::holds_alternative<TitlePage>(report.blocks.front());
}

class Html {
public:
    explicit Html(const Report& report) : m_headings(headingsOf(report)) {}

    void operator()(const Heading& h) {
        const QString tag =
            h.level == Heading::Level::subsection ? QStringLiteral("h3") : QStringLiteral("h2");
        m_text += u'<' + tag + u'>' + h.text.toHtmlEscaped() + QStringLiteral("</") + tag
                  + QStringLiteral(">\n");
    }
    void operator()(const Paragraph& p) {
        const QString text =
            p.symbols ? withIndices(p.text).replace(u'\n', QStringLiteral("<br/>")) : lines(p.text);
        m_text += p.strong ? QStringLiteral("<p><strong>%1</strong></p>\n").arg(text)
                           : QStringLiteral("<p>%1</p>\n").arg(text);
    }
    void operator()(const Facts& facts) {
        m_text += QStringLiteral("<dl>\n");
        for (const auto& [name, value] : facts.facts) {
            m_text += QStringLiteral("<div><dt>%1</dt><dd>%2</dd></div>\n")
                          .arg(name.toHtmlEscaped(), lines(value));
        }
        m_text += QStringLiteral("</dl>\n");
    }
    void operator()(const Table& table) {
        const QString caption = captionOf(table).toHtmlEscaped();
        m_text +=
            QStringLiteral("<table>\n")
            + (caption.isEmpty() ? caption : QStringLiteral("<caption>%1</caption>\n").arg(caption))
            + QStringLiteral("<thead>") + row(table.head, table, "th", false)
            + QStringLiteral("</thead>\n<tbody>\n");
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            m_text +=
                row(table.rows[r], table, "td", table.lastIsSum && r + 1 == table.rows.size());
        }
        m_text += QStringLiteral("</tbody>\n</table>\n");
    }
    void operator()(const Figure& figure) {
        m_text += QStringLiteral("<figure>\n%1<figcaption>%2</figcaption>\n</figure>\n")
                      .arg(svgOf(figure, ++m_figures), figure.caption.toHtmlEscaped());
    }
    void operator()(const Formula& formula) {
        m_text += QStringLiteral("<div class=\"formula\">%1<span>%2</span></div>\n")
                      .arg(mathMarkup(formula), formula.label.toHtmlEscaped());
    }
    void operator()(const FormHead& head) {
        if (!head.entries.empty()) {
            (*this)(Facts{head.entries});
        }
    }
    void operator()(const PageBreak&) { m_text += QStringLiteral("<div class=\"page\"></div>\n"); }
    void operator()(const Blank& blank) {
        m_text += QStringLiteral("<p class=\"blank\">&#160;</p>\n").repeated(blank.lines);
    }
    void operator()(const TitlePage& title) {
        m_text += QStringLiteral("<div class=\"title\">\n");
        for (const QString& line : title.above) {
            m_text += QStringLiteral("<p>%1</p>\n").arg(line.toHtmlEscaped());
        }
        m_text += QStringLiteral("<h1>%1</h1>\n").arg(title.document.toHtmlEscaped());
        for (const QString& line : title.title) {
            m_text += QStringLiteral("<p><strong>%1</strong></p>\n").arg(line.toHtmlEscaped());
        }
        (*this)(Facts{title.people});
        m_text += QStringLiteral("<p>%1</p>\n</div>\n").arg(title.below.toHtmlEscaped());
    }
    void operator()(const Contents& contents) {
        m_text += QStringLiteral("<h2>%1</h2>\n<p>%2</p>\n")
                      .arg(contents.title.toHtmlEscaped(), lines(m_headings.join(u'\n')));
    }
    [[nodiscard]] const QString& text() const { return m_text; }

private:
    static QString lines(const QString& text) {
        return text.toHtmlEscaped().replace(u'\n', QStringLiteral("<br/>"));
    }
    static QString row(const QStringList& cells, const Table& table, const char* tag, bool sum) {
        const QString name = QString::fromLatin1(tag);
        QString text = sum ? QStringLiteral("<tr class=\"sum\">") : QStringLiteral("<tr>");
        for (qsizetype c = 0; c < cells.size(); ++c) {
            const auto i = static_cast<std::size_t>(c);
            const bool isText = i < table.texts.size() && table.texts[i];
            const bool isSymbol = table.symbols && c == 0 && &cells != &table.head;
            text += u'<' + name
                    + (isText ? QStringLiteral(" class=\"text\">") : QStringLiteral(">"))
                    + (isSymbol ? withIndices(cells[c]) : lines(cells[c])) + QStringLiteral("</")
                    + name + u'>';
        }
        return text + QStringLiteral("</tr>\n");
    }

    QStringList m_headings;
    QString m_text;
    int m_figures = 0;
};

class Markdown {
public:
    explicit Markdown(const Report& report) : m_headings(headingsOf(report)) {}

    void operator()(const Heading& h) {
        m_text +=
            (h.level == Heading::Level::subsection ? QStringLiteral("### ") : QStringLiteral("## "))
            + plain(h.text) + end();
    }
    void operator()(const Paragraph& p) {
        static const QRegularExpression indent(QStringLiteral("^[ \\x{a0}]+"),
                                               QRegularExpression::MultilineOption);
        static const QRegularExpression bullet(QStringLiteral("^([-+])"),
                                               QRegularExpression::MultilineOption);
        static const QRegularExpression count(QStringLiteral("^(\\d+)([.)])"),
                                              QRegularExpression::MultilineOption);
        QString text = (p.symbols ? indexed(p.text) : plain(p.text)).remove(indent);
        text.replace(bullet, QStringLiteral("\\\\1"));
        text.replace(count, QStringLiteral("\\1\\\\2"));
        text.replace(u'\n', QStringLiteral("  \n"));
        m_text += (p.strong ? QStringLiteral("**%1**").arg(text) : text) + end();
    }
    void operator()(const Facts& facts) {
        for (const auto& [name, value] : facts.facts) {
            m_text += QStringLiteral("* %1: **%2**\n").arg(plain(name), inLine(value));
        }
        m_text += u'\n';
    }
    void operator()(const Table& table) {
        if (const QString caption = captionOf(table); !caption.isEmpty()) {
            m_text += plain(caption) + end();
        }
        m_text += row(table.head) + QStringLiteral("|");
        for (qsizetype c = 0; c < table.head.size(); ++c) {
            const auto i = static_cast<std::size_t>(c);
            const bool isText = i < table.texts.size() && table.texts[i];
            m_text += isText ? QStringLiteral(" :-- |") : QStringLiteral(" --: |");
        }
        m_text += u'\n';
        for (const QStringList& cells : table.rows) {
            m_text += row(cells, table.symbols);
        }
        m_text += u'\n';
    }
    void operator()(const Figure& figure) {
        const QString name = QStringLiteral("figure-%1").arg(++m_figures);
        m_text += QStringLiteral("![%1][%2]").arg(plain(figure.caption), name) + end();
        const QString said = figure.description == figure.caption
                                 ? figure.caption
                                 : figure.caption + QStringLiteral(": ") + figure.description;
        m_text += QStringLiteral("*%1*").arg(plain(said)) + end();
        m_pictures += QStringLiteral("[%1]: data:image/svg+xml;base64,").arg(name)
                      + QString::fromLatin1(drawn(figure).toBase64()) + u'\n';
    }
    /// On one line, with indices and powers as in HTML, which Markdown accepts.
    void operator()(const Formula& formula) {
        static const QRegularExpression power(QStringLiteral("\\^\\(([0-9.,/]+)\\)"));
        m_text += indexed(inOneLine(formula)).replace(power, QStringLiteral("<sup>\\1</sup>"))
                  + QStringLiteral(" ") + plain(formula.label) + end();
    }
    void operator()(const FormHead& head) {
        if (!head.entries.empty()) {
            (*this)(Facts{head.entries});
        }
    }
    void operator()(const PageBreak&) { m_text += QStringLiteral("---") + end(); }
    void operator()(const Blank& blank) {
        m_text += (QStringLiteral("\\_").repeated(blankSigns) + end()).repeated(blank.lines);
    }
    void operator()(const TitlePage& title) {
        for (const QString& line : title.above) {
            m_text += plain(line) + end();
        }
        m_text += QStringLiteral("# ") + plain(title.document) + end();
        for (const QString& line : title.title) {
            m_text += QStringLiteral("**%1**").arg(plain(line)) + end();
        }
        (*this)(Facts{title.people});
        m_text += plain(title.below) + end();
    }
    void operator()(const Contents& contents) {
        m_text += QStringLiteral("## ") + plain(contents.title) + end();
        for (const QString& heading : m_headings) {
            m_text += QStringLiteral("* %1\n").arg(plain(heading));
        }
        m_text += u'\n';
    }
    [[nodiscard]] const QString& text() const { return m_text; }
    /// The drawings, placed at the end of the file to keep the text above readable.
    [[nodiscard]] const QString& pictures() const { return m_pictures; }
    /// Escapes characters with a meaning in Markdown or HTML.
    static QString plain(const QString& text) {
        static const QRegularExpression signs(QStringLiteral("([\\\\`*_{}\\[\\]#|~$])"));
        QString out = text;
        out.replace(signs, QStringLiteral("\\\\1"));
        return out.replace(u'&', QStringLiteral("&amp;"))
            .replace(u'<', QStringLiteral("&lt;"))
            .replace(u'>', QStringLiteral("&gt;"));
    }

private:
    static QString end() { return QStringLiteral("\n\n"); }
    static QString inLine(const QString& text) {
        return plain(text).replace(u'\n', QStringLiteral("<br>"));
    }
    /// "k_s" in HTML, which Markdown accepts.
    static QString indexed(const QString& text) {
        static const QRegularExpression index(QStringLiteral("\\\\_(\\w+)"),
                                              QRegularExpression::UseUnicodePropertiesOption);
        return plain(text).replace(index, QStringLiteral("<sub>\\1</sub>"));
    }
    static QString row(const QStringList& cells, bool symbols = false) {
        QString text = QStringLiteral("|");
        for (const QString& cell : cells) {
            const bool isSymbol = symbols && &cell == &cells.front();
            text += u' ' + (isSymbol ? indexed(cell) : inLine(cell)) + QStringLiteral(" |");
        }
        return text + u'\n';
    }

    static constexpr int blankSigns = 60; ///< underscores of a line for handwriting

    QStringList m_headings;
    QString m_text, m_pictures;
    int m_figures = 0;
};

} // namespace

QByteArray html(const Report& report) {
    Html body(report);
    for (const Block& block : report.blocks) {
        std::visit(body, block);
    }
    const QString title = report.title.toHtmlEscaped();
    const QString subject = report.subject.toHtmlEscaped();
    const QString page =
        QStringList{
            QStringLiteral("<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\""),
            report.language,
            QStringLiteral("\">\n<head>\n<meta charset=\"utf-8\"/>\n<title>"),
            title,
            QStringLiteral(" – "),
            subject,
            QStringLiteral("</title>\n<meta name=\"author\" content=\""),
            report.author.toHtmlEscaped(),
            QStringLiteral("\"/>\n<meta name=\"generator\" content=\""),
            report.program.toHtmlEscaped(),
            QStringLiteral("\"/>\n<style>"),
            QString::fromLatin1(styleSheet),
            QStringLiteral("</style>\n</head>\n<body>\n"),
            hasTitlePage(report) ? QString()
                                 : QStringLiteral("<h1>%1</h1>\n<p>%2</p>\n").arg(title, subject),
            body.text(),
            QStringLiteral("<footer>"),
            report.origin().toHtmlEscaped(),
            QStringLiteral("</footer>\n</body>\n</html>\n")}
            .join(QString());
    return harmlessText(page).toUtf8();
}

QByteArray markdown(const Report& report) {
    Markdown body(report);
    for (const Block& block : report.blocks) {
        std::visit(body, block);
    }
    const QString head = hasTitlePage(report)
                             ? QString()
                             : QStringLiteral("# ") + Markdown::plain(report.title)
                                   + QStringLiteral("\n\n") + Markdown::plain(report.subject)
                                   + QStringLiteral("\n\n");
    return harmlessText(head + body.text() + QStringLiteral("---\n\n")
                        + Markdown::plain(report.origin()) + u'\n'
                        + (body.pictures().isEmpty() ? QString() : u'\n' + body.pictures()))
        .toUtf8();
}

std::optional<Format> formatOf(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == u"pdf") {
        return Format::pdf;
    }
    if (suffix == u"html" || suffix == u"htm") {
        return Format::html;
    }
    if (suffix == u"md" || suffix == u"markdown") {
        return Format::markdown;
    }
    if (suffix == u"odt") {
        return Format::odt;
    }
    return {};
}

QByteArray bytesOf(const Report& report, Format format, const KeepGoing& keepGoing) {
    switch (format) {
    case Format::pdf: return pdf(report, keepGoing);
    case Format::html: return html(report);
    case Format::markdown: return markdown(report);
    case Format::odt: return odt(report);
    }
    return {};
}

} // namespace sparkout::report
