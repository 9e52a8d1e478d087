// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stage_model.h"

#include "ui/session/document.h"

namespace sparkout {

const Stage& StageModel::stage(const QModelIndex& index) const {
    return document().project().cycle.stages[std::size_t(index.row())];
}

bool StageModel::relevant(const QModelIndex& index) const {
    if (field(index).kind == Kind::sparkOut) {
        return index.row() == rowCount() - 1 || stage(index).spark_out.mode != SparkOut::Mode::none;
    }
    return ListModel::relevant(index);
}

void StageModel::setSparkOut(const QModelIndex& index, SparkOut sparkOut) {
    Project project = document().project();
    Stage& to = project.cycle.stages[std::size_t(index.row())];
    const Stage before = to;
    to.spark_out = sparkOut;
    const bool feeds = sparkOut.mode == SparkOut::Mode::none;
    if (!feeds) { // a spark-out feeds nothing
        to.radial_feed_mm.reset();
        to.radial_feed_mm_min.reset();
    } else if (before.spark_out.mode != SparkOut::Mode::none) {
        const bool traverse = project.operation == Operation::traverse;
        auto& feed = traverse ? to.radial_feed_mm : to.radial_feed_mm_min;
        feed = feed ? feed : std::optional(traverse ? 0.001 : 0.1);
    }
    document().edit(std::move(project), {"Input", field(index).label},
                    QString::fromStdString(path(index)));
}

QString StageModel::sparkOutShown(const QModelIndex& index) const {
    const SparkOut& sparkOut = stage(index).spark_out;
    switch (sparkOut.mode) {
    case SparkOut::Mode::none: return tr("none");
    case SparkOut::Mode::untilSize: return tr("until size");
    case SparkOut::Mode::count: break;
    }
    return document().project().operation == Operation::traverse
               ? tr("%n double strokes", nullptr, sparkOut.count)
               : tr("%n revolutions", nullptr, sparkOut.count);
}

QString StageModel::shown(const QModelIndex& index) const {
    const bool sparkOut = field(index).kind == Kind::sparkOut && relevant(index);
    return sparkOut ? sparkOutShown(index) : ListModel::shown(index);
}

} // namespace sparkout
