#include "campaign/detail/body_keys.hpp"

#include "campaign/body_spec.hpp"

namespace overturn {

constinit config::KeyTable const body_table{
    .meaning = "a body file", .keys = body_keys.all, .also = {&footing_table, &placement_table}};
constinit config::KeyTable const bodies_table{
    .meaning = "one body of a campaign; a body file has the same keys except file",
    .keys = bodies_keys.all,
    .also = {&body_table}};

}  // namespace overturn
