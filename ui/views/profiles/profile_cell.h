// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/magnified_profile.h"
#include "ui/charts/profiles_look.h"

#include <QFont>
#include <QPalette>
#include <QPen>

class QCPAxisRect;
class QCPCurve;
class QCPLayoutGrid;
class QCPTextElement;
class QCustomPlot;

namespace sparkout {

class PolarCircle;
class PolarGrid;
class PolarPointer;
class PolarRing;

/// One cross-section of ProfilesPlot: its header, its drawing and its numbers, beside or below. The
/// parts belong to the plot.
class ProfileCell {
public:
    ProfileCell(QCustomPlot& plot, QCPLayoutGrid& into, bool numbersBeside);

    /// Draws a profile within this distance from the centre.
    void fill(const ProfileSeries& series, const Profile& profile, const PolarScale& scale,
              double reach, const ProfileLines& hidden, ReferenceCircles circles);
    /// Hides blank, target and tolerance: of a measured profile only the form is known.
    void showFormAlone() const;
    void restyle(const QFont& font, const QPalette& palette, bool dim);
    void point(const Profile& profile, const PolarScale& scale, int k);
    void removeLayers(); ///< removes parts that are neither plottables nor in a layout

    [[nodiscard]] QCPTextElement* header() const { return m_header; }
    [[nodiscard]] QCPTextElement* numbers() const { return m_numbers; }
    [[nodiscard]] QCPAxisRect* rect() const { return m_rect; }
    [[nodiscard]] PolarRing* field() const { return m_field; }
    [[nodiscard]] PolarCircle* target() const { return m_target; }
    [[nodiscard]] PolarGrid* grid() const { return m_grid; }
    [[nodiscard]] PolarPointer* pointer() const { return m_pointer; }
    [[nodiscard]] QCPCurve* profile() const { return m_profile; }
    [[nodiscard]] QCPCurve* blank() const { return m_blank; }
    [[nodiscard]] QCPCurve* leastSquares() const { return m_leastSquares; }
    [[nodiscard]] QCPCurve* innerCircle() const { return m_inner; }
    [[nodiscard]] QCPCurve* outerCircle() const { return m_outer; }
    [[nodiscard]] QCPCurve* centreMark() const { return m_centre; }
    [[nodiscard]] QCPCurve* contacts() const { return m_contacts; }

private:
    void arrange(QCPLayoutGrid& into, bool numbersBeside) const;
    void fillCircles(const Profile& profile, const PolarScale& scale, const ProfileLines& hidden,
                     ReferenceCircles circles);
    void setCirclePens();

    QCPTextElement* m_header;
    QCPTextElement* m_numbers;
    QCPAxisRect* m_rect;
    PolarRing* m_field;
    PolarGrid* m_grid;
    PolarCircle* m_target;
    PolarPointer* m_pointer;
    QCPCurve* m_blank;
    QCPCurve* m_leastSquares;
    QCPCurve* m_inner; ///< circles of the minimum zone, or the reference circles
    QCPCurve* m_outer;
    QCPCurve* m_centre; ///< centre of the circles
    QCPCurve* m_profile;
    QCPCurve* m_contacts; ///< contacts of the minimum zone
    QPen m_circlePen;
    ReferenceCircles m_circles = ReferenceCircles::none;
};

} // namespace sparkout
