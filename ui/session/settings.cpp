// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/settings.h"

#include "core/project/part.h"
#include "core/sha256.h"
#include "core/text.h"
#include "ui/session/guarded_file.h"
#include "ui/session/kept_texts.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QStandardPaths>

#include <array>
#include <cerrno>
#include <utility>

namespace sparkout {

namespace {

const QString logoKey = QStringLiteral("logo");

} // namespace

template <>
const StructInfo& tableOf<CompanyTexts>() {
    using T = CompanyTexts;
    constexpr Range letters{0, 200};
    static const std::array rows{
        SPARKOUT_FIELD(T, name, .label = SPARKOUT_NOOP("Input", "Company"), .hard = letters),
        SPARKOUT_FIELD(T, department, .label = SPARKOUT_NOOP("Input", "Department"),
                       .hard = letters),
        SPARKOUT_FIELD(T, developed, .label = SPARKOUT_NOOP("Input", "Prepared by"),
                       .hard = letters),
        SPARKOUT_FIELD(T, checked, .label = SPARKOUT_NOOP("Input", "Checked by"), .hard = letters),
        SPARKOUT_FIELD(T, agreed, .label = SPARKOUT_NOOP("Input", "Agreed by"), .hard = letters),
        SPARKOUT_FIELD(T, standards, .label = SPARKOUT_NOOP("Input", "Standards checked by"),
                       .hard = letters),
        SPARKOUT_FIELD(T, approved, .label = SPARKOUT_NOOP("Input", "Approved by"),
                       .hard = letters),
        SPARKOUT_FIELD(T, designation, .label = SPARKOUT_NOOP("Input", "Document number"),
                       .hard = letters),
        SPARKOUT_FIELD(T, part, .label = SPARKOUT_NOOP("Input", "Part designation"),
                       .hard = letters),
        SPARKOUT_FIELD(T, shop, .label = SPARKOUT_NOOP("Input", "Shop"), .hard = letters),
        SPARKOUT_FIELD(T, area, .label = SPARKOUT_NOOP("Input", "Shop area"), .hard = letters),
        SPARKOUT_FIELD(T, place, .label = SPARKOUT_NOOP("Input", "Work place"), .hard = letters),
        SPARKOUT_FIELD(T, operation, .label = SPARKOUT_NOOP("Input", "Operation number"),
                       .hard = letters),
    };
    static const StructInfo info =
        makeTable<CompanyTexts>(SPARKOUT_NOOP("Struct", "Company and signatures"), rows);
    return info;
}

Company Company::with(const CardEntries& entries) const {
    Company made = *this;
    const auto take = [](std::string& number, const std::string& given) {
        if (const QString text = QString::fromStdString(given).simplified(); !text.isEmpty()) {
            number = text.toStdString();
        }
    };
    take(made.part, entries.part_number);
    take(made.designation, entries.document_number);
    take(made.operation, entries.operation_number);
    return made;
}

QVariantMap Company::kept() const {
    QVariantMap kept = keptTexts(tableOf<CompanyTexts>(), static_cast<const CompanyTexts*>(this));
    if (!logo.isEmpty()) {
        kept.insert(logoKey, QString::fromLatin1(logo.toBase64()));
    }
    return kept;
}

Company Company::fromKept(const QVariantMap& kept) {
    Company made;
    readKeptTexts(kept, tableOf<CompanyTexts>(), static_cast<CompanyTexts*>(&made));
    made.logo = QByteArray::fromBase64(kept.value(logoKey).toString().toLatin1());
    return made;
}

namespace {

constexpr int later_ms = 500; ///< several settings are often set together
const QString reportedKey = QStringLiteral("damagedReported");

QByteArray textOf(const QVariantMap& values) {
    return QJsonDocument(QJsonObject::fromVariantMap(values)).toJson();
}

} // namespace

SettingsFile::SettingsFile(const QString& path) : m_path(path) {
    m_later.setSingleShot(true);
    m_later.setInterval(later_ms);
    connect(&m_later, &QTimer::timeout, this, [this] { (void)flush(); });
    refresh();
}

SettingsFile::~SettingsFile() {
    (void)flush();
}

std::optional<SettingsFile::Content> SettingsFile::read() {
    m_unreadable.reset();
    const auto bytes = readFile(systemPath(m_path), limits::settingsBytes);
    const auto* text = std::get_if<std::string>(&bytes);
    const auto* error = std::get_if<FileError>(&bytes);
    if (error != nullptr && error->step != FileStep::tooLarge) {
        if (error->systemError == ENOENT || error->systemError == ENOTDIR) {
            return Content{}; // defaults apply
        }
        m_unreadable = *error;
        return std::nullopt;
    }
    if (text != nullptr) {
        QJsonParseError fault;
        const QJsonDocument document =
            QJsonDocument::fromJson(QByteArray::fromStdString(*text), &fault);
        if (fault.error == QJsonParseError::NoError && document.isObject()) {
            return Content{document.object().toVariantMap(), sha256(*text)};
        }
    }
    // Another instance may have written a valid one since.
    const auto again = readFile(systemPath(m_path), limits::settingsBytes);
    if (const auto* now = std::get_if<std::string>(&again);
        now != nullptr && (text == nullptr || *now != *text)) {
        return read();
    }
    const auto aside = putAside(systemPath(m_path));
    if (const auto* failed = std::get_if<FileError>(&aside)) {
        m_unreadable = *failed;
        return std::nullopt;
    }
    emit foundDamaged();
    return Content{m_values, {}}; // keeps the values read before
}

QStringList SettingsFile::damaged() const {
    if (m_path.isEmpty()) {
        return {};
    }
    const QFileInfo file(m_path);
    const QStringList reported = m_values.value(reportedKey).toStringList();
    QStringList found;
    for (const QFileInfo& aside : file.dir().entryInfoList(
             {file.fileName() + QStringLiteral(".damaged*")}, QDir::Files, QDir::Name)) {
        if (!reported.contains(aside.fileName())) {
            found += aside.filePath();
        }
    }
    return found;
}

QStringList SettingsFile::takeDamaged() {
    const QStringList found = damaged();
    QStringList reported = m_values.value(reportedKey).toStringList();
    const QDir folder = QFileInfo(m_path).dir();
    reported.removeIf([&folder](const QString& name) { return !folder.exists(name); });
    for (const QString& path : found) {
        reported += QFileInfo(path).fileName();
    }
    if (reported != m_values.value(reportedKey).toStringList()) {
        set(reportedKey, reported);
    }
    return found;
}

bool SettingsFile::mayBeRead(const QByteArray& text) {
    const bool may = std::size_t(text.size()) <= limits::settingsBytes;
    if (!may) {
        emit refused({systemText(m_path), FileStep::content, 0, {}});
    }
    return may;
}

void SettingsFile::set(const QString& key, const QVariant& value) {
    if (m_values.value(key) == value) {
        return;
    }
    QVariantMap values = m_values;
    values.insert(key, value);
    if (!m_path.isEmpty() && !mayBeRead(textOf(values))) {
        return;
    }
    m_values = std::move(values);
    m_changed.insert(key, value);
    if (!m_path.isEmpty() && QCoreApplication::instance() != nullptr) {
        m_later.start();
    }
}

void SettingsFile::refresh() {
    if (m_path.isEmpty()) {
        return;
    }
    if (std::optional<Content> content = read()) { // otherwise the values read before are kept
        m_values = std::move(content->values);
        m_values.insert(m_changed);
    }
}

std::optional<FileError> SettingsFile::flush() {
    m_later.stop();
    if (m_path.isEmpty() || m_changed.isEmpty()) {
        return {};
    }
    using Amendment = GuardedFile::Amendment;
    const auto merged = [this]() -> std::optional<Amendment> {
        std::optional<Content> content = read();
        if (!content) {
            return std::nullopt;
        }
        content->values.insert(m_changed);
        const QByteArray text = textOf(content->values);
        return Amendment{content->sha256,
                         mayBeRead(text) ? std::optional(text.toStdString()) : std::nullopt};
    };
    std::optional<FileError> error = GuardedFile::amend(m_path, GuardedFile::Waiting::here, merged);
    if (!error && !m_unreadable) {
        m_changed.clear();
    }
    return error ? error : m_unreadable;
}

namespace {

const QString languageKey = QStringLiteral("language");
const QString themeKey = QStringLiteral("theme");
const QString fontKey = QStringLiteral("fontSize");
const QString stockKey = QStringLiteral("stockOnDiameter");
const QString allInputsKey = QStringLiteral("allInputs");
const QString tourKey = QStringLiteral("tourSeen");
const QString handoutKey = QStringLiteral("handout");
const QString titlePageKey = QStringLiteral("titlePage");
const QString companyKey = QStringLiteral("company");
const QString studentKey = QStringLiteral("student");
const QString folderKey = QStringLiteral("lastFolder");
const QString recentKey = QStringLiteral("recentFiles");
const QString geometryKey = QStringLiteral("window/geometry");
const QString dialogKey = QStringLiteral("dialog/");
const QString columnsKey = QStringLiteral("columns/");
const QString windowStateKey = QStringLiteral("window/state");

const QString english = QStringLiteral("en");
const QString russian = QStringLiteral("ru");

QString usersFile() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation);
    return folder.isEmpty() ? QString() : folder + QStringLiteral("/sparkout/settings.json");
}

