// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/pack_plan.h"

#include "core/catalogue/catalogue.h"
#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/lesson/lesson_file.h"
#include "core/study/new_project.h"
#include "ui/dialogs/file_questions.h"
#include "ui/report/logo.h"
#include "ui/session/background.h"
#include "ui/session/catalogue_store.h"
#include "ui/session/guarded_file.h"
#include "ui/session/kept_texts.h"
#include "ui/session/own_lessons.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/text/field_text.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QVariantMap>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

QByteArray logoOf(const Pack& pack) {
    return QByteArray::fromBase64(QByteArray::fromStdString(pack.logo));
}

} // namespace

QString PackParts::name(PackPart part) {
    switch (part) {
    case PackPart::machine: return tr("Machine");
    case PackPart::wheel: return tr("Wheel");
    case PackPart::material: return tr("Material");
    case PackPart::company: return tr("Company and signatures");
    case PackPart::lesson: return tr("Laboratory work");
    }
    return {};
}

std::vector<CatalogueEntry> PackParts::entries(const Pack& pack, PackPart part) {
    switch (part) {
    case PackPart::machine: return {pack.machines.begin(), pack.machines.end()};
    case PackPart::wheel: return {pack.wheels.begin(), pack.wheels.end()};
    case PackPart::material: return {pack.materials.begin(), pack.materials.end()};
    case PackPart::company:
    case PackPart::lesson: break;
    }
    return {};
}

void PackParts::add(const CatalogueEntry& entry, Pack& pack) {
    if (const auto* machine = std::get_if<MachineEntry>(&entry)) {
        pack.machines.push_back(*machine);
    } else if (const auto* wheel = std::get_if<WheelEntry>(&entry)) {
        pack.wheels.push_back(*wheel);
    } else {
        pack.materials.push_back(std::get<MaterialEntry>(entry));
    }
}

Company PackParts::company(const Pack& pack) {
    QVariantMap kept;
    for (const auto& [key, text] : pack.company) {
        kept.insert(QString::fromStdString(key), QString::fromStdString(text));
    }
    Company company = Company::fromKept(kept);
    if (QByteArray logo = logoOf(pack); report::Logo::fault(logo).isEmpty()) {
        company.logo = std::move(logo);
    }
    return company;
}

QString PackParts::logoFault(const Pack& pack) {
    return report::Logo::fault(logoOf(pack));
}

void PackParts::setCompany(const Company& company, Pack& pack) {
    const CompanyTexts& texts = company;
    for (const Field& field : tableOf<CompanyTexts>().fields) {
        if (const QString text = textIn(field, &texts); !text.isEmpty()) {
            pack.company[field.key] = text.toStdString();
        }
    }
    if (report::Logo::fault(company.logo).isEmpty()) {
        pack.logo = company.logo.toBase64().toStdString();
    }
}

QString PackParts::title(const Lesson& lesson) {
    return QString::fromStdString(lesson.title.in(QLocale().language() == QLocale::Russian));
}

CatalogueKind kindOf(PackPart part) {
    return part == PackPart::machine ? CatalogueKind::machines
           : part == PackPart::wheel ? CatalogueKind::wheels
                                     : CatalogueKind::materials;
}

namespace {

constexpr std::array entryParts{PackPart::machine, PackPart::wheel, PackPart::material};

const CatalogueItem* itemOf(const CatalogueStore& store, const QString& name) {
    const auto& items = store.items();
    const auto found = std::ranges::find(
        items, name, [](const CatalogueItem& item) { return entryName(item.entry); });
    return found == items.end() ? nullptr : &*found;
}

bool isSame(const CatalogueEntry& a, const CatalogueEntry& b) {
    return std::visit(
        [&b](const auto& entry) {
            using Entry = std::decay_t<decltype(entry)>;
            return writeCatalogue<Entry>({entry}) == writeCatalogue<Entry>({std::get<Entry>(b)});
        },
        a);
}

/// "Name (2)", "Name (3)"… the first that is free.
template <class Taken>
QString freeName(const QString& name, const Taken& isTaken) {
    for (int number = 2;; ++number) {
        const QString free = QStringLiteral("%1 (%2)").arg(name).arg(number);
        if (!isTaken(free)) {
            return free;
        }
    }
}

/// The text of a file of the user's; empty if it is missing or unreadable.
std::optional<std::string> textOf(const QString& path) {
    std::variant<std::string, FileError> read;
    runAside([&] { read = readFile(systemPath(path), limits::fileBytes); });
    auto* text = std::get_if<std::string>(&read);
    return text ? std::optional(std::move(*text)) : std::nullopt;
}

} // namespace

