// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/dialogs/export_dialog.h"

namespace sparkout {

class Document;
struct Studies;

/// The batch, sweep and search that were computed; those that are running, or of other inputs than
/// `now`, say so.
[[nodiscard]] std::vector<StudyOffer> studiesOffered(Studies& studies, const Project& now,
                                                     const Document& document);

} // namespace sparkout
