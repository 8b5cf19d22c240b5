#include "store/detail/h5.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

#include <fmt/format.h>
#include <sys/mman.h>

#include "core/error.hpp"
#include "core/next_step.hpp"
#include "store/durable.hpp"

namespace overturn::store {
namespace {

herr_t innermost(unsigned depth, H5E_error2_t const* error, void* reason) {
    if (depth == 0 && error->desc != nullptr) {
        *static_cast<std::string*>(reason) = error->desc;
    }
    return 0;
}

// HDF5 reports a system's error among addresses and offsets ("..., filename = 'out.h5', ..., errno = 5, ..."): of these
// what a person can act on. Empty where no system call failed.
std::string error_of_system(std::string const& what, std::string const& reason) {
    constexpr std::string_view number_mark = "errno = ";
    constexpr std::string_view name_mark = "filename = '";
    auto const at = reason.find(number_mark);
    int const number = at == std::string::npos ? 0 : std::atoi(reason.c_str() + at + number_mark.size());
    if (number <= 0) {
        return {};
    }
    auto const name = reason.find(name_mark);
    auto const end = name == std::string::npos ? name : reason.find("', ", name);
    auto const place = end == std::string::npos
                           ? std::string()
                           : " in " + reason.substr(name + name_mark.size(), end - name - name_mark.size());
    bool const reads = reason.starts_with("file read failed");
    return fmt::format("HDF5: cannot {}{} ({}). {}", what, place, std::strerror(number),
                       reads ? "Check the disk, then " + next_step() : advice_on_disk(number));
}

Datatype fixed_text(std::size_t length) {
    Datatype type(checked(H5Tcopy(H5T_C_S1), "make a text type"));
    checked(H5Tset_size(type.id(), length == 0 ? 1 : length), "size a text type");
    checked(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "pad a text type");
    checked(H5Tset_cset(type.id(), H5T_CSET_UTF8), "set a text type's characters");
    return type;
}

// Of any length, for a C string without zeros in it.
Datatype text_on_the_heap() { return fixed_text(H5T_VARIABLE); }

void write_scalar(hid_t where, std::string const& name, hid_t stored, hid_t memory, void const* value) {
    Dataspace const scalar(checked(H5Screate(H5S_SCALAR), "make a scalar"));
    Attribute const attribute(checked(H5Acreate2(where, name.c_str(), stored, scalar.id(), H5P_DEFAULT, H5P_DEFAULT),
                                      "make attribute " + name));
    checked(H5Awrite(attribute.id(), memory, value), "write attribute " + name);
}

}  // namespace

template <class Result> Result checked(Result result, std::string const& what) {
    if (result < 0) {
        std::string reason = "no reason given";
        H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, &innermost, &reason);
        std::replace(reason.begin(), reason.end(), '\n', ' ');  // a message is one line
        auto const text = error_of_system(what, reason);
        throw SystemError(text.empty() ? fmt::format("HDF5: cannot {} ({})", what, reason) : text);
    }
    return result;
}
template hid_t checked(hid_t, std::string const&);
template herr_t checked(herr_t, std::string const&);

void require_memory_for_hdf5() {
    constexpr std::size_t enough = std::size_t{32} << 20;  // a file takes a tenth of it
    void* const room = ::mmap(nullptr, enough, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) {  // NOLINT(performance-no-int-to-ptr): as POSIX defines it
        throw std::bad_alloc();
    }
    ::munmap(room, enough);
}

Quiet::Quiet() {
    [[maybe_unused]] static herr_t const once = H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}
Quiet::~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

void write_attribute(hid_t where, std::string const& name, std::string const& text) {
    constexpr std::size_t object_header_holds = 60000;  // of 64 KiB, with room for the rest
    if (text.size() > object_header_holds) {
        auto const type = text_on_the_heap();
        char const* const start = text.c_str();
        write_scalar(where, name, type.id(), type.id(), &start);
        return;
    }
    auto const type = fixed_text(text.size());
    write_scalar(where, name, type.id(), type.id(), text.empty() ? "" : text.data());
}
void write_attribute(hid_t where, std::string const& name, std::int64_t value) {
    write_scalar(where, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}
void write_attribute(hid_t where, std::string const& name, double value) {
    write_scalar(where, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

std::string read_text_attribute(hid_t where, std::string const& name) {
    Attribute const attribute(checked(H5Aopen(where, name.c_str(), H5P_DEFAULT), "open attribute " + name));
    Datatype const type(checked(H5Aget_type(attribute.id()), "read the type of attribute " + name));
    bool const on_the_heap = H5Tis_variable_str(type.id()) > 0;
    auto const memory = on_the_heap ? text_on_the_heap() : fixed_text(H5Tget_size(type.id()));
    // Other writers call the same bytes ASCII, which HDF5 does not turn into UTF-8.
    checked(H5Tset_cset(memory.id(), H5Tget_cset(type.id())), "set a text type's characters");
    if (on_the_heap) {
        char* start = nullptr;
        checked(H5Aread(attribute.id(), memory.id(), static_cast<void*>(&start)), "read attribute " + name);
        std::string text = start == nullptr ? "" : start;
        H5free_memory(start);
        return text;
    }
    std::string text(H5Tget_size(type.id()), '\0');
    checked(H5Aread(attribute.id(), memory.id(), text.data()), "read attribute " + name);
    text.resize(text.find_last_not_of('\0') + 1);
    return text;
}

std::int64_t read_integer_attribute(hid_t where, std::string const& name) {
    Attribute const attribute(checked(H5Aopen(where, name.c_str(), H5P_DEFAULT), "open attribute " + name));
    std::int64_t value = 0;
    checked(H5Aread(attribute.id(), H5T_NATIVE_INT64, &value), "read attribute " + name);
    return value;
}

}  // namespace overturn::store
