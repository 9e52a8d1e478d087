// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/dialogs/export_dialog.h"

namespace sparkout {

class Document;
struct Studies;

/// The computed batch, sweep and search, marked if they are running, or do not belong to `now`.
[[nodiscard]] std::vector<StudyOffer> studiesOffered(Studies& studies, const Project& now,
                                                     const Document& document);

} // namespace sparkout
