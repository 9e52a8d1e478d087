// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/catalogue_store.h"

#include <QWidget>

#include <memory>
#include <optional>

class QPushButton;

namespace sparkout {

class Document;
class ReasonLabel;
class Settings;

/// At the head of a page of the inputs: takes values from a catalogue, and keeps the page's in the
/// user's own.
class CatalogueBar : public QWidget {
    Q_OBJECT

public:
    /// Without settings the own entries live as long as this does.
    CatalogueBar(CatalogueKind kind, Document& document, Settings* settings, QWidget* parent);
    ~CatalogueBar() override;

    void retranslate();
    /// The project as the entry of its name makes it; nothing where the catalogue has none.
    [[nodiscard]] std::optional<Project> asInCatalogue();

private:
    void choose();
    void keep();
    [[nodiscard]] CatalogueStore& store(); ///< read when it is first asked for
    [[nodiscard]] QString nameInProject() const;

    CatalogueKind m_kind;
    Document& m_document;
    Settings* m_settings;
    std::unique_ptr<CatalogueStore> m_store;
    QPushButton* m_choose;
    QPushButton* m_keep;
    ReasonLabel* m_fault; ///< why nothing was kept
};

} // namespace sparkout
