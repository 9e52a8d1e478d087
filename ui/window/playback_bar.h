// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/cycle_cursor.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace sparkout {

class ToolRow;

/// Moves the cursor through the cycle: by steps of a chosen unit, by a slider, or automatically.
class PlaybackBar : public QWidget {
    Q_OBJECT
public:
    explicit PlaybackBar(CycleCursor& cursor, QWidget* parent = nullptr);

    void setPlaying(bool playing); ///< restarts from the end
    [[nodiscard]] bool isPlaying() const { return m_timer.isActive(); }
    [[nodiscard]] CursorUnit unit() const;
    void addTool(QAction* action); ///< at its end
    /// The text on the moment of the cycle; the window places it where a long text fits.
    [[nodiscard]] QLabel* place() const { return m_place; }
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void connectParts();
    void follow(); ///< shows the cursor's position
    void tick();
    void showPlay();
    void showPlace();
    void fillUnits(CursorUnit chosen);
    void fillSpeeds();
    [[nodiscard]] QString placeText() const;

    CycleCursor& m_cursor;
    QTimer m_timer;
    bool m_strokes = true; ///< double strokes are counted, which have steps of revolutions
    QToolButton *m_first, *m_previous, *m_play, *m_next, *m_last;
    QComboBox* m_unit;
    QComboBox* m_speed;
    QSlider* m_slider;
    ToolRow* m_row = nullptr;
    QLabel* m_place;
};

} // namespace sparkout
