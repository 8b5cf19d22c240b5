#include "config/faults.hpp"

#include <algorithm>
#include <utility>

namespace overturn::config {
namespace {

constexpr char next_fault = '\x1e';  // ASCII's record separator, which no text of a user's holds

/// "c.toml:3:1: waves.count: missing", which no other fault begins with.
std::string_view head_of(std::string_view text) { return text.substr(0, text.find(" (")); }

bool speaks_of(std::string_view reported, Fault const& fault) {
    bool const of_place = !fault.missing && fault.where.line > 0;
    return reported.starts_with(head_of(fault.text)) || (of_place && reported.starts_with(fault.where.prefix()));
}

}  // namespace

std::string joined_faults(std::vector<std::string> const& faults) {
    std::string message;
    for (auto fault : faults) {
        std::ranges::replace(fault, '\n', ' ');
        message += (message.empty() ? std::string() : std::string(1, next_fault)) + fault;
    }
    return message;
}

std::vector<std::string> faults_of(std::string_view message) {
    std::vector<std::string> faults;
    for (bool more = true; more;) {
        auto const end = message.find(next_fault);
        more = end != std::string_view::npos;
        faults.emplace_back(message.substr(0, end));
        message = more ? message.substr(end + 1) : std::string_view();
    }
    return faults;
}

std::string with_further_faults(std::string_view first, Table const& table) {
    auto reported = faults_of(first);
    auto const already = reported.size();
    for (auto& fault : table.faults()) {
        auto const end = reported.begin() + already;
        if (std::none_of(reported.begin(), end, [&](std::string const& one) { return speaks_of(one, fault); })) {
            reported.push_back(std::move(fault.text));
        }
    }
    return joined_faults(reported);
}

void FaultGatherer::add(std::string_view message) {
    for (auto& fault : faults_of(message)) {
        if (std::ranges::find(faults_, fault) == faults_.end()) {
            faults_.push_back(std::move(fault));
        }
    }
}

void FaultGatherer::tell() const {
    if (!faults_.empty()) {
        throw InputError(joined_faults(faults_));
    }
}

}  // namespace overturn::config
