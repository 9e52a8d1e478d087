// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/given_factors.h"

#include <vector>

/// Notices of what an edit changed beside its input.
namespace sparkout {

class NoticeBar;

/// Shows what a change of the operation changed outside the stages.
void showOperationNotice(NoticeBar& notices, const Project& before, const Project& after);
/// Names the factors of the batch whose laws an edit moved; without any, removes the notice of an
/// earlier edit.
void showLawsNotice(NoticeBar& notices, const std::vector<FactorKind>& moved);
void dropEditNotices(NoticeBar& notices);

} // namespace sparkout
