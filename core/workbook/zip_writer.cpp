// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workbook/zip_writer.h"

#include <limits>
#include <utility>

#include <zlib.h>

namespace sparkout {

namespace {

constexpr int level = 4; // half as large as with the quickest, twice as quick as with the usual
constexpr int rawDeflate = -15;
constexpr int memory = 8;
constexpr std::size_t roomBytes = std::size_t{64} * 1024;
constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();

constexpr std::uint32_t localSignature = 0x04034b50;
constexpr std::uint32_t centralSignature = 0x02014b50;
constexpr std::uint32_t endSignature = 0x06054b50;
constexpr std::uint64_t version = 20; // compressed files
constexpr std::uint64_t stored = 0, deflated = 8;
constexpr std::uint64_t firstOfJanuary1980 = 0x0021; // no time: equal content, equal bytes
constexpr std::size_t localHeaderBytes = 30;

/// `bytes` of a number, the lowest first.
void put(std::string& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) {
        to += static_cast<char>(value >> (8 * i) & 0xff);
    }
}

} // namespace

ZipWriter::ZipWriter() : m_room(roomBytes) {}

ZipWriter::~ZipWriter() {
    if (m_stream) {
        deflateEnd(m_stream);
        delete m_stream;
    }
}

void ZipWriter::begin(std::string_view name) {
    Entry entry;
    entry.name = name;
    entry.offset = m_bytes.size();
    m_entries.push_back(entry);
    m_bytes.append(localHeaderBytes + name.size(), '\0'); // its numbers are known at the end
    m_stream = new z_stream();
    m_failed = m_failed
               || deflateInit2(m_stream, level, Z_DEFLATED, rawDeflate, memory, Z_DEFAULT_STRATEGY)
                      != Z_OK;
}

void ZipWriter::deflate(std::string_view bytes, int flush) {
    m_stream->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    m_stream->avail_in = static_cast<uInt>(bytes.size());
    do {
        m_stream->next_out = m_room.data();
        m_stream->avail_out = static_cast<uInt>(m_room.size());
        if (::deflate(m_stream, flush) == Z_STREAM_ERROR) {
            m_failed = true;
            return;
        }
        m_bytes.append(reinterpret_cast<const char*>(m_room.data()),
                       m_room.size() - m_stream->avail_out);
    } while (m_stream->avail_out == 0);
}

void ZipWriter::add(std::string_view bytes) {
    if (m_failed || bytes.empty()) {
        return;
    }
    Entry& entry = m_entries.back();
    entry.crc = static_cast<std::uint32_t>(crc32(
        entry.crc, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
    entry.size += bytes.size();
    deflate(bytes, Z_NO_FLUSH);
}

void ZipWriter::end() {
    if (!m_failed) {
        deflate({}, Z_FINISH);
    }
    deflateEnd(m_stream);
    delete std::exchange(m_stream, nullptr);
    Entry& entry = m_entries.back();
    const auto start = static_cast<std::size_t>(entry.offset);
    entry.packed = m_bytes.size() - start - localHeaderBytes - entry.name.size();
    m_failed = m_failed || entry.size > most || m_bytes.size() > most;
    const std::string header = headerOf(entry, false);
    m_bytes.replace(start, header.size(), header); // as long as the reserved space
}

void ZipWriter::addStored(std::string_view name, std::string_view bytes) {
    Entry entry;
    entry.name = name;
    entry.offset = m_bytes.size();
    entry.size = entry.packed = bytes.size();
    entry.crc = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
    entry.isStored = true;
    m_bytes += headerOf(entry, false);
    m_bytes += bytes;
    m_entries.push_back(entry);
}

std::string ZipWriter::headerOf(const Entry& entry, bool central) {
    std::string header;
    put(header, central ? centralSignature : localSignature, 4);
    if (central) {
        put(header, version, 2);
    }
    put(header, version, 2);
    put(header, 0, 2); // flags
    put(header, entry.isStored ? stored : deflated, 2);
    put(header, 0, 2); // time
    put(header, firstOfJanuary1980, 2);
    put(header, entry.crc, 4);
    put(header, entry.packed, 4);
    put(header, entry.size, 4);
    put(header, entry.name.size(), 2);
    put(header, 0, 2); // extra field
    if (central) {
        put(header, 0, 6); // comment, disk, attributes within the archive
        put(header, 0, 4); // and of the file
        put(header, entry.offset, 4);
    }
    return header + entry.name;
}

const char* ZipWriter::libraryVersion() {
    return zlibVersion();
}

std::string ZipWriter::finish() {
    const std::size_t start = m_bytes.size();
    for (const Entry& entry : m_entries) {
        m_bytes += headerOf(entry, true);
    }
    const std::size_t end = m_bytes.size();
    put(m_bytes, endSignature, 4);
    put(m_bytes, 0, 4); // disks
    put(m_bytes, m_entries.size(), 2);
    put(m_bytes, m_entries.size(), 2);
    put(m_bytes, end - start, 4);
    put(m_bytes, start, 4);
    put(m_bytes, 0, 2); // comment
    m_failed = m_failed || m_bytes.size() > most;
    return m_failed ? std::string() : std::move(m_bytes);
}

} // namespace sparkout
