// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/part.h"
#include "ui/session/document.h"
#include "ui/text/designation_text.h"

#include <QWidget>

#include <optional>
#include <string>

class QLabel;
class QLineEdit;
class QPushButton;

namespace sparkout {

/// A helper beside a row of the inputs that fills others from text typed in it.
class RowHelper : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;
    virtual void retranslate() = 0;
    [[nodiscard]] virtual bool standsFirst() const { return false; } ///< above its row, not below
    /// Accepts a text that the row itself refuses; false if it has no meaning here.
    virtual bool take(const QString&) { return false; }
};

/// The helper of the row at a path; null if there is none.
[[nodiscard]] RowHelper* makeRowHelper(const std::string& path, Document& document,
                                       QWidget* parent);

/// Explains the wheel's marking, and fills in the wheel from it.
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

/// An optional part of the project, and a usual value of it.
struct Offer {
    const char *noteName, *buttonName; ///< names of the widgets
    bool (*isGiven)(const Project& project);
    Project (*give)(Project project);
    EditText edit;
    const char *purpose, *note, *button, *tip; ///< to be translated
    /// The offered value, for %1 of the note.
    QString (*value)(const Project& project) = nullptr;
};

/// Explains the part and offers the usual one as long as it is not given.
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

/// Accepts a size with its tolerance class, 30h6, shows its meaning, and fills diameter and limits
/// from it when the focus leaves or on Enter; also accepts one typed into the diameter.
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

/// Accepts a keyway in the notation of drawings, 12P9 × 45, shows its meaning for the model, and
/// makes it a gap of the surface when the focus leaves or on Enter. A keyway that begins within a
/// gap replaces it.
class KeywayHelper : public RowHelper {
    Q_OBJECT

public:
    KeywayHelper(Document& document, QWidget* parent);
    void retranslate() override;

private:
    /// A typed gap of the part: its description, or the error.
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
