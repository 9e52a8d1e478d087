// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/dialogs/part_drawing.h"

#include <QDialog>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;

namespace sparkout {

class AnswerButtons;
class PartDrawing;

/// Asks for the place of a new surface on the part, its initial cycle and its name; for a copy also
/// which parts of the drawing to keep. A step of the shaft gives place, length and diameter. A
/// duplicate is a copy at the same place. The part keeps its wheel; where that leaves a greater Ra
/// than required, the wheel that suits is named.
class AddSurfaceDialog : public QDialog {
    Q_OBJECT

public:
    using IsFreeName = std::function<bool(const QString&)>;

    AddSurfaceDialog(const SetupState& state, const QString& name, IsFreeName isFree,
                     std::optional<std::size_t> step, QWidget* parent = nullptr);

    void onlyDuplicate();                        ///< asks only for the name and the parts to keep
    [[nodiscard]] bool hasAnythingToAsk() const; ///< for a copy: a keyway or tolerances

    [[nodiscard]] QString name() const;
    [[nodiscard]] bool isCopy() const; ///< whether it copies the current surface, keeping its cycle
    [[nodiscard]] Project project() const;
    /// Numbers of its drawing that are yet to be given.
    [[nodiscard]] std::vector<std::string> openInputs() const;
    /// Whether a starting cycle is made once they are given.
    [[nodiscard]] bool startsWhenDrawn() const;

private:
    void askWhatComesAlong();
    void fillPlaces();
    void offerOperation();
    void follow();
    [[nodiscard]] QString wheelText() const;
    [[nodiscard]] std::optional<std::size_t> step() const; ///< empty: at the current place
    void chooseStep(std::size_t step);

    const SetupState m_state;
    const PartOutline m_outline;
    IsFreeName m_isFree;
    QFormLayout* m_form;
    PartDrawing* m_drawing;
    QListWidget* m_places;
    QComboBox* m_begin;
    bool m_isBeginChosen = false; ///< whether the user chose the beginning
    QLineEdit* m_name;
    QLabel* m_wheel;
    QWidget* m_along; ///< parts of the drawing to keep
    QCheckBox *m_gaps, *m_deviations, *m_tolerances;
    AnswerButtons* m_buttons;
};

} // namespace sparkout
