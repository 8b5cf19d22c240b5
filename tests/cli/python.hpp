/// Results files in the hands of Python, as users open and edit them.
#pragma once

#include <string>

#include "support/command.hpp"

namespace overturn::testing {

/// Can the Python of these tests import them? \param modules "h5py, matplotlib"
[[nodiscard]] inline bool has_python(Folder const& folder, std::string const& modules) {
    return execute(folder, {OVERTURN_PYTHON, "-c", "import " + modules}).code == 0;
}

/// Runs a statement on the open file `f` and closes it. \return how Python ended
[[nodiscard]] inline Ended edit_results(Folder const& folder, std::string const& file, std::string const& statement) {
    return execute(folder,
                   {OVERTURN_PYTHON, "-c", "import h5py\nwith h5py.File('" + file + "', 'r+') as f: " + statement});
}

/// What the package says of a file that it refuses, and then 2; 0 where it opens it.
[[nodiscard]] inline Ended open_in_python(Folder const& folder, std::string const& file) {
    return execute(
        folder, {"timeout", "60", OVERTURN_PYTHON, "-B", "-c",
                 "import sys\nsys.path.insert(0, '" OVERTURN_PACKAGE "')\nimport overturn\ntry: overturn.open('" + file
                     + "')\nexcept overturn.Error as error: print(error); sys.exit(2)"});
}

}  // namespace overturn::testing
