// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

class NoticeBar;
struct Project;

/// Says what an edit that chose another operation changed outside the stages.
void showOperationNotice(NoticeBar& notices, const Project& before, const Project& after);
void dropOperationNotice(NoticeBar& notices);

} // namespace sparkout
