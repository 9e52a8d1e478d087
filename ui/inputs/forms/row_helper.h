// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/part.h"
#include "ui/session/document.h"
#include "ui/text/size_field.h"

#include <QWidget>

#include <optional>
#include <string>

class QLabel;
class QLineEdit;
class QPushButton;

namespace sparkout {

/// What stands beside a row of the inputs and fills others from what is typed there.
class RowHelper : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;
    virtual void retranslate() = 0;
    [[nodiscard]] virtual bool standsFirst() const { return false; } ///< above its row, not below
    /// Takes a text that the row itself refuses; false where it means nothing here.
    virtual bool take(const QString&) { return false; }
};

/// The helper of the row at a path; null where there is none.
[[nodiscard]] RowHelper* makeRowHelper(const std::string& path, Document& document,
                                       QWidget* parent);

/// Says what the wheel's marking means, and fills the wheel from it.
class MarkingHelper : public RowHelper {
    Q_OBJECT

public:
    MarkingHelper(Document& document, QWidget* parent);
    void retranslate() override;

private:
    void showMarking();
    void fill();

    Document& m_document;
    QLabel* m_meaning;
    QPushButton* m_fill;
};

/// A part of the project that may not be given yet, and a usual one of it.
struct Offer {
    const char *noteName, *buttonName; ///< of the widgets
    bool (*isGiven)(const Project& project);
    Project (*give)(Project project);
    EditText edit;
    const char *purpose, *note, *button, *tip; ///< to be translated
    /// What is offered, for %1 of the note.
    QString (*value)(const Project& project) = nullptr;
};

/// Says what the part is for and offers the usual one, as long as it is not given.
class OfferHelper : public RowHelper {
    Q_OBJECT

public:
    OfferHelper(const Offer& offer, Document& document, QWidget* parent);
    void retranslate() override;

private:
    void showOffer();

    const Offer& m_offer;
    Document& m_document;
    QLabel* m_note;
    QPushButton* m_add;
};

/// Takes a size with its tolerance class, 30h6, says what it means, and fills diameter and limits
/// from it when it is left or Enter is pressed; also one that is typed into the diameter.
class SizeHelper : public RowHelper {
    Q_OBJECT

public:
    SizeHelper(Document& document, QWidget* parent);
    void retranslate() override;
    [[nodiscard]] bool standsFirst() const override { return true; }
    bool take(const QString& text) override;

private:
    void showPart();
    void showTyped();
    [[nodiscard]] std::optional<TypedSize> toFill() const;
    void fill();

    Document& m_document;
    QLabel* m_label;
    QLineEdit* m_size;
    QLabel* m_meaning;
};

/// Takes a keyway as a drawing states it, 12P9 × 45, says what it is to the model, and makes it a
/// gap of the surface when it is left or Enter is pressed. One that begins within a gap takes its
/// place.
class KeywayHelper : public RowHelper {
    Q_OBJECT

public:
    KeywayHelper(Document& document, QWidget* parent);
    void retranslate() override;

private:
    /// What is typed as a gap of the part: its words, or why it is none.
    struct Typed {
        std::optional<SurfaceGap> gap;
        QString text;
    };
    [[nodiscard]] Typed typed() const;
    void showTyped();
    void fill();

    Document& m_document;
    QLabel* m_label;
    QLineEdit* m_keyway;
    QLabel* m_meaning;
};

} // namespace sparkout
