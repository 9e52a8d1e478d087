// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

class QPDF;

namespace sparkout {

class PdfStructure;

/// Tags a document whose pages were painted with the structure's marks: the marks become marked
/// content, the elements a structure tree. Throws if a mark is not as Qt paints it, and the
/// exceptions of libqpdf. `afterPage` may throw as well.
void putTags(QPDF& document, const PdfStructure& structure, const std::function<void()>& afterPage);

} // namespace sparkout
