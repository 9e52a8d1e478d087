// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/study/outcome.h"
#include "ui/inputs/list_model.h"

namespace sparkout {

/// "62 %", "0.4 %".
[[nodiscard]] QString percentText(double share);

/// The stages of the document's cycle as a table; the last stage may spark out. An additional
/// column has the time of each stage; stock and time also give the stage's share of the total.
class StageModel : public ListModel {
    Q_OBJECT

public:
    static constexpr int shareRole = Qt::UserRole + 10; ///< 0…1; invalid without a share
    static constexpr int staleRole = Qt::UserRole + 11; ///< from the last valid run
    /// A feed as a share of the wheel's width, or per revolution; empty if there is none.
    static constexpr int formRole = Qt::UserRole + 12;

    StageModel(std::string path, const Field& list, Document& document);

    [[nodiscard]] const Stage& stage(const QModelIndex& index) const;
    /// Takes over a stage whose spark-out was edited: feeds that a spark-out does not have are
    /// removed, and restored later.
    void setSparkOut(const QModelIndex& index, Stage edited);
    void setOutcome(const sparkout::OutcomePtr& outcome);
    void forgetOutcome();

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// Keeps a spark-out at the end, unless the given columns define it.
    [[nodiscard]] std::size_t lastRowsKept(const std::vector<const Field*>& given) const override;
    void resizeRows(Project& project, std::size_t rows, std::size_t last) const override;
    /// Accepts a spark-out as displayed, or its number.
    [[nodiscard]] QString takeText(Project& project, int row, const Field& column,
                                   const QString& text) const override;

protected:
    [[nodiscard]] bool relevant(const QModelIndex& index) const override;
    /// The column of the continuous infeed is shown if a stage has it.
    [[nodiscard]] bool shows(const Field& column) const override;
    [[nodiscard]] QString valueShown(const QModelIndex& index) const override;
    [[nodiscard]] int resultColumns() const override { return 1; }
    [[nodiscard]] QVariant resultData(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant resultHeader(int column, int role) const override;

private:
    [[nodiscard]] QString takeSparkOut(Project& project, std::size_t row, const Field& column,
                                       const QString& text) const;
    /// A feed in other units, the shortest last; empty for other cells.
    [[nodiscard]] QStringList formsOf(const QModelIndex& index) const;
    [[nodiscard]] bool isStock(const QModelIndex& index) const;
    [[nodiscard]] bool known(int row) const; ///< whether the last run has this stage
    [[nodiscard]] double stockShare(int row) const;
    [[nodiscard]] double timeShare(int row) const;

    OutcomePtr m_run;     ///< the last valid run
    bool m_stale = false; ///< the inputs are faulty since
};

} // namespace sparkout
