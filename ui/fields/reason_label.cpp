// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/reason_label.h"

namespace sparkout {

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
