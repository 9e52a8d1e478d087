// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/part_rows_file.h"

#include "core/batch/scenario_source.h"

#include <cstdint>
#include <utility>

namespace sparkout {

PartSink PartRowsFile::begin(const ScenarioSource& source, const std::stop_token& stop) {
    PartColumns columns = PartColumns::of(source, stop);
    const std::vector<std::string> head = m_form.head(columns);
    m_table = std::make_unique<PartTable>(std::move(columns), m_form.dialect);
    m_file.write(m_table->head(head));
    return [this](const PartRecord& record) { return m_file.write(m_table->line(record)); };
}

bool PartRowsFile::runBatch(const Project& project, BatchOptions options,
                            const KeepGoing& keepGoing) {
    const ScenarioSource source(project);
    const auto parts = static_cast<double>(source.parts());
    std::int64_t done = 0;
    options.sink = [&keepGoing, &done, parts,
                    write = begin(source, options.stop)](const PartRecord& record) {
        return keepGoing(static_cast<double>(++done) / parts) && write(record);
    };
    return !error() && sparkout::runBatch(project, options).status == BatchStatus::completed
           && finish();
}

} // namespace sparkout
