// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/fields/mark.h"

#include <QLabel>

namespace sparkout {

/// The reason of a mark in the mark's colour; hidden if there is none.
class ReasonLabel : public QLabel {
    Q_OBJECT

public:
    explicit ReasonLabel(QWidget* parent = nullptr);

    void showRemark(const Remark& remark);
};

} // namespace sparkout
