// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/odt_xml.h"
#include "ui/report/format/report.h"

#include <QString>

#include <cstddef>

namespace sparkout::report {

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

} // namespace sparkout::report
