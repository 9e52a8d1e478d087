// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/form/harmonics.h"
#include "core/study/profile_series.h"
#include "ui/views/profiles/profile_plot.h"

#include <vector>

namespace sparkout {

/// Amplitudes of a profile over the undulations per revolution: 1 is the eccentricity, 2 an oval.
/// One axis rect for each zone or section side by side, blank and profile as bars, all moved
/// together.
class SpectrumPlot : public ProfilePlot {
    Q_OBJECT
public:
    explicit SpectrumPlot(QWidget* parent = nullptr);

    void setSeries(const ProfileSeries& series, const std::vector<int>& shown); ///< no replot
    void setLogarithmic(bool on);
    void fit() override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeFor(98, 3); }
    void restyle() override;

    [[nodiscard]] int cellCount() const { return static_cast<int>(m_cells.size()); }
    [[nodiscard]] QCPAxisRect* cell(int index) const { return at(index).rect; }
    [[nodiscard]] QCPBars* bars(int index, ProfileLine line) const;
    [[nodiscard]] std::vector<ProfileLine> lines() const override;
    [[nodiscard]] CsvTable table() const override;

protected:
    void setTexts() override;
    void showChoice() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

private:
    struct Cell {
        QString name;
        QCPTextElement* header = nullptr;
        QCPAxisRect* rect = nullptr;
        QCPBars* blank = nullptr;
        QCPBars* profile = nullptr;
        QCPBarsGroup* sideBySide = nullptr;
        std::vector<Harmonic> left; ///< spectrum of the profile
        Zone zone = Zone::section;
        int section = 0;
    };
    [[nodiscard]] const Cell& at(int index) const {
        return m_cells[static_cast<std::size_t>(index)];
    }
    void rebuild(std::size_t count);
    void buildCell(Cell& cell, QCPLayoutGrid& into, int column);
    [[nodiscard]] QCPAxis* amplitudeAxis() const; ///< the others follow it
    [[nodiscard]] double highestBar() const;      ///< [µm]
    void fitAmplitudes();

    std::vector<Harmonic> m_blank;
    std::vector<Cell> m_cells;
    QCPTextElement* m_caption = nullptr;
    QCPRange m_fitted; ///< amplitudes of the last fit
    bool m_logarithmic = true;
};

} // namespace sparkout
