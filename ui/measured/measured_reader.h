// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/measured_table.h"
#include "core/tables/table_text.h"
#include "ui/session/newest_job.h"

#include <QObject>
#include <QString>

#include <memory>

namespace sparkout {

/// The text of a table of measurements, and its origin.
struct MeasuredSource {
    QString name; ///< name of the file; empty: pasted
    TableText text;
};

using MeasuredSourcePtr = std::shared_ptr<const MeasuredSource>;

using ReadMeasuredPtr = std::shared_ptr<const ReadMeasured>;

/// Reads a table of measurements off the window's thread; a newer reading drops the older one.
class MeasuredReader : public QObject {
    Q_OBJECT
public:
    explicit MeasuredReader(QObject* parent = nullptr);

    void start(const MeasuredSourcePtr& source, const MeasuredTable& table,
               const MeasuredContext& context);
    void stop();
    [[nodiscard]] bool running() const { return m_running; }

signals:
    void finished(sparkout::ReadMeasuredPtr read);

private:
    bool m_running = false;
    NewestJob m_job; ///< last member: destroyed before the objects its work uses
};

} // namespace sparkout
