#include "scene/gltf/gltf_resources.h"

#include <algorithm>

namespace weft::scene::gltf {
namespace {

class Loader {
 public:
    Loader(const RootedFolder& folder, uint64_t max_bytes, MemoryBudget& memory, Report& report)
        : folder_(folder), bytes_left_(max_bytes), memory_(memory), report_(report) {}

    // Returns the bytes of `uri`, or nullopt after an error was reported for the JSON value at `pointer`.
    std::optional<std::vector<uint8_t>> load(const std::string& uri, const std::string& pointer) {
        std::optional<std::vector<uint8_t>> bytes =
            is_data_uri(uri) ? decode(uri, pointer) : read(uri, pointer);
        if (!bytes) return std::nullopt;
        if (bytes->size() > bytes_left_) {
            report_fault(ReadFault::too_large, "the data: URI needs more memory than the limit leaves",
                         pointer);
            return std::nullopt;
        }
        if (!take_memory(memory_, {bytes->size(), "S107", pointer, "this data"}, report_))
            return std::nullopt;
        bytes_left_ -= bytes->size();
        return bytes;
    }

    // Reserves `bytes` bytes for a copy of the binary chunk. Subtracts them from both limits: the total bytes
    // of all files, and the memory budget. Returns false after an error was reported.
    bool reserve(uint64_t bytes, const std::string& pointer) {
        if (bytes > bytes_left_) {
            report_fault(ReadFault::too_large, "the buffers together are larger than the limit", pointer);
            return false;
        }
        if (!take_memory(memory_, {bytes, "S107", pointer, "the buffer"}, report_)) return false;
        bytes_left_ -= bytes;
        return true;
    }

 private:
    std::optional<std::vector<uint8_t>> decode(const std::string& uri, const std::string& pointer) {
        std::optional<std::vector<uint8_t>> bytes = decode_data_uri(uri);
        if (!bytes) {
            report_.error("S102", pointer, "the data: URI is not valid base64",
                          "export the file again, because it is damaged");
        }
        return bytes;
    }

    std::optional<std::vector<uint8_t>> read(const std::string& uri, const std::string& pointer) {
        // Two limits apply: the total bytes of all files, and the memory budget. The file's size is compared
        // with both before the file is read.
        FileBytes file = folder_.read(uri, std::min(bytes_left_, memory_.left_bytes()));
        if (!file.fault) return std::move(file.bytes);
        report_fault(*file.fault, file.message, pointer);
        return std::nullopt;
    }

    void report_fault(ReadFault fault, const std::string& message, const std::string& pointer) {
        switch (fault) {
            case ReadFault::escapes:
                report_.error("S103", pointer, message,
                              "copy the file into the scene's folder, and use a relative URI");
                break;
            case ReadFault::too_large:
                report_.error("S107", pointer, message,
                              "use fewer or smaller buffers and images, or raise scene.resourceBytes or "
                              "scene.memoryBytes with --limits");
                break;
            case ReadFault::missing:
            case ReadFault::unreadable:
                report_.error("S101", pointer, message,
                              "put the file beside the scene, under the name in the URI");
                break;
        }
    }

    const RootedFolder& folder_;
    uint64_t bytes_left_;
    MemoryBudget& memory_;
    Report& report_;
};

void report_short_buffer(Report& report, const std::string& pointer, uint64_t wanted, uint64_t found) {
    report.error("S104", pointer + "/byteLength",
                 "\"byteLength\" is " + std::to_string(wanted) + ", but the data of the buffer has " +
                     std::to_string(found) + " bytes",
                 "copy or export the scene again, because the buffer is truncated");
}

void load_buffer(Loader& loader, const BufferSource& source, std::optional<std::span<const uint8_t>> binary,
                 size_t index, Report& report, Resources& out) {
    const std::string pointer = "/buffers/" + std::to_string(index);
    std::vector<uint8_t>& buffer = out.buffers.emplace_back();
    if (source.uri) {
        std::optional<std::vector<uint8_t>> bytes = loader.load(*source.uri, pointer + "/uri");
        if (!bytes) return;
        buffer = std::move(*bytes);
    } else {
        if (!binary || index != 0) {
            report.error("S101", pointer,
                         "the buffer has no \"uri\", and the file has no binary chunk for the buffer",
                         "add \"uri\", or save the scene as .glb with this buffer as the first");
            return;
        }
        if (source.length_bytes > binary->size()) {
            report_short_buffer(report, pointer, source.length_bytes, binary->size());
            return;
        }
        if (!loader.reserve(source.length_bytes, pointer)) return;
        const std::span<const uint8_t> bytes = binary->first(source.length_bytes);
        buffer.assign(bytes.begin(), bytes.end());
    }
    if (buffer.size() < source.length_bytes) {
        report_short_buffer(report, pointer, source.length_bytes, buffer.size());
        return;
    }
    buffer.resize(source.length_bytes);
}

}  // namespace

std::optional<Resources> load_resources(CheckedJson& checked, std::optional<std::span<const uint8_t>> binary,
                                        const RootedFolder& folder, const SceneLimits& limits,
                                        MemoryBudget& memory, Report& report) {
    Loader loader(folder, limits.resource_bytes, memory, report);
    Resources out;
    for (size_t i = 0; i < checked.buffers.size(); ++i) {
        load_buffer(loader, checked.buffers[i], binary, i, report, out);
    }
    for (size_t i = 0; i < checked.images.size(); ++i) {
        const ImageSource& source = checked.images[i];
        EncodedImage& image = out.images.emplace_back();
        image.name = !source.name.empty()                            ? source.name
                     : source.uri.empty() || is_data_uri(source.uri) ? "image " + std::to_string(i)
                                                                     : source.uri;
        image.view = source.view;
        if (source.view != kNone) continue;
        if (auto bytes = loader.load(source.uri, "/images/" + std::to_string(i) + "/uri"))
            image.bytes = std::move(*bytes);
    }
    if (report.failed()) return std::nullopt;
    return out;
}

}  // namespace weft::scene::gltf
