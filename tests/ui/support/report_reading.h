// SPDX-License-Identifier: GPL-3.0-or-later
// Reports read back, by poppler's tools and as XML.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QXmlStreamReader>

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
