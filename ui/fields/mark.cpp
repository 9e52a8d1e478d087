// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/mark.h"

#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/text/texts.h"

namespace sparkout {

QColor markColor(Mark mark, const QPalette& palette) {
    switch (mark) {
    case Mark::error: return tone(Tone::error, palette);
    case Mark::warning: return tone(Tone::warning, palette);
    case Mark::none: break;
    }
    return palette.color(QPalette::Text);
}

QIcon markIcon(Mark mark) {
    switch (mark) {
    case Mark::error: return themeIcon(u"error");
    case Mark::warning: return themeIcon(u"warning");
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
