// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/flat_button.h"

#include "ui/kit/theme_icon.h"

#include <QToolButton>

namespace sparkout {

QToolButton* flatButton(QWidget* parent, const char* name, const char16_t* icon) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setIcon(themeIcon(icon));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace sparkout
