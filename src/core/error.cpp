#include "core/error.hpp"

namespace overturn {

std::string Location::prefix() const {
    if (file.empty()) {
        return {};
    }
    if (line <= 0) {
        return fmt::format("{}: ", file);
    }
    return column > 0 ? fmt::format("{}:{}:{}: ", file, line, column) : fmt::format("{}:{}: ", file, line);
}

InputError::InputError(Location const& where, std::string_view message)
    : std::runtime_error(fmt::format("{}{}", where.prefix(), message)) {}

void contract_failed(char const* kind, char const* condition, char const* file, int line) {
    throw ContractError(
        fmt::format("{}:{}: {} {} (a mistake in overturn, not in your input)", file, line, kind, condition));
}

}  // namespace overturn
