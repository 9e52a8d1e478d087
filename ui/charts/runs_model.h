// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "ui/charts/verdict_table.h"

#include <QAbstractListModel>
#include <QPixmap>
#include <QSize>
#include <QString>

#include <optional>
#include <vector>

namespace sparkout {

/// The present run and below it the kept ones, each with a sample of its line, its light, a line of
/// what came out, and a check mark that lays it over the present one.
class RunsModel : public QAbstractListModel {
    Q_OBJECT
public:
    struct Run {
        QString name;
        QString detail;      ///< the lines below
        QString description; ///< for the tooltip
        std::optional<Light> light;
        int number = 0; ///< of its dash; below 0: it is not drawn
        bool chosen = true;
        bool isOwn = true;                   ///< else its name is not edited here
        std::optional<JudgedState> judged{}; ///< whose mark stands in place of the light
        friend bool operator==(const Run&, const Run&) = default;
    };
    using QAbstractListModel::QAbstractListModel;

    static constexpr QSize sample{42, 12}; ///< of a line, and the light beside it

    void setRuns(std::vector<Run> runs); ///< the present one first; it cannot be unchecked
    void setPresent(Run run);            ///< the others stay

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void chosen(int run, bool isChosen); ///< of the kept ones, from 0
    void renamed(int run, const QString& name);

private:
    [[nodiscard]] static QPixmap markOf(const Run& run, const QColor& text,
                                        const QColor& behindLight);

    std::vector<Run> m_runs;
};

} // namespace sparkout
