#include "cli/walltime.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <vector>

#include "core/digit.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "runner/root_broadcast.hpp"

namespace overturn::cli {
namespace {

constexpr double minute_s = 60, hour_s = 3600, day_s = 86400;

double whole(std::string_view text, std::string const& all) {
    double value = 0;
    bool const digits = !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    validate(digits && parse_number(text, value), "'{}' (is no time). Write \"50 min\", HH:MM:SS or D-HH:MM:SS", all);
    return value;
}

std::vector<double> numbers_between_colons(std::string_view text, std::string const& all) {
    std::vector<double> numbers;
    for (auto rest = text;;) {
        auto const colon = rest.find(':');
        numbers.push_back(whole(rest.substr(0, colon), all));
        if (colon == std::string_view::npos) {
            return numbers;
        }
        rest.remove_prefix(colon + 1);
    }
}

double slurm_time(std::string const& text) {
    std::string_view rest = text;
    auto const dash = rest.find('-');
    bool const has_days = dash != std::string_view::npos;
    double const days = has_days ? whole(rest.substr(0, dash), text) : 0;
    auto const parts = numbers_between_colons(has_days ? rest.substr(dash + 1) : rest, text);
    constexpr std::size_t most = 3;
    validate(parts.size() <= most, "'{}' (more than hours, minutes and seconds). Write HH:MM:SS", text);
    // Behind days hours come first, else the last are seconds.
    double unit = has_days ? hour_s : parts.size() == most ? hour_s : minute_s;
    double seconds = days * day_s;
    for (double const part : parts) {
        seconds += part * unit;
        unit /= minute_s;
    }
    return seconds;
}

// "1h": a blank before the first letter.
std::string with_blank(std::string text) {
    auto const letter = std::find_if(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    if (letter != text.begin() && letter != text.end() && is_digit(*(letter - 1))) {
        text.insert(letter, ' ');
    }
    return text;
}

std::string end_of_job() {
    char const* const stated = std::getenv("SLURM_JOB_END_TIME");
    return stated == nullptr ? "" : stated;
}

}  // namespace

double seconds_until(std::string const& end, std::chrono::system_clock::time_point now) {
    constexpr double leaving_s = 30;
    constexpr double leaving_share = 0.1;
    constexpr double stale_s = hour_s;
    double at = 0;
    bool const number = !end.empty() && end.find_first_not_of("0123456789") == std::string::npos;
    double const left =
        number && parse_number(end, at) ? at - std::chrono::duration<double>(now.time_since_epoch()).count() : -stale_s;
    if (left <= -stale_s) {
        return std::numeric_limits<double>::infinity();
    }
    return left > 0 ? left - std::min(leaving_s, leaving_share * left) : 0;
}

double seconds_of_job() { return seconds_until(end_of_job(), std::chrono::system_clock::now()); }

double seconds_of_job(parallel::Communicator const& comm) {
    return seconds_until(broadcast_from_root(comm, [] { return end_of_job(); }), std::chrono::system_clock::now());
}

double parse_walltime(std::string const& text) {
    bool const slurm =
        text.find(':') != std::string::npos || (text.find('-') != std::string::npos && text.front() != '-');
    double const seconds = slurm ? slurm_time(text) : parse_quantity(with_blank(text), Dimension::time);
    validate(seconds > 0, "{} s (must be above 0). State the time this run may take", seconds);
    return seconds;
}

double stated_walltime(std::string const& text) {
    try {
        return parse_walltime(text);
    } catch (InputError const& error) {
        throw InputError(fmt::format("--max-walltime: {}", error.what()));
    }
}

}  // namespace overturn::cli
