// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/copyable_label.h"

#include <QLabel>

namespace sparkout {

QLabel* copyableLabel(QWidget* parent, const QString& text) {
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace sparkout
