// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>

namespace sparkout {

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
