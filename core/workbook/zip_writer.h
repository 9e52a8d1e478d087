// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

struct z_stream_s;

namespace sparkout {

/// A ZIP archive made in memory, file after file; equal content gives equal bytes. Limited to 4 GB.
class ZipWriter {
public:
    ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;
    ~ZipWriter();

    void begin(std::string_view name); ///< a name in ASCII
    void add(std::string_view bytes);  ///< to the file begun last
    void end();
    /// A small file that is not compressed.
    void addStored(std::string_view name, std::string_view bytes);

    /// Version of the compression library: "1.2.13".
    [[nodiscard]] static const char* libraryVersion();

    /// The archive, moved out; empty if it is too large, or if memory is insufficient.
    [[nodiscard]] std::string finish();

private:
    struct Entry {
        std::string name;
        std::uint32_t crc = 0;
        std::uint64_t size = 0;
        std::uint64_t packed = 0;
        std::uint64_t offset = 0;
        bool isStored = false; ///< uncompressed
    };
    void deflate(std::string_view bytes, int flush);
    [[nodiscard]] static std::string headerOf(const Entry& entry, bool central);

    std::string m_bytes;
    std::vector<Entry> m_entries;
    std::vector<unsigned char> m_room; ///< filled by the compressor
    z_stream_s* m_stream = nullptr;    ///< while a file is open
    bool m_failed = false;
};

} // namespace sparkout
