// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

namespace sparkout {

/// Types a text in place of the present one.
template <class Field>
void typeOver(Field& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
}

} // namespace sparkout