PackPlan::PackPlan(Pack pack, const Settings& settings)
    : m_pack(std::move(pack))
    , m_company(settings.company())
    , m_lessons(ownLessonsFolder(settings.folder())) {
    for (const PackPart part : entryParts) {
        m_stores[static_cast<std::size_t>(part)] =
            CatalogueStore::make(kindOf(part), settings.folder());
        addEntries(part);
    }
    addCompany();
    addLessons();
}

CatalogueStore& PackPlan::store(PackPart part) const {
    return *m_stores[static_cast<std::size_t>(part)];
}

QString PackPlan::lessonPath(const std::string& file) const {
    return m_lessons + u'/' + QString::fromStdString(file);
}

void PackPlan::addEntries(PackPart part) {
    const std::vector<CatalogueEntry> entries = PackParts::entries(m_pack, part);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QString name = entryName(entries[i]);
        const CatalogueItem* mine = itemOf(store(part), name);
        const bool same = mine && isSame(entries[i], mine->entry);
        const State state = !mine       ? State::fresh
                            : same      ? State::same
                            : mine->own ? State::different
                                        : State::shipped;
        const bool takes = state == State::fresh || state == State::shipped;
        m_lines.push_back(
            {part, i, name, entryNote(entries[i]), state, takes ? Choice::take : Choice::leave});
    }
}

/// The company as it would be saved: a refused logo replaces nothing.
Company PackPlan::packsCompany() const {
    Company packs = PackParts::company(m_pack);
    if (!logoFault().isEmpty()) {
        packs.logo = m_company.logo;
    }
    return packs;
}

void PackPlan::addCompany() {
    if (PackParts::company(m_pack) == Company()) {
        return;
    }
    const Company packs = packsCompany();
    const State state = m_company == Company() ? State::fresh
                        : m_company == packs   ? State::same
                                               : State::different;
    m_lines.push_back({PackPart::company, 0, QString::fromStdString(packs.name),
                       QString::fromStdString(packs.department), state,
                       state == State::fresh ? Choice::take : Choice::leave});
}

void PackPlan::addLessons() {
    for (std::size_t i = 0; i < m_pack.lessons.size(); ++i) {
        const PackedLesson& lesson = m_pack.lessons[i];
        const QString path = lessonPath(lesson.file);
        State state = State::fresh;
        QByteArray known;
        if (!m_lessons.isEmpty() && QFileInfo::exists(path)) {
            const auto text = textOf(path);
            known = contentHash(text.value_or(std::string()));
            state = text == writeLesson(lesson.lesson) ? State::same : State::different;
        }
        m_known.push_back(known);
        m_lines.push_back({PackPart::lesson, i, PackParts::title(lesson.lesson),
                           QString::fromStdString(lesson.file), state,
                           state == State::fresh ? Choice::take : Choice::leave});
    }
}

std::vector<PackPlan::Choice> PackPlan::choices(std::size_t line) const {
    const Line& at = m_lines[line];
    switch (at.state) {
    case State::fresh:
    case State::shipped: return {Choice::leave, Choice::take};
    case State::same: return {Choice::leave};
    case State::different: break;
    }
    if (at.part == PackPart::company) {
        return {Choice::leave, Choice::take};
    }
    return {Choice::leave, Choice::take, Choice::takeBeside};
}

int PackPlan::chosen() const {
    return static_cast<int>(std::ranges::count_if(
        m_lines, [](const Line& line) { return line.choice != Choice::leave; }));
}

