// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/mark.h"

#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/text/texts.h"

namespace sparkout {

QColor markColor(Mark mark, const QPalette& palette) {
    switch (mark) {
    case Mark::error: return tone(Tone::error, palette);
    case Mark::missing: return palette.color(QPalette::Link);
    case Mark::warning: return tone(Tone::warning, palette);
    case Mark::none: break;
    }
    return palette.color(QPalette::Text);
}

QIcon markIcon(Mark mark) {
    switch (mark) {
    case Mark::error: return themeIcon(u"error");
    case Mark::missing: return themeIcon(u"info");
    case Mark::warning: return themeIcon(u"warning");
    case Mark::none: break;
    }
    return {};
}

Mark markOf(const Issue& issue) {
    return issue.severity == Severity::warning   ? Mark::warning
           : issue.code == IssueCode::missingKey ? Mark::missing
                                                 : Mark::error;
}

namespace {

Remark worstOf(const Issues& issues, const std::string& path, bool below) {
    Remark worst;
    for (const Issue& issue : issues) {
        const bool here = issue.path == path || (below && issue.path.starts_with(path + "/"));
        if (here && markOf(issue) > worst.mark) {
            worst = {markOf(issue), issueText(issue)};
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

ReasonLabel::ReasonLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setVisible(false);
}

void ReasonLabel::showRemark(const Remark& remark) {
    QPalette colors = parentWidget()->palette();
    colors.setColor(QPalette::WindowText, markColor(remark.mark, colors));
    setPalette(colors);
    setText(remark.reason);
    setVisible(remark.mark != Mark::none);
}

} // namespace sparkout
