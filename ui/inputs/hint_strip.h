// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QFrame>
#include <QPointer>

class QLabel;

namespace sparkout {

/// Sets the input of a widget, which the strip then describes.
void setHintField(QWidget& widget, const Field& field);
/// The input of a widget or its nearest parent with one; null if there is none.
[[nodiscard]] const Field* hintField(const QWidget* widget);

/// Shows below the pages the limits, default and meaning of the focused input, for use without a
/// pointer.
class HintStrip : public QFrame {
    Q_OBJECT

public:
    explicit HintStrip(QWidget* parent = nullptr);
    ~HintStrip() override;

    void showField(const Field& field);
    void showFieldOf(const QWidget* widget); ///< empty if it belongs to no input
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;

private:
    void fitFont();
    void follow(const QWidget* focused);
    void fill();

    QLabel* m_text;
    const Field* m_field = nullptr;
    QPointer<const QWidget> m_helper; ///< a helper such as a tolerance class: shows its tool tip
};

} // namespace sparkout
