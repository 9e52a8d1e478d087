// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/form_sheet.h"
#include "ui/report/format/formula_node.h"

#include <QByteArray>
#include <QDate>
#include <QImage>
#include <QSizeF>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <functional>
#include <utility>
#include <variant>
#include <vector>

class QPainter;

/// A printed document as a value, in the current language: the source of the pages, the web page
/// and the Markdown text. Texts are plain.
namespace sparkout::report {

/// The style of pages: the program's own sheets, or a report by ГОСТ 7.32.
enum class PageStyle { sheet, standard };

struct Heading {
    enum class Level {
        section,
        subsection,
        part, ///< unnumbered part: contents, conclusion; in a report by the standard
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

/// Every row has as many cells as the head; the first column is aligned left, the others right
/// unless they are texts. No cell is empty.
struct Table {
    QStringList head;
    std::vector<QStringList> rows;
    std::vector<bool> texts;         ///< by column: aligned left
    bool lastIsSum = false;          ///< the last row adds up the others
    std::vector<double> widths = {}; ///< shares of its columns; empty: as its texts need
    bool symbols = false;            ///< the first column has symbols: "k_s"
    /// In a form, the text in the first of these columns extends over those before the second, in
    /// rows where they are empty.
    std::pair<std::size_t, std::size_t> spread = {};
    QString caption = {}; ///< its name, above it; may be empty
    int number = 0;       ///< precedes its name
};

/// The caption of a table with a name: "Table 1 — Stages", or that of a continuation.
[[nodiscard]] QString captionOf(const Table& table);
[[nodiscard]] QString continuationOf(const Table& table);

/// A drawing in vectors.
struct Figure {
    QString caption;
    QString description; ///< alternative text
    QSizeF size;         ///< in units of the drawing; it is scaled to the width of the page
    std::function<void(QPainter&)> paint;
};

/// An equation: its left side, then the equal sides: symbols, inserted numbers, the result.
struct Formula {
    std::vector<FormulaNode> sides;
    QString label; ///< its number, at the edge
};

/// Starts a new page.
struct PageBreak {};

/// Ruled lines for handwriting.
struct Blank {
    int lines = 1;
};

/// The first page of a report, without a number.
struct TitlePage {
    QStringList above; ///< recipient of the report: ministry, university, department
    QString document;  ///< kind of document
    QStringList title; ///< title of the work
    std::vector<std::pair<QString, QString>> people; ///< their roles and names
    QString below;                                   ///< place and year
};

/// The headings of the report with their pages.
struct Contents {
    QString title;
};

/// A cell of a form: the value is below its caption.
struct FormCell {
    enum class Count { none, pages, page };
    QString caption;
    QString value = {};
    int columns = 1, rows = 1; ///< number of columns and rows that it spans
    Count count = Count::none; ///< count of the document, replaces a value
    QImage picture = {};       ///< before the value
};

/// Cells in rows; a place covered by a spanning cell is left out.
struct FormGrid {
    std::vector<double> widths_mm; ///< widths of the columns
    std::vector<std::vector<FormCell>> rows;
};

/// The head of a form in an editable text; it begins a sheet.
struct FormHead {
    QString number;              ///< number of the form, above it
    QString symbol, name;        ///< at the foot of its sheets
    std::vector<FormGrid> grids; ///< one below the other
    FormGrid following;          ///< replaces them on further sheets
    /// The entries, as captions with values, for formats without grids. Empty if they appear above
    /// already.
    std::vector<std::pair<QString, QString>> entries;
};

using Block = std::variant<Heading, Paragraph, Facts, Table, Figure, Formula, PageBreak, FormHead,
                           Blank, TitlePage, Contents>;

struct Report {
    QString title;
    QString subject; ///< its subject: the part and the project
    QString author;
    QString file;      ///< name of the project's file
    QByteArray inputs; ///< the project's text, attached to a PDF; may be empty
    QString program;   ///< "Sparkout 0.1.0"
    QString language;  ///< "en"
    QDate date;
    std::vector<Block> blocks;
    /// A form printed instead of the blocks, on A4 landscape; the other formats use the blocks.
    std::vector<FormSheet> sheets;
    PageStyle style = PageStyle::sheet;

    /// The line at the foot of every page.
    [[nodiscard]] QString origin() const;
};

} // namespace sparkout::report
