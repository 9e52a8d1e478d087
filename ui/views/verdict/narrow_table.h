// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/copy_table.h"

namespace sparkout {

/// A table of numbers for a narrow panel: a row a quantity, with little air between the columns. It
/// is as high as its rows and scrolls sideways when its columns need more than the width.
class NarrowTable : public CopyTable {
    Q_OBJECT
public:
    explicit NarrowTable(ValueModel& model, QWidget* parent = nullptr);

    void fit(); ///< columns and height to what the model has

private:
    bool m_fitting = false;
};

} // namespace sparkout
