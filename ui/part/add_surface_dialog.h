// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/part/part_outline.h"

#include <QDialog>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QListWidget;

namespace sparkout {

class AnswerButtons;
class PartDrawing;

/// Asks where on the part a further surface is, which cycle it begins with, and its name; of a copy
/// also what of the drawing comes along. A step of the shaft gives it place, length and diameter. A
/// duplicate is a copy that stays in its place.
class AddSurfaceDialog : public QDialog {
    Q_OBJECT

public:
    using IsFreeName = std::function<bool(const QString&)>;

    AddSurfaceDialog(const SetupState& state, const QString& name, IsFreeName isFree,
                     std::optional<std::size_t> step, QWidget* parent = nullptr);

    void onlyDuplicate();                        ///< asks for the name and what comes along alone
    [[nodiscard]] bool hasAnythingToAsk() const; ///< of a copy: a keyway or tolerances

    [[nodiscard]] QString name() const;
    [[nodiscard]] bool isCopy() const; ///< of the surface in front: its cycle stays
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
    [[nodiscard]] std::optional<std::size_t> step() const; ///< nothing: where the present one is
    void chooseStep(std::size_t step);

    const SetupState m_state;
    const PartOutline m_outline;
    IsFreeName m_isFree;
    QFormLayout* m_form;
    PartDrawing* m_drawing;
    QListWidget* m_places;
    QComboBox* m_begin;
    bool m_isBeginChosen = false; ///< by the user
    QLineEdit* m_name;
    QWidget* m_along; ///< what comes along
    QCheckBox *m_gaps, *m_deviations, *m_tolerances;
    AnswerButtons* m_buttons;
};

} // namespace sparkout
