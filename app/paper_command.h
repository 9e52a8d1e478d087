// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

struct ReportRequest;

/// `sparkout --report lab-report FILE -o OUT`, likewise for the worksheet, its key and the guide:
/// writes a paper of the course from a student's work, the teacher's lesson or a project, depending
/// on the paper, and returns the exit status.
[[nodiscard]] int writePaper(const ReportRequest& request);

} // namespace sparkout
