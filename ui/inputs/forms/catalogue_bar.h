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

/// At the top of a page of the inputs: takes values from a catalogue, and saves the page's in the
/// user's own.
class CatalogueBar : public QWidget {
    Q_OBJECT

public:
    /// Without settings the own entries are lost with this object.
    CatalogueBar(CatalogueKind kind, Document& document, Settings* settings, QWidget* parent);
    ~CatalogueBar() override;

    void retranslate();
    /// The project with the catalogue entry of its name; empty if there is none.
    [[nodiscard]] std::optional<Project> asInCatalogue();

private:
    void choose();
    void keep();
    [[nodiscard]] CatalogueStore& store(); ///< read at the first call
    [[nodiscard]] QString nameInProject() const;

    CatalogueKind m_kind;
    Document& m_document;
    Settings* m_settings;
    std::unique_ptr<CatalogueStore> m_store;
    QPushButton* m_choose;
    QPushButton* m_keep;
    ReasonLabel* m_fault; ///< why saving failed
};

} // namespace sparkout
