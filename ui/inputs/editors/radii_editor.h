// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/editors/project_model.h"

class QLabel;
class QPushButton;

namespace sparkout {

/// The measured profile of the blank: a summary line, a button that reads it from a CSV file and
/// one that removes it. An unreadable file leaves the profile unchanged and shows the reason.
class RadiiEditor : public FieldEditor {
    Q_OBJECT

public:
    RadiiEditor(const std::string& path, const Field& field, ProjectModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_body; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override;
    void dropRefusal() override { refuse({}, {}); }
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }

    void readFrom(const QString& path);

private:
    void askForFile();
    void clear();
    void refuse(const QString& file, const QString& reason);
    [[nodiscard]] QString summary() const;

    Document& m_document;
    QWidget* m_body;
    QLabel* m_summary;
    QPushButton* m_read;
    QPushButton* m_clear;
    QString m_refused; ///< why the last file was refused; empty: accepted
};

} // namespace sparkout
