// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace sparkout {

/// A plot of a view: dims with a run that is out of date, follows the window's language, palette
/// and font, and tells what is under the mouse.
class ViewPlot : public QCustomPlot {
    Q_OBJECT
public:
    explicit ViewPlot(QWidget* parent = nullptr) : QCustomPlot(parent) {}

    void setDimmed(bool dim);
    [[nodiscard]] bool isDimmed() const { return m_dim; }
    void retranslate();         ///< numbers and texts
    virtual void restyle() = 0; ///< by palette and font

signals:
    void contentChanged();             ///< hence the legend
    void pointed(const QString& text); ///< values under the mouse; empty: at nothing

protected:
    virtual void setTexts() = 0;
    /// When a new font, else a new palette, has come.
    virtual void takeLook(bool font);
    virtual void pointAway();           ///< the mouse has left
    void setBuilt() { m_built = true; } ///< all is there that restyle() needs
    [[nodiscard]] bool isBuilt() const { return m_built; }

    void changeEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    bool m_dim = false, m_built = false;
};

} // namespace sparkout
