// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QFrame>
#include <QPointer>

class QLabel;

namespace sparkout {

/// Says which input a widget is for, so that the strip can describe it.
void setHintField(QWidget& widget, const Field& field);
/// The input of a widget or of what it stands in; null when there is none.
[[nodiscard]] const Field* hintField(const QWidget* widget);

/// Below the pages: limits, default and meaning of the input that has the focus, for those who
/// work without a pointer.
class HintStrip : public QFrame {
    Q_OBJECT

public:
    explicit HintStrip(QWidget* parent = nullptr);
    ~HintStrip() override;

    void showField(const Field& field);
    void showFieldOf(const QWidget* widget); ///< nothing where it is no input's
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;

private:
    void fitFont();
    void follow(const QWidget* focused);
    void fill();

    QLabel* m_text;
    const Field* m_field = nullptr;
    QPointer<const QWidget> m_helper; ///< what is no input itself, as a tolerance class: its tip
};

} // namespace sparkout
