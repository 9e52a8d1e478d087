// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/dialog_parts.h"

#include <QLabel>

namespace sparkout {

QLabel* plainLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

QLabel* copyableLabel(QWidget* parent, const QString& text) {
    QLabel* const label = plainLabel(text, parent);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace sparkout