QVariant asText(const QByteArray& bytes) {
    return QString::fromLatin1(bytes.toBase64());
}

QByteArray asBytes(const QVariant& text) {
    return QByteArray::fromBase64(text.toString().toLatin1());
}

} // namespace

Settings::Settings() : Settings(usersFile()) {}

Settings::Settings(const QString& file)
    : m_file(std::make_unique<SettingsFile>(file))
    , m_folder(file.isEmpty() ? QString() : QFileInfo(file).absolutePath()) {}

Settings Settings::transient() {
    Settings settings{QString()};
    settings.setAllInputs(true); // hidden inputs could not be tried
    return settings;
}

QString Settings::oneOf(const QString& key, const QStringList& allowed) const {
    const QString chosen = m_file->value(key).toString();
    return allowed.contains(chosen) ? chosen : QString();
}

QString Settings::language() const {
    const QString chosen = oneOf(languageKey, {english, russian});
    if (!chosen.isEmpty()) {
        return chosen;
    }
    return QLocale::system().language() == QLocale::Russian ? russian : english;
}

void Settings::setLanguage(const QString& code) {
    m_file->set(languageKey, code);
}

QString Settings::theme() const {
    const QString chosen = oneOf(
        themeKey, {QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("contrast")});
    return chosen.isEmpty() ? QStringLiteral("system") : chosen;
}

