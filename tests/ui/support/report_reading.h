// SPDX-License-Identifier: GPL-3.0-or-later
// Reports read back, by poppler's tools and as XML.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <initializer_list>

namespace sparkout::reading {

/// What a tool of poppler says of a PDF.
inline QString told(const QString& tool, const QStringList& options, const QByteArray& pdf) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("report.pdf"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(pdf) != pdf.size()) {
        return {};
    }
    file.close();
    QProcess process;
    QStringList arguments = options + QStringList{path};
    if (tool == u"pdftotext") {
        arguments << QStringLiteral("-");
    }
    process.start(tool, arguments);
    if (!process.waitForFinished(60'000) || process.exitCode() != 0) {
        return {};
    }
    return QString::fromUtf8(process.readAllStandardOutput());
}

inline QString textOf(const QByteArray& pdf) {
    return told(QStringLiteral("pdftotext"), {QStringLiteral("-layout")}, pdf)
        .replace(QChar(0x00a0), u' ');
}

/// The fonts of a PDF that are not embedded; a word where it has none at all.
inline QStringList fontsLeftOut(const QByteArray& pdf) {
    QStringList fonts =
        told(QStringLiteral("pdffonts"), {}, pdf).split(u'\n', Qt::SkipEmptyParts).mid(2);
    if (fonts.isEmpty()) {
        return {QStringLiteral("none")};
    }
    static const QRegularExpression embedded(QStringLiteral("\\byes +(yes|no) +(yes|no) +\\d"));
    fonts.removeIf([](const QString& font) { return font.contains(embedded); });
    return fonts;
}

/// Words of three Latin letters and more, but for names, symbols and functions.
inline QStringList englishWords(const QString& text, std::initializer_list<const char*> more = {}) {
    static const QRegularExpression english(QStringLiteral("\\b[A-Za-z]{3,}\\b"));
    QStringList words;
    for (auto it = english.globalMatch(text); it.hasNext();) {
        words << it.next().captured();
    }
    for (const char* kept : {"Sparkout", "part", "sparkout", "HRC", "Srad"}) {
        words.removeAll(QString::fromLatin1(kept));
    }
    for (const char* kept : more) {
        words.removeAll(QString::fromLatin1(kept));
    }
    return words;
}

/// The first row of a table in Markdown that has an empty cell or not as many as that before.
inline QString raggedRow(const QString& markdown) {
    static const QRegularExpression bar(QStringLiteral("(?<!\\\\)\\|"));
    qsizetype columns = 0;
    for (const QString& line : markdown.split(u'\n')) {
        const qsizetype now = line.startsWith(u'|') ? line.count(bar) : 0;
        if ((columns > 0 && now > 0 && now != columns) || line.contains(QStringLiteral("|  |"))) {
            return line;
        }
        columns = now;
    }
    return {};
}

/// A file of an archive that is whole, as another program reads it; else empty.
inline QByteArray unzipped(const QByteArray& archive, const char* name) {
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("paper.odt")));
    if (!file.open(QIODevice::WriteOnly) || file.write(archive) != archive.size()) {
        return {};
    }
    file.close();
    QProcess process;
    process.start(QStringLiteral("/usr/bin/python3"),
                  {QStringLiteral("-c"),
                   QStringLiteral("import sys, zipfile\n"
                                  "z = zipfile.ZipFile(sys.argv[1])\n"
                                  "assert z.testzip() is None\n"
                                  "sys.stdout.buffer.write(z.read(sys.argv[2]))"),
                   file.fileName(), QString::fromLatin1(name)});
    process.waitForFinished(60'000);
    return process.readAllStandardOutput();
}

/// The plain text of a well-formed page; a fault is empty.
inline QString textOfHtml(const QByteArray& html) {
    QXmlStreamReader reader(html);
    QString text;
    while (!reader.atEnd()) {
        reader.readNext();
        if (reader.isStartElement() && reader.name() == u"style") {
            reader.skipCurrentElement();
        } else if (reader.isCharacters()) {
            text += reader.text().toString() + u' ';
        }
    }
    return reader.hasError() ? QString() : text.replace(QChar(0x00a0), u' ');
}

/// An entry of a PDF's outline.
struct OutlineEntry {
    QString text;
    int page = 0; ///< from 1
};

/// The outline as poppler reads it, in its order; deeper levels as they come.
inline QList<OutlineEntry> outlineOf(const QByteArray& pdf) {
    QXmlStreamReader reader(
        told(QStringLiteral("pdftohtml"),
             {QStringLiteral("-xml"), QStringLiteral("-i"), QStringLiteral("-stdout")}, pdf));
    QList<OutlineEntry> entries;
    while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == u"item") {
            const int page = reader.attributes().value(QStringLiteral("page")).toInt();
            entries.append({reader.readElementText(), page});
        }
    }
    return entries;
}

/// Rows of the tables of a web page, cell by cell, heads too.
inline QList<QStringList> rowsOfHtml(const QByteArray& html) {
    QXmlStreamReader reader(html);
    QList<QStringList> rows;
    while (!reader.atEnd()) {
        reader.readNext();
        if (!reader.isStartElement()) {
            continue;
        }
        if (reader.name() == u"tr") {
            rows.append(QStringList());
        } else if (reader.name() == u"td" || reader.name() == u"th") {
            rows.last() += reader.readElementText(QXmlStreamReader::IncludeChildElements);
        }
    }
    return rows;
}

} // namespace sparkout::reading
