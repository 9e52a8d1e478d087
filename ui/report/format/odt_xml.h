// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QByteArray>
#include <QString>
#include <QXmlStreamWriter>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace sparkout::report {

/// A file of an OpenDocument text that is being written.
class OdtXml {
public:
    using Attributes = std::vector<std::pair<QString, QString>>;

    explicit OdtXml(const char* root);
    void attribute(const char* name, const QString& value);
    void begin(const char* name);
    void end();
    void text(const QString& text);
    void empty(const char* name, const Attributes& attributes);
    /// A paragraph or heading; line breaks are kept.
    void paragraph(const char* style, const QString& text, const char* element = "text:p");
    /// A text with symbols: the index of "k_s" is lowered.
    void symbols(const char* style, const QString& text);
    void paragraphStyle(const char* name, const Attributes& paragraph, const Attributes& text);
    /// Ends all open elements.
    [[nodiscard]] QByteArray finish();

    [[nodiscard]] static QString millimetres(double value);

private:
    QByteArray m_bytes;
    QXmlStreamWriter m_writer;
};

/// The additional parts of a report by ГОСТ 7.32 in an OpenDocument text: styles and pages, the
/// title page, and contents whose page numbers are updated on opening.
class OdtStandard {
public:
    static void writeStyles(OdtXml& xml, const QString& language); ///< of paragraphs
    static void writeIndexStyle(OdtXml& xml);                      ///< of indices
    /// Writes the layouts of the pages into the open automatic styles; then the pages.
    static void writePages(OdtXml& xml);

    static void writeHeading(OdtXml& xml, const Heading& heading, std::size_t number);
    static void writeTitle(OdtXml& xml, const TitlePage& title);
    static void writeContents(OdtXml& xml, const Contents& contents, const Report& report);
};

/// The forms of a report in an OpenDocument text: each has its head as tables, and pages of its
/// own, of which the later ones have a short head.
class OdtForms {
public:
    /// Adds a picture to the document; returns its name there.
    using KeepPicture = std::function<QString(const QImage& image)>;

    explicit OdtForms(const Report& report);

    [[nodiscard]] bool isEmpty() const { return m_heads.empty(); }
    /// Writes the styles of the heads for the file of the text.
    void writeStyles(OdtXml& xml) const;
    /// Writes the head of a form; the following blocks are on its sheets.
    void writeHead(OdtXml& xml, std::size_t form, const KeepPicture& keep) const;
    /// For the file of styles: those of headers and footers, then the pages.
    void writePageStyles(OdtXml& xml) const;
    void writePages(OdtXml& xml, const QString& layout, const QString& origin) const;

private:
    static QString tableName(std::size_t form, std::size_t grid);
    static void writeColumns(OdtXml& xml, const QString& table, const FormGrid& grid);
    static void writeGrid(OdtXml& xml, const QString& table, const FormGrid& grid,
                          const KeepPicture& keep);
    static void writeCell(OdtXml& xml, const FormCell& cell, const KeepPicture& keep);
    static void writePage(OdtXml& xml, const QString& name, const QString& next,
                          const QString& layout, const std::function<void()>& contents);
    [[nodiscard]] FormGrid foot(std::size_t form) const;

    std::vector<const FormHead*> m_heads;
};

} // namespace sparkout::report
