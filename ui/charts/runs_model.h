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

/// The current run and the kept ones below it, each with a sample of its line, its light, a summary
/// line, and a check mark that draws it over the current one.
class RunsModel : public QAbstractListModel {
    Q_OBJECT
public:
    struct Run {
        QString name;
        QString detail;      ///< the lines below
        QString description; ///< for the tool tip
        std::optional<Light> light;
        int number = 0; ///< number of its dash; negative: not drawn
        bool chosen = true;
        bool isOwn = true;                   ///< otherwise its name is not editable here
        std::optional<JudgedState> judged{}; ///< its mark replaces the light
        friend bool operator==(const Run&, const Run&) = default;
    };
    using QAbstractListModel::QAbstractListModel;

    static constexpr QSize sample{42, 12}; ///< size of a line sample, and of the light beside it

    void setRuns(std::vector<Run> runs); ///< the current one first; it cannot be unchecked
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
