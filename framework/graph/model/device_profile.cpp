#include "weft/device_profile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <string_view>

#include "graph/model/profile_json.h"

namespace weft {
namespace {

using Json = nlohmann::ordered_json;
namespace pj = profile_json;

Json features_to_json(FormatFeatureMask mask) {
    Json names = Json::array();
    for (const pj::FeatureName& feature : pj::kFeatureNames) {
        if (mask & feature.bit) names.push_back(feature.name);
    }
    return names;
}

// Reads the values of a profile file into a DeviceProfile and collects the errors. The position of an error
// is a JSON pointer, such as "/memoryTypes", because the JSON parser keeps no lines and columns.
struct ProfileReader {
    const std::string& file;
    Diagnostics faults;

    void fault(const std::string& pointer, std::string message, std::string help) {
        Diagnostic d;
        d.code = "W140";
        d.file = file;
        d.pointer = pointer;
        d.message = std::move(message);
        d.help = {std::move(help)};
        faults.push_back(std::move(d));
    }

    void formats(const Json& object, DeviceProfile& profile) {
        for (const auto& [name, list] : object.items()) {
            const std::optional<Format> format = format_from_name(name);
            if (!format || !list.is_array()) {
                fault("/formats/" + name, "\"" + name + "\" is not a known format with a list of features",
                      "use the names that `weft doctor --json` writes");
                continue;
            }
            FormatFeatureMask mask = 0;
            for (const Json& item : list) {
                const auto it = std::find_if(pj::kFeatureNames.begin(), pj::kFeatureNames.end(),
                                             [&](const pj::FeatureName& f) {
                                                 return item.is_string() && item.get<std::string>() == f.name;
                                             });
                if (it == pj::kFeatureNames.end()) {
                    fault("/formats/" + name, "unknown format feature " + item.dump(),
                          "use sampled, linear, storage, color, blend, depth, copySrc, copyDst, "
                          "blitSrc, blitDst");
                } else {
                    mask |= it->bit;
                }
            }
            profile.formats[*format] = mask;
        }
    }

    bool sample_counts(const std::string& key, const Json& list, DeviceProfile& profile) {
        const auto it = std::find_if(pj::kSampleCounts.begin(), pj::kSampleCounts.end(),
                                     [&](const pj::SampleCounts& s) { return key == s.name; });
        if (it == pj::kSampleCounts.end() || !list.is_array()) return false;
        SampleCountMask mask = 0;
        for (const Json& item : list) {
            const uint64_t count = item.is_number_unsigned() ? item.get<uint64_t>() : 0;
            if (std::has_single_bit(count) && count <= pj::kMostSamples)
                mask |= static_cast<SampleCountMask>(count);
            else
                fault("/" + key, item.dump() + " is not a sample count", "use 1, 2, 4, 8, 16, 32 and 64");
        }
        if ((mask & 1) == 0) fault("/" + key, "the sample count 1 is missing", "add 1 to the list");
        profile.*it->value = mask;
        return true;
    }

    void capabilities(const Json& list, DeviceProfile& profile) {
        profile.shader_capabilities = 0;
        for (const Json& item : list) {
            const auto it = std::find_if(pj::kCapabilityNames.begin(), pj::kCapabilityNames.end(),
                                         [&](const pj::CapabilityName& c) {
                                             return item.is_string() && item.get<std::string>() == c.name;
                                         });
            if (it != pj::kCapabilityNames.end()) {
                profile.shader_capabilities |= it->bit;
                continue;
            }
            std::string known;
            for (const pj::CapabilityName& c : pj::kCapabilityNames)
                known += (known.empty() ? "" : ", ") + std::string(c.name);
            fault("/shaderCapabilities", "unknown shader capability " + item.dump(), "use one of " + known);
        }
    }

    void queues(const Json& list, DeviceProfile& profile) {
        profile.queue_families.clear();
        for (const Json& item : list) {
            const std::string kind = item.value("kind", "");
            const auto it = std::find(pj::kQueueNames.begin(), pj::kQueueNames.end(), kind);
            if (it == pj::kQueueNames.end()) {
                fault("/queueFamilies", "a queue family has the unknown kind \"" + kind + "\"",
                      "use graphics, compute or transfer");
                continue;
            }
            profile.queue_families.push_back(
                {static_cast<QueueKind>(it - pj::kQueueNames.begin()), item.value("count", 1u)});
        }
        if (profile.queue_families.empty())
            fault("/queueFamilies", "the list of queue families is empty", "add at least one queue family");
    }

