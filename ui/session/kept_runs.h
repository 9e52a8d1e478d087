// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/session/document.h"
#include "ui/session/run_recall.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// The kept runs of a document: keeping, renaming, deleting and restoring are edits of it, so all
/// of it can be undone and is saved. Which of them are laid over the present run is not. They are
/// computed again aside, and held against what was kept. Behind them stand those of the other
/// surfaces of the set-up, to be compared only.
class KeptRuns : public QObject {
    Q_OBJECT

public:
    explicit KeptRuns(Document& document, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<KeptRun>& all() const { return m_document.project().runs; }
    [[nodiscard]] int count() const { return static_cast<int>(all().size()); }
    /// With those of the other surfaces, whose indices follow.
    [[nodiscard]] int listed() const { return static_cast<int>(m_entries.size()); }
    [[nodiscard]] const KeptRun& run(int index) const { return at(index).run; }
    /// The name of the other surface; empty: the one in front.
    [[nodiscard]] const QString& surfaceOf(int index) const { return at(index).surface; }

    enum class Kept { yes, refused, full };
    /// The run of an outcome under the first free name "Run 1", "Run 2", …, and chosen; not when
    /// its inputs are refused, or the project file would grow beyond what is read again. A given
    /// name gets a number, "Worst part (2)", where a kept run has it.
    Kept keep(const Outcome& outcome, const QString& name = {});
    void rename(int index, const QString& name); ///< an empty name changes nothing
    void remove(int index);
    /// Its inputs in place of the present ones; the kept runs stay. False when they can no longer
    /// be read.
    bool restore(int index);

    [[nodiscard]] bool isChosen(int index) const;
    void choose(int index, bool chosen);

    [[nodiscard]] const RecalledRun* recalled(int index) const; ///< null: not yet
    [[nodiscard]] bool busy() const { return m_recall.busy(); }
    /// Whether it comes out otherwise than it was kept.
    [[nodiscard]] bool isChanged(int index) const { return at(index).changed; }
    /// The inputs as run, and the summary as kept; null when they cannot be read.
    [[nodiscard]] const Project* inputs(int index) const;
    [[nodiscard]] const ReadSummary* summary(int index) const;

signals:
    void replaced();    ///< the runs of another document; changed() follows
    void changed();     ///< other runs, names or choices
    void runRecalled(); ///< one more has been computed again

private:
    /// A run as it was read; it never changes but for its name.
    struct Entry {
        KeptRun run;
        QString surface = {};                            ///< its name; empty: the one in front
        mutable std::shared_ptr<const Project> inputs{}; ///< read when first asked for …
        mutable std::optional<std::optional<ReadSummary>> read{}; ///< … and so is the summary
        bool changed = false;
        bool chosen = false;
    };
    void follow(bool another);
    [[nodiscard]] std::vector<Entry> entriesNow() const; ///< as they are in the document, unread
    void request();
    void compare(Entry& entry);
    [[nodiscard]] static const std::optional<ReadSummary>& summaryOf(const Entry& entry);
    [[nodiscard]] const Entry& at(int index) const {
        return m_entries.at(static_cast<std::size_t>(index));
    }

    Document& m_document;
    std::vector<Entry> m_entries;
    RunRecall m_recall;
};

} // namespace sparkout
