#include "load/measure_files.h"

#include "graph/diagnostics/quantity_text.h"
#include "load/data_file.h"
#include "load/picture_file.h"

namespace weft {
namespace {

// The header of a picture lies in these first bytes of the file. Only a JPEG may have large data before it.
constexpr uint64_t kHeaderBytes = 1 << 20;

std::string folder_of(const GraphDesc& graph, const SourceLoc& loc) {
    if (loc.file >= graph.sources.files.size()) return {};
    return std::filesystem::path(graph.sources.files[loc.file].path).parent_path().string();
}

class Measure {
 public:
    Measure(GraphDesc& graph, const LoadSettings& settings, std::set<std::filesystem::path>* searched,
            Diagnostics& faults)
        : graph_(graph), settings_(settings), searched_(searched), faults_(faults) {}

    void run() {
        for (auto& [name, resource] : graph_.resources)
            if (!resource.file.name.empty()) measure(resource);
    }

 private:
    void fail(const ResourceDesc& resource, const std::string& fault, const std::string& help) {
        Diagnostic d = graph_.sources.error(
            resource.file.loc, "W145",
            "the file \"" + resource.file.name + "\" of \"" + resource.name + "\" is not usable: " + fault);
        d.help.push_back(help);
        faults_.push_back(std::move(d));
    }

    void measure(ResourceDesc& resource) {
        const DataFile file = find_data_file(folder_of(graph_, resource.file.loc), resource.file.name,
                                             kHeaderBytes, settings_, searched_);
        if (!file.fault.empty()) return fail(resource, file.fault, file.help);
        if (file.size_bytes == 0) return fail(resource, "the file is empty", "write the data into the file");
        uint64_t content_bytes = file.size_bytes;
        if (!resource.is_buffer) {
            const PictureHeader header = read_picture_header(file.bytes);
            if (!header.fault.empty())
                return fail(resource, header.fault, "save the picture again with another program");
            resource.file.width_px = header.width_px;
            resource.file.height_px = header.height_px;
            if (header.width_px > 0) content_bytes += decoding_bytes(header);
        }
        resource.file.size_bytes = file.size_bytes;
        const uint64_t limit_bytes = settings_.limits.graph.file_bytes;
        if (content_bytes > limit_bytes - used_bytes_)
            return fail(resource,
                        "all files of the graph together need " + bytes_text(used_bytes_ + content_bytes) +
                            "; the limit is " + limit_bytes_text(limit_bytes),
                        "use smaller files, " + raise_limit_text("graph.fileBytes"));
        used_bytes_ += content_bytes;
        resource.file.path = file.path;
    }

    GraphDesc& graph_;
    const LoadSettings& settings_;
    std::set<std::filesystem::path>* searched_;
    Diagnostics& faults_;
    uint64_t used_bytes_ = 0;
};

}  // namespace

void measure_files(GraphDesc& graph, const LoadSettings& settings, std::set<std::filesystem::path>* searched,
                   Diagnostics& faults) {
    Measure(graph, settings, searched, faults).run();
}

}  // namespace weft
