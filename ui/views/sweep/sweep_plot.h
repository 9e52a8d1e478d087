// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
#include "ui/views/sweep/sweep_scale.h"
#include "ui/views/sweep/sweep_text.h"

#include <functional>
#include <optional>
#include <vector>

namespace sparkout {

/// What the two plots of a sweep share: one axis rect over the varied inputs, the point under the
/// mouse, the point chosen, the marks of points without numbers.
class SweepPlot : public ViewPlot {
    Q_OBJECT
public:
    enum Key { presentKey = 1000, chosenKey, limitKey, holdsKey, refusedKey, notReachedKey };

    explicit SweepPlot(QWidget* parent);

    void setSweep(SweepResultPtr sweep, SweepEntry entry, bool margins); ///< no replot
    /// The present values of the inputs, as far as they are given.
    void setPresent(std::vector<std::optional<double>> values);
    void setChosen(std::optional<std::size_t> point);
    void restyle() override;

    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    [[nodiscard]] QPointF pixelOf(std::size_t point) const; ///< in the middle of its marks
    [[nodiscard]] CsvTable table() const override;          ///< the points in sight
    /// A row a point that was run and is wanted: its inputs, its state, the quantities.
    [[nodiscard]] static CsvTable tableOf(const SweepResult& sweep,
                                          const std::vector<std::size_t>& quantities,
                                          const std::function<bool(std::size_t)>& wanted);

signals:
    void pointChosen(std::size_t point); ///< by a click, of the right button too

protected:
    void setTexts() override;

    virtual void fill() = 0;      ///< from what was set
    virtual void fillMarks() = 0; ///< present and chosen point
    virtual void colour() = 0;    ///< by the palette
    virtual void label() = 0;     ///< in the language

    [[nodiscard]] bool empty() const { return !m_sweep || m_entry.quantities.empty(); }
    [[nodiscard]] const SweepResult& sweep() const { return *m_sweep; }
    [[nodiscard]] const SweepEntry& entry() const { return m_entry; }
    [[nodiscard]] bool margins() const { return m_margins; }
    [[nodiscard]] SweepScale scaleOf(std::size_t input) const;
    /// Of the present values; nothing where one is not given, or not positive over ratios.
    [[nodiscard]] std::optional<double> presentPlace(std::size_t input) const;
    [[nodiscard]] const std::optional<std::size_t>& chosen() const { return m_chosen; }
    /// Value or margin of a quantity at a point; NaN where there is none.
    [[nodiscard]] double shownAt(std::size_t point, std::size_t quantity) const;
    [[nodiscard]] bool any(SweepStatus status) const;
    [[nodiscard]] QCPAxis* across() const { return m_rect->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* up() const { return m_rect->axis(QCPAxis::atLeft); }
    /// The values of an input as the plot places them.
    [[nodiscard]] std::vector<double> placesOf(std::size_t input) const;
    [[nodiscard]] QCPGraph* addMarks(QCPAxis* value); ///< a graph of signs without a line
    /// Signs of points without numbers, once; then empty and filled at a height for each point.
    void addStatusMarks(QCPAxis* value, double size);
    void clearStatusMarks();
    void fillStatusMarks(const std::function<double(std::size_t point)>& height);
    /// Entries of points without numbers, as far as there are any.
    void addStatusEntries(LegendEntries& entries) const;
    /// The point nearest to a pixel within the axis rect.
    [[nodiscard]] std::optional<std::size_t> pointAt(const QPointF& pixel) const;

private:
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;

    SweepResultPtr m_sweep;
    SweepEntry m_entry;
    bool m_margins = false;
    std::vector<std::optional<double>> m_present;
    std::optional<std::size_t> m_chosen;
    QCPAxisRect* m_rect;
    QCPGraph *m_refused = nullptr, *m_notReached = nullptr;
    double m_signSize = 0; ///< [px]
};

} // namespace sparkout