std::vector<PackPlan::Difference> PackPlan::differences(std::size_t line) const {
    const Line& at = m_lines[line];
    std::vector<Difference> found;
    if (at.part == PackPart::company) {
        const Company packs = packsCompany();
        const CompanyTexts &mine = m_company, &others = packs;
        for (const Field& field : tableOf<CompanyTexts>().fields) {
            if (!field.same(&mine, &others)) {
                found.push_back(
                    {inputText(field.label), textIn(field, &mine), textIn(field, &others)});
            }
        }
        if (m_company.logo != packs.logo) {
            const auto has = [](const Company& company) {
                return company.logo.isEmpty() ? tr("none") : tr("a picture");
            };
            found.push_back({tr("Logo"), has(m_company), has(packs)});
        }
        return found;
    }
    if (at.part == PackPart::lesson) {
        const Lesson& packs = m_pack.lessons[at.index].lesson;
        const auto steps = [](const Lesson& lesson) {
            return QString::number(lesson.steps.size());
        };
        const auto text = textOf(lessonPath(m_pack.lessons[at.index].file));
        const auto mine = text ? readLessonOfAnybody(*text).lesson : std::nullopt;
        found.push_back(
            {tr("Title"), mine ? PackParts::title(*mine) : QString(), PackParts::title(packs)});
        found.push_back({tr("Steps"), mine ? steps(*mine) : QString(), steps(packs)});
        return found;
    }
    const CatalogueEntry entry = PackParts::entries(m_pack, at.part)[at.index];
    const CatalogueItem* mine = itemOf(store(at.part), at.name);
    const Project none = newProject();
    for (const CatalogueChange& change :
         changesBy(entry, mine ? withEntry(mine->entry, none) : none)) {
        if (!mine || change.changed) {
            const QString unit = unitText(change.field->unit);
            const QString label = inputText(change.field->label);
            found.push_back({unit.isEmpty() ? label : label + QStringLiteral(", ") + unit,
                             mine ? change.now : QString(), change.then});
        }
    }
    return found;
}

QString PackPlan::keepEntries(PackPart part) {
    const std::vector<CatalogueEntry> entries = PackParts::entries(m_pack, part);
    std::vector<CatalogueEntry> kept;
    const auto isTaken = [&](const QString& name) {
        return itemOf(store(part), name)
               || std::ranges::any_of(
                   kept, [&](const CatalogueEntry& entry) { return entryName(entry) == name; })
               || std::ranges::any_of(
                   entries, [&](const CatalogueEntry& entry) { return entryName(entry) == name; });
    };
    for (const Line& line : m_lines) {
        if (line.part != part || line.choice == Choice::leave) {
            continue;
        }
        CatalogueEntry entry = entries[line.index];
        if (line.choice == Choice::takeBeside) {
            const std::string name = freeName(line.name, isTaken).toStdString();
            std::visit([&name](auto& each) { each.name = name; }, entry);
        }
        kept.push_back(std::move(entry));
    }
    return kept.empty() ? QString() : store(part).keep(kept);
}

QString PackPlan::keepLesson(const Line& line) const {
    const PackedLesson& lesson = m_pack.lessons[line.index];
    QString path = lessonPath(lesson.file);
    QByteArray known = m_known[line.index];
    if (line.choice == Choice::takeBeside) {
        const QString ending = QStringLiteral(".sparkout-lesson");
        path.chop(ending.size());
        path = freeName(path, [&](const QString& name) { return QFileInfo::exists(name + ending); })
               + ending;
        known.clear();
    }
    QDir().mkpath(m_lessons); // a failure shows when writing
    GuardedFile file;
    file.protect({}); // the replaced version is kept beside it
    if (file.claim(path) == GuardedFile::Access::conflict) {
        return inUseText(path, file.holder());
    }
    file.follow(path, known);
    const auto error = file.write(path, [&lesson]() -> std::optional<std::string> {
        std::string text = writeLesson(lesson.lesson);
        return readLessonOfAnybody(text).lesson ? std::optional(std::move(text)) : std::nullopt;
    });
    return error ? saveErrorText(*error) : QString();
}

/// Decodes the pack's picture for the first time, since it was chosen.
QString PackPlan::keepCompany(Settings& settings) const {
    Company packs = packsCompany();
    const bool damaged = packs.logo != m_company.logo && !packs.logo.isEmpty()
                         && report::Logo::image(packs.logo).isNull();
    if (damaged) {
        packs.logo = m_company.logo;
    }
    settings.setCompany(packs);
    return damaged ? report::Logo::damagedText() : QString();
}

QStringList PackPlan::carryOut(Settings& settings) {
    QStringList faults;
    const auto note = [&faults](const QString& fault) {
        if (!fault.isEmpty()) {
            faults += fault;
        }
    };
    for (const PackPart part : entryParts) {
        note(keepEntries(part));
    }
    for (const Line& line : m_lines) {
        if (line.choice == Choice::leave) {
            continue;
        }
        if (line.part == PackPart::company) {
            note(keepCompany(settings));
        } else if (line.part == PackPart::lesson) {
            note(m_lessons.isEmpty() ? tr("There is no folder for lessons of your own.")
                                     : keepLesson(line));
        }
    }
    return faults;
}

} // namespace sparkout
