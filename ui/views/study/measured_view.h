// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/adequacy.h"
#include "ui/chart/plot_view.h"

#include <array>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSplitter;
class QStackedWidget;

namespace sparkout {

class BarPlot;
class CopyTable;
class DataSheet;
class Document;
class RunBar;
class ValueModel;

/// The view "Measured": measured parts against the batch that the project predicts, as boxes, as a
/// table and in words; and the measured data themselves, to edit. A quick batch runs by itself when
/// the inputs change, another one on demand; results of other inputs are drawn faint.
class MeasuredView : public StudyView {
    Q_OBJECT
public:
    enum Sheet { comparison, parts, summaries, traces };

    explicit MeasuredView(Document& document, QWidget* parent = nullptr,
                          Settings* settings = nullptr, Studies* studies = nullptr);

    [[nodiscard]] BarPlot* boxes() const { return m_boxes; }
    [[nodiscard]] const std::vector<AdequacyRow>& rows() const { return m_rows; }
    [[nodiscard]] bool busy() const override { return studies().prediction.running(); }
    /// Whether the result belongs to other inputs.
    [[nodiscard]] bool stale() const { return studies().prediction.stale(); }

    void offerCalibration(bool offers); ///< the button that calibrates

    [[nodiscard]] QString title() const override;

signals:
    void importAsked();
    void pasteAsked();
    void calibrateAsked();

protected:
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void takeOutcome(const OutcomePtr& before) override;
    void dropOutcome() override;
    [[nodiscard]] bool drawn() const override;
    [[nodiscard]] bool faint() const override;
    void showState() override;
    [[nodiscard]] QString keptText() const override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void dropStudies() override;
    QWidget* buildTools();
    QWidget* buildComparison();
    void connectParts();
    void chooseSheet();
    void chooseQuantity();
    [[nodiscard]] bool isComparing() const;
    [[nodiscard]] bool hasStatistics() const;
    [[nodiscard]] const BatchOutcomePtr& batch() const { return studies().prediction.result(); }
    void runBatch();
    void takeBatch();
    void judge();
    void showComparison();
    void fillQuantities();
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QString recordedText() const; ///< empty without traces

    BarPlot* m_boxes;
    ValueModel* m_model;
    std::vector<AdequacyRow> m_rows; ///< its rows
    CopyTable* m_table = nullptr;
    QLabel* m_judgement;
    QScrollArea* m_judged = nullptr; ///< its scroll area
    QSplitter* m_splitter;
    QStackedWidget* m_sheets;
    QComboBox* m_sheet;
    QComboBox* m_quantity;
    RunBar* m_bar;
    QPushButton *m_import, *m_paste, *m_calibrate;
    QPushButton* m_start; ///< in the empty view
    std::array<DataSheet*, 3> m_data{};
    MeasuredQuantity m_wanted = MeasuredQuantity::diameter_deviation;
    bool m_hasStatistics = false;
};

} // namespace sparkout
