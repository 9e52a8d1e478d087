// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/odt_xml.h"
#include "ui/report/format/report.h"

#include <QByteArray>
#include <QString>

#include <cstddef>
#include <functional>
#include <vector>

namespace sparkout::report {

struct Report;

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