    void heaps(const Json& list, DeviceProfile& profile) {
        for (const Json& item : list)
            profile.memory_heaps.push_back(
                {item.value("bytes", uint64_t{0}), item.value("deviceLocal", true)});
    }

    MemoryContentMask contents(const Json& item) {
        if (!item.contains("holds")) return memory_content::kAll;
        MemoryContentMask mask = 0;
        for (const Json& word : item.at("holds")) {
            const auto it = std::find_if(pj::kContentNames.begin(), pj::kContentNames.end(),
                                         [&](const pj::ContentName& c) { return word == c.name; });
            if (it == pj::kContentNames.end())
                fault("/memoryTypes", "unknown content of a memory type: " + word.dump(),
                      "use buffers, colorImages and depthImages");
            else
                mask |= it->bit;
        }
        return mask;
    }

    void types(const Json& list, DeviceProfile& profile) {
        for (const Json& item : list)
            profile.memory_types.push_back({item.value("heap", 0u), item.value("deviceLocal", true),
                                            item.value("hostVisible", false),
                                            item.value("lazilyAllocated", false), contents(item)});
    }

    // Checks values that depend on each other or that the file may omit. For example, a memory type names a
    // heap by its index in "memoryHeaps". So this check runs after all keys have been read.
    void check_memory(const DeviceProfile& profile) {
        if (profile.memory_types.size() > 32)
            fault("/memoryTypes", std::to_string(profile.memory_types.size()) + " memory types are too many",
                  "list at most 32 memory types");
        MemoryContentMask held = 0;
        for (const MemoryTypeProfile& type : profile.memory_types) {
            if (!type.lazily_allocated) held |= type.holds;
            if (type.heap >= profile.memory_heaps.size())
                fault("/memoryTypes", "a memory type names the unknown heap " + std::to_string(type.heap),
                      "the profile has " + std::to_string(profile.memory_heaps.size()) +
                          " heaps, counted from 0");
        }
        if (!profile.memory_types.empty() && held != memory_content::kAll)
            fault("/memoryTypes", "the memory types do not cover all kinds of resources",
                  "list a memory type that is not lazily allocated for each of buffers, colorImages and "
                  "depthImages");
        for (const pj::WideLimit& l : pj::kMemoryLimits)
            if (!std::has_single_bit(profile.*l.value))
                fault(std::string("/") + l.name, "the alignment must be a power of two",
                      "correct the value, which is " + std::to_string(profile.*l.value));
        if (!std::has_single_bit(profile.buffer_image_granularity_bytes))
            fault("/bufferImageGranularityBytes", "the granularity must be a power of two",
                  "correct the value, which is " + std::to_string(profile.buffer_image_granularity_bytes));
    }

    void member(const std::string& key, const Json& value, DeviceProfile& profile) {
        if (key == "name" && value.is_string()) {
            profile.name = value.get<std::string>();
        } else if (key == "formats" && value.is_object()) {
            formats(value, profile);
        } else if (key == "shaderCapabilities" && value.is_array()) {
            capabilities(value, profile);
        } else if (key == "queueFamilies" && value.is_array()) {
            queues(value, profile);
        } else if (key == "memoryHeaps" && value.is_array()) {
            heaps(value, profile);
        } else if (key == "memoryTypes" && value.is_array()) {
            types(value, profile);
        } else if (!sample_counts(key, value, profile) && !limit(key, value, profile)) {
            fault("/" + key, "unknown key or wrong type",
                  "compare the profile with the output of `weft doctor --json`");
        }
    }

