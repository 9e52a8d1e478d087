// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/measured_reader.h"

#include <utility>

namespace sparkout {

MeasuredReader::MeasuredReader(QObject* parent) : QObject(parent) {}

void MeasuredReader::start(const MeasuredSourcePtr& source, const MeasuredTable& table,
                           const MeasuredContext& context) {
    m_running = true;
    m_job.start(
        [this, source, table, context](const std::stop_token& stop, const NewestJob::Post& post) {
            ReadMeasured read = readMeasured(source->text, table, context, stop);
            if (stop.stop_requested()) {
                return;
            }
            post([this, answer = std::make_shared<const ReadMeasured>(std::move(read))] {
                m_running = false;
                emit finished(answer);
            });
        });
}

void MeasuredReader::stop() {
    m_job.stop();
    m_running = false;
}

} // namespace sparkout
