// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pdf/pdf_structure.h"
#include "ui/report/format/form_sheet.h"
#include "ui/report/format/pages.h"

#include <vector>

namespace sparkout::report {

/// A sheet of a form as painted pieces, by the elements of the structure: its heading, its texts,
/// the table and the drawing; frames belong to none.
[[nodiscard]] std::vector<Pages::Piece> sheetPieces(const FormSheet& sheet,
                                                    PdfStructure& structure);

} // namespace sparkout::report
