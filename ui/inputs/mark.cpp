// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/mark.h"

#include "ui/session/texts.h"

namespace sparkout {

QColor markColor(Mark mark, const QPalette& palette) {
    const bool dark = palette.color(QPalette::Base).lightness() < 128;
    switch (mark) {
    case Mark::error: return dark ? QColor(0xff, 0x7b, 0x72) : QColor(0xb3, 0x1d, 0x1d);
    case Mark::warning: return dark ? QColor(0xe3, 0xb3, 0x41) : QColor(0x8a, 0x5a, 0x00);
    case Mark::none: break;
    }
    return palette.color(QPalette::Text);
}

QIcon markIcon(Mark mark) {
    switch (mark) {
    case Mark::error: return QIcon(QStringLiteral(":/icons/error.svg"));
    case Mark::warning: return QIcon(QStringLiteral(":/icons/warning.svg"));
    case Mark::none: break;
    }
    return {};
}

Mark markOf(Severity severity) {
    return severity == Severity::error ? Mark::error : Mark::warning;
}

namespace {

Remark worstOf(const Issues& issues, const std::string& path, bool below) {
    Remark worst;
    for (const Issue& issue : issues) {
        const bool here = issue.path == path || (below && issue.path.starts_with(path + "/"));
        if (here && markOf(issue.severity) > worst.mark) {
            worst = {markOf(issue.severity), issueText(issue)};
        }
    }
    return worst;
}

} // namespace

Remark remarkFor(const Issues& issues, const std::string& path) {
    return worstOf(issues, path, true);
}

Remark remarkAt(const Issues& issues, const std::string& path) {
    return worstOf(issues, path, false);
}

} // namespace sparkout