    static bool limit(const std::string& key, const Json& value, DeviceProfile& profile) {
        for (const pj::Limit& l : pj::kLimits) {
            if (key == l.name && value.is_number_unsigned())
                return profile.*l.value = value.get<uint32_t>(), true;
        }
        for (const std::span<const pj::WideLimit> limits :
             {std::span<const pj::WideLimit>(pj::kWideLimits),
              std::span<const pj::WideLimit>(pj::kMemoryLimits),
              std::span<const pj::WideLimit>(&pj::kExtraBytes, 1)})
            for (const pj::WideLimit& l : limits) {
                if (key == l.name && value.is_number_unsigned())
                    return profile.*l.value = value.get<uint64_t>(), true;
            }
        for (const pj::RealLimit& l : pj::kRealLimits) {
            if (key == l.name && value.is_number()) return profile.*l.value = value.get<float>(), true;
        }
        for (const pj::Switch& s : pj::kSwitches) {
            if (key == s.name && value.is_boolean()) return profile.*s.value = value.get<bool>(), true;
        }
        return false;
    }
};

}  // namespace

FormatFeatureMask DeviceProfile::features(Format format) const {
    const auto it = formats.find(format);
    return it == formats.end() ? 0 : it->second;
}

SampleCountMask DeviceProfile::samples(Format format) const {
    switch (format_info(format).numeric) {
        case NumericClass::float_like:
            return color_samples;
        case NumericClass::sint:
        case NumericClass::uint:
            return format_info(format).stencil ? depth_samples : integer_samples;
        case NumericClass::depth:
            return depth_samples;
    }
    return 1;
}

Result<DeviceProfile> parse_profile(const std::string& json, const std::string& file) {
    ProfileReader reader{file, {}};
    DeviceProfile profile;
    const Json root = Json::parse(json, nullptr, false);
    if (!root.is_object()) {
        reader.fault("", "the profile is not a JSON object",
                     "use a profile in the format that `weft doctor --json` writes");
        return std::move(reader.faults);
    }
    try {
        for (const auto& [key, value] : root.items()) reader.member(key, value, profile);
    } catch (const nlohmann::json::exception& e) {
        reader.fault("", e.what(), "compare the profile with the output of `weft doctor --json`");
    }
    reader.check_memory(profile);
    if (!reader.faults.empty()) return std::move(reader.faults);
    return profile;
}

namespace {

Json content_to_json(MemoryContentMask mask) {
    Json names = Json::array();
    for (const pj::ContentName& content : pj::kContentNames)
        if (mask & content.bit) names.push_back(content.name);
    return names;
}

void write_memory(const DeviceProfile& profile, Json& root) {
    const DeviceProfile standard;
    for (const pj::WideLimit& l : pj::kMemoryLimits)
        if (profile.*l.value != standard.*l.value) root[l.name] = profile.*l.value;
    if (profile.image_extra_bytes != 0) root[pj::kExtraBytes.name] = profile.image_extra_bytes;
    for (const MemoryHeapProfile& heap : profile.memory_heaps)
        root["memoryHeaps"].push_back({{"bytes", heap.size_bytes}, {"deviceLocal", heap.device_local}});
    for (const MemoryTypeProfile& type : profile.memory_types) {
        Json object{{"heap", type.heap},
                    {"deviceLocal", type.device_local},
                    {"hostVisible", type.host_visible},
                    {"lazilyAllocated", type.lazily_allocated}};
        if (type.holds != memory_content::kAll) object["holds"] = content_to_json(type.holds);
        root["memoryTypes"].push_back(std::move(object));
    }
}

}  // namespace

std::string profile_to_json(const DeviceProfile& profile) {
    Json root;
    root["name"] = profile.name;
    for (const QueueFamilyProfile& family : profile.queue_families) {
        root["queueFamilies"].push_back(
            {{"kind", pj::kQueueNames.at(static_cast<size_t>(family.kind))}, {"count", family.count}});
    }
    for (const pj::Limit& l : pj::kLimits) root[l.name] = profile.*l.value;
    for (const pj::RealLimit& l : pj::kRealLimits) root[l.name] = profile.*l.value;
    for (const pj::WideLimit& l : pj::kWideLimits) root[l.name] = profile.*l.value;
    for (const pj::SampleCounts& s : pj::kSampleCounts)
        for (uint32_t count = 1; count <= pj::kMostSamples; count <<= 1)
            if (profile.*s.value & count) root[s.name].push_back(count);
    for (const pj::Switch& s : pj::kSwitches) root[s.name] = profile.*s.value;
    root["shaderCapabilities"] = Json::array();
    for (const pj::CapabilityName& c : pj::kCapabilityNames)
        if (profile.shader_capabilities & c.bit) root["shaderCapabilities"].push_back(c.name);
    write_memory(profile, root);
    for (const auto& [format, mask] : profile.formats) {
        root["formats"][std::string(format_info(format).name)] = features_to_json(mask);
    }
    return root.dump(2) + "\n";
}

}  // namespace weft
