// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/odt_xml.h"
#include "ui/report/format/report.h"

#include <QString>

#include <cstddef>

namespace sparkout::report {

/// What a report by ГОСТ 7.32 has in an OpenDocument text beside what every text has: its styles
/// and pages, the title page, contents whose pages are looked up by who opens it.
class OdtStandard {
public:
    static void writeStyles(OdtXml& xml, const QString& language); ///< those of paragraphs
    static void writeIndexStyle(OdtXml& xml); ///< of what stands below the line
    /// Layouts of the pages among the automatic styles, which are open; then the pages.
    static void writePages(OdtXml& xml);

    static void writeHeading(OdtXml& xml, const Heading& heading, std::size_t number);
    static void writeTitle(OdtXml& xml, const TitlePage& title);
    static void writeContents(OdtXml& xml, const Contents& contents, const Report& report);
};

} // namespace sparkout::report
