// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
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

/// Two linked rings beside an input shared by all surfaces of a set-up.
class SharedMark : public QWidget {
    Q_OBJECT

public:
    explicit SharedMark(QWidget* parent = nullptr);

    [[nodiscard]] static QString text(); ///< "for all surfaces"
    void retranslate();
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

/// A dot beside an input that differs from its default; a click restores it.
class ResetMark : public QAbstractButton {
    Q_OBJECT

public:
    explicit ResetMark(QWidget* parent = nullptr);

    void showChanged(bool changed);
    void showDefault(const QString& label, const QString& defaultText);
    [[nodiscard]] QString menuText() const; ///< "Reset to the default (0.3)"

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_default;
};

} // namespace sparkout
