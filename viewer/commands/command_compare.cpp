// `weft compare`: computes the difference of two pictures and checks it against a limit.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "viewer/commands/commands.h"
#include "viewer/output/formatted.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "viewer/pictures/image_file.h"
#include "viewer/pictures/image_reader.h"
#include "weft/image/channel_difference.h"
#include "weft/image/error_summary.h"
#include "weft/image/flip.h"
#include "weft/image/heat_map.h"

namespace weft::viewer {
namespace {

using image::Image;

struct Comparison {
    double value = 0;
    const char* unit = "";
    image::Plane map;
    // True if `map` contains the values of the metric, so that the mean and maximum of `map` can be printed.
    bool has_summary = false;
};

bool is_flip(const CompareOptions& options) {
    return options.metric == "flip";
}

bool is_psnr(const CompareOptions& options) {
    return options.metric == "psnr";
}

// Returns a message if the options contradict each other, such as --max with --metric psnr. Returns an empty
// text if the options are valid.
std::string usage_fault(const CompareOptions& options) {
    if (options.max && is_psnr(options))
        return "--max: for the metric psnr, a higher value is better; use --min for psnr";
    if (options.min && !is_psnr(options))
        return "--min: for flip and max, a lower value is better; use --max for flip and max";
    if (options.output.empty()) return "";
    const Result<ImageFileKind> kind = image_file_kind(options.output);
    if (!kind || *kind != ImageFileKind::png)
        return "--output: the heat map is a .png file; give a name that ends in .png";
    return "";
}

Diagnostic sizes_differ(const CompareOptions& options, const Image& a, const Image& b) {
    const auto size = [](const Image& image) {
        return std::to_string(image.width_px) + "x" + std::to_string(image.height_px);
    };
    Diagnostic d;
    d.code = "X532";
    d.file = options.test;
    d.message =
        "the size of the picture is " + size(b) + ", but the size of " + options.reference + " is " + size(a);
    d.help = {"render both pictures with the same --size"};
    return d;
}

// Adds an error if a texel of the picture is NaN. NaN cannot be converted to a display value, so most metrics
// cannot compare such a picture.
void require_numbers(const Image& picture, const std::string& file, Diagnostics& errors) {
    const auto it = std::find_if(picture.texels.begin(), picture.texels.end(),
                                 [](const glm::vec3& t) { return glm::any(glm::isnan(t)); });
    if (it == picture.texels.end()) return;
    const auto index = static_cast<size_t>(it - picture.texels.begin());
    Diagnostic d;
    d.code = "X533";
    d.file = file;
    d.message = "texel (" + std::to_string(index % picture.width_px) + ", " +
                std::to_string(index / picture.width_px) + ") is not a number (NaN)";
    d.help = {
        "correct the pass that writes NaN, or compare two raw pictures (EXR, PFM) with `--metric max`, which "
        "accepts NaN"};
    errors.push_back(std::move(d));
}

// Returns all reasons why the two pictures cannot be compared.
Diagnostics faults(const CompareOptions& options, const Image& a, const Image& b) {
    Diagnostics errors;
    if (!image::same_size(a, b)) errors.push_back(sizes_differ(options, a, b));
    const bool raw = a.encoding == image::Encoding::linear && b.encoding == image::Encoding::linear;
    if (options.metric == "max" && raw) return errors;
    require_numbers(a, options.reference, errors);
    require_numbers(b, options.test, errors);
    return errors;
}

Comparison compare(const CompareOptions& options, const Image& a, const Image& b) {
    Comparison result;
    if (is_flip(options)) {
        result.map = image::flip_map(a, b);
        result.value = image::summarize(result.map).mean;
        result.unit = "mean FLIP";
        result.has_summary = true;
    } else if (is_psnr(options)) {
        result.map = image::difference_map(a, b, image::Compared::as_displayed);
        result.value = image::psnr_db(a, b);
        result.unit = "dB";
    } else {
        const bool raw = a.encoding == image::Encoding::linear && b.encoding == image::Encoding::linear;
        result.map = image::difference_map(a, b);
        result.value = image::largest_difference(a, b);
        result.unit = raw ? "raw" : "8-bit steps";
    }
    return result;
}

// Returns the number as JSON text. JSON cannot represent infinity (the PSNR of equal pictures), so infinity
// and NaN become null.
std::string json_number(double value) {
    return std::isfinite(value) ? formatted("%.9g", value) : "null";
}

std::string comparison_json(const CompareOptions& options, const Comparison& comparison, bool good) {
    std::string text = "{\"metric\": \"" + options.metric +
                       "\", \"value\": " + json_number(comparison.value) + ", \"unit\": \"" +
                       comparison.unit + "\"";
    if (comparison.has_summary) {
        const image::ErrorSummary summary = image::summarize(comparison.map);
        text += ", \"mean\": " + json_number(summary.mean) + ", \"median\": " + json_number(summary.median) +
                ", \"max\": " + json_number(summary.max) + ", \"weighted_quartiles\": [";
        for (size_t i = 0; i < summary.weighted_quartiles.size(); ++i)
            text += (i ? ", " : "") + json_number(summary.weighted_quartiles[i]);
        text += "]";
    }
    const bool limited = options.max || options.min;
    text += ", \"width\": " + std::to_string(comparison.map.width_px) +
            ", \"height\": " + std::to_string(comparison.map.height_px) +
            ", \"limit\": " + (limited ? json_number(options.max ? *options.max : *options.min) : "null") +
            ", \"passed\": " + (limited ? (good ? "true" : "false") : "null") + "}\n";
    return text;
}

Status write_heat_map(const std::string& path, const image::Plane& map) {
    return write_png(path, map.width_px, map.height_px, image::heat_map(map));
}

}  // namespace

ExitCode run_compare(const CompareOptions& options) {
    if (const std::string fault = usage_fault(options); !fault.empty()) {
        std::fprintf(stderr, "weft: %s\n", fault.c_str());
        return ExitCode::usage;
    }
    if (const ExitCode code = check_outputs({options.output}, {options.reference, options.test});
        code != ExitCode::ok)
        return code;
    const Result<Image> a = read_image(options.reference, options.limits.picture),
                        b = read_image(options.test, options.limits.picture);
    Diagnostics errors;
    for (const Result<Image>* read : {&a, &b})
        if (!*read) errors.insert(errors.end(), read->errors().begin(), read->errors().end());
    if (errors.empty()) errors = faults(options, *a, *b);
    if (!errors.empty()) {
        report(errors);
        return exit_code_for(errors);
    }
    const Comparison comparison = compare(options, *a, *b);
    if (!options.output.empty())
        if (const Status written = write_heat_map(options.output, comparison.map); !written) {
            report(written.errors());
            return exit_code_for(written.errors());
        }
    const bool good = (!options.max || comparison.value <= *options.max) &&
                      (!options.min || comparison.value >= *options.min);
    const ExitCode printed = print_data(options.json ? comparison_json(options, comparison, good)
                                                     : formatted("%.6g\n", comparison.value));
    if (good || printed != ExitCode::ok) return printed;
    std::fprintf(stderr, "weft: %s differs too much from %s: the result is %.6g %s, the limit --%s is %g\n",
                 options.test.c_str(), options.reference.c_str(), comparison.value, comparison.unit,
                 options.max ? "max" : "min", options.max ? *options.max : *options.min);
    return ExitCode::mismatch;
}

}  // namespace weft::viewer
