// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "core/study/run_comparison.h"
#include "ui/session/document.h"
#include "ui/session/job.h"

#include <QObject>
#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sparkout {

/// Recomputes kept runs one after the other outside the window's thread: the summaries of all, and
/// the feeds of the wanted ones. Runs are identified by their inputs, which never change.
class RunRecall : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Sets all kept runs and those that are drawn, as the texts of their inputs.
    void setRuns(std::set<std::string> all, std::set<std::string> wanted);
    [[nodiscard]] const RecalledRun* find(const std::string& inputs) const; ///< null: not yet
    [[nodiscard]] bool busy() const { return !m_pending.empty(); }

signals:
    void recalled(const std::string& inputs); ///< one more run was recomputed

private:
    [[nodiscard]] bool isOpen(const std::string& inputs) const;
    void take(const std::string& inputs, RecalledRun run);

    std::set<std::string> m_all, m_wanted;
    std::set<std::string> m_pending; ///< runs of the running job
    std::map<std::string, RecalledRun> m_runs;
    NewestJob m_job; ///< last: stopped before the members that it reports to are destroyed
};

/// The kept runs of a document: keeping, renaming, deleting and restoring are edits of it, so they
/// can be undone and are saved. The choice of runs shown with the current one is not. The runs are
/// recomputed in another thread and compared with the kept numbers. They are followed by those of
/// the other surfaces of the set-up, which can only be compared.
class KeptRuns : public QObject {
    Q_OBJECT

public:
    explicit KeptRuns(Document& document, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<KeptRun>& all() const { return m_document.project().runs; }
    [[nodiscard]] int count() const { return static_cast<int>(all().size()); }
    /// Returns the number of runs with those of the other surfaces, whose indices follow.
    [[nodiscard]] int listed() const { return static_cast<int>(m_entries.size()); }
    [[nodiscard]] const KeptRun& run(int index) const { return at(index).run; }
    /// Returns the name of the other surface; empty: the current one.
    [[nodiscard]] const QString& surfaceOf(int index) const { return at(index).surface; }

    enum class Kept { yes, refused, full };
    /// Keeps the run of an outcome under the first free name "Run 1", "Run 2", …, and chooses it,
    /// unless its inputs are refused or the project file would become too large to be read again. A
    /// given name gets a number, "Worst part (2)", where a kept run already has it.
    Kept keep(const Outcome& outcome, const QString& name = {});
    void rename(int index, const QString& name); ///< an empty name changes nothing
    void remove(int index);
    /// Replaces the current inputs by those of a run; the kept runs stay. Returns false when they
    /// can no longer be read.
    bool restore(int index);

    [[nodiscard]] bool isChosen(int index) const;
    void choose(int index, bool chosen);

    [[nodiscard]] const RecalledRun* recalled(int index) const; ///< null: not yet
    [[nodiscard]] bool busy() const { return m_recall.busy(); }
    /// Returns whether the recomputed run differs from the kept one.
    [[nodiscard]] bool isChanged(int index) const { return at(index).changed; }
    /// Returns the inputs and the summary of a kept run; null: they cannot be read.
    [[nodiscard]] const Project* inputs(int index) const;
    [[nodiscard]] const ReadSummary* summary(int index) const;

signals:
    void replaced();    ///< another document was opened; changed() follows
    void changed();     ///< runs, names or choices have changed
    void runRecalled(); ///< one more run was recomputed

private:
    /// A run as it was read; only its name can change.
    struct Entry {
        KeptRun run;
        QString surface = {}; ///< name of its surface; empty: the current one
        mutable std::shared_ptr<const Project> inputs{};          ///< read when first asked for …
        mutable std::optional<std::optional<ReadSummary>> read{}; ///< … and so is the summary
        bool changed = false;
        bool chosen = false;
    };
    void follow(bool another);
    [[nodiscard]] std::vector<Entry> entriesNow() const; ///< entries of the document, not read yet
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
