// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/study/outcome.h"
#include "ui/inputs/forms/list_model.h"

namespace sparkout {

/// "62 %", "0.4 %".
[[nodiscard]] QString percentText(double share);

/// The stages of the document's cycle as a table; the last stage may spark out. A further column
/// has the time of each stage; stock and time know the stage's share of the cycle's.
class StageModel : public ListModel {
    Q_OBJECT

public:
    static constexpr int shareRole = Qt::UserRole + 10; ///< 0…1; invalid where there is none
    static constexpr int staleRole = Qt::UserRole + 11; ///< of the last run that could be made
    /// A feed as a share of the wheel's width, else per revolution; empty where there is none.
    static constexpr int formRole = Qt::UserRole + 12;

    StageModel(std::string path, const Field& list, Document& document);

    [[nodiscard]] const Stage& stage(const QModelIndex& index) const;
    /// Takes over a stage whose spark-out was edited: what a spark-out does not feed goes, and
    /// comes back with it.
    void setSparkOut(const QModelIndex& index, Stage edited);
    void setOutcome(const sparkout::OutcomePtr& outcome);
    void forgetOutcome();

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// A spark-out at the end, unless the given columns say what becomes of it.
    [[nodiscard]] std::size_t lastRowsKept(const std::vector<const Field*>& given) const override;
    void resizeRows(Project& project, std::size_t rows, std::size_t last) const override;
    /// A spark-out as it is shown, or its number.
    [[nodiscard]] QString takeText(Project& project, int row, const Field& column,
                                   const QString& text) const override;

protected:
    [[nodiscard]] bool relevant(const QModelIndex& index) const override;
    /// The continuous infeed where a stage states one: few cycles have it.
    [[nodiscard]] bool shows(const Field& column) const override;
    [[nodiscard]] QString shown(const QModelIndex& index) const override;
    [[nodiscard]] int resultColumns() const override { return 1; }
    [[nodiscard]] QVariant resultData(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant resultHeader(int column, int role) const override;

private:
    [[nodiscard]] QString sparkOutShown(const QModelIndex& index) const;
    [[nodiscard]] QString takeSparkOut(Project& project, std::size_t row, const Field& column,
                                       const QString& text) const;
    /// A feed in its other forms, the shortest last; empty of other cells.
    [[nodiscard]] QStringList formsOf(const QModelIndex& index) const;
    [[nodiscard]] bool isStock(const QModelIndex& index) const;
    [[nodiscard]] bool known(int row) const; ///< whether the last run has this stage
    [[nodiscard]] double stockShare(int row) const;
    [[nodiscard]] double timeShare(int row) const;

    OutcomePtr m_run;     ///< the last one that could be made
    bool m_stale = false; ///< the inputs are faulty since
};

} // namespace sparkout
