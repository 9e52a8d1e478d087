// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/profiles_look.h"
#include "ui/views/part/framed_plot.h"
#include "ui/views/part/profile_cell.h"

#include <QCoreApplication>
#include <QString>

#include <optional>
#include <utility>
#include <vector>

class QWidget;

namespace sparkout {

/// A cross-section recorded by a roundness machine, for comparison with the predicted ones.
struct MeasuredSection {
    Q_DECLARE_TR_FUNCTIONS(MeasuredSection)

public:
    QString name; ///< name of its file
    std::vector<double> radii_mm;

    /// Asks for a table of angles and radii and reads it; shows any error.
    [[nodiscard]] static std::optional<MeasuredSection> ask(QWidget* window,
                                                            double nominalRadius_mm);
    /// Reads a file; empty, with the reason, if it is invalid.
    [[nodiscard]] static std::optional<MeasuredSection>
    read(const QString& path, double nominalRadius_mm, QString& reason);
};

/// Cross-sections side by side with magnified deviations: one cell for each zone or section, all at
/// the same scale and magnification and moved together. Samples are joined by straight lines.
class ProfilesPlot : public FramedPlot {
    Q_OBJECT
public:
    explicit ProfilesPlot(QWidget* parent = nullptr);

    /// Sets the profiles with these indices; drawn by replot().
    void setSeries(ProfileSeries series, std::vector<int> shown);
    void setReference(RadiusReference reference);
    void setMagnification(std::optional<double> wanted); ///< empty: chosen by the program
    void setCircles(ReferenceCircles circles);
    void setFilter(std::optional<int> cutoff_upr); ///< applied before the circles are fitted
    /// Adds a measured profile, in a cell of its own after the others; empty: removes it.
    void setMeasured(std::optional<MeasuredSection> measured);
    void fit() override; ///< fits all cells
    /// Includes names, numbers in three lines and the caption in two.
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeFor(126, 6); }
    void restyle() override;

    [[nodiscard]] const ProfileSeries& series() const { return m_series; }
    [[nodiscard]] const std::vector<int>& shown() const { return m_shown; }
    [[nodiscard]] double magnification() const { return m_magnification; }
    [[nodiscard]] std::vector<double> magnifications() const; ///< currently available ones
    [[nodiscard]] QString caption() const;
    [[nodiscard]] std::vector<ProfileLine> lines() const override;
    [[nodiscard]] CsvTable table() const override;

    [[nodiscard]] QCPAxisRect* cell(int index) const { return at(index).rect(); }
    /// For the minimum zone, the outer circle.
    [[nodiscard]] QCPCurve* curve(int index, ProfileLine line) const;
    [[nodiscard]] QCPCurve* innerCircle(int index) const { return at(index).innerCircle(); }
    [[nodiscard]] QCPCurve* centreMark(int index) const { return at(index).centreMark(); }
    [[nodiscard]] QCPCurve* contacts(int index) const { return at(index).contacts(); }
    [[nodiscard]] ReferenceCircles circles() const { return m_circles; }
    [[nodiscard]] const std::optional<MeasuredSection>& measured() const { return m_measured; }
    /// The profile as drawn: filtered, with the chosen circles.
    [[nodiscard]] const Profile& drawn(int index) const {
        return m_drawn.at(static_cast<std::size_t>(index));
    }
    [[nodiscard]] QString describeMeasured() const; ///< empty if there is none
    [[nodiscard]] PolarRing* field(int index) const { return at(index).field(); }
    [[nodiscard]] PolarCircle* target(int index) const { return at(index).target(); }
    [[nodiscard]] PolarGrid* grid(int index) const { return at(index).grid(); }
    [[nodiscard]] PolarPointer* pointer(int index) const { return at(index).pointer(); }
    [[nodiscard]] QString numbers(int index) const;

protected:
    void setTexts() override;
    void showChoice() override { fit(); }
    void takeLook(bool font) override;
    void onMouse(QMouseEvent* event) override;
    void pointAway() override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// The number of cells in a row, and whether their numbers are beside them.
    struct Arrangement {
        int columns = 1;
        bool beside = false;
        bool operator==(const Arrangement&) const = default;
    };

    [[nodiscard]] const ProfileCell& at(int index) const {
        return m_cells.at(static_cast<std::size_t>(index));
    }
    [[nodiscard]] const Profile& profile(std::size_t cell) const { return m_drawn[cell]; }
    [[nodiscard]] bool isMeasured(std::size_t cell) const { return cell >= m_shown.size(); }
    [[nodiscard]] std::size_t cellCount() const {
        return m_shown.empty() ? 0 : m_shown.size() + (m_measured ? 1 : 0);
    }
    [[nodiscard]] QString nameOf(std::size_t cell) const;
    [[nodiscard]] std::pair<QString, QString> circleNames() const;
    [[nodiscard]] Reach reach() const;
    [[nodiscard]] PolarScale scaleOf(std::size_t cell) const;
    [[nodiscard]] Arrangement arrangement() const;
    void rebuild();
    void clearCells();
    void buildCell(QCPLayoutGrid& into);
    void drawProfiles(); ///< the displayed profiles
    void chooseMagnification();
    void fill();
    [[nodiscard]] QString numbersOf(std::size_t cell, bool brief) const;
    [[nodiscard]] QString headerOf(std::size_t cell, int room) const;
    void keepScales();
    void pointAt(int cell, int k);

    ProfileSeries m_series;
    std::vector<int> m_shown;
    std::optional<MeasuredSection> m_measured;
    std::vector<Profile> m_drawn; ///< cell by cell
    std::vector<ProfileCell> m_cells;
    QCPTextElement* m_caption = nullptr;
    Arrangement m_arrangement;
    RadiusReference m_reference = RadiusReference::target;
    std::optional<double> m_wanted; ///< requested magnification
    double m_magnification = 1;
    double m_reach = 1; ///< radius of the drawing
    ReferenceCircles m_circles = ReferenceCircles::leastSquares;
    std::optional<int> m_cutoff_upr;
    int m_pointedCell = 0;
    int m_pointedRadius = -1;
};

} // namespace sparkout
