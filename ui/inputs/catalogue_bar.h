// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/catalogue_store.h"

#include <QDialog>
#include <QWidget>

#include <memory>
#include <optional>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace sparkout {

class Settings;
class StiffnessOffer;

/// A catalogue to choose from: search, entries with their main numbers and sources, and the changes
/// that the chosen one would make to the project. Also renames and deletes the user's own entries.
class CatalogueDialog : public QDialog {
    Q_OBJECT

public:
    CatalogueDialog(CatalogueStore& store, Project project, Settings* settings, QWidget* parent);
    ~CatalogueDialog() override;

    [[nodiscard]] const CatalogueItem* chosen() const; ///< may be null
    /// The project with the chosen parts of the chosen entry. Requires an entry.
    [[nodiscard]] Project taken() const;
    [[nodiscard]] static QString title(CatalogueKind kind);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    QWidget* buildList();
    QWidget* buildPreview();
    void fill(const QString& current); ///< and selects the entry with that name
    void filter();
    void showChosen();
    void showPreview();
    void showFault();
    [[nodiscard]] bool complianceIsGiven() const; ///< stiffnesses are then not used
    void putAside();
    void renameOwn();
    void removeOwn();
    void finishChange(const QString& fault, const QString& name);

    CatalogueStore& m_store;
    Project m_project;
    Settings* m_settings;
    QLabel* m_fault;
    QPushButton* m_aside;
    QLineEdit* m_search;
    QLabel* m_found;
    QTreeWidget* m_list;
    QLabel* m_note;
    QTreeWidget* m_preview;
    StiffnessOffer* m_stiffness;
    QLabel* m_refused;
    QPushButton* m_rename;
    QPushButton* m_remove;
    QPushButton* m_take = nullptr;
};

class Document;
class ReasonLabel;

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
