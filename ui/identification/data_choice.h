// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QGroupBox>

#include <vector>

class QCheckBox;

namespace sparkout {

/// The choice of measurements for a fit: traces, and the diameters of the parts.
class DataChoice : public QGroupBox {
    Q_OBJECT

public:
    explicit DataChoice(const Project& project, QWidget* parent = nullptr);

    [[nodiscard]] std::vector<int> traces() const; ///< indices in the project
    [[nodiscard]] bool withParts() const;

signals:
    void changed();

private:
    QCheckBox* add(const QString& text, const QString& name);

    std::vector<QCheckBox*> m_traces;
    std::vector<int> m_numbers;   ///< numbers of the traces
    QCheckBox* m_parts = nullptr; ///< null: no part has a diameter
};

} // namespace sparkout
