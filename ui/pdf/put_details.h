// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pdf/pdf_details.h"

#include <QByteArray>

#include <functional>

namespace sparkout {

/// What withDetails() gives, made with libqpdf. Where there are modules it is in one that is loaded
/// for the first document: the library and what it needs are a tenth of all that a start would
/// read.
[[nodiscard]] QByteArray putDetails(const QByteArray& pdf, const PdfDetails& details,
                                    const std::function<bool()>& goesOn);

/// The module's entry, by its name there.
using PutDetails = void (*)(QByteArray& result, const QByteArray& pdf, const PdfDetails& details,
                            const std::function<bool()>& goesOn);
inline constexpr const char* putDetailsName = "sparkoutPutDetails";

} // namespace sparkout
