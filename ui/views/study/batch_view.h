// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/chart/plot_view.h"
#include "ui/dialogs/table_file.h"

#include <functional>
#include <optional>
#include <string>

class QComboBox;
class QPushButton;
class QSplitter;

namespace sparkout {

/// Asks for a file and runs the batch again with a row for every part in a CSV file: factors,
/// quantities, requirements. Shows progress; a stop leaves no file. True once it is saved.
bool savePartRows(QWidget* window, Settings* settings, const Project& project, TableFormat format);

class ValueModel;
class ChartPlot;
class CopyTable;
class RunBar;
class SensitivityPlot;

/// The view "Batch": parts that differ by the factors of the project. It shows their scatter
/// against the tolerance, zone by zone with the figures of each, the influence of the factors, and
/// any two quantities against each other. A short batch runs by itself after a change of the
/// inputs, a long one on demand; outdated results are drawn faint.
class BatchView : public StudyView {
    Q_OBJECT
public:
    explicit BatchView(QWidget* parent = nullptr, Settings* settings = nullptr,
                       Studies* studies = nullptr);

    [[nodiscard]] ChartPlot* histograms() const { return m_histograms; }
    [[nodiscard]] SensitivityPlot* sensitivity() const { return m_sensitivity; }
    [[nodiscard]] ChartPlot* scatter() const { return m_scatter; }
    [[nodiscard]] const BatchOutcomePtr& batch() const { return studies().batch.result(); }
    [[nodiscard]] const SobolIndicesPtr& indices() const { return studies().indices(); }
    [[nodiscard]] bool busy() const override; ///< runs a batch, or its Sobol indices
    /// Whether the result belongs to other inputs.
    [[nodiscard]] bool stale() const { return studies().batch.stale(); }

    /// Whether the interval of the mean, Pp, Ppk and the verdict based on them are shown.
    void tellIndices(bool tells);

    [[nodiscard]] QString title() const override;

signals:
    /// Requests a run of these inputs, to be kept with the project under a name.
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
    [[nodiscard]] bool showsIndices() const; ///< Sobol indices are chosen
    [[nodiscard]] bool wantsIndices() const; ///< they are needed, but not computed yet
    void runIndices();
    void takeIndices();

    void fillNames();
    void fillQuantities();
    void showBatch();
    void showFigures();
    [[nodiscard]] QString contentNotice() const; ///< why the chosen content is empty
    [[nodiscard]] std::string chosenName() const;

    ChartPlot* m_histograms;
    SensitivityPlot* m_sensitivity;
    ChartPlot* m_scatter;
    ChartPlot* m_pareto;
    QWidget* m_choice = nullptr; ///< content and exports
    QSplitter* m_splitter;
    ValueModel* m_figures;
    CopyTable* m_table = nullptr;
    QComboBox* m_name;
    QComboBox* m_weights; ///< rank regression or Sobol indices
    QComboBox* m_across;
    QComboBox* m_up;
    RunBar* m_bar;
    QPushButton* m_worst;
    QPushButton* m_rows; ///< writes all parts to a file
    QPushButton* m_add;
    std::string m_wanted = "diameter"; ///< characteristic the user chose
    BatchOutcomePtr m_shown;           ///< the drawn batch
    std::string m_drawn;               ///< characteristic of the drawn histograms
    bool m_tellsIndices = true;
};

} // namespace sparkout
