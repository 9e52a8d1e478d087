// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace sparkout {

/// A ruler beside an input whose value was found from measurements, struck through if it has
/// changed since. The tool tip has the details.
class CalibratedMark : public QWidget {
    Q_OBJECT

public:
    explicit CalibratedMark(QWidget* parent = nullptr);

    void showCalibration(bool holds, const QString& details); ///< empty details: not calibrated
    [[nodiscard]] bool holds() const { return m_holds; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool m_holds = true;
};

} // namespace sparkout
