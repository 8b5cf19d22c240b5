/// A results file while it is read: what HDF5 holds open of it.
#pragma once

#include "store/detail/h5.hpp"
#include "store/results_file.hpp"

namespace overturn::store {

struct ResultsReader::Opened {
    Quiet quiet;
    File file;
};

}  // namespace overturn::store
