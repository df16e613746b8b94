#include "scene/loading/rooted_folder.h"

#include <array>
#include <span>

#include "graph/syntax/contained_file.h"

namespace weft::scene {
namespace {

namespace fs = std::filesystem;

FileBytes fault(ReadFault kind, std::string message) {
    return {{}, kind, std::move(message)};
}

FileBytes read_file(const fs::path& file, uint64_t max_bytes, LastLink link) {
    const std::string name = "\"" + file.filename().string() + "\"";
    FileBytes result;
    const PlainRead read = weft::read_plain_file(file, max_bytes, link, [&](uint64_t size) {
        result.bytes.resize(size);
        return std::as_writable_bytes(std::span(result.bytes));
    });
    switch (read.fault) {
        case FileFault::none:
            // The file may have become shorter after its size was read. Then the bytes at the end of the
            // result would be zeros that are not in the file, so the file counts as unreadable.
            if (read.size_bytes == result.bytes.size()) return result;
            [[fallthrough]];
        case FileFault::unreadable:
            return fault(ReadFault::unreadable, name + " cannot be read");
        case FileFault::missing:
            return fault(ReadFault::missing, name + " is not a plain file");
        case FileFault::not_plain:
            return fault(ReadFault::unreadable, name + " is not a plain file");
        case FileFault::too_large:
            break;
    }
    return fault(ReadFault::too_large, name + " has " + std::to_string(read.size_bytes) +
                                           " bytes, but the limit leaves only " + std::to_string(max_bytes) +
                                           " bytes");
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

bool has_scheme(std::string_view uri) {
    const size_t colon = uri.find(':');
    return colon != std::string_view::npos && uri.substr(0, colon).find('/') == std::string_view::npos;
}

constexpr std::array<int8_t, 256> base64_table() {
    std::array<int8_t, 256> table{};
    table.fill(-1);
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < digits.size(); ++i)
        table[static_cast<uint8_t>(digits[i])] = static_cast<int8_t>(i);
    return table;
}

}  // namespace

RootedFolder::RootedFolder(const fs::path& folder) : root_(real_folder(folder)) {}

FileBytes RootedFolder::read(std::string_view uri, uint64_t max_bytes) const {
    const std::string shown(uri.substr(0, 80));
    const std::optional<std::string> decoded = percent_decode(uri);
    if (!decoded || decoded->empty())
        return fault(ReadFault::missing, "\"" + shown + "\" is not a valid URI");
    const fs::path relative(*decoded);
    if (has_scheme(uri) || has_scheme(*decoded) || decoded->find('\\') != std::string::npos ||
        climbs_out(relative)) {
        return fault(ReadFault::escapes, "\"" + shown + "\" leads out of the scene's folder");
    }
    if (root_.empty()) return fault(ReadFault::missing, "the scene's folder does not exist");
    const RealFile real = find_real_file(root_ / relative, std::span(&root_, 1));
    if (real.path.empty()) return fault(ReadFault::missing, "\"" + shown + "\" does not exist");
    if (!real.is_inside) {
        return fault(ReadFault::escapes, "\"" + shown + "\" is a link that leads out of the scene's folder");
    }
    return read_file(real.path, max_bytes, LastLink::refused);
}

FileBytes read_plain_file(const fs::path& file, uint64_t max_bytes) {
    return read_file(file, max_bytes, LastLink::followed);
}

std::optional<std::string> percent_decode(std::string_view uri) {
    std::string out;
    out.reserve(uri.size());
    for (size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            out.push_back(uri[i]);
        } else {
            if (i + 2 >= uri.size()) return std::nullopt;
            const int high = hex_digit(uri[i + 1]);
            const int low = hex_digit(uri[i + 2]);
            if (high < 0 || low < 0) return std::nullopt;
            out.push_back(static_cast<char>(high * 16 + low));
            i += 2;
        }
        if (out.back() == '\0') return std::nullopt;
    }
    return out;
}

bool is_data_uri(std::string_view uri) {
    return uri.starts_with("data:");
}

std::optional<std::vector<uint8_t>> decode_data_uri(std::string_view uri) {
    static constexpr std::array<int8_t, 256> kTable = base64_table();
    const size_t comma = uri.find(',');
    if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
    if (!uri.substr(0, comma).ends_with(";base64")) return std::nullopt;
    std::string_view text = uri.substr(comma + 1);
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::vector<uint8_t> out;
    out.reserve(text.size() / 4 * 3 + 3);
    uint32_t bits = 0;
    int bit_count = 0;
    for (const char c : text) {
        const int digit = kTable[static_cast<uint8_t>(c)];
        if (digit < 0) return std::nullopt;
        bits = (bits << 6 | static_cast<uint32_t>(digit)) & 0xffffff;
        bit_count += 6;
        if (bit_count >= 8) {
            bit_count -= 8;
            out.push_back(static_cast<uint8_t>(bits >> bit_count));
        }
    }
    return out;
}

}  // namespace weft::scene
