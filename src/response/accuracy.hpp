/// Accuracy settings of all models.
#pragma once

#include "config/table.hpp"
#include "contact/contact_accuracy.hpp"
#include "rocking/rocking_accuracy.hpp"

namespace overturn {

struct Accuracy {
    RockingAccuracy rocking;
    ContactAccuracy contact;
};

/// Reads the models' keys of `[accuracy]`; others are left to the caller. \throws InputError
[[nodiscard]] Accuracy read_accuracy(config::Table const& table);

}  // namespace overturn
