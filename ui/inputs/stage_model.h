// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "ui/inputs/list_model.h"

namespace sparkout {

/// The stages of the document's cycle as a table; the last stage may spark out.
class StageModel : public ListModel {
    Q_OBJECT

public:
    using ListModel::ListModel;

    [[nodiscard]] const Stage& stage(const QModelIndex& index) const;
    void setSparkOut(const QModelIndex& index, SparkOut sparkOut);

protected:
    [[nodiscard]] bool relevant(const QModelIndex& index) const override;
    [[nodiscard]] QString shown(const QModelIndex& index) const override;

private:
    [[nodiscard]] QString sparkOutShown(const QModelIndex& index) const;
};

} // namespace sparkout
