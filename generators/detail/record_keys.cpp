#include "generators/detail/record_keys.hpp"

#include "generators/detail/records.hpp"

namespace overturn {

constinit config::KeyTable const record_files_table{
    .meaning = "recorded motions from files", .keys = record_files_keys.all, .also = {&reading_table}};
constinit config::KeyTable const records_table{.meaning = "recorded motions from files",
                                               .keys = {},
                                               .also = {&every_wave_table, &record_files_table},
                                               .chosen_by = "source",
                                               .word = "records"};

}  // namespace overturn
