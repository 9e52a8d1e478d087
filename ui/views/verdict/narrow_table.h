// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/copy_table.h"

namespace sparkout {

/// A table of numbers for a narrow panel: a row for each quantity, with little space between the
/// columns. It is as high as its rows and scrolls sideways if its columns are too wide.
class NarrowTable : public CopyTable {
    Q_OBJECT
public:
    explicit NarrowTable(ValueModel& model, QWidget* parent = nullptr);

    void fit(); ///< fits columns and height to the model

private:
    bool m_fitting = false;
};

} // namespace sparkout
