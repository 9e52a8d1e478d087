// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

class NoticeBar;
struct Project;

/// Shows what a change of the operation changed outside the stages.
void showOperationNotice(NoticeBar& notices, const Project& before, const Project& after);
void dropOperationNotice(NoticeBar& notices);

} // namespace sparkout
