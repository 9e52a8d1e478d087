// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/study_view.h"

#include <functional>
#include <optional>
#include <string>

class QComboBox;
class QPushButton;
class QSplitter;

namespace sparkout {

class ValueModel;
class ChartPlot;
class CopyTable;
class HistogramPlot;
class RunBar;
class SensitivityPlot;

/// The view "Batch": parts that differ by the factors of the project, run one after another. How
/// they scatter against the tolerance band, zone beside zone, with the figures of each; which
/// factor matters most; any two quantities against each other. A quick batch runs by itself when
/// the inputs change, another one on demand; results of other inputs are drawn faint.
class BatchView : public StudyView {
    Q_OBJECT
public:
    explicit BatchView(QWidget* parent = nullptr, Settings* settings = nullptr,
                       Studies* studies = nullptr);

    [[nodiscard]] HistogramPlot* histograms() const { return m_histograms; }
    [[nodiscard]] SensitivityPlot* sensitivity() const { return m_sensitivity; }
    [[nodiscard]] ChartPlot* scatter() const { return m_scatter; }
    [[nodiscard]] const BatchOutcomePtr& batch() const { return studies().batch.result(); }
    [[nodiscard]] const SobolIndicesPtr& indices() const { return studies().indices(); }
    [[nodiscard]] bool busy() const override; ///< runs a batch, or its Sobol indices
    /// What is shown is of other inputs.
    [[nodiscard]] bool stale() const { return studies().batch.stale(); }

    /// Whether the interval of the mean, Pp, Ppk and the verdict they decide may be read.
    void tellIndices(bool tells);

    [[nodiscard]] QString title() const override;

signals:
    /// A run of such inputs is to be kept beside the project, under a name.
    void runWanted(const std::function<std::optional<sparkout::Project>(sparkout::Project)>& inputs,
                   const QString& name);

protected:
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void takeOutcome(const OutcomePtr& before) override;
    [[nodiscard]] bool drawn() const override;
    [[nodiscard]] bool faint() const override;
    [[nodiscard]] const Project* shownProject() const override;
    void showState() override;
    [[nodiscard]] QString keptText() const override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override;

private:
    void dropStudies() override;
    CopyTable* buildFigures();
    void buildRows();
    void connectParts();
    void nameButtons();
    void chooseContent();
    void chooseName();
    void chooseWeights();
    void chooseQuantities();
    void setQuantities();

    void runBatch();
    void takeBatch();
    void takeWorst();
    [[nodiscard]] bool showsIndices() const; ///< Sobol's are chosen
    [[nodiscard]] bool wantsIndices() const; ///< they are, but not there yet
    void runIndices();
    void takeIndices();

    void fillNames();
    void fillQuantities();
    void showBatch();
    void showFigures();
    [[nodiscard]] QString contentNotice() const; ///< why what was chosen shows nothing
    [[nodiscard]] std::string chosenName() const;

    HistogramPlot* m_histograms;
    SensitivityPlot* m_sensitivity;
    ChartPlot* m_scatter;
    ChartPlot* m_pareto;
    QWidget* m_choice = nullptr; ///< of what is drawn, and how it leaves
    QSplitter* m_splitter;
    ValueModel* m_figures;
    CopyTable* m_table = nullptr;
    QComboBox* m_name;
    QComboBox* m_weights; ///< rank regression or Sobol indices
    QComboBox* m_across;
    QComboBox* m_up;
    RunBar* m_bar;
    QPushButton* m_worst;
    QPushButton* m_rows; ///< of all parts, into a file
    QPushButton* m_add;
    std::string m_wanted = "diameter"; ///< characteristic the user chose
    BatchOutcomePtr m_shown;           ///< drawn
    bool m_tellsIndices = true;
};

} // namespace sparkout
