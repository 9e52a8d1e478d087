// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/number_field.h"

#include <QGroupBox>

#include <string>
#include <vector>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace sparkout {

class Document;
class ReasonLabel;

/// The compliance: a field a zone (traverse) or a section (plunge), or a tick that leaves it to
/// stiffness and shaft; what of these is not given yet gets usual values with the tick.
class ComplianceBox : public QGroupBox {
    Q_OBJECT

public:
    ComplianceBox(std::string path, const Field& field, Document& document,
                  QWidget* parent = nullptr);

    void show(bool replaced);
    void setIssues(const Issues& issues);
    void retranslate();
    [[nodiscard]] QStringList refusals() const;
    bool focusPath(const std::string& path);

private:
    struct Line {
        std::string key; ///< last part of the path
        QLabel* label;
        NumberField* field;
        QLabel* unit;
        ReasonLabel* reason;
    };

    void build(const std::vector<std::string>& keys);
    void addLine(const std::string& key);
    void store(std::size_t index);
    void showReason(const Line& line);
    void retranslate(const Line& line);

    std::string m_path;
    const Field& m_field;
    Document& m_document;
    QCheckBox* m_computed;
    ReasonLabel* m_reason;
    QWidget* m_body;
    QGridLayout* m_grid = nullptr;
    std::vector<Line> m_lines;
    Issues m_issues;
};

} // namespace sparkout