void Settings::setTheme(const QString& theme) {
    m_file->set(themeKey, theme);
}

int Settings::fontSize() const {
    constexpr int usual = 100, least = 50, most = 400;
    const int percent = m_file->value(fontKey).toInt();
    return percent >= least && percent <= most ? percent : usual;
}

void Settings::setFontSize(int percent) {
    m_file->set(fontKey, percent);
}

bool Settings::stockOnDiameter() const {
    return m_file->value(stockKey).toBool();
}

void Settings::setStockOnDiameter(bool onDiameter) {
    m_file->set(stockKey, onDiameter);
}

bool Settings::allInputs() const {
    return m_file->value(allInputsKey).toBool();
}

void Settings::setAllInputs(bool all) {
    m_file->set(allInputsKey, all);
}

bool Settings::tourSeen() const {
    return m_file->value(tourKey).toBool();
}

void Settings::setTourSeen() {
    m_file->set(tourKey, true);
}

QString Settings::handout() const {
    return m_file->value(handoutKey).toString();
}

void Settings::setHandout(const QString& words) {
    m_file->set(handoutKey, words);
}

Company Settings::company() const {
    return Company::fromKept(m_file->value(companyKey).toMap());
}

void Settings::setCompany(const Company& company) {
    m_file->set(companyKey, company.kept());
}

QVariantMap Settings::titlePage() const {
    return m_file->value(titlePageKey).toMap();
}

void Settings::setTitlePage(const QVariantMap& texts) {
    m_file->set(titlePageKey, texts);
}

QStringList Settings::student() const {
    return m_file->value(studentKey).toStringList();
}

void Settings::setStudent(const QString& name, const QString& group) {
    m_file->set(studentKey, QStringList{name, group});
}

QString Settings::lastFolder() const {
    const QString folder = m_file->value(folderKey).toString();
    return folder.isEmpty() ? QDir::homePath() : folder;
}

void Settings::setLastFolder(const QString& folder) {
    m_file->set(folderKey, folder);
}

QStringList Settings::recentFiles() const {
    QStringList paths = m_file->value(recentKey).toStringList();
    paths.removeAll(QString());
    return paths.mid(0, recentFilesKept);
}

void Settings::addRecentFile(const QString& path) {
    const QString whole = QFileInfo(path).absoluteFilePath();
    m_file->refresh();
    QStringList paths = recentFiles();
    paths.removeAll(whole);
    paths.prepend(whole);
    setRecentFiles(paths);
}

void Settings::setRecentFiles(const QStringList& paths) {
    m_file->set(recentKey, paths.mid(0, recentFilesKept));
}

QByteArray Settings::windowGeometry() const {
    return asBytes(m_file->value(geometryKey));
}

QByteArray Settings::windowState() const {
    return asBytes(m_file->value(windowStateKey));
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
    m_file->set(geometryKey, asText(geometry));
    m_file->set(windowStateKey, asText(state));
}

QByteArray Settings::dialogGeometry(const QString& name) const {
    return asBytes(m_file->value(dialogKey + name));
}

void Settings::setDialogGeometry(const QString& name, const QByteArray& geometry) {
    m_file->set(dialogKey + name, asText(geometry));
}

QStringList Settings::hiddenColumns(const QString& table) const {
    return m_file->value(columnsKey + table).toStringList();
}

void Settings::setHiddenColumns(const QString& table, const QStringList& keys) {
    m_file->set(columnsKey + table, keys);
}

} // namespace sparkout
