// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/form_head.h"
#include "ui/report/format/form_sheet.h"
#include "ui/report/format/formula_node.h"

#include <QByteArray>
#include <QDate>
#include <QSizeF>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <functional>
#include <utility>
#include <variant>
#include <vector>

class QPainter;

/// A printed document as a value, in the present language: what the pages, the web page and the
/// Markdown text are all made from. Texts are plain.
namespace sparkout::report {

/// How pages look: as the program's own sheets, or as ГОСТ 7.32 has those of a report.
enum class PageStyle { sheet, standard };

struct Heading {
    enum class Level {
        section,
        subsection,
        part, ///< of its own, without a number: contents, conclusion; in a report by the standard
    };
    QString text;
    Level level = Level::section;
};

struct Paragraph {
    QString text;
    bool strong = false;
    bool symbols = false; ///< it has symbols with indices: "k_s"
};

/// Names with their values, two abreast on a page.
struct Facts {
    std::vector<std::pair<QString, QString>> facts;
};

/// Every row has as many cells as the head; the first column reads from the left, the others stand
/// to the right unless they are texts. No cell is empty.
struct Table {
    QStringList head;
    std::vector<QStringList> rows;
    std::vector<bool> texts;         ///< by column: set to the left
    bool lastIsSum = false;          ///< the last row adds up the others
    std::vector<double> widths = {}; ///< of its columns, in shares; empty: as its texts need
    bool symbols = false;            ///< the first column has symbols: "k_s"
    /// In a form, the text in the first of these columns goes on over those before the second, in
    /// rows that have nothing there.
    std::pair<std::size_t, std::size_t> spread = {};
    QString caption = {}; ///< its name, above it; empty: none
    int number = 0;       ///< beside its name
};

/// What stands above a table that has a name: "Table 1 — Stages", or where it goes on.
[[nodiscard]] QString captionOf(const Table& table);
[[nodiscard]] QString continuationOf(const Table& table);

/// A drawing in vectors.
struct Figure {
    QString caption;
    QString description; ///< the same in words, for those who cannot see it
    QSizeF size;         ///< in units of the drawing; it is scaled to the width of the page
    std::function<void(QPainter&)> paint;
};

/// An equation: its left side, then what that is equal to: symbols, numbers put in, the result.
struct Formula {
    std::vector<FormulaNode> sides;
    QString label; ///< its number, at the edge
};

/// What follows begins on a page of its own.
struct PageBreak {};

/// Ruled lines to write on by hand.
struct Blank {
    int lines = 1;
};

/// The first page of a report, without a number.
struct TitlePage {
    QStringList above; ///< who the report is made for: ministry, university, department
    QString document;  ///< what it is
    QStringList title; ///< and of what
    std::vector<std::pair<QString, QString>> people; ///< in what they take part, who they are
    QString below;                                   ///< place and year
};

/// The headings of the report with their pages.
struct Contents {
    QString title;
};

using Block = std::variant<Heading, Paragraph, Facts, Table, Figure, Formula, PageBreak, FormHead,
                           Blank, TitlePage, Contents>;

struct Report {
    QString title;
    QString subject; ///< what it is about: the part and the project
    QString author;
    QString file;      ///< name of the project's file
    QByteArray inputs; ///< the project's text, which a PDF carries with it; empty: none
    QString program;   ///< "Sparkout 0.1.0"
    QString language;  ///< "en"
    QDate date;
    std::vector<Block> blocks;
    /// A form that is printed in place of the blocks, on A4 landscape; the other formats have
    /// those.
    std::vector<FormSheet> sheets;
    PageStyle style = PageStyle::sheet;

    /// The line at the foot of every page.
    [[nodiscard]] QString origin() const;
};

} // namespace sparkout::report
