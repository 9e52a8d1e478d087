// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/dialogs/export_dialog.h"

namespace sparkout {

class View;

/// The batch, sweep and search that the views show; those of other inputs than `now` say so.
[[nodiscard]] std::vector<StudyOffer> studiesShown(const std::vector<View*>& views,
                                                   const Project& now);

} // namespace sparkout
