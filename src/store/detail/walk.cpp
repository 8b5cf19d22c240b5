#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/detail/objects.hpp"

namespace overturn::store {
namespace {

constexpr char const* foreign_advice = "Give the file that overturn wrote";

struct Link {
    std::string name;
    H5L_type_t type;
};

std::vector<Link> links_of(Object const& group, std::string const& path) {
    std::vector<Link> links;
    auto const add = [](hid_t, char const* name, H5L_info_t const* info, void* list) -> herr_t {
        static_cast<std::vector<Link>*>(list)->push_back({name, info->type});
        return 0;
    };
    checked(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &links), "list " + path);
    return links;
}

void require_stored_within(Object const& dataset, std::string const& path) {
    PropertyList const made(checked(H5Dget_create_plist(dataset.id()), "read how " + path + " is stored"));
    validate(H5Pget_external_count(made.id()) <= 0 && H5Pget_layout(made.id()) != H5D_VIRTUAL,
             "{} is stored in another file (a results file must not refer to other files). {}", path, foreign_advice);
    auto const filters = H5Pget_nfilters(made.id());
    for (int i = 0; i < filters; ++i) {
        unsigned flags = 0;
        std::size_t parameters = 0;
        auto const filter = H5Pget_filter2(made.id(), i, &flags, &parameters, nullptr, 0, nullptr, nullptr);
        validate(filter >= 0 && filter < H5Z_FILTER_RESERVED,
                 "{} is stored through filter {} (a plugin, which is never loaded). {}", path, static_cast<int>(filter),
                 foreign_advice);
    }
}

}  // namespace

void each_object(File const& file, std::function<void(std::string const&, Object const&)> const& visit) {
    std::vector<std::string> groups{"/"};  // to be looked into
    std::set<haddr_t> seen;
    {
        Object const root(checked(H5Oopen(file.id(), "/", H5P_DEFAULT), "open /"));
        visit("/", root);
    }
    while (!groups.empty()) {
        auto const path = std::move(groups.back());
        groups.pop_back();
        Object const group(checked(H5Oopen(file.id(), path.c_str(), H5P_DEFAULT), "open " + path));
        H5O_info_t info{};
        checked(H5Oget_info2(group.id(), &info, H5O_INFO_BASIC), "look at " + path);
        validate(seen.insert(info.addr).second, "{} is reached by two names (results know no such group). {}", path,
                 foreign_advice);
        for (auto const& link : links_of(group, path)) {
            auto const name = (path == "/" ? path : path + "/") + link.name;
            validate(link.type == H5L_TYPE_HARD,
                     "{} is a link to elsewhere (a results file must not refer to other files). {}", name,
                     foreign_advice);
            Object const object(checked(H5Oopen(group.id(), link.name.c_str(), H5P_DEFAULT), "open " + name));
            auto const kind = H5Iget_type(object.id());
            if (kind == H5I_DATASET) {
                require_stored_within(object, name);
            } else if (kind == H5I_GROUP) {
                groups.push_back(name);
            }
            visit(name, object);
        }
    }
}

}  // namespace overturn::store
