// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "ui/session/part_runs.h"
#include "ui/session/setup_state.h"

#include <QIcon>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <cstddef>
#include <optional>
#include <vector>

namespace sparkout {

/// The times of a part with their formulas and numbers, one per line.
[[nodiscard]] QString pieceTimeText(const SetupTimes& times, std::size_t surfaces,
                                    std::optional<double> cycles_min);

/// The headline of its judgement; "inputs refused", "not run".
[[nodiscard]] QString statusText(const SurfaceStatus& status);

/// The requirement to report first, with its margin: "Roundness +1.2 µm"; empty: not run.
[[nodiscard]] QString worstText(const SurfaceStatus& status);

/// The mark of its judgement: a ring if it was not run, a cross for refused inputs.
[[nodiscard]] QPixmap statusPixmap(const SurfaceStatus& status, int size, qreal ratio);

/// The part of a set-up as drawn from the side: the steps of its body, and the ground surfaces.
struct PartOutline {
    struct Step {
        double from_mm = 0; ///< distance from the headstock end
        double length_mm = 0;
        double diameter_mm = 0;

        [[nodiscard]] double to_mm() const { return from_mm + length_mm; }
    };
    struct Ground : Step {
        bool isInternal = false;
    };

    std::vector<Step> steps;      ///< from the headstock; those of the drawing
    std::vector<Ground> surfaces; ///< in the order of the set-up
    bool hasSteps = false;        ///< false: the body is assumed around the ground surfaces
    double length_mm = 0;
    double diameter_mm = 0; ///< the largest

    [[nodiscard]] static PartOutline of(const SetupState& state);

    [[nodiscard]] std::optional<std::size_t> stepAt(double x_mm) const;
    /// The surface at a place: of several the shortest.
    [[nodiscard]] std::optional<std::size_t> surfaceAt(double x_mm) const;
    /// Whether no more than a part of a step is ground.
    [[nodiscard]] bool isFree(std::size_t step) const;
    [[nodiscard]] std::optional<std::size_t> firstFreeStep() const;
};

/// The part from the side, to scale: its steps in thin lines, ground surfaces in bold ones with
/// their numbers. Clicks report their place; the keyboard uses the list beside it.
class PartDrawing : public QWidget {
    Q_OBJECT

public:
    explicit PartDrawing(QWidget* parent = nullptr);

    void setOutline(PartOutline outline);
    void setPresent(std::optional<std::size_t> surface); ///< drawn as the current one
    void setChosenStep(std::optional<std::size_t> step); ///< where a surface is to be added
    void setTips(QStringList tips);                      ///< tool tips of the surfaces
    [[nodiscard]] const PartOutline& outline() const { return m_outline; }
    [[nodiscard]] double xOf(double place_mm) const; ///< in widget coordinates
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void surfaceClicked(std::size_t surface);
    void stepClicked(std::size_t step);
    void freeStepEntered(std::size_t step); ///< by a double click

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] double scale() const; ///< pixels a millimetre
    [[nodiscard]] double placeAt(double x) const;
    [[nodiscard]] QRectF box(const PartOutline::Step& step) const;
    void drawBody(QPainter& painter) const;
    void drawSurface(QPainter& painter, std::size_t surface) const;
    void drawNumbers(QPainter& painter) const;

    PartOutline m_outline;
    std::optional<std::size_t> m_present;
    std::optional<std::size_t> m_step;
    QStringList m_tips;
};

} // namespace sparkout
